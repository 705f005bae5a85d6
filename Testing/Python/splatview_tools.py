# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the tests of splatview: running it, and looking at what it wrote.

A test is started with the program as its first argument.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

PROGRAM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else "splatview"
SIZE = 96  # of pictures, both ways


class Picture:
    def __init__(self, file):
        self.file = file
        reader = vtkPNGReader()
        reader.SetFileName(file)
        reader.Update()
        image = reader.GetOutput()
        self.width, self.height, _ = image.GetDimensions()
        self.bytes = bytes(memoryview(image.GetPointData().GetScalars()))

    def pixel(self, x, y):
        """From the lower left; r, g, b."""
        at = 3 * (y * self.width + x)
        return tuple(self.bytes[at : at + 3])

    def centre(self):
        return self.pixel(self.width // 2, self.height // 2)

    def pixels(self):
        return [tuple(self.bytes[i : i + 3]) for i in range(0, len(self.bytes), 3)]

    def difference(self, other):
        """Mean of absolute differences, of 255."""
        assert len(self.bytes) == len(other.bytes)
        return sum(abs(a - b) for a, b in zip(self.bytes, other.bytes)) / len(self.bytes)


class SplatviewTest(unittest.TestCase):
    """Each test in a folder of its own, without a display."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="splatview-")
        self.addCleanup(shutil.rmtree, self.folder)
        self.environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        mode = "wb" if isinstance(content, bytes) else "w"
        with open(self.path(name), mode, encoding=None if mode == "wb" else "utf-8") as file:
            file.write(content)
        return name

    def run_splatview(self, *arguments):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=100,
            check=False,
        )

    def draw(self, *arguments):
        """Runs it, which must go without a word; the report and the picture."""
        size = () if "--size" in arguments else ("--size", f"{SIZE}x{SIZE}")
        done = self.run_splatview(
            *arguments, *size, "--frames", 1, "--quiet", "--json", "r.json", "--output", "o.png"
        )
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), arguments)
        with open(self.path("r.json"), encoding="utf-8") as file:
            report = json.load(file)
        return report, Picture(self.path("o.png"))

    def assert_refused(self, *arguments):
        """Exit code 2, one line on stderr, no picture; the line."""
        done = self.run_splatview(*arguments)
        self.assertEqual(done.returncode, 2, (arguments, done))
        self.assertRegex(done.stderr, r"\Asplatview: [^\n]+\n\Z", arguments)
        self.assertEqual(done.stdout, "", arguments)
        self.assertFalse([f for f in os.listdir(self.folder) if f.endswith(".png")], arguments)
        return done.stderr

    def assert_bounds(self, surface, bounds, tolerance):
        for got, wanted in zip(surface["bounds"], bounds):
            self.assertAlmostEqual(got, wanted, delta=tolerance, msg=surface["name"])


def main():
    unittest.main(argv=sys.argv)
