#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPointSplatEstimation takes, beside vtkPCANormalEstimation in the same run.

  estimation.py [--points N] [--rounds N] [--bound RATIO]

Both are given the same points at random on a torus, and have their defaults;
vtkPCANormalEstimation finds normals only. Splats are timed with normals given, and without; for a
sixteenth of the points, sixteen times each; then a mesh's vertices without and with their triangles.
Processor time of all threads, the least of the rounds, in which the filters take turns. Ends with 1
if, with normals given, splats take more than RATIO of vtkPCANormalEstimation's time, or points that
share their places more than others.
"""
import argparse
import os
import sys
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Accuracy"))
try:
    import pointsplatting
except ImportError:  # where run.sh and test.sh build it
    sys.path.append(os.path.join(HERE, "..", "..", "build", "lib", "python3", "dist-packages"))
    import pointsplatting

from vtkmodules.vtkCommonDataModel import vtkPolyData  # noqa: E402
from vtkmodules.vtkFiltersPoints import vtkPCANormalEstimation  # noqa: E402

from scenes import grid_triangles, polydata  # noqa: E402

Splats = pointsplatting.vtkPointSplatEstimation


def torus(u, v):
    """Points and normals, by angles."""
    n = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], -1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], -1) + 0.4 * n, n


def torus_at_random(count):
    rng = np.random.default_rng(1)
    u, v = rng.uniform(0, 2 * np.pi, (2, 2 * count))
    kept = rng.uniform(0, 1.4, 2 * count) < 1 + 0.4 * np.cos(v)  # by equal areas
    return torus(u[kept][:count], v[kept][:count])


def torus_mesh(count):
    rows = int(np.sqrt(0.4 * count))
    columns = count // rows
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, columns + 1), np.linspace(0, 2 * np.pi, rows + 1))
    points, normals = torus(u, v)
    numbers = np.arange(u.size).reshape(u.shape)
    return polydata(points.reshape(-1, 3), normals.reshape(-1, 3),
                    grid_triangles(columns, rows, numbers))


def without_triangles(mesh):
    cloud = vtkPolyData()
    cloud.SetPoints(mesh.GetPoints())
    cloud.GetPointData().SetNormals(mesh.GetPointData().GetNormals())
    return cloud


def took(make, data):
    estimation = make()
    estimation.SetInputData(data)
    start = time.process_time()
    estimation.Update()
    return time.process_time() - start


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1000000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--bound", type=float)
    options = parser.parse_args()
    points, normals = torus_at_random(options.points)
    mesh = torus_mesh(options.points)
    copies = [np.repeat(values[:options.points // 16], 16, 0) for values in (points, normals)]
    cases = {"vtkPCANormalEstimation": (vtkPCANormalEstimation, polydata(points, None)),
             "splats, normals given": (Splats, polydata(points, normals)),
             "splats, normals estimated": (Splats, polydata(points, None)),
             "sixteen at each place": (Splats, polydata(*copies)),
             "a mesh's vertices": (Splats, without_triangles(mesh)),
             "and its triangles": (Splats, mesh)}
    times = {name: float("inf") for name in cases}
    for _ in range(options.rounds):
        for name, case in cases.items():
            times[name] = min(times[name], took(*case))
    stock = times["vtkPCANormalEstimation"]
    for name, seconds in times.items():
        print("%-26s %8d points %8.3f s, %.2f of vtkPCANormalEstimation's" % (
            name, options.points, seconds, seconds / stock))
    ratio = times["splats, normals given"] / stock
    if options.bound and ratio > options.bound:
        print("FALLS SHORT: %.2f is more than %.2f" % (ratio, options.bound))
        return 1
    if options.bound and times["sixteen at each place"] > times["splats, normals given"]:
        print("FALLS SHORT: points that share their places take longer than others")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
