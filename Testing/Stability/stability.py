#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where splats break: one sweep for each way to fail, against fine meshes of closed forms.

  stability.py [--quick] [--output FOLDER] [--size PIXELS] [SWEEP ...]

Each sweep changes one thing, all else at its default, and measures the picture against the mesh
of the same surface, supersampled 3 x 3:
- psnr: of the whole picture, dB;
- mesh: the psnr of that mesh itself, not supersampled;
- holes: the pixels well inside the mesh's image where nothing is drawn, as a share of these;
- leaks: the pixels drawn farther than two pixels outside, as a share of those covered.
Writes stability.csv and a chart of each sweep (NAME.png). Exit code 1 if a value marked below as
one that the defaults must bear misses its bound. --quick: these values alone, no charts.
"""
import argparse
import csv
import math
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import (
    vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource)
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
import pointsplatting

SAMPLES = 3


class Surface:
    """A closed form: its fine mesh, and points drawn from it by equal areas."""

    def __init__(self, mesh, draw, colour=(0.9, 0.6, 0.4), opacity=1.0):
        self.mesh, self.draw, self.colour, self.opacity = mesh, draw, colour, opacity


def random(seed=5):
    return np.random.default_rng(seed)


def sphere_points(n, rng):
    z = rng.uniform(-1, 1, n)
    a = rng.uniform(0, 2 * math.pi, n)
    r = np.sqrt(1 - z * z)
    p = np.stack([r * np.cos(a), r * np.sin(a), z], 1)
    return p, p.copy()


def sphere():
    source = vtkSphereSource()
    source.SetRadius(1)
    source.SetThetaResolution(720)
    source.SetPhiResolution(360)
    source.Update()
    return Surface(source.GetOutput(), sphere_points)


def torus():
    function = vtkParametricTorus()
    function.SetRingRadius(0.7)
    function.SetCrossSectionRadius(0.3)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(600)
    source.SetVResolution(300)
    source.SetScalarModeToNone()
    source.Update()

    def draw(n, rng):
        v = rng.uniform(0, 2 * math.pi, 3 * n + 100)
        keep = rng.uniform(0, 1, len(v)) < (0.7 + 0.3 * np.cos(v))
        v = v[keep][:n]
        u = rng.uniform(0, 2 * math.pi, len(v))
        ring = 0.7 + 0.3 * np.cos(v)
        p = np.stack([ring * np.cos(u), ring * np.sin(u), 0.3 * np.sin(v)], 1)
        m = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
        return p, m
    return Surface(source.GetOutput(), draw)


def grid(n, rng):
    """Points at random within the cells of a grid, so that there are no gaps."""
    side = int(math.sqrt(n))
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    x = 2 * (x.ravel() + rng.uniform(0, 1, side * side)) / side - 1
    y = 2 * (y.ravel() + rng.uniform(0, 1, side * side)) / side - 1
    return x, y


def plate(z=0.0, colour=(0.9, 0.6, 0.4), opacity=1.0):
    source = vtkPlaneSource()
    source.SetOrigin(-1, -1, z)
    source.SetPoint1(1, -1, z)
    source.SetPoint2(-1, 1, z)
    source.Update()

    def draw(n, rng):
        x, y = grid(n, rng)
        return np.stack([x, y, np.full(len(x), z)], 1), np.tile([0.0, 0.0, 1.0], (len(x), 1))
    return Surface(source.GetOutput(), draw, colour, opacity)


def cloud(points, normals):
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=1))
    data.SetPoints(coordinates)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals, dtype=np.float32), deep=1)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    return data


def look(position, focus=(0, 0, 0), angle=30, parallel=None, clipping=None, up=(0, 1, 0)):
    def set_camera(renderer):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*position)
        camera.SetFocalPoint(*focus)
        camera.SetViewUp(*up)
        camera.SetViewAngle(angle)
        if parallel:
            camera.ParallelProjectionOn()
            camera.SetParallelScale(parallel)
        if clipping:
            camera.SetClippingRange(*clipping)
        else:
            renderer.ResetCameraClippingRange()
    return set_camera


def picture(parts, camera, size):
    """parts: (mapper, surface, offset). Rows of RGB, black where nothing is drawn."""
    window = pointsplatting.vtkEGLHeadlessRenderWindow()
    window.SetSize(size, size)
    window.SetMultiSamples(0)
    renderer = vtkRenderer()
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(10)
    renderer.SetOcclusionRatio(0.0)
    window.AddRenderer(renderer)
    for mapper, surface, offset in parts:
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(*offset)
        mapper.ScalarVisibilityOff()
        material = actor.GetProperty()
        material.SetColor(*surface.colour)
        material.SetOpacity(surface.opacity)
        material.SetAmbient(0.15)
        material.SetSpecular(0.3)
        material.SetSpecularPower(20)
        renderer.AddActor(actor)
    camera(renderer)
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, size - 1, size - 1, 0, pixels, 0)
    image = vtk_to_numpy(pixels).reshape(size, size, 3).astype(float)
    window.Finalize()
    return image


def shrink(mask, pixels):
    for _ in range(pixels):
        padded = np.pad(mask, 1, constant_values=True)
        mask = (padded[1:-1, 1:-1] & padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] &
                padded[1:-1, 2:])
    return mask


def psnr(a, b):
    return min(99.0, -10 * math.log10(max(((a - b) ** 2).mean() / 255.0 ** 2, 1e-12)))


def measure(surfaces, data, camera, size, configure=lambda mapper: None, offset=(0, 0, 0),
            interior=0):
    """offset: the data lie this much off, and the actors bring them back. interior: psnr of what
    lies so many pixels inside only, since at borders splats reach over, whatever else happens."""
    meshes, splats = [], []
    for surface, points in zip(surfaces, data):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface.mesh)
        meshes.append((mapper, surface, (0, 0, 0)))
        mapper = pointsplatting.vtkPointSplatMapper()
        mapper.SetInputData(points)
        configure(mapper)
        splats.append((mapper, surface, tuple(-x for x in offset)))
    fine = picture(meshes, camera, SAMPLES * size)
    blocks = fine.reshape(size, SAMPLES, size, SAMPLES, 3)
    reference = blocks.mean((1, 3))
    covered = (blocks.max(4) > 0).mean((1, 3))
    drawn = picture(splats, camera, size)
    inside = shrink(covered == 1, 2)
    outside = shrink(covered == 0, 2)
    is_drawn = drawn.max(2) > 0
    judged = shrink(covered == 1, interior) if interior else np.ones_like(inside)
    if not judged.any():
        judged = np.ones_like(inside)
    return {
        "psnr": psnr(drawn[judged], reference[judged]),
        "mesh": psnr(picture(meshes, camera, size)[judged], reference[judged]),
        "holes": float((inside & ~is_drawn).sum() / max(1, inside.sum())),
        "leaks": float((outside & is_drawn).sum() / max(1, (covered > 0).sum())),
    }


# Sweeps: values to go through, and of these the ones that defaults must bear with the least psnr
# and the most holes and leaks; then the function that measures one.
SWEEPS = {}


def sweep(values, stable, gap, holes=0.0, leaks=0.0):
    """stable: values that users meet with all at its default. gap: how many dB below the mesh's
    own psnr the picture may be there, if that is not ENOUGH."""
    def register(function):
        SWEEPS[function.__name__] = (values, stable, gap, holes, leaks, function)
        return function
    return register


def decades(first, last, count):
    return [float(x) for x in np.logspace(math.log10(first), math.log10(last), count)]


FRONT = look((0, 0, 4.2))
# Differences that nobody sees, where the mesh itself is nearer still.
ENOUGH = 45


def simple(surface, n, camera, size, **more):
    return measure([surface], [cloud(*surface.draw(n, random()))], camera, size, **more)


@sweep(decades(2, 300, 9), [4, 40, 150], 8)
def close_up(pixels, size):
    """A splat's diameter in pixels."""
    n = 20000
    diameter = 2 * 1.2 * math.sqrt(4 * math.pi / n)
    distance = diameter * size / pixels / (2 * math.tan(math.radians(15)))
    # Beside the middle, where the surface is seen at a slant.
    return simple(sphere(), n, look((0.5, 0.3, 0.8 + distance), (0.5, 0.3, 0.8)), size)


