#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent splats beside the depth-peeled mesh of the same points, interleaved in one run, medians.

  transparency_benchmark.py [--samples N] [--size PIXELS] [--runs N]

1. Three nested isosurfaces of a hydrogen orbital, opacities 0.3, 0.5 and 1: frame times of the
   mesh, of all layers peeled, of 8, of sorted and of nearest-exact transparency, and their likeness
   (psnr) to the mesh, supersampled 2 x 2.
2. 27 spheres (Guennebaud, Barthe, Paulin 2006, figure 6): six layers, three, and three of which
   the last gathers the rest, against all layers.
"""
import argparse
import os
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import pointsplatting

arguments = argparse.ArgumentParser(
    description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("--samples", type=int, default=256)
arguments.add_argument("--size", type=int, default=1024)
arguments.add_argument("--runs", type=int, default=5)
options = arguments.parse_args()
SHELLS = ((4.0, 0.3, (0.35, 0.55, 0.95)), (18.0, 0.5, (0.35, 0.8, 0.4)), (50.0, 1.0, (0.85, 0.55, 0.3)))


def orbital(n):
    """The density of hydrogen's 3d orbital along z, greatest value 100."""
    x = np.linspace(-18, 18, n, dtype=np.float32)
    z, y, x = np.meshgrid(x, x, x, indexing="ij")
    r2 = x * x + y * y + z * z
    density = ((3 * z * z - r2) * np.exp(-np.sqrt(r2) / 3)) ** 2
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(-18, -18, -18)
    image.SetSpacing(36 / (n - 1), 36 / (n - 1), 36 / (n - 1))
    values = numpy_to_vtk((100 * density / density.max()).ravel(), deep=1)
    values.SetName("density")
    image.GetPointData().SetScalars(values)
    return image


def surfaces():
    image = orbital(options.samples)
    parts = []
    for value, opacity, colour in SHELLS:
        contour = vtkFlyingEdges3D()
        contour.SetInputData(image)
        contour.SetValue(0, value)
        contour.ComputeNormalsOn()
        contour.ComputeScalarsOff()
        contour.Update()
        parts.append((contour.GetOutput(), opacity, colour))
    return parts


def cloud(mesh):
    data = vtkPolyData()
    data.SetPoints(mesh.GetPoints())
    data.GetPointData().SetNormals(mesh.GetPointData().GetNormals())
    return data


class Scene:
    def __init__(self, parts, size, splats, configure=lambda mapper: None):
        self.size = size
        self.mappers = []
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.2, 0.4)
        self.renderer.UseDepthPeelingOn()
        self.renderer.SetMaximumNumberOfPeels(30)
        self.renderer.SetOcclusionRatio(0.0)
        for part in parts:
            mapper = pointsplatting.vtkPointSplatMapper() if splats else vtkPolyDataMapper()
            mapper.SetInputData(cloud(part[0]) if splats else part[0])
            if splats:
                configure(mapper)
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetOpacity(part[1])
            actor.GetProperty().SetColor(part[2])
            if len(part) > 3:
                actor.SetPosition(part[3])
            self.renderer.AddActor(actor)
            self.mappers.append(mapper)
        if os.environ.get("DISPLAY"):
            self.window = vtkRenderWindow()
            self.window.OffScreenRenderingOn()
        else:
            self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        self.renderer.ResetCamera()
        camera.Azimuth(25)
        camera.Elevation(20)
        self.renderer.ResetCameraClippingRange()
        self.times = []

    def draw(self, turn=0):
        self.renderer.GetActiveCamera().Azimuth(turn)
        self.renderer.ResetCameraClippingRange()
        pixels = vtkUnsignedCharArray()
        start = time.perf_counter()
        self.window.Render()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        self.times.append(1e3 * (time.perf_counter() - start))
        return vtk_to_numpy(pixels).reshape(self.size, self.size, 3).astype(np.float32)


def psnr(a, b):
    drawn = (np.abs(a - a[0, 0]).max(2) > 2) | (np.abs(b - b[0, 0]).max(2) > 2)
    return 10 * np.log10(255 ** 2 / max(((a - b)[drawn] ** 2).mean(), 1e-4))


parts = surfaces()
size = options.size
reference = Scene(parts, 2 * size, False).draw().reshape(size, 2, size, 2, 3).mean((1, 3))
scenes = {
    "mesh, depth-peeled": Scene(parts, size, False),
    "splats, peeled": Scene(parts, size, True, lambda m: m.SetTransparencyToPeeling()),
    "splats, 8 layers": Scene(parts, size, True, lambda m: m.SetMaximumNumberOfLayers(8)),
    "splats, nearest exact": Scene(parts, size, True, lambda m: m.SetTransparencyToNearestExact()),
    "splats, sorted": Scene(parts, size, True, lambda m: m.SetTransparencyToSorted()),
}
pictures = {name: scene.draw() for name, scene in scenes.items()}
for scene in scenes.values():
    scene.times.clear()
for _ in range(options.runs):
    for scene in scenes.values():
        scene.draw(3)
points = sum(part[0].GetNumberOfPoints() for part in parts)
print(f"Nested isosurfaces, {points} points, {size} x {size}")
for name, scene in scenes.items():
    layers = scene.mappers[0].GetNumberOfLayersDrawn() if "splats" in name else ""
    print(f"  {name:24}{statistics.median(scene.times):8.0f} ms {psnr(reference, pictures[name]):8.1f} dB"
          f"   {layers} {'layers' if layers != '' else ''}")
del scenes

sphere = vtkSphereSource()
sphere.SetThetaResolution(100)
sphere.SetPhiResolution(50)
sphere.Update()
many = [(sphere.GetOutput(), 0.4, ((x + 2) / 3, (y + 2) / 3, (z + 2) / 3), (1.2 * x, 1.2 * y, 1.2 * z))
        for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
scene = Scene(many, size // 2, True)
full = scene.draw()
print(f"27 spheres, {scene.mappers[0].GetNumberOfLayersDrawn()} layers in all; likeness to all of them")
for layers, gather in ((6, False), (3, False), (3, True)):
    for mapper in scene.mappers:
        mapper.SetMaximumNumberOfLayers(layers)
        mapper.SetGatherRemaining(gather)
    print(f"  {layers} layers{', the last gathering the rest' if gather else '':32}{psnr(full, scene.draw()):8.1f} dB")
