# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes by which the automatic choices are judged. No constant is fitted to any of them: the fit has
the clouds of shapes.py."""
import numpy as np

from scenes import Scene, orbital_scene, polydata

KNOT_TUBE = 0.28
SHADOW_LIGHT = (2.5, -1.5, 5.0)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1)[:, None]


def knot(count, seed=3):
    """Random points on a tube along the trefoil knot."""
    generator = np.random.default_rng(seed)
    s, t = generator.uniform(0.0, 2.0 * np.pi, (2, count))

    def curve(s):
        return np.stack([np.sin(s) + 2.0 * np.sin(2.0 * s), np.cos(s) - 2.0 * np.cos(2.0 * s),
                         -np.sin(3.0 * s)], 1) / 2.2

    step = 1e-4
    along = unit(curve(s + step) - curve(s - step))
    bend = curve(s + step) - 2.0 * curve(s) + curve(s - step)
    side = unit(bend - (bend * along).sum(1)[:, None] * along)
    normals = np.cos(t)[:, None] * side + np.sin(t)[:, None] * np.cross(along, side)
    return polydata(curve(s) + KNOT_TUBE * normals, normals)


def ellipsoid(count, scale, seed):
    """Random points, denser where it bends more."""
    axes = scale * np.array([1.3, 0.9, 0.6])
    on_ball = unit(np.random.default_rng(seed).normal(size=(count, 3)))
    return polydata(on_ball * axes, unit(on_ball / axes))


def dunes(count, seed=4):
    """A square of hills, which ends at its sides."""
    x, y = np.random.default_rng(seed).uniform(-1.6, 1.6, (2, count))
    a, b = 2.3 * x + 0.7 * y, 3.1 * y - 1.1 * x
    normals = np.stack([-0.15 * (2.3 * np.cos(a) * np.cos(b) + 1.1 * np.sin(a) * np.sin(b)),
                        -0.15 * (0.7 * np.cos(a) * np.cos(b) - 3.1 * np.sin(a) * np.sin(b)),
                        np.ones(count)], 1)
    return polydata(np.stack([x, y, 0.15 * np.sin(a) * np.cos(b)], 1), unit(normals))


def knot_scene(name="knot", opacity=1.0, zoom=1.4):
    return Scene(name, [], lambda count: [knot(count)], [opacity],
                 ([-1.7, -1.7, -0.8], [1.7, 1.7, 0.8]), zoom=zoom)


def dunes_scene():
    return Scene("dunes", [], lambda count: [dunes(count)], [1.0], ([-1.6] * 3, [1.6] * 3))


def shells_scene(layers, opacity):
    """Nested ellipsoids, the innermost opaque."""
    scales = np.linspace(1.0, 0.4, layers)
    shares = scales ** 2 / (scales ** 2).sum()
    return Scene(f"{layers} ellipsoids", [],
                 lambda count: [ellipsoid(round(count * share), scale, seed)
                                for seed, (share, scale) in enumerate(zip(shares, scales))],
                 [opacity] * (layers - 1) + [1.0], ([-1.3] * 3, [1.3] * 3))


def shadows_scene():
    """A knot over dunes, lit from the side."""
    def clouds(count):
        floor = dunes(count // 2)
        data = knot(count // 2)
        points = data.GetPoints()
        for i in range(points.GetNumberOfPoints()):
            x, y, z = points.GetPoint(i)
            points.SetPoint(i, 0.5 * x, 0.5 * y, 0.5 * z + 0.8)
        return [floor, data]
    return Scene("knot over dunes", [], clouds, [1.0, 1.0], ([-1.6, -1.6, -0.2], [1.6, 1.6, 1.2]),
                 light=SHADOW_LIGHT, light_radius=0.3)


def scenes():
    """(scene, points, pixels a side, what is tried)"""
    opacities = (0.3, 0.5, 1.0)
    for points in (20000, 160000, 640000):
        yield knot_scene(), points, 384, "opaque"
    yield knot_scene(), 160000, 768, "opaque"
    yield knot_scene("knot, close-up", zoom=4.0), 160000, 384, "opaque"
    yield dunes_scene(), 320000, 384, "opaque"
    yield orbital_scene((1, 1, 1), "orbital"), 320000, 384, "opaque"
    yield orbital_scene((1, 1, 1), "orbital, quads only"), 160000, 384, "quads"
    for points in (40000, 320000):
        yield orbital_scene(opacities, "orbital, translucent"), points, 384, "translucent"
    yield shells_scene(8, 0.2), 80000, 384, "translucent"
    yield shells_scene(3, 0.4), 80000, 384, "translucent"
    yield knot_scene("knot, translucent", opacity=0.5), 80000, 384, "translucent"
    yield shadows_scene(), 40000, 384, "shadows"
