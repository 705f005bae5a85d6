# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""papers.py --quick as a user starts it: all sections are there, numbers are finite, pictures show
something, and nothing is fetched from elsewhere.

TestPapers.py, with the package pointsplatting to be found.
"""
import base64
import html.parser
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
import pointsplatting

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from papers import filters  # noqa: E402
from scenes import BACKGROUND  # noqa: E402

# Sections without numbers.
WORDS_ONLY = set()
# Sections that are tables only.
NO_PICTURES = WORDS_ONLY | {
    "zhang-tables", "dobrev-table-3", "guennebaud-table-1", "confetti-tables"}
NAMES = {"zhang-tables", "zhang-figure-8", "zhang-figure-11", "zhang-section-6.2",
         "zhang-figure-14", "dobrev-table-3", "dobrev-figure-16", "dobrev-figure-18",
         "dobrev-figure-19", "guennebaud-table-1", "guennebaud-figures-3-4", "guennebaud-figure-5",
         "guennebaud-figure-6", "confetti-tables", "confetti-figures-15-16", "confetti-figure-18"}
if not hasattr(pointsplatting, "vtkPointSplatOctree"):
    WORDS_ONLY.add("confetti-tables")


class Reader(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.sections, self.links, self.text = {}, [], ""

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "h2":
            self.own = self.sections[attributes["id"]] = {"pictures": [], "differs": 0}
        if tag == "img":
            self.own["pictures"].append(attributes["src"])
        if attributes.get("class") == "differs":
            self.own["differs"] += 1
        self.links += [attributes[key] for key in ("src", "href") if key in attributes]

    def handle_data(self, data):
        self.text += data


def decoded(source):
    data = base64.b64decode(source.split(",", 1)[1], validate=True)
    reader = vtkPNGReader()
    reader.SetMemoryBuffer(data)
    reader.SetMemoryBufferLength(len(data))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


class TestPrefilters(unittest.TestCase):
    """That the prefilters written down in NumPy do what the paper says of them."""

    def setUp(self):
        class Camera:  # looks down on a plane; what Splats asks of reference.Camera
            width = height = 64
            half = np.array([0.5, 0.5])

            def points_to_view(self, points):
                return points - (0, 0, 1)

            def to_view(self, vectors):
                return vectors
        self.camera = Camera()

    def splats(self, n, radius):
        axis = ((np.arange(n) + 0.5) / n - 0.5)
        x, y = np.meshgrid(axis, axis)
        points = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
        return filters.Splats(self.camera, points, np.array([0.0, 0.0, 1.0]), radius,
                              np.full(n * n, 0.5))

    def covered(self, picture):
        return np.abs(picture - 255 * np.array(BACKGROUND)).max(2) > 1

    def test_one_colour_stays(self):
        one = self.splats(50, 0.75 / 50)
        for make in (one.filter_none, one.filter_ewa, one.filter_maximum, one.filter_tangents):
            inside = one.draw(make())[2:-2, 2:-2]
            np.testing.assert_allclose(inside, 127.5, err_msg=make.__name__)

    def test_only_prefilters_meet_pixels_between_tiny_splats(self):
        one = self.splats(40, 1e-4)
        self.assertLess(self.covered(one.draw(one.filter_none())).mean(), 0.1)
        for make in (one.filter_ewa, one.filter_maximum, one.filter_tangents):
            self.assertTrue(self.covered(one.draw(make()))[2:-2, 2:-2].all(), make.__name__)

    def test_spacing(self):
        spacing = self.splats(32, 0.02).spacing_below(1 / 32)
        self.assertAlmostEqual(spacing[np.isfinite(spacing)].min(), 2, delta=0.6)

    def test_large_splats_need_none(self):
        one = self.splats(8, 0.75 / 8)
        weights = []
        for make in (one.filter_none, one.filter_maximum, one.filter_tangents):
            pixels = one.at[:1, None] + np.array([[[3.0, 2.0]]])
            weights.append(make()(np.array([0]), pixels)[0, 0])
        self.assertAlmostEqual(weights[0], weights[1])
        self.assertAlmostEqual(weights[0], weights[2])


class TestPage(unittest.TestCase):
    def test_quick(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, os.path.join(HERE, "papers.py"), "--quick",
                            "--output", folder], check=True)
            with open(os.path.join(folder, "papers.json"), encoding="utf-8") as file:
                measured = json.load(file)["sections"]
            page = Reader()
            with open(os.path.join(folder, "papers.html"), encoding="utf-8") as file:
                page.feed(file.read())
        self.assertEqual(set(page.sections), NAMES)
        self.assertEqual(set(measured), NAMES)
        self.assertNotIn("nan", page.text.split())
        for link in page.links:
            self.assertTrue(link.startswith(("#", "data:image/png;base64,")), link[:80])
        for name, section in page.sections.items():
            with self.subTest(section=name):
                self.check(name, section, measured[name])

    def check(self, name, section, measured):
        numbers = [value for row in measured["rows"] for value in row.values()
                   if not isinstance(value, str)]
        self.assertEqual(bool(numbers), name not in WORDS_ONLY)
        self.assertTrue(all(math.isfinite(value) for value in numbers))
        self.assertEqual(bool(section["pictures"]), name not in NO_PICTURES)
        self.assertEqual(len(section["pictures"]), measured["pictures"])
        if name not in WORDS_ONLY:
            self.assertGreater(section["differs"], 0)
        for source in section["pictures"]:
            self.assertGreater(np.ptp(decoded(source), 0).max(), 20)


if __name__ == "__main__":
    unittest.main()
