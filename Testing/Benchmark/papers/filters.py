# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A chequered plane by splats with each of the prefilters that Guennebaud, Barthe and Paulin 2006
compare, in NumPy and straight from the equations: the module draws with one of its own only.

All splats are disks on a plane, of one radius, with the same truncated Gaussian.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from papers.clouds import board_colour
from scenes import BACKGROUND

SIGMA, SUPPORT = 0.6, 1.5     # in radii, as vtkPointSplatMapper's defaults
PREFILTER = np.sqrt(2)        # pixels: section 4.1's typical choice of h
PAIRS = 1 << 20               # splats and pixels at a time


def kernel(squared):
    return np.where(squared <= SUPPORT ** 2, np.exp(squared / (-2 * SIGMA ** 2)), 0.0)


def focus_of(camera):
    """Pixels for a length of one at a depth of one, and the picture's size."""
    return camera.width / 2 / camera.half[0], np.array([camera.width, camera.height])


def places(view, focus, size):
    """In pixels, of points in view coordinates."""
    return view[:, :2] / -view[:, 2:] * focus + size / 2 - 0.5


def directions(pixels, focus, size):
    """Of rays through pixels [..., 2], in view coordinates, of length one along the axis."""
    side = (pixels + 0.5 - size / 2) / focus
    return np.concatenate([side, -np.ones_like(side[..., :1])], -1)


def overlaps(camera, cloud, depth, layer):
    """How many splats of a cloud are blended at each pixel: flat disks that rays meet within
    `layer`, along the normal, of the surface whose depth before the eye is given."""
    focus, size = focus_of(camera)
    data = cloud.GetPointData()
    p = camera.points_to_view(vtk_to_numpy(cloud.GetPoints().GetData()).astype(float))
    n = camera.to_view(vtk_to_numpy(data.GetNormals()).astype(float))
    reach = SUPPORT * vtk_to_numpy(data.GetArray("SplatRadius")).astype(float)
    front = np.einsum("ij,ij->i", p, n) < 0
    p, n, reach = p[front], n[front], reach[front]
    count, flat = np.zeros(size[0] * size[1]), depth.ravel()
    for which, pixels, to in pairs(places(p, focus, size), reach * focus / -p[:, 2], size):
        d = directions(pixels, focus, size)
        across = np.einsum("nj,nkj->nk", n[which], d)
        t = np.einsum("nj,nj->n", p[which], n[which])[:, None] / np.minimum(across, -1e-6)
        apart = ((t[..., None] * d - p[which][:, None]) ** 2).sum(-1)
        gap = np.abs((t - flat[to]) * across)
        met = (to >= 0) & (apart <= reach[which][:, None] ** 2) & (gap <= layer)
        count += np.bincount(to[met], minlength=len(count))
    return count.reshape(size[1], size[0])


