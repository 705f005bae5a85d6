# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters by their names, selection, detail while dragging, bad input, memory, states."""
import os
import resource
import tempfile

import numpy as np
from paraview import servermanager, smstate
from paraview.simple import (
    ClearSelection, Delete, ExtractSelection, GetActiveView, GetSources, Hide, LoadState,
    ParticleSurfacePoints, PointSplatEstimation, PointSplatGrouping, PointSplatProjection,
    ProgrammableSource, Render, ResetSession, SaveState, SelectSurfaceCells, SelectSurfacePoints,
)  # fmt: skip

import splat_scenes as scenes
from splat_scenes import at_least, covered, picture, psnr

view = scenes.new_view()
points = scenes.cloud(normals=False)

# The filters, by their names.
estimated = PointSplatEstimation(Input=points)
estimated.UpdatePipeline()
assert {"SplatRadius", "SplatCurvature"} <= set(estimated.PointData.keys())
grouped = PointSplatGrouping(Input=estimated)
grouped.UpdatePipeline()
assert "SplatGroup" in grouped.PointData.keys()
projected = PointSplatProjection(Input=points)
projected.UpdatePipeline()
assert projected.GetDataInformation().GetNumberOfPoints() > 19000
surface = ParticleSurfacePoints(Input=scenes.cloud(count=2000))
surface.UpdatePipeline()
assert surface.GetDataInformation().GetNumberOfPoints() > 1000

# A rectangle picks the points that are seen in it, once each.
splats = scenes.show(points, view)
reference = picture(view)
SelectSurfacePoints(Rectangle=[150, 100, 250, 200], View=view)
extracted = ExtractSelection(Input=points)
extracted.UpdatePipeline()
ids = np.asarray(servermanager.Fetch(extracted).GetPointData().GetArray("Id"))
where = np.array([servermanager.Fetch(extracted).GetPoint(i) for i in range(len(ids))])
print(len(ids), "points picked")
assert len(ids) > 300 and len(set(ids)) == len(ids)
assert (where @ np.array([3, -2, 2]) > 0).all(), "points behind the sphere are picked"
assert psnr(reference, picture(view)) < 40, "the selection is not shown"
Delete(extracted)
ClearSelection(points)
SelectSurfaceCells(Rectangle=[150, 100, 250, 200], View=view)
ClearSelection(points)
at_least(psnr(reference, picture(view)), 60, "without a selection again, dB")

# Dragging: either frames are fast anyway, or splats are fewer; at rest all are there.
Hide(points, view)
many = scenes.cloud(count=600000)
dense = scenes.show(many, view)
Render(view)
full = picture(view)
for frame in range(8):
    view.GetActiveCamera().Azimuth(1)
    view.SMProxy.InteractiveRender()
dragged = scenes.information(dense, "SplatStride")
choices = scenes.information(dense, "SplatChoices")
print("while dragging one of", dragged, "|", choices.splitlines()[-1])
assert dragged > 1 or "took" in choices
view.GetActiveCamera().Azimuth(-8)
at_least(psnr(full, picture(view)), 50, "at rest again, dB")
assert scenes.information(dense, "SplatStride") == 1
Delete(many)

# Bad input: an error or nothing, and the next frame is right.
for bad in (
    "pass",
    "fill(self.GetOutput(), np.full((5, 3), np.nan), 0)",
    "fill(self.GetOutput(), np.zeros((1, 3)), 0)",
    "fill(self.GetOutput(), sphere(1, 20) * [1, 1, 0], 0)",
):
    source = scenes.cloud(bad)
    scenes.show(source, view)
    Render(view)
    Delete(source)
blocks = scenes.cloud(scenes.THREE_SPHERES, "vtkMultiblockDataSet", count=2000)
scenes.show(blocks, view)
Render(view)
blocks.Script = "self.GetOutput().SetNumberOfBlocks(1)"
Render(view)
Delete(blocks)
splats = scenes.show(points, view)
at_least(psnr(reference, picture(view)), 60, "after bad input, dB")

# Memory is flat over frames with changes.
def memory():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20

small = scenes.cloud(count=3000)
changing = scenes.show(small, view)
Hide(points, view)
def change(frames):
    for frame in range(frames):
        changing.Opacity = 0.3 + 0.1 * (frame % 8)
        changing.Representation = ("Point Splats", "Points")[frame % 10 == 9]
        if frame % 20 == 0:
            small.Script = small.Script.replace("COUNT = 3000", "COUNT = 3001")
        elif frame % 20 == 10:
            small.Script = small.Script.replace("COUNT = 3001", "COUNT = 3000")
        Render(view)

change(100)
before = memory()
change(400)
print("memory grew by", memory() - before, "MiB")
assert memory() - before < 20, "memory grows"
Delete(small)

# States, of both kinds.
splats = scenes.show(points, view)
splats.SplatTargetError = 1 / 64
splats.Opacity = 0.6
reference = picture(view)
folder = tempfile.mkdtemp(prefix="splats-")
SaveState(os.path.join(folder, "state.pvsm"))
script = smstate.get_state()
assert "Point Splats" in script
ResetSession()
LoadState(os.path.join(folder, "state.pvsm"))
view = GetActiveView()
at_least(psnr(reference, picture(view)), 50, "of a state in XML, dB")
ResetSession()
exec(script)
view = GetActiveView()
at_least(psnr(reference, picture(view)), 50, "of a state in Python, dB")
