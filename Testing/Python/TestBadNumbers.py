# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that no user means: NaN for a property, points beyond all others, sizes of other points."""
import math
import random
import unittest

import pointsplatting
from pointsplatting import (
    vtkEGLHeadlessRenderWindow,
    vtkIsosurfacePoints,
    vtkPointSplatEstimation,
    vtkPointSplatMapper,
)
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkMaskPoints
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

CLASSES = (
    "vtkIsosurfacePoints vtkParticleSurfacePoints vtkPointShadowTexture vtkPointSplatEstimation"
    " vtkPointSplatGrouping vtkPointSplatMapper vtkPointSplatPass vtkPointSplatProjection"
    " vtkPointSplatShadowPass"
).split()


def ball(count=4000, far=(), normals=True):
    """Random points of a unit ball's surface, and those far off."""
    random.seed(1)
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    array = vtkFloatArray()
    array.SetName("Normals")
    array.SetNumberOfComponents(3)
    for _ in range(count):
        z, a = random.uniform(-1, 1), random.uniform(0, 2 * math.pi)
        r = math.sqrt(1 - z * z)
        points.InsertNextPoint(r * math.cos(a), r * math.sin(a), z)
        array.InsertNextTuple3(r * math.cos(a), r * math.sin(a), z)
    for point in far:
        points.InsertNextPoint(point)
        array.InsertNextTuple3(0, 0, 1)
    data.SetPoints(points)
    if normals:
        data.GetPointData().SetNormals(array)
    return data


class Drawn:
    """A mapper that counts what it is told to say, in a window with a camera that stays."""

    def __init__(self, data, size=120):
        self.warnings, self.errors, self.progress = 0, 0, []
        self.mapper = vtkPointSplatMapper()
        self.mapper.AddObserver("WarningEvent", self.warn)
        self.mapper.AddObserver("ErrorEvent", self.err)
        self.mapper.SetInputDataObject(data)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.renderer.GetActiveCamera().SetPosition(0, 0, 6)
        self.renderer.GetActiveCamera().SetClippingRange(1, 20)
        self.window = vtkEGLHeadlessRenderWindow()
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        self.size = size

    def warn(self, *_):
        self.warnings += 1

    def err(self, *_):
        self.errors += 1

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        last = self.size - 1
        self.window.GetPixelData(0, 0, last, last, 0, pixels, 0)
        return bytes(memoryview(pixels))


