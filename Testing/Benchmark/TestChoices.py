# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the mapper chooses by itself keeps to its target error, and takes less time where that allows
it to draw fewer splats, layers or samples. Times are of the processors, and of this process.

TestChoices.py, with the package pointsplatting to be found.
"""
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from bench import choosing  # noqa: E402
from bench.cloud import Cloud  # noqa: E402
from reference import Spheres  # noqa: E402
from scenes import (  # noqa: E402
    Scene, orbital_scene, shadow_scene, sphere_mesh, torus_scene)


class TestChoices(unittest.TestCase):
    def chosen(self, scene, count, size, settings, extra=(), runs=2):
        """By the mapper, for each target; and rows of other settings."""
        tried = settings + [choosing.automatic(target, settings[0].kind, extra)
                            for target in choosing.TARGETS]
        rows = choosing.measured(scene, Cloud(scene, count), size, tried, runs)
        for target, row in zip(choosing.TARGETS, rows[-3:]):
            with self.subTest(scene.name, target=target):
                self.assertLessEqual(row["error"], target)
        return rows

    def strides(self, rows, least):
        """All splats where one is expected; else no more of them than one of so many."""
        strides = [row["did"][5] for row in rows]
        self.assertEqual([stride > 1 for stride in strides], [stride > 1 for stride in least])
        self.assertTrue(all(a >= b for a, b in zip(strides, least)), strides)

    def test_opaque(self):
        """Many splats to a pixel: one of many takes half of the time, coarser levels too."""
        rows = self.chosen(torus_scene(), 160000, 256, choosing.OPAQUE[:1], runs=5)
        best, _, _, rough = rows
        self.strides(rows, [1, 1, 1, 16])
        self.assertLess(rough["ms"], 0.7 * best["ms"])
        rows = self.chosen(torus_scene(), 640000, 256, choosing.OPAQUE[:1], runs=5)
        best, _, _, rough = rows
        self.strides(rows, [1, 1, 1, 1])
        self.assertIn("stand for others", rough["choices"])
        self.assertLess(rough["ms"], 0.7 * best["ms"])

    def test_sparse(self):
        rows = self.chosen(torus_scene(4.0), 4000, 256, choosing.OPAQUE[:1])
        self.strides(rows, 4 * [1])
        self.assertEqual([row["did"][0] for row in rows], 4 * ["two-pass"])

    def test_translucent(self):
        """Few splats, and no layers that hardly show, take half the time."""
        rows = self.chosen(orbital_scene((0.3, 0.5, 1.0), "orbital"), 160000, 256,
                           choosing.TRANSLUCENT[:1], runs=5)
        best, _, fair, rough = rows
        self.assertEqual([row["did"][2] for row in rows], 4 * ["peeling"])
        self.strides(rows, [1, 1, 2, 8])
        self.assertLess(fair["did"][6], best["did"][6])
        self.assertLess(rough["did"][6], fair["did"][6])
        self.assertLess(rough["ms"], 0.8 * best["ms"])

    def test_crowded(self):
        """Shells nearer to each other than the splats that are left are wide."""
        radii = [1 - 0.02 * k for k in range(4)]
        shells = Scene("shells", [Spheres(radii)],
                       lambda count: [sphere_mesh(count / 4, radius) for radius in radii],
                       4 * [0.2], ([-1] * 3, [1] * 3))
        rows = self.chosen(shells, 200000, 192, choosing.TRANSLUCENT[:1])
        self.strides(rows, [1, 1, 1, 8])

    def test_bright_shadows(self):
        """On white one sample, which does for the colours of the scene, might have an error of 0.046."""
        scene = shadow_scene()
        for prop in scene.properties:
            prop.SetColor(1, 1, 1)
            prop.SetAmbient(0)
            prop.SetDiffuse(1)
            prop.SetSpecular(0)
        rows = self.chosen(scene, 4000, 128, choosing.SHADED[:1],
                           choosing.shadows(choosing.SAMPLES, (choosing.TWO_PASS,)))
        self.assertEqual([row["did"][4] for row in rows], [16, 16, 9, 1])

    def test_shadows(self):
        rows = self.chosen(shadow_scene(), 4000, 128, choosing.SHADED[:1],
                           choosing.shadows(choosing.SAMPLES))
        self.assertEqual([row["did"][4] for row in rows], [16, 15, 1, 1])

    def test_verdict(self):
        """The fastest that keeps to the target counts; doing the same is no miss."""
        def row(name, error, ms, did):
            return dict(setting=name, error=error, ms=ms, did=did)

        by_hand = [row("best", 0.0, 100, "two"), row("rough", 0.01, 20, "image")]
        first, second = choosing.judged(
            by_hand + [row("a", 0.0, 130, "two"), row("b", 0.0, 101, "two")], (1 / 256, 1 / 64))
        self.assertEqual((first["fastest"]["setting"], first["miss"]), ("best", False))
        self.assertEqual((second["fastest"]["setting"], second["miss"]), ("rough", True))
        self.assertTrue(first["kept"])


if __name__ == "__main__":
    unittest.main()
