# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What scenes do with vtkPolyDataMapper, done with splats of the same ball: the same picture."""
import gc
import itertools
import os
import subprocess
import sys
import unittest

import vtkmodules.vtkRenderingFreeType  # pylint: disable=unused-import
from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData,
    vtkElevationFilter,
    vtkPolyDataConnectivityFilter,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkCellPicker,
    vtkPointPicker,
    vtkPolyDataMapper,
    vtkPropPicker,
    vtkRenderer,
    vtkWindowToImageFilter,
    vtkWorldPointPicker,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor
from vtkmodules.vtkRenderingCore import vtkLODProp3D
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkEDLShading,
    vtkOpenGLFXAAPass,
    vtkRenderStepsPass,
    vtkSSAAPass,
)

SIZE = 150


class Scene:
    """A ball, by splats or by its mesh."""

    def __init__(self, kind):
        ball = vtkSphereSource()
        ball.SetThetaResolution(160)
        ball.SetPhiResolution(80)
        self.source = vtkElevationFilter()
        self.source.SetInputConnection(ball.GetOutputPort())
        self.source.SetLowPoint(0, -0.5, 0)
        self.source.SetHighPoint(0, 0.5, 0)
        self.mapper = kind()
        self.mapper.SetInputConnection(self.source.GetOutputPort())
        self.mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.actor.GetProperty().SetColor(0.9, 0.6, 0.3)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.2, 0.4)
        self.renderer.GetActiveCamera().SetPosition(0, 0, 2.4)
        self.renderer.GetActiveCamera().SetClippingRange(1.0, 4.0)
        self.window = vtkEGLHeadlessRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)

    def show(self, prop=None):
        self.renderer.AddViewProp(prop or self.actor)
        return self.picture()

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        width, height = self.window.GetSize()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        return bytes(memoryview(pixels))

    def translucent(self):
        self.actor.GetProperty().SetOpacity(0.4)
        other = vtkActor()
        other.ShallowCopy(self.actor)
        other.SetPosition(0.2, 0.1, 0.3)
        self.renderer.AddActor(other)
        return self.show()


def plain(scene):
    return scene.show()


