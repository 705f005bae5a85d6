# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each measure on pictures of which the answer is known."""
import unittest

import numpy as np

import measures


def disk(size, radius):
    y, x = np.mgrid[:size, :size] - (size - 1) / 2
    return x * x + y * y < radius * radius


class TestMeasures(unittest.TestCase):
    def setUp(self):
        self.every = np.ones((40, 50), bool)
        self.picture = np.random.default_rng(3).uniform(0, 255, (40, 50, 3))

    def test_psnr(self):
        self.assertEqual(measures.psnr(self.picture, self.picture, self.every), 100)
        self.assertAlmostEqual(measures.psnr(self.picture + 2.55, self.picture, self.every), 40)
        half = self.picture.copy()
        half[:20] += 25.5
        self.assertAlmostEqual(measures.psnr(half, self.picture, self.every), 20 + 10 * np.log10(2))
        only = self.every.copy()
        only[:20] = False
        self.assertEqual(measures.psnr(half, self.picture, only), 100)
        self.assertIsNone(measures.psnr(half, half, ~self.every))

    def test_ssim(self):
        self.assertAlmostEqual(measures.ssim(self.picture, self.picture, self.every), 1)
        flat = np.full((40, 50, 3), 100.0)
        brighter = np.full((40, 50, 3), 120.0)
        c1 = (0.01 * 255) ** 2
        self.assertAlmostEqual(measures.ssim(flat, brighter, self.every),
                               (2 * 100 * 120 + c1) / (100 ** 2 + 120 ** 2 + c1))
        negative = 255 - self.picture
        self.assertLess(measures.ssim(negative, self.picture, self.every), 0)

    def test_depth_and_normals(self):
        depth = np.full((40, 50), 7.0)
        self.assertAlmostEqual(measures.depth_error(depth + 0.2, depth, self.every, 4.0), 0.05)
        depth[0] = np.inf
        elsewhere = np.where(np.isinf(depth), 1, depth)
        self.assertAlmostEqual(measures.depth_error(elsewhere, depth, np.isfinite(depth), 1.0), 0)
        normal = np.tile([0.0, 0, 1], (40, 50, 1))
        turned = np.tile([0, np.sin(0.1), np.cos(0.1)], (40, 50, 1))
        self.assertAlmostEqual(measures.normal_angle(turned, normal, self.every), np.degrees(0.1))
        self.assertAlmostEqual(measures.normal_angle(0 * normal, normal, self.every), 180)

    def test_outline(self):
        truth = disk(61, 20)
        self.assertEqual(measures.silhouette(truth, truth), 0)
        wider = measures.grown(truth)
        self.assertTrue(0.8 < measures.silhouette(wider, truth) < 1.6)
        self.assertTrue(0.8 < measures.silhouette(measures.inner(truth, 1), truth) < 1.6)
        far = truth.copy()
        far[0, :5] = True
        self.assertEqual(measures.silhouette(far, truth), 0)
        self.assertEqual(measures.spill(far, truth), 5)
        self.assertEqual(measures.spill(wider, truth), 0)

    def test_holes(self):
        truth = disk(61, 20)
        self.assertEqual(measures.holes(truth, truth), 0)
        torn = truth.copy()
        torn[30, 28:31] = False
        self.assertEqual(measures.holes(torn, truth), 3)
        # A pixel of the outline is no hole.
        rim = truth.copy()
        rim[tuple(np.argwhere(measures.outline(truth))[0])] = False
        self.assertEqual(measures.holes(rim, truth), 0)

    def test_openings(self):
        # A slope before a wall.
        truth = np.tile(np.linspace(5.0, 6.0, 61), (61, 1))
        truth[:20] = 9.0
        self.assertEqual(measures.openings(truth, truth, 0.01), 0)
        torn = truth.copy()
        torn[40, 28:31] = 9.0
        self.assertEqual(measures.openings(torn, truth, 0.01), 3)
        # Where the wall is seen beside it, the slope may end.
        torn = truth.copy()
        torn[20:22] = 9.0
        self.assertEqual(measures.openings(torn, truth, 0.01), 0)
        self.assertEqual(measures.openings(truth - 1.0, truth, 0.01), 0)

    def test_grown_and_inner(self):
        dot = np.zeros((9, 9), bool)
        dot[4, 4] = True
        self.assertEqual(measures.grown(dot).sum(), 9)
        self.assertEqual(measures.grown(dot, 2).sum(), 25)
        np.testing.assert_array_equal(measures.inner(measures.grown(dot, 2), 2), dot)
        np.testing.assert_array_equal(measures.grown(np.float32([[1, 2, 5, 4, 3]])), [[2, 5, 5, 5, 4]])

    def test_layers(self):
        truth = np.zeros((10, 10), int)
        truth[:5] = 4
        self.assertEqual(measures.layer_error(truth, truth), 0)
        got = truth.copy()
        got[0] = 3
        got[9] = 1
        self.assertAlmostEqual(measures.layer_error(got, truth), 20 / 60)


if __name__ == "__main__":
    unittest.main()
