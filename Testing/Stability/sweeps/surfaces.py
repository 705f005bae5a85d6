# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed forms: fine meshes of them, and points drawn from them by equal areas."""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFlyingEdges3D, vtkReverseSense
from vtkmodules.vtkFiltersSources import (
    vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource)

CLAY, RED, BLUE = (0.9, 0.6, 0.4), (0.9, 0.2, 0.2), (0.2, 0.2, 0.9)


class Surface:
    """mesh: vtkPolyData with normals; draw(n, rng): about n points and their normals."""

    def __init__(self, mesh, draw, colour=CLAY, opacity=1.0):
        self.mesh, self.draw, self.colour, self.opacity = mesh, draw, colour, opacity


def random(seed=5):
    return np.random.default_rng(seed)


def cloud(points, normals, colours=None):
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=1))
    data.SetPoints(coordinates)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals, dtype=np.float32), deep=1)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    return data


def sphere_points(n, rng):
    z = rng.uniform(-1, 1, n)
    a = rng.uniform(0, 2 * math.pi, n)
    r = np.sqrt(1 - z * z)
    p = np.stack([r * np.cos(a), r * np.sin(a), z], 1)
    return p, p.copy()


def sphere_mesh(radius=1.0, centre=(0, 0, 0)):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(*centre)
    source.SetThetaResolution(360)
    source.SetPhiResolution(180)
    source.Update()
    return source.GetOutput()


def sphere(radius=1.0, centre=(0, 0, 0), colour=CLAY, opacity=1.0):
    def draw(n, rng):
        p, m = sphere_points(n, rng)
        return radius * p + centre, m
    return Surface(sphere_mesh(radius, centre), draw, colour, opacity)


def torus(radius=0.7, tube=0.3):
    function = vtkParametricTorus()
    function.SetRingRadius(radius)
    function.SetCrossSectionRadius(tube)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(400)
    source.SetVResolution(200)
    source.SetScalarModeToNone()
    source.Update()

    def draw(n, rng):
        v = rng.uniform(0, 2 * math.pi, 3 * n + 100)
        keep = rng.uniform(0, radius + tube, len(v)) < (radius + tube * np.cos(v))
        v = v[keep][:n]
        u = rng.uniform(0, 2 * math.pi, len(v))
        ring = radius + tube * np.cos(v)
        p = np.stack([ring * np.cos(u), ring * np.sin(u), tube * np.sin(v)], 1)
        m = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
        return p, m
    return Surface(source.GetOutput(), draw)


def jittered(n, rng):
    """Points at random within the cells of a grid of -1 to 1, so that there are no gaps."""
    side = int(math.sqrt(n))
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    x = 2 * (x.ravel() + rng.uniform(0, 1, side * side)) / side - 1
    y = 2 * (y.ravel() + rng.uniform(0, 1, side * side)) / side - 1
    return x, y


def ball_in_volume(sigma, size=48):
    """The isosurface of a ball's distances, with noise of so many voxels."""
    half = 0.5 * (size - 1)
    z, y, x = np.meshgrid(*3 * [np.arange(size) - half], indexing="ij")
    values = 0.83 * half - np.sqrt(x * x + y * y + z * z) + random(14).normal(0, sigma, (size,) * 3)
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetSpacing(*3 * [1 / half])
    image.SetOrigin(-1, -1, -1)
    image.GetPointData().SetScalars(numpy_to_vtk(values.astype(np.float32).ravel(), deep=1))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeScalarsOff()
    contour.Update()
    return Surface(contour.GetOutput(), None)


def plane(corner, first, second):
    source = vtkPlaneSource()
    source.SetOrigin(*corner)
    source.SetPoint1(*first)
    source.SetPoint2(*second)
    source.Update()
    return source.GetOutput()


def plate(z=0.0, colour=CLAY, opacity=1.0, turn=None):
    """z: its height; turn: a matrix that turns it then."""
    turn = np.eye(3) if turn is None else turn
    mesh = plane(*(turn @ (x, y, z) for x, y in ((-1, -1), (1, -1), (-1, 1))))

    def draw(n, rng):
        x, y = jittered(n, rng)
        points = np.stack([x, y, np.full(len(x), z)], 1)
        return points @ turn.T, np.tile(turn @ (0.0, 0.0, 1.0), (len(x), 1))
    return Surface(mesh, draw, colour, opacity)


def box(half, colour=CLAY):
    """half: its half sides. Points by area, on each face for itself, so that edges are sharp."""
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (1, -1):
            centre, first, second = np.zeros(3), np.zeros(3), np.zeros(3)
            centre[axis] = side * half[axis]
            first[u], second[v] = side * half[u], half[v]
            faces.append((centre, first, second, 4 * half[u] * half[v]))
    append = vtkAppendPolyData()
    for centre, first, second, _ in faces:
        append.AddInputData(plane(centre - first - second, centre + first - second,
                                  centre - first + second))
    append.Update()
    total = sum(area for *_, area in faces)

    def draw(n, rng):
        p, m = [], []
        for centre, first, second, area in faces:
            # As many rows and columns as make square cells, and one at least.
            step = math.sqrt(total / n)
            columns, rows = (max(1, round(2 * np.linalg.norm(e) / step)) for e in (first, second))
            i, j = (k.ravel() for k in np.meshgrid(np.arange(columns), np.arange(rows)))
            s = 2 * (i + rng.uniform(0, 1, len(i))) / columns - 1
            t = 2 * (j + rng.uniform(0, 1, len(j))) / rows - 1
            p.append(centre + s[:, None] * first + t[:, None] * second)
            m.append(np.tile(np.cross(first, second), (len(i), 1)))
        m = np.concatenate(m)
        return np.concatenate(p), m / np.linalg.norm(m, axis=1, keepdims=True)
    return Surface(append.GetOutput(), draw, colour)


def ellipsoid(axes, colour=CLAY, opacity=1.0, inward=False):
    """inward: its normals point to its middle, as those of a cavity in a body do."""
    axes = np.asarray(axes, float)
    side = -1 if inward else 1

    def normals(p):
        m = side * p / axes ** 2
        return m / np.linalg.norm(m, axis=1, keepdims=True)

    mesh = vtkPolyData()
    mesh.DeepCopy(sphere_mesh())
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points *= axes.astype(points.dtype)
    vtk_to_numpy(mesh.GetPointData().GetNormals())[:] = normals(points)
    if inward:
        reverse = vtkReverseSense()
        reverse.SetInputData(mesh)
        reverse.Update()
        mesh = reverse.GetOutput()

    def draw(n, rng):
        p, _ = sphere_points(3 * n + 100, rng)
        stretch = np.linalg.norm(p / axes, axis=1)
        p = p[rng.uniform(0, 1, len(p)) * stretch.max() < stretch][:n] * axes
        return p, normals(p)
    return Surface(mesh, draw, colour, opacity)


def spacing(n):
    """Of n points on the unit sphere."""
    return math.sqrt(4 * math.pi / n)
