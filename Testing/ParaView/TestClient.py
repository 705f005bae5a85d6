# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window, by its own test player: a file is opened, the representation chosen in the
toolbar, the view dragged, points selected by a rubber band, opacity changed, and the state saved.

Argument: the script that runs ParaView's programs.
"""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
FRAME = (
    "pqClientMainWindow/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/"
    "MultiViewWidget1/Container/Frame.0"
)


def write_cloud(file, count=20000):
    """A torus with normals, in VTK's legacy format."""
    i = np.arange(count) + 0.5
    u, v = 2 * np.pi * i * (5**0.5 - 1) / 2, 2 * np.pi * i / count
    normals = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], 1)
    points = np.stack([np.cos(u), np.sin(u), 0 * u], 1) + 0.4 * normals
    with open(file, "w") as out:
        out.write("# vtk DataFile Version 3.0\ntorus\nASCII\nDATASET POLYDATA\n")
        out.write(f"POINTS {count} float\n")
        np.savetxt(out, points, "%.5f")
        out.write(f"POINT_DATA {count}\nNORMALS Normals float\n")
        np.savetxt(out, normals, "%.5f")


folder = tempfile.mkdtemp(prefix="splats-client-")
write_cloud(os.path.join(folder, "cloud.vtk"))
with open(os.path.join(HERE, "client.xml.in")) as file:
    steps = file.read().replace("@FRAME@", FRAME).replace("@FOLDER@", folder)
steps = steps.replace("@HERE@", HERE)
with open(os.path.join(folder, "client.xml"), "w") as file:
    file.write(steps)
# No settings of a user's, and none left behind.
environment = dict(os.environ, HOME=folder, XDG_CONFIG_HOME=folder, QT_QPA_PLATFORM="xcb")
environment.pop("DISPLAY", None)
done = subprocess.run(
    ["bash", sys.argv[1], "--with", "paraview", "-dr", f"--test-directory={folder}",
     f"--test-script={folder}/client.xml", "--exit"],
    env=environment, capture_output=True, text=True, timeout=280,
)  # fmt: skip
said = done.stdout + done.stderr
assert done.returncode == 0, f"exit code {done.returncode}\n{said}"
assert "ERR|" not in said and "Warning: In vtkPointSplat" not in said, said
with open(os.path.join(folder, "facts.json")) as file:
    facts = json.load(file)
print(json.dumps(facts, indent=1))
assert facts["shown"]["representation"] == "Point Splats"
assert "method:" in facts["shown"]["choices"]
assert facts["dragged"]["frames"] - facts["shown"]["frames"] >= 4, "dragging draws no frames"
assert facts["selected"]["picked"] > 100, "the rubber band picks no points"
assert facts["translucent"]["opacity"] == 0.5
assert "peel" in facts["translucent"]["choices"]
with open(os.path.join(folder, "state.pvsm")) as file:
    assert '"Point Splats"' in file.read(), "the state does not have the representation"
