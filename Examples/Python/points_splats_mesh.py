#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same points three ways, side by side: as VTK draws points, as splats, and the mesh
that they were taken from.   points_splats_mesh.py [PICTURE.png]"""
import os
import sys

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricConicSpiral
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper

source = vtkParametricFunctionSource()
source.SetParametricFunction(vtkParametricConicSpiral())
source.SetUResolution(200)
source.SetVResolution(200)
source.SetScalarModeToNone()
mesh = vtkPolyDataNormals()
mesh.SetInputConnection(source.GetOutputPort())
mesh.SplittingOff()
mesh.Update()

cloud = vtkPolyData()
cloud.SetPoints(mesh.GetOutput().GetPoints())
cloud.GetPointData().SetNormals(mesh.GetOutput().GetPointData().GetNormals())
dots = vtkVertexGlyphFilter()
dots.SetInputData(cloud)

mappers = [vtkPolyDataMapper(), vtkPointSplatMapper(), vtkPolyDataMapper()]
mappers[0].SetInputConnection(dots.GetOutputPort())
mappers[1].SetInputData(cloud)
mappers[2].SetInputConnection(mesh.GetOutputPort())

window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1200, 420)
camera = None
for i, mapper in enumerate(mappers):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.85, 0.55, 0.30)
    actor.GetProperty().SetSpecular(0.4)
    actor.GetProperty().SetSpecularPower(30)
    renderer = vtkRenderer()
    renderer.SetViewport(i / 3, 0, (i + 1) / 3, 1)
    renderer.SetBackground(0.1, 0.2, 0.4)
    renderer.AddActor(actor)
    if camera is None:
        renderer.ResetCamera()
        camera = renderer.GetActiveCamera()
        camera.Elevation(-60)
        camera.Dolly(1.2)
        renderer.ResetCameraClippingRange()
    renderer.SetActiveCamera(camera)
    window.AddRenderer(renderer)
window.Render()

image = vtkWindowToImageFilter()
image.SetInput(window)
image.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "points_splats_mesh.png")
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
