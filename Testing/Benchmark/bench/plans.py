# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which cells are measured: scenes, points, sizes and settings, for a look, minutes or an hour."""
from scenes import orbital_scene, shadow_scene, spheres_scene, torus_scene

from .settings import OPAQUE, TRANSLUCENT, layered, shadowed

ORBITAL_OPACITIES = (0.3, 0.5, 1.0)
PEELED_SPHERES = 8  # nested: 15 layers


class Plan:
    """points, size: those of the charts of error over time. point_counts, sizes: of the sweeps, of
    points at that size and of sizes at that number of points. which: how many scenes are swept,
    SMOKE (one, and few others are there), SOME or ALL. runs: frames of each setting. limit_ms: frames
    expected to take longer are not drawn; cell_ms: a cell that took longer than this draws no more
    than three frames of each setting. all_errors: whether errors are found at every size. minutes:
    after these no further cell is begun; 0: all are."""

    SMOKE, SOME, ALL = range(3)

    def __init__(self, which, points, size, point_counts, sizes, layers, samples, runs,
                 supersampling, shadow_samples, limit_ms, cell_ms, all_errors, minutes=0):
        self.which, self.points, self.size = which, points, size
        self.point_counts, self.sizes = point_counts, sizes
        self.layers, self.samples, self.runs = layers, samples, runs
        self.supersampling, self.shadow_samples = supersampling, shadow_samples
        self.limit_ms, self.cell_ms, self.all_errors = limit_ms, cell_ms, all_errors
        self.minutes = minutes

    def cells(self):
        """(scene, points, size, settings), each once; those of a scene and number of points one
        after the other, by size."""
        torus, orbital = torus_scene(), orbital_scene((1, 1, 1), "orbital")
        close = torus_scene(4.0, "torus, close-up")
        translucent = orbital_scene(ORBITAL_OPACITIES, "orbital, translucent")
        peeled, shadows = spheres_scene(PEELED_SPHERES, 0.2, "spheres, translucent"), shadow_scene()
        here = [(self.points, self.size)]
        points = [(count, self.size) for count in self.point_counts]
        sizes = [(self.points, size) for size in self.sizes]
        every = points + sizes
        some, few = (every, every) if self.which == Plan.ALL else (points, here)
        peeling = TRANSLUCENT + layered(self.layers)
        shaded = shadowed(self.samples, shadows.light_radius)
        wanted = [(torus, every, OPAQUE), (peeled, few, peeling), (shadows, few, shaded)]
        if self.which != Plan.SMOKE:
            wanted[1:1] = [(orbital, some, OPAQUE), (translucent, some, TRANSLUCENT),
                           (close, few, OPAQUE)]
        for scene, places, settings in wanted:
            for count, size in sorted({*places, *here}):
                yield scene, count, size, settings


PLANS = {
    "quick": Plan(Plan.SOME, points=160000, size=512, point_counts=(10000, 40000, 160000, 640000),
                  sizes=(256, 512, 768, 1024), layers=(1, 2, 4, 8, 12), samples=(1, 4, 16),
                  runs=5, supersampling=3, shadow_samples=16, limit_ms=5000, cell_ms=12000,
                  all_errors=False),
    "full": Plan(Plan.ALL, points=640000, size=1024,
                 point_counts=(10000, 40000, 160000, 640000, 2500000, 6000000),
                 sizes=(512, 768, 1024, 1536, 2048), layers=(1, 2, 4, 8, 12),
                 samples=(1, 4, 16, 64), runs=9, supersampling=3, shadow_samples=64,
                 limit_ms=20000, cell_ms=40000, all_errors=True, minutes=60),
    "smoke": Plan(Plan.SMOKE, points=4000, size=96, point_counts=(1000, 4000), sizes=(64, 96),
                  layers=(1, 2, 4), samples=(1, 4), runs=2, supersampling=1, shadow_samples=4,
                  limit_ms=2000, cell_ms=500, all_errors=True),
}