@sweep([300, 100, 50, 30, 20, 10, 5], [300, 50, 10], 8)
def minification(diameter, size):
    """The cloud's diameter in pixels."""
    distance = 1 / math.sin(math.atan(diameter / size * math.tan(math.radians(15))))
    return simple(torus(), 50000, look((0, 0, distance)), size)


@sweep([60, 30, 15, 8, 4, 2, 1], [30, 8], 8, leaks=0.01)
def grazing(degrees, size):
    """The angle between the view and a plane."""
    a = math.radians(degrees)
    return simple(plate(), 20000, look((0, -4 * math.cos(a), 4 * math.sin(a)), up=(0, 0, 1)), size,
                  interior=8)


@sweep([0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99], [0, 0.8, 0.95], 8)
def camera_inside(off, size):
    """How far off a sphere's centre the camera is, looking at the near wall at a slant."""
    return simple(sphere(), 20000,
                  look((0, 0, off), (0.5, 0, 1.2), angle=60, clipping=(0.001, 3)), size)


@sweep(decades(100, 200000, 8), [2000, 20000, 200000], 8)
def density(n, size):
    """How many points sample a sphere, at random."""
    return simple(sphere(), int(n), FRONT, size)


@sweep([1, 2, 5, 10, 20, 50], [1, 10], 8)
def non_uniform(ratio, size):
    """How many times denser the left half of a torus is sampled than the right one."""
    surface = torus()
    p, n = surface.draw(20000, random())
    keep = (p[:, 0] < 0) | (random(6).uniform(0, 1, len(p)) < 1 / ratio)
    return measure([surface], [cloud(p[keep], n[keep])], FRONT, size)


