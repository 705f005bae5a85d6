# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes by Embree 3 or 4 (Debian's libembree3-3, libembree4-4), as another surface of the
reference.

Only its C interface is used, through ctypes: nothing has to be built. Rays go in streams of any
length by Embree 3, and sixteen by sixteen by Embree 4, which has no streams; the next crossing is
looked for behind the last one. Embree computes in single precision.
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
# Sixteen rays as Embree 4 has them. What follows the instances in some builds is for instances alone.
RAY_HIT_16 = np.dtype([
    ("origin", "(3,16)f4"), ("near", "16f4"), ("direction", "(3,16)f4"), ("time", "16f4"),
    ("far", "16f4"), ("mask", "16u4"), ("id", "16u4"), ("flags", "16u4"),
    ("face_normal", "(3,16)f4"), ("u", "16f4"), ("v", "16f4"), ("triangle", "16u4"),
    ("geometry", "16u4"), ("instance", "16u4"), ("more", "16u4")])
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
    name = ctypes.util.find_library("embree4") or ctypes.util.find_library("embree3")
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
            ("rtcIntersect16", None, [pointer, pointer, pointer, pointer]),
            ("rtcReleaseGeometry", None, [pointer]),
            ("rtcReleaseScene", None, [pointer]),
            ("rtcReleaseDevice", None, [pointer])):
        if hasattr(embree, function):
            getattr(embree, function).restype = result
            getattr(embree, function).argtypes = arguments
    return embree


def aligned(n, dtype):
    """zeros(n, dtype), at an address that is a multiple of 64, as Embree's packets want it."""
    held = np.zeros(n * dtype.itemsize + 64, np.uint8)
    start = -held.ctypes.data % 64
    return held[start:start + n * dtype.itemsize].view(dtype)


class Mesh:
    """points [n, 3], triangles [m, 3] and normals at points [n, 3], which are interpolated."""

    def __init__(self, points, triangles, normals):
        self.embree = library()
        if not self.embree:
            raise RuntimeError(
                "Embree is not installed: Debian's package libembree3-3 or libembree4-4")
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

    def intersect(self, rays):
        """Fill in the hits of an array of RAY_HIT."""
        if hasattr(self.embree, "rtcIntersect1M"):
            context = Context(0, None, NOTHING, 0.0)
            self.embree.rtcIntersect1M(self.scene, ctypes.byref(context), rays.ctypes.data, len(rays),
                                       RAY_HIT.itemsize)
            return
        packets = aligned(-(-len(rays) // 16), RAY_HIT_16)
        valid = aligned(16 * len(packets), np.dtype("i4"))
        valid[:len(rays)] = -1
        lanes = np.zeros(len(valid), RAY_HIT)
        lanes[:len(rays)] = rays
        for name in RAY_HIT.names:
            values = lanes[name].reshape(len(packets), 16, -1)
            packets[name] = np.moveaxis(values, 1, 2).reshape(packets[name].shape)
        for i in range(len(packets)):
            self.embree.rtcIntersect16(
                valid.ctypes.data + 64 * i, self.scene,
                packets.ctypes.data + RAY_HIT_16.itemsize * i, None)
        for name in ("far", "u", "v", "triangle", "geometry"):
            rays[name] = packets[name].reshape(-1)[:len(rays)]

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
            self.intersect(rays)
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
