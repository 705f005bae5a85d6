# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The guides and the API's pages build without a warning, and hold what users look for."""
import html
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import pointsplatting

TOP = pathlib.Path(__file__).parents[2]


class TestDocumentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        done = subprocess.run(
            [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html",
             TOP / "Documentation", cls.folder.name],
            text=True, check=False, stderr=subprocess.PIPE)
        if done.returncode != 0:
            raise AssertionError(done.stderr)

    def page(self, name):
        return html.unescape(pathlib.Path(self.folder.name, f"{name}.html").read_text())

    def test_api(self):
        page = self.page("python_api")
        for name in ("pointsplatting.read", "PlotterSplats.add", "PlotterSplats.settings",
                     "PlotterSplats.choices", "DataSetSplats.estimate", "DataSetSplats.contour",
                     "DataSetSplats.project", "convert.convert", "app.main"):
            self.assertTrue(re.search(rf'id="[\w.]*{re.escape(name)}"', page), name)

    def test_every_class_is_there_with_its_methods(self):
        page = self.page("classes")
        for name, kind in vars(pointsplatting).items():
            if name.startswith("vtk") and isinstance(kind, type):
                self.assertTrue(f'id="pointsplatting.{name}"' in page, name)
        self.assertTrue('id="pointsplatting.vtkPointSplatMapper.SetTargetError"' in page)

    def test_links_of_the_readme_lead_somewhere(self):
        text = (TOP / "README.md").read_text()
        self.assertLess(len(text.splitlines()), 200)
        links = re.findall(r"\]\(([^)#:]+)(?:#([\w-]+))?\)", text)
        self.assertGreater(len(links), 5)
        for file, anchor in links:
            with self.subTest(file, anchor=anchor):
                self.assertTrue((TOP / file).is_file())
                headings = re.findall(r"(?m)^#+ (.*)$", (TOP / file).read_text()) if anchor else []
                self.assertIn(anchor, [*(h.lower().replace(" ", "-") for h in headings), ""])


if __name__ == "__main__":
    unittest.main()
