# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins that are rings of points (standins.py): tubes about curves, as vtkTubeFilter makes them of streamlines, and limbs of
coarse models. Points are some times as dense around them as along them."""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter, vtkTubeFilter

from standin import StandIn, vertices
from volumes import Capsules

RADIUS = 0.05


def curves(lines, seed=3):
    """Waves that run side by side, and pass each other by."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 6, 60)
    found = []
    for _ in range(lines):
        a, b, c = rng.uniform(-1, 1, 3)
        found.append(np.stack([t + a, np.sin(t + 3 * b) + 2 * b, np.cos(1.3 * t + 3 * c) + 2 * c], -1))
    return found


def streamtubes(sides=12, lines=30):
    """Of 12 sides rings are 4 to 7 times as far apart as their points are."""
    all_curves = curves(lines)
    points, cells, truth = vtkPoints(), vtkCellArray(), Capsules()
    points.SetData(numpy_to_vtk(np.concatenate(all_curves), deep=1))
    first = 0
    for curve in all_curves:
        cells.InsertNextCell(len(curve), range(first, first + len(curve)))
        truth.add(curve, [RADIUS] * len(curve))
        first += len(curve)
    polylines = vtkPolyData()
    polylines.SetPoints(points)
    polylines.SetLines(cells)
    tube = vtkTubeFilter()
    tube.SetInputData(polylines)
    tube.SetRadius(RADIUS)
    tube.SetNumberOfSides(sides)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(tube.GetOutputPort())
    triangles.Update()
    mesh = triangles.GetOutput()
    return StandIn("streamtubes", vertices(mesh), lambda p: np.abs(truth(p)), 2 * RADIUS * math.sin(math.pi / sides), mesh)
