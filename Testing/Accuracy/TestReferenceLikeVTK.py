# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference's pictures against those of stock VTK's fine meshes.

Where VTK has as many rays a pixel, and no shadows or layers to approximate, the two differ by
little more than the rounding to 8 bits, which alone makes 59 dB.
"""
import unittest

import numpy as np

import measures
import reference
import scenes
from drawing import Drawing
from vtkmodules.vtkRenderingCore import vtkLight, vtkPolyDataMapper

SIZE = 128
POINTS = 60000


def mesh_drawing(scene, size=SIZE, points=POINTS):
    mappers = []
    for mesh in scene.meshes(points):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mappers.append(mapper)
    return Drawing(scene, mappers, size, 30 if scene.translucent else None)


def light(kind, position, colour=(1, 1, 1), intensity=1.0, positional=False):
    made = vtkLight()
    made.SetLightType(kind)
    made.SetPosition(position)
    made.SetFocalPoint(0, 0, 0)
    made.SetColor(colour)
    made.SetIntensity(intensity)
    made.SetPositional(positional)
    return made


class TestReferenceLikeVTK(unittest.TestCase):
    def likeness(self, drawing, shadows=None):
        """psnr within the outline, one ray a pixel."""
        truth = reference.render(drawing.scene.parts(), drawing.renderer, drawing.size, drawing.size,
                                 1, shadows)
        picture = drawing.draw()
        value = measures.psnr(picture, truth.colour, measures.inner(truth.covered, 1))
        print(f"{self.id().split('.')[-1]}, {drawing.scene.name}: {value:.1f} dB")
        return value

    def use(self, drawing, *lights):
        drawing.renderer.AutomaticLightCreationOff()
        drawing.renderer.RemoveAllLights()
        for one in lights:
            drawing.renderer.AddLight(one)

    def test_headlight(self):
        for scene in (scenes.spheres_scene(1), scenes.torus_scene()):
            self.assertGreater(self.likeness(mesh_drawing(scene)), 57, scene.name)
        # Facets show where its surfaces hide each other.
        fine = mesh_drawing(scenes.orbital_scene((1, 1, 1), "orbital"), points=8 * POINTS)
        self.assertGreater(self.likeness(fine), 50)

    def test_parallel_projection(self):
        drawing = mesh_drawing(scenes.torus_scene())
        drawing.renderer.GetActiveCamera().ParallelProjectionOn()
        self.assertGreater(self.likeness(drawing), 57)

    def test_lights(self):
        drawing = mesh_drawing(scenes.torus_scene())
        self.use(drawing, light(1, (0.2, 0, 1), (1, 0.8, 0.5), 0.6),  # headlight, among others
                 light(2, (1, 0.5, 0.3), (0.3, 0.5, 1)), light(3, (-3, -3, 2), intensity=0.7))
        self.assertGreater(self.likeness(drawing), 57)
        spot = light(3, (2, -2, 3), (1, 0.9, 0.8), 1.5, True)
        spot.SetConeAngle(20)
        spot.SetExponent(3)
        spot.SetAttenuationValues(0.5, 0.1, 0.02)
        self.use(drawing, spot, light(2, (0, 0.3, 0.1), (0.2, 0.4, 0.9), 0.5, True))
        self.assertGreater(self.likeness(drawing), 55)

    def test_supersampled(self):
        """Three by three pixels of VTK's averaged are the reference's colour."""
        drawing = mesh_drawing(scenes.torus_scene(), 3 * SIZE)
        truth = reference.render(drawing.scene.parts(), drawing.renderer, SIZE, SIZE, 3)
        mean = drawing.draw().reshape(SIZE, 3, SIZE, 3, 3).mean((1, 3))
        every = np.ones((SIZE, SIZE), bool)
        value = measures.psnr(mean, truth.colour, every)
        print(f"supersampled: {value:.1f} dB")
        self.assertGreater(value, 57)
        self.assertGreater(measures.ssim(mean, truth.colour, every), 0.999)
        # And they say more than one ray a pixel does.
        alone = reference.render(drawing.scene.parts(), drawing.renderer, SIZE, SIZE, 1)
        self.assertLess(measures.psnr(alone.colour, truth.colour, every), value - 10)

    def test_layers(self):
        for scene in (scenes.spheres_scene(4, 0.3),
                      scenes.orbital_scene((0.3, 0.5, 1), "orbital, translucent")):
            drawing = mesh_drawing(scene)
            # VTK rounds to 8 bits after each layer.
            self.assertGreater(self.likeness(drawing), 44, scene.name)
            truth = reference.render(scene.parts(), drawing.renderer, SIZE, SIZE, 1)
            self.assertEqual(truth.layers.max(), drawing.layers().max())
            self.assertLess(measures.layer_error(drawing.layers(), truth.layers), 0.03)

    def test_depth_normals_and_outline(self):
        drawing = mesh_drawing(scenes.torus_scene())
        truth = reference.render(drawing.scene.parts(), drawing.renderer, SIZE, SIZE, 1)
        drawing.draw()
        depth = drawing.depth()
        covered = np.isfinite(depth)
        both = covered & truth.covered
        self.assertLess(measures.depth_error(depth, truth.depth, both, drawing.scene.diagonal), 5e-4)
        # 8 bits for a component are 0.2 degrees.
        self.assertLess(measures.normal_angle(drawing.normals(), truth.normal, both), 0.2)
        self.assertLess(measures.silhouette(covered, truth.covered), 0.03)
        self.assertEqual(measures.holes(covered, truth.covered), 0)
        self.assertEqual(measures.spill(covered, truth.covered), 0)
        # What was changed to read normals is as it was.
        self.assertGreater(self.likeness(drawing), 57)

    def test_shadows(self):
        """VTK's shadow maps have steps along the shadow's rim, so only the bulk can be compared."""
        drawing = mesh_drawing(scenes.shadow_scene())
        self.assertGreater(self.likeness(drawing), 57)
        drawing.add_shadow_map(2048)
        hard = reference.Shadows(scale=drawing.scene.diagonal)
        self.assertGreater(self.likeness(drawing, hard), 40)
        self.assertLess(self.likeness(drawing), 31)
        truth = reference.render(drawing.scene.parts(), drawing.renderer, SIZE, SIZE, 1, hard)
        lit = truth.shadow[truth.covered]
        self.assertTrue(np.isin(lit, (0.0, 1.0)).all())
        self.assertTrue(0.02 < (lit == 0).mean() < 0.5)


if __name__ == "__main__":
    unittest.main()
