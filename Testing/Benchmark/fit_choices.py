#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the constants of the automatic choices (Rendering/Choice/vtkPointSplatChoices.cxx).

  fit_choices.py [--size PIXELS] [--scratch FOLDER] [CONSTANT ...]

Of each constant, or of those named, it draws clouds of formulas (bench/shapes.py), forces what the
constant decides, whatever the sources have, and prints what each scene asks for, what they ask for
together, and what the sources have. Errors are rms differences of colour, of 1, over covered pixels.
FOLDER gets the pictures, each beside the best one. All constants take some minutes, the first two,
which have their pictures in common, most of them. The first two are for frames before which none was
measured, as while the user drags.

StrideErrorPerPixel: every 2^n-th splat, larger by as much and without smooth outlines, against all of
    them. The error over the distance in pixels of the splats that are drawn; the greatest of smooth
    clouds counts, of splats two to five pixels apart, which errors of 1/32 and 1/16 lead to. Noise of
    normals, of which fewer splats average less, has a ratio of its own, and is printed only.
OutlineError: of the same pictures, and of all splats, where these are less than a pixel apart: the
    greatest error of smooth clouds, which is that of outlines. It is to be less than the sources have:
    bodies of half as many pixels have twice that of these, and noise has more.
OneStepPixels: points by image space with one step of filling: the greatest distance at which no more
    than one covered pixel of ten thousand stays a hole.
ShadowSampleError, ShadowWidthPower: one sample of an area light against 64, on white. The error grows as this power of
    the tangent at which the lamp is seen; the greatest factor counts.

splatbench.py --choices judges the choices on scenes that are not among these. levels.py is for the
constants of levels of detail.
"""
import argparse
import os
import re
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer
import pointsplatting

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from bench import shapes  # noqa: E402
from drawing import save  # noqa: E402

SOURCE = os.path.join(HERE, "..", "..", "Rendering", "Choice", "vtkPointSplatChoices.cxx")
BACKGROUND = (26, 51, 102)
MOST_HOLES = 1e-4
LEAST_PIXELS, OUTLINES_BELOW, FEWER_FROM, MOST_PIXELS = 0.5, 1.0, 2.0, 5.0
SMOOTH = {"ball": shapes.sphere, "torus": shapes.torus, "bumpy ball": shapes.bumpy}


def cloud(points, normals):
    """With the radii that the mapper would estimate."""
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    data.SetPoints(places)
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype(np.float32), deep=True))
    estimation = pointsplatting.vtkPointSplatEstimation()
    estimation.SetInputData(data)
    estimation.Update()
    return estimation.GetOutput()


def along_curve(points):
    """The order in which the mapper has points, along a curve that fills space."""
    cells = ((points - points.min(axis=0)) / np.ptp(points, axis=0).max() * 1023.0).astype(np.int64)
    code = np.zeros(len(points), np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return np.argsort(code, kind="stable")


def every(data, order, shift):
    """Each 2^shift-th splat in that order, larger by as much as it takes to cover the surface."""
    kept = order[::1 << shift]
    fewer = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(vtk_to_numpy(data.GetPoints().GetData())[kept], deep=True))
    fewer.SetPoints(places)
    for k in range(data.GetPointData().GetNumberOfArrays()):
        array = data.GetPointData().GetArray(k)
        values = vtk_to_numpy(array)[kept]
        copy = numpy_to_vtk(values * 2.0 ** (0.5 * shift) if array.GetName() == "SplatRadius"
                            else values, deep=True)
        copy.SetName(array.GetName())
        fewer.GetPointData().AddArray(copy)
    fewer.GetPointData().SetActiveNormals(data.GetPointData().GetNormals().GetName())
    return fewer


class Scene:
    """Clouds in a window, each with an actor. Mappers take all points in full quality."""

    def __init__(self, options, clouds, opacity=1.0):
        self.size = options.size
        self.scratch = options.scratch
        self.renderer = vtkRenderer()
        self.renderer.SetBackground([c / 255.0 for c in BACKGROUND])
        self.mappers, self.properties = [], []
        for data in clouds:
            mapper = pointsplatting.vtkPointSplatMapper()
            mapper.SetInputData(data)
            mapper.LevelOfDetailOff()
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetSpecular(0.3)
            actor.GetProperty().SetSpecularPower(20)
            actor.GetProperty().SetOpacity(opacity)
            self.renderer.AddActor(actor)
            self.mappers.append(mapper)
            self.properties.append(actor.GetProperty())
        self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(self.size, self.size)
        self.window.AddRenderer(self.renderer)

    def draw(self, **settings):
        """The picture with what the mappers are to be set to, as levels of 255."""
        for mapper in self.mappers:
            for name, value in settings.items():
                getattr(mapper, "Set" + name)(value)
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(self.size, self.size, 3).astype(float)

    def keep(self, name, picture, best):
        if self.scratch:
            save(os.path.join(self.scratch, name.replace(" ", "_") + ".png"),
                 np.concatenate([best, picture], 1))


def covered(picture):
    return (np.abs(picture - np.array(BACKGROUND)) > 2).any(axis=2)


def error(picture, best):
    """Rms, of 1, over the pixels that either covers."""
    inside = covered(best) | covered(picture)
    return np.sqrt((((picture - best)[inside] / 255.0) ** 2).mean())


def spacing(best, count, balls=1):
    """Pixels between random points on so many closed surfaces, one within the other: the root of the
    area that each has. A ball's area is four times that of its picture."""
    return np.sqrt(4.0 * balls * covered(best).sum() / count)


