# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package as PyVista's users write it: found by entry points, drawn off screen."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import pyvista as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPropPicker,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import pointsplatting

SIZE = 300


def psnr(a, b):
    """Of two pictures of 8 bits, in dB."""
    error = np.mean((np.asarray(a, float) - np.asarray(b, float)) ** 2)
    return np.inf if error == 0 else 10 * np.log10(255 ** 2 / error)


def ball(resolution=120):
    cloud = pv.Sphere(theta_resolution=resolution, phi_resolution=resolution)
    cloud["height"] = cloud.points[:, 2]
    return cloud


def checks():
    """A texture of broad checks."""
    squares = np.kron(np.indices((6, 6)).sum(axis=0) % 2, np.ones((20, 20)))
    return pv.Texture(np.repeat(80 + 175 * squares[..., None], 3, axis=2).astype(np.uint8))


class TestPyVista(unittest.TestCase):
    def setUp(self):
        self.plotter = pv.Plotter(off_screen=True, window_size=(SIZE, SIZE), lighting="light kit")
        self.plotter.background_color = "black"

    def tearDown(self):
        self.plotter.close()

    def picture(self):
        self.plotter.show(auto_close=False)
        return self.plotter.screenshot(return_img=True)

    def mesh_picture(self, mesh, **keywords):
        """The same by add_mesh, which splats are to look like."""
        plotter = pv.Plotter(off_screen=True, window_size=(SIZE, SIZE), lighting="light kit")
        plotter.background_color = "black"
        actor = plotter.add_mesh(mesh, **keywords)
        actor.prop.interpolation = "Gouraud"
        plotter.show(auto_close=False)
        picture = plotter.screenshot(return_img=True)
        plotter.close()
        return picture

    def test_nothing_is_imported_before_it_is_asked_for(self):
        subprocess.run([sys.executable, "-c", """
import sys
import pyvista
assert "pointsplatting" not in sys.modules
pyvista.Plotter(off_screen=True).splats
assert "pointsplatting" in sys.modules
"""], check=True)

    def test_the_ten_lines(self):
        cloud = pv.PolyData(ball().points)
        cloud["height"] = cloud.points[:, 2]
        self.plotter.splats.add(cloud, scalars="height", cmap="viridis", opacity=0.6, shadows=True)
        surface = pv.Wavelet().splats.contour([100, 150], spacing=0.5)
        self.plotter.splats.add(surface, color="tan")
        cloud = cloud.splats.estimate()
        self.assertIn("SplatRadius", cloud.array_names)
        self.assertGreater(self.picture().std(), 10)

    def test_the_readme(self):
        """Its lines as they stand, with files of the names that it reads."""
        text = pathlib.Path(__file__).parents[2].joinpath("README.md").read_text()
        lines = re.search(r"## Ten lines of PyVista.*?```python\n(.*?)```", text, re.DOTALL)[1]
        volume = pv.Wavelet()
        volume["RTData"] -= 60
        there = {}
        with tempfile.TemporaryDirectory() as folder:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            ball().save("scan.ply")
            volume.save("head.vti")
            exec(lines, there)
        self.assertEqual(sorted(set(there["surface"]["Isovalue"])), [20, 60, 120])
        self.assertIn("Normals", there["cloud"].array_names)

    def test_like_the_module_itself(self):
        """By PyVista and by the classes alone: one picture."""
        cloud = ball()
        actor = self.plotter.splats.add(cloud, color="tan")
        by_pyvista = self.picture()
        mapper = pointsplatting.vtkPointSplatMapper()
        mapper.SetInputData(cloud)
        mapper.ScalarVisibilityOff()
        plain = vtkActor()
        plain.SetMapper(mapper)
        plain.SetProperty(actor.GetProperty())
        renderer = vtkRenderer()
        renderer.SetBackground(0, 0, 0)
        renderer.AddActor(plain)
        renderer.SetActiveCamera(self.plotter.camera)
        for light in self.plotter.renderer.lights:
            renderer.AddLight(light)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(SIZE, SIZE)
        window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
        window.Render()
        reader = vtkWindowToImageFilter()
        reader.SetInput(window)
        reader.ReadFrontBufferOff()
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        by_module = pixels.reshape(SIZE, SIZE, -1)[::-1, :, :3]
        print(f"PyVista's picture to the classes': {psnr(by_pyvista, by_module):.1f} dB")
        self.assertGreater(psnr(by_pyvista, by_module), 40)

    def test_looks_like_meshes(self):
        for keywords in ({"color": "orange"}, {"scalars": "height", "cmap": "plasma"},
                         {"scalars": "height", "clim": (-0.2, 0.2), "above_color": "red"},
                         # One layer: several are in any order where a mesh is not depth-peeled.
                         {"scalars": "height", "opacity": "linear", "culling": "back"},
                         {"color": "w", "opacity": 0.4, "culling": "back"},
                         {"color": "w", "lighting": False}, {"color": "w", "specular": 0.8},
                         {"color": "w", "culling": "front"}, {"texture": checks()}):
            with self.subTest(**keywords):
                self.tearDown()
                self.setUp()
                # One that has texture coordinates; they are of no account without a texture.
                cloud = ball()
                if "texture" in keywords:
                    cloud.texture_map_to_plane(inplace=True)
                self.plotter.splats.add(cloud, show_scalar_bar=False, **keywords)
                drawn = self.picture()
                mesh = self.mesh_picture(cloud, show_scalar_bar=False, **keywords)
                inside = mesh.max(axis=2) > 0
                self.assertGreater(inside.mean(), 0.2)
                self.assertGreater(psnr(drawn, mesh), 24)

    def test_translucent_beside_a_translucent_mesh(self):
        """Layers and the mesh are peeled together: what a mesh in the splats' place shows."""
        pictures = []
        for add in ("splats", "mesh"):
            self.tearDown()
            self.setUp()
            self.plotter.enable_depth_peeling()
            self.plotter.disable_anti_aliasing()
            (self.plotter.splats.add if add == "splats" else self.plotter.add_mesh)(
                ball(), color="red", opacity=0.8)
            self.plotter.add_mesh(pv.Plane(i_size=2, j_size=2), color="w", opacity=0.5)
            pictures.append(self.picture())
        self.assertGreater(pictures[1].std(), 10)
        self.assertGreater(psnr(*pictures), 24)

    def test_rgb_and_arrays(self):
        cloud = ball()
        colours = np.zeros((cloud.n_points, 3), np.uint8)
        colours[:, 0] = 255
        self.plotter.splats.add(cloud.points, scalars=colours, rgb=True)
        self.assertEqual(len(self.plotter.scalar_bars), 0)
        picture = self.picture()
        self.assertGreater(picture[..., 0].max(), 100)
        self.assertEqual(picture[..., 1].max(), 0)
        self.plotter.clear_actors()
        self.plotter.splats.add(cloud, opacity=np.linspace(0, 1, cloud.n_points), color="w")
        self.assertGreater(self.picture().max(), 50)

    def test_scalar_bar_and_name(self):
        self.plotter.splats.add(ball(), scalars="height", name="ball",
                                scalar_bar_args={"title": "z"})
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["z"])
        actor = self.plotter.splats.add(ball(40), color="r", name="ball")
        self.assertEqual(list(self.plotter.scalar_bars.keys()), [])
        self.assertIs(self.plotter.actors["ball"], actor)
        self.plotter.splats.add(ball(), scalars="height", name="ball")
        before = self.picture()
        self.plotter.update_scalar_bar_range((-5, 5))
        self.assertLess(psnr(before, self.picture()), 40)

    def test_settings(self):
        actor = self.plotter.splats.add(
            ball(), shadows=True, method="image_space", target_error=0.1, absorption=(1, 2, 3))
        mapper = actor.mapper
        self.assertTrue(mapper.GetShadows())
        self.assertEqual(mapper.GetMethod(), mapper.IMAGE_SPACE)
        self.assertEqual(mapper.GetAbsorption(), (1, 2, 3))
        self.picture()
        self.assertIn("method", self.plotter.splats.choices(actor))
        self.assertEqual(self.plotter.splats.settings()["transparency"][0], "automatic")

    def test_errors_name_what_there_is(self):
        add = self.plotter.splats.add
        for error, says, arguments, keywords in (
                (TypeError, "shadows", (ball(),), {"shadow": True}),
                (TypeError, "do not have", (ball(),), {"silhouette": True}),
                (KeyError, "height", (ball(), "hight"), {}),
                (ValueError, "two_pass", (ball(),), {"method": "fast"}),
                (ValueError, "nearest", (ball(),), {"target_error": 7}),
                (ValueError, r"\(n, 3\)", (np.zeros((4, 2)),), {}),
                (TypeError, "contour", (pv.Wavelet(),), {}),
                (TypeError, "one by one", (pv.MultiBlock([ball()]),), {})):
            with self.subTest(says), self.assertRaisesRegex(error, says):
                add(*arguments, **keywords)
        with self.assertRaisesRegex(KeyError, "RTData"):
            pv.Wavelet().splats.contour([1], scalars="nothing")

    def test_estimated_clouds_are_not_coloured_by_their_sizes(self):
        self.plotter.splats.add(ball(40).splats.estimate()) # whose scalars are its height
        self.assertEqual(list(self.plotter.scalar_bars.keys()), ["height"])
        self.plotter.clear()
        self.plotter.splats.add(pv.PolyData(ball().points).splats.estimate())
        self.assertEqual(len(self.plotter.scalar_bars), 0)

    def test_picking(self):
        actor = self.plotter.splats.add(ball())
        self.picture()
        picker = vtkPropPicker()
        self.assertEqual(picker.Pick(SIZE / 2, SIZE / 2, 0, self.plotter.renderer), 1)
        self.assertIs(picker.GetActor(), actor)
        self.plotter.splats.add(ball(), name="n", pickable=False)
        self.assertFalse(self.plotter.actors["n"].GetPickable())

    def test_contour_estimate_project(self):
        surface = pv.Wavelet().splats.contour(150.0)
        self.assertTrue(np.all(surface["Isovalue"] == 150))
        scattered = pv.PolyData(pv.Wavelet().points)
        scattered["v"] = pv.Wavelet()["RTData"]
        self.assertGreater(scattered.splats.contour([150], scalars="v").n_points, 100)
        noisy = pv.PolyData(ball().points
                            + np.random.default_rng(1).normal(0, 0.003, (ball().n_points, 3)))
        radii = np.linalg.norm(noisy.splats.project().points, axis=1)
        self.assertLess(radii.std(), np.linalg.norm(noisy.points, axis=1).std() / 2)
        facing = pv.PolyData(ball().points).splats.estimate(viewpoint=(0, 0, 0))
        self.assertLess(np.median(np.sum(facing["Normals"] * facing.points, axis=1)), 0)


if __name__ == "__main__":
    unittest.main()
