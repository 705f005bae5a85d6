# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation's pictures against those of vtkPointSplatMapper alone, for the same camera and
light. Argument: the script that runs others by pvbatch. It runs where pointsplatting is found."""
import os
import subprocess
import sys
import tempfile

import numpy as np
import vtkmodules.vtkRenderingOpenGL2
from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkWindowToImageFilter

HERE = os.path.dirname(os.path.abspath(__file__))
LEAST = {"opaque": 40, "translucent": 40}  # dB


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float)


folder = tempfile.mkdtemp(prefix="splats-module-")
environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
scene = os.path.join(HERE, "module_scene.py")
subprocess.run(["bash", sys.argv[1], scene, folder], env=environment, check=True)
points = vtkXMLPolyDataReader()
points.SetFileName(os.path.join(folder, "points.vtp"))
mapper = vtkPointSplatMapper()
mapper.SetInputConnection(points.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtkActor()
actor.SetMapper(mapper)
look = actor.GetProperty()
look.SetColor(0.9, 0.6, 0.3)
look.SetSpecular(0.4)
look.SetSpecularPower(30)
look.SetSpecularColor(1, 1, 1)
renderer = vtkRenderer()
renderer.AddActor(actor)
light = vtkLight()
light.SetLightTypeToSceneLight()
light.SetPosition(4, -1, 5)
renderer.AddLight(light)
camera = renderer.GetActiveCamera()
camera.SetPosition(3, -2, 2)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = vtkEGLHeadlessRenderWindow()
window.SetMultiSamples(0)
window.SetSize(400, 300)
window.AddRenderer(renderer)
for name, least in LEAST.items():
    look.SetOpacity(1 if name == "opaque" else 0.5)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(os.path.join(folder, name + "-module.png"))
    writer.Write()
    difference = read(os.path.join(folder, name + ".png")) - read(writer.GetFileName())
    value = 10 * np.log10(255**2 / max(np.mean(difference**2), 1e-9))
    print(f"{name}: {value:.1f} dB, at least {least}")
    assert value >= least, folder
