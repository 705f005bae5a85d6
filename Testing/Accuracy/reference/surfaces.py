# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces whose truth is known: where rays cross them, and their normals there.

A surface has parts (nested spheres, isovalues), each with a colour and opacity of its own.
crossings(origins, directions), both [n, 3], gives for each part a Crossings: t [n, k], ascending and
infinite where there are fewer than k, with origin + t * direction on the surface; a grazed surface
may be left out. Directions need not be of unit length.
"""
import numpy as np

from .roots import bracketed, polynomial_roots


class Crossings:
    """Where rays cross one part; normals(rows, k, points) are outward and of unit length."""

    def __init__(self, t, normals):
        self.t = t
        self.normals = normals


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def through_ball(origins, directions, centre, radius):
    """Each ray's t nearest to the centre, and how far to either side of it the ball reaches; 0
    where it is missed."""
    from_centre = origins - centre
    squared = np.einsum("ij,ij->i", directions, directions)
    nearest = -np.einsum("ij,ij->i", from_centre, directions) / squared
    closest = from_centre + nearest[:, None] * directions
    gap = radius ** 2 - np.einsum("ij,ij->i", closest, closest)
    return nearest, np.sqrt(np.maximum(gap, 0.0) / squared)


class Spheres:
    """One sphere a part. In closed form."""

    def __init__(self, radii, centres=None):
        self.radii = radii
        self.centres = np.zeros((len(radii), 3)) if centres is None else np.asarray(centres, float)

    def crossings(self, origins, directions):
        found = []
        for centre, radius in zip(self.centres, self.radii):
            nearest, half = through_ball(origins, directions, centre, radius)
            t = np.stack([nearest - half, nearest + half], 1)
            t[half <= 0] = np.inf
            found.append(Crossings(t, lambda rows, k, points, centre=centre: unit(points - centre)))
        return found

    def bounds(self):
        radii = np.asarray(self.radii)[:, None]
        return (self.centres - radii).min(0), (self.centres + radii).max(0)


class Torus:
    """Around the z axis, of a major and a minor radius. By all roots of its quartic."""

    def __init__(self, major, minor):
        self.major, self.minor = major, minor

    def crossings(self, origins, directions):
        nearest, half = through_ball(origins, directions, np.zeros(3), self.major + self.minor)
        t = np.full((len(origins), 4), np.inf)
        at = np.flatnonzero(half > 0)
        if len(at):
            # (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), on p = closest + s * direction.
            direction = directions[at]
            closest = origins[at] + nearest[at, None] * direction
            a = np.einsum("ij,ij->i", direction, direction)
            c = np.einsum("ij,ij->i", closest, closest) + self.major ** 2 - self.minor ** 2
            b = 2 * np.einsum("ij,ij->i", closest, direction)
            flat, flat_closest = direction[:, :2], closest[:, :2]
            four = 4 * self.major ** 2
            coefficients = np.stack([
                c * c - four * np.einsum("ij,ij->i", flat_closest, flat_closest),
                2 * b * c - 2 * four * np.einsum("ij,ij->i", flat, flat_closest),
                b * b + 2 * a * c - four * np.einsum("ij,ij->i", flat, flat),
                2 * a * b, a * a], 1)
            t[at] = polynomial_roots(coefficients, -half[at], half[at]) + nearest[at, None]
        return [Crossings(t, self.normals)]

    def normals(self, rows, k, points):
        ring = points * (1.0, 1.0, 0.0)
        return unit(points - self.major * unit(ring))

    def bounds(self):
        outer = self.major + self.minor
        return np.array([-outer, -outer, -self.minor]), np.array([outer, outer, self.minor])


class Isosurfaces:
    """function(points) = value, one part a value, inside a ball around the origin.

    The function is sampled at even steps along the ray. A change of sign brackets a root. A pair of
    roots between two samples shows as an extremum towards zero: a parabola's vertex is put in as one
    more sample, and again. So what can be missed are pairs much nearer to each other than
    a step, 2 radius / steps. gradient(points) points towards greater values; normals are its opposite.
    """

    def __init__(self, function, gradient, values, radius, steps=96):
        self.function, self.gradient = function, gradient
        self.values, self.radius, self.steps = values, radius, steps

    def crossings(self, origins, directions):
        n = len(origins)
        nearest, half = through_ball(origins, directions, np.zeros(3), self.radius)
        at = np.flatnonzero(half > 0)
        origin, direction = origins[at], directions[at]
        share = np.linspace(-1, 1, self.steps + 1)
        t = nearest[at, None] + half[at, None] * share
        samples = self.function(origin[:, None] + t[..., None] * direction[:, None])
        found = []
        for value in self.values:
            rows, low, high, sign = self.brackets(origin, direction, t, samples - value, value)
            roots = bracketed(lambda s, r: self.along(origin[rows[r]], direction[rows[r]], s, value),
                              low, high, sign, 1e-11)
            found.append(Crossings(self.table(n, at[rows], roots), self.normals))
        return found

    def along(self, origins, directions, t, value):
        points = origins + t[:, None] * directions
        return (self.function(points) - value,
                np.einsum("ij,ij->i", self.gradient(points), directions))

    def brackets(self, origin, direction, t, g, value):
        """Rows, ends and the value at the lower end of each interval with a root in it."""
        negative = g < 0
        row, k = np.nonzero(negative[:, 1:] != negative[:, :-1])
        parts = [(row, t[row, k], t[row, k + 1], g[row, k])]
        size = np.abs(g)
        same = (negative[:, 1:-1] == negative[:, :-2]) & (negative[:, 1:-1] == negative[:, 2:])
        dip = same & (size[:, 1:-1] <= size[:, :-2]) & (size[:, 1:-1] <= size[:, 2:])
        row, k = np.nonzero(dip)
        a, b, c = t[row, k], t[row, k + 1], t[row, k + 2]
        ga, gb, gc = g[row, k], g[row, k + 1], g[row, k + 2]
        for _ in range(4):
            if not len(row):
                break
            with np.errstate(divide="ignore", invalid="ignore"):
                p, q = (b - a) * (gb - gc), (b - c) * (gb - ga)
                v = b - 0.5 * ((b - a) * p - (b - c) * q) / (p - q)
            v = np.where((v > a) & (v < c) & (v != b), v, 0.5 * (a + b))
            gv = self.function(origin[row] + v[:, None] * direction[row]) - value
            crossed = (gv < 0) != (gb < 0)
            hit = np.flatnonzero(crossed)
            parts += [(row[hit], a[hit], v[hit], ga[hit]), (row[hit], v[hit], c[hit], gv[hit])]
            # The three around the sample nearest to zero go on.
            keep = np.flatnonzero(~crossed)
            row, a, b, c, v = row[keep], a[keep], b[keep], c[keep], v[keep]
            ga, gb, gc, gv = ga[keep], gb[keep], gc[keep], gv[keep]
            left, better = v < b, np.abs(gv) < np.abs(gb)
            new = [np.where(better, np.where(left, x, y), np.where(left, z, x)) for x, y, z in
                   ((a, b, v), (ga, gb, gv))]
            last = [np.where(better, np.where(left, y, x), np.where(left, x, z)) for x, y, z in
                    ((c, b, v), (gc, gb, gv))]
            b, gb = np.where(better, v, b), np.where(better, gv, gb)
            (a, ga), (c, gc) = new, last
        return [np.concatenate(column) for column in zip(*parts)]

    @staticmethod
    def table(n, rows, roots):
        """Roots of rays [n, k], ascending; infinite where there are fewer."""
        order = np.lexsort((roots, rows))
        rows, roots = rows[order], roots[order]
        count = np.bincount(rows, minlength=n)
        first = np.cumsum(count) - count
        t = np.full((n, max(1, count.max(initial=0))), np.inf)
        t[rows, np.arange(len(rows)) - first[rows]] = roots
        return t

    def normals(self, rows, k, points):
        return -unit(self.gradient(points))

    def bounds(self):
        return np.full(3, -self.radius), np.full(3, self.radius)
