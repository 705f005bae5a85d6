# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of how near surfaces come to each other. All splats have a radius of about 0.02."""
import math

import numpy as np

from sweeps.measures import FRONT, NEAR, look, merged, several, simple
from sweeps.registry import Stable, coarse, sweep
from sweeps.surfaces import BLUE, RED, box, ellipsoid, plate, sphere

GAPS = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1]


def sheets(gap, n, opacity=1.0):
    return several([plate(gap, RED, opacity), plate(0, BLUE, opacity)], n, NEAR)


@sweep(GAPS, Stable([0.03, 0.1]), coarse([0.03, 0.1]))
def parallel_sheets(gap, n):
    """distance of a red sheet before a blue one, two actors"""
    return sheets(gap, n)


@sweep(GAPS, Stable([0.1]), coarse([0.1]))
def parallel_sheets_translucent(gap, n):
    """the same with opacity 0.5"""
    return sheets(gap, n, 0.5)


@sweep(GAPS, Stable([0.1]), coarse([0.1]))
def sheets_in_one(gap, n):
    """distance of two sheets of one actor, opacity 0.5"""
    pair = [plate(gap, RED, 0.5), plate(0, RED, 0.5)]
    return merged(pair, n, NEAR)


def turned(degrees):
    a = math.radians(degrees)
    return np.array([[math.cos(a), 0, -math.sin(a)], [0, 1, 0], [math.sin(a), 0, math.cos(a)]])


def crossing_sheets(degrees, n, draw=several, colour=BLUE):
    return draw([plate(0, RED), plate(0, colour, turn=turned(degrees))], n,
                look((0.3, -0.7, 0.8), up=(0, 0, 1)))


@sweep([5, 10, 20, 45, 90], Stable([20, 90], 12), coarse([90]))
def crossing(degrees, n):
    """angle at which two sheets cross, degrees"""
    return crossing_sheets(degrees, n)


@sweep([5, 10, 20, 45, 90], Stable([45], 13), coarse([90]))
def crossing_in_one(degrees, n):
    """angle at which two sheets of one actor cross, degrees"""
    return crossing_sheets(degrees, n, merged, RED)


@sweep([-0.3, -0.1, -0.03, -0.01, 0, 0.01, 0.03, 0.1, 0.3], Stable([-0.1, 0, 0.1]),
       coarse([0]))
def touching(gap, n):
    """distance of two spheres: 0 where they touch"""
    x = 0.5 + gap / 2
    return several([sphere(0.5, (-x, 0, 0), RED), sphere(0.5, (x, 0, 0), BLUE)], n,
                   look((0, 0, 4.2)))


@sweep(GAPS[:-1], Stable([0.001, 0.01, 0.1]), coarse([0.1]), quads=Stable([0.01]))
def thin_wall(thickness, n):
    """thickness of a wall, both sides in one actor"""
    return simple(box((1, 1, thickness / 2)), 2 * n, NEAR)


def hollow(wall, n, opacity):
    """A body like a turbine's blade: flat, with a cavity under a wall of that thickness."""
    axes = np.array((0.6, 1.0, 0.35))
    return several([ellipsoid(axes, RED, opacity), ellipsoid(axes - wall, BLUE, opacity, inward=True)],
                   n, FRONT)


@sweep([0.001, 0.003, 0.01, 0.03, 0.1, 0.3], Stable([0.03]), coarse([0.1]))
def cavity(wall, n):
    """thickness of the wall about a cavity, opacity 0.5"""
    return hollow(wall, n, 0.5)
