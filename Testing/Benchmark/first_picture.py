#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long a user waits for the picture of a large cloud, and for all of it.

  first_picture.py [--points MILLIONS ...] [--size PIXELS]

For a torus of random points with normals, in a window that can be asked for frames, this prints
the seconds until the first Render() has returned, and until all points are drawn; of each picture on
the way how many points it had, and when it came; and the longest time that the window did
not answer: a frame, or a step of what is made in the background.
"""
import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
import pointsplatting
import vtkmodules.vtkInteractionStyle  # the interactor wants one

from bench.shapes import torus

LONGEST_WAIT = 600.0  # seconds


def cloud(count):
    points, normals = torus(count, np.random.default_rng(1))
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    data.SetPoints(places)
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype(np.float32), deep=True))
    return data


def measure(count, size):
    mapper = pointsplatting.vtkPointSplatMapper()
    mapper.SetInputData(cloud(count))
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = pointsplatting.vtkEGLHeadlessRenderWindow()
    window.SetShowWindow(True)  # as if on a screen
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    interactor = vtkGenericRenderWindowInteractor()
    interactor.AddObserver("CreateTimerEvent", lambda *_: None)
    interactor.SetRenderWindow(window)
    interactor.EnableRenderOff()
    interactor.Initialize()
    interactor.EnableRenderOn()

    start = time.perf_counter()
    window.Render()
    first = time.perf_counter() - start
    pictures = [(first, mapper.GetNumberOfSplats())]
    longest = 0.0
    while mapper.IsProgressing() and time.perf_counter() - start < LONGEST_WAIT:
        time.sleep(0.1)
        before = time.perf_counter()
        interactor.TimerEvent()
        longest = max(longest, time.perf_counter() - before)
        if mapper.GetNumberOfSplats() != pictures[-1][1]:
            pictures.append((time.perf_counter() - start, mapper.GetNumberOfSplats()))
    way = ", ".join(f"{n / 1e6:.2f} at {t:.1f}" for t, n in pictures)
    print(f"{count / 1e6:6.1f} {first:8.2f} {pictures[-1][0]:8.1f} {longest:8.2f}   {way}", flush=True)
    window.Finalize()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, nargs="+", default=[4.0, 16.0])
    parser.add_argument("--size", type=int, default=1024)
    options = parser.parse_args()
    print("points,M first, s   all, s pause, s   pictures: points,M and s")
    for millions in options.points:
        measure(int(1e6 * millions), options.size)


if __name__ == "__main__":
    main()
