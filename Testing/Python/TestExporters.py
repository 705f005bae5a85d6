# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What writes geometry gets plain vertices with colours of splats, and one warning that says so."""
import json
import os
import re
import tempfile
import unittest

from pointsplatting import (
    vtkEGLHeadlessRenderWindow,
    vtkPointSplatMapper,
    vtkPointSplatPlainScene,
)
from vtkmodules import vtkIOExport
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOExportGL2PS import vtkGL2PSExporter
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper, vtkRenderer
import vtkmodules.vtkRenderingGL2PSOpenGL2  # noqa: F401 (the exporter's implementation)

POINTS = 362


def ball(x=0.0):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(20)
    source.SetPhiResolution(20)
    colours = vtkElevationFilter()
    colours.SetInputConnection(source.GetOutputPort())
    colours.Update()
    return colours.GetOutput()


def cloud(x=0.0):
    mesh = ball(x)
    points = vtkPolyData()
    points.SetPoints(mesh.GetPoints())
    points.GetPointData().ShallowCopy(mesh.GetPointData())
    return points


def blocks():
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, cloud())
    data.SetBlock(1, cloud(2.0))
    return data


class Scene:
    def __init__(self, *inputs, assembled=False):
        self.renderer = vtkRenderer()
        self.actors = []
        for data in inputs:
            mapper = vtkPointSplatMapper()
            mapper.SetInputDataObject(data)
            actor = vtkActor()
            actor.SetMapper(mapper)
            self.actors.append(actor)
            if assembled:
                assembly = vtkAssembly()
                assembly.AddPart(actor)
                actor = assembly
            self.renderer.AddActor(actor)
        self.window = vtkEGLHeadlessRenderWindow()
        self.window.SetSize(64, 64)
        self.window.AddRenderer(self.renderer)
        self.window.Render()
        self.warnings = []
        self.plain = vtkPointSplatPlainScene()
        self.plain.SetRenderWindow(self.window)
        self.plain.AddObserver("WarningEvent", lambda *_: self.warnings.append(1))


class TestExporters(unittest.TestCase):
    def export(self, scene, name, **settings):
        """The file's text."""
        exporter = getattr(vtkIOExport, name)()
        exporter.SetRenderWindow(scene.window)
        for setting, value in settings.items():
            getattr(exporter, setting)(value)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene")
            if hasattr(exporter, "SetFileName"):
                exporter.SetFileName(path)
            else:
                exporter.SetFilePrefix(path)
            scene.plain.Begin()
            exporter.Write()
            scene.plain.End()
            files = sorted(os.listdir(folder), key=lambda f: f.endswith(".mtl"))
            with open(os.path.join(folder, files[0]), encoding="latin1") as file:
                return file.read()

    def test_obj_has_a_vertex_a_point(self):
        text = self.export(Scene(cloud()), "vtkOBJExporter")
        self.assertEqual(len(re.findall(r"^v ", text, re.MULTILINE)), POINTS)
        self.assertEqual(len(re.findall(r"^p ", text, re.MULTILINE)), POINTS)
        self.assertEqual(len(re.findall(r"^vn ", text, re.MULTILINE)), POINTS)

    def test_gltf_has_points_with_colours(self):
        scene = json.loads(self.export(Scene(blocks()), "vtkGLTFExporter", SetInlineData=True))
        (mesh,) = scene["meshes"]
        (primitive,) = mesh["primitives"]
        self.assertEqual(primitive["mode"], 0)
        accessors = scene["accessors"]
        for attribute in ("POSITION", "COLOR_0"):
            self.assertEqual(accessors[primitive["attributes"][attribute]]["count"], 2 * POINTS)

    def test_all_survive_and_write_points_where_they_can(self):
        for name in ("IV", "OOGL", "POV", "RIB", "VRML", "X3D"):
            for data in (cloud(), blocks()):
                with self.subTest(name, data=data.GetClassName()):
                    text = self.export(Scene(data), f"vtk{name}Exporter")
                    # POV-Ray and RenderMan know no points.
                    if name not in ("OOGL", "POV", "RIB"):
                        self.assertGreater(len(text), 10 * POINTS)

    def test_vector_graphics_have_the_picture(self):
        drawn = []
        for mapper in (None, vtkPolyDataMapper()):
            scene = Scene(cloud())
            if mapper:
                mapper.SetInputData(ball())
                scene.actors[0].SetMapper(mapper)
            exporter = vtkGL2PSExporter()
            exporter.SetRenderWindow(scene.window)
            exporter.SetFileFormatToPS()
            exporter.CompressOff()
            with tempfile.TemporaryDirectory() as folder:
                exporter.SetFilePrefix(os.path.join(folder, "scene"))
                exporter.Write()
                with open(os.path.join(folder, "scene.ps"), encoding="latin1") as file:
                    image = max(re.findall(r"(?:[0-9A-Fa-f]{2,}\n)+", file.read()), key=len)
            pixels = re.findall("......", image.replace("\n", ""))
            self.assertGreaterEqual(len(pixels), 64 * 64)
            drawn.append(sum(pixel != "000000" for pixel in pixels))
        self.assertGreater(drawn[1], 1000)  # of the mesh
        self.assertLess(abs(drawn[0] - drawn[1]), 0.05 * drawn[1])

    def test_colours_are_those_that_are_drawn(self):
        scene = Scene(blocks())
        mapper = scene.actors[0].GetMapper()
        mapper.SetBlockColor(1, 1.0, 0.0, 0.0)
        mapper.SetBlockOpacity(1, 0.2)
        mapper.SetBlockVisibility(2, False)
        scene.plain.Begin()
        data = scene.actors[0].GetMapper().GetInput()
        self.assertEqual(data.GetNumberOfPoints(), POINTS)
        self.assertEqual(data.GetNumberOfVerts(), POINTS)
        self.assertEqual(data.GetPointData().GetScalars().GetTuple(7), (255, 0, 0, 51))
        scene.plain.End()
        mapper.RemoveBlockColors()
        mapper.RemoveBlockOpacities()
        for blended in (True, False):
            mapper.SetInterpolateScalarsBeforeMapping(not blended)
            scene.plain.Begin()
            colours = scene.actors[0].GetMapper().GetInput().GetPointData().GetScalars()
            expected = mapper.GetLookupTable().MapScalars(
                cloud().GetPointData().GetScalars(), 0, -1
            )
            for i in range(POINTS):
                for a, b in zip(colours.GetTuple(i), expected.GetTuple(i)):
                    self.assertLess(abs(a - b), 8)
            scene.plain.End()

    def test_mappers_come_back(self):
        for assembled in (False, True):
            scene = Scene(cloud(), blocks(), ball(), assembled=assembled)
            before = [actor.GetMapper() for actor in scene.actors]
            scene.plain.Begin()
            self.assertEqual(scene.plain.GetNumberOfActors(), 2)
            self.assertEqual(len(scene.warnings), 1)
            self.assertIs(scene.actors[2].GetMapper(), before[2])  # a mesh is written as it is
            self.assertIsNot(scene.actors[0].GetMapper(), before[0])
            scene.plain.End()
            self.assertEqual([actor.GetMapper() for actor in scene.actors], before)
            scene.plain.Begin()
            scene.plain = None
            self.assertEqual([actor.GetMapper() for actor in scene.actors], before)
        nothing = vtkPointSplatPlainScene()
        errors = []
        nothing.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        nothing.Begin()
        self.assertEqual(len(errors), 1)


if __name__ == "__main__":
    unittest.main()
