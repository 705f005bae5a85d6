# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins for what CAD makes (standins.py): few and long triangles, and faces that have points of their own."""
import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkCleanPolyData, vtkReverseSense, vtkTriangleFilter, vtkTubeFilter)
from vtkmodules.vtkFiltersModeling import (
    vtkAdaptiveSubdivisionFilter, vtkLinearExtrusionFilter, vtkLinearSubdivisionFilter)
from vtkmodules.vtkFiltersSources import (
    vtkArrowSource, vtkCubeSource, vtkCylinderSource, vtkLineSource, vtkSphereSource)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

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


def split(name, mesh):
    """A stand-in whose truth is the mesh, split where its triangles meet at more than 30 degrees."""
    mesh = with_normals(mesh, splitting=True)
    return StandIn(name, mesh, None, mesh.GetLength() / math.sqrt(mesh.GetNumberOfPoints()), mesh)


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
    return split(name, mesh)


def dome():
    """One flat face, and a surface that is nowhere flat all around that: few of its edges are flat."""
    source = vtkSphereSource()
    source.SetThetaResolution(48)
    source.SetPhiResolution(32)
    source.Update()
    mesh = source.GetOutput()
    places = vtk_to_numpy(mesh.GetPoints().GetData()).copy()
    places *= 1 + 0.001 * np.sin(37.0 * np.arange(len(places)))[:, None]
    places[:, 2] = np.maximum(3 * places[:, 2], -1.3)
    mesh.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    return with_shared_points(split("dome", merged(mesh)))


def wire(radius=0.03, sides=5):
    """Triangles of a thin tube are ten times as long as they are wide, and there once for each side."""
    angles = np.linspace(0, 2.5, 9)
    points = vtkPoints()
    for angle in angles:
        points.InsertNextPoint(math.cos(angle), math.sin(angle), 0)
    line = vtkLineSource()
    line.SetPoints(points)
    tube = vtkTubeFilter()
    tube.SetInputConnection(line.GetOutputPort())
    tube.SetRadius(radius)
    tube.SetNumberOfSides(sides)
    tube.CappingOn()
    found = body("wire", tube)
    back = vtkReverseSense()
    back.SetInputData(found.mesh)
    both = vtkAppendPolyData()
    both.AddInputData(found.mesh)
    both.AddInputConnection(back.GetOutputPort())
    both.Update()
    return StandIn("wire", merged(both.GetOutput()), None, found.spacing, found.mesh)


def plate(thickness=0.1, bevels=6):
    """Flat faces are a triangle wide, and so is each step of the round ones between them."""
    angles = np.pi / 2 * np.arange(bevels + 1) / bevels
    corner = np.stack([np.sin(angles), np.cos(angles)], 1) * thickness
    sides = [corner * (1, 1) + (1, 0), corner[::-1] * (1, -1) + (1, 0), corner * (-1, -1) + (-1, 0),
             corner[::-1] * (-1, 1) + (-1, 0)]
    return with_shared_points(body("plate", extruded(np.concatenate(sides), 1.5)))


def with_shared_points(standin):
    """Without normals, and with one point in each place."""
    return StandIn(standin.name + ", shared points", merged(standin.mesh), None, standin.spacing, standin.mesh)


def with_means(standin):
    """With one point in each place, and normals that are means over edges, with which the truth is shaded, too."""
    mesh = with_normals(merged(standin.mesh), splitting=False)
    return StandIn(standin.name + ", means", mesh, None, standin.spacing, mesh)


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


def lens():
    """Two caps, which are nowhere flat, and an edge between them that is no bend."""
    source = vtkSphereSource()
    source.SetThetaResolution(48)
    source.SetPhiResolution(33)  # a ring of points lies half way between the poles
    source.Update()
    mesh = source.GetOutput()
    x, y, z = (2 * vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)).T
    rim = np.abs(z) < 1e-6
    z = np.where(rim, 0, np.sign(z)) * (np.sqrt(np.maximum(2 - x * x - y * y, 1)) - 1)
    z += 0.0002 * np.sin(37.0 * np.arange(len(z)))
    mesh.GetPoints().SetData(numpy_to_vtk(np.stack([x, y, z], 1), deep=True))
    return with_shared_points(split("lens", merged(mesh)))


def channel(wall=0.04):
    """Bent sheet metal: walls that are thin beside the two triangles of each face."""
    side, floor = 0.5, -0.3
    profile = [(-side, side), (-side + wall, side), (-side + wall, floor + wall), (side - wall, floor + wall),
               (side - wall, side), (side, side), (side, floor), (-side, floor)]
    return with_shared_points(body("channel", extruded(profile[::-1], 2.0)))


def ledge(steps=6):
    """A bar whose flat face is three narrow and long triangles wide, beside one that is round."""
    angles = np.pi / 2 * np.arange(steps + 1) / steps
    profile = [(0, -0.6), (0, 0), (0.1, 0), (0.2, 0)]
    profile += list(zip(0.3 + 0.3 * np.sin(angles), 0.3 * np.cos(angles) - 0.3)) + [(0.6, -0.6)]
    return with_shared_points(body("ledge", extruded(profile[::-1], 4.0)))