def strides(options):
    """(scene, whether it is smooth, pixels apart, error)"""
    generator = np.random.default_rng(5)
    scenes = {**{name: (shape, 1.0) for name, shape in SMOOTH.items()},
              "torus, translucent": (shapes.torus, 0.5), "shells": (shapes.shells, 0.2),
              "noisy ball": (shapes.rough, 1.0)}
    for name, (shape, opacity) in scenes.items():
        for count in (100_000, 1_600_000):
            data = cloud(*shape(count, generator))
            order = along_curve(vtk_to_numpy(data.GetPoints().GetData()))
            radius = float(np.median(vtk_to_numpy(data.GetPointData().GetArray("SplatRadius"))))
            scene = Scene(options, [data], opacity)
            scene.mappers[0].SetLayerDistance(radius)
            best = scene.draw()
            apart = spacing(best, count, 4 if name == "shells" else 1)
            for shift in range(8):
                pixels = apart * 2.0 ** (0.5 * shift)
                if not LEAST_PIXELS <= pixels <= MOST_PIXELS:
                    continue
                scene.mappers[0].SetInputData(every(data, order, shift))
                picture = scene.draw(AntiAliasing=False)
                scene.keep(f"stride {name} {count} {1 << shift}", picture, best)
                yield name, name != "noisy ball", pixels, error(picture, best)


def fit_strides(options):
    rows = []
    for name, smooth, pixels, difference in strides(options):
        rows.append((smooth, pixels, difference / pixels))
        print(f"  {name:19s} {pixels:5.2f} pixels apart: error {difference:.4f}, per pixel "
              f"{difference / pixels:.4f}", flush=True)
    for kind, what in ((True, "smooth"), (False, "noisy")):
        ratios = [ratio for smooth, _, ratio in rows if smooth == kind]
        print(f"  {what} clouds, per pixel: median {np.median(ratios):.4f}, greatest {max(ratios):.4f}")
    return {"StrideErrorPerPixel": max(ratio for smooth, pixels, ratio in rows
                                       if smooth and pixels >= FEWER_FROM),
            "OutlineError": max(ratio * pixels for smooth, pixels, ratio in rows
                                if smooth and pixels < OUTLINES_BELOW)}


