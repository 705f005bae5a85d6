# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is selected otherwise than by what is seen in a rectangle: through a frustum, by hovering, with
the values that are told of a point; and the labels of what is selected."""
import re

import numpy as np
from paraview import servermanager
from paraview.simple import (
    ClearSelection, Delete, ExtractSelection, SelectPointsThrough, SelectSurfacePoints,
)  # fmt: skip
from vtkmodules.vtkCommonCore import reference, vtkCollection

import splat_scenes as scenes
from splat_scenes import picture

COUNT = 20000
WIDTH, HEIGHT = 400, 300


def positions():
    """The cloud's points, by the formula of its script."""
    i = np.arange(COUNT) + 0.5
    z = 1 - 2 * i / COUNT
    angle = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(angle), r * np.sin(angle), z], 1)


def pixels(view, points):
    """Where points are seen, in pixels from the lower left corner."""
    matrix = view.GetActiveCamera().GetCompositeProjectionTransformMatrix(WIDTH / HEIGHT, -1, 1)
    rows = np.array([[matrix.GetElement(r, c) for c in range(4)] for r in range(4)])
    seen = np.c_[points, np.ones(len(points))] @ rows.T
    return (seen[:, :2] / seen[:, 3:] + 1) / 2 * [WIDTH, HEIGHT]


def selected(source):
    extracted = ExtractSelection(Input=source)
    extracted.UpdatePipeline()
    ids = servermanager.Fetch(extracted).GetPointData().GetArray("Id")
    ids = set(np.asarray(ids).tolist()) if ids else set()
    Delete(extracted)
    return ids


view = scenes.new_view()
cloud = scenes.cloud(count=COUNT)
splats = scenes.show(cloud, view)
plain = picture(view)
where = pixels(view, positions())

# Through a frustum: all points that a rectangle has, seen or not.
x0, y0, x1, y1 = rectangle = [120, 60, 280, 240]
SelectSurfacePoints(Rectangle=rectangle, View=view)
seen = selected(cloud)
ClearSelection(cloud)
SelectPointsThrough(Rectangle=rectangle, View=view)
through = selected(cloud)


def inside(by):
    low, high = np.array([x0 - by, y0 - by]), np.array([x1 + by, y1 + by])
    return set(np.nonzero(((where >= low) & (where <= high)).all(1))[0].tolist())


print(len(seen), "points seen in the rectangle,", len(through), "through it")
assert inside(-1) <= through <= inside(1), "other points than those of the frustum"
assert len(through) > 1.5 * len(seen), "what lies behind is not selected"
assert seen <= inside(4), "points are seen farther off than splats reach"

# Labels: as those of the representation Points.
ClearSelection(cloud)
SelectSurfacePoints(Rectangle=[180, 140, 190, 150], View=view)
labelled = selected(cloud)
masks = {}
for representation in ("Point Splats", "Points"):
    splats.Representation = representation
    splats.SelectionPointFieldDataArrayName = "Id"
    splats.SelectionPointLabelVisibility = 0
    without = picture(view)
    splats.SelectionPointLabelVisibility = 1
    masks[representation] = np.abs(picture(view) - without).max(-1) > 8
splats.Representation = "Point Splats"
both, either = masks["Point Splats"] & masks["Points"], masks["Point Splats"] | masks["Points"]
print(len(labelled), "labels,", either.sum(), "pixels,", both.sum(), "the same")
assert labelled and both.sum() > 100 and both.sum() > 0.9 * either.sum(), "labels differ"
splats.SelectionPointLabelVisibility = 0
ClearSelection(cloud)
assert scenes.psnr(plain, picture(view)) > 60, "the selection stays"

# Hovering: the point below the mouse is marked, and its values are told.
mark = servermanager.vtkSMInteractiveSelectionPipeline.GetInstance()
tip = servermanager.vtkSMTooltipSelectionPipeline.GetInstance()
for x, y in ((200, 150), (150, 120), (240, 200)):
    shown, sources = vtkCollection(), vtkCollection()
    found = view.SMProxy.SelectSurfacePoints([x, y, x, y], shown, sources, 0, 0, False)
    assert found and shown.GetNumberOfItems() == 1, f"nothing is found at {x}, {y}"
    of, what = shown.GetItemAsObject(0), sources.GetItemAsObject(0)
    tip.Show(of, what, view.SMProxy)
    text = reference("")
    assert tip.GetTooltipInfo(0, text), "nothing is told"
    told = str(text)
    point = int(re.findall(r"Id: (\d+)", told)[0])
    coordinates = [float(c) for c in re.search(r"Coords: \(([^)]*)\)", told)[1].split(",")]
    height = float(re.search(r"Height: (\S+)", told)[1])
    off = np.linalg.norm(where[point] - [x + 0.5, y + 0.5])
    print(f"at {x}, {y}: point {point}, {off:.1f} pixels off")
    assert np.allclose(coordinates, positions()[point], atol=1e-4), "another point's coordinates"
    assert abs(height - positions()[point][2]) < 1e-4, "another point's values"
    near = np.linalg.norm(where[positions() @ view.CameraPosition > 0.5] - where[point], axis=1)
    assert off < 2 * np.sort(near)[1], "a point that is not the nearest one"
    tip.Hide(view.SMProxy)
    mark.Show(of, what, view.SMProxy)
    marked = np.abs(picture(view) - plain).max(-1) > 8
    mark.Hide(view.SMProxy)
    rows, columns = np.nonzero(marked)
    assert 0 < len(rows) < 200, f"{len(rows)} pixels mark the point"
    assert np.hypot(columns.mean() - x, rows.mean() - y) < 5, "the mark is elsewhere"
    assert scenes.psnr(plain, picture(view)) > 60, "the mark stays"
