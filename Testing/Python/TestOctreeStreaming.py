# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPointSplatOctreeReader that follows a camera, with its cache, and vtkPointSplatOctreeWriter that
adds to a file.

TestOctreeStreaming.py [--pictures FOLDER], with the package pointsplatting to be found. The pictures
that are compared are written to the folder.
"""
import os
import shutil
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkRenderer, vtkWindowToImageFilter)
import pointsplatting

from octree_tools import COUNT, FAR, OctreeTest, main, positions, torus

PICTURES = sys.argv.pop(2) if sys.argv[1:2] == ["--pictures"] else None
if PICTURES:
    sys.argv.pop(1)
SIZE = 300  # pixels of a view, both ways


def camera_at(*position, focus=(0, 0, 0), parallel=None):
    """About the torus's middle; parallel: half the height that is seen."""
    camera = vtkCamera()
    camera.SetFocalPoint(*(FAR + x for x in focus))
    camera.SetPosition(*(FAR + x for x in position))
    camera.SetViewUp(0, 0, 1)
    if parallel:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(parallel)
    return camera


def in_view(points, camera):
    """Which of the points are inside the picture's sides."""
    projection = camera.GetProjectionTransformMatrix(1.0, -1, 1)
    view = camera.GetViewTransformMatrix()
    rows = np.array([[m.GetElement(i, j) for j in range(4)] for m in (projection, view)
                     for i in range(4)]).reshape(2, 4, 4)  # fmt: skip
    clip = np.c_[points, np.ones(len(points))] @ (rows[0] @ rows[1]).T
    return (np.abs(clip[:, 0]) <= clip[:, 3]) & (np.abs(clip[:, 1]) <= clip[:, 3])


def bumpy_ball(count):
    draws = np.random.default_rng(4)
    out = draws.normal(size=(count, 3))
    out /= np.linalg.norm(out, axis=1)[:, None]
    waves = 9 * out
    radius = 1 + 0.03 * np.sin(waves).sum(1)
    slope = 0.27 * np.cos(waves)
    slope -= (slope * out).sum(1)[:, None] * out
    normals = radius[:, None] * out - slope
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(FAR + radius[:, None] * out, deep=1))
    data.SetPoints(points)
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype("f4"), deep=1))
    size = numpy_to_vtk(np.full(count, 1.6 * np.sqrt(4.5 * np.pi / count), "f4"), deep=1)
    size.SetName("SplatRadius")
    data.GetPointData().AddArray(size)
    return data


class View:
    """A window with a mapper."""

    def __init__(self, camera, size=400):
        self.mapper = pointsplatting.vtkPointSplatMapper()
        self.mapper.ScalarVisibilityOff()
        self.mapper.LevelOfDetailOff()
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        # No pixel is white: there all pictures would be alike.
        actor.GetProperty().SetColor(0.35, 0.55, 0.75)
        actor.GetProperty().SetSpecular(0.2)
        actor.GetProperty().SetSpecularPower(20)
        self.renderer = vtkRenderer()
        self.renderer.SetActiveCamera(camera)
        self.renderer.AddActor(actor)
        self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)

    def picture(self, data, name):
        shown = vtkPolyData()
        shown.ShallowCopy(data)
        self.mapper.SetInputData(shown)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.ReadFrontBufferOff()
        image.Update()
        if PICTURES:
            writer = vtkPNGWriter()
            writer.SetFileName(os.path.join(PICTURES, name + ".png"))
            writer.SetInputData(image.GetOutput())
            writer.Write()
        return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).astype(float)


