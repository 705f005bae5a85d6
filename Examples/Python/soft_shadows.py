#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A gyroid's ball of points in the light of a lamp of some size: local illumination, hard shadows, soft ones.   soft_shadows.py [PICTURE.png]"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCylinderSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
from pointsplatting import (
    vtkEGLHeadlessRenderWindow, vtkIsosurfacePoints, vtkPointSplatMapper)

# A gyroid's sheet within a ball: the greater of two distances is that of their intersection,
# here with its edges rounded.
n = 130
x = np.linspace(-1.05, 1.05, n, dtype=np.float32)
z, y, x = np.meshgrid(x, x, x, indexing="ij")
k = 5.2
gyroid = (np.sin(k * x) * np.cos(k * y) + np.sin(k * y) * np.cos(k * z)
          + np.sin(k * z) * np.cos(k * x)) / k
image = vtkImageData()
image.SetDimensions(n, n, n)
image.SetOrigin(-1.05, -1.05, -1.05)
image.SetSpacing(2.1 / (n - 1), 2.1 / (n - 1), 2.1 / (n - 1))
field = 0.03 * np.logaddexp((np.abs(gyroid) - 0.06) / 0.03,
                            (np.sqrt(x * x + y * y + z * z) - 1.0) / 0.03)
image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(), deep=1))
ball = vtkIsosurfacePoints()
ball.SetInputData(image)
ball.SetValue(0, 0.0)

# The floor: points on a grid.
m = 400
u, v = np.meshgrid(np.linspace(-4, 4, m), np.linspace(-4, 4, m))
floor = vtkPolyData()
points = vtkPoints()
points.SetData(numpy_to_vtk(np.c_[u.ravel(), v.ravel(), np.full(m * m, -1.02)], deep=1))
floor.SetPoints(points)
floor.GetPointData().SetNormals(numpy_to_vtk(np.tile([0.0, 0.0, 1.0], (m * m, 1)), deep=1))

# A column that is an ordinary mesh casts on the points too.
column = vtkCylinderSource()
column.SetRadius(0.1)
column.SetHeight(2.6)
column.SetResolution(60)

window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1500, 500)
for i in range(3):
    renderer = vtkRenderer()
    renderer.SetViewport(i / 3, 0, (i + 1) / 3, 1)
    renderer.SetBackground(0.55, 0.62, 0.72)
    renderer.AutomaticLightCreationOff()
    for data, colour in ((ball, (0.95, 0.62, 0.35)), (floor, (0.92, 0.9, 0.86))):
        mapper = vtkPointSplatMapper()
        if data is floor:
            mapper.SetInputData(data)
        else:
            mapper.SetInputConnection(data.GetOutputPort())
        mapper.ScalarVisibilityOff()
        mapper.SetShadows(i > 0)
        mapper.SetShadowLightRadius(0.35 if i > 1 else 0.0)
        mapper.SetNumberOfShadowSamples(48)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetAmbient(0.12)
        actor.GetProperty().SetDiffuse(0.85)
        actor.GetProperty().SetSpecular(0.25 if data is ball else 0.0)
        actor.GetProperty().SetSpecularPower(30)
        renderer.AddActor(actor)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(column.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.RotateX(90)
    actor.SetPosition(-1.15, -0.75, 0.28)
    actor.GetProperty().SetColor(0.45, 0.6, 0.8)
    actor.GetProperty().SetAmbient(0.22)
    renderer.AddActor(actor)

    lamp = vtkLight()
    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(-4.0, -2.4, 4.2)
    lamp.SetFocalPoint(0, 0, -0.4)
    lamp.SetIntensity(0.9)
    renderer.AddLight(lamp)
    fill = vtkLight()
    fill.SetLightTypeToHeadlight() # casts no shadow
    fill.SetIntensity(0.25)
    renderer.AddLight(fill)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.9, -5.6, 3.1)
    camera.SetFocalPoint(0.3, 0.2, -0.4)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(34)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "soft_shadows.png")
writer.Write()
