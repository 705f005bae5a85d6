# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The PyVista examples run and draw a lit surface."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import pyvista as pv

TOP = pathlib.Path(__file__).parents[2]
EXAMPLES = TOP / "Examples" / "Python" / "PyVista"
LEAST = 40.0 # dB


class TestExamples(unittest.TestCase):
    def test_examples(self):
        examples = sorted(EXAMPLES.glob("*.py"))
        self.assertGreaterEqual(len(examples), 6)
        for example in examples:
            with self.subTest(example.name), tempfile.TemporaryDirectory() as folder:
                picture = pathlib.Path(folder) / "picture.png"
                subprocess.run([sys.executable, example, picture], check=True)
                pixels = pv.read(picture).point_data.active_scalars[:, :3].astype(int)
                background = pixels[0]
                differs = np.abs(pixels - background).max(axis=1) > 8
                self.assertGreater(differs.mean(), 0.05)
                self.assertGreater(len(np.unique(pixels[differs], axis=0)), 500)
                # The gallery shows what users get.
                shown = pv.read(TOP / "Documentation" / f"gallery_{example.stem}.png")
                shown = shown.point_data.active_scalars[:, :3].astype(int)
                self.assertEqual(shown.shape, pixels.shape)
                psnr = 10 * np.log10(255**2 / max(np.mean((shown - pixels) ** 2), 1e-9))
                print(f"{example.name}: {psnr:.1f} dB to the gallery's picture")
                self.assertGreater(psnr, LEAST)


if __name__ == "__main__":
    unittest.main()
