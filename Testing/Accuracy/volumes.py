# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins that come as volumes (standins.py): vessels, what a volume cuts off, a ball with holes, a machined
part, thick slices."""
import functools
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkFlyingEdges3D
from vtkmodules.vtkImagingCore import vtkImageResample
import pointsplatting

from parametric import nearest
from reference.surfaces import unit
from scenes import polydata
from standin import StandIn, vertices


class Capsules:
    """Chains of round cones: the distance to their union, negative inside."""

    def __init__(self):
        self.segments = []  # a, b, radius at a, radius at b

    def add(self, line, radii):
        self.segments += [(line[i], line[i + 1], radii[i], radii[i + 1])
                          for i in range(len(line) - 1)]

    @staticmethod
    def to_one(p, a, b, ra, rb):
        along = b - a
        t = np.clip(((p - a) @ along) / max(along @ along, 1e-30), 0, 1)
        return np.linalg.norm(p - a - t[..., None] * along, axis=-1) - (ra + t * (rb - ra))

    @staticmethod
    def box(a, b, ra, rb, reach):
        wide = max(ra, rb) + reach
        return np.minimum(a, b) - wide, np.maximum(a, b) + wide

    def __call__(self, p, reach=3.0):
        """What is farther than reach is reach."""
        found = np.full(p.shape[:-1], reach)
        for segment in self.segments:
            low, high = self.box(*segment, reach)
            near = ((p > low) & (p < high)).all(-1)
            found[near] = np.minimum(found[near], self.to_one(p[near], *segment))
        return found

    def sampled(self, size, reach=3.0):
        """On a grid of unit spacing; what is farther than reach is reach."""
        field = np.full((size,) * 3, reach)  # z, y, x
        for segment in self.segments:
            low, high = self.box(*segment, reach)
            low = np.clip(np.floor(low).astype(int), 0, size)
            high = np.clip(np.ceil(high).astype(int) + 1, 0, size)
            x, y, z = (np.arange(low[k], high[k], dtype=float) for k in range(3))
            grid = np.stack(np.broadcast_arrays(x[None, None, :], y[None, :, None],
                                                z[:, None, None]), -1)
            box = tuple(slice(low[k], high[k]) for k in (2, 1, 0))
            field[box] = np.minimum(field[box], self.to_one(grid, *segment))
        return field


def vessels(size, tubes, specks, seed=3):
    """Tubes of 0.7 to 2 voxels' radius that wind through a volume, and specks of 3 to 30
    vertices."""
    rng = np.random.default_rng(seed)
    made = Capsules()
    for k in range(tubes):
        place, heading = rng.uniform(0.2, 0.8, 3) * size, unit(rng.normal(size=3))
        radius = 0.7 + 1.3 * k / max(1, tubes - 1)
        line = []
        while len(line) < 60 and (place > 4).all() and (place < size - 5).all():
            line.append(place)
            heading = unit(heading + 0.35 * rng.normal(size=3))
            place = place + 2.0 * heading
        made.add(line, np.full(len(line), radius))
    for _ in range(specks):
        place = rng.uniform(4, size - 5, 3)
        made.add([place, place + rng.uniform(0, 0.5, 3)], np.full(2, rng.uniform(0.55, 1.1)))
    return made


def image_of(field, spacing=(1, 1, 1)):
    image = vtkImageData()
    image.SetDimensions(*reversed(field.shape))
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(field.astype(np.float32).ravel(), deep=1))
    return image


def isosurface(field, extraction, finer=1):
    """extraction: "points", "edges" or "contour"; finer: so many times, between linearly."""
    filters = {"points": pointsplatting.vtkIsosurfacePoints, "edges": vtkFlyingEdges3D,
               "contour": vtkContourFilter}
    contour = filters[extraction]()
    resample = vtkImageResample()
    resample.SetInputData(image_of(-field))  # denser inside, as an angiogram is
    resample.SetMagnificationFactors(finer, finer, finer)
    contour.SetInputConnection(resample.GetOutputPort())
    contour.SetValue(0, 0.0)
    if extraction != "points":
        contour.ComputeNormalsOn()
        contour.ComputeScalarsOff()
    contour.Update()
    return contour.GetOutput()


def sampled(field, size):
    """A field's values on a grid of unit spacing: z, y, x."""
    z, y, x = np.meshgrid(*3 * [np.arange(size, dtype=float)], indexing="ij")
    return field(np.stack([x, y, z], -1))


def to_level(field):
    """About the distance to where a field is 0, by its slope."""
    def distance(p):
        slope = np.stack([field(p + d) - field(p - d) for d in 1e-3 * np.eye(3)], -1) / 2e-3
        return np.abs(field(p)) / np.maximum(np.linalg.norm(slope, axis=-1), 1e-3)
    return distance


def tubes_and_specks(extraction="edges", size=80, tubes=10, specks=250):
    body = vessels(size, tubes, specks)
    field = body.sampled(size)
    mesh = isosurface(field, "edges" if extraction == "points" else extraction)
    cloud = isosurface(field, extraction) if extraction == "points" else vertices(mesh)
    return StandIn("tubes and specks, " + extraction, cloud, lambda p: np.abs(body(p)), 0.7, mesh,
                   lambda: isosurface(field, "edges", 4))


def noisy_vessels(noise=0.3):
    """Of an angiogram as scanners give it: the same tubes, by a volume with noise, in voxels of its surface's place. Its own
    isosurface is the truth."""
    body = vessels(80, 10, 0)
    field = body.sampled(80) + np.random.default_rng(12).normal(0, noise, (80,) * 3)
    mesh = isosurface(field, "edges")
    return StandIn("noisy vessels", vertices(mesh), lambda p: np.abs(body(p)), 0.7, mesh)


