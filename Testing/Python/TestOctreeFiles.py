# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPointSplatOctreeWriter and -Reader: what is written comes back, coarse versions look like the
whole, and files that are no such files are refused.

TestOctreeFiles.py, with the package pointsplatting to be found.
"""
import os
import random

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter
import pointsplatting

from octree_tools import COUNT, FAR, OctreeTest, arrays, main, positions, torus


def picture(data):
    mapper = pointsplatting.vtkPointSplatMapper()
    mapper.SetInputData(data)
    mapper.SetScalarRange(-1, 1)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(FAR, FAR, FAR)
    camera.SetPosition(FAR, FAR - 4, FAR + 4)
    renderer.ResetCameraClippingRange()
    window = pointsplatting.vtkEGLHeadlessRenderWindow()
    window.SetSize(200, 200)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).astype(float)
    window.Finalize()
    return pixels


class TestOctreeFiles(OctreeTest):
    def test_all_comes_back(self):
        whole = torus()
        written, writer = self.write(whole)
        self.assertEqual((written, writer.GetNumberOfPointsWritten()), (1, COUNT))
        self.assertEqual(os.listdir(self.folder), ["cloud.h5"])
        read, reader = self.read()
        self.assertEqual((read.GetNumberOfPoints(), reader.GetCoarsestLevelRead()), (COUNT, 0))
        self.assertEqual(reader.GetNumberOfPointsInFile(), COUNT)
        self.assertEqual(reader.GetBoundsInFile(), whole.GetBounds())
        ids = vtk_to_numpy(read.GetPointData().GetArray("vtkOriginalPointIds"))
        np.testing.assert_array_equal(np.sort(ids), np.arange(COUNT))
        np.testing.assert_array_equal(positions(read), positions(whole)[ids])
        for name, most in (("Normals", 1e-7), ("a/b", 0), ("pair", 0), ("height", 0)):  # normals are normalised
            before, after = (d.GetPointData().GetArray(name) for d in (whole, read))
            self.assertEqual(after.GetDataType(), before.GetDataType())
            np.testing.assert_allclose(
                vtk_to_numpy(after), vtk_to_numpy(before)[ids], rtol=0, atol=most)
        texts = read.GetPointData().GetAbstractArray("texts")
        bits = read.GetPointData().GetAbstractArray("bits")
        for i in range(0, COUNT, 997):
            self.assertEqual(texts.GetValue(i), f"point {ids[i]} ö")
            self.assertEqual(bits.GetValue(i), ids[i] % 3 == 0)
        self.assertEqual(read.GetPointData().GetScalars().GetName(), "height")
        self.assertEqual(read.GetPointData().GetArray("pair").GetComponentName(1), "second")
        self.assertEqual(read.GetFieldData().GetArray("SensorPosition").GetTuple(0), (1.5, 2.5, 3.5))
        self.assertEqual(self.said(), "")

    def test_coarse_versions(self):
        self.write(torus())
        best = picture(self.read()[0])
        for most, least in ((20000, 42), (4000, 35), (800, 20)):
            coarse, reader = self.read(most)
            self.assertLessEqual(coarse.GetNumberOfPoints(), most)
            self.assertGreater(coarse.GetNumberOfPoints(), 0.6 * most)
            self.assertGreater(reader.GetCoarsestLevelRead(), 0)
            self.assertIn("SplatRadius", arrays(coarse))
            self.assertNotIn("texts", arrays(coarse))
            self.assertNotIn("SplatFirstChild", arrays(coarse))
            psnr = 10 * np.log10(255**2 / ((picture(coarse) - best) ** 2).mean())
            self.assertGreater(psnr, least, most)
        # There is nothing coarser than the coarsest.
        self.assertEqual(self.read(1)[0].GetNumberOfPoints(), self.read(2)[0].GetNumberOfPoints())

    def test_lines(self):
        """Splats of all levels have the arrays by which points end at edges."""
        whole = torus()
        for name, value in (("SplatClip", 5 * [0.0] + [1.0]), ("SplatFold", 6 * [0.0]), ("SplatPlaneNormal", [0.0, 0.0, 1.0])):
            array = numpy_to_vtk(np.full((COUNT, len(value)), value), deep=1)
            array.SetName(name)
            whole.GetPointData().AddArray(array)
        self.write(whole)
        for most in (0, COUNT // 2, 800):
            read, _ = self.read(most)
            for name in ("SplatClip", "SplatFold", "SplatPlaneNormal"):
                self.assertIn(name, arrays(read), most)

    def test_normals_without_a_name(self):
        """Those of levels have one; where points and levels are read both are normals."""
        whole = torus()
        whole.GetPointData().GetNormals().SetName("")
        self.write(whole)
        for most in (0, COUNT // 2, 800):
            read, _ = self.read(most)
            normals = read.GetPointData().GetNormals()
            self.assertIsNotNone(normals, most)
            self.assertEqual(normals.GetNumberOfTuples(), read.GetNumberOfPoints())
            lengths = np.linalg.norm(vtk_to_numpy(normals), axis=1)
            np.testing.assert_allclose(lengths, 1, atol=1e-5)

    def test_bounds(self):
        whole = torus()
        self.write(whole)
        box = (FAR + 0.5, FAR + 2, FAR - 2, FAR + 2, FAR - 2, FAR + 2)
        read, _ = self.read(0, box)
        inside = int((positions(whole)[:, 0] >= box[0]).sum())
        self.assertEqual(int((positions(read)[:, 0] >= box[0]).sum()), inside)
        self.assertLess(read.GetNumberOfPoints(), 1.3 * inside)
        nothing, _ = self.read(0, (0, 1, 0, 1, 0, 1))
        self.assertEqual(nothing.GetNumberOfPoints(), 0)

    def test_pieces(self):
        """Of a source that divides itself, and of data sets one after the other."""
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(64)
        sphere.SetPhiResolution(64)
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetNumberOfPieces(3)
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(writer.GetNumberOfPiecesWritten(), 3)
        self.assertGreaterEqual(writer.GetNumberOfPointsWritten(), 62 * 64)
        self.assertEqual(self.read()[0].GetNumberOfPoints(), writer.GetNumberOfPointsWritten())

        # What cannot divide itself is written once.
        producer = vtkTrivialProducer()
        producer.SetOutput(torus(5000))
        writer.SetInputConnection(producer.GetOutputPort())
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(writer.GetNumberOfPointsWritten(), 5000)

        self.assertTrue(writer.Open())
        for seed in range(4):
            self.assertTrue(writer.Append(torus(3000, seed)))
        self.assertTrue(writer.Append(vtkPolyData()))
        self.assertTrue(writer.Close())
        read, reader = self.read()
        self.assertEqual((read.GetNumberOfPoints(), writer.GetNumberOfPiecesWritten()), (12000, 4))
        self.assertEqual(self.read(3000)[1].GetNumberOfPointsInFile(), 12000)
        self.assertEqual(self.said(), "")

    def test_pieces_with_other_arrays(self):
        """Those that all pieces have are read."""
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        self.assertTrue(writer.Open())
        self.assertTrue(writer.Append(torus(3000)))
        other = torus(3000)
        other.GetPointData().RemoveArray("a/b")
        self.assertTrue(writer.Append(other))
        self.assertTrue(writer.Close())
        read, _ = self.read()
        self.assertEqual(read.GetNumberOfPoints(), 6000)
        self.assertIn("texts", arrays(read))
        self.assertNotIn("a/b", arrays(read))

    def test_few_and_bad_points(self):
        one = torus(1)
        self.assertEqual(self.write(one)[0], 1)
        self.assertEqual(self.read()[0].GetNumberOfPoints(), 1)
        spoilt = torus(2000)
        positions(spoilt)[7] = np.nan
        written, writer = self.write(spoilt)
        self.assertEqual((written, writer.GetNumberOfSkippedPoints()), (1, 1))
        self.assertEqual(self.read()[0].GetNumberOfPoints(), 1999)

    def test_what_cannot_be_written(self):
        self.write(torus(2000))
        before = os.path.getsize(self.name)
        for data, name, what in (
                (vtkPolyData(), self.name, "no point"),
                (torus(10), os.path.join(self.folder, "no", "such.h5"), "folder"),
                (torus(10), "", "FileName")):
            writer = pointsplatting.vtkPointSplatOctreeWriter()
            writer.SetFileName(name)
            writer.SetInputData(data)
            self.assertEqual(writer.Write(), 0)
            self.assertIn(what, self.said())
        self.assertFalse(pointsplatting.vtkPointSplatOctreeWriter().Append(torus(10)))
        self.assertIn("Open first", self.said())
        # What is given up leaves what was there before.
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        self.assertTrue(writer.Open())
        self.assertTrue(writer.Append(torus(100)))
        del writer
        self.assertEqual(sorted(os.listdir(self.folder)), ["cloud.h5", "log"])
        self.assertEqual(os.path.getsize(self.name), before)

    def test_abort(self):
        self.write(torus(2000))
        before = os.path.getsize(self.name)
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        writer.SetInputData(torus())
        writer.AddObserver("ProgressEvent", lambda *_: writer.SetAbortExecute(1))
        self.assertEqual(writer.Write(), 0)
        self.assertIn("aborted", self.said())
        self.assertEqual(os.path.getsize(self.name), before)

    def test_what_cannot_be_read(self):
        def refused(name, what):
            self.assertFalse(pointsplatting.vtkPointSplatOctreeReader.CanReadFile(name), what)
            read, _ = self.read(0, None, name)
            self.assertEqual(read.GetNumberOfPoints(), 0)
            self.assertIn(what, self.said())

        self.write(torus(3000))
        with open(self.name, "rb") as file:
            good = file.read()
        self.assertTrue(pointsplatting.vtkPointSplatOctreeReader.CanReadFile(self.name))
        other = os.path.join(self.folder, "other.h5")
        refused(other, "is not there")
        refused("", "FileName")
        refused(self.folder, "is not there")
        for content, what in ((b"", "no HDF5"), (b"x y z\n1 2 3\n", "no HDF5"),
                              (good[: len(good) // 2], "truncated"), (good[:-1], "truncated"),
                              (good.replace(b"PointSplatOctree", b"PointSplatOctavo"),
                               "was not written by")):
            with open(other, "wb") as file:
                file.write(content)
            refused(other, what)

    def test_damaged(self):
        """Bytes that changed are an error or other values, never a crash."""
        self.write(torus(3000))
        with open(self.name, "rb") as file:
            good = file.read()
        dice = random.Random(5)
        other = os.path.join(self.folder, "damaged.h5")
        errors = 0
        for _ in range(150):
            bad = bytearray(good)
            for _ in range(dice.choice((1, 8, 64))):
                # Most of the tree's own numbers lie in what is not deflated, at the beginning of groups.
                bad[dice.randrange(len(bad))] = dice.randrange(256)
            with open(other, "wb") as file:
                file.write(bad)
            read, _ = self.read(dice.choice((0, 500)), None, other)
            text = self.said()
            errors += "damaged" in text or "truncated" in text or "was not written" in text
            self.assertTrue(text or read.GetNumberOfPoints() > 0)
        self.assertGreater(errors, 20)


if __name__ == "__main__":
    main()
