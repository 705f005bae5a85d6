# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that two parameters run over: their meshes, points of theirs, and how far places are from
them."""
import functools

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersPoints import vtkPointInterpolator, vtkVoronoiKernel

from reference.surfaces import unit
from scenes import grid_triangles, polydata


def parametric(function, columns, rows, u_range, v_range, closed=True):
    """A mesh of function(u, v) (points, last axis 3), its normals by differences; u closed."""
    u = np.linspace(*u_range, columns + 1)
    v = np.linspace(*v_range, rows + 1)
    u, v = np.meshgrid(u[:-1] if closed else u, v)
    points, normals = function(u, v), normals_of(function, u, v)
    numbers = np.arange(u.size).reshape(u.shape)
    if closed:
        numbers = np.pad(numbers, ((0, 0), (0, 1)), mode="wrap")
    return polydata(points.reshape(-1, 3), normals.reshape(-1, 3),
                    grid_triangles(columns, rows, numbers))


def normals_of(function, u, v, step=1e-5):
    du = function(u + step, v) - function(u - step, v)
    dv = function(u, v + step) - function(u, v - step)
    return unit(np.cross(du, dv))


def random_of(function, u_range, v_range, count, rng):
    """Points by equal areas."""
    many = 4 * count
    u, v = rng.uniform(*u_range, many), rng.uniform(*v_range, many)
    du = (function(u + 1e-5, v) - function(u - 1e-5, v)) / 2e-5
    dv = (function(u, v + 1e-5) - function(u, v - 1e-5)) / 2e-5
    area = np.linalg.norm(np.cross(du, dv), axis=1)
    pick = rng.choice(many, count, replace=False, p=area / area.sum())
    return u[pick], v[pick]


def to_parametric(function, u_range, v_range):
    """The distance to such a surface, whose many points are made when it is first asked for."""
    @functools.lru_cache
    def find():
        u, v = np.meshgrid(np.linspace(*u_range, 1501), np.linspace(*v_range, 1001))
        return to_points(function(u, v).reshape(-1, 3), normals_of(function, u, v).reshape(-1, 3))
    return lambda p: find()(p)


def to_points(points, normals):
    """The distance to a surface by many of its points: to the plane at the nearest one."""
    find = nearest(points, normals)

    def distance(p):
        q, n = find(p)
        far = np.linalg.norm(p - q, axis=1)
        return np.where(far < 0.05, np.abs(((p - q) * n).sum(1)), far)
    return distance


def nearest(points, normals):
    """What finds for places the nearest of these points, and its normal."""
    source = polydata(points, normals)

    def find(places):
        probe = vtkPointInterpolator()
        probe.SetSourceData(source)
        probe.SetInputData(polydata(places, None))
        probe.SetKernel(vtkVoronoiKernel())
        probe.PassPointArraysOff()
        probe.Update()
        found = probe.GetOutput().GetPointData()
        return (vtk_to_numpy(found.GetArray("Position")).astype(float),
                vtk_to_numpy(found.GetArray("Normals")).astype(float))
    for data, name in ((source.GetPoints().GetData(), "Position"),
                       (source.GetPointData().GetNormals(), "Normals")):
        data.SetName(name)
        source.GetPointData().AddArray(data)
    return find
