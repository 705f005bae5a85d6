# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins for what CAD makes (standins.py): few and long triangles, and faces that have points of their own."""
import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import (
    vtkAdaptiveSubdivisionFilter, vtkLinearExtrusionFilter, vtkLinearSubdivisionFilter)
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkCubeSource, vtkCylinderSource

from meshes import with_normals
from standin import StandIn


def extruded(polygon, height, edge=1e9):
    """The triangles of a body with that outline, with edges no longer than that."""
    points = vtkPoints()
    for x, y in polygon:
        points.InsertNextPoint(x, y, 0)
    cells = vtkCellArray()
    cells.InsertNextCell(len(polygon), list(range(len(polygon))))
    flat = vtkPolyData()
    flat.SetPoints(points)
    flat.SetPolys(cells)
    extrusion = vtkLinearExtrusionFilter()
    extrusion.SetInputData(flat)
    extrusion.SetExtrusionTypeToVectorExtrusion()
    extrusion.SetVector(0, 0, height)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(extrusion.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    divided = vtkAdaptiveSubdivisionFilter()
    divided.SetInputConnection(clean.GetOutputPort())
    divided.SetMaximumEdgeLength(edge)
    divided.SetMaximumTriangleArea(1e9)
    return divided


def merged(mesh):
    """Its triangles, with one point in each place and no normals."""
    bare = vtkPolyData()
    bare.SetPoints(mesh.GetPoints())
    bare.SetPolys(mesh.GetPolys())
    clean = vtkCleanPolyData()
    clean.SetInputData(bare)
    clean.Update()
    return clean.GetOutput()


def body(name, source, divisions=0):
    """The source's surface, its triangles divided, split where they meet at more than 30 degrees. Its mesh is the truth."""
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    mesh = merged(triangles.GetOutput())
    if divisions:
        divided = vtkLinearSubdivisionFilter()
        divided.SetNumberOfSubdivisions(divisions)
        divided.SetInputData(mesh)
        divided.Update()
        mesh = divided.GetOutput()
    mesh = with_normals(mesh, splitting=True)
    return StandIn(name, mesh, None, mesh.GetLength() / math.sqrt(mesh.GetNumberOfPoints()), mesh)


def with_shared_points(standin):
    """Without normals, and with one point in each place."""
    return StandIn(standin.name + ", shared points", merged(standin.mesh), None, standin.spacing, standin.mesh)


def can(resolution=200, divisions=3):
    """The triangles of the ends meet in one point."""
    source = vtkCylinderSource()
    source.SetResolution(resolution)
    return body("can", source, divisions)


def slab(thickness=0.01):
    """Each face has two triangles, and four of them are a hundred times as long as they are wide."""
    source = vtkCubeSource()
    source.SetZLength(thickness)
    return body("slab", source)


def shaft(resolution=100, radius=0.03):
    """Triangles are five hundred times as long as they are wide."""
    source = vtkCylinderSource()
    source.SetResolution(resolution)
    source.SetRadius(radius)
    return body("shaft", source)


def arrow(resolution=24):
    """A shaft, and a cone whose tip is one point."""
    source = vtkArrowSource()
    source.SetTipResolution(resolution)
    source.SetShaftResolution(resolution)
    return body("arrow", source)


def cog(teeth=12, height=0.3):
    """Faces of its rim are two triangles wide and high, those of its ends a polygon's."""
    angles = 2 * np.pi * np.arange(4 * teeth) / (4 * teeth)
    radii = np.where(np.arange(4 * teeth) // 2 % 2 == 0, 1.0, 0.8)
    return body("cog", extruded(np.stack([radii * np.cos(angles), radii * np.sin(angles)], 1), height))
