#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The smallest program that draws a point cloud as a surface.

Put vtkPointSplatMapper where vtkPolyDataMapper would stand. Here the cloud is a
sphere's vertices and normals; the picture goes to a file, no X server needed.
"""
import sys

from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter

cloud = vtkSphereSource()
cloud.SetThetaResolution(120)
cloud.SetPhiResolution(60)

mapper = vtkPointSplatMapper()
mapper.SetInputConnection(cloud.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)

renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkEGLHeadlessRenderWindow()
window.SetSize(400, 400)
window.AddRenderer(renderer)
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "splat_sphere.png")
writer.Write()
