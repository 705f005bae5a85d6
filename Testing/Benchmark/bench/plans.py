# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which cells are measured: scenes, points, sizes and settings, for a look, minutes or an hour."""
from scenes import orbital_scene, shadow_scene, spheres_scene, torus_scene

from .settings import OPAQUE, TRANSLUCENT, layered, shadowed

ORBITAL_OPACITIES = (0.3, 0.5, 1.0)
PEELED_SPHERES = 8  # nested: 15 layers


class Plan:
    """points, size: those of the charts of error over time. point_counts, sizes: of the sweeps, of
    points at that size and of sizes at that number of points; which: how many scenes are swept,
    SMOKE (one, and few others at all), SOME or ALL. limit_ms: longer frames are not begun; cell_ms:
    longer than this no cell takes its frames, but for three of each setting."""

    SMOKE, SOME, ALL = range(3)

    def __init__(self, which, points, size, point_counts, sizes, layers, samples, runs,
                 supersampling, shadow_samples, limit_ms, cell_ms):
        self.which, self.points, self.size = which, points, size
        self.point_counts, self.sizes = point_counts, sizes
        self.layers, self.samples, self.runs = layers, samples, runs
        self.supersampling, self.shadow_samples = supersampling, shadow_samples
        self.limit_ms, self.cell_ms = limit_ms, cell_ms

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
        some = every if self.which == Plan.ALL else points
        peeling, shaded = TRANSLUCENT + layered(self.layers), shadowed(self.samples)
        wanted = [(torus, every, OPAQUE), (peeled, here, peeling), (shadows, here, shaded)]
        if self.which != Plan.SMOKE:
            wanted[1:1] = [(orbital, some, OPAQUE), (translucent, every, TRANSLUCENT),
                           (close, here if self.which == Plan.SOME else every, OPAQUE)]
        for scene, places, settings in wanted:
            for count, size in sorted({*places, *here}):
                yield scene, count, size, settings


PLANS = {
    "quick": Plan(Plan.SOME, 160000, 512, (10000, 40000, 160000, 640000),
                  (256, 384, 512, 768, 1024), (1, 2, 4, 8, 12), (1, 4, 16), 5, 3, 16, 4000, 20000),
    "full": Plan(Plan.ALL, 640000, 1024, (10000, 40000, 160000, 640000, 2500000, 6000000),
                 (512, 768, 1024, 1536, 2048), (1, 2, 4, 8, 12), (1, 4, 16, 64), 9, 3, 64, 20000, 40000),
    "smoke": Plan(Plan.SMOKE, 4000, 96, (1000, 4000), (64, 96), (1, 2, 4), (1, 4), 2, 1, 4, 2000, 500),
}
