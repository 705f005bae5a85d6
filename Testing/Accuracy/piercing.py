# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins whose surfaces pierce one another (standins.py)."""
import math

import numpy as np
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from parametric import parametric
from scenes import sphere_mesh
from standin import StandIn, vertices


def crossing(angle=60):
    """Two balls, each of which goes on inside of the other, whose surfaces cross at so many degrees."""
    apart = 2 * math.sin(math.radians(angle) / 2)
    centres = [(-apart / 2, 0, 0), (apart / 2, 0, 0)]
    append = vtkAppendPolyData()
    for centre in centres:
        append.AddInputData(sphere_mesh(20000, 1.0, centre))
    append.Update()
    mesh = append.GetOutput()
    return StandIn("crossing", vertices(mesh),
                   lambda p: np.min([np.abs(np.linalg.norm(p - c, axis=1) - 1) for c in centres], 0),
                   math.pi / 2 / 58, mesh)


def belted(ratio=8):
    """A ball with a belt, which lies a little off it, whose vertices are ratio times as near together."""
    radius, tube, spacing = 1.04, 0.03, math.pi / 2 / 31

    def belt(u, v):
        r = radius + tube * np.cos(v)
        return np.stack([r * np.cos(u), r * np.sin(u), tube * np.sin(v)], -1)
    around, across = (round(2 * math.pi * r * ratio / spacing) for r in (radius, tube))
    append = vtkAppendPolyData()
    append.AddInputData(sphere_mesh(6 * 31 * 31, 1.0))
    append.AddInputData(parametric(belt, around, across, (0, 2 * math.pi), (0, 2 * math.pi)))
    append.Update()
    mesh = append.GetOutput()

    def distance(p):
        to_belt = np.hypot(np.hypot(p[:, 0], p[:, 1]) - radius, p[:, 2]) - tube
        return np.minimum(np.abs(np.linalg.norm(p, axis=1) - 1), np.abs(to_belt))
    return StandIn("belted", vertices(mesh), distance, spacing, mesh)