# Of plates: no border is in sight.
NEAR = look((0, -0.7, 0.8), up=(0, 0, 1))


def spacing(n):
    return math.sqrt(4 * math.pi / n)


@sweep([0, 0.02, 0.05, 0.1, 0.2, 0.5, 1], [0.1], 14)
def position_noise(sigma, size):
    """The deviation of points along the normal, in mean spacings; true normals."""
    surface = sphere()
    p, n = surface.draw(20000, random())
    p = p + n * random(7).normal(0, sigma * spacing(len(p)), (len(p), 1))
    return measure([surface], [cloud(p, n)], FRONT, size)


@sweep([0, 1, 2, 5, 10, 20, 40], [2], 14)
def normal_noise(degrees, size):
    """The deviation of normals."""
    surface = sphere()
    p, n = surface.draw(20000, random())
    m = n + random(8).normal(0, math.tan(math.radians(degrees)), n.shape)
    return measure([surface], [cloud(p, m)], FRONT, size)


@sweep([0, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1], [0.001], 14, leaks=0.05)
def outliers(share, size):
    """The share of points that lie anywhere in the sphere's box, enlarged by half."""
    surface = sphere()
    p, n = surface.draw(20000, random())
    count = int(share * len(p))
    p[:count] = random(9).uniform(-1.5, 1.5, (count, 3))
    return measure([surface], [cloud(p, n)], FRONT, size)


