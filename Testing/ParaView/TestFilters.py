# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters by their proxies: they tell their progress, stop when they are asked to, and are right
when they run again."""
from paraview import servermanager
from paraview.simple import (
    Calculator, Delete, FastUniformGrid, IsosurfacePoints, ParticleSurfacePoints,
    PointSplatEstimation, PointSplatGrouping, PointSplatProjection,
)  # fmt: skip

import splat_scenes as scenes

grid = FastUniformGrid(WholeExtent=[-40, 40, -40, 40, -40, 40])
field = Calculator(Input=grid, ResultArrayName="r", Function="sqrt(coordsX^2+coordsY^2+coordsZ^2)")
bare = scenes.cloud(normals=False, count=60000)
sized = PointSplatEstimation(Input=bare)
particles = scenes.cloud(
    "fill(self.GetOutput(), np.random.default_rng(1).uniform(-1, 1, (COUNT, 3)), 0)", count=6000
)
filters = {
    "IsosurfacePoints": IsosurfacePoints(
        Input=field, ContourBy=["POINTS", "r"], Isosurfaces=[10.0, 20.0, 30.0]
    ),
    "PointSplatEstimation": PointSplatEstimation(Input=bare),
    "PointSplatProjection": PointSplatProjection(Input=sized),
    "PointSplatGrouping": PointSplatGrouping(Input=sized),
    "ParticleSurfacePoints": ParticleSurfacePoints(Input=particles),
}
for producer in (field, bare, sized, particles):
    producer.UpdatePipeline()
handler = servermanager.ActiveConnection.Session.GetProgressHandler()
handler.SetProgressInterval(0)
told = []
handler.AddObserver("ProgressEvent", lambda *_: told.append(handler.GetLastProgressText()))
for name, proxy in filters.items():
    algorithm = proxy.GetClientSideObject()
    progress = []
    stop_after = None

    def note(caller, event):
        progress.append(caller.GetProgress())
        if stop_after is not None and caller.GetProgress() > stop_after:
            caller.SetAbortExecute(1)

    observer = algorithm.AddObserver("ProgressEvent", note)
    told.clear()
    proxy.UpdatePipeline()
    points = servermanager.Fetch(proxy).GetNumberOfElements(0)
    inner = sorted({round(value, 3) for value in progress if 0 < value < 1})
    print(f"{name}: {points} points, {len(inner)} values of progress")
    assert points > 0 and len(inner) >= 2, f"{name} tells {progress}"
    assert any(algorithm.GetClassName() in text for text in told if text), f"{name}: {set(told)}"
    steps = len(progress)
    stop_after = inner[0] / 2
    progress.clear()
    algorithm.Modified()
    proxy.MarkModified(proxy.SMProxy)
    proxy.UpdatePipeline()
    assert progress and len(progress) < steps, f"{name} goes on: {progress} after {inner}"
    stop_after = None
    algorithm.SetAbortExecute(0)
    algorithm.Modified()
    proxy.MarkModified(proxy.SMProxy)
    proxy.UpdatePipeline()
    again = servermanager.Fetch(proxy).GetNumberOfElements(0)
    assert again == points, f"{name} has {again} points after {points}"
    algorithm.RemoveObserver(observer)
