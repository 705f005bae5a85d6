# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same scene on 1, 2 and 4 processes, with even and uneven shares of the points: the same
pictures, and the same points picked. Argument: the script that runs others by pvbatch."""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = os.path.dirname(os.path.abspath(__file__))
LEAST = {"opaque": 45, "estimated": 45, "translucent": 38} # dB against one process


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


def run(ranks, shares):
    folder = tempfile.mkdtemp(prefix=f"splats-{ranks}-")
    done = subprocess.run(
        ["bash", sys.argv[1], "--ranks", str(ranks), os.path.join(HERE, "ranks_scene.py"), folder, shares],
        capture_output=True, text=True,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "ERR|" not in said and "WARN|" not in said, said
    with open(os.path.join(folder, "facts.json")) as file:
        facts = json.load(file)
    return {name: read(os.path.join(folder, name + ".png")) for name in LEAST}, facts


one, facts = run(1, "EVEN")
assert len(facts["ids"]) > 500
for ranks, shares in ((2, "EVEN"), (4, "UNEVEN")):
    pictures, other = run(ranks, shares)
    print(f"{ranks} ranks: {other['seconds']:.3f} s a frame, one rank {facts['seconds']:.3f} s")
    for name, least in LEAST.items():
        error = np.mean((pictures[name] - one[name]) ** 2)
        value = 10 * np.log10(255**2 / max(error, 1e-9))
        print(f"{ranks} ranks, {shares}, {name}: {value:.1f} dB, at least {least}")
        assert value >= least
    missed = set(facts["ids"]) ^ set(other["ids"])
    print(f"{len(other['ids'])} points picked, {len(missed)} others than by one rank")
    assert len(other["ids"]) == len(set(other["ids"])), "a point is picked twice"
    assert len(missed) <= 0.01 * len(facts["ids"]), f"other points are picked: {sorted(missed)[:20]}"
