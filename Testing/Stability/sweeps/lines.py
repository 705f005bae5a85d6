# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sweep of scan lines, whose points are denser along them than they are apart."""
import math

import numpy as np

from sweeps.measures import COUNTS, TWO_PASSES, Scene
from sweeps.registry import SWEEPS, Stable, Sweep
from sweeps.surfaces import cloud, torus

GIVEN, NONE = "normals given", "no normals"


def scan_lines(ratio, n):
    """how many times denser along scan lines than from one to the next"""
    ring, tube = 0.7, 0.3
    apart = math.sqrt(4 * math.pi ** 2 * ring * tube * ratio / n)
    lines = round(2 * math.pi * tube / apart)
    v = 2 * math.pi * np.arange(lines) / lines
    counts = np.round(2 * math.pi * (ring + tube * np.cos(v)) * ratio / apart).astype(int)
    u = np.concatenate([2 * math.pi * np.arange(count) / count for count in counts])
    v = np.repeat(v, counts)
    m = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
    return np.stack([ring * np.cos(u), ring * np.sin(u), 0 * u], 1) + tube * m, m


def measure(series, ratio, size):
    points, normals = scan_lines(ratio, COUNTS[TWO_PASSES])
    scene = Scene([torus()], [cloud(points, normals if series == GIVEN else None)])
    return scene.measure(size, lambda mapper: None)[0]


SWEEPS["scan_lines"] = Sweep("scan_lines", scan_lines.__doc__.strip(), [1, 2, 3, 5, 8, 12, 20, 40, 80],
                             {GIVEN: Stable([8, 20]), NONE: Stable([8], 14)}, measure)
