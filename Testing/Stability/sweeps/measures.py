# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of splats and of meshes, and how much they differ."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
import pointsplatting

from sweeps.surfaces import Surface, cloud, random

# Along a pixel's side, of the mesh that counts as the truth; wide windows get that mesh as it is.
SAMPLES, WIDE = 3, 1024
PERFECT = 99.0  # dB, where there is no difference
TWO_PASSES, IMAGE_SPACE, QUADS = "two passes", "image space", "two passes by quads"
# Points of a body in the middle of the picture; image space is for those denser than pixels.
COUNTS = {TWO_PASSES: 20000, IMAGE_SPACE: 200000, QUADS: 20000}


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


FRONT = look((0, 0, 4.2))
# Of plates: no border is in sight.
NEAR = look((0, -0.7, 0.8), up=(0, 0, 1))


class Window:
    """One for all pictures, so that shaders are compiled once."""
    shared = None

    @classmethod
    def of(cls, size):
        if cls.shared is None:
            cls.shared = pointsplatting.vtkEGLHeadlessRenderWindow()
            cls.shared.SetMultiSamples(0)
        cls.shared.SetSize(size, size)
        return cls.shared


def picture(parts, camera, size, lights=()):
    """parts: (mapper, surface, offset). Rows of RGB, black where nothing is drawn."""
    window = Window.of(size)
    renderer = vtkRenderer()
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(10)
    renderer.SetOcclusionRatio(0.0)
    for light in lights:
        renderer.AddLight(light)
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
    window.RemoveRenderer(renderer)
    return vtk_to_numpy(pixels).reshape(size, size, 3)


def shrink(mask, pixels):
    for _ in range(pixels):
        padded = np.pad(mask, 1, constant_values=True)
        mask = (padded[1:-1, 1:-1] & padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] &
                padded[1:-1, 2:])
    return mask


def psnr(a, b):
    difference = np.subtract(a, b, dtype=np.float32).ravel()
    square = np.dot(difference, difference) / difference.size / 255.0 ** 2
    return min(PERFECT, -10 * math.log10(max(square, 1e-12)))


class Truth:
    """The picture of meshes, supersampled, and what of it is covered; how near they come to it
    themselves without."""

    def __init__(self, surfaces, camera, size, interior):
        parts = []
        for surface in surfaces:
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(surface.mesh)
            parts.append((mapper, surface, (0, 0, 0)))
        n = SAMPLES if size <= WIDE else 1
        fine = picture(parts, camera, n * size)
        shares = [fine[i::n, j::n] for i in range(n) for j in range(n)]
        self.picture = (fine if n == 1 else
                        sum(share.astype(np.float32) for share in shares) / len(shares))
        covered = sum((share.max(2) > 0).astype(int) for share in shares)
        self.any, whole = covered > 0, covered == len(shares)
        self.inside, self.outside = shrink(whole, 2), shrink(~self.any, 2)
        self.judged = shrink(whole, interior) if interior else np.ones_like(self.any)
        if not self.judged.any():
            self.judged = np.ones_like(self.any)
        self.mesh = PERFECT if n == 1 else psnr(
            picture(parts, camera, size)[self.judged], self.picture[self.judged])


class Scene:
    """surfaces: with data, a vtkPolyData of points each. offset: the data lie this much off, and the
    actors bring them back. interior: only what lies so many pixels inside counts for psnr, since at
    borders splats reach over, whatever else happens."""

    def __init__(self, surfaces, data, camera=FRONT, offset=(0, 0, 0), interior=0):
        self.surfaces, self.data, self.camera = surfaces, data, camera
        self.offset, self.interior = offset, interior
        self.truths = {}

    def truth(self, size):
        if size not in self.truths:
            self.truths[size] = Truth(self.surfaces, self.camera, size, self.interior)
        return self.truths[size]

    def draw(self, size, configure):
        """The picture, and the mappers that made it."""
        parts = []
        for surface, points in zip(self.surfaces, self.data):
            mapper = pointsplatting.vtkPointSplatMapper()
            mapper.SetInputData(points)
            configure(mapper)
            parts.append((mapper, surface, tuple(-x for x in self.offset)))
        return picture(parts, self.camera, size), [mapper for mapper, *_ in parts]

    def measure(self, size, configure):
        """The figures, and the mappers."""
        truth = self.truth(size)
        drawn, mappers = self.draw(size, configure)
        is_drawn = drawn.max(2) > 0
        return {
            "psnr": psnr(drawn[truth.judged], truth.picture[truth.judged]),
            "mesh": truth.mesh,
            "holes": float((truth.inside & ~is_drawn).sum() / max(1, truth.inside.sum())),
            "leaks": float((truth.outside & is_drawn).sum() / max(1, truth.any.sum())),
        }, mappers


def simple(surface, n, camera=FRONT, **more):
    """One surface by n points at random."""
    return Scene([surface], [cloud(*surface.draw(n, random()))], camera, **more)


def several(surfaces, n, camera=FRONT, **more):
    """n points of each surface, each in an actor of its own."""
    data = [cloud(*surface.draw(n, random(seed))) for seed, surface in enumerate(surfaces)]
    return Scene(surfaces, data, camera, **more)


def merged(surfaces, n, camera=FRONT, **more):
    """n points of each surface, all in one actor, with the first one's properties."""
    parts = [surface.draw(n, random(seed)) for seed, surface in enumerate(surfaces)]
    append = vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface.mesh)
    append.Update()
    first = surfaces[0]
    whole = Surface(append.GetOutput(), None, first.colour, first.opacity)
    return Scene([whole], [cloud(*(np.concatenate(part) for part in zip(*parts)))], camera, **more)


def by_method(name):
    """What gives a mapper the method of that name."""
    def configure(mapper):
        if name == IMAGE_SPACE:
            mapper.SetMethodToImageSpace()
        if name == QUADS:
            mapper.SetProjectionToQuads()
    return configure