def pairs(at, longest, size):
    """Splats with the pixels near them, many at a time: the splats' numbers [n], pixels [n, k, 2],
    and their places [n, k] in a picture of `size`, -1 outside. at: where splats are, in pixels;
    longest: how far they reach."""
    reach = np.minimum(np.ceil(longest), max(size)).astype(int)
    base = np.round(at).astype(int)
    near = ((base > -reach[:, None]) & (base < size + reach[:, None])).all(1)
    for r in np.unique(reach[near]):
        own = np.flatnonzero(near & (reach == r))
        y, x = np.mgrid[-r:r + 1, -r:r + 1]
        offsets = np.stack([x.ravel(), y.ravel()], -1)
        for which in np.array_split(own, max(1, len(own) * len(offsets) // PAIRS)):
            pixels = base[which][:, None] + offsets
            inside = ((pixels >= 0) & (pixels < size)).all(-1)
            yield (which, pixels.astype(float),
                   np.where(inside, pixels[..., 1] * size[0] + pixels[..., 0], -1))


class Splats:
    """Points in view coordinates, and how the radius' two tangents and Jacobian look there.
    camera: reference.Camera."""

    def __init__(self, camera, points, normal, radius, colours):
        view = camera.points_to_view(points)
        seen = view[:, 2] < -1e-3 * np.abs(view[:, 2]).max()
        self.p, self.colours = view[seen], colours[seen]
        self.focus, self.size = focus_of(camera)
        n = camera.to_view(normal)
        s = np.cross(self.p, n)  # equation 10
        t = np.cross(n, s)
        self.s = radius * s / np.linalg.norm(s, axis=1)[:, None]
        self.t = radius * t / np.linalg.norm(t, axis=1)[:, None]
        self.at = places(self.p, self.focus, self.size)

    def projected(self, t):
        """Pixels from the centre: a tangent's image by the derivative of the projection."""
        depth = -self.p[:, 2:]
        return self.focus * (t[:, :2] + self.p[:, :2] / depth * t[:, 2:]) / depth

    def widened(self, t):
        """Equations 8 and 9: at least PREFILTER pixels long, then parallel to the screen."""
        pz, tz = self.p[:, 2:], t[:, 2:]
        image = (t[:, :2] * pz - tz * self.p[:, :2]) / (pz ** 2 - tz ** 2)
        length = np.linalg.norm(image, axis=1)
        h = PREFILTER / self.focus
        flat = np.concatenate([image / length[:, None] * np.abs(pz) * h, 0 * pz], 1)
        return np.where((length < h)[:, None], flat, t)

    def exact(self, s, t):
        """The squared distance in radii at which rays meet splats, by equations 3 to 7."""
        p = self.p
        rows = [np.cross(p, t), np.cross(s, p), np.cross(s, t)]

        def squared(which, pixels):
            d = directions(pixels, self.focus, self.size)
            a, b, c = (np.einsum("nj,nkj->nk", row[which], d) for row in rows)
            c = np.where(np.abs(c) < 1e-30, 1e-30, c)
            return (a * a + b * b) / (c * c)
        return squared

    def screen(self, which, pixels):
        """The squared distance from the centre, in prefilters."""
        return ((pixels - self.at[which][:, None]) ** 2).sum(-1) / PREFILTER ** 2

    def filter_none(self):
        exact = self.exact(self.s, self.t)
        return lambda which, pixels: kernel(exact(which, pixels))

    def filter_maximum(self):
        """Botsch et al. 2005, as section 4 has it: the greater of kernel and prefilter."""
        exact = self.exact(self.s, self.t)
        return lambda which, pixels: kernel(np.minimum(exact(which, pixels),
                                                       self.screen(which, pixels)))

    def filter_ewa(self):
        """Zwicker et al. 2001: the affine image of the kernel, convolved with the prefilter."""
        a, b = self.projected(self.s), self.projected(self.t)
        xx, yy = (a[:, i] ** 2 + b[:, i] ** 2 + PREFILTER ** 2 for i in (0, 1))
        xy = a[:, 0] * a[:, 1] + b[:, 0] * b[:, 1]
        determinant = xx * yy - xy ** 2

        def weight(which, pixels):
            dx, dy = np.moveaxis(pixels - self.at[which][:, None], -1, 0)
            q = (yy[which, None] * dx ** 2 - 2 * xy[which, None] * dx * dy +
                 xx[which, None] * dy ** 2)
            return kernel(q / determinant[which, None])
        return weight

    def filter_tangents(self):
        """The paper's own: tangents that are too short in the image are lengthened."""
        exact = self.exact(self.widened(self.s), self.widened(self.t))
        return lambda which, pixels: kernel(exact(which, pixels))

    def draw(self, weight):
        """[height, width, 3], the background where there is no splat."""
        longest = SUPPORT * np.sqrt((self.projected(self.s) ** 2).sum(1) +
                                    (self.projected(self.t) ** 2).sum(1) + PREFILTER ** 2)
        width, height = self.size
        sums, weights = np.zeros(width * height), np.zeros(width * height)
        for which, pixels, to in pairs(self.at, longest, self.size):
            w = weight(which, pixels)
            colour = np.broadcast_to(self.colours[which][:, None], w.shape)
            inside = to >= 0
            weights += np.bincount(to[inside], w[inside], width * height)
            sums += np.bincount(to[inside], (w * colour)[inside], width * height)
        grey = np.where(weights > 0, sums / np.maximum(weights, 1e-300), 0.0)
        return np.where(weights[:, None] > 0, 255 * grey[:, None],
                        255 * np.array(BACKGROUND)).reshape(height, width, 3)

    def spacing_below(self, spacing):
        """For each pixel with points, how many pixels a length of `spacing` spans there along the
        tangent that is foreshortened; infinite at others."""
        across = np.linalg.norm(self.projected(self.t), axis=1) / np.linalg.norm(self.t, axis=1)
        width, height = self.size
        x, y = np.round(self.at).astype(int).T
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        least = np.full((height, width), np.inf)
        np.minimum.at(least, (y[inside], x[inside]), spacing * across[inside])
        return least


def board_truth(camera, field, extent, samples=9):
    """The plane's picture, samples x samples rays a pixel; and where all of them meet it."""
    pixels = np.arange(camera.width * camera.height)
    grey, met = np.zeros(len(pixels)), np.zeros(len(pixels), int)
    for i in range(samples):
        for j in range(samples):
            origins, d = camera.rays(pixels, (i + 0.5) / samples - 0.5, (j + 0.5) / samples - 0.5)
            t = -origins[:, 2] / np.where(np.abs(d[:, 2]) < 1e-12, 1e-12, d[:, 2])
            x, y = (origins + t[:, None] * d)[:, :2].T
            hit = (t > 0) & (np.abs(x) < extent) & (np.abs(y) < extent)
            grey += np.where(hit, board_colour(x, y, field), 0)
            met += hit
    share = (met / samples ** 2)[:, None]
    colour = 255 * ((grey / samples ** 2)[:, None] + (1 - share) * BACKGROUND)
    shape = (camera.height, camera.width)
    return colour.reshape(*shape, 3), (met == samples ** 2).reshape(shape)
