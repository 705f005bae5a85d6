# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window, by its own test player: a file is opened, the representation chosen in the
toolbar, that undone and done again, the view dragged, points selected by a rubber band, opacity
changed, and the state saved. The panel says at each step what was chosen for the last frame, and the
trace in Python of it all gives the same picture.

Argument: the script that runs ParaView's programs.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from xml.sax.saxutils import quoteattr

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = os.path.dirname(os.path.abspath(__file__))
FRAME = (
    "pqClientMainWindow/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/"
    "MultiViewWidget1/Container/Frame.0"
)
LINE = (
    "pqClientMainWindow/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/"
    "scrollAreaWidgetContents/DisplayFrame/ProxyPanel/SplatChoices/SplatChoices"
)
PANEL = ("shown", "dragged", "translucent")  # where the panel has the line


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


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float)


def play(texts):
    """Does the steps, and looks at what the panel's line has before each step that notes what the
    client knows. Returns that by step."""
    with open(os.path.join(HERE, "client.xml.in")) as file:
        steps = file.read()
    for name, value in (("FRAME", FRAME), ("FOLDER", folder), ("HERE", HERE)):
        steps = steps.replace(f"@{name}@", value)
    lines = []
    for line in steps.splitlines():
        noted = re.search(r"facts.note\('(\w+)'\)", line)
        if noted and noted[1] in texts:
            text = quoteattr(texts[noted[1]])
            lines.append(f'<pqcheck object="{LINE}" property="plainText" arguments={text} />')
        lines.append(line)
    with open(os.path.join(folder, "client.xml"), "w") as file:
        file.write("\n".join(lines))
    # No settings of a user's, and none left behind.
    environment = dict(os.environ, HOME=folder, XDG_CONFIG_HOME=folder, QT_QPA_PLATFORM="xcb")
    environment.pop("DISPLAY", None)
    done = subprocess.run(
        ["bash", sys.argv[1], "--with", "paraview", "-dr", f"--test-directory={folder}",
         f"--test-script={folder}/client.xml", "--exit"],
        env=environment, capture_output=True, text=True, timeout=140,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, f"exit code {done.returncode}\n{said}"
    assert "ERR|" not in said and "Warning: In vtkPointSplat" not in said, said
    with open(os.path.join(folder, "facts.json")) as file:
        return json.load(file)


folder = tempfile.mkdtemp(prefix="splats-client-")
write_cloud(os.path.join(folder, "cloud.vtk"))
facts = play({})
# The player compares texts with what is known before: so it all is done once more.
play({step: facts[step]["known"] for step in PANEL})
print(json.dumps(facts, indent=1))
for step in PANEL:
    known = facts[step]["known"]
    assert known == facts[step]["choices"], f"{step}: what was chosen is known as {known}"
    assert "method: none" not in known and "method: " in known, f"{step}: {known}"
assert facts["shown"]["representation"] == "Point Splats"
assert facts["dragged"]["frames"] - facts["shown"]["frames"] >= 4, "dragging draws no frames"
assert facts["dragged"]["frames"] - facts["shown"]["frames"] <= 12, "frames follow by themselves"
assert facts["selected"]["picked"] > 100, "the rubber band picks no points"
assert facts["translucent"]["opacity"] == 0.5
assert "peel" in facts["translucent"]["choices"]
with open(os.path.join(folder, "state.pvsm")) as file:
    assert '"Point Splats"' in file.read(), "the state does not have the representation"

# The trace, played in a batch.
with open(os.path.join(folder, "trace.py")) as file:
    trace = file.read()
assert "SetRepresentationType('Point Splats')" in trace and "Opacity = 0.5" in trace, trace
replay = os.path.join(folder, "replay.py")
with open(replay, "w") as file:
    file.write(f"{trace}\nClearSelection()\nrenderView1.OrientationAxesVisibility = 0\n"
               f"SaveScreenshot('{folder}/replayed.png', renderView1, ImageResolution=[400, 300])\n")  # fmt: skip
subprocess.run(["bash", sys.argv[1], replay], check=True, timeout=120)
error = np.mean((read(f"{folder}/traced.png") - read(f"{folder}/replayed.png")) ** 2)
value = 10 * np.log10(255**2 / max(error, 1e-9))
print(f"the trace's picture: {value:.1f} dB, at least 50")
assert value >= 50, folder
