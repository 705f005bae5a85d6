#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""One cloud as one block and as many: frames of both, in turn, by processor time.

blocks.py [--points N] [--blocks N] [--size N] [--opacity A] [--frames N] [--bound X] [--dealt]

The blocks are rows of a torus' grid, with sizes; or, with --dealt, random points of a torus, dealt out at random, with normals alone.
With a bound the exit code is 1 where the many blocks' median frame takes more than X times that of
the one block.
"""
import argparse
import os
import statistics
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import pointsplatting

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from bench.cloud import Cloud  # noqa: E402
from bench.shapes import torus  # noqa: E402
from drawing import Drawing  # noqa: E402
from scenes import polydata, torus_scene  # noqa: E402


LONGEST_WAIT = 600  # tenths of seconds


def part_of(whole, ids):
    """Some of the points, with their sizes."""
    data = whole.GetPointData()
    part = polydata(vtk_to_numpy(whole.GetPoints().GetData())[ids],
                    vtk_to_numpy(data.GetNormals())[ids])
    for name in ("SplatRadius", "SplatPlaneNormal", "SplatCurvature"):
        array = numpy_to_vtk(vtk_to_numpy(data.GetArray(name))[ids], deep=1)
        array.SetName(name)
        part.GetPointData().AddArray(array)
    return part


def mapper_of(data):
    mapper = pointsplatting.vtkPointSplatMapper()
    mapper.SetInputDataObject(data)
    return mapper


def wait(drawing):
    """Until there are levels, or there will be none."""
    for _ in range(LONGEST_WAIT):
        drawing.turn(1e-6)
        drawing.draw()
        if "being made" not in drawing.mappers[0].GetChoices():
            return
        time.sleep(0.1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=1000000)
    parser.add_argument("--blocks", type=int, default=1000)
    parser.add_argument("--size", type=int, default=768)
    parser.add_argument("--opacity", type=float, default=1.0)
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--bound", type=float)
    parser.add_argument("--dealt", action="store_true")
    options = parser.parse_args()

    scene = torus_scene()
    scene.properties[0].SetOpacity(options.opacity)
    blocks = vtkMultiBlockDataSet()
    if options.dealt:
        points, normals = torus(options.points, np.random.default_rng(1))
        whole = polydata(points, normals)
        for i in range(options.blocks):
            blocks.SetBlock(i, polydata(points[i::options.blocks], normals[i::options.blocks]))
    else:
        whole = Cloud(scene, options.points).splats()[0]
        for i, ids in enumerate(np.array_split(np.arange(whole.GetNumberOfPoints()), options.blocks)):
            blocks.SetBlock(i, part_of(whole, ids))
    drawings = [Drawing(scene, [mapper_of(data)], options.size) for data in (whole, blocks)]
    for drawing in drawings:
        for _ in range(3):  # levels are asked for when a frame is like the one before
            wait(drawing)
    times = [[], []]
    for frame in range(2 + options.frames):
        for own, drawing in zip(times, drawings):
            drawing.turn(7)
            drawing.draw()
            if frame >= 2:  # shaders are made before
                own.append(drawing.processor_milliseconds)
    one, many = map(statistics.median, times)
    print(f"{whole.GetNumberOfPoints()} points, opacity {options.opacity:g}, {options.size} x {options.size}: one block "
          f"{one:.0f} ms, {options.blocks} blocks {many:.0f} ms, {many / one:.2f} times")
    if options.bound and many > options.bound * one:
        sys.exit(f"more than {options.bound:g} times")


if __name__ == "__main__":
    main()
