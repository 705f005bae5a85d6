# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps of the mapper's settings over scenes, a curve each: defaults must be near each one's best."""
import functools

import pointsplatting

from sweeps.layers import crossing_sheets, hollow, sheets
from sweeps.measures import (
    COUNTS, FRONT, IMAGE_SPACE, TWO_PASSES, Scene, by_method, look, several, simple)
from sweeps.registry import SWEEPS, Stable, Sweep, decades
from sweeps.samplings import non_uniform, position_noise
from sweeps.surfaces import BLUE, RED, box, ellipsoid, torus


def nested(n):
    """Eight translucent shells in one another: sixteen layers."""
    shells = [ellipsoid(3 * (1 - 0.1 * i,), RED if i % 2 else BLUE, 0.2) for i in range(8)]
    return several(shells, n, FRONT)


SCENES = {
    "torus": lambda n: simple(torus(), n),
    "box": lambda n: simple(box((0.6, 0.6, 0.6)), n, look((2, -3, 2.5)), interior=8),
    "sheets 0.05 apart": lambda n: sheets(0.05, n),
    "sheets that cross": lambda n: crossing_sheets(45, n),
    "cavity, wall 0.05": lambda n: hollow(0.05, n, 0.5),
    "10 to 1 sampling": lambda n: non_uniform(10, n),
    "noise": lambda n: position_noise(0.1, n),
    "nested shells": nested,
}


@functools.lru_cache(maxsize=None)
def made(name, method):
    return SCENES[name](COUNTS[method])


def setting(name, title, values, default, scenes, apply, margin=2.0, where=None, method=TWO_PASSES,
            base=None):
    """scenes: a Stable for each scene's name, of no values yet. apply(mapper, value): what is
    swept; values at the default are drawn with it not applied. where(mapper): where on the axis an
    automatic default lies. method: whose number of points. base(mapper): what else is not at its default, as the method."""
    for stable in scenes.values():
        stable.values = [default]

    def measure(scene, value, size):
        def configure(mapper):
            if base:
                base(mapper)
            if value != default:
                apply(mapper, value)
        figures, mappers = made(scene, method).measure(size, configure)
        if where and value == default:
            figures["at"] = where(mappers[0])
        return figures
    SWEEPS[name] = Sweep(name, title, values, scenes, measure, default, margin)


def deferred(mapper):
    mapper.SetMethodToDeferred()


setting("layer_distance", "The least layer distance set by hand; the larger mark is the automatic one.",
        decades(1e-4, 1, 13), 0,
        {"torus": Stable(()), "sheets 0.05 apart": Stable(()), "sheets that cross": Stable((), 12),
         "cavity, wall 0.05": Stable(()), "noise": Stable((), 14), "10 to 1 sampling": Stable(())},
        lambda mapper, value: mapper.SetLayerDistance(value),
        where=lambda mapper: mapper.GetLayerDistanceUsed())
setting("layer_distance_image_space",
        "The same in image space.", decades(1e-4, 1, 13), 0,
        {"torus": Stable(()), "sheets 0.05 apart": Stable((), 14),
         "sheets that cross": Stable((), 20), "cavity, wall 0.05": Stable((), 14),
         "noise": Stable((), 14)},
        lambda mapper, value: mapper.SetLayerDistance(value),
        where=lambda mapper: mapper.GetLayerDistanceUsed(), 
        method=IMAGE_SPACE, base=by_method(IMAGE_SPACE))
setting("radius_scale", "What all radii are multiplied with.", [0.25, 0.5, 0.7, 1, 1.4, 2, 4, 8], 1,
        {"torus": Stable(()), "box": Stable(()), "10 to 1 sampling": Stable(()),
         "noise": Stable((), 14)},
        lambda mapper, value: mapper.SetRadiusScale(value))
setting("kernel_sigma", "The Gaussian's width in radii.", [0.1, 0.2, 0.3, 0.6, 1, 2, 5], 0.6,
        {"torus": Stable(()), "box": Stable(()), "10 to 1 sampling": Stable(()),
         "noise": Stable((), 14)},
        lambda mapper, value: mapper.SetKernelSigma(value))
setting("layers", "The most layers, of sixteen that are there.", [1, 2, 4, 6, 8, 12, 16, 24, 32], 32,
        {"nested shells": Stable(()), "cavity, wall 0.05": Stable(())},
        lambda mapper, value: mapper.SetMaximumNumberOfLayers(int(value)))
setting("overlap_factor", "Deferred blending: the factor c.", [0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1], 0.8,
        {"torus": Stable(()), "box": Stable(()), "noise": Stable((), 14)},
        lambda mapper, value: mapper.SetOverlapFactor(value), base=deferred)
setting("fill_steps", "Image space: how often holes are filled at most.", [1, 2, 3, 4, 8, 16, 64], 2,
        {"torus": Stable(()), "box": Stable(()), "sheets that cross": Stable((), 20),
         "10 to 1 sampling": Stable(())},
        lambda mapper, value: mapper.SetMaximumNumberOfFillSteps(int(value)), 
        method=IMAGE_SPACE, base=by_method(IMAGE_SPACE))


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
    "groups", "Deferred blending: K groups of weighted colouring; the larger mark is what c = 0.8 makes.",
    [1, 2, 3, 4, 6, 8, 12, 16, 24, 32],
    {"torus": Stable([0]), "box": Stable([0]), "noise": Stable([0], 14)}, measure_groups, 0, 2.0)
