# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The installed wheel: what is in it, how it is imported, what its hints and pins say.

POINTSPLATTING_WHEEL names the wheel's file.
"""
import ast
import importlib.metadata
import os
import pathlib
import statistics
import subprocess
import sys
import unittest
import zipfile

import pointsplatting

MEGABYTE = 1 << 20
WHEEL = pathlib.Path(os.environ["POINTSPLATTING_WHEEL"])


def import_time(statement):
    """Seconds that a new interpreter takes for a statement, the median of nine."""
    taken = []
    for _ in range(9):
        script = f"""
import time, vtkmodules.vtkRenderingOpenGL2, vtkmodules.vtkRenderingCore
start = time.perf_counter()
{statement}
print(time.perf_counter() - start)"""
        taken.append(float(subprocess.run(
            [sys.executable, "-c", script], text=True, check=True, stdout=subprocess.PIPE).stdout))
    return statistics.median(taken)


class TestWheel(unittest.TestCase):
    def test_is_what_is_imported(self):
        self.assertIn("site-packages", pointsplatting.__file__)
        self.assertNotIn("LD_LIBRARY_PATH", os.environ)

    def test_size(self):
        size = WHEEL.stat().st_size
        print(f"{WHEEL.name}: {size / MEGABYTE:.2f} MB")
        self.assertLess(size, 5 * MEGABYTE)

    def test_holds_no_library_of_vtk(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            names = wheel.namelist()
        libraries = [name for name in names if ".so" in name]
        self.assertEqual(len(libraries), 4, libraries)
        self.assertTrue(all("PointSplatting" in name for name in libraries))
        self.assertFalse([name for name in names if name.endswith((".h", ".cmake", ".txt"))
                          and "dist-info" not in name])

    def test_import_time(self):
        taken = import_time("import pointsplatting")
        print(f"import pointsplatting on top of vtkmodules: {1000 * taken:.1f} ms")
        self.assertLess(taken, 0.05)

    def test_hints(self):
        folder = pathlib.Path(pointsplatting.__file__).parent
        self.assertTrue((folder / "py.typed").is_file())
        hinted = set()
        for module in ("vtkFiltersPointSplatting", "vtkRenderingPointSplatting"):
            tree = ast.parse((folder / f"{module}.pyi").read_text())
            hinted |= {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
        there = {name for name in vars(pointsplatting) if name.startswith("vtk")
                 and isinstance(getattr(pointsplatting, name), type)}
        self.assertEqual(there - hinted, set())

    def test_pins(self):
        pins = [one for one in importlib.metadata.requires("pointsplatting") if "extra" not in one]
        self.assertEqual(len(pins), 1)
        self.assertRegex(pins[0], r"^vtk[<>=]")
        self.assertEqual(subprocess.run([sys.executable, "-m", "pip", "check"],
                                        check=False, stdout=subprocess.DEVNULL).returncode, 0)

    def test_another_release_is_refused(self):
        script = """
from vtkmodules.vtkCommonCore import vtkVersion
import vtkmodules.vtkCommonCore as core
class Other:
    GetVTKVersion = staticmethod(lambda: "9.9.0")
core.vtkVersion = Other
import pointsplatting"""
        done = subprocess.run([sys.executable, "-c", script], text=True, check=False,
                              stderr=subprocess.PIPE)
        self.assertIn("was built for VTK", done.stderr)

    def test_entry_points(self):
        for group in ("pyvista.plotter_components", "pyvista.accessors"):
            points = importlib.metadata.entry_points(group=group)
            self.assertIn("splats", [point.name for point in points])


if __name__ == "__main__":
    unittest.main()
