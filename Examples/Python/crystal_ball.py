#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A crystal ball, a ring of ruby glass and a lacquered ball, all of points, that refract and
reflect a sky over a chequered floor.   crystal_ball.py [PICTURE.png]"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageResample
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkRenderer, vtkRenderWindow, vtkSkybox, vtkTexture, vtkWindowToImageFilter)
from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper


def environment(width=3072, height=1536):
    """A sky with a sun above a floor, as an equirectangular picture; y is up."""
    a, b = np.meshgrid(2 * np.pi * ((np.arange(width) + 0.5) / width - 0.5),
                       np.pi * ((np.arange(height) + 0.5) / height - 0.5))
    d = np.stack([np.cos(b) * np.cos(a), np.sin(b), np.cos(b) * np.sin(a)], axis=-1)
    d = d.astype(np.float32)
    up = d[..., 1:2]
    # Sky: from a warm horizon to a deep blue, streaks of cloud, and a sun.
    t = np.clip(up, 0, 1) ** 0.45
    colour = (1 - t) * np.array([1.0, 0.82, 0.62]) + t * np.array([0.10, 0.27, 0.62])
    q = d / np.maximum(up, 0.06)
    cloud = (np.sin(1.3 * q[..., 0] + 2 * np.sin(0.7 * q[..., 2])) +
             np.sin(2.1 * q[..., 2] + 1.5 * np.sin(1.1 * q[..., 0])))[..., None] / 4 + 0.5
    cloud = np.clip(2 * cloud - 1, 0, 1) * np.clip(4 * up, 0, 1)
    colour += 0.7 * cloud * (1 - colour)
    sun = d @ (np.array([-0.55, 0.5, -0.67]) / np.linalg.norm([-0.55, 0.5, -0.67]))
    colour += np.exp(60 * (sun - 1))[..., None] * np.array([0.5, 0.4, 0.2])
    colour += 2 * np.clip(2000 * (sun - 0.9985), 0, 1)[..., None]
    # Floor: tiles, that fade into the horizon.
    p = 1.6 * d / np.minimum(up, -1e-3)
    tile = (np.floor(p[..., 0] + 0.35) + np.floor(p[..., 2])) % 2
    floor = np.where(tile[..., None] > 0.5, [0.92, 0.88, 0.80], [0.16, 0.22, 0.30])
    fade = np.exp(-0.09 * np.linalg.norm(p[..., ::2], axis=-1))[..., None]
    floor = fade * floor + (1 - fade) * np.array([1.0, 0.82, 0.62]) * 0.9
    colour = np.clip(np.where(up < 0, floor, colour), 0, 1)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk((255 * colour + 0.5).astype(np.uint8).reshape(-1, 3), deep=1))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


def cloud(points, normals):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points.astype(np.float32), deep=1))
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype(np.float32), deep=1))
    return data


def sphere(centre, radius, count=60000):
    k = np.arange(count) + 0.5
    z = 1 - 2 * k / count
    a = np.pi * (1 + 5 ** 0.5) * k
    n = np.stack([np.sqrt(1 - z * z) * np.cos(a), z, np.sqrt(1 - z * z) * np.sin(a)], axis=-1)
    return cloud(np.array(centre) + radius * n, n)


def ring(centre, major, minor, tilt, count=90000):
    k = np.arange(count) + 0.5
    a, b = 2 * np.pi * k * (5 ** 0.5 - 1) / 2, 2 * np.pi * k / count
    n = np.stack([np.cos(b) * np.cos(a), np.sin(b), np.cos(b) * np.sin(a)], axis=-1)
    p = major * np.stack([np.cos(a), 0 * a, np.sin(a)], axis=-1) + minor * n
    c, s = np.cos(tilt), np.sin(tilt)
    turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    return cloud(np.array(centre) + p @ turn.T, n @ turn.T)


def body(data, opacity=0.0, colour=(1, 1, 1), index=1.5, dispersion=0.0, absorption=(0, 0, 0)):
    mapper = vtkPointSplatMapper()
    mapper.SetInputData(data)
    mapper.RefractionOn()
    mapper.SetRefractiveIndex(index)
    mapper.SetDispersion(dispersion)
    mapper.SetAbsorption(absorption)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


sky = environment()
renderer = vtkRenderer()
renderer.SetEnvironmentTexture(sky)
skybox = vtkSkybox()
skybox.SetTexture(sky)
skybox.SetProjectionToSphere()
skybox.SetFloorRight(0, 0, 1)  # so it shows the picture where the environment has it
renderer.AddActor(skybox)
renderer.AddActor(body(sphere((0, 0, 0), 1.0), index=1.5, dispersion=0.04))
renderer.AddActor(body(ring((1.75, -0.45, 0.35), 0.42, 0.17, 1.1), index=1.45,
                       absorption=(0.2, 3.5, 3.0)))
renderer.AddActor(body(sphere((-1.7, -0.5, 0.3), 0.5), opacity=1.0, colour=(0.04, 0.22, 0.16)))
camera = renderer.GetActiveCamera()
camera.SetPosition(0, 0.75, 6.4)
camera.SetFocalPoint(0.02, -0.08, 0)
camera.SetViewAngle(28)
renderer.ResetCameraClippingRange()

window = vtkRenderWindow() if os.environ.get("DISPLAY") else vtkEGLHeadlessRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(1800, 1000)
window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
smaller = vtkImageResample()  # two by two pixels to one smooth edges
grab.Update()
smaller.SetInputData(grab.GetOutput())
smaller.SetDimensionality(2)
smaller.SetMagnificationFactors(0.5, 0.5, 1)
writer = vtkPNGWriter()
writer.SetInputConnection(smaller.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "crystal_ball.png")
writer.Write()
