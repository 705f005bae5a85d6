#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times beside what a user would pick in stock VTK, interleaved in one run, medians.

  splat_benchmark.py [--samples N] [--size PIXELS] [--runs N]

1. vtkIsosurfacePoints against vtkFlyingEdges3D with normals, on a volume of N^3 samples.
2. vtkPointSplatEstimation on the points found.
3. A frame, with read-back: splats, stock points, stock mesh, point Gaussians.
Exit code 1 if the isosurface points took longer than flying edges, or a frame of splats longer
than one of point Gaussians.
"""
import argparse
import os
import statistics
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPointGaussianMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
import pointsplatting

arguments = argparse.ArgumentParser(
    description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("--samples", type=int, default=256)
arguments.add_argument("--size", type=int, default=1024)
arguments.add_argument("--runs", type=int, default=7)
options = arguments.parse_args()
ISOVALUES = (4.0, 18.0, 50.0)


def orbital(n):
    """The density of hydrogen's 3d orbital along z, greatest value 100."""
    axis = np.linspace(-20, 20, n, dtype=np.float32)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    r2 = x * x + y * y + z * z
    density = ((3 * z * z - r2) * np.exp(-np.sqrt(r2) / 3)) ** 2
    density *= 100 / density.max()
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(-20, -20, -20)
    image.SetSpacing(3 * [40 / (n - 1)])
    image.GetPointData().SetScalars(numpy_to_vtk(density.ravel(), deep=1))
    return image


def interleaved(actions):
    """Median milliseconds of each action, all taken in turn."""
    times = {name: [] for name in actions}
    for run in range(options.runs + 1):
        for name, action in actions.items():
            start = time.perf_counter()
            action()
            if run:  # the first is a warm-up
                times[name].append(1e3 * (time.perf_counter() - start))
    return {name: statistics.median(values) for name, values in times.items()}


def report(title, medians):
    print(title)
    for name, ms in medians.items():
        print(f"  {name:28s} {ms:9.1f} ms")


volume = orbital(options.samples)
points = pointsplatting.vtkIsosurfacePoints()
edges = vtkFlyingEdges3D()
edges.ComputeNormalsOn()
edges.ComputeScalarsOff()
for extractor in (points, edges):
    extractor.SetInputData(volume)
    for i, value in enumerate(ISOVALUES):
        extractor.SetValue(i, value)


def run(algorithm):
    algorithm.Modified()
    algorithm.Update()


extraction = interleaved({"vtkIsosurfacePoints": lambda: run(points),
                          "vtkFlyingEdges3D": lambda: run(edges)})
count = points.GetOutput().GetNumberOfPoints()
report(f"extraction, {options.samples}^3 samples, {count} points", extraction)

estimation = pointsplatting.vtkPointSplatEstimation()
estimation.SetInputConnection(points.GetOutputPort())
report("estimation of the splats' radii", interleaved({"vtkPointSplatEstimation": lambda: run(estimation)}))

cloud = vtkPolyData()
cloud.SetPoints(edges.GetOutput().GetPoints())
cloud.GetPointData().SetNormals(edges.GetOutput().GetPointData().GetNormals())
dots = vtkVertexGlyphFilter()
dots.SetInputData(cloud)
dots.Update()
mappers = {"vtkPointSplatMapper": pointsplatting.vtkPointSplatMapper(),
           "stock points": vtkPolyDataMapper(), "stock mesh": vtkPolyDataMapper(),
           "vtkPointGaussianMapper": vtkPointGaussianMapper()}
mappers["vtkPointSplatMapper"].SetInputData(cloud)
mappers["stock points"].SetInputData(dots.GetOutput())
mappers["stock mesh"].SetInputData(edges.GetOutput())
mappers["vtkPointGaussianMapper"].SetInputData(dots.GetOutput())
mappers["vtkPointGaussianMapper"].EmissiveOff()
mappers["vtkPointGaussianMapper"].SetScaleFactor(cloud.GetLength() / 400)

frames = {}
for name, mapper in mappers.items():
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = (vtkRenderWindow() if os.environ.get("DISPLAY")
              else pointsplatting.vtkEGLHeadlessRenderWindow())
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(options.size, options.size)
    window.AddRenderer(renderer)
    renderer.ResetCamera()

    def frame(window=window, renderer=renderer):
        renderer.GetActiveCamera().Azimuth(3)
        renderer.ResetCameraClippingRange()
        window.Render()
        window.GetPixelData(0, 0, options.size - 1, options.size - 1, 0, vtkUnsignedCharArray(), 0)

    frames[name] = frame
drawing = interleaved(frames)
report(f"a frame of {cloud.GetNumberOfPoints()} points, {options.size} x {options.size}", drawing)

slow = []
if extraction["vtkIsosurfacePoints"] > extraction["vtkFlyingEdges3D"]:
    slow.append("vtkIsosurfacePoints took longer than vtkFlyingEdges3D")
if drawing["vtkPointSplatMapper"] > drawing["vtkPointGaussianMapper"]:
    slow.append("splats took longer than point Gaussians")
for line in slow:
    print("SLOW:", line)
sys.exit(1 if slow else 0)
