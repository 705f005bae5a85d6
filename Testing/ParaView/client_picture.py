# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The README's picture of ParaView's window, with the example of the hydrogen orbital.

python3 Testing/ParaView/client_picture.py Documentation/paraview.png, after a run of
Module/ParaView/test.sh or run.sh --paraview, where VTK's Python modules are found. A display of its own
is read: Xvfb's, as a file.
"""
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

SIZE = 1400, 860
TOP = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
BATCH = os.path.join(TOP, "Module", "ParaView", "batch.sh")
EXAMPLE = os.path.join(TOP, "Examples", "ParaView", "hydrogen.py")


# What hands do in the window: the panels are made wider and higher, and the settings of splats shown.
HANDS = (
    "mousemove 297 500 mousedown 1 mousemove 350 500 mousemove 400 500 mousemove 433 500 mouseup 1",
    "mousemove 147 386 mousedown 1 mousemove 147 330 mousemove 147 290 mousemove 147 254 mouseup 1",
    "mousemove 411 440 mousedown 1 mousemove 411 500 mousemove 411 560 mousemove 411 590 mouseup 1",
)


def write(screen, file):
    """The screen, in X's format of window dumps, as a PNG."""
    with open(screen, "rb") as data:
        dump = data.read()
    header = struct.unpack(">25I", dump[:100])
    size, width, height, line, colors = (header[i] for i in (0, 4, 5, 12, 19))
    pixels = np.frombuffer(dump, np.uint8, line * height, size + 12 * colors)
    pixels = pixels.reshape(height, line)[:, : 4 * width].reshape(height, width, 4)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    rows = np.ascontiguousarray(pixels[::-1, :, 2::-1]).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=1))
    writer = vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputData(image)
    writer.Write()


folder = tempfile.mkdtemp(prefix="splats-picture-")
reads, writes = os.pipe()
screen = "{}x{}x24".format(*SIZE)
server = subprocess.Popen(
    ["Xvfb", "-displayfd", str(writes), "-screen", "0", screen, "-fbdir", folder, "-noreset"],
    pass_fds=[writes], stderr=subprocess.DEVNULL,
)  # fmt: skip
display = ":" + os.read(reads, 16).decode().strip()
# No settings of a user's, and none left behind.
environment = dict(
    os.environ, DISPLAY=display, HOME=folder, XDG_CONFIG_HOME=folder, QT_QPA_PLATFORM="xcb"
)
environment.pop("LD_LIBRARY_PATH", None)
environment.pop("PYTHONPATH", None)
client = subprocess.Popen(
    ["bash", BATCH, "--with", "paraview", "-dr", "-geometry", "{}x{}+0+0".format(*SIZE),
     "--script=" + EXAMPLE],
    env=environment, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
)  # fmt: skip
try:
    time.sleep(float(os.environ.get("SECONDS_TO_WAIT", 40)))
    for hands in HANDS:
        for hand in re.findall(r"[a-z]+(?: \d+)+", hands):
            subprocess.run(["xdotool", *hand.split()], env=environment, check=True)
            time.sleep(1)
        time.sleep(3)
    write(os.path.join(folder, "Xvfb_screen0"), sys.argv[1])
finally:
    os.killpg(client.pid, signal.SIGTERM)
    server.terminate()
