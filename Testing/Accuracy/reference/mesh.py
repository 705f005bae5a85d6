# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes by Embree 3 (Debian's libembree3-3), as another surface of the reference.

Only its C interface is used, through ctypes: nothing has to be built. Rays go in streams; the next
crossing is looked for behind the last one. Embree computes in single precision.
"""
import ctypes
import ctypes.util

import numpy as np

from .surfaces import Crossings, unit

RAY_HIT = np.dtype([
    ("origin", "3f4"), ("near", "f4"), ("direction", "3f4"), ("time", "f4"), ("far", "f4"),
    ("mask", "u4"), ("id", "u4"), ("flags", "u4"),
    ("face_normal", "3f4"), ("u", "f4"), ("v", "f4"), ("triangle", "u4"), ("geometry", "u4"),
    ("instance", "u4")])
NOTHING = 0xFFFFFFFF
TRIANGLE, INDEX_BUFFER, VERTEX_BUFFER = 0, 0, 1
UINT3, FLOAT3 = 0x5003, 0x9003
ROBUST = 1 << 2
MAXIMUM_CROSSINGS = 64


class Context(ctypes.Structure):
    # The last member is there only in builds with a feature for curves; room for it does no harm.
    _fields_ = [("flags", ctypes.c_uint), ("filter", ctypes.c_void_p),
                ("instance", ctypes.c_uint), ("minimum_width", ctypes.c_float)]


def library():
    """Embree, or None where it is not installed."""
    name = ctypes.util.find_library("embree3")
    if not name:
        return None
    embree = ctypes.CDLL(name)
    pointer, number = ctypes.c_void_p, ctypes.c_uint
    for function, result, arguments in (
            ("rtcNewDevice", pointer, [ctypes.c_char_p]),
            ("rtcNewScene", pointer, [pointer]),
            ("rtcSetSceneFlags", None, [pointer, number]),
            ("rtcNewGeometry", pointer, [pointer, number]),
            ("rtcSetNewGeometryBuffer", pointer,
             [pointer, number, number, number, ctypes.c_size_t, ctypes.c_size_t]),
            ("rtcCommitGeometry", None, [pointer]),
            ("rtcAttachGeometry", number, [pointer, pointer]),
            ("rtcCommitScene", None, [pointer]),
            ("rtcIntersect1M", None, [pointer, pointer, pointer, number, ctypes.c_size_t]),
            ("rtcReleaseGeometry", None, [pointer]),
            ("rtcReleaseScene", None, [pointer]),
            ("rtcReleaseDevice", None, [pointer])):
        getattr(embree, function).restype = result
        getattr(embree, function).argtypes = arguments
    return embree


class Mesh:
    """points [n, 3], triangles [m, 3] and normals at points [n, 3], which are interpolated."""

    def __init__(self, points, triangles, normals):
        self.embree = library()
        if not self.embree:
            raise RuntimeError("Embree is not installed: Debian's package libembree3-3")
        self.points = np.asarray(points, np.float32)
        self.triangles = np.asarray(triangles, np.uint32)
        self.point_normals = np.asarray(normals, float)
        self.skip = 1e-5 * float(np.linalg.norm(np.ptp(self.points, 0)))
        self.device = self.embree.rtcNewDevice(None)
        self.scene = self.embree.rtcNewScene(self.device)
        self.embree.rtcSetSceneFlags(self.scene, ROBUST)
        geometry = self.embree.rtcNewGeometry(self.device, TRIANGLE)
        for kind, layout, values in ((VERTEX_BUFFER, FLOAT3, self.points),
                                     (INDEX_BUFFER, UINT3, self.triangles)):
            values = np.ascontiguousarray(values)
            buffer = self.embree.rtcSetNewGeometryBuffer(geometry, kind, 0, layout, 12, len(values))
            ctypes.memmove(buffer, values.ctypes.data, values.nbytes)
        self.embree.rtcCommitGeometry(geometry)
        self.embree.rtcAttachGeometry(self.scene, geometry)
        self.embree.rtcReleaseGeometry(geometry)
        self.embree.rtcCommitScene(self.scene)

    def __del__(self):
        if getattr(self, "scene", None):
            self.embree.rtcReleaseScene(self.scene)
            self.embree.rtcReleaseDevice(self.device)

    def crossings(self, origins, directions):
        n = len(origins)
        length = np.linalg.norm(directions, axis=1)
        rays = np.zeros(n, RAY_HIT)
        rays["origin"], rays["direction"] = origins, directions / length[:, None]
        alive = np.arange(n)
        columns, hits = [], []
        while len(alive) and len(columns) < MAXIMUM_CROSSINGS:
            rays["far"], rays["mask"] = np.inf, NOTHING
            rays["geometry"] = rays["instance"] = NOTHING
            context = Context(0, None, NOTHING, 0.0)
            self.embree.rtcIntersect1M(self.scene, ctypes.byref(context), rays.ctypes.data, len(rays),
                                       RAY_HIT.itemsize)
            hit = rays["geometry"] != NOTHING
            alive, rays = alive[hit], rays[hit]
            t = np.full(n, np.inf)
            t[alive] = rays["far"] / length[alive]
            where = np.zeros((n, 3))
            where[alive] = np.stack([rays["triangle"], rays["u"], rays["v"]], 1)
            columns.append(t)
            hits.append(where)
            rays["near"] = rays["far"] + self.skip

        def normals(rows, k, points):
            triangle, u, v = hits[k][rows].T
            corners = self.point_normals[self.triangles[triangle.astype(int)]]
            weights = np.stack([1 - u - v, u, v], 1)
            return unit(np.einsum("ij,ijk->ik", weights, corners))

        return [Crossings(np.stack(columns, 1), normals)]

    def bounds(self):
        return self.points.min(0).astype(float), self.points.max(0).astype(float)
