# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Of TestManyRanks.py: pictures of one scene, opaque and translucent, and what a rectangle picks.

Arguments: a folder to write to; EVEN, UNEVEN or SINGLE shares of points for the processes; and, where
these are a pvserver's, its port, and the size from which on it draws, in MB.
"""
import json
import os
import sys
import time

import numpy as np
from paraview import servermanager
from paraview.simple import (
    ClearSelection, Connect, Delete, ExtractSelection, Render, SelectSurfacePoints,
)  # fmt: skip

import splat_scenes as scenes

folder, shares = sys.argv[1], getattr(scenes, sys.argv[2])
processes = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
if len(sys.argv) > 3:
    Connect("localhost", int(sys.argv[3]))
    processes = servermanager.ActiveConnection.GetNumberOfDataPartitions()
view = scenes.new_view()
view.RemoteRenderThreshold = float(sys.argv[4]) if len(sys.argv) > 4 else 0
sphere = scenes.cloud(shares=shares)
splats = scenes.show(sphere, view)
scenes.picture(view, os.path.join(folder, "opaque.png"))
choices = splats.GetProperty("SplatChoices").GetElement(0)
drawn_by_server = view.GetClientSideObject().GetUseDistributedRenderingForRender()
start = time.time()
for frame in range(5):
    Render(view)
seconds = (time.time() - start) / 5


def pick(rectangle):
    """The ids of the points in a rectangle, of all processes."""
    SelectSurfacePoints(Rectangle=rectangle, View=view)
    extracted = ExtractSelection(Input=sphere)
    extracted.UpdatePipeline()
    ids = []
    for rank in range(processes):
        picked = servermanager.Fetch(extracted, rank).GetPointData().GetArray("Id")
        ids += np.asarray(picked).tolist() if picked else []
    Delete(extracted)
    ClearSelection(sphere)  # what shows it would hide points from the next
    return ids


ids, whole = pick([120, 60, 280, 240]), pick([0, 0, 399, 299])
Delete(sphere)
bare = scenes.cloud(shares=shares, normals=False, count=5000)
scenes.show(bare, view)
scenes.picture(view, os.path.join(folder, "estimated.png"))
Delete(bare)
blocks = scenes.cloud(scenes.THREE_SPHERES, "vtkMultiblockDataSet", shares=shares)
nested = scenes.show(blocks, view)
nested.BlockOpacities = ["/Root/Block0", "0.3", "/Root/Block1", "0.5"]
scenes.picture(view, os.path.join(folder, "translucent.png"))
with open(os.path.join(folder, "facts.json"), "w") as file:
    facts = {
        "ids": ids, "whole": whole, "seconds": seconds, "choices": choices,
        # A programmable source of ParaView 6 leaves NumPy's bool under that name.
        "remote": int(drawn_by_server),
    }  # fmt: skip
    json.dump(facts, file)
