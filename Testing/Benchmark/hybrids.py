#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What hybrids of splats and triangles gain and cost, from the farthest view of a mesh to the closest.

  hybrids.py [--triangles MILLIONS ...] [--size PIXELS] [--frames N] [--distances D ...]
             [--translucent] [--chart FILE.png]

For a torus with waves on it, of so many triangles, this prints of several distances how far apart its
points are in the image, of VTK's mesh, of splats alone and of the hybrid the processor time of a frame
(median, interleaved) and the psnr against the mesh supersampled 3 x 3, how many splats and triangles
the hybrid projected, and what its time and psnr are beside the others': its time over the better of
both, and its psnr less the worse of both. The edge from which on triangles are drawn, TrianglePixels of
Rendering/Frame/vtkPointSplatCollection.cxx, is such that the former is about 1.
"""
import argparse
import os
import statistics
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import pointsplatting

HERE = os.path.dirname(os.path.abspath(__file__))
LONGEST_WAIT = 300.0  # seconds
SAMPLES = 3
KINDS = ("mesh", "splats", "hybrid")
AREA = 4 * np.pi ** 2 * 0.4


def place(u, v):
    waves = 0.1 * np.sin(9 * u) * np.sin(6 * v) + 0.01 * np.sin(90 * u) * np.sin(60 * v)
    r = 0.4 * (1 + waves)
    across = 1 + r * np.cos(v)
    return np.stack([across * np.cos(u), across * np.sin(u), r * np.sin(v)], -1)


def torus(triangles):
    """A grid with normals, of about so many triangles."""
    around = max(int(np.sqrt(triangles / 5.0)), 3)
    along = max(triangles // (2 * around), 3)
    u = np.linspace(0, 2 * np.pi, along, endpoint=False)[:, None] + np.zeros((1, around))
    v = np.linspace(0, 2 * np.pi, around, endpoint=False)[None, :] + np.zeros((along, 1))
    step = 1e-5
    normals = np.cross(place(u + step, v) - place(u - step, v), place(u, v + step) - place(u, v - step))
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    i, j = np.arange(along)[:, None], np.arange(around)[None, :]
    a, b = i * around + j, (i + 1) % along * around + j
    c, d = (i + 1) % along * around + (j + 1) % around, i * around + (j + 1) % around
    corners = np.stack([a, b, c, a, c, d], -1).reshape(-1).astype(np.int64)
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(place(u, v).reshape(-1, 3).astype(np.float32), deep=True))
    data.SetPoints(points)
    data.GetPointData().SetNormals(
        numpy_to_vtk(normals.reshape(-1, 3).astype(np.float32), deep=True))
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, len(corners) + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    return data


class View:
    def __init__(self, kind, data, size, translucent):
        self.size = size
        self.mapper = vtkPolyDataMapper() if kind == "mesh" else pointsplatting.vtkPointSplatMapper()
        if kind == "hybrid":
            self.mapper.SetHybridToAutomatic()
        self.mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        actor.GetProperty().SetColor(0.35, 0.55, 0.95)
        actor.GetProperty().SetSpecular(0.3)
        actor.GetProperty().SetSpecularPower(20)
        actor.GetProperty().SetOpacity(0.5 if translucent else 1.0)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.2, 0.4)
        self.renderer.AddActor(actor)
        if translucent:
            self.renderer.SetUseDepthPeeling(True)
            self.renderer.SetMaximumNumberOfPeels(20)
            self.renderer.SetOcclusionRatio(0.0)
        self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetSize(size, size)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)

    def look(self, distance, turn):
        """From the distance of a place on the torus, to that the more, the nearer it is."""
        out = np.array([np.cos(0.9), 0.0, np.sin(0.9)])
        target = np.array([1.0, 0.0, 0.0]) + 0.4 * out
        towards = out + np.array([0.0, 0.5, 0.1])
        towards /= np.linalg.norm(towards)
        focus = target * max(1.0 - distance / 6.0, 0.0)
        c, s = np.cos(turn), np.sin(turn)
        rotation = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*(rotation @ (focus + distance * towards)))
        camera.SetFocalPoint(*(rotation @ focus))
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).astype(float).reshape(self.size, self.size, 3)

    def wait_for_levels(self):
        start = time.perf_counter()
        while time.perf_counter() - start < LONGEST_WAIT:
            self.look(5.0, 1e-6 * (time.perf_counter() - start))
            self.window.Render()
            choices = self.mapper.GetChoices()
            if "stand for others" in choices or "being made" not in choices:
                return
            time.sleep(0.1)


def psnr(a, b):
    return 10 * np.log10(255.0 ** 2 / max(np.mean((a - b) ** 2), 1e-9))


def measure(views, reference, distance, frames):
    """Milliseconds and psnr of each kind."""
    times = {kind: [] for kind in KINDS}
    for frame in range(frames + 1):
        for kind in KINDS:
            views[kind].look(distance, 0.01 * (frame + 1))
            start = time.process_time()
            views[kind].picture()
            times[kind].append(1e3 * (time.process_time() - start))
    for view in (reference, *views.values()):
        view.look(distance, 0.0)
    size = views["mesh"].size
    best = reference.picture().reshape(size, SAMPLES, size, SAMPLES, 3).mean(axis=(1, 3))
    return ({kind: statistics.median(times[kind][1:]) for kind in KINDS},
            {kind: psnr(best, views[kind].picture()) for kind in KINDS})


def draw_chart(path, title, rows):
    sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]
    from bench.charts import Chart
    chart = Chart(title, "pixels between points", "frame time, ms of processors")
    colours = {"mesh": (0, 0, 0), "splats": (30, 120, 220), "hybrid": (0, 165, 120)}
    for kind in KINDS:
        x, y = [row[0] for row in rows], [row[1][kind] for row in rows]
        chart.line(x, y, colours[kind])
        chart.points(x, y, colours[kind], kind, kind == "mesh", 8)
    chart.write(path[:-4] if path.endswith(".png") else path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--triangles", type=float, nargs="+", default=[10.0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--distances", type=float, nargs="+",
                        default=[40, 12, 5, 2, 1, 0.5, 0.25, 0.1, 0.05, 0.02])
    parser.add_argument("--translucent", action="store_true")
    parser.add_argument("--chart")
    options = parser.parse_args()
    for millions in options.triangles:
        data = torus(int(1e6 * millions))
        views = {kind: View(kind, data, options.size, options.translucent) for kind in KINDS}
        reference = View("mesh", data, SAMPLES * options.size, options.translucent)
        for kind in KINDS[1:]:
            views[kind].wait_for_levels()
        spacing = np.sqrt(AREA / data.GetNumberOfPoints())
        print(f"{data.GetNumberOfCells()} triangles, {options.size} x {options.size}, "
              f"{'translucent' if options.translucent else 'opaque'}")
        print("distance spacing, px | mesh: ms    dB | splats: ms    dB | hybrid: ms    dB  "
              "splats triangles | time  psnr")
        rows = []
        for distance in options.distances:
            ms, dB = measure(views, reference, distance, options.frames)
            pixels = spacing * options.size / (2 * np.tan(np.radians(15.0)) * distance)
            mapper = views["hybrid"].mapper
            rows.append((pixels, ms, dB))
            print(f"{distance:8g} {pixels:11.2f} | {ms['mesh']:8.0f} {dB['mesh']:5.1f} "
                  f"| {ms['splats']:10.0f} {dB['splats']:5.1f} "
                  f"| {ms['hybrid']:10.0f} {dB['hybrid']:5.1f} "
                  f"{mapper.GetNumberOfPointsProjected():7d} "
                  f"{mapper.GetNumberOfTrianglesProjected():9d} "
                  f"| {ms['hybrid'] / min(ms['mesh'], ms['splats']):4.2f} "
                  f"{dB['hybrid'] - min(dB['mesh'], dB['splats']):+5.1f}", flush=True)
        if options.chart:
            draw_chart(options.chart, f"a mesh of {millions:g} M triangles", rows)


if __name__ == "__main__":
    main()
