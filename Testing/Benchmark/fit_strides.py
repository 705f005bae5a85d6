#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fits StrideErrorPerPixel of Rendering/Choice/vtkPointSplatChoices.cxx.

  fit_strides.py [--size PIXELS]

Where the mapper draws only every 2^n-th splat, its picture differs from that of all splats. For
a ball, a torus, a bumpy ball and one whose normals are noisy as scans' are, at random points of
several densities, this prints the rms difference of colour over the covered pixels, the spacing
of the splats that are drawn, in pixels, and the ratio of the two; and of all ratios the median
and the greatest of splats up to eight pixels apart. The constant is twice the greatest of smooth
clouds (0.006); noise of normals, of which fewer splats average less, has up to 0.05.
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
import pointsplatting

BACKGROUND = (26, 51, 102)


def sphere(count, generator, bumps=0.0):
    """Random points on a ball, whose radius varies by the bumps, and their normals."""
    d = generator.normal(size=(count, 3))
    d /= np.linalg.norm(d, axis=1)[:, None]
    phase = 7.0 * d
    r = 1.0 + bumps * np.sin(phase).prod(axis=1)
    gradient = 7.0 * bumps * np.stack([
        np.cos(phase[:, k]) * np.sin(phase[:, k - 1]) * np.sin(phase[:, k - 2]) for k in range(3)
    ], axis=1)
    tangential = gradient - (gradient * d).sum(axis=1)[:, None] * d
    normals = d - tangential / r[:, None]
    return r[:, None] * d, normals / np.linalg.norm(normals, axis=1)[:, None]


def torus(count, generator):
    """Random points on a torus of radii 1 and 0.4, and their normals."""
    f, t, k = generator.uniform(0.0, 1.0, (3, 3 * count))
    f, t = 2.0 * np.pi * f, 2.0 * np.pi * t
    kept = 1.4 * k < 1.0 + 0.4 * np.cos(t)
    f, t = f[kept][:count], t[kept][:count]
    normals = np.stack([np.cos(f) * np.cos(t), np.sin(f) * np.cos(t), np.sin(t)], axis=1)
    return np.stack([np.cos(f), np.sin(f), 0.0 * f], axis=1) + 0.4 * normals, normals


def rough(count, generator):
    """The bumpy ball, with normals that are off by six degrees."""
    points, normals = sphere(count, generator, bumps=0.15)
    normals = normals + generator.normal(scale=0.1, size=normals.shape)
    return points, normals / np.linalg.norm(normals, axis=1)[:, None]


class Scene:
    """A cloud in a window."""

    def __init__(self, points, normals, size):
        data = vtkPolyData()
        self.keep = [points.astype(np.float32), normals.astype(np.float32)]
        places = vtkPoints()
        places.SetData(numpy_to_vtk(self.keep[0]))
        data.SetPoints(places)
        data.GetPointData().SetNormals(numpy_to_vtk(self.keep[1]))
        self.mapper = pointsplatting.vtkPointSplatMapper()
        self.mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        actor.GetProperty().SetSpecular(0.3)
        actor.GetProperty().SetSpecularPower(20)
        renderer = vtkRenderer()
        renderer.SetBackground([c / 255.0 for c in BACKGROUND])
        renderer.AddActor(actor)
        self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetSize(size, size)
        self.window.AddRenderer(renderer)
        self.size = size

    def draw(self, error):
        """The picture for a target error, colours from 0 to 1."""
        self.mapper.SetTargetError(error)
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 1, pixels, 0)
        return vtk_to_numpy(pixels).reshape(-1, 3) / 255.0


def main():
    """Prints the table and the fit."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=512)
    size = parser.parse_args().size
    generator = np.random.default_rng(5)
    shapes = {"sphere": sphere, "torus": torus,
              "bumps": lambda n, g: sphere(n, g, bumps=0.15), "rough": rough}
    ratios = []
    for name, shape in shapes.items():
        for count in (100_000, 400_000, 1_600_000):
            scene = Scene(*shape(count, generator), size)
            best = scene.draw(1.0 / 256.0)
            covered = (np.abs(best - np.array(BACKGROUND) / 255.0) > 0.01).any(axis=1)
            # At random points the spacing is the root of the area that each has.
            area = 2.0 * covered.sum() * 2.0 / count
            strides = set()
            for error in (1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4):
                picture = scene.draw(error)
                stride = scene.mapper.GetStride()
                if stride == 1 or stride in strides:
                    continue
                strides.add(stride)
                difference = np.sqrt(((picture - best)[covered] ** 2).mean())
                spacing = np.sqrt(area * stride)
                ratio = difference / spacing
                if spacing <= 8.0:
                    ratios.append(ratio)
                print(f"{name:8} {count:8} points, every {stride:3}th: {spacing:5.2f} pixels apart,"
                      f" error {difference:.4f}, per pixel {ratio:.4f}", flush=True)
    print(f"per pixel: median {np.median(ratios):.4f}, greatest {max(ratios):.4f}")


if __name__ == "__main__":
    main()
