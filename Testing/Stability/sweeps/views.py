# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of the view."""
import math

from sweeps.measures import FRONT, Scene, look, simple
from sweeps.registry import Stable, decades, sweep
from sweeps.surfaces import plate, spacing, sphere, torus

# Windows in which distances below are counted.
PIXELS = 300


@sweep(decades(2, 300, 9), Stable([4, 40, 150]), Stable([4]))
def close_up(pixels, n):
    """A splat's diameter in pixels."""
    diameter = 2 * 1.2 * spacing(n)
    distance = diameter * PIXELS / pixels / (2 * math.tan(math.radians(15)))
    # Beside the middle, where the surface is seen at a slant.
    return simple(sphere(), n, look((0.5, 0.3, 0.8 + distance), (0.5, 0.3, 0.8)))


@sweep([300, 100, 50, 30, 20, 10, 5], Stable([300, 50, 10]), Stable([300, 50, 10]))
def minification(diameter, n):
    """The cloud's diameter in pixels."""
    distance = 1 / math.sin(math.atan(diameter / PIXELS * math.tan(math.radians(15))))
    return simple(torus(), n, look((0, 0, distance)))


@sweep([60, 30, 15, 8, 4, 2, 1], Stable([30, 8], leaks=0.01), Stable([30, 8], leaks=0.01))
def grazing(degrees, n):
    """The angle between the view and a plane."""
    a = math.radians(degrees)
    return simple(plate(), n, look((0, -4 * math.cos(a), 4 * math.sin(a)), up=(0, 0, 1)),
                  interior=8)


@sweep([0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99], Stable([0, 0.8, 0.95]), Stable([0, 0.8]))
def camera_inside(off, n):
    """How far off a sphere's centre the camera is, looking at the near wall at a slant."""
    return simple(sphere(), n,
                  look((0, 0, off), (0.5, 0, 1.2), angle=60, clipping=(0.001, 3)))


@sweep(decades(10, 1e7, 7), Stable([1e6]), Stable([1e6]))
def clipping_ratio(ratio, n):
    """The far clipping plane's distance over the near one's."""
    return simple(torus(), n, look((0, 0, 4.2), clipping=(8 / ratio, 8)))


@sweep([0.05, 0.15, 0.5, 1.2, 5, 15], Stable([0.5, 1.2]), Stable([0.5, 1.2]))
def parallel_projection(scale, n):
    """Half the height of a parallel view, of a slanted torus."""
    return simple(torus(), n, look((0.7, -2, 2), (0.7, 0, 0.2), parallel=scale))


class InWindow(Scene):
    """Of its own size."""

    def __init__(self, pixels, n):
        made = simple(torus(), n, FRONT)
        super().__init__(made.surfaces, made.data, made.camera)
        self.pixels = pixels

    def measure(self, size, configure):
        return super().measure(self.pixels, configure)


@sweep([1, 2, 10, 100, 300, 1024, 4096], Stable([1, 100, 4096], enough=35),
       Stable([1, 100], enough=35))
def window(pixels, n):
    """The window's side."""
    return InWindow(pixels, n)
