#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent and opaque bodies of points over ordinary meshes, without and with their shadows on these.   coloured_shadows.py [PICTURE.png]"""
import os
import sys

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource, vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource)
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
from pointsplatting import (
    vtkEGLHeadlessRenderWindow, vtkPointSplatMapper, vtkPointSplatShadowPass)


def ball(centre, radius):
    source = vtkSphereSource()
    source.SetCenter(centre)
    source.SetRadius(radius)
    source.SetThetaResolution(240)
    source.SetPhiResolution(120)
    return source


floor = vtkPlaneSource()
floor.SetOrigin(-2.2, -2.2, 0)
floor.SetPoint1(3.0, -2.2, 0)
floor.SetPoint2(-2.2, 2.8, 0)
block = vtkCubeSource()
block.SetBounds(0.9, 1.5, -0.6, 0.0, 0.0, 0.5)
shape = vtkParametricTorus()
shape.SetRingRadius(0.55)
shape.SetCrossSectionRadius(0.16)
torus = vtkParametricFunctionSource()
torus.SetParametricFunction(shape)
torus.SetUResolution(240)
torus.SetVResolution(100)

# What is drawn: the data, whether by splats, colour, opacity, and where.
bodies = [
    (floor, False, (0.93, 0.92, 0.9), 1.0, (0, 0, 0)),
    (block, False, (0.9, 0.9, 0.88), 1.0, (0, 0, 0)),
    (torus, True, (0.95, 0.75, 0.4), 1.0, (-0.2, 0.75, 0.75)),
    (ball((-0.75, -0.35, 0.75), 0.42), True, (1.0, 0.15, 0.1), 0.45, (0, 0, 0)),
    (ball((0.0, -0.6, 0.95), 0.42), True, (0.15, 0.9, 0.2), 0.45, (0, 0, 0)),
    (ball((0.75, 0.1, 1.05), 0.42), True, (0.15, 0.35, 1.0), 0.45, (0, 0, 0)),
]
window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1200, 440)
for i in range(2):
    renderer = vtkRenderer()
    renderer.SetViewport(i / 2, 0, (i + 1) / 2, 1)
    renderer.SetBackground(0.55, 0.62, 0.72)
    renderer.AutomaticLightCreationOff()
    for data, splats, colour, opacity, position in bodies:
        mapper = vtkPointSplatMapper() if splats else vtkPolyDataMapper()
        mapper.SetInputConnection(data.GetOutputPort())
        mapper.ScalarVisibilityOff()
        if splats:
            mapper.ShadowsOn()
            mapper.SetShadowLightRadius(0.12)
            mapper.SetNumberOfShadowSamples(24)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(position)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetAmbient(0.15)
        actor.GetProperty().SetDiffuse(0.85)
        actor.GetProperty().SetSpecular(0.2 if splats else 0.0)
        actor.GetProperty().SetSpecularPower(40)
        renderer.AddActor(actor)
    lamp = vtkLight()
    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(-2.5, 2.2, 5.0)
    lamp.SetFocalPoint(0, 0, 0)
    renderer.AddLight(lamp)
    if i == 1:
        renderer.SetPass(vtkPointSplatShadowPass()) # that is all
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.6, -5.2, 3.4)
    camera.SetFocalPoint(0.2, 0.0, 0.35)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(32)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "coloured_shadows.png")
writer.Write()