class TestBadNumbers(unittest.TestCase):
    def test_no_setter_keeps_nan(self):
        tried = 0
        for name in CLASSES:
            thing = getattr(pointsplatting, name)()
            errors = []
            thing.AddObserver("ErrorEvent", lambda *_, errors=errors: errors.append(1))
            for setter in (m for m in dir(thing) if m.startswith("Set")):
                getter = getattr(thing, "Get" + setter[3:], None)
                try:
                    before = getter()
                except TypeError:
                    continue
                if isinstance(before, float):
                    arguments = (math.nan,)
                elif isinstance(before, tuple) and before and isinstance(before[0], float):
                    arguments = (math.nan,) * len(before)
                else:
                    continue
                owner = next(c for c in type(thing).__mro__ if setter in vars(c))
                if owner.__name__ != name:
                    continue  # VTK's own
                getattr(thing, setter)(*arguments)
                self.assertEqual(getter(), before, (name, setter))
                tried += 1
                if setter != "SetAbsorption":
                    self.assertEqual(len(errors), 1, (name, setter))
                errors.clear()
        self.assertGreater(tried, 30)

    def test_setters_clamp(self):
        mapper = vtkPointSplatMapper()
        for value, kept in ((30.0, 8.0), (-1.0, 1e-6), (2.0, 2.0), (math.inf, 8.0)):
            mapper.SetRadiusScale(value)
            self.assertEqual(mapper.GetRadiusScale(), kept)

    def test_points_far_off(self):
        for normals in (True, False):
            good = Drawn(ball(normals=normals)).picture()
            self.assertGreater(max(good), 100)
            for far in ((3e38, 0, 0), (0, 1e30, 0), (1e300, -1e300, 0), (0, 0, 1e12)):
                with self.subTest(far=far, normals=normals):
                    spoilt = Drawn(ball(far=[far, far], normals=normals))
                    picture = spoilt.picture()
                    spoilt.picture()
                    difference = sum(abs(a - b) for a, b in zip(good, picture)) / len(good)
                    self.assertLess(difference, 0.1)
                    self.assertEqual(spoilt.mapper.GetNumberOfSkippedPoints(), 2)
                    self.assertEqual((spoilt.warnings, spoilt.errors), (1, 0))
                    self.assertLess(max(map(abs, spoilt.mapper.GetBounds())), 1.01)
        # What is only far is drawn.
        far = Drawn(ball(far=[(5e4, 0, 0), (0, 5e4, 0)]))
        far.picture()
        self.assertEqual((far.mapper.GetNumberOfSkippedPoints(), far.warnings), (0, 0))

    def test_windows_of_more_pixels_than_memory(self):
        large = Drawn(ball())
        large.mapper.SetProjectionToQuads()
        large.mapper.SetMaximumWindowMemory(1 << 28)
        large.window.SetMultiSamples(0)
        large.window.SetSize(16384, 500)
        large.window.Render()
        self.assertEqual(large.errors, 0)
        self.assertLess(large.mapper.GetImageMemorySize(), 1 << 28)
        pixels = vtkUnsignedCharArray()
        large.window.GetPixelData(8192, 250, 8192, 250, 0, pixels, 0)
        self.assertGreater(pixels.GetValue(0), 100)
        large.window.SetSize(120, 120)
        self.assertGreater(max(large.picture()), 100)
        self.assertEqual(large.errors, 0)

    def test_sizes_of_other_points(self):
        def estimated(data):
            estimation = vtkPointSplatEstimation()
            estimation.SetInputData(data)
            estimation.Update()
            return estimation.GetOutput()

        def scaled(data, factor):
            transform = vtkTransform()
            transform.Scale(factor, factor, factor)
            scaling = vtkTransformFilter()
            scaling.SetTransform(transform)
            scaling.SetInputData(data)
            scaling.Update()
            return scaling.GetOutput()

        grid = vtkSphereSource()
        grid.SetThetaResolution(80)
        grid.SetPhiResolution(40)
        grid.Update()
        wave = vtkRTAnalyticSource()
        wave.SetWholeExtent(-12, 12, -12, 12, -12, 12)
        surface = vtkIsosurfacePoints()
        surface.SetInputConnection(wave.GetOutputPort())
        surface.SetValue(0, 150.0)
        surface.Update()
        clouds = {
            "random": estimated(ball()),
            "grid": estimated(grid.GetOutput()),
            "isosurface": surface.GetOutput(),
        }
        for name, cloud in clouds.items():
            for factor, wanted in ((1.0, 0), (1.2, 0), (5.0, 1), (0.15, 1), (1000.0, 1)):
                with self.subTest(name=name, factor=factor):
                    drawn = Drawn(scaled(cloud, factor))
                    drawn.picture()
                    drawn.picture()
                    self.assertEqual((drawn.warnings, drawn.errors), (wanted, 0))
            drawn = Drawn(cloud)
            drawn.actor.SetScale(5.0)
            drawn.picture()
            self.assertEqual(drawn.warnings, 0, name)
        # Estimating anew mends it.
        drawn = Drawn(estimated(scaled(clouds["random"], 5.0)))
        drawn.picture()
        self.assertEqual(drawn.warnings, 0)
        # And thinning leaves holes between sizes of before.
        thin = vtkMaskPoints()
        thin.SetInputData(clouds["random"])
        thin.SetOnRatio(40)
        thin.Update()
        drawn = Drawn(thin.GetOutput())
        drawn.picture()
        self.assertEqual(drawn.warnings, 1)


class TestProgress(unittest.TestCase):
    def test_the_mapper_tells_its_progress(self):
        for normals in (True, False):
            drawn = Drawn(ball(60000, normals=normals))
            told = []
            drawn.mapper.AddObserver(
                "ProgressEvent", lambda *_, told=told, m=drawn.mapper: told.append(m.GetProgress())
            )
            self.assertGreater(max(drawn.picture()), 100)
            self.assertGreater(len([p for p in told if 0.0 < p < 1.0]), 5)
            self.assertEqual(told, sorted(told))
            told.clear()
            drawn.picture()
            self.assertFalse([p for p in told if p < 1.0], "nothing is estimated twice")

    def test_it_can_be_aborted(self):
        for at in (0.01, 0.3):
            drawn = Drawn(ball(60000, normals=False))
            tag = drawn.mapper.AddObserver(
                "ProgressEvent",
                lambda *_, m=drawn.mapper, at=at: m.SetAbortExecute(int(m.GetProgress() >= at)),
            )
            self.assertEqual(max(drawn.picture()), 0)
            self.assertEqual(drawn.mapper.GetNumberOfSplats(), 0)
            self.assertEqual(max(drawn.picture()), 0)
            drawn.mapper.RemoveObserver(tag)
            self.assertGreater(max(drawn.picture()), 100, "and begun anew")
            self.assertEqual((drawn.warnings, drawn.errors), (0, 0))


if __name__ == "__main__":
    unittest.main()