def fit_fill(options):
    generator = np.random.default_rng(7)
    fits, fails = [], []
    for name, shape in SMOOTH.items():
        for count in (20_000, 40_000, 60_000, 80_000, 120_000, 240_000):
            scene = Scene(options, [cloud(*shape(round(count * (options.size / 384.0) ** 2),
                                                 generator))])
            best = scene.draw()
            inside = covered(best)
            for _ in range(2):
                inside[1:-1, 1:-1] &= (inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] &
                                       inside[1:-1, 2:])
            apart = spacing(best, count * (options.size / 384.0) ** 2)
            for mapper in scene.mappers:
                mapper.SetMethodToImageSpace()
            shares = []
            for steps in (1, 2):
                picture = scene.draw(MaximumNumberOfFillSteps=steps)
                shares.append((inside & ~covered(picture)).sum() / inside.sum())
                scene.keep(f"fill {name} {count} {steps}", picture, best)
            (fits if shares[0] <= MOST_HOLES else fails).append(apart)
            print(f"  {name:10s} {apart:.2f} pixels apart: holes {shares[0]:.6f} with one step, "
                  f"{shares[1]:.6f} with two", flush=True)
    most = max((apart for apart in fits if apart < min(fails, default=np.inf)), default=0.0)
    return {"OneStepPixels": most}


def fit_shadows(options):
    generator = np.random.default_rng(8)
    ball, normals = shapes.sphere(10_000, generator)
    floor = cloud(*shapes.torus(60_000, generator))
    over = cloud(0.35 * ball + (0.75, -0.35, 1.0), normals)
    boxes = np.array([floor.GetBounds(), over.GetBounds()])
    centre = 0.5 * (boxes[:, ::2].min(axis=0) + boxes[:, 1::2].max(axis=0))
    errors, tangents = [], []
    for place in ((2.0, -1.0, 5.0), (4.0, -2.0, 3.0)):
        for radius in (0.1, 0.2, 0.4, 0.8):
            scene = Scene(options, [floor, over])
            for prop in scene.properties:
                prop.SetColor(1.0, 1.0, 1.0)
                prop.SetSpecular(0.0)
            lamp = vtkLight()
            lamp.SetLightTypeToSceneLight()
            lamp.PositionalOn()
            lamp.SetPosition(place)
            lamp.SetFocalPoint(0.0, 0.0, 0.0)
            lamp.SetConeAngle(90.0)
            scene.renderer.AutomaticLightCreationOff()
            scene.renderer.AddLight(lamp)
            best = scene.draw(TargetError=0.0, Shadows=True, ShadowLightRadius=radius,
                              NumberOfShadowSamples=64)
            picture = scene.draw(NumberOfShadowSamples=1)
            scene.keep(f"shadows {radius} {place[0]}", picture, best)
            errors.append(error(picture, best))
            tangents.append(radius / np.linalg.norm(np.array(place) - centre))
            print(f"  lamp of {radius} at {place}: tangent {tangents[-1]:.3f}, error {errors[-1]:.4f}",
                  flush=True)
    # Each place has a line of its own by logarithms; their slopes' mean.
    lines = [np.polyfit(np.log(tangents[i:i + 4]), np.log(errors[i:i + 4]), 1) for i in (0, 4)]
    power = np.mean([line[0] for line in lines])
    return {"ShadowSampleError": (errors / np.power(tangents, power)).max(),
            "ShadowWidthPower": power}


FITS = {"StrideErrorPerPixel": fit_strides, "OutlineError": fit_strides, "OneStepPixels": fit_fill,
        "ShadowSampleError": fit_shadows, "ShadowWidthPower": fit_shadows}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--scratch", help="a folder for pictures")
    parser.add_argument("constants", nargs="*", metavar="CONSTANT",
                        help="one of " + ", ".join(FITS) + "; all of them by default")
    options = parser.parse_args()
    unknown = set(options.constants) - set(FITS)
    if unknown:
        parser.error(f"no such constant: {', '.join(sorted(unknown))}")
    if options.scratch:
        os.makedirs(options.scratch, exist_ok=True)
    with open(SOURCE, encoding="utf-8") as file:
        has = {name: np.divide.reduce([float(part) for part in value.split("/")]) for name, value in
               re.findall(r"constexpr double (\w+) = ([0-9./ ]+);", file.read())}
    # Constants that are fitted by the same pictures are fitted once.
    for fit in dict.fromkeys(FITS[name] for name in options.constants or FITS):
        start = time.perf_counter()
        fitted = fit(options)
        seconds = time.perf_counter() - start
        for name, value in fitted.items():
            print(f"{name}: the scenes ask for {value:.4f}, the sources have "
                  f"{has.get(name, np.nan):g} ({seconds:.0f} s)\n", flush=True)


if __name__ == "__main__":
    main()
