# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of scans, text and VTK's formats: exact coordinates, arrays, boxes, clear errors."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import laspy
import numpy as np
import pye57
import pyvista as pv
from copc_writer import write_copc
from vtkmodules.util.numpy_support import vtk_to_numpy

import pointsplatting

# As of a survey: a float has 3 cm there.
OFFSET = np.array([4_512_345.0, 5_403_210.0, 120.0])
MILLIMETRE = 0.001


def survey(count=5000, seed=1):
    """Coordinates that are whole millimetres, as integers and in metres."""
    whole = np.random.default_rng(seed).integers(0, 20_000, (count, 3)).astype("int32")
    return whole, whole * MILLIMETRE + OFFSET


def points_of(cloud):
    return vtk_to_numpy(cloud.GetPoints().GetData())


def array_of(cloud, name):
    return vtk_to_numpy(cloud.GetPointData().GetArray(name))


class TestReading(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name, name)

    def write_las(self, name):
        whole, _ = survey()
        header = laspy.LasHeader(point_format=7, version="1.4")
        header.offsets, header.scales = OFFSET, np.full(3, MILLIMETRE)
        for axis in "xyz":
            header.add_extra_dim(laspy.ExtraBytesParams(name=f"n{axis}", type="f4"))
        header.add_extra_dim(laspy.ExtraBytesParams(name="Amplitude", type="f8"))
        las = laspy.LasData(header)
        las.X, las.Y, las.Z = whole.T
        las.intensity = np.arange(len(whole)) % 65536
        las.classification = np.arange(len(whole)) % 19
        las.red, las.green, las.blue = (np.arange(len(whole)) * k % 65536 for k in (13, 17, 19))
        las.red[0] = 65535
        las.nx, las.ny, las.nz = (np.full(len(whole), v) for v in (0.6, 0, 0.8))
        las.Amplitude = np.linspace(-1, 1, len(whole))
        las.write(str(self.path(name)))
        return las

    def test_las_and_laz(self):
        for name in ("a.las", "a.laz", "A.LAZ"):
            with self.subTest(name):
                written = self.write_las(name)
                cloud = pointsplatting.read(self.path(name))
                _, metres = survey()
                self.assertEqual(points_of(cloud).dtype, np.float64)
                np.testing.assert_allclose(points_of(cloud), metres, rtol=0, atol=1e-9)
                np.testing.assert_array_equal(array_of(cloud, "Intensity"), written.intensity)
                np.testing.assert_array_equal(
                    array_of(cloud, "Classification"), np.asarray(written.classification))
                rgb = array_of(cloud, "RGB")
                self.assertEqual((rgb.dtype, rgb[0, 0]), (np.uint8, 255))
                np.testing.assert_allclose(rgb[:, 1], np.asarray(written.green) / 257, atol=1)
                np.testing.assert_allclose(array_of(cloud, "Amplitude"), written.Amplitude)
                np.testing.assert_allclose(
                    vtk_to_numpy(cloud.GetPointData().GetNormals())[7], (0.6, 0, 0.8), atol=1e-6)
                self.assertFalse(cloud.GetPointData().HasArray("nx"))

    def test_box(self):
        self.write_las("a.laz")
        _, metres = survey()
        box = np.column_stack((OFFSET + 5, OFFSET + 12)).ravel()
        wanted = metres[((metres >= box[0::2]) & (metres <= box[1::2])).all(axis=1)]
        self.assertGreater(len(wanted), 50)
        cloud = pointsplatting.read(self.path("a.laz"), box=box)
        np.testing.assert_allclose(points_of(cloud), wanted, rtol=0, atol=1e-9)
        self.assertEqual(len(array_of(cloud, "Intensity")), len(wanted))
        empty = pointsplatting.read(self.path("a.laz"), box=(0, 1, 0, 1, 0, 1))
        self.assertEqual(empty.GetNumberOfPoints(), 0)

    def test_copc(self):
        """Of three levels a spacing takes one or two, and a box leaves others' bytes alone."""
        whole, metres = survey(6000)
        file = self.path("a.copc.laz")
        chunks = write_copc(file, whole, OFFSET, MILLIMETRE)
        everything = pointsplatting.read(file)
        self.assertEqual(everything.GetNumberOfPoints(), len(whole))
        order = np.lexsort(points_of(everything).T)
        np.testing.assert_allclose(points_of(everything)[order], metres[np.lexsort(metres.T)],
                                   rtol=0, atol=1e-9)
        root = pointsplatting.read(file, spacing=2.0)
        self.assertEqual(root.GetNumberOfPoints(), chunks[(0, 0, 0, 0)][2])
        two = pointsplatting.read(file, spacing=1.0)
        self.assertEqual(two.GetNumberOfPoints(),
                         sum(count for key, (_, _, count) in chunks.items() if key[0] < 2))
        box = np.column_stack((OFFSET, OFFSET + 4)).ravel()
        wanted = metres[((metres >= box[0::2]) & (metres <= box[1::2])).all(axis=1)]
        # The bytes of a far octant are spoilt: who reads what is asked for alone does not notice.
        start, size, _ = chunks[(1, 1, 1, 1)]
        content = bytearray(file.read_bytes())
        content[start:start + size] = bytes(size)
        file.write_bytes(content)
        near = pointsplatting.read(file, box=box)
        self.assertEqual(near.GetNumberOfPoints(), len(wanted))

    def test_e57(self):
        _, metres = survey(300)
        local = (metres - OFFSET).astype("float32").astype(float) # what pye57 writes
        turn = np.array([np.cos(0.5), 0, 0, np.sin(0.5)]) # a radian about z
        with pye57.E57(str(self.path("a.e57")), mode="w") as file:
            for i, (rotation, translation) in enumerate(
                    (((1, 0, 0, 0), OFFSET), (turn, OFFSET + 50))):
                file.write_scan_raw(
                    {"cartesianX": local[:, 0].copy(), "cartesianY": local[:, 1].copy(),
                     "cartesianZ": local[:, 2].copy(), "intensity": np.linspace(0, 1, 300),
                     "colorRed": np.full(300, 10 + i), "colorGreen": np.arange(300) % 256,
                     "colorBlue": np.full(300, 30)},
                    rotation=np.array(rotation, float), translation=translation)
        cloud = pointsplatting.read(self.path("a.e57"))
        points = points_of(cloud)
        np.testing.assert_allclose(points[:300], local + OFFSET, rtol=0, atol=1e-8)
        c, s = np.cos(1), np.sin(1)
        turned = local @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + OFFSET + 50
        np.testing.assert_allclose(points[300:], turned, rtol=0, atol=1e-8)
        self.assertEqual(array_of(cloud, "ScanId").tolist(), [0] * 300 + [1] * 300)
        np.testing.assert_allclose(
            vtk_to_numpy(cloud.GetFieldData().GetArray("SensorPosition")), (OFFSET, OFFSET + 50))
        self.assertEqual(array_of(cloud, "RGB")[305].tolist(), [11, 5, 30])
        np.testing.assert_allclose(array_of(cloud, "Intensity")[:300], np.linspace(0, 1, 300),
                                   atol=1e-6)
        # Normals face the scanners, whose positions the estimation is told.
        estimation = pointsplatting.vtkPointSplatEstimation()
        estimation.SetInputData(cloud)
        estimation.Update()
        normals = array_of(estimation.GetOutput(), "Normals")[:300]
        self.assertTrue((np.sum(normals * local, axis=1) < 1e-3).all())

    def test_text(self):
        self.path("a.csv").write_text("X;Y;Z;Red;Green;Blue;Temperature\n1;2;3;255;0;9;20.5\n")
        cloud = pointsplatting.read(self.path("a.csv"))
        self.assertEqual(cloud.GetPoint(0), (1, 2, 3))
        self.assertEqual(array_of(cloud, "RGB").tolist(), [[255, 0, 9]])
        self.assertEqual(array_of(cloud, "Temperature").tolist(), [20.5])
        self.path("a.xyz").write_text("# of a scanner\n4512345.001 2 3 7\n4512345.002 5 6 8\n")
        cloud = pointsplatting.read(self.path("a.xyz"))
        self.assertEqual(cloud.GetPoint(1), (4512345.002, 5, 6))
        self.assertEqual(array_of(cloud, "Column4").tolist(), [7, 8])
        self.path("a.txt").write_text("//x,y,z\n1,2,3\n")
        self.assertEqual(pointsplatting.read(self.path("a.txt")).GetPoint(0), (1, 2, 3))

    def test_formats_of_vtk(self):
        for name, data in (("a.vtp", pv.Sphere()), ("a.ply", pv.Sphere()), ("a.stl", pv.Sphere()),
                           ("a.vtk", pv.Sphere()), ("a.vti", pv.Wavelet()),
                           ("a.vtu", pv.Wavelet().cast_to_unstructured_grid()),
                           ("a.vtm", pv.MultiBlock([pv.Sphere()]))):
            with self.subTest(name):
                data.save(self.path(name))
                read = pointsplatting.read(self.path(name))
                self.assertGreater(read.GetNumberOfElements(0), 100)

    def test_convert(self):
        """What programs that read no scans are given instead."""
        self.write_las("a.laz")
        convert = [sys.executable, "-m", "pointsplatting.convert"]
        target = self.path("a.vtp")
        done = subprocess.run([*convert, self.path("a.laz"), target], text=True, check=True,
                              stdout=subprocess.PIPE)
        self.assertEqual(done.stdout, f"{target}: 5000 points\n")
        cloud = pointsplatting.read(target)
        _, metres = survey()
        self.assertEqual(points_of(cloud).dtype, np.float64)
        np.testing.assert_allclose(points_of(cloud), metres, rtol=0, atol=1e-9)
        self.assertIn("Normals", cloud.GetPointData().GetNormals().GetName())
        self.assertEqual(array_of(cloud, "RGB").shape, (5000, 3))
        half = ["--box", *(str(v) for v in (OFFSET[0], OFFSET[0] + 10, 0, 1e9, 0, 1e9))]
        subprocess.run([*convert, self.path("a.laz"), target, *half], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(pointsplatting.read(target).GetNumberOfPoints(),
                         np.count_nonzero(metres[:, 0] <= OFFSET[0] + 10))
        pv.Wavelet().save(self.path("v.vti"))
        for says, arguments in (("with .vtp", ("a.laz", "a.ply")), ("missing.laz", ("missing.laz", "b.vtp")),
                                ("vtkImageData", ("v.vti", "b.vtp")), ("b.vtp", ("a.laz", "none/b.vtp"))):
            with self.subTest(says):
                done = subprocess.run([*convert, *(self.path(one) for one in arguments)], text=True,
                                      check=False, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 1)
                self.assertIn(says, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_pyvista_reads_scans(self):
        self.write_las("a.laz")
        cloud = pv.read(self.path("a.laz"))
        self.assertIsInstance(cloud, pv.PolyData)
        self.assertEqual(cloud["Classification"].max(), 18)

    def test_far_away_is_drawn_as_near(self):
        """Coordinates of a survey draw what the same points near the origin do."""
        near = pv.Sphere(radius=10, theta_resolution=90, phi_resolution=90)
        pictures = []
        for offset in (np.zeros(3), OFFSET):
            cloud = pv.PolyData(near.points.astype(float) + offset)
            plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
            plotter.splats.add(cloud, color="w")
            plotter.show(auto_close=False)
            pictures.append(plotter.screenshot(return_img=True).astype(float))
            plotter.close()
        self.assertGreater(10 * np.log10(255**2 / max(1e-9, np.mean(
            (pictures[0] - pictures[1]) ** 2))), 40)

    def test_errors(self):
        self.path("a.xyz").write_text("1 2 3\n")
        for name in ("a.las", "a.laz", "a.copc.laz", "a.e57", "a.vtp", "a.csv"):
            self.path(name).write_text("this is none\nof these\n")
            with self.subTest(name), self.assertRaisesRegex(OSError, name.replace(".", r"\.")):
                pointsplatting.read(self.path(name))
        for error, says, name, choices in (
                (ValueError, r"\.copc\.laz", "a.docx", {}),
                (FileNotFoundError, "missing.las", "missing.las", {}),
                (ValueError, r"xmin, xmax", "a.xyz", {"box": (1, 0, 0, 1, 0, 1)}),
                (ValueError, r"\.copc\.laz", "a.xyz", {"spacing": 1.0}),
                (ValueError, "for scans", "a.vtp", {"box": (0, 1, 0, 1, 0, 1)})):
            with self.subTest(says), self.assertRaisesRegex(error, says):
                pointsplatting.read(self.path(name), **choices)

    def test_missing_packages_are_named(self):
        for name, package in (("a.las", "laspy"), ("a.laz", "lazrs"), ("a.e57", "pye57")):
            self.path(name).write_bytes(b"LASF")
            script = f"""
import sys
sys.modules[{package!r}] = None
import pointsplatting
pointsplatting.read({str(self.path(name))!r})"""
            done = subprocess.run([sys.executable, "-c", script], text=True, check=False,
                                  stderr=subprocess.PIPE)
            self.assertIn(f"the package {package} is needed", done.stderr)
            self.assertIn("pip install 'pointsplatting[", done.stderr)


if __name__ == "__main__":
    unittest.main()
