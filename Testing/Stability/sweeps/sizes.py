# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of what is small beside the spacing of the points, and of edges."""
import math

import numpy as np
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from sweeps.measures import Scene, merged, simple
from sweeps.registry import Stable, sweep
from sweeps.surfaces import Surface, cloud, jittered, plane, random, sphere, torus


def tube(radius):
    """A tube, and as many points as make its radius so many spacings."""
    ring, own = 0.8, 0.1
    area = 4 * math.pi ** 2 * ring * own
    return torus(ring, own), int(area * (radius / own) ** 2)


@sweep([0.5, 0.7, 1, 1.4, 2, 3, 5, 10], Stable([2, 5], 14, leaks=0.01))
def tube_radius(radius, _):
    """radius of a tube, in spacings"""
    return simple(*tube(radius))


@sweep([0, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1], Stable([0.001, 0.3], 12, leaks=0.003))
def missing_normals(share, _):
    """share of points without a normal, on a tube of two spacings' radius"""
    surface, n = tube(2)
    p, m = surface.draw(n, random())
    m[random(10).permutation(n) < share * n] = 0
    return Scene([surface], [cloud(p, m)])


@sweep([1, 2, 3, 5, 10, 20, 50, 100, 300], Stable([50, 300], 18, leaks=0.03))
def component_size(points, _):
    """points at random on each of twelve small spheres"""
    spheres = [sphere(0.2, (0.55 * (k % 4) - 0.825, 0.6 * (k // 4) - 0.6, 0.1 * (k % 3)))
               for k in range(12)]
    return merged(spheres, int(points))


@sweep([15, 30, 60, 90, 120, 150, 170], Stable([90, 150], enough=30, leaks=0.01))
def crease_angle(degrees, n):
    """interior angle between two faces, degrees"""
    half = math.radians(degrees) / 2
    append = vtkAppendPolyData()
    points, normals = [], []
    for side in (1, -1):
        down = np.array([0, side * math.sin(half), -math.cos(half)])
        out = np.array([0, side * math.cos(half), math.sin(half)])
        first = np.array([1.0, 0, 0])
        append.AddInputData(plane(-first, *((first, down - first) if side < 0 else
                                            (down - first, first))))
        along, across = jittered(n // 2, random(12 + side))
        points.append(along[:, None] * first + 0.5 * (across[:, None] + 1) * down)
        normals.append(np.tile(out, (len(along), 1)))
    append.Update()
    roof = Surface(append.GetOutput(), None)
    # What is asked of is the edge: the borders count in other sweeps.
    return Scene([roof], [cloud(np.concatenate(points), np.concatenate(normals))], interior=6)
