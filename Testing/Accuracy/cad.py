# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins for what CAD makes (standins.py): few and long triangles, and faces that have points of their own."""
import math

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter, vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkCubeSource, vtkCylinderSource

from standin import StandIn


def body(name, source, divisions=0):
    """The source's surface, its triangles divided, split where they meet at more than 30 degrees. Its mesh is the truth."""
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    bare = vtkPolyData()
    bare.SetPoints(triangles.GetOutput().GetPoints())
    bare.SetPolys(triangles.GetOutput().GetPolys())
    merged = vtkCleanPolyData()
    merged.SetInputData(bare)
    divided = vtkLinearSubdivisionFilter()
    divided.SetNumberOfSubdivisions(divisions)
    divided.SetInputConnection(merged.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection((divided if divisions else merged).GetOutputPort())
    normals.Update()
    mesh = normals.GetOutput()
    return StandIn(name, mesh, None, mesh.GetLength() / math.sqrt(mesh.GetNumberOfPoints()), mesh)


def with_shared_points(standin):
    """Without normals, and with one point in each place."""
    bare = vtkPolyData()
    bare.SetPoints(standin.mesh.GetPoints())
    bare.SetPolys(standin.mesh.GetPolys())
    merged = vtkCleanPolyData()
    merged.SetInputData(bare)
    merged.Update()
    return StandIn(standin.name + ", shared points", merged.GetOutput(), None, standin.spacing, standin.mesh)


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
    points, outline = vtkPoints(), vtkCellArray()
    outline.InsertNextCell(4 * teeth)
    for k in range(4 * teeth):
        radius, angle = 1.0 if k // 2 % 2 == 0 else 0.8, 2 * math.pi * k / (4 * teeth)
        outline.InsertCellPoint(points.InsertNextPoint(radius * math.cos(angle), radius * math.sin(angle), 0))
    polygon = vtkPolyData()
    polygon.SetPoints(points)
    polygon.SetPolys(outline)
    source = vtkLinearExtrusionFilter()
    source.SetInputData(polygon)
    source.SetExtrusionTypeToNormalExtrusion()
    source.SetVector(0, 0, 1)
    source.SetScaleFactor(height)
    return body("cog", source)
