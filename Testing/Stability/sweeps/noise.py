# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of noise, outliers and scans that contradict one another: as given, by default (the mapper
projects what it takes for noise), and through vtkPointSplatProjection."""
import functools
import math

import numpy as np
import pointsplatting

from sweeps.measures import COUNTS, TWO_PASSES, Scene
from sweeps.registry import SWEEPS, Stable, Sweep, unasked
from sweeps.samplings import outliers, range_scans
from sweeps.surfaces import cloud, random, spacing, torus

GIVEN, DEFAULT, PROJECTED = "as given", "by default", "projected"


def projected(data):
    projection = pointsplatting.vtkPointSplatProjection()
    projection.SetInputData(data)
    projection.Update()
    return projection.GetOutput()


def sweep(name, values, make, default, filtered):
    """make: a function of the value and of a number of points that makes the Scene."""
    @functools.lru_cache(maxsize=1)
    def scene(value):
        return make(value, COUNTS[TWO_PASSES])

    @functools.lru_cache(maxsize=1)
    def scene_projected(value):
        made = scene(value)
        other = Scene(made.surfaces, [projected(data) for data in made.data], made.camera)
        other.truths = made.truths
        return other

    def measure(series, value, size):
        made = scene_projected(value) if series == PROJECTED else scene(value)
        return made.measure(size, lambda mapper: mapper.SetProjectNoise(series == DEFAULT))[0]
    SWEEPS[name] = Sweep(name, make.__doc__.strip(), values,
                         {GIVEN: unasked(), DEFAULT: default, PROJECTED: filtered}, measure)


def noise(sigma, n):
    """deviation of points in all directions, in spacings; normals are off by 10 degrees"""
    surface = torus()
    p, m = surface.draw(n, random())
    p = p + random(7).normal(0, sigma * spacing(n), p.shape)
    m = m + random(8).normal(0, math.tan(math.radians(10)), m.shape)
    return Scene([surface], [cloud(p, m / np.linalg.norm(m, axis=1, keepdims=True))])


sweep("noise_projected", [0, 0.1, 0.2, 0.3, 0.5, 0.7, 1], noise, Stable([0.5], 14),
      Stable([0.2, 0.5], 14))
sweep("outliers_projected", [0, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1], outliers,
      unasked(), Stable([0.003], 8))
sweep("scans_projected", [0, 0.05, 0.1, 0.2, 0.5, 1, 2], range_scans, Stable([0.2], 14),
      Stable([0.2], 14))
