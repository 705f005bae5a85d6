# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of text: a point a line, its coordinates first or in columns of that name."""
import re

import numpy as np

from .reading import bytes_of_colours, inside, make_cloud

GROUPS = {"Normals": (("nx", "ny", "nz"), ("normalx", "normaly", "normalz")),
          "RGB": (("r", "g", "b"), ("red", "green", "blue"))}


def read(path, box, spacing):
    """See :func:`pointsplatting.read`."""
    names, delimiter, skipped = _look_at(path)
    try:
        table = np.loadtxt(path, delimiter=delimiter, skiprows=skipped, ndmin=2,
                           comments=("#", "//", "%"), encoding="utf-8-sig")
    except ValueError as error:
        raise OSError(f"{path} cannot be read as a table of numbers: {error}") from error
    if table.shape[1] < 3:
        raise OSError(f"{path} has {table.shape[1]} columns: at least 3 are needed for points.")
    if len(names) != table.shape[1]:
        names = ["x", "y", "z", *(f"Column{i}" for i in range(4, table.shape[1] + 1))]
    columns = dict(zip((name.lower() for name in names), table.T))
    axes = ("x", "y", "z") if {"x", "y", "z"} <= columns.keys() else tuple(columns)[:3]
    points = np.column_stack([columns[axis] for axis in axes])
    keep = slice(None) if box is None else inside(points, box)
    arrays, used = {}, set(axes)
    for array, choices in GROUPS.items():
        for group in choices:
            if set(group) <= columns.keys():
                arrays[array] = np.column_stack([columns[name] for name in group])[keep]
                used |= set(group)
    if "RGB" in arrays:
        arrays["RGB"] = bytes_of_colours(arrays["RGB"])
    for name in names:
        if name.lower() not in used:
            arrays[name] = columns[name.lower()][keep]
    return make_cloud(points[keep], arrays)


def _look_at(path):
    """The columns' names where there are some, what separates them, lines before the numbers."""
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        for skipped, line in enumerate(file):
            text = line.strip().lstrip("#/%").strip()
            delimiter = next((mark for mark in ";,\t" if mark in text), None)
            cells = [cell.strip().strip('"') for cell in text.split(delimiter)]
            if not text or (line.lstrip()[0] in "#/%" and not re.search(r"\bx\b", text, re.I)):
                continue
            if any(re.match(r"[A-Za-z_]", cell) and cell.lower() not in ("nan", "inf")
                   for cell in cells):
                return cells, delimiter, skipped + 1
            return [], delimiter, skipped
    return [], None, 0
