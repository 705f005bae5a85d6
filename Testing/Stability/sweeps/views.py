# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of the view."""
import math

from sweeps.measures import COUNTS, FRONT, TWO_PASSES, Scene, look, simple
from sweeps.registry import Stable, coarse, decades, sweep
from sweeps.surfaces import plate, spacing, sphere, torus

# Windows in which distances below are counted.
PIXELS = 300


@sweep(decades(2, 300, 9), Stable([4, 40, 150]), coarse([4, 20]))
def close_up(pixels, n):
    """a splat's diameter in pixels, of 20,000 on a sphere"""
    diameter = 2 * 1.2 * spacing(COUNTS[TWO_PASSES])
    distance = diameter * PIXELS / pixels / (2 * math.tan(math.radians(15)))
    # Beside the middle, where the surface is seen at a slant.
    return simple(sphere(), n, look((0.5, 0.3, 0.8 + distance), (0.5, 0.3, 0.8)))


@sweep([300, 100, 50, 30, 20, 10, 5], Stable([300, 50, 10]), coarse([300, 50, 10]))
def minification(diameter, n):
    """the cloud's diameter in pixels"""
    distance = 1 / math.sin(math.atan(diameter / PIXELS * math.tan(math.radians(15))))
    return simple(torus(), n, look((0, 0, distance)))


@sweep([60, 30, 15, 8, 4, 2, 1], Stable([30, 8], leaks=0.01), coarse([30, 8]))
def grazing(degrees, n):
    """angle between the view and a plane, degrees"""
    a = math.radians(degrees)
    return simple(plate(), n, look((0, -4 * math.cos(a), 4 * math.sin(a)), up=(0, 0, 1)),
                  interior=8)


@sweep([0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99], Stable([0, 0.8, 0.95]), coarse([0]))
def camera_inside(off, n):
    """how far off the sphere's centre the camera is"""
    return simple(sphere(), n,
                  look((0, 0, off), (0.5, 0, 1.2), angle=60, clipping=(0.001, 3)))


@sweep(decades(10, 1e7, 7), Stable([1e6]), coarse([1e6]))
def clipping_ratio(ratio, n):
    """far clipping distance over the near one"""
    return simple(torus(), n, look((0, 0, 4.2), clipping=(8 / ratio, 8)))


@sweep([0.05, 0.15, 0.5, 1.2, 5, 15], Stable([0.5, 1.2]), coarse([0.5, 1.2]))
def parallel_projection(scale, n):
    """half the height of a parallel view"""
    return simple(torus(), n, look((0.7, -2, 2), (0.7, 0, 0.2), parallel=scale))


class InWindow(Scene):
    """Of its own size."""

    def __init__(self, pixels, n):
        made = simple(torus(), n, FRONT)
        super().__init__(made.surfaces, made.data, made.camera)
        self.pixels = pixels

    def measure(self, size, configure):
        return super().measure(self.pixels, configure)


@sweep([1, 2, 10, 100, 300, 1024, 4096], Stable([1, 100, 4096]), coarse([1, 100]))
def window(pixels, n):
    """the window's side, pixels"""
    return InWindow(pixels, n)
