# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""splatbench --smoke as a user starts it: files, and values that make sense.

TestSplatbench.py, with the package pointsplatting to be found.
"""
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from bench import analysis  # noqa: E402
from bench.charts import ticks  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGReader  # noqa: E402


def row(setting, peer, ms, error, holes=0):
    return dict(setting=setting, peer=peer, status="measured", ms=ms, rms_inside=error,
                psnr_inside=40 - 20 * np.log10(error), holes=holes)


class TestAnalysis(unittest.TestCase):
    def test_growth(self):
        x = np.array([1e4, 4e4, 16e4])
        grown = analysis.growth(x, 3e-3 * x ** 0.7)
        self.assertAlmostEqual(grown["exponent"], 0.7)
        self.assertAlmostEqual(grown["exponent_upper"], 0.7)
        grown = analysis.growth(x[::-1], 5 + 2e-3 * x[::-1])
        self.assertAlmostEqual(grown["fixed_ms"], 5)
        self.assertAlmostEqual(grown["each_ms"], 2e-3)
        self.assertLess(grown["off_line"], 1e-9)
        self.assertIsNone(analysis.growth([1], [1]))

    def test_front_and_peers(self):
        rows = [row("a", False, 10, 1.0), row("b", False, 20, 0.5), row("c", False, 15, 2.0),
                row("p", True, 5, 3.0), row("q", True, 12, 1.5), row("r", True, 30, 0.4, 7)]
        self.assertEqual([one["setting"] for one in analysis.front(rows)], ["p", "a", "b", "r"])
        free, better = analysis.not_dominated(rows)
        self.assertEqual([one["setting"] for one in free], ["p", "r"])
        self.assertEqual(better, [])
        free, better = analysis.not_dominated(rows + [row("s", True, 9, 0.3)])
        self.assertEqual([one["setting"] for one in better], ["s"])
        table = analysis.choices(rows, (45.0,))
        self.assertEqual(table[0]["ours"]["setting"], "b")
        self.assertIsNone(table[0]["peer"])  # r has holes
        self.assertEqual(table[1]["peer"]["setting"], "r")

    def test_ticks(self):
        self.assertEqual(ticks(9, 600), [10, 20, 50, 100, 200, 500])
        self.assertEqual(ticks(0.5, 20000), [1, 10, 100, 1000, 10000])


class TestSplatbench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="splatbench-")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}

        def run(folder, *arguments):
            done = subprocess.run(
                [sys.executable, os.path.join(HERE, "splatbench.py"), "--smoke", "--output", folder,
                 *arguments],
                capture_output=True, text=True, env=environment, check=False)
            if done.returncode:
                raise AssertionError(done.stdout + done.stderr)
            with open(os.path.join(folder, "splatbench.json"), encoding="utf-8") as file:
                return done, json.load(file)

        cls.done, cls.report = run(cls.folder)
        _, cls.hurried = run(os.path.join(cls.folder, "hurried"), "--minutes", "0.001")
        cls.rows = [one for one in cls.report["rows"] if one["status"] == "measured"]

    def test_no_warnings(self):
        """VTK's or Python's; drivers may have something to say."""
        self.assertNotRegex(self.done.stderr, "ERROR: In|Warning: In|RuntimeWarning|Traceback")

    def test_minutes(self):
        """Out of time, what is not begun is left out and listed."""
        self.assertEqual(self.report["left_out"], [])
        cells = {(one["scene"], one["points"], one["size"]) for one in self.report["rows"]}
        begun = {(one["scene"], one["points"], one["size"]) for one in self.hurried["rows"]}
        self.assertEqual(len(begun), 1)
        self.assertEqual(len(self.hurried["left_out"]), len(cells) - 1)

    def test_json_and_csv(self):
        machine = self.report["machine"]
        for key in ("date", "cpu", "cores", "vtk", "commit"):
            self.assertTrue(machine[key], key)
        self.assertTrue(machine["opengl"]["renderer"])
        with open(os.path.join(self.folder, "splatbench.csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), len(self.report["rows"]))
        self.assertEqual(list(table[0]), list(self.report["columns"]))
        for one in self.report["rows"]:
            self.assertRegex(one["status"], "measured|not in this build|skipped")

    def test_values(self):
        self.assertGreater(len(self.rows), 30)
        for one in self.rows:
            with self.subTest(one["scene"] + ", " + one["setting"]):
                self.assertTrue(0 < one["ms_q1"] <= one["ms"] <= one["ms_q3"])
                self.assertGreater(one["cold_ms"], 0)
                self.assertTrue(5 < one["psnr"] < 100)
                self.assertTrue(-1 <= one["ssim"] <= 1)
                self.assertGreaterEqual(one["layers"], 1)

    def find(self, scene, setting):
        return max((one for one in self.rows if one["scene"] == scene and
                    one["setting"] == setting), key=lambda one: (one["size"], one["points"]))

    def test_known_order(self):
        """Of what must be nearer to the truth than what."""
        mesh, splats = self.find("torus", "stock mesh"), self.find("torus", "two passes, compute")
        dots = self.find("torus", "stock points, 1 px")
        for one in mesh, splats:
            self.assertGreater(one["psnr_inside"], dots["psnr_inside"] + 15)
            self.assertEqual(one["holes"], 0)
            self.assertLess(one["depth"], 0.02)
            self.assertLess(one["normal"], 2)
            self.assertLess(one["silhouette"], 0.3)
        self.assertGreater(dots["holes"], 100)
        peeled = self.find("spheres, translucent", "peeling, all layers")
        single = self.find("spheres, translucent", "peeling, 1 layer")
        self.assertEqual((peeled["asked_layers"], single["asked_layers"]), (None, 1))
        self.assertEqual(single["layers"], 1)
        self.assertGreater(peeled["layers"], 12)
        self.assertLess(peeled["layer_error"], 0.1)
        self.assertGreater(single["layer_error"], 0.5)
        self.assertGreater(peeled["psnr_inside"], single["psnr_inside"] + 10)
        shadows = self.find("shadows", "stock mesh, shadow map")
        self.assertGreater(shadows["psnr"], self.find("shadows", "stock mesh, no shadows")["psnr"] + 3)

    def test_growth(self):
        over = {(one["where"].split(" ")[0].strip(","), one["over"])
                for one in self.report["growth"]}
        self.assertLessEqual({("torus", "points"), ("torus", "pixels"),
                              ("spheres", "layers")}, over)
        self.assertIn("exponent over points", self.done.stdout)

    def test_charts(self):
        names = ["torus-error-over-time", "torus-cost-over-points", "torus-cost-over-pixels",
                 "spheres-translucent-cost-over-layers", "shadows-error-over-time"]
        for name in names:
            reader = vtkPNGReader()
            reader.SetFileName(os.path.join(self.folder, name + ".png"))
            reader.Update()
            image = reader.GetOutput()
            self.assertEqual(image.GetDimensions(), (900, 600, 1), name)
            pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(600, 900, -1)[..., :3]
            self.assertTrue((pixels[0] == 255).all(), name)
            # Markers in colour, in the plot and in the legend.
            colourful = (np.ptp(pixels.astype(int), axis=2) > 100)
            self.assertGreater(colourful[:, :680].sum(), 100, name)
            self.assertGreater(colourful[:, 690:].sum(), 20, name)
            root = xml.etree.ElementTree.parse(os.path.join(self.folder, name + ".svg")).getroot()
            self.assertTrue(root.tag.endswith("svg"))
            tags = [element.tag.rpartition("}")[2] for element in root.iter()]
            self.assertGreater(tags.count("use"), 5, name)  # markers
            # See Chart: nothing is clipped in coordinates of another transform.
            for element in root.iter():
                if "clip-path" in element.attrib:
                    self.assertIn(element.get("transform", "identity"),
                                  ("identity", "matrix(1,0,0,1,0,0)"), name)


if __name__ == "__main__":
    unittest.main()
