# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of splats and meshes: pictures, likeness, and times taken in turn."""
import statistics

import numpy as np
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
import pointsplatting

import measures
from drawing import Drawing, window
from scenes import BACKGROUND, Scene

PEELS = 30
MODEL = (([-1.25] * 3, [1.25] * 3))  # bounds of clouds.body_mesh


class Plan:
    """How much is done: all of it, or next to nothing, for a test."""

    def __init__(self, quick, files=()):
        self.quick, self.files = quick, files

    def size(self, pixels):
        return max(64, pixels // 8) if self.quick else pixels

    def points(self, count):
        return max(600, count // 60) if self.quick else count

    def runs(self, count):
        return 1 if self.quick else count


class Frame(Drawing):
    """In one window with all others."""
    window_of_all = None

    def __init__(self, view, mappers, size, peels=None):
        if Frame.window_of_all is None:
            Frame.window_of_all = window(size, size)
        super().__init__(view, mappers, size, peels, Frame.window_of_all)


def scene(opacities, bounds, zoom=1.4):
    """A view from above and beside, and properties; nothing for the reference renderer."""
    return Scene("", [], None, opacities, bounds, zoom=zoom)


def splat_mapper(data, *calls):
    """calls: methods of the mapper with their arguments."""
    mapper = pointsplatting.vtkPointSplatMapper()
    mapper.SetInputData(data)
    mapper.SetMaximumImageMemory(0)
    for method, *arguments in calls:
        getattr(mapper, method)(*arguments)
    return mapper


def mesh_mapper(mesh):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    return mapper


def splat_drawing(view, clouds, size, *calls):
    return Frame(view, [splat_mapper(cloud, *calls) for cloud in clouds], size)


def mesh_drawing(view, meshes, size):
    return Frame(view, [mesh_mapper(mesh) for mesh in meshes], size,
                 PEELS if view.translucent else None)


def mesh_truth(view, meshes, size, samples=3):
    """The mesh's picture of a larger window, averaged."""
    drawing = mesh_drawing(view, meshes, samples * size)
    picture = drawing.draw().reshape(size, samples, size, samples, 3).mean((1, 3))
    drawing.close()
    return picture


def picture_of(view, clouds, size, *calls):
    drawing = splat_drawing(view, clouds, size, *calls)
    picture = drawing.draw()
    drawing.close()
    return picture


def likeness(picture, truth):
    """psnr in dB where either shows anything."""
    background = 255 * np.array(BACKGROUND)
    shown = [np.abs(one - background).max(2) > 2 for one in (picture, truth)]
    return measures.psnr(picture, truth, shown[0] | shown[1])


def difference(picture, truth, gain=8):
    """Grey where they are alike, brighter or darker by so many times the difference."""
    return np.clip(128 + gain * (picture - truth), 0, 255)


def crop(picture, share=0.3, centre=(0.5, 0.5), grown=3):
    """A part of a picture, its pixels enlarged."""
    size = picture.shape[0]
    half = max(4, round(share * size / 2))
    rows, columns = (min(max(half, round(c * size)), size - half) for c in centre)
    part = picture[rows - half:rows + half, columns - half:columns + half]
    return part.repeat(grown, 0).repeat(grown, 1)


def medians(drawings, runs, degrees=3, before=None):
    """Milliseconds of frames by name, each from another side, all taken in turn. before: called
    with each drawing before each frame."""
    times = {name: [] for name in drawings}
    for run in range(runs + 1):
        for name, drawing in drawings.items():
            drawing.turn(degrees)
            if before:
                before(drawing)
            drawing.draw()
            if run:  # shaders were compiled and points uploaded before
                times[name].append(drawing.milliseconds)
    return {name: statistics.median(ms) for name, ms in times.items()}


def closed(drawings):
    for drawing in drawings.values():
        drawing.close()
