# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the mapper chooses by itself keeps to its target error, and where one setting is known to be
far faster than the others, it is chosen.

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
    Scene, orbital_scene, shadow_scene, sphere_mesh, spheres_scene, torus_scene)


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

    def test_opaque(self):
        """Image space takes a fifth of the time of two passes here."""
        rows = self.chosen(torus_scene(), 160000, 256, choosing.OPAQUE[:1], runs=3)
        best, full, _, rough = rows
        self.assertEqual([row["did"][0] for row in (full, rough)], ["two-pass", "image-space"])
        self.assertLess(rough["ms"], 0.67 * best["ms"])

    def test_sparse(self):
        rows = self.chosen(torus_scene(4.0), 4000, 256, choosing.OPAQUE[:1])
        self.assertEqual([row["did"][0] for row in rows[1:]], 3 * ["two-pass"])

    def test_translucent(self):
        """Sorting takes a quarter of the time of peeling 15 layers."""
        rows = self.chosen(spheres_scene(8, 0.2), 16000, 192, choosing.TRANSLUCENT[:1], runs=3)
        best, full, fair, rough = rows
        self.assertEqual([row["did"][2] for row in (full, fair, rough)],
                         ["peeling", "peeling", "sorted"])
        self.assertLess(rough["ms"], 0.67 * best["ms"])
        self.chosen(orbital_scene((0.3, 0.5, 1.0), "orbital"), 20000, 128,
                    choosing.TRANSLUCENT[:1])

    def test_roomy(self):
        """Spheres three spacings apart: all but the nearest layer may be sorted for 1/64."""
        rows = self.chosen(spheres_scene(5, 0.2), 16000, 192, choosing.TRANSLUCENT[:1], runs=3)
        best, full, fair, _ = rows
        self.assertEqual([row["did"][2] for row in (full, fair)], ["peeling", "nearest-exact"])
        self.assertLess(fair["ms"], 0.8 * best["ms"])

    def test_crowded(self):
        """Shells nearer to each other than their points are: sorted they have an error of 0.06."""
        radii = [1 - 0.02 * k for k in range(4)]
        shells = Scene("shells", [Spheres(radii)],
                       lambda count: [sphere_mesh(count / 4, radius) for radius in radii],
                       4 * [0.2], ([-1] * 3, [1] * 3))
        rows = self.chosen(shells, 20000, 192, choosing.TRANSLUCENT[:1])
        self.assertEqual([row["did"][2] for row in rows[1:]], 3 * ["peeling"])

    def test_bright_shadows(self):
        """On white two samples, which do for the colours of the scene, would have an error of 0.025."""
        scene = shadow_scene()
        for prop in scene.properties:
            prop.SetColor(1, 1, 1)
            prop.SetAmbient(0)
            prop.SetDiffuse(1)
            prop.SetSpecular(0)
        rows = self.chosen(scene, 4000, 128, choosing.SHADED[:1],
                           choosing.shadows(choosing.SAMPLES, (choosing.TWO_PASS,)))
        self.assertEqual([row["did"][4] for row in rows], [16, 16, 15, 1])

    def test_shadows(self):
        rows = self.chosen(shadow_scene(), 4000, 128, choosing.SHADED[:1],
                           choosing.shadows(choosing.SAMPLES))
        self.assertEqual([row["did"][4] for row in rows], [16, 16, 2, 1])

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
