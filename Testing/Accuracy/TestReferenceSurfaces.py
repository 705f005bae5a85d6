# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference renderer's surfaces against facts that need no renderer."""
import unittest

import numpy as np

import scenes
from reference import Camera, Isosurfaces, Part, Spheres, Torus
from reference.mesh import library
from reference.roots import polynomial_roots
from reference.shadows import Shadows
from reference.surfaces import unit
from vtkmodules.vtkRenderingCore import vtkCamera, vtkProperty


def random_rays(count, reach, seed=5):
    """From a sphere around everything through points inside it."""
    random = np.random.default_rng(seed)
    origins = 3 * reach * unit(random.normal(size=(count, 3)))
    return origins, random.uniform(-0.7, 0.7, (count, 3)) * reach - origins


def crossings_by_sampling(function, origins, directions, low, high, samples=20001):
    """How often the function changes its sign along each ray."""
    t = np.linspace(low, high, samples)
    return [int((np.diff(np.sign(function(o + t[:, None] * d))) != 0).sum())
            for o, d in zip(origins, directions)]


class TestReferenceSurfaces(unittest.TestCase):
    def test_roots_of_polynomials(self):
        random = np.random.default_rng(1)
        wanted = np.sort(random.uniform(-2, 2, (500, 4)), 1)
        scale = random.uniform(-3, 3, 500)
        coefficients = np.array([s * np.polynomial.polynomial.polyfromroots(r)
                                 for s, r in zip(scale, wanted)])
        apart = np.diff(wanted, axis=1).min(1) > 1e-3
        found = polynomial_roots(coefficients, np.full(500, -2.5), np.full(500, 2.5))
        np.testing.assert_allclose(found[apart], wanted[apart], atol=1e-8)
        # Those outside of the interval are not there, and complex ones nowhere.
        found = polynomial_roots(coefficients, np.zeros(500), np.full(500, 2.5))
        self.assertEqual(np.isfinite(found[apart]).sum(), (wanted[apart] > 0).sum())
        self.assertFalse(np.isfinite(polynomial_roots(
            np.array([[1.0, 0, 2, 0, 1]]), np.array([-9.0]), np.array([9.0]))).any())

    def check(self, surface, function, normal_of, reach, tolerance):
        """All crossings lie on the surface, none is missed, and normals are right."""
        origins, directions = random_rays(400, reach)
        for part, crossings in enumerate(surface.crossings(origins, directions)):
            t = crossings.t
            found = np.isfinite(t)
            self.assertTrue((np.diff(np.where(found, t, 1e9), axis=1) >= 0).all())
            rows, k = np.nonzero(found)
            points = origins[rows] + t[rows, k, None] * directions[rows]
            self.assertLess(np.abs(function(part, points)).max(), tolerance)
            count = crossings_by_sampling(lambda p, part=part: function(part, p), origins, directions,
                                          0, 3)
            wrong = (found.sum(1) != count).sum()
            self.assertEqual(wrong, 0)
            for column in range(t.shape[1]):
                at = np.flatnonzero(found[:, column])
                place = origins[at] + t[at, column, None] * directions[at]
                np.testing.assert_allclose(crossings.normals(at, column, place),
                                           normal_of(part, place), atol=1e-6)

    def test_spheres(self):
        radii, centres = [1.0, 0.5], np.array([[0.0, 0, 0], [0.3, 0.1, -0.2]])
        self.check(Spheres(radii, centres),
                   lambda i, p: np.linalg.norm(p - centres[i], axis=1) - radii[i],
                   lambda i, p: unit(p - centres[i]), 1.0, 1e-12)

    def test_torus(self):
        def distance(_, p):
            return np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1, p[:, 2]) - 0.4

        def normal(_, p):
            step = 1e-5 * np.eye(3)
            return unit(np.stack([distance(0, p + s) - distance(0, p - s) for s in step], 1))

        self.check(Torus(1.0, 0.4), distance, normal, 1.4, 1e-10)

    def test_isosurfaces(self):
        values = scenes.ORBITAL_VALUES

        def normal(_, p):
            step = 1e-5 * np.eye(3)
            return -unit(np.stack([scenes.orbital(p + s) - scenes.orbital(p - s) for s in step], 1))

        surface = Isosurfaces(scenes.orbital, scenes.orbital_gradient, values, scenes.ORBITAL_RADIUS)
        self.check(surface, lambda i, p: np.where(
            np.linalg.norm(p, axis=1) < scenes.ORBITAL_RADIUS, scenes.orbital(p) - values[i], -1.0),
            normal, scenes.ORBITAL_RADIUS, 1e-8)

    def test_isosurfaces_find_pairs_between_samples(self):
        # A sphere that rays hit with 0.01 to 0.3 of a step of 2 / 16 inside it.
        surface = Isosurfaces(lambda p: -(p * p).sum(-1), lambda p: -2 * p, (-0.25,), 1.0, 16)
        inside = np.linspace(0.00125, 0.0375, 50)
        origins = np.stack([np.sqrt(0.25 - (inside / 2) ** 2), np.zeros(50), np.full(50, -2.0)], 1)
        crossings, = surface.crossings(origins, np.tile([0.0, 0, 1], (50, 1)))
        np.testing.assert_allclose(crossings.t[:, 1] - crossings.t[:, 0], inside, rtol=1e-6)

    def test_meshes_of_scenes_lie_on_them(self):
        for scene, function in (
                (scenes.spheres_scene(1), lambda p: np.linalg.norm(p, axis=1) - 1),
                (scenes.torus_scene(),
                 lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1, p[:, 2]) - 0.4),
                (scenes.orbital_scene((1, 1, 1), "orbital"), None)):
            for count in (3000, 12000):
                meshes = scene.meshes(count)
                total = sum(mesh.GetNumberOfPoints() for mesh in meshes)
                self.assertLess(abs(total / count - 1), 0.1, scene.name)
                for i, mesh in enumerate(meshes):
                    points = scenes.vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
                    off = (function(points) if function else
                           scenes.orbital(points) / scenes.ORBITAL_VALUES[i] - 1)
                    self.assertLess(np.abs(off).max(), 1e-5, scene.name)

    @unittest.skipUnless(library(), "Embree is not installed")
    def test_embree_against_closed_form(self):
        sphere = scenes.sphere_mesh(40000, 1.0)
        surface = scenes.mesh_surface(sphere)
        origins, directions = random_rays(2000, 1.0)
        truth, = Spheres([1.0]).crossings(origins, directions)
        found, = surface.crossings(origins, directions)
        length = np.linalg.norm(directions, axis=1)
        hit = np.isfinite(truth.t[:, 0])
        chord = np.zeros(len(hit))
        chord[hit] = (truth.t[hit, 1] - truth.t[hit, 0]) * length[hit]
        # Through grazing facets only by chance, and there is no third crossing at any edge.
        clear = chord > 0.3
        self.assertGreater(clear.sum(), 1000)
        np.testing.assert_array_equal(np.isfinite(found.t[clear]).sum(1), 2)
        self.assertLess(np.abs((found.t[clear, :2] - truth.t[clear]) * length[clear, None]).max(), 2e-3)
        rows = np.flatnonzero(clear)
        points = origins[rows] + truth.t[rows, 0, None] * directions[rows]
        cosine = (found.normals(rows, 0, points) * truth.normals(rows, 0, points)).sum(1)
        self.assertLess(np.degrees(np.arccos(np.minimum(cosine, 1))).max(), 0.1)

    def test_camera(self):
        camera = vtkCamera()
        camera.SetPosition(1, 2, 3)
        camera.SetFocalPoint(0, 0.5, 0)
        for parallel in (0, 1):
            camera.SetParallelProjection(parallel)
            rays = Camera(camera, 300, 200)
            pixels = np.array([0, 299, 50 * 300 + 17, 199 * 300])
            origins, directions = rays.rays(pixels, 0.2, -0.3)
            world = origins + 4.0 * directions
            matrix = camera.GetCompositeProjectionTransformMatrix(1.5, -1, 1)
            rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
            clip = np.concatenate([world, np.ones((4, 1))], 1) @ rows.T
            x = (clip[:, 0] / clip[:, 3] + 1) / 2 * 300
            y = (clip[:, 1] / clip[:, 3] + 1) / 2 * 200
            np.testing.assert_allclose(x, pixels % 300 + 0.7, atol=1e-6)
            np.testing.assert_allclose(y, pixels // 300 + 0.2, atol=1e-6)
            np.testing.assert_allclose(rays.points_to_view(world)[:, 2], -4.0, atol=1e-9)

    def test_shadow_of_a_sphere(self):
        """On a plane below a sphere, under a point light and under a disk of light."""
        class Light:
            positional = True
            world_position, world_focal_point = np.array([0.0, 0, 10]), np.zeros(3)

        prop = vtkProperty()
        parts = [Part(Spheres([1.0], [[0.0, 0, 2]]), [prop])]
        x = np.linspace(-4, 4, 401)
        points = np.stack([x, 0 * x, 0 * x], 1)
        up = np.tile([0.0, 0, 1], (401, 1))
        hard = Shadows(scale=1.0).factors(parts, Light, points, up, 1)
        # The cone of tangents from 8 above the centre: sine 1 / 8.
        edge = 10 * np.tan(np.arcsin(1 / 8))
        np.testing.assert_array_equal(hard, np.where(np.abs(x) < edge, 0.0, 1.0))
        prop.SetOpacity(0.5)
        parts = [Part(Spheres([1.0], [[0.0, 0, 2]]), [prop])]
        through = Shadows(scale=1.0).factors(parts, Light, points, up, 1)
        np.testing.assert_allclose(through[200], 0.25)
        prop.SetOpacity(1)
        parts = [Part(Spheres([1.0], [[0.0, 0, 2]]), [prop])]
        soft = Shadows(0.8, 256, 1.0).factors(parts, Light, points, up, 1)
        # Umbra and penumbra: tangents from the disk's opposite rims, by similar triangles.
        self.assertEqual(soft[200], 0.0)
        self.assertEqual(soft[np.abs(x) > 1.6].min(), 1.0)
        half = soft[np.argmin(np.abs(x - edge))]
        self.assertLess(abs(half - 0.5), 0.06)
        self.assertTrue((np.diff(soft[x > 0]) > -0.04).all())


if __name__ == "__main__":
    unittest.main()
