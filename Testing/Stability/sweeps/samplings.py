# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of the points."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from sweeps.measures import NEAR, Scene, simple
from sweeps.registry import Stable, coarse, decades, sweep
from sweeps.scans import range_scan
from sweeps.surfaces import ball_in_volume, cloud, plate, random, spacing, sphere, torus


@sweep(decades(100, 200000, 8), Stable([2000, 20000]), coarse([200000]))
def density(n, _):
    """points of a sphere, at random"""
    return simple(sphere(), int(n))


@sweep([1, 2, 5, 10, 20, 50], Stable([1, 10]), coarse([1, 10], 16))
def non_uniform(ratio, n):
    """how many times denser one half of a torus is sampled"""
    surface = torus()
    p, m = surface.draw(n, random())
    keep = (p[:, 0] < 0) | (random(6).uniform(0, 1, len(p)) < 1 / ratio)
    return Scene([surface], [cloud(p[keep], m[keep])])


@sweep([0, 1, 2, 3, 4, 5, 6, 7], Stable(), coarse())
def random_gaps(seed, n):
    """the seed of a plate's random points: some have gaps"""
    rng = random(seed)
    p = np.stack([rng.uniform(-1, 1, n), rng.uniform(-1, 1, n), np.zeros(n)], 1)
    return Scene([plate()], [cloud(p, np.tile([0.0, 0.0, 1.0], (n, 1)))], NEAR)


@sweep([0, 0.02, 0.05, 0.1, 0.2, 0.5, 1], Stable([0.1], 14), coarse([0.1]))
def position_noise(sigma, n):
    """deviation of points along true normals, in spacings"""
    surface = sphere()
    p, m = surface.draw(n, random())
    p = p + m * random(7).normal(0, sigma * spacing(n), (n, 1))
    return Scene([surface], [cloud(p, m)])


@sweep([0, 0.1, 0.2, 0.3, 0.5, 0.7, 1], Stable([0.2, 0.5], 14, leaks=0.003))
def volume_noise(sigma, _):
    """deviation of a volume's values, in voxels of its isosurface's place"""
    surface = ball_in_volume(sigma)
    arrays = (surface.mesh.GetPoints().GetData(), surface.mesh.GetPointData().GetNormals())
    return Scene([surface], [cloud(*map(vtk_to_numpy, arrays))])


@sweep([0, 1, 2, 5, 10, 20, 40], Stable([2], 14), coarse([2]))
def normal_noise(degrees, n):
    """deviation of normals, degrees"""
    surface = sphere()
    p, m = surface.draw(n, random())
    m = m + random(8).normal(0, math.tan(math.radians(degrees)), m.shape)
    return Scene([surface], [cloud(p, m)])


@sweep([0, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1], Stable([0.001], 14, leaks=0.05),
       coarse([0.001], leaks=0.05))
def outliers(share, n):
    """share of points that lie anywhere about the sphere"""
    surface = sphere()
    p, m = surface.draw(n, random())
    count = int(share * n)
    p[:count] = random(9).uniform(-1.5, 1.5, (count, 3))
    return Scene([surface], [cloud(p, m)])


@sweep([0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.5], Stable([0.01, 0.3]), coarse([0.01, 0.3]))
def flipped_normals(share, n):
    """share of points whose normals point inward"""
    surface = sphere()
    p, m = surface.draw(n, random())
    m[random(10).uniform(0, 1, n) < share] *= -1
    return Scene([surface], [cloud(p, m)])


@sweep([0, 1e2, 1e4, 1e6, 1e8], Stable([1e6]), coarse([1e6]))
def far_coordinates(offset, n):
    """how far from the origin the sphere of radius 1 lies"""
    surface = sphere()
    p, m = surface.draw(n, random())
    shift = (offset, 0.7 * offset, -0.3 * offset)
    return Scene([surface], [cloud(p + shift, m)], offset=shift)


@sweep([0, 0.05, 0.1, 0.2, 0.5, 1, 2], Stable([0.2], 14), coarse([0.2]))
def range_scans(error, n):
    """noise and misplacement of six range scans, in spacings"""
    surface = torus()
    rng = random(11)
    step = math.sqrt(10 / n)  # so that all of them have about n points
    found = []
    for direction in ((0.3, 0.2, 1), (1, 0, 0.8), (-0.5, 0.9, 0.8), (-0.5, -0.9, 0.8),
                      (0.2, -0.4, 0.9), (-0.8, 0.3, 0.6)):
        p, m = range_scan(surface.mesh, direction, step, error * step, rng)
        found.append((p + rng.normal(0, error * step / math.sqrt(3), 3), m))
    return Scene([surface], [cloud(*(np.concatenate(part) for part in zip(*found)))])
