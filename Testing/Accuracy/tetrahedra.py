# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins that come from solvers' grids of tetrahedra (standins.py): an isosurface that ends where the grid does, and what is
left of a body that was clipped. Their vertices lie on the tetrahedra's edges, some together where these meet, others three
spacings apart."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkContourGrid, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

from standin import StandIn, vertices
from volumes import to_level

LEVEL = 0.1
SPLIT = 40  # degrees between faces from which on their vertices are there twice


def gyroid(p):
    x, y, z = (3.2 * np.pi * p[..., k] for k in range(3))
    return np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)


def grid(size, seed=5):
    """Tetrahedra of the unit cube, whose inner points are moved by up to a third of the way to the next."""
    steps = np.arange(size)
    z, y, x = np.meshgrid(steps, steps, steps, indexing="ij")
    index = np.stack([x, y, z], -1).reshape(-1, 3)
    moved = np.random.default_rng(seed).uniform(-0.3, 0.3, index.shape)
    moved[(index == 0) | (index == size - 1)] = 0  # along the cube's faces alone
    places = ((index + moved) / (size - 1)).astype(np.float32)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=1))
    hexahedra = vtkStructuredGrid()
    hexahedra.SetDimensions(size, size, size)
    hexahedra.SetPoints(points)
    hexahedra.GetPointData().SetScalars(
        numpy_to_vtk(gyroid(places.astype(float)).astype(np.float32), deep=1))
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(hexahedra)
    divide.Update()
    return divide.GetOutput()


def with_normals(surface, splitting):
    """Triangles whose vertices are there once, or at sharp edges once for each face."""
    data = surface
    for step in (vtkCleanPolyData(), vtkTriangleFilter(), vtkPolyDataNormals()):
        step.SetInputData(data)
        if isinstance(step, vtkPolyDataNormals):
            step.SetSplitting(splitting)
            step.SetFeatureAngle(SPLIT)
        step.Update()
        data = step.GetOutput()
    return data


def contoured(size=32):
    """An isosurface, with a border at the cube's faces."""
    contour = vtkContourGrid()
    contour.SetInputData(grid(size))
    contour.SetValue(0, LEVEL)
    contour.Update()
    mesh = with_normals(contour.GetOutput(), False)
    return StandIn("isosurface of tetrahedra", vertices(mesh), to_level(lambda p: gyroid(p) - LEVEL), 0.7 / size, mesh)


def clipped(size=32, splitting=True):
    """The surface of what has larger values: that isosurface, and parts of the cube's faces. splitting: whether vertices at its
    edges have normals of one face, or means."""
    clip = vtkClipDataSet()
    clip.SetInputData(grid(size))
    clip.SetValue(LEVEL)
    clip.Update()
    surface = vtkGeometryFilter()
    surface.SetInputData(clip.GetOutput())
    surface.Update()

    def body(p):
        return np.maximum(np.abs(p - 0.5).max(-1) - 0.5, LEVEL - gyroid(p))
    mesh = with_normals(surface.GetOutput(), splitting)
    return StandIn("clipped tetrahedra", vertices(mesh), to_level(body), 0.7 / size, mesh)
