# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Windows without a driver, and windows of both kinds in one process: no crash, and a word.

Where VTK has an EGL window of its own, vtkEGLHeadlessRenderWindow is that: without a driver it draws
nothing, and whatever else is asked of it, and windows of an X server beside it, end the process as VTK's do.
"""
import os
import subprocess
import sys
import unittest

from pointsplatting import vtkEGLHeadlessRenderWindow
from virtual_display import VirtualDisplay, is_available

SCENE = """
import sys
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import *
import vtkmodules.vtkInteractionStyle, vtkmodules.vtkRenderingOpenGL2
from pointsplatting import (
    vtkEGLHeadlessRenderWindow, vtkPointShadowTexture, vtkPointSplatMapper, vtkPointSplatPass)


def fill(window, kind=vtkPointSplatMapper):
    ball = vtkSphereSource()
    ball.SetThetaResolution(60)
    ball.SetPhiResolution(30)
    mapper = kind()
    mapper.SetInputConnection(ball.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window.SetSize(120, 120)
    window.AddRenderer(renderer)
    return renderer


def read(window):
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    return bytes(memoryview(image.GetOutput().GetPointData().GetScalars()))


def picks(window, renderer):
    selector = vtkHardwareSelector()
    selector.SetRenderer(renderer)
    selector.SetArea(0, 0, 119, 119)
    return selector.Select().GetNumberOfNodes()
"""

DRAWS_WITHOUT_DRIVER = """
window = vtkEGLHeadlessRenderWindow()
fill(window)
fill(window, vtkPolyDataMapper)
window.Render()
window.Render()
assert window.GetPlatform() == ""
print("alive")
"""

ASKS_WITHOUT_DRIVER = """
window = vtkEGLHeadlessRenderWindow()
renderer = fill(window)
fill(window, vtkPolyDataMapper)
window.Render()
window.Render()
assert window.GetPlatform() == ""
assert set(read(window)) == {0}, "a black picture"
mapper = renderer.GetActors().GetLastActor().GetMapper()
mapper.RenderPiece(renderer, renderer.GetActors().GetLastActor())
mapper.GetChoices()
window.WaitForCompletion()
window.ReportCapabilities()
window.SetSize(300, 200)
window.Render()
window.Finalize()
window.RemoveRenderer(renderer)
print("alive")
"""

BOTH = """
first, meshes = sys.argv[1] == "x", sys.argv[2] == "meshes"
kind = vtkPolyDataMapper if meshes else vtkPointSplatMapper
windows = [vtkRenderWindow(), vtkEGLHeadlessRenderWindow()]
if not first:
    windows.reverse()
renderers = [fill(window, kind) for window in windows]
for window in windows:
    window.SetMultiSamples(0)
    window.Render()
before = [read(window) for window in windows]
assert before[0] == before[1] and max(before[0]) > 100, "one picture by both"
for turn in range(3):
    for window, renderer in zip(windows, renderers):
        window.Render()
        assert picks(window, renderer) == 1
        assert read(window) == before[0], turn
        window.SetSize(80 + turn, 80)
        window.Render()
        window.SetSize(120, 120)
# One after the other goes, and comes again.
for i in (0, 1):
    windows[i].Finalize()
    windows[1 - i].Render()
    assert read(windows[1 - i]) == before[0]
for window, renderer in zip(windows, renderers):
    window.Render()
    renderer.RemoveAllViewProps()
    window.Render()
    window.RemoveRenderer(renderer)
print("alive")
"""


VTK_HAS_ONE = any(base.__name__ == "vtkEGLRenderWindow" for base in vtkEGLHeadlessRenderWindow.__mro__)


class TestWindows(unittest.TestCase):
    def run_script(self, script, *arguments, **environment):
        done = subprocess.run(
            [sys.executable, "-c", SCENE + script, *arguments], env={**os.environ, **environment},
            capture_output=True, text=True, timeout=100, check=False,
        )  # fmt: skip
        self.assertEqual((done.returncode, done.stdout), (0, "alive\n"), done.stderr)
        return done.stderr

    def without_a_driver(self, script):
        said = self.run_script(script, DISPLAY="", __EGL_VENDOR_LIBRARY_FILENAMES="/nosuch.json")
        self.assertEqual(said.count("No OpenGL context of version 3.2"), 1, said)

    def test_drawing_without_a_driver(self):
        self.without_a_driver(DRAWS_WITHOUT_DRIVER)

    @unittest.skipIf(VTK_HAS_ONE, "VTK's own EGL window")
    def test_asking_without_a_driver(self):
        self.without_a_driver(ASKS_WITHOUT_DRIVER)

    @unittest.skipIf(VTK_HAS_ONE, "VTK's own EGL window")
    @unittest.skipUnless(is_available(), "no Xvfb here")
    def test_beside_windows_of_an_x_server(self):
        with VirtualDisplay() as display:
            for first in ("x", "egl"):
                for kind in ("meshes", "splats"):
                    with self.subTest(first=first, kind=kind):
                        said = self.run_script(BOTH, first, kind, DISPLAY=display.name)
                        self.assertEqual(said, "")


if __name__ == "__main__":
    unittest.main()
