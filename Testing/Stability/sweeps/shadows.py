# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of shadow textures: a ball over a plane, against rays to the light."""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight
import pointsplatting

from sweeps.measures import PERFECT, look, picture, psnr
from sweeps.registry import SWEEPS, Stable, Sweep, decades
from sweeps.surfaces import Surface, cloud, jittered, random, sphere_points

COUNT = 40000
RADIUS, HEIGHT = 0.3, 0.5  # of the ball, and of its centre over the plane z = 0


def direction(elevation):
    """To the light."""
    a = math.radians(elevation)
    return np.array((math.cos(a) * 0.8, math.cos(a) * 0.6, math.sin(a)))


def points():
    """Of the plane and of the ball, and of these those that are the ball's."""
    x, y = jittered(0.75 * COUNT, random(1))
    q, m = sphere_points(COUNT // 4, random(2))
    p = np.concatenate([np.stack([x, y, 0 * x], 1), RADIUS * q + (0, 0, HEIGHT)])
    n = np.concatenate([np.tile((0.0, 0.0, 1.0), (len(x), 1)), m])
    return p, n, np.arange(len(p)) >= len(x)


def exact(p, ball, light):
    """Of each point: whether light reaches it, and how far it is from the edge of the shadow."""
    to = p - (0, 0, HEIGHT)
    along = to @ light
    off = np.linalg.norm(to - along[:, None] * light, axis=1)
    # The ball shadows its own far side, from the terminator on.
    lit = np.where(ball, along > 0, ~((off < RADIUS) & (along < 0)))
    edge = np.where(ball, abs(along), np.where(along < 0, abs(off - RADIUS), np.inf))
    return lit, edge


def measure(elevation, size, apply):
    """psnr: of splats with the shadows against the same splats with exact ones. holes: the share
    of lit points told to be in the shadow; leaks: of shadowed ones told to be lit; both farther than
    a spacing from edges, and not of what faces away, which gets no light anyway."""
    p, n, ball = points()
    light = direction(elevation)
    data = cloud(p, n)
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.PositionalOff()
    lamp.SetPosition(*(10 * light))
    lamp.SetFocalPoint(0, 0, 0)
    texture = pointsplatting.vtkPointShadowTexture()
    texture.SetInputData(data)
    texture.AddLight(lamp)
    apply(texture)
    texture.Update()
    found = texture.GetOutput()
    factor = vtk_to_numpy(found.GetPointData().GetArray("ShadowFactor")).ravel()
    lit, edge = exact(p, ball, light)
    faces = n @ light > 0
    sure = faces & (edge > 2.0 / math.sqrt(0.75 * COUNT))
    right = found.NewInstance()
    right.ShallowCopy(found)
    array = numpy_to_vtk(lit.astype(np.float32), deep=1)
    array.SetName("ShadowFactor")
    right.GetPointData().AddArray(array)
    pictures = []
    for shadowed in (found, right):
        mapper = pointsplatting.vtkPointSplatMapper()
        mapper.SetInputData(shadowed)
        surface = Surface(None, None)
        pictures.append(picture([(mapper, surface, (0, 0, 0))],
                                look((0.5, -3.2, 2.2), (0, 0, 0.2), up=(0, 0, 1)), size, [lamp]))
    return {
        "psnr": psnr(*pictures), "mesh": PERFECT,
        "holes": float((sure & lit & (factor < 0.5)).sum() / max(1, (sure & lit).sum())),
        "leaks": float((sure & ~lit & (factor >= 0.5)).sum() / max(1, (sure & ~lit).sum())),
    }, texture


def shadow_sweep(name, title, values, default, stable, measured, margin=None):
    """measured(value, size): figures and the filter."""
    SWEEPS[name] = Sweep(name, title, values, {"directional light": stable}, measured, default, margin)


def by_setting(apply, where):
    def measured(_, value, size):
        def configure(texture):
            if value:
                apply(texture, value)
        figures, texture = measure(40, size, configure)
        if not value:
            figures["at"] = where(texture)
        return figures
    return measured


SHADOWED = {"holes": 0.001, "leaks": 0.001, "enough": 30}
shadow_sweep(
    "shadow_layer_distance",
    "shadow test's least layer distance (bias); mark: automatic",
    decades(1e-4, 1, 13), 0, Stable([0], **SHADOWED),
    by_setting(lambda texture, value: texture.SetLayerDistance(value),
               lambda texture: texture.GetLayerDistanceUsed()), 2.0)
shadow_sweep(
    "shadow_resolution",
    "the shadow map's pixels along a side; mark: automatic",
    [16, 32, 64, 128, 256, 512, 1024, 2048, 4096], 0, Stable([0], **SHADOWED),
    by_setting(lambda texture, value: texture.SetResolution(int(value)),
               lambda texture: texture.GetResolutionUsed()), 2.0)
shadow_sweep(
    "light_grazing", "the light's elevation over a plane, degrees",
    [80, 60, 40, 20, 10, 5, 3, 2, 1], None, Stable([60, 10], **SHADOWED),
    lambda _, value, size: measure(value, size, lambda texture: None)[0])
