# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of Catalyst on two processes against one: a picture a step, and the same ones.

Argument: the script that runs ParaView's programs.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLE = os.path.join(HERE, "..", "..", "Examples", "ParaView", "in_situ.py")
STEPS = 4


def read(folder, step):
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(folder, f"splats_{step:03d}.png"))
    assert os.path.exists(reader.GetFileName()), f"no picture of step {step} in {folder}"
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float)


folders = []
for ranks in (1, 2):
    folders.append(tempfile.mkdtemp(prefix=f"splats-insitu-{ranks}-"))
    done = subprocess.run(
        ["bash", sys.argv[1], "--ranks", str(ranks), "--with", "/usr/bin/python3",
         EXAMPLE, folders[-1], "8000", str(STEPS)],
        capture_output=True, text=True, timeout=200,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "ERR|" not in said, said
before = None
for step in range(STEPS):
    one, two = (read(folder, step) for folder in folders)
    value = 10 * np.log10(255**2 / max(np.mean((one - two) ** 2), 1e-9))
    shown = np.mean(np.abs(one - one[0]).max(-1) > 8)
    print(f"step {step}: two processes against one {value:.1f} dB, {shown:.2f} of the picture")
    assert value >= 40 and shown > 0.02
    assert before is None or np.abs(one - before).max() > 8, "nothing moves"
    before = one