@sweep([0, 0.001, 0.01, 0.05, 0.1, 0.3, 0.5], [0.001], 14)
def flipped_normals(share, size):
    """The share of points, at random, whose normals point inward."""
    surface = sphere()
    p, n = surface.draw(20000, random())
    n[random(10).uniform(0, 1, len(n)) < share] *= -1
    return measure([surface], [cloud(p, n)], FRONT, size)


@sweep([0, 1e2, 1e4, 1e6, 1e8], [1e6], 8)
def far_coordinates(offset, size):
    """How far from the origin a sphere of radius 1 lies, as doubles; its actor brings it back."""
    surface = sphere()
    p, n = surface.draw(20000, random())
    shift = (offset, 0.7 * offset, -0.3 * offset)
    return measure([surface], [cloud(p + shift, n)], FRONT, size, offset=shift)


@sweep([0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1], [0.1], 8)
def thin_wall(gap, size):
    """The distance of a red plate before a blue one of another actor; splats have a radius of 0.02."""
    front, back = plate(gap, (0.9, 0.2, 0.2)), plate(0, (0.2, 0.2, 0.9))
    data = [cloud(*s.draw(20000, random(i))) for i, s in enumerate((front, back))]
    return measure([front, back], data, NEAR, size)


@sweep([0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1], [0.1], 8)
def thin_wall_translucent(gap, size):
    """The same with an opacity of 0.5."""
    front, back = plate(gap, (0.9, 0.2, 0.2), 0.5), plate(0, (0.2, 0.2, 0.9), 0.5)
    data = [cloud(*s.draw(20000, random(i))) for i, s in enumerate((front, back))]
    return measure([front, back], data, NEAR, size)


@sweep([0, 1, 2, 3, 4, 5, 6, 7], [], 8)
def random_gaps(seed, size):
    """The seed of a plate's points, wholly random: now and then a gap between them stays open."""
    surface = plate()
    rng = random(seed)
    p = np.stack([rng.uniform(-1, 1, 20000), rng.uniform(-1, 1, 20000), np.zeros(20000)], 1)
    return measure([surface], [cloud(p, np.tile([0.0, 0.0, 1.0], (len(p), 1)))], NEAR, size)


@sweep([5, 10, 20, 45, 90], [20, 90], 12)
def crossing(degrees, size):
    """The angle at which two plates of two actors cross."""
    a = math.radians(degrees)
    one, other = plate(0, (0.9, 0.2, 0.2)), plate(0, (0.2, 0.2, 0.9))
    turn = np.array([[math.cos(a), 0, -math.sin(a)], [0, 1, 0], [math.sin(a), 0, math.cos(a)]])
    mesh = vtkPlaneSource()
    mesh.SetOrigin(*(turn @ (-1, -1, 0)))
    mesh.SetPoint1(*(turn @ (1, -1, 0)))
    mesh.SetPoint2(*(turn @ (-1, 1, 0)))
    mesh.Update()
    p, n = other.draw(20000, random(1))
    other.mesh = mesh.GetOutput()
    return measure([one, other], [cloud(*one.draw(20000, random())), cloud(p @ turn.T, n @ turn.T)],
                   NEAR, size)


@sweep(decades(1e-4, 1, 9), [], 8)
def layer_distance(distance, size):
    """The least layer distance, set by hand, of a torus; the automatic one is about 0.02."""
    return simple(torus(), 20000, FRONT, size,
                  configure=lambda mapper: mapper.SetLayerDistance(distance))


@sweep([0.25, 0.5, 0.7, 1, 1.4, 2, 4, 8], [1], 8)
def radius_scale(scale, size):
    """What all radii are multiplied with."""
    return simple(torus(), 20000, FRONT, size,
                  configure=lambda mapper: mapper.SetRadiusScale(scale))


@sweep([0.1, 0.2, 0.3, 0.6, 1, 2, 5], [0.6], 8)
def kernel_sigma(sigma, size):
    """The Gaussian's width in radii."""
    return simple(torus(), 20000, FRONT, size,
                  configure=lambda mapper: mapper.SetKernelSigma(sigma))


