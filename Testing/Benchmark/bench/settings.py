# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of what is compared: the module's methods and quality settings, and VTK's own peers.

A setting of which the mapper has no such property is listed as not in this build.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkPointGaussianMapper, vtkPolyDataMapper
import pointsplatting

from drawing import Drawing

ALL_PEELS = 30
# A disk a point: VTK's own shader makes it fade out, which leaves holes.
DISK = """//VTK::Color::Impl
if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) { discard; }
"""


class Setting:
    """kind: opaque, translucent or shadows. draws: splats, hybrid, mesh, points or disks. calls: methods
    of the splat mapper with their arguments. layers, samples: how many are asked for, where
    that is what the setting is about; family: of settings that differ in nothing else."""

    def __init__(self, name, kind, draws, calls=(), width=1, peels=None, layers=None, samples=None,
                 family=None, shadow_map=False):
        self.name, self.kind, self.draws, self.calls = name, kind, draws, calls
        self.width, self.peels, self.layers, self.samples = width, peels, layers, samples
        self.family, self.shadow_map = family or name, shadow_map

    @property
    def peer(self):
        return self.draws not in ("splats", "hybrid")

    def missing(self):
        """Why it cannot be drawn, or None."""
        for method, *_ in self.calls:
            if not hasattr(pointsplatting.vtkPointSplatMapper, method):
                return f"not in this build: {method}"
        return None

    def drawing(self, scene, cloud, size):
        mappers = [getattr(self, self.draws)(cloud, i) for i in range(len(cloud.meshes))]
        drawing = Drawing(scene, mappers, size, self.peels)
        if self.draws == "points":
            for actor in drawing.actors:
                actor.GetProperty().SetPointSize(self.width)
        if self.shadow_map:
            drawing.add_shadow_map()
        return drawing

    def splats(self, cloud, i):
        mapper = pointsplatting.vtkPointSplatMapper()
        mapper.SetInputData(cloud.splats()[i])
        for method, *arguments in self.calls:
            getattr(mapper, method)(*arguments)
        return mapper

    def hybrid(self, cloud, i):
        mapper = self.splats(cloud, i)
        mapper.SetInputData(cloud.meshes[i])
        return mapper

    def mesh(self, cloud, i):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(cloud.meshes[i])
        return mapper

    def points(self, cloud, i):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(cloud.dots()[i])
        return mapper

    def disks(self, cloud, i):
        mapper = vtkPointGaussianMapper()
        mapper.SetInputData(cloud.dots()[i])
        mapper.EmissiveOff()
        radii = vtk_to_numpy(cloud.splats()[i].GetPointData().GetArray("SplatRadius"))
        mapper.SetScaleFactor(float(np.median(radii)))
        mapper.SetSplatShaderCode(DISK)
        return mapper


def splats(name, kind, *calls, **about):
    return Setting(name, kind, "splats", calls, **about)


TWO_PASS, DEFERRED, IMAGE = "SetMethodToTwoPass", "SetMethodToDeferred", "SetMethodToImageSpace"
COMPUTE, QUADS = "SetProjectionToCompute", "SetProjectionToQuads"
UNBOUNDED = ("SetMaximumImageMemory", 0)

OPAQUE = [
    splats("two passes, compute", "opaque", (TWO_PASS,), (COMPUTE,)),
    splats("two passes, quads", "opaque", (TWO_PASS,), (QUADS,)),
    *(splats(f"deferred, c = {c:g}", "opaque", (DEFERRED,), ("SetOverlapFactor", c), UNBOUNDED)
      for c in (1.0, 0.8, 0.4)),
    splats("image space, compute", "opaque", (IMAGE,), (COMPUTE,)),
    splats("image space, raster", "opaque", (IMAGE,), (QUADS,)),
    Setting("stock mesh", "opaque", "mesh"),
    *(Setting(f"stock points, {width} px", "opaque", "points", width=width) for width in (1, 3, 5)),
    Setting("stock point Gaussian disks", "opaque", "disks"),
]
TRANSLUCENT = [
    splats("peeling, all layers", "translucent", ("SetTransparencyToPeeling",), UNBOUNDED),
    splats("peeling, image space", "translucent", (IMAGE,), ("SetTransparencyToPeeling",), UNBOUNDED),
    splats("nearest exact (Alg. 3)", "translucent", ("SetTransparencyToNearestExact",), UNBOUNDED),
    splats("sorted (Alg. 2)", "translucent", ("SetTransparencyToSorted",), UNBOUNDED),
    Setting("stock mesh, dual peeling", "translucent", "mesh", peels=ALL_PEELS),
    Setting("stock mesh, not sorted", "translucent", "mesh"),
    Setting("stock points, 3 px, dual p.", "translucent", "points", width=3, peels=ALL_PEELS),
]


def plural(n, noun):
    return f"{n} {noun}{'' if n == 1 else 's'}"


def layered(counts):
    """Peeling with at most n layers; one of VTK's peels takes two, the nearest and the farthest."""
    return ([splats(f"peeling, {plural(n, 'layer')}", "translucent", ("SetTransparencyToPeeling",),
                    ("SetMaximumNumberOfLayers", n), UNBOUNDED, layers=n, family="peeling, n layers")
             for n in counts] +
            [Setting(f"stock mesh, {plural(n, 'peel')}", "translucent", "mesh", peels=n, layers=2 * n,
                     family="stock mesh, n/2 peels")
             for n in sorted({max(1, count // 2) for count in counts})])


def shadowed(counts, radius):
    """Of a light of some radius; one sample is a point light, with hard shadows."""
    return ([splats("splats, no shadows", "shadows", (TWO_PASS,))] +
            [splats(f"shadows, {plural(n, 'sample')}", "shadows", ("SetShadows", True),
                    ("SetNumberOfShadowSamples", n), ("SetShadowLightRadius", radius if n > 1 else 0.0),
                    samples=n, family="shadows, n samples") for n in counts] +
            [Setting("stock mesh, no shadows", "shadows", "mesh"),
             Setting("stock mesh, shadow map", "shadows", "mesh", shadow_map=True)])
