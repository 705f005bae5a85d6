#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three nested isosurfaces as point clouds, each with its own opacity: peeled, with the nearest
layer exact, and sorted.   transparent_layers.py [PICTURE.png]"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
from pointsplatting import (
    vtkEGLHeadlessRenderWindow, vtkIsosurfacePoints, vtkPointSplatMapper)

# The density of hydrogen's 3d orbital, greatest value 100.
n = 160
x = np.linspace(-18, 18, n, dtype=np.float32)
z, y, x = np.meshgrid(x, x, x, indexing="ij")
density = ((2 * z * z - x * x - y * y) * np.exp(-np.sqrt(x * x + y * y + z * z) / 3)) ** 2
image = vtkImageData()
image.SetDimensions(n, n, n)
image.SetSpacing(36 / (n - 1), 36 / (n - 1), 36 / (n - 1))
image.GetPointData().SetScalars(numpy_to_vtk((100 * density / density.max()).ravel(), deep=1))

window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1200, 420)
camera = None
for i in range(3):
    renderer = vtkRenderer()
    renderer.SetViewport(i / 3, 0, (i + 1) / 3, 1)
    renderer.SetBackground(0.1, 0.2, 0.4)
    for value, opacity, colour in ((4, 0.3, (0.35, 0.55, 0.95)), (18, 0.5, (0.35, 0.8, 0.4)),
                                   (50, 1.0, (0.9, 0.6, 0.3))):
        surface = vtkIsosurfacePoints()
        surface.SetInputData(image)
        surface.SetValue(0, value)
        mapper = vtkPointSplatMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        (mapper.SetTransparencyToPeeling, mapper.SetTransparencyToNearestExact,
         mapper.SetTransparencyToSorted)[i]()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetSpecular(0.3)
        actor.GetProperty().SetSpecularPower(20)
        renderer.AddActor(actor)
    if camera is None:
        renderer.ResetCamera()
        camera = renderer.GetActiveCamera()
        camera.Elevation(-65)
        camera.Azimuth(20)
        camera.OrthogonalizeViewUp()
        camera.Dolly(1.5)
        renderer.ResetCameraClippingRange()
    renderer.SetActiveCamera(camera)
    window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "transparent_layers.png")
writer.Write()
