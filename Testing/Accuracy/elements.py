# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts as programs that compute with finite elements mesh them: edges of one length, so that narrow faces have a row of
vertices between their edges, or none, and normals that are averages at all edges."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkDelaunay2D

from scenes import polydata


def circle(x, y, radius, spacing):
    """A hole's loop, clockwise, as points (n, 2)."""
    number = round(2 * math.pi * radius / spacing)
    angle = -2 * np.pi * np.arange(number) / number
    return np.stack([x + radius * np.cos(angle), y + radius * np.sin(angle)], 1)


def divided(corners, spacing):
    """The sides of a polygon, each as points from its first corner to its last."""
    sides = []
    for a, b in zip(corners, np.roll(corners, -1, 0)):
        number = max(1, round(np.linalg.norm(b - a) / spacing))
        sides.append(a + (b - a) * np.linspace(0, 1, number + 1)[:, None])
    return sides


def triangulated(plane, loops=()):
    """Triangles of points (n, 2), those inside of the loops of indices, if there are such, as indices (m, 3)."""
    data = polydata(np.c_[plane, np.zeros(len(plane))], None)
    delaunay = vtkDelaunay2D()
    delaunay.SetInputData(data)
    if loops:
        cells = vtkCellArray()
        for loop in loops:
            cells.InsertNextCell(len(loop), [int(i) for i in loop])
        border = vtkPolyData()
        border.SetPoints(data.GetPoints())
        border.SetPolys(cells)
        delaunay.SetSourceData(border)
    delaunay.Update()
    return vtk_to_numpy(delaunay.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)


def wall(columns, height, spacing):
    """The face over the points (n, 2) of a side: columns of vertices, every other one moved up by half of the way."""
    number = round(height / spacing)
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(columns, axis=0), axis=1))])
    plane, places = [], []
    for k, (s, column) in enumerate(zip(along, columns)):
        inner = k % 2 and k < len(columns) - 1
        steps = np.concatenate([[0], np.arange(number) + 0.5, [number]]) if inner else np.arange(number + 1.0)
        for z in steps * height / number:
            plane.append((s, z))
            places.append((*column, z))
    return polydata(places, None, triangulated(plane))


def lid(loops, z, spacing):
    """The flat face between loops (n, 2), the outer one first, with vertices in a triangular grid."""
    outline = np.concatenate(loops)
    low, high = outline.min(0), outline.max(0)
    grid = [(x + 0.5 * spacing * (row % 2), y)
            for row, y in enumerate(np.arange(low[1], high[1], spacing * math.sqrt(0.75)))
            for x in np.arange(low[0], high[0], spacing)]
    grid = np.array([p for p in grid if np.linalg.norm(outline - p, axis=1).min() > 0.7 * spacing])
    starts = np.cumsum([0] + [len(loop) for loop in loops])
    plane = np.concatenate([outline, grid])
    triangles = triangulated(plane, [np.arange(a, b) for a, b in zip(starts, starts[1:])])
    return polydata(np.c_[plane, np.full(len(plane), z)], None, triangles)


def ribbed_block(spacing, height=1.0):
    """What makes a block with ribs that are one, two and three edges wide, and holes of 3, 4 and 6 edges' radius."""
    corners = [(0.0, 0.0), (1.2, 0.0), (1.2, 0.35)]
    for number, x in ((3, 0.9), (2, 0.6), (1, 0.3)):
        width = number * spacing
        corners += [(x + width, 0.35), (x + width, 0.5), (x, 0.5), (x, 0.35)]
    sides = divided(np.array(corners + [(0.0, 0.35)]), spacing)
    holes = [circle(x, 0.17, number * spacing, spacing) for number, x in ((3, 0.2), (4, 0.5), (6, 0.9))]
    loops = [np.concatenate([side[:-1] for side in sides])] + holes
    append = vtkAppendPolyData()
    for side in sides:
        append.AddInputData(wall(side, height, spacing))
    for hole in holes:
        append.AddInputData(wall(np.r_[hole, hole[:1]], height, spacing))
    for z in (0.0, height):
        append.AddInputData(lid(loops, z, spacing))
    return joined(append, spacing)


def joined(append, spacing):
    clean = vtkCleanPolyData()
    clean.SetInputConnection(append.GetOutputPort())
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(0.01 * spacing)
    return clean


def graded_bar(spacing, ratio):
    """What makes a bar whose edges are ratio times as long in its midst as at its ends."""
    length, sizes = 3.0, (0.5, 0.4)
    rows = [0.0]
    while rows[-1] < length / 2:
        share = min(1.0, rows[-1] / (0.3 * length))
        rows.append(rows[-1] + spacing * (1 + (ratio - 1) * share ** 2))
    rows = np.array(rows) * (0.5 * length / rows[-1])
    rows = np.r_[rows, length - rows[-2::-1]]
    steps = np.gradient(rows)
    append = vtkAppendPolyData()
    for across, width in enumerate(sizes):
        plane = np.array([(x, y) for x, step in zip(rows, steps)
                          for y in np.linspace(0, width, 1 + max(2, round(width / step)))])
        triangles = triangulated(plane)
        for other in (0.0, sizes[1 - across]):
            places = np.insert(plane, 2 - across, other, 1)
            append.AddInputData(polydata(places, None, triangles))
    end = np.array([(y, z) for y, z in np.ndindex(*(1 + round(size / steps[0]) for size in sizes))], float)
    end *= np.array(sizes) / end.max(0)
    for x in (0.0, length):
        append.AddInputData(polydata(np.insert(end, 0, x, 1), None, triangulated(end)))
    return joined(append, spacing)