def segmented_vessels(labels=1):
    """The tubes and specks as a segmentation gives them: a volume of 0 and, inside, of as many labels from 1 on, in blocks
    of 8 voxels a side. One's surface lies in the middle between samples, that of all of many next to samples, where up to
    six of its vertices are nearly in one place. Its own isosurface is the truth."""
    body = vessels(80, 10, 250)
    blocks = np.random.default_rng(14).integers(1, labels + 1, (10,) * 3)
    for axis in range(3):
        blocks = np.repeat(blocks, 8, axis)
    mesh = isosurface(np.where(body.sampled(80) < 0, 0.5 - blocks, 0.5), "edges")
    return StandIn("segmented vessels, %d" % labels, vertices(mesh), lambda p: np.abs(body(p)), 0.7, mesh)


def cut_by_volume(extraction="points", size=64, noise=0.0):
    """A surface with a thousand spacings of border, where the volume cuts it (a gyroid). noise: of the volume, whose
    slope is 0.4 a voxel; its own isosurface is the truth."""
    k = 2 * math.pi / 24

    def field(p):
        x, y, z = k * p[..., 0], k * p[..., 1], k * p[..., 2]
        return np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
    values = sampled(field, size) + np.random.default_rng(13).normal(0, noise, (size,) * 3)
    mesh = isosurface(values, "edges")
    cloud = isosurface(values, "points") if extraction == "points" else vertices(mesh)
    return StandIn("cut by its volume, " + extraction, cloud, lambda p: np.abs(field(p)) / k, 0.7, mesh)


def holed_ball(size=72):
    """A ball's mesh as an extraction of isosurfaces leaves it, triangles taken out: holes with ragged
    borders, of a few spacings and more."""
    body = Capsules()
    centre = np.full(3, 0.5 * size - 0.3)
    body.add([centre, centre], np.full(2, 0.42 * size))
    mesh = isosurface(body.sampled(size), "edges")
    p = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    def is_cut(q):
        x, y, z = (0.22 * (q - centre)).T
        return np.sin(x + 0.4) * np.sin(y + 1) * np.sin(z + 2) > 0.45
    triangles = triangles[~is_cut(p[triangles].mean(1))]
    used, triangles = np.unique(triangles, return_inverse=True)
    normals = vtk_to_numpy(mesh.GetPointData().GetNormals())
    mesh = polydata(p[used], normals[used], triangles.reshape(-1, 3))

    find = nearest(p[used], normals[used])

    def distance(q):
        # Past the border, as far as the nearest vertex.
        far = np.linalg.norm(q - find(q)[0], axis=1)
        return np.where(far < 1, np.abs(body(q)), far)
    return StandIn("holed ball", vertices(mesh), distance, 0.7, mesh)


@functools.lru_cache(1)
def gear_field(size):
    """The gear's distances, as a function of places and sampled."""
    half = (size - 1) / 2

    def field(p):
        x, y, z = ((p[..., k] - half) / half for k in range(3))
        r, angle = np.hypot(x, y), np.arctan2(y, x)
        teeth = r - 0.749 - 0.1 * np.clip(4 * np.cos(14 * angle), -1, 1)
        bores = [0.119 - np.hypot(x - 0.45 * math.cos(a), y - 0.45 * math.sin(a))
                 for a in np.arange(6) * math.pi / 3]
        return np.maximum.reduce([teeth, np.abs(z) - 0.199, 0.181 - r, *bores])
    return field, sampled(field, size)


def gear(extraction="edges", size=128):
    """A machined part as a volume of distances gives it: the faces of its teeth bend, and points near their edges have
    normals of both faces, by the field's differences. extraction: as of isosurface()."""
    field, values = gear_field(size)
    mesh = isosurface(values, "edges")
    cloud = vertices(mesh) if extraction == "edges" else isosurface(values, extraction)
    return StandIn("gear " + extraction, cloud, to_level(field), 0.7, mesh)


def thick_slices(ratio=4, size=72):
    """The mesh of a scanner's volume whose slices are ratio times as far apart as its voxels: round
    bodies that overlap above a wavy sheet, which the volume cuts off. It has points along rows, whose normals turn by up
    to a right angle from one row to the next."""
    rng = np.random.default_rng(5)
    centres = (rng.uniform(0.2, 0.8, (24, 3)) * (1, 1, 0.4) + (0, 0, 0.4)) * size
    widths = rng.uniform(2.5, 4.5, 24)

    def field(p):
        bodies = sum(np.exp(-((p - c) ** 2).sum(-1) / (2 * w * w)) for c, w in zip(centres, widths))
        x, y, z = p[..., 0], p[..., 1], p[..., 2]
        sheet = 0.17 * size + 6 * np.sin(0.2 * x) * np.cos(0.17 * y) + np.sin(0.6 * x + 0.3 * y) - z
        return np.maximum(bodies - 0.5, sheet / 8)
    x, y, z = np.meshgrid(np.arange(0, size + 1, ratio), *2 * [np.arange(size + 1)], indexing="ij")
    values = field(np.stack([x, y, z], -1).astype(float)).transpose(2, 1, 0)
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image_of(values, (ratio, 1, 1)))
    contour.SetValue(0, 0.0)
    contour.ComputeScalarsOff()
    contour.Update()
    mesh = contour.GetOutput()
    return StandIn("thick slices", vertices(mesh), to_level(field), 1.0, mesh)