class TestOctreeStreaming(OctreeTest):
    def reader(self, camera=None, name=None):
        reader = pointsplatting.vtkPointSplatOctreeReader()
        reader.SetFileName(self.name if name is None else name)
        reader.SetCamera(camera)
        reader.SetViewSize(SIZE, SIZE)
        return reader

    def count(self, reader):
        reader.Update()
        return reader.GetOutput().GetNumberOfPoints()

    def test_what_is_seen_is_fine(self):
        whole = torus()
        self.write(whole)
        coarsest = self.read(1)[0].GetNumberOfPoints()
        # From outside, from inside of the ring's tube, and along parallel lines.
        for camera in (camera_at(1.6, 0, 0.3, focus=(1.2, 0, 0)),
                       camera_at(1, 0, 0, focus=(1, 0.3, 0.1)),
                       camera_at(1.5, 0, 2, focus=(1.2, 0, 0), parallel=0.3)):
            reader = self.reader(camera)
            count = self.count(reader)
            self.assertLess(count, 0.75 * COUNT)
            self.assertGreater(count, coarsest)
            cut = positions(reader.GetOutput())
            seen = in_view(positions(whole), camera)
            self.assertGreater(int(seen.sum()), 500)
            # A pixel is smaller than the points are apart: all that are seen are there.
            own = {tuple(x) for x in cut}
            missing = [x for x in positions(whole)[seen] if tuple(x) not in own]
            self.assertEqual(len(missing), 0)
            # What is off is there, but coarse.
            self.assertGreater(int((~in_view(cut, camera)).sum()), coarsest / 4)
            self.assertEqual(self.said(), "")

    def test_what_is_far_is_coarse(self):
        self.write(torus())
        counts = []
        for distance in (6, 20, 100, 1e4):
            counts.append(self.count(self.reader(camera_at(0, -distance, 0.5 * distance))))
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertEqual(counts[-1], self.read(1)[0].GetNumberOfPoints())
        # Parallel lines: how much is seen matters, and not from where.
        near, far = (self.count(self.reader(camera_at(0, -d, 0.5 * d, parallel=2))) for d in (3, 90))
        self.assertAlmostEqual(near / far, 1, delta=0.02)
        wide = self.count(self.reader(camera_at(0, -3, 1, parallel=20)))
        self.assertLess(wide, 0.2 * near)
        # Turned away: there is nothing to refine.
        away = self.count(self.reader(camera_at(0, -5, 0, focus=(0, -9, 0))))
        self.assertEqual(away, counts[-1])

    def test_room_and_size(self):
        self.write(torus())
        camera = camera_at(0, -6, 3)
        reader = self.reader(camera)
        counts = []
        for pixels in (0, 1, 2, 4, 30):
            reader.SetSplatPixels(pixels)
            counts.append(self.count(reader))
        self.assertEqual(counts[0], COUNT)
        self.assertEqual(counts, sorted(counts, reverse=True))
        reader.SetSplatPixels(0)
        for room in (30000, 5000):
            reader.SetMaximumNumberOfPoints(room)
            count = self.count(reader)
            self.assertTrue(0.6 * room < count <= room, count)
        # Where there is no room for all it is nearest to the eye that is finest.
        camera.SetPosition(FAR + 2.0, FAR, FAR + 0.3)
        camera.SetFocalPoint(FAR, FAR, FAR)
        reader.Modified()
        self.count(reader)
        cut = positions(reader.GetOutput()) - FAR
        self.assertGreater((cut[:, 0] > 0.7).sum(), 3 * (cut[:, 0] < -0.7).sum())

    def test_bad_cameras(self):
        self.write(torus())
        coarsest = self.read(1)[0].GetNumberOfPoints()
        for spoil in (lambda c: c.SetPosition(np.nan, 0, 0), lambda c: c.SetPosition(np.inf, 0, 0),
                      lambda c: c.SetPosition(c.GetFocalPoint())):
            camera = camera_at(0, -3, 2)
            spoil(camera)
            reader = self.reader(camera)
            self.assertEqual(self.count(reader), coarsest)
            self.assertIn("camera", self.said())
            reader.FollowCamera()
            self.assertFalse(reader.Prefetch(1))
        reader = self.reader(camera_at(0, -3, 2))
        reader.SetSplatPixels(np.nan)
        self.assertIn("NaN", self.said())
        reader.SetSplatPixels(-1)
        self.assertEqual(reader.GetSplatPixels(), 0)
        reader.SetViewSize(0, -5)
        self.assertEqual(reader.GetViewSize(), (1, 1))
        reader.SetSplatPixels(2)
        self.assertEqual(self.count(reader), coarsest)
        reader.SetCamera(None)
        self.assertEqual(self.count(reader), COUNT)
        self.assertFalse(reader.FollowCamera())
        self.assertFalse(reader.Prefetch(1))
        self.assertEqual(self.said(), "")

    def test_pieces_of_unlike_size(self):
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        self.assertTrue(writer.Open())
        for seed, count in enumerate((1, 70000, 300, 9)):
            self.assertTrue(writer.Append(torus(count, seed)))
        self.assertTrue(writer.Close())
        reader = self.reader(camera_at(0, -40, 20))
        far = self.count(reader)
        self.assertLess(far, 10000)
        reader.GetCamera().SetPosition(FAR, FAR - 3, FAR + 2)
        self.assertTrue(reader.FollowCamera())
        self.assertGreater(self.count(reader), 5 * far)
        reader.SetCamera(None)
        self.assertEqual(self.count(reader), 70310)
        self.assertEqual(self.said(), "")

    def test_it_follows(self):
        self.write(torus())
        camera = camera_at(0, -36, 24)
        reader = self.reader(camera)
        self.assertFalse(reader.FollowCamera())  # there is nothing yet
        reader.Update()
        before = reader.GetMTime()
        camera.Azimuth(0.01)
        self.assertEqual(reader.GetMTime(), before)
        self.assertFalse(reader.FollowCamera())
        self.assertEqual(reader.GetMTime(), before)
        coarse = self.count(reader)
        camera.Dolly(6)
        self.assertEqual(self.count(reader), coarse)
        self.assertTrue(reader.FollowCamera())
        self.assertTrue(reader.FollowCamera())  # until it is read
        self.assertGreater(self.count(reader), 2 * coarse)
        self.assertFalse(reader.FollowCamera())
        camera.Dolly(1 / 6)
        self.assertTrue(reader.FollowCamera())
        self.assertAlmostEqual(self.count(reader) / coarse, 1, delta=0.02)

    def test_cache(self):
        self.write(torus())
        camera = camera_at(1.5, 0, 0.3, focus=(1.2, 0, 0))
        reader = self.reader(camera)
        self.assertEqual(reader.GetCacheSize(), 512 * 1024)
        self.count(reader)
        first = reader.GetNumberOfBytesRead()
        self.assertGreater(first, 0)
        self.assertAlmostEqual(reader.GetCacheSizeUsed(), first // 1024, delta=1)
        reader.Modified()
        self.count(reader)
        self.assertEqual(reader.GetNumberOfBytesRead(), first)
        # Elsewhere, and back.
        camera.SetPosition(FAR - 1.5, FAR, FAR + 0.3)
        camera.SetFocalPoint(FAR - 1.2, FAR, FAR)
        self.assertTrue(reader.FollowCamera())
        self.count(reader)
        both = reader.GetNumberOfBytesRead()
        self.assertGreater(both, first)
        camera.SetPosition(FAR + 1.5, FAR, FAR + 0.3)
        camera.SetFocalPoint(FAR + 1.2, FAR, FAR)
        self.assertTrue(reader.FollowCamera())
        self.count(reader)
        self.assertEqual(reader.GetNumberOfBytesRead(), both)
        # With little room the budget is kept, and the same points come.
        points = positions(reader.GetOutput()).copy()
        for size in (1000, 64, 0):
            reader.SetCacheSize(size)
            self.assertLessEqual(reader.GetCacheSizeUsed(), size)
            reader.Modified()
            self.count(reader)
            self.assertLessEqual(reader.GetCacheSizeUsed(), size)
            np.testing.assert_array_equal(positions(reader.GetOutput()), points)
        self.assertEqual(reader.GetCacheSizeUsed(), 0)
        self.assertGreater(reader.GetNumberOfBytesRead(), both)
        reader.SetCacheSize(-7)
        self.assertEqual(reader.GetCacheSize(), 0)
        reader.SetCacheSize(1 << 62)  # no overflow
        self.assertGreater(reader.GetCacheSize(), 1 << 50)
        self.assertEqual(self.said(), "")

    def test_prefetch(self):
        """A camera that goes on along its way finds everything there."""
        data = torus(400000)
        for name in ("texts", "bits"):
            data.GetPointData().RemoveArray(name)
        self.write(data)
        fetched = {}
        for ahead in (False, True):
            camera = camera_at(0, -1.55, 0.1, focus=(0, -1.4, 0))
            reader = self.reader(camera)
            reader.SetMaximumNumberOfPoints(100000)
            self.count(reader)
            self.assertFalse(reader.Prefetch(1))  # it has not moved
            step = np.array([0.03, 0.02, 0.03]) * 3
            for _ in range(2):
                camera.SetPosition(np.array(camera.GetPosition()) + step)
                camera.SetFocalPoint(np.array(camera.GetFocalPoint()) + step)
                if ahead:
                    slices = 0
                    while reader.Prefetch(0):
                        slices += 1
                self.assertTrue(reader.FollowCamera())
                before = reader.GetNumberOfBytesRead()
                self.count(reader)
            fetched[ahead] = reader.GetNumberOfBytesRead() - before
            if ahead:
                self.assertGreater(slices, 1)
        self.assertGreater(fetched[False], 0)
        self.assertEqual(fetched[True], 0)
        # What the cut uses is not given up for what it may use.
        reader = self.reader(camera_at(0, -1.55, 0.1, focus=(0, -1.4, 0)))
        self.count(reader)
        reader.SetCacheSize(reader.GetCacheSizeUsed() + 100)
        reader.GetCamera().Azimuth(10)
        reader.FollowCamera()
        while reader.Prefetch(0.001):
            pass
        reader.GetCamera().Azimuth(-10)
        before = reader.GetNumberOfBytesRead()
        reader.Modified()
        self.count(reader)
        self.assertEqual(reader.GetNumberOfBytesRead(), before)

    def test_file_changes_while_it_is_open(self):
        self.write(torus(3000))
        reader = self.reader(camera_at(0, -3, 2))
        reader.SetSplatPixels(0)
        self.assertEqual(self.count(reader), 3000)
        # Another in its place.
        self.assertEqual(self.write(torus(4000))[0], 1)
        self.assertTrue(reader.FollowCamera())
        self.assertEqual(self.count(reader), 4000)
        self.assertFalse(reader.FollowCamera())
        # Written over, and half of it is missing.
        with open(self.name, "rb") as file:
            good = file.read()
        with open(self.name, "r+b") as file:
            file.truncate(len(good) // 2)
        self.assertTrue(reader.FollowCamera())
        self.assertFalse(reader.Prefetch(1))
        self.assertEqual(self.count(reader), 0)
        self.assertIn("truncated", self.said())
        self.assertFalse(reader.FollowCamera())
        # Its inside is other bytes.
        for fill in (b"\0", b"\xff", b"x"):
            with open(self.name, "wb") as file:
                file.write(good)
            reader.Modified()
            self.assertEqual(self.count(reader), 4000)
            self.said()
            with open(self.name, "r+b") as file:
                file.seek(2000)
                file.write(fill * (len(good) - 4000))
            reader.Modified()
            self.count(reader)
            self.assertNotEqual(self.said(), "")
        # It comes back, and goes.
        with open(self.name, "wb") as file:
            file.write(good)
        reader.Modified()
        self.assertEqual(self.count(reader), 4000)
        os.remove(self.name)
        self.assertTrue(reader.FollowCamera())
        self.assertEqual(self.count(reader), 0)
        self.assertIn("is not there", self.said())

    def test_damaged_files(self):
        """Bytes that changed are an error or other values, never a crash, wherever the camera goes."""
        self.write(torus(8000))
        with open(self.name, "rb") as file:
            good = file.read()
        dice = np.random.default_rng(9)
        errors = 0
        for _ in range(80):
            bad = np.frombuffer(good, np.uint8).copy()
            bad[dice.integers(len(bad), size=dice.choice((1, 8, 64)))] = dice.integers(256)
            bad.tofile(self.name)
            camera = camera_at(0, -9, 4)
            reader = self.reader(camera)
            for _ in range(4):
                self.count(reader)
                camera.Dolly(1.6)
                reader.FollowCamera()
                reader.Prefetch(1)
            errors += self.said() != ""
        self.assertGreater(errors, 10)

    def test_file_is_closed(self):
        def opened():
            return sum(os.path.realpath(f"/proc/self/fd/{f}").startswith(self.folder)
                       for f in os.listdir("/proc/self/fd"))

        if not os.path.isdir("/proc/self/fd"):
            self.skipTest("no list of open files here")
        before = opened()
        self.write(torus(3000))
        other = os.path.join(self.folder, "other.h5")
        self.write(torus(2000), other)
        reader = self.reader()
        self.assertEqual(self.count(reader), 3000)
        self.assertEqual(opened(), before + 1)
        reader.SetFileName(other)
        self.assertEqual(self.count(reader), 2000)
        self.assertEqual(opened(), before + 1)
        reader.CloseFile()
        reader.CloseFile()
        self.assertEqual((opened(), reader.GetCacheSizeUsed()), (before, 0))
        reader.Modified()
        self.assertEqual(self.count(reader), 2000)
        del reader
        self.assertEqual(opened(), before)

    def test_append(self):
        self.write(torus(3000))
        reader = self.reader()
        self.assertEqual(self.count(reader), 3000)
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        writer.AppendToFileOn()
        high = torus(2000, 7)
        points = positions(high)
        points[:, 2] += 5
        writer.SetInputData(high)
        self.assertEqual(writer.Write(), 1)  # while a reader has it open
        self.assertEqual((writer.GetNumberOfPointsWritten(), writer.GetNumberOfPiecesWritten()), (5000, 2))
        self.assertTrue(writer.Open())
        for seed in (8, 9):
            self.assertTrue(writer.Append(torus(500, seed)))
        self.assertTrue(writer.Close())
        self.assertEqual((writer.GetNumberOfPointsWritten(), writer.GetNumberOfPiecesWritten()), (6000, 4))
        reader.Modified()
        self.assertEqual(self.count(reader), 6000)
        self.assertEqual(reader.GetNumberOfPointsInFile(), 6000)
        self.assertAlmostEqual(reader.GetBoundsInFile()[5], points[:, 2].max())
        self.assertAlmostEqual(reader.GetBoundsInFile()[4], FAR - 0.4, delta=1e-3)
        self.assertEqual(sorted(os.listdir(self.folder)), ["cloud.h5"])
        # Scalars of another name are another quantity, be they both the active ones.
        other = torus(500, 10)
        other.GetPointData().GetScalars().SetName("pressure")
        writer.SetInputData(other)
        self.assertEqual(writer.Write(), 1)
        reader.Modified()
        self.assertEqual(self.count(reader), 6500)
        for name in ("height", "pressure"):
            self.assertIsNone(reader.GetOutput().GetPointData().GetArray(name))
        self.assertIsNotNone(reader.GetOutput().GetPointData().GetNormals())
        # Without a file it is a new one.
        new = os.path.join(self.folder, "new.h5")
        writer.SetFileName(new)
        writer.SetInputData(torus(700))
        for count in (700, 1400):
            self.assertEqual(writer.Write(), 1)
            self.assertEqual(self.read(0, None, new)[0].GetNumberOfPoints(), count)
        self.assertEqual(self.said(), "")

    def test_append_that_fails(self):
        self.write(torus(3000))
        with open(self.name, "rb") as file:
            good = file.read()

        def refused(content, what, data):
            with open(self.name, "wb") as file:
                file.write(content)
            writer = pointsplatting.vtkPointSplatOctreeWriter()
            writer.SetFileName(self.name)
            writer.AppendToFileOn()
            writer.SetInputData(data)
            self.assertEqual(writer.Write(), 0)
            self.assertIn(what, self.said())
            with open(self.name, "rb") as file:
                self.assertEqual(file.read(), content)
            self.assertFalse(os.path.exists(self.name + ".part"))

        refused(b"x y z\n", "no HDF5", torus(10))
        refused(b"", "no HDF5", torus(10))
        refused(good[:-9], "truncated", torus(10))
        refused(good.replace(b"PointSplatOctree", b"PointSplatOctavo"), "was not written by", torus(10))
        refused(good, "no point", vtkPolyData())
        spoilt = bytearray(good)
        for at in range(4000, len(good) - 4000, 97):
            spoilt[at] ^= 0xFF
        refused(bytes(spoilt), "was not written", torus(10))
        # Given up, with a file that another run has left behind.
        shutil.copy(self.name, self.name + ".part")
        with open(self.name, "wb") as file:
            file.write(good)
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name)
        writer.AppendToFileOn()
        self.assertTrue(writer.Open())
        self.assertTrue(writer.Append(torus(100)))
        del writer
        self.assertFalse(os.path.exists(self.name + ".part"))
        with open(self.name, "rb") as file:
            self.assertEqual(file.read(), good)

    def test_pictures(self):
        """Of the camera's cut, against all points."""
        count = 1200000
        self.write(bumpy_ball(count))
        whole = self.read()[0]
        for name, camera, most in (
                ("far", camera_at(0, -9, 4), 0.1), ("whole", camera_at(0, -5.5, 2), 0.6),
                ("close", camera_at(0, -1.3, 0.6, focus=(0, -0.9, 0.3)), 0.3),
                ("inside", camera_at(0.2, 0.1, 0, focus=(1, 0.5, 0.2)), 0.4),
                ("parallel", camera_at(0, -4, 2, parallel=1.6), 0.5)):
            view = View(camera)
            reader = self.reader(camera)
            reader.SetViewSize(view.window.GetSize())
            cut = self.count(reader)
            best = view.picture(whole, name + "-all")
            error = ((view.picture(reader.GetOutput(), name + "-cut") - best) ** 2).mean()
            psnr = 10 * np.log10(255**2 / max(error, 1e-9))
            print(f"{name}: {cut} splats of {count}, {psnr:.1f} dB")
            self.assertLess(cut, most * count, name)
            self.assertGreater(psnr, 45, name)
            view.window.Finalize()


if __name__ == "__main__":
    main()
