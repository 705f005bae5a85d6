# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds in the place of the papers' scans and volumes, made of formulas, and clouds of files."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataNormals
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
import pointsplatting

from reference.surfaces import unit
from scenes import grid_triangles, polydata, sphere_mesh

READERS = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader, ".vtk": vtkPolyDataReader,
           ".obj": vtkOBJReader, ".stl": vtkSTLReader}
GOLDEN = 0.5 * (np.sqrt(5) - 1)


def coloured(data, colours):
    """With colours, 0 to 1, as scalars."""
    values = numpy_to_vtk(np.round(255 * np.clip(colours, 0, 1)).astype(np.uint8), deep=1)
    values.SetName("colour")
    data.GetPointData().SetScalars(values)
    return data


def splats(data):
    """With the sizes that the mapper would estimate."""
    estimation = pointsplatting.vtkPointSplatEstimation()
    estimation.SetInputData(data)
    estimation.Update()
    return estimation.GetOutput()


def vertices(mesh):
    """A mesh's points, normals and scalars without its triangles, with sizes."""
    data = vtkPolyData()
    data.SetPoints(mesh.GetPoints())
    data.GetPointData().SetNormals(mesh.GetPointData().GetNormals())
    data.GetPointData().SetScalars(mesh.GetPointData().GetScalars())
    return splats(data)


def radius_of(d):
    """Of a star-shaped body with lobes and wrinkles, towards unit vectors d."""
    x, y, z = d[..., 0], d[..., 1], d[..., 2]
    return (1 + 0.18 * np.sin(3 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(5 * z - 2 * x)
            + 0.025 * np.sin(19 * x) * np.sin(17 * y) * np.sin(18 * z))


def body_mesh(count):
    """A scanned model's stand-in: smooth lobes, wrinkles, and a texture of veins and squares."""
    ball = sphere_mesh(count, 1.0)
    directions = vtk_to_numpy(ball.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(ball.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    # Not on a grid, as a scan's points are not.
    shift = np.random.default_rng(3).uniform(-0.25, 0.25, directions.shape)
    directions = unit(directions + np.sqrt(4 * np.pi / len(directions)) * shift)
    points = directions * radius_of(directions)[:, None]
    step = 1e-5
    level = np.stack([np.linalg.norm(points + e, axis=1) - radius_of(unit(points + e))
                      - np.linalg.norm(points - e, axis=1) + radius_of(unit(points - e))
                      for e in step * np.eye(3)], 1)
    x, y, z = points.T
    veins = 0.5 + 0.5 * np.sin(14 * y + 5 * np.sin(6 * x) + 4 * np.sin(7 * z))
    squares = np.floor(6 * x + 100) + np.floor(6 * y + 100) + np.floor(6 * z + 100)
    shade = np.where(squares % 2, 0.95, 0.55)[:, None]
    colours = shade * (veins[:, None] * (1.0, 0.85, 0.6) + (1 - veins)[:, None] * (0.5, 0.25, 0.2))
    return coloured(polydata(points, unit(level), triangles), colours)


def board(n, field, extent=1.0):
    """n x n points of a chequered plane z = 0 of -extent to extent, and the width of its fields."""
    axis = extent * ((np.arange(n) + 0.5) * 2 / n - 1)
    x, y = np.meshgrid(axis, axis)
    points = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
    grey = board_colour(points[:, 0], points[:, 1], field)
    data = polydata(points, np.tile((0.0, 0.0, 1.0), (n * n, 1)),
                    grid_triangles(n - 1, n - 1, np.arange(n * n).reshape(n, n)))
    return coloured(data, np.repeat(grey[:, None], 3, 1))


def board_colour(x, y, field):
    return np.where((np.floor(x / field) + np.floor(y / field)) % 2 == 0, 0.92, 0.12)


def torus(count, minor):
    """Evenly spread points, with radii as estimation gives them there: 0.75 spacings."""
    i = np.arange(count)
    u, v = 2 * np.pi * i / count, 2 * np.pi * np.modf(i * GOLDEN)[0]
    normal = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
    data = polydata(np.stack([np.cos(u), np.sin(u), 0 * u], 1) + minor * normal, normal)
    radius = 0.75 * np.sqrt(4 * np.pi ** 2 * minor / count)
    radii = numpy_to_vtk(np.full(count, radius, np.float32), deep=1)
    radii.SetName("SplatRadius")
    data.GetPointData().AddArray(radii)
    return data


def charges_mesh(count):
    """An isosurface of Gaussian clouds at random places: many components, as Neghip's has."""
    random = np.random.default_rng(1)
    atoms = [(random.uniform(-0.8, 0.8, 3), random.uniform(0.06, 0.16)) for _ in range(60)]

    def contour(n):
        axis = np.linspace(-1, 1, n)
        field = np.zeros((n, n, n))
        for centre, width in atoms:
            x, y, z = (np.exp(-(axis - c) ** 2 / (2 * width ** 2)) for c in centre)
            field += z[:, None, None] * y[:, None] * x
        image = vtkImageData()
        image.SetDimensions(n, n, n)
        image.SetOrigin(-1, -1, -1)
        image.SetSpacing(3 * [2 / (n - 1)])
        image.GetPointData().SetScalars(numpy_to_vtk(field.astype(np.float32).ravel(), deep=1))
        surface = vtkFlyingEdges3D()
        surface.SetInputData(image)
        surface.SetValue(0, 0.6)
        surface.ComputeNormalsOn()
        surface.ComputeScalarsOff()
        surface.Update()
        return surface.GetOutput()
    first = contour(48)
    return contour(max(24, round(48 * np.sqrt(count / first.GetNumberOfPoints()))))


def read(name):
    """A file's points, with normals; of meshes their vertices."""
    reader = READERS[os.path.splitext(name)[1].lower()]()
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput()
    if not data.GetNumberOfPoints():
        raise SystemExit(f"{name}: no points")
    if not data.GetPointData().GetNormals() and data.GetNumberOfPolys():
        normals = vtkPolyDataNormals()
        normals.SplittingOff()
        normals.SetInputData(data)
        normals.Update()
        data = normals.GetOutput()
    return vertices(data)
