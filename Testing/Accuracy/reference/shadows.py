# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""How much of a light arrives at a point: hard shadows, and soft ones of a light with an area.

A light of radius r is a disk across the direction to the scene, as Dobrev, Rosenthal and Linsen 2010
(section 6) have it: its points are spread evenly (a sunflower), turned by a random angle at each
shaded point, and the shares of all are averaged. Translucent parts let through what they do not hide.
"""
import numpy as np

from .surfaces import unit

GOLDEN = np.pi * (3 - np.sqrt(5))


class Shadows:
    """radius of the lights, in world units for positional ones, for directional ones the tangent of
    the angle at which it is seen; samples a light (1: its centre); scale: the scene's size."""

    def __init__(self, radius=0.0, samples=1, scale=1.0):
        self.radius, self.samples, self.scale = radius, samples, scale

    def factors(self, parts, light, points, normals, seed):
        """The share of the light, 0 to 1, that arrives at points in world coordinates."""
        towards = unit(light.world_focal_point - light.world_position)
        # A directional light stands behind everything.
        distance = None if light.positional else 4 * self.scale
        across = unit(np.cross(towards, np.eye(3)[np.argmin(np.abs(towards))]))
        up = np.cross(towards, across)
        turn = np.random.default_rng(seed).uniform(0, 2 * np.pi, len(points))
        arrived = np.zeros(len(points))
        for i in range(self.samples):
            place = light.world_position if distance is None else points - distance * towards
            if self.samples > 1:
                r = self.radius * (distance or 1.0) * np.sqrt((i + 0.5) / self.samples)
                angle = turn + i * GOLDEN
                place = place + r * (np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * up)
            arrived += self.transmitted(parts, points, place - points, normals)
        return arrived / self.samples

    def transmitted(self, parts, points, directions, normals):
        length = np.linalg.norm(directions, axis=1)
        # Off the surface towards the light, by far less than any picture shows.
        side = np.sign(np.einsum("ij,ij->i", normals, directions))
        start = points + (1e-6 * self.scale * side)[:, None] * normals
        share = np.ones(len(points))
        least = 1e-6 * self.scale / length
        for part in parts:
            for crossings, material in zip(part.surface.crossings(start, directions), part.materials):
                hit = (crossings.t > least[:, None]) & (crossings.t < 1)
                share *= (1 - material.opacity) ** hit.sum(1)
        return share
