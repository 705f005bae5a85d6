#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frame times that must hold against what stock VTK takes for the same scene, in one run.

  against_stock.py [--size N] [--frames N] [--only WORD] [--smoke]

Frames of splats and of VTK's own mapper, the mesh or dots of a pixel, are taken in turn, each from
another side and with read-back; medians count. All data is made here: meshes whose vertices are
the clouds, and points spread at random. Ends with 1 where splats take too long. --smoke draws all of it
very small, once, and judges nothing. Not for machines that do something else meanwhile.
"""
import argparse
import gc
import os
import statistics
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Accuracy"))
try:
    import pointsplatting  # noqa: F401
except ImportError:  # where run.sh and test.sh build it
    sys.path.append(os.path.join(HERE, "..", "..", "build", "lib", "python3", "dist-packages"))

from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D  # noqa: E402

from bench.cloud import Cloud  # noqa: E402
from bench.settings import ALL_PEELS, Setting  # noqa: E402
from scenes import Scene, orbital_meshes, polydata, sphere_mesh  # noqa: E402

MESH = Setting("mesh", "opaque", "mesh")
PEELED = Setting("peeled mesh", "translucent", "mesh", peels=ALL_PEELS)
DOTS = Setting("dots", "opaque", "points")


def opaque_orbital(count):
    return orbital_meshes(count), [1.0, 1.0, 1.0]


def nested_orbital(count):
    return orbital_meshes(count), [0.3, 0.4, 0.5]


def single_orbital(count):
    return orbital_meshes(2.5 * count, (4.0,)), [0.6]


def engine(count):
    """Cylinders and a plate with ripples: two isosurfaces with holes and narrow ribs."""
    n = max(16, round(np.sqrt(count / 4.6)))
    z, y, x = np.mgrid[-1:1:n * 1j, -1:1:n * 1j, -1:1:n * 1j].astype(np.float32)
    field = np.maximum.reduce([
        1.2 - 1.6 * np.hypot(x, y) - 0.4 * np.abs(z), 1 - 2.2 * np.hypot(x - 0.5, z),
        1 - 2.2 * np.hypot(y + 0.4, z - 0.3), 0.9 - 3 * np.hypot(x + 0.4, y - 0.5)])
    field += 0.1 * np.sin(9 * x) * np.sin(8 * y) * np.sin(7 * z)
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(3 * [2 / (n - 1)])
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(), deep=1))
    meshes = []
    for value in (0.25, 0.55):
        contour = vtkFlyingEdges3D()
        contour.SetInputData(image)
        contour.SetValue(0, value)
        contour.ComputeNormalsOn()
        contour.ComputeScalarsOff()
        contour.Update()
        meshes.append(contour.GetOutput())
    return meshes, [0.3, 0.6]


def eight_spheres(count):
    return [sphere_mesh(count / 8, 0.55, (x, y, z))
            for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)], 8 * [0.4]


def many_spheres(count):
    centres = np.random.default_rng(2).uniform(-1, 1, (300, 3))
    return [sphere_mesh(count / 300, 0.1, centre) for centre in centres], 300 * [1.0]


def torus_points(count):
    """Spread evenly: where the torus is wider there are more."""
    random = np.random.default_rng(1)
    a, b, keep = random.uniform(0, 1, (3, 2 * count + 100))
    a, b = 2 * np.pi * a, 2 * np.pi * b
    kept = 1.4 * keep < 1 + 0.4 * np.cos(b)
    a, b = a[kept][:count], b[kept][:count]
    normals = np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)], 1)
    ring = np.stack([np.cos(a), np.sin(a), 0 * a], 1)
    return [polydata(ring + 0.4 * normals, normals)], [1.0]


def sphere_points(count):
    normals = np.random.default_rng(1).normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return [polydata(normals, normals)], [1.0]


# Splats take at most factor times what the peer takes, and so many milliseconds.
CASES = [
    # name, data, points, peer, factor, milliseconds
    ("orbital, opaque", opaque_orbital, 440000, MESH, 1.0, 0),
    ("orbital, three translucent", nested_orbital, 440000, PEELED, 0.35, 0),
    ("eight translucent spheres", eight_spheres, 160000, PEELED, 0.5, 0),
    ("engine, two translucent", engine, 130000, PEELED, 0.5, 0),
    ("single translucent isosurface", single_orbital, 150000, PEELED, 0.5, 0),
    ("torus, 100 k points", torus_points, 100000, DOTS, 1.5, 0),
    ("sphere, 1 k points", sphere_points, 1000, DOTS, 1.0, 35),
    ("torus, 4 M points", torus_points, 4000000, DOTS, 1.0, 0),
    ("300 actors", many_spheres, 300000, MESH, 2.0, 0),
]


def scene_of(name, data, count):
    meshes, opacities = data(count)
    bounds = np.array([mesh.GetBounds() for mesh in meshes]).reshape(-1, 3, 2)
    return Scene(name, [], lambda _: meshes, opacities,
                 (bounds[..., 0].min(0), bounds[..., 1].max(0)), zoom=1.0)


def milliseconds(scene, count, peer, size, frames):
    """Medians of splats and of the peer."""
    cloud = Cloud(scene, count)
    drawings = [setting.drawing(scene, cloud, size)
                for setting in (Setting("splats", peer.kind, "splats", peels=peer.peels), peer)]
    for drawing in drawings:
        drawing.draw()
        drawing.draw()
    times = ([], [])
    for _ in range(frames):
        for drawing, taken in zip(drawings, times):
            drawing.turn(3)
            drawing.draw()
            taken.append(drawing.milliseconds)
    for drawing in drawings:
        drawing.close()
    return cloud.points, *(statistics.median(taken) for taken in times)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=1024, help="pixels a side")
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--only", help="scenes with this in their names, and no others")
    parser.add_argument("--smoke", action="store_true")
    options = parser.parse_args()
    if options.smoke:
        options.size, options.frames = 64, 1
    print("| scene | points | splats, ms | stock, ms | | ratio | at most, ms | |",
          "|" + 8 * "---|", sep="\n")
    too_long = 0
    for name, data, count, peer, factor, more in CASES:
        if options.only and options.only not in name:
            continue
        count = count // 100 if options.smoke else count
        points, ours, stock = milliseconds(
            scene_of(name, data, count), count, peer, options.size, options.frames)
        gc.collect()
        most = factor * stock + more
        print(f"| {name} | {points} | {ours:.0f} | {stock:.0f} | {peer.name} | {ours / stock:.2f} "
              f"| {most:.0f} | {'too long' if ours > most else ''} |", flush=True)
        too_long += ours > most
    if too_long and not options.smoke:
        sys.exit(f"Splats take too long for {too_long} scenes.")


if __name__ == "__main__":
    main()
