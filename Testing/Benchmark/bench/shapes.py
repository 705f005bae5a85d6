# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random points on shapes that formulas tell, and their normals. The constants of the automatic choices
are fitted to them; unseen.py has others, by which the choices are judged."""
import numpy as np


def sphere(count, generator, bumps=0.0):
    """A ball, whose radius varies by the bumps."""
    d = generator.normal(size=(count, 3))
    d /= np.linalg.norm(d, axis=1)[:, None]
    phase = 7.0 * d
    r = 1.0 + bumps * np.sin(phase).prod(axis=1)
    gradient = 7.0 * bumps * np.stack([
        np.cos(phase[:, k]) * np.sin(phase[:, k - 1]) * np.sin(phase[:, k - 2]) for k in range(3)
    ], axis=1)
    tangential = gradient - (gradient * d).sum(axis=1)[:, None] * d
    normals = d - tangential / r[:, None]
    return r[:, None] * d, normals / np.linalg.norm(normals, axis=1)[:, None]


def bumpy(count, generator):
    return sphere(count, generator, bumps=0.15)


def torus(count, generator):
    """Of radii 1 and 0.4."""
    f, t, k = generator.uniform(0.0, 1.0, (3, 3 * count))
    f, t = 2.0 * np.pi * f, 2.0 * np.pi * t
    kept = 1.4 * k < 1.0 + 0.4 * np.cos(t)
    f, t = f[kept][:count], t[kept][:count]
    normals = np.stack([np.cos(f) * np.cos(t), np.sin(f) * np.cos(t), np.sin(t)], axis=1)
    return np.stack([np.cos(f), np.sin(f), 0.0 * f], axis=1) + 0.4 * normals, normals


def rough(count, generator):
    """The bumpy ball, with normals that are off by six degrees, as scans' are."""
    points, normals = bumpy(count, generator)
    normals = normals + generator.normal(scale=0.1, size=normals.shape)
    return points, normals / np.linalg.norm(normals, axis=1)[:, None]


def shells(count, generator, layers=4, distance=0.02):
    """Balls within each other."""
    points, normals = sphere(count, generator)
    layer = np.arange(count) % layers
    return points * (1.0 - distance * layer)[:, None], normals
