#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What it costs to follow a camera through a file of points with levels of detail.

  streaming.py [--points MILLIONS] [--pieces N] [--size PIXELS] [--room MILLIONS] [--file FILE]
               [--bound DB]

A bumpy ball of random points with normals, in pieces side by side, is written to a file. Of views from
outside, near by and close up this prints the seconds until the file is open and the first cut is
there, after a step of the camera's, after a second one like it that was read ahead, and back where it was
before; of each the splats, and the megabytes of arrays that were read from the file (the system has it in
memory, so that none waits for a disk). Last comes the psnr of the first cut's picture against
that of all points. With --file an existing file is read, or the new one is kept. With --bound the
program fails where a psnr is less.
"""
import argparse
import os
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkCamera
import pointsplatting

from bench.shapes import bumpy
from levels import Drawing, psnr

# Positions and focal points, and the step that is taken in each.
VIEWS = {
    "outside": ((0, -7, 3), (0, 0, 0), (0.3, 0, 0)),
    "near": ((0, -2.2, 0.6), (0, -0.6, 0.2), (0.1, 0, 0)),
    "close": ((0, -1.25, 0.25), (0, -0.9, 0.2), (0.05, 0, 0.02)),
}


def write(name, count, pieces):
    points, normals = bumpy(count, np.random.default_rng(1))
    # Side by side, as scans are, and not one in another.
    angle = np.arctan2(points[:, 1], points[:, 0])
    radius = 1.6 * np.sqrt(4 * np.pi * 1.1 / count)
    writer = pointsplatting.vtkPointSplatOctreeWriter()
    writer.SetFileName(name)
    writer.Open()
    for piece in range(pieces):
        low, high = (2 * np.pi * (piece + i) / pieces - np.pi for i in (0, 1))
        own = (angle >= low) & (angle < high)
        data = vtkPolyData()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(points[own].astype("f4"), deep=True))
        data.SetPoints(places)
        data.GetPointData().SetNormals(numpy_to_vtk(normals[own].astype("f4"), deep=True))
        radii = numpy_to_vtk(np.full(int(own.sum()), radius, "f4"), deep=True)
        radii.SetName("SplatRadius")
        data.GetPointData().AddArray(radii)
        writer.Append(data)
    writer.Close()


class Reading:
    """Prints what each reading costs."""

    def __init__(self, name, camera, options):
        self.reader = pointsplatting.vtkPointSplatOctreeReader()
        self.reader.SetFileName(name)
        self.reader.SetCamera(camera)
        self.reader.SetViewSize(options.size, options.size)
        self.reader.SetMaximumNumberOfPoints(int(1e6 * options.room))

    def measure(self, what, work):
        before = self.reader.GetNumberOfBytesRead()
        start = time.perf_counter()
        done = work()
        seconds = time.perf_counter() - start
        read = (self.reader.GetNumberOfBytesRead() - before) / 1e6
        splats = self.reader.GetOutput().GetNumberOfPoints()
        note = "" if done else ", nothing to read"
        print(f"  {what:22s} {seconds:8.3f} s {read:9.1f} MB {splats:9d} splats{note}", flush=True)

    def first(self):
        self.reader.Update()
        return True

    def follow(self):
        found = self.reader.FollowCamera()
        self.reader.Update()
        return found

    def ahead(self):
        while self.reader.Prefetch(0.02):
            pass
        return True


def shown(reader):
    data = vtkPolyData()
    data.ShallowCopy(reader.GetOutput())
    return data


def measure(name, view, options):
    position, focus, step = (np.array(x, float) for x in VIEWS[view])
    camera = vtkCamera()
    camera.SetViewUp(0, 0, 1)

    def go(steps):
        camera.SetPosition(position + steps * step)
        camera.SetFocalPoint(focus + steps * step)

    print(view)
    go(0)
    reading = Reading(name, camera, options)
    reading.measure("first cut", reading.first)
    cut = shown(reading.reader)
    go(1)
    reading.measure("after a step", reading.follow)
    reading.measure("reading ahead", reading.ahead)
    go(2)
    reading.measure("after a second step", reading.follow)
    go(0)
    reading.measure("back", reading.follow)

    reader = pointsplatting.vtkPointSplatOctreeReader()
    reader.SetFileName(name)
    reader.SetCacheSize(0)
    start = time.perf_counter()
    reader.Update()
    seconds = time.perf_counter() - start
    drawing = Drawing(shown(reader), options.size)
    drawing.mapper.LevelOfDetailOff()
    drawing.renderer.SetActiveCamera(camera)
    drawing.renderer.ResetCameraClippingRange()
    best = drawing.picture()
    drawing.mapper.SetInputData(cut)
    likeness = psnr(drawing.picture(), best)
    drawing.window.Finalize()
    print(f"  all {reader.GetOutput().GetNumberOfPoints()} points: {seconds:.3f} s; "
          f"the first cut against them: {likeness:.1f} dB", flush=True)
    return likeness


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, default=4.0)
    parser.add_argument("--pieces", type=int, default=4)
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--room", type=float, default=4.0)
    parser.add_argument("--file")
    parser.add_argument("--bound", type=float, default=0.0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        name = options.file or os.path.join(folder, "points.h5")
        if not os.path.exists(name):
            start = time.perf_counter()
            write(name, int(1e6 * options.points), options.pieces)
            print(f"written in {time.perf_counter() - start:.1f} s, "
                  f"{os.path.getsize(name) / 1e6:.0f} MB")
        worst = min(measure(name, view, options) for view in VIEWS)
    raise SystemExit(int(worst < options.bound))


if __name__ == "__main__":
    main()
