# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Casts rays at parts and shades what they cross, all layers of it.

Two-sided: normals are turned to the viewer. Layers are composited front to back. Colour is the mean of
n x n rays a pixel; all else is of the ray through the pixel's centre, so n must be odd.
"""
import concurrent.futures
import os

import numpy as np

from .camera import Camera
from .lighting import Material, lights_of, shade

CHUNK = 1 << 14  # rays at a time: what fits a cache


class Part:
    """A surface, and for each of its parts a vtkProperty."""

    def __init__(self, surface, properties):
        self.surface = surface
        self.materials = [Material(prop) for prop in properties]


class Picture:
    """Row 0 is the lowest. colour [h, w, 3], 0 to 255; covered [h, w]: whether there is anything;
    depth [h, w] before the eye in world units, infinite where there is nothing; normal [h, w, 3] in
    view coordinates, towards the viewer; layers [h, w]: surfaces crossed, hidden ones too;
    shadow [h, w]: the share of the first light that arrives at the nearest surface."""

    def __init__(self, width, height):
        self.colour = np.zeros((height, width, 3))
        self.covered = np.zeros((height, width), bool)
        self.depth = np.full((height, width), np.inf)
        self.normal = np.zeros((height, width, 3))
        self.layers = np.zeros((height, width), int)
        self.shadow = np.ones((height, width))


def cast(parts, camera, origins, directions):
    """All crossings between the clipping planes: depths [n, k], ascending; and for each column of
    `where` [n, k] the number of the part and its column there."""
    tables, owners = [], []
    for part in parts:
        for crossings, material in zip(part.surface.crossings(origins, directions), part.materials):
            t = np.where((crossings.t > camera.near) & (crossings.t < camera.far), crossings.t, np.inf)
            tables.append(t)
            owners += [(crossings, material, k) for k in range(t.shape[1])]
    t = np.concatenate(tables, 1)
    order = np.argsort(t, 1)
    return np.take_along_axis(t, order, 1), order, owners


def trace(parts, camera, lights, shadows, background, pixels, dx, dy):
    """Colours of pixels, 0 to 1, and of the nearest surface: depth, normal, layers, shadow."""
    origins, directions = camera.rays(pixels, dx, dy)
    depths, order, owners = cast(parts, camera, origins, directions)
    n = len(pixels)
    colour = np.zeros((n, 3))
    through = np.ones(n)
    normal = np.zeros((n, 3))
    shadow = np.ones(n)
    for layer in range(depths.shape[1]):
        left = np.isfinite(depths[:, layer]) & (through > 1e-5)
        if not left.any():
            break
        for number in np.unique(order[left, layer]):
            crossings, material, k = owners[number]
            rows = np.flatnonzero(left & (order[:, layer] == number))
            points = origins[rows] + depths[rows, layer, None] * directions[rows]
            normals = crossings.normals(rows, k, points)
            away = np.einsum("ij,ij->i", normals, directions[rows]) > 0
            normals = np.where(away[:, None], -normals, normals)
            view_normals = camera.to_view(normals)
            factors = [1.0] * len(lights)
            if shadows:
                factors = [shadows.factors(parts, light, points, normals, int(pixels[0]))
                           for light in lights]
            shaded = shade(material, lights, camera.points_to_view(points), view_normals, factors)
            colour[rows] += (through[rows] * material.opacity)[:, None] * shaded
            through[rows] *= 1 - material.opacity
            if layer == 0:
                normal[rows] = view_normals
                shadow[rows] = factors[0] if factors else 1.0
    colour += through[:, None] * background
    return colour, depths[:, 0], normal, np.isfinite(depths).sum(1), shadow


def render(parts, renderer, width, height, supersampling=3, shadows=None):
    """The truth of parts as a vtkRenderer's camera, lights and background show them: a Picture."""
    if supersampling % 2 == 0:
        raise ValueError("supersampling must be odd, for one ray to go through the centre")
    camera = Camera(renderer.GetActiveCamera(), width, height)
    lights = lights_of(renderer, camera)
    background = np.array(renderer.GetBackground())
    picture = Picture(width, height)
    colour = picture.colour.reshape(-1, 3)

    def work(pixels):
        for i in range(supersampling):
            for j in range(supersampling):
                dx, dy = ((k + 0.5) / supersampling - 0.5 for k in (i, j))
                got = trace(parts, camera, lights, shadows, background, pixels, dx, dy)
                colour[pixels] += 255 * got[0] / supersampling ** 2
                if i == j == supersampling // 2:
                    picture.depth.reshape(-1)[pixels] = got[1]
                    picture.covered.reshape(-1)[pixels] = np.isfinite(got[1])
                    picture.normal.reshape(-1, 3)[pixels] = got[2]
                    picture.layers.reshape(-1)[pixels] = got[3]
                    picture.shadow.reshape(-1)[pixels] = got[4]

    chunks = np.array_split(np.arange(width * height), max(1, width * height // CHUNK))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(work, chunks))
    return picture
