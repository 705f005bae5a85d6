#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points projected as single pixels: table 3 of Dobrev, Rosenthal and Linsen 2010 (An image-space
approach to interactive point cloud rendering including shadows and transparency), made anew.

  image_space_benchmark.py [FILE ...] [--points N] [--size PIXELS ...] [--runs N] [--quick]

Frames a second of Method ImageSpace, and in brackets their ratio to local illumination: with 3 and
6 translucent layers, and with shadows of 1, 5 and 10 samples, whose texture is made anew in each
frame, since the light moves. Holes are filled as often as the points need it, once in the paper.
Beside them, lit only: points of one pixel by stock VTK, and splats of two passes. All are taken in
turn, a frame to get used to and one that counts, medians of the latter.
Scenes: three nested tori of N points each, 2 M by default; a field like Neghip and hydrogen's
orbital, with the paper's numbers of points or as many of them as N is of 2 M; and files of points
or meshes (.ply .vtp .vtk .obj .stl). The paper's figures, on a GeForce GTX 260, follow after a bar.
"""
import argparse
import math
import os
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import pointsplatting

arguments = argparse.ArgumentParser(
    description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("files", nargs="*")
arguments.add_argument("--points", type=int, default=2000000)
arguments.add_argument("--size", type=int, nargs="+", default=[512, 1024])
arguments.add_argument("--runs", type=int, default=5)
arguments.add_argument("--quick", action="store_true", help="few points, small pictures, one run")
options = arguments.parse_args()
if options.quick:
    options.points, options.size, options.runs = min(options.points, 50000), [256], 1

COLOURS = ((0.35, 0.55, 0.95), (0.35, 0.8, 0.4), (0.85, 0.55, 0.3))
OPACITY = 0.4  # light is left behind six layers, so that all of them are made
READERS = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader, ".vtk": vtkPolyDataReader,
           ".obj": vtkOBJReader, ".stl": vtkSTLReader}
# Rows as in METHODS, each at 512 and 1024 pixels.
PAPER = {
    "Blade": ("883k", (52, 52), (17.6, 17.5), (8.8, 8.8), (26, 25), (9, 9), (5, 5)),
    "Happy Buddha": ("543k", (83, 64), (28, 22), (14, 11), (40, 39), (14, 14), (7, 7)),
    "Dragon": ("437k", (103, 68), (35, 23), (18, 12), (50, 49), (18, 17), (9.6, 9)),
    "3 nested tori": ("3 x 2M", (8, 8), (2.7, 2.7), (1.4, 1.4), (4, 3.7), (1.3, 1.1), (0.6, 0.6)),
    "Neghip": ("128k", (235, 82), (83, 27), (43, 14), (145, 64), (62, 35), (35, 22)),
    "Hydrogen": ("535k", (72, 48), (24, 15), (12, 8), (40, 31), (14, 14), (8, 7.5)),
}
LOCAL = "Local illumination"
# Which actors, how many translucent layers, how many samples of the light.
METHODS = {
    LOCAL: ("image space", 0, 0),
    "Transparency (3 layers)": ("image space", 3, 0),
    "Transparency (6 layers)": ("image space", 6, 0),
    "Shadows (1 sample)": ("image space", 0, 1),
    "Shadows (5 samples)": ("image space", 0, 5),
    "Shadows (10 samples)": ("image space", 0, 10),
    "Stock VTK, points of 1 pixel": ("stock", 0, 0),
    "Splats, two passes": ("two passes", 0, 0),
}


def polydata(points, normals, radius=None):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=1))
    data.SetPoints(vtk_points)
    data.GetPointData().SetNormals(
        numpy_to_vtk(np.ascontiguousarray(normals, np.float32), deep=1))
    if radius is not None:
        radii = numpy_to_vtk(np.full(len(points), radius, np.float32), deep=1)
        radii.SetName("SplatRadius")
        data.GetPointData().AddArray(radii)
    return data


def torus(count, minor):
    """Evenly spread points, with radii as estimation gives them there: 0.75 spacings."""
    i = np.arange(count)
    u = 2 * np.pi * i / count
    v = 2 * np.pi * np.modf(i * 0.5 * (np.sqrt(5) - 1))[0]
    normal = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
    centre = np.stack([np.cos(u), np.sin(u), 0 * u], 1)
    area = 4 * np.pi ** 2 * minor
    return polydata(centre + minor * normal, normal, 0.75 * math.sqrt(area / count))


def grid(n, half):
    """Coordinates of the samples of a cube about the origin, z slowest."""
    axis = np.linspace(-half, half, n, dtype=np.float32)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    return x, y, z


def orbital(n):
    """The density of hydrogen's 3d orbital along z, greatest value 100."""
    x, y, z = grid(n, 18)
    r2 = x * x + y * y + z * z
    density = ((3 * z * z - r2) * np.exp(-np.sqrt(r2) / 3)) ** 2
    return 100 * density / density.max(), 18


