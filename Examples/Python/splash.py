#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A drop has fallen into a tank: the fluid's particles as VTK draws points, its surface from them,
and the same as clear water under a sky.   splash.py [PICTURE.png]"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture, vtkWindowToImageFilter)
from pointsplatting import (
    vtkEGLHeadlessRenderWindow, vtkParticleSurfacePoints, vtkPointSplatMapper)

# Particles about one unit apart: a pool with rings on it, a crown one particle thick, a jet in its
# middle, and spray, faster the higher it is.
random = np.random.default_rng(4)
x, depth, z = np.meshgrid(np.arange(-35, 36), np.arange(14), np.arange(-35, 36), indexing="ij")
r = np.hypot(x, z)
level = (9 - 5 * np.exp(-((r / 9) ** 2)) +
         2.5 * np.exp(-(((r - 16) / 7) ** 2)) * np.cos(0.55 * (r - 15)))
pool = np.stack([x, level - 0.5 - depth, z], -1)[level > depth + 0.5]
pool += random.uniform(-0.2, 0.2, pool.shape)
crown = []
for k in range(11):
    radius = 11 + 0.04 * k * k
    a = np.arange(0, 2 * np.pi, 1 / radius)
    a = a[np.sin(9 * a) + 1.2 > (k - 5) / 4]  # fingers
    crown.append(np.stack([radius * np.cos(a), 9.5 + k + 0 * a, radius * np.sin(a)], -1))
crown = np.concatenate(crown)
j = np.arange(0, 12, 0.9)
jet = np.concatenate([np.stack([w * np.cos(b + j), 4 + j, w * np.sin(b + j)], -1)
                      for w, b in ((0, 0), (1, 0), (1, 2.1), (1, 4.2))])
a = random.uniform(0, 2 * np.pi, 90)
h = random.uniform(0, 1, 90)
spray = np.stack([(13 + 14 * h) * np.cos(a), 20 + 22 * h * random.uniform(0.3, 1, 90),
                  (13 + 14 * h) * np.sin(a)], -1)
particles = np.concatenate([pool, crown, jet, spray])

data = vtkPolyData()
data.SetPoints(vtkPoints())
data.GetPoints().SetData(numpy_to_vtk(particles.astype(np.float32), deep=1))
surface = vtkParticleSurfacePoints()
surface.SetInputData(data)
surface.Update()


def sky(width=1024, height=512):
    """Brighter towards the horizon, with a sun, over a tiled ground; y is up."""
    a, b = np.meshgrid(2 * np.pi * ((np.arange(width) + 0.5) / width - 0.5),
                       np.pi * ((np.arange(height) + 0.5) / height - 0.5))
    d = np.stack([np.cos(b) * np.cos(a), np.sin(b), np.cos(b) * np.sin(a)], axis=-1)
    t = np.clip(d[..., 1:2], 0, 1) ** 0.5
    colour = (1 - t) * np.array([0.95, 0.93, 0.90]) + t * np.array([0.15, 0.35, 0.70])
    sun = d @ (np.array([-0.5, 0.6, 0.6]) / np.linalg.norm([-0.5, 0.6, 0.6]))
    colour += 2 * np.clip(400 * (sun - 0.995), 0, 1)[..., None]
    p = 2 * d / np.minimum(d[..., 1:2], -1e-2)
    tile = (np.floor(p[..., 0]) + np.floor(p[..., 2])) % 2
    colour = np.where(d[..., 1:2] < 0, 0.5 + 0.2 * tile[..., None], colour)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk((255 * np.clip(colour, 0, 1)).astype(np.uint8).reshape(-1, 3), deep=1))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1500, 500)
camera = None
for i in range(3):
    renderer = vtkRenderer()
    renderer.SetViewport(i / 3, 0, (i + 1) / 3, 1)
    renderer.SetBackground(0.1, 0.2, 0.4)
    actor = vtkActor()
    if i == 0:
        vertices = vtkVertexGlyphFilter()
        vertices.SetInputData(data)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(vertices.GetOutputPort())
        actor.GetProperty().SetPointSize(2)
    else:
        mapper = vtkPointSplatMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
    if i == 2:
        mapper.RefractionOn()
        mapper.SetRefractiveIndex(1.33)
        mapper.SetAbsorption(0.025, 0.008, 0.004)  # per unit: deep water is blue
        actor.GetProperty().SetOpacity(0)
        renderer.SetEnvironmentTexture(sky())
        renderer.SetBackground(0.75, 0.8, 0.85)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.35, 0.55, 0.95)
    actor.GetProperty().SetSpecular(0.3)
    actor.GetProperty().SetSpecularPower(20)
    renderer.AddActor(actor)
    if camera is None:
        camera = renderer.GetActiveCamera()
        camera.SetPosition(60, 75, 110)
        camera.SetFocalPoint(0, 12, 0)
        camera.SetViewAngle(32)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "splash.png")
writer.Write()
