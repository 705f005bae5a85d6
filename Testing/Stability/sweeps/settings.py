# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of the mapper's settings over scenes, a curve each: defaults must be near each one's best."""
import functools

import pointsplatting

from sweeps.layers import crossing_sheets, hollow, sheets, sheets_in_one, thin_wall
from sweeps.measures import (
    COUNTS, FRONT, IMAGE_SPACE, TWO_PASSES, Scene, by_method, look, several, simple)
from sweeps.registry import SWEEPS, Stable, Sweep, coarse, decades, unasked
from sweeps.samplings import non_uniform, position_noise
from sweeps.surfaces import BLUE, RED, box, ellipsoid, torus


def nested(n):
    """Four translucent shells in one another: eight layers."""
    shells = [ellipsoid(3 * (1 - 0.2 * i,), RED if i % 2 else BLUE, 0.3) for i in range(4)]
    return several(shells, n, FRONT)


SCENES = {
    "torus": lambda n: simple(torus(), n),
    "box": lambda n: simple(box((0.6, 0.6, 0.6)), n, look((2, -3, 2.5)), interior=8),
    "sheets 0.05 apart": lambda n: sheets(0.05, n),
    "sheets in one": lambda n: sheets_in_one(0.05, n),
    "sheets that cross": lambda n: crossing_sheets(45, n),
    "wall of 0.01": lambda n: thin_wall(0.01, n),
    "cavity, wall 0.05": lambda n: hollow(0.05, n, 0.5),
    "10 to 1 sampling": lambda n: non_uniform(10, n),
    "noise": lambda n: position_noise(0.1, n),
    "nested shells": nested,
}


@functools.lru_cache(maxsize=None)
def made(name, method):
    return SCENES[name](COUNTS[method])


# With all settings at their defaults: the figures and the mappers.
DEFAULTS = {}


def setting(name, title, values, default, scenes, apply, margin=2.0, where=None, method=TWO_PASSES,
            base=None):
    """scenes: a Stable for each scene's name, of no values yet. apply(mapper, value): what is
    swept; values at the default are drawn with it not applied. where(mapper): where on the axis an
    automatic default lies. method: whose number of points. base(mapper): what else is not at its
    default, as the method."""
    for stable in scenes.values():
        stable.values = [default]

    def measure(scene, value, size):
        def configure(mapper):
            if base:
                base(mapper)
            if value != default:
                apply(mapper, value)
        if value == default and (scene, method, base, size) in DEFAULTS:
            figures, mappers = DEFAULTS[scene, method, base, size]
        else:
            figures, mappers = made(scene, method).measure(size, configure)
            if value == default:
                DEFAULTS[scene, method, base, size] = figures, mappers
        if where and value == default:
            figures = {**figures, "at": where(mappers[0])}
        return figures
    SWEEPS[name] = Sweep(name, title, values, scenes, measure, default, margin)


image_space = by_method(IMAGE_SPACE)


def deferred(mapper):
    mapper.SetMethodToDeferred()


setting("layer_distance", "least layer distance by hand; marks: the automatic one",
        decades(1e-4, 1, 13), 0,
        {"torus": Stable(), "wall of 0.01": Stable(), "sheets that cross": Stable(gap=12),
         "sheets in one": Stable(), "cavity, wall 0.05": Stable(), "noise": Stable(gap=14),
         "10 to 1 sampling": Stable()},
        lambda mapper, value: mapper.SetLayerDistance(value),
        where=lambda mapper: mapper.GetLayerDistanceUsed())
setting("layer_distance_image_space",
        "least layer distance by hand; marks: the automatic one", decades(1e-4, 1, 13), 0,
        {"torus": coarse(), "sheets 0.05 apart": coarse(),
         "sheets that cross": coarse(), "cavity, wall 0.05": coarse(), "noise": coarse()},
        lambda mapper, value: mapper.SetLayerDistance(value),
        where=lambda mapper: mapper.GetLayerDistanceUsed(),
        method=IMAGE_SPACE, base=image_space)
setting("radius_scale", "factor on all radii; marks: the default",
        [0.25, 0.5, 0.7, 1, 1.4, 2, 4, 8], 1,
        {"torus": Stable(), "box": unasked(), "10 to 1 sampling": Stable(),
         "noise": Stable(gap=14)},
        lambda mapper, value: mapper.SetRadiusScale(value))
setting("kernel_sigma", "the Gaussian's width in radii; marks: the default",
        [0.1, 0.2, 0.3, 0.6, 1, 2, 5], 0.6,
        {"torus": Stable(), "box": unasked(), "10 to 1 sampling": Stable(),
         "noise": Stable(gap=14)},
        lambda mapper, value: mapper.SetKernelSigma(value))
setting("layers", "most layers, of eight and four that are there",
        [1, 2, 3, 4, 5, 6, 7, 8, 16, 32], 32,
        {"nested shells": Stable(), "cavity, wall 0.05": Stable()},
        lambda mapper, value: mapper.SetMaximumNumberOfLayers(int(value)))
setting("overlap_factor", "deferred blending: the factor c; marks: the default",
        [0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1], 0.8,
        {"torus": Stable(), "box": unasked(), "wall of 0.01": Stable(), "noise": Stable(gap=14)},
        lambda mapper, value: mapper.SetOverlapFactor(value), base=deferred)
# Each step closes wider holes and blurs silhouettes: what has no holes would do with one.
setting("fill_steps", "image space: fill steps at most; marks: the default",
        [1, 2, 3, 4, 8, 16, 64], 2,
        {"torus": coarse(), "box": unasked(), "sheets that cross": coarse(),
         "10 to 1 sampling": coarse(gap=16)},
        lambda mapper, value: mapper.SetMaximumNumberOfFillSteps(int(value)), margin=4.0,
        method=IMAGE_SPACE, base=image_space)


def grouped(scene, groups):
    """The scene with its splats in so many groups; 0: as many as the mapper makes."""
    if not groups:
        return scene
    data = []
    for points in scene.data:
        grouping = pointsplatting.vtkPointSplatGrouping()
        grouping.SetInputData(points)
        grouping.SetColoringToWeighted()
        grouping.SetWantedNumberOfGroups(int(groups))
        grouping.Update()
        data.append(grouping.GetOutput())
    return Scene(scene.surfaces, data, scene.camera, scene.offset, scene.interior)


def measure_groups(scene, value, size):
    figures, mappers = grouped(made(scene, TWO_PASSES), value).measure(size, deferred)
    if not value:
        figures["at"] = mappers[0].GetNumberOfGroups()
    return figures


SWEEPS["groups"] = Sweep(
    "groups", "deferred blending: K groups; marks: what c = 0.8 makes",
    [1, 2, 3, 4, 6, 8, 12, 16, 24, 32],
    {"torus": Stable([0]), "box": unasked(), "noise": Stable([0], 14)}, measure_groups, 0, 2.0)