@sweep(decades(10, 1e7, 7), [1e6], 8)
def clipping_ratio(ratio, size):
    """The far clipping plane's distance over the near one's."""
    return simple(torus(), 20000, look((0, 0, 4.2), clipping=(8 / ratio, 8)), size)


@sweep([0.05, 0.5, 1.2, 5], [0.5, 1.2], 8)
def parallel_projection(scale, size):
    """Half the height of a parallel view, of a slanted torus."""
    return simple(torus(), 20000, look((0.7, -2, 2), (0.7, 0, 0.2), parallel=scale), size)


@sweep([1, 2, 10, 100, 1024, 4096], [1, 100], 8)
def window(pixels, size):
    """The window's side."""
    return simple(torus(), 20000, FRONT, pixels)


def chart(name, rows, folder):
    from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from vtkmodules.vtkCommonDataModel import vtkTable
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingContext2D import vtkContextActor
    import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
    import vtkmodules.vtkRenderingFreeType  # noqa: F401
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
    table = vtkTable()
    for column in ("value", "psnr", "mesh"):
        array = vtkDoubleArray()
        array.SetName(column)
        for row in rows:
            array.InsertNextValue(row[column])
        table.AddColumn(array)
    plot = vtkChartXY()
    plot.SetShowLegend(True)
    plot.SetTitle(name.replace("_", " "))
    for column, colour in ((1, (200, 80, 30)), (2, (120, 120, 120))):
        line = plot.AddPlot(vtkChart.LINE)
        line.SetInputData(table, 0, column)
        line.SetColor(*colour, 255)
        line.SetWidth(2.5)
    values = [row["value"] for row in rows]
    bottom = plot.GetAxis(vtkAxis.BOTTOM)
    bottom.SetTitle(SWEEPS[name][5].__doc__.strip())
    bottom.SetLogScale(min(values) > 0 and max(values) / min(values) > 20)
    plot.GetAxis(vtkAxis.LEFT).SetTitle("psnr, dB")
    actor = vtkContextActor()
    actor.GetScene().AddItem(plot)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    actor.GetScene().SetRenderer(renderer)
    image = pointsplatting.vtkEGLHeadlessRenderWindow()
    image.SetSize(700, 400)
    image.SetMultiSamples(4)
    image.AddRenderer(renderer)
    image.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(image)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(os.path.join(folder, name + ".png"))
    writer.Write()


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--output", default=".")
    parser.add_argument("--size", type=int, default=300)
    parser.add_argument("sweeps", nargs="*", metavar="SWEEP", help=", ".join(SWEEPS))
    options = parser.parse_args()
    missed = 0
    rows = []
    for name in options.sweeps or SWEEPS:
        values, stable, gap, holes, leaks, function = SWEEPS[name]
        own = []
        for value in stable if options.quick else sorted(set(values) | set(stable)):
            row = {"sweep": name, "value": value, **function(value, options.size)}
            good = value not in stable or (
                row["psnr"] >= min(ENOUGH, row["mesh"] - gap) and row["holes"] <= holes and row["leaks"] <= leaks)
            missed += not good
            own.append(row)
            print("%-22s %10.4g  %5.1f dB (mesh %5.1f)  holes %.4f  leaks %.4f%s" % (
                name, value, row["psnr"], row["mesh"], row["holes"], row["leaks"],
                ("" if good else "  MISSED") if value not in stable else
                "  stable" if good else "  MISSED"), flush=True)
        rows += own
        if not options.quick and len(own) > 1:
            chart(name, own, options.output)
    with open(os.path.join(options.output, "stability.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, ["sweep", "value", "psnr", "mesh", "holes", "leaks"])
        writer.writeheader()
        writer.writerows(rows)
    if missed:
        print("%d values miss their bounds: psnr below the mesh's by more than allowed, or holes "
              "or leaks." % missed)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