def largest_region(scene):
    """Of two balls the larger one: the points of the other are there still, and of no cell."""
    other = vtkSphereSource()
    other.SetThetaResolution(60)
    other.SetPhiResolution(60)
    other.SetCenter(0.3, 0.3, 0.6)
    other.SetRadius(0.25)
    both = vtkAppendPolyData()
    both.AddInputConnection(scene.source.GetOutputPort())
    both.AddInputConnection(other.GetOutputPort())
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(both.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    scene.mapper.SetInputConnection(largest.GetOutputPort())
    picture = scene.show()
    if isinstance(scene.mapper, vtkPointSplatMapper):
        assert " that no cell uses" in scene.mapper.GetChoices()
    return picture


def scalar_bar(scene):
    table = vtkLookupTable()
    table.SetHueRange(0.7, 0.0)
    table.Build()
    scene.mapper.SetLookupTable(table)
    scene.mapper.ScalarVisibilityOn()
    bar = vtkScalarBarActor()
    bar.SetLookupTable(scene.mapper.GetLookupTable())
    bar.SetTitle("height")
    scene.renderer.AddActor2D(bar)
    return scene.show()


def lod_actor(scene):
    actor = vtkLODActor()
    actor.SetMapper(scene.mapper)
    actor.SetProperty(scene.actor.GetProperty())
    return scene.show(actor)


def lod_prop(scene):
    prop = vtkLODProp3D()
    prop.AddLOD(scene.mapper, scene.actor.GetProperty(), 0.0)
    return scene.show(prop)


def assembly(scene):
    inner, outer = vtkAssembly(), vtkAssembly()
    inner.AddPart(scene.actor)
    inner.SetScale(0.7, 0.7, 0.7)
    inner.RotateX(30)
    outer.AddPart(inner)
    outer.SetPosition(0.1, -0.1, 0.0)
    return scene.show(outer)


def clipping(scene):
    plane = vtkPlane()
    plane.SetNormal(1, 0.5, -1)
    plane.SetOrigin(-0.1, 0, 0.2)
    scene.mapper.AddClippingPlane(plane)
    return scene.show()


def stereo(kind):
    def draw(scene):
        scene.window.StereoCapableWindowOn()
        getattr(scene.window, "SetStereoTypeTo" + kind)()
        scene.window.StereoRenderOn()
        return scene.show()

    draw.__name__ = "stereo_" + kind
    return draw


def tiles(scene):
    scene.show()
    image = vtkWindowToImageFilter()
    image.SetInput(scene.window)
    image.SetScale(3, 2)
    image.ReadFrontBufferOff()
    image.Update()
    return bytes(memoryview(image.GetOutput().GetPointData().GetScalars()))


def viewport(scene):
    scene.renderer.SetViewport(0.2, 0.1, 0.7, 0.9)
    return scene.show()


def passes(kind):
    def draw(scene):
        steps = vtkRenderStepsPass()
        outer = kind()
        outer.SetDelegatePass(steps)
        scene.renderer.SetPass(outer)
        return scene.show()

    draw.__name__ = kind.__name__
    return draw


def ssao(scene):
    scene.renderer.UseSSAOOn()
    scene.renderer.SetSSAORadius(0.3)
    scene.renderer.SetSSAOBias(0.01)
    return scene.show()


def fxaa(scene):
    scene.renderer.UseFXAAOn()
    return scene.show()


def samples(scene):
    scene.window.SetMultiSamples(8)
    return scene.show()


def without_peeling(scene):
    # VTK weights translucent meshes then; splats are peeled all the same.
    if isinstance(scene.mapper, vtkPointSplatMapper):
        return scene.translucent()
    return dual_peeling(scene)


def dual_peeling(scene):
    scene.renderer.UseDepthPeelingOn()
    scene.renderer.SetMaximumNumberOfPeels(16)
    return scene.translucent()


def legacy_peeling(scene):
    os.environ["VTK_USE_LEGACY_DEPTH_PEELING"] = "1"
    try:
        return dual_peeling(scene)
    finally:
        del os.environ["VTK_USE_LEGACY_DEPTH_PEELING"]


SCENES = (
    plain, largest_region, scalar_bar, lod_actor, lod_prop, assembly, clipping, stereo("Anaglyph"),
    stereo("RedBlue"), stereo("Interlaced"), stereo("Checkerboard"), tiles, viewport,
    passes(vtkSSAAPass), passes(vtkEDLShading), passes(vtkOpenGLFXAAPass), ssao, fxaa, samples,
    without_peeling, dual_peeling, legacy_peeling,
)  # fmt: skip


def difference(a, b):
    return sum(abs(x - y) for x, y in zip(a, b)) / len(a)


class TestLikeAnyMapper(unittest.TestCase):
    def test_pictures(self):
        ground = Scene(vtkPolyDataMapper).picture()
        for draw in SCENES:
            with self.subTest(draw.__name__):
                mesh = draw(Scene(vtkPolyDataMapper))
                splats = draw(Scene(vtkPointSplatMapper))
                self.assertEqual(len(splats), len(mesh))
                self.assertLess(difference(splats, mesh), 1.5)
                if len(mesh) == len(ground):
                    self.assertGreater(difference(mesh, ground), 5.0, "a scene that shows the ball")

    def test_pickers(self):
        for picker in (vtkPropPicker(), vtkCellPicker(), vtkPointPicker(), vtkWorldPointPicker()):
            found = []
            for kind in (vtkPolyDataMapper, vtkPointSplatMapper):
                scene = Scene(kind)
                scene.show()
                hit = picker.Pick(SIZE / 2 + 10, SIZE / 2 + 5, 0, scene.renderer)
                actor = picker.GetActor() if hasattr(picker, "GetActor") else None
                found.append((hit, actor is scene.actor, picker.GetPickPosition()))
                miss = picker.Pick(2, 2, 0, scene.renderer)
                self.assertEqual(miss, 0)
            mesh, splats = found
            self.assertEqual(mesh[:2], splats[:2], picker.GetClassName())
            # VTK's point picker has another answer at each run, for the mesh too: of those in reach.
            reach = 0.06 if isinstance(picker, vtkPointPicker) else 0.01
            for a, b in zip(mesh[2], splats[2]):
                self.assertAlmostEqual(a, b, delta=reach, msg=picker.GetClassName())

    def test_orders_of_deletion(self):
        for order in itertools.permutations(("mapper", "actor", "renderer", "window")):
            scene = Scene(vtkPointSplatMapper)
            scene.show()
            for name in order:
                delattr(scene, name)
                gc.collect()
                if hasattr(scene, "window"):
                    scene.window.Render()

    def test_versions_of_opengl(self):
        script = (
            "import sys; sys.argv = ['']; from TestLikeAnyMapper import *\n"
            "scene = Scene(vtkPointSplatMapper); picture = scene.show()\n"
            "print(scene.mapper.GetProjectionUsed(), sum(picture[::7]) / len(picture[::7]))"
        )
        seen = {}
        for version in ("3.2", "3.3", "4.1", "4.2", "4.3", "4.5"):
            environment = {**os.environ, "MESA_GL_VERSION_OVERRIDE": version}
            done = subprocess.run(
                [sys.executable, "-c", script], cwd=os.path.dirname(os.path.abspath(__file__)),
                env=environment, capture_output=True, text=True, timeout=100, check=False,
            )  # fmt: skip
            self.assertEqual((done.returncode, done.stderr), (0, ""), version)
            seen[version] = done.stdout.split()
            self.assertAlmostEqual(float(seen[version][1]), float(seen["3.2"][1]), delta=0.5)
        if seen["4.5"][0] == "compute":
            self.assertEqual(seen["4.3"][0], "compute")
        self.assertEqual(seen["3.2"][0], "quads")


if __name__ == "__main__":
    unittest.main()