def charges(n):
    """Gaussian clouds about atoms at random places: surfaces of many components, as Neghip's."""
    x, y, z = grid(n, 1)
    random = np.random.default_rng(1)
    field = np.zeros_like(x)
    for _ in range(60):
        cx, cy, cz = random.uniform(-0.8, 0.8, 3)
        width = random.uniform(0.06, 0.16)
        field += np.exp(-((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) / (2 * width ** 2))
    return field, 1


def isosurface(field, values, count):
    """Parts of count points in all, or fewer if the samples make fewer: drawn at random."""
    values_of, half = field
    n = len(values_of)
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(-half, -half, -half)
    image.SetSpacing(3 * [2 * half / (n - 1)])
    scalars = numpy_to_vtk(values_of.ravel(), deep=1)
    scalars.SetName("field")
    image.GetPointData().SetScalars(scalars)
    found = []
    for value in values:
        surface = pointsplatting.vtkIsosurfacePoints()
        surface.SetInputData(image)
        surface.SetValue(0, value)
        surface.Update()
        data = surface.GetOutput()
        found.append((vtk_to_numpy(data.GetPoints().GetData()),
                      vtk_to_numpy(data.GetPointData().GetNormals())))
    share = min(1.0, count / sum(len(points) for points, _ in found))
    random = np.random.default_rng(2)
    parts = []
    for points, normals in found:
        some = random.permutation(len(points))[:round(share * len(points))]
        parts.append(polydata(points[some], normals[some]))
    return parts


def read(name):
    reader = READERS[os.path.splitext(name)[1].lower()]()
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput()
    if not data.GetNumberOfPoints():
        raise SystemExit(f"{name}: no points")
    if not data.GetPointData().GetNormals():
        if data.GetNumberOfPolys() or data.GetNumberOfStrips():
            normals = vtkPolyDataNormals()
            normals.SplittingOff()
        else:
            normals = pointsplatting.vtkPointSplatEstimation()
        normals.SetInputData(data)
        normals.Update()
        data = normals.GetOutput()
    return polydata(vtk_to_numpy(data.GetPoints().GetData()),
                    vtk_to_numpy(data.GetPointData().GetNormals()))


class Scene:
    """All actors in one renderer, of which those of one kind are seen."""

    def __init__(self, parts):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.light = vtkLight()
        self.light.SetLightTypeToSceneLight()
        self.renderer.AddLight(self.light)
        self.actors = {"image space": [], "stock": [], "two passes": []}
        for data, colour in zip(parts, COLOURS):
            self.add("image space", pointsplatting.vtkPointSplatMapper(), data, colour)
            self.actors["image space"][-1].GetMapper().SetMethodToImageSpace()
            vertices = vtkVertexGlyphFilter()
            vertices.SetInputData(data)
            vertices.Update()
            self.add("stock", vtkPolyDataMapper(), vertices.GetOutput(), colour)
            if not data.GetPointData().HasArray("SplatRadius"):
                estimation = pointsplatting.vtkPointSplatEstimation()
                estimation.SetInputData(data)
                estimation.Update()
                data = estimation.GetOutput()
            self.add("two passes", pointsplatting.vtkPointSplatMapper(), data, colour)
            self.actors["two passes"][-1].GetMapper().SetMethodToTwoPass()
        if os.environ.get("DISPLAY"):
            self.window = vtkRenderWindow()
            self.window.OffScreenRenderingOn()
        else:
            self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()
        self.renderer.GetActiveCamera().Elevation(-50)
        self.renderer.GetActiveCamera().Zoom(1.6)
        bounds = self.renderer.ComputeVisiblePropBounds()
        self.centre = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
        self.length = math.dist(bounds[::2], bounds[1::2])
        self.frames = 0

    def add(self, kind, mapper, data, colour):
        mapper.SetInputData(data)
        mapper.ScalarVisibilityOff()
        if kind != "stock":
            mapper.SetMaximumImageMemory(0)
            mapper.SetShadowLightRadius(0.0)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        self.renderer.AddActor(actor)
        self.actors[kind].append(actor)

    def configure(self, kind, layers, samples):
        for name, actors in self.actors.items():
            for actor in actors:
                actor.SetVisibility(name == kind)
                if name == "image space":
                    mapper = actor.GetMapper()
                    actor.GetProperty().SetOpacity(OPACITY if layers else 1.0)
                    mapper.SetTransparencyToPeeling()
                    mapper.SetMaximumNumberOfLayers(layers)
                    mapper.SetShadows(samples > 0)
                    mapper.SetNumberOfShadowSamples(max(samples, 1))
                    mapper.SetShadowLightRadius(0.03 * self.length if samples > 1 else 0.0)

    def draw(self):
        """Milliseconds. The camera turns, and the light moves a little."""
        self.frames += 1
        angle = 0.6 + 0.01 * self.frames
        self.light.SetFocalPoint(self.centre)
        self.light.SetPosition(self.centre[0] + self.length * math.cos(angle),
                               self.centre[1] + self.length * math.sin(angle),
                               self.centre[2] + self.length)
        self.renderer.GetActiveCamera().Azimuth(3)
        self.renderer.ResetCameraClippingRange()
        pixels = vtkUnsignedCharArray()
        start = time.perf_counter()
        self.window.Render()
        self.window.GetPixelData(0, 0, 0, 0, 0, pixels, 0)
        return 1e3 * (time.perf_counter() - start)

    def measure(self, size):
        """Frames a second by method, and layers where there were fewer than wanted."""
        self.window.SetSize(size, size)
        times = {name: [] for name in METHODS}
        layers = {}
        for _ in range(options.runs):
            for name, method in METHODS.items():
                self.configure(*method)
                self.draw()
                before = self.updates()
                times[name].append(self.draw())
                if method[2] and self.updates() == before:
                    raise SystemExit(f"{name}: shadows were not computed again")
                drawn = self.actors["image space"][0].GetMapper().GetNumberOfLayersDrawn()
                if drawn < method[1]:
                    layers[name] = drawn
        return {name: 1e3 / statistics.median(ms) for name, ms in times.items()}, layers

    def updates(self):
        return self.actors["image space"][0].GetMapper().GetNumberOfShadowUpdates()


def paper_of(name):
    """The paper's column for a scene, or None."""
    words = name.lower()
    return next((key for key in PAPER if key.lower().split()[-1] in words), None)


def cell(rate, local):
    return f"{rate:.3g} ({rate / local:.2f})"


def header(sizes):
    return "".join(f"{f'{size} px':>16}" for size in sizes)


def paper_cells(key, row):
    return "".join(f"{cell(PAPER[key][row + 1][k], PAPER[key][1][k]):>16}" for k in range(2))


def report(name, parts):
    scene = Scene(parts)
    results = [scene.measure(size) for size in options.size]
    key = paper_of(name)
    count = sum(part.GetNumberOfPoints() for part in parts)
    mapper = scene.actors["image space"][0].GetMapper()
    title = f"{name}, {count} points"
    print(f"\n{title:44}{header(options.size)}"
          + (f"  | paper, {PAPER[key][0]:7}{header((512, 1024))}" if key else ""))
    for row, method in enumerate(METHODS):
        fewer = [layers[method] for _, layers in results if method in layers]
        label = method + (f", {fewer[0]} there" if fewer else "")
        line = f"{label:44}" + "".join(
            f"{cell(rates[method], rates[LOCAL]):>16}" for rates, _ in results)
        print(line + (f"  | {'':14}{paper_cells(key, row)}" if key and row < 6 else ""))
    print(f"projection: {mapper.GetProjectionUsed()}; steps of filling: "
          f"{mapper.GetNumberOfFillSteps()}", flush=True)
    return key


print("Frames a second, and in brackets the ratio to local illumination; "
      f"medians of {options.runs}")
tori = [torus(options.points, minor) for minor in (0.4, 0.28, 0.16)]
seen = {report("3 nested tori", tori)}
del tori
part_of_all = options.points / 2e6
seen.add(report("Neghip-like field", isosurface(charges(256), (0.6,), round(128e3 * part_of_all))))
seen.add(report("Hydrogen orbital",
                isosurface(orbital(324), (4.0, 18.0, 50.0), round(535e3 * part_of_all))))
for file in options.files:
    seen.add(report(os.path.basename(file), [read(file)]))
for other in PAPER:
    if other not in seen:
        print(f"\n{f'paper: {other}, {PAPER[other][0]} points':44}{header((512, 1024))}")
        for at, what in enumerate(list(METHODS)[:6]):
            print(f"{what:44}{paper_cells(other, at)}")
