#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grouping and deferred blending beside two passes: tables 1 and 2 of Zhang and Pajarola 2006
(Single-Pass Point Rendering and Transparent Shading), and where each method wins.

  deferred_benchmark.py [FILE.ply ...] [--size PIXELS] [--runs N] [--sweep] [--grouping]

Table 1: groups K, largest and mean degree of the overlap graph, for disks of SplatRadius (Reach 1).
Table 2: frame times of two passes (by compute shaders where there are any, and by quads) and of
deferred blending at c = 0.8 and 0.4, interleaved, medians, and the ratio of frame rates. "one group" puts
all splats into a single one: no grouping could be faster.
--sweep: the same over points, pixels and overdraw, on tori.
--grouping: seconds and memory of vtkPointSplatGrouping from 10 k to 4 M points, and the copies that make
four groups cover a surface (the paper: 45 % on the dragon).
Without files, tori of 34 k and 134 k points take their place. The paper's own rows follow.
"""
import argparse
import os
import resource
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import pointsplatting

arguments = argparse.ArgumentParser(
    description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("files", nargs="*")
arguments.add_argument("--size", type=int, default=1024)
arguments.add_argument("--runs", type=int, default=7)
arguments.add_argument("--sweep", action="store_true")
arguments.add_argument("--grouping", action="store_true")
options = arguments.parse_args()

PAPER_1 = (("David head", "2,000 k", "18/37/17.2", "14/31/11.6", "11/24/9.4", "7/8/3.9"),
           ("Dragon", "1,100 k", "14/34/8.8", "12/29/6.3", "8/15/3.0", "5/7/0.8"),
           ("Female", "303 k", "19/49/18.9", "15/32/13.2", "10/18/6.9", "8/9/2.3"),
           ("BallJoint", "137 k", "17/31/18.6", "12/23/13.6", "9/14/7.1", "5/7/2.3"))
PAPER_2 = (("D-Head", 0.96, 1.2, 1.4), ("Dragon", 15.04, 19.70, 22.62),
           ("Female", 32.65, 32.11, 37.76), ("Balljoint", 65.68, 52.96, 70.37))


def polydata(points, normals):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=1))
    data.SetPoints(vtk_points)
    data.GetPointData().SetNormals(
        numpy_to_vtk(np.ascontiguousarray(normals, np.float32), deep=1))
    return data


def torus(count, nested=1):
    """Evenly spread points on tori, one inside the other: overdraw without more pixels."""
    points, normals = [], []
    for k in range(nested):
        n = count // nested
        minor = 0.4 * (1 - 0.8 * k / nested)
        i = np.arange(n)
        u = 2 * np.pi * i / n
        v = 2 * np.pi * np.modf(i * 0.5 * (np.sqrt(5) - 1))[0]
        normal = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
        centre = np.stack([np.cos(u), np.sin(u), 0 * u], 1)
        points.append(centre + minor * normal)
        normals.append(normal)
    return polydata(np.concatenate(points), np.concatenate(normals))


def read(name):
    reader = vtkPLYReader()
    reader.SetFileName(name)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    data = vtkPolyData()
    data.SetPoints(normals.GetOutput().GetPoints())
    data.GetPointData().SetNormals(normals.GetOutput().GetPointData().GetNormals())
    return data


def splats(data):
    estimation = pointsplatting.vtkPointSplatEstimation()
    estimation.SetInputData(data)
    estimation.Update()
    return estimation.GetOutput()


def window():
    if os.environ.get("DISPLAY"):
        win = vtkRenderWindow()
        win.OffScreenRenderingOn()
        return win
    return pointsplatting.vtkEGLHeadlessRenderWindow()


class Frame:
    def __init__(self, data, size, configure):
        self.mapper = pointsplatting.vtkPointSplatMapper()
        self.mapper.SetInputData(data)
        self.mapper.ScalarVisibilityOff()
        configure(self.mapper)
        self.renderer = vtkRenderer()
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        self.renderer.AddActor(actor)
        self.window = window()
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        self.times = []
        self.draw()
        self.times.clear()

    def draw(self):
        self.renderer.GetActiveCamera().Azimuth(3)
        self.renderer.ResetCameraClippingRange()
        pixels = vtkUnsignedCharArray()
        start = time.perf_counter()
        self.window.Render()
        self.window.GetPixelData(0, 0, 0, 0, 0, pixels, 0)
        self.times.append(1e3 * (time.perf_counter() - start))


def deferred(factor):
    def configure(mapper):
        mapper.SetMethodToDeferred()
        mapper.SetOverlapFactor(factor)
        mapper.SetMaximumImageMemory(0)
    return configure


def quads(mapper):
    mapper.SetMethodToTwoPass()
    mapper.SetProjectionToQuads()


def frame_times(data, size):
    one = vtkPolyData()
    one.ShallowCopy(data)
    group = numpy_to_vtk(np.zeros(data.GetNumberOfPoints(), np.int32), deep=1)
    group.SetName("SplatGroup")
    one.GetPointData().AddArray(group)
    frames = {"two": Frame(data, size, lambda m: m.SetMethodToTwoPass()),
              "quads": Frame(data, size, quads), "0.8": Frame(data, size, deferred(0.8)),
              "0.4": Frame(data, size, deferred(0.4)), "one": Frame(one, size, deferred(1.0))}
    for _ in range(options.runs):
        for frame in frames.values():
            frame.draw()
    times = {name: statistics.median(frame.times) for name, frame in frames.items()}
    groups = {name: frames[name].mapper.GetNumberOfGroups() for name in ("0.8", "0.4")}
    return times, groups, frames["two"].mapper.GetProjectionUsed()


scenes = [(os.path.basename(name), splats(read(name))) for name in options.files] or \
         [(f"torus {n // 1000} k", splats(torus(n))) for n in (34000, 134000)]

print("Table 1: K / largest degree / mean degree")
print(f"{'':28}{'points':>10}{'c = 1.0':>16}{'c = 0.8':>16}{'c = 0.6':>16}{'c = 0.4':>16}")
for name, data in scenes:
    row = f"{name:28}{data.GetNumberOfPoints():10}"
    for factor in (1.0, 0.8, 0.6, 0.4):
        grouping = pointsplatting.vtkPointSplatGrouping()
        grouping.SetInputData(data)
        grouping.SetReach(1.0)
        grouping.SetOverlapFactor(factor)
        grouping.Update()
        text = (f"{grouping.GetNumberOfGroups()}/{grouping.GetMaximumDegree()}/"
                f"{grouping.GetMeanDegree():.1f}")
        row += f"{text:>16}"
    print(row)
for name, count, *figures in PAPER_1:
    print(f"{'paper: ' + name:28}{count:>10}" + "".join(f"{text:>16}" for text in figures))

print(f"\nTable 2: ms a frame, {options.size} x {options.size}; in brackets the frame rate over that "
      "of two passes by the same rasteriser")
print(f"{'':28}{'two passes':>14}{'2 by quads':>14}{'c = 0.8':>18}{'c = 0.4':>18}{'one group':>18}")


def print_times(name, data, size):
    times, groups, projection = frame_times(data, size)
    row = f"{name:28}{times['two']:14.0f}{times['quads']:14.0f}"
    for key in ("0.8", "0.4", "one"):
        text = f"{times[key]:.0f} ({times['quads'] / times[key]:.2f})"
        row += f"{text:>18}"
    print(row + f"   K {groups['0.8']}, {groups['0.4']}; two passes by {projection}", flush=True)


for name, data in scenes:
    print_times(name, data, options.size)
for name, two, c8, c4 in PAPER_2:
    text = [f"{f} fps ({f / two:.2f})" for f in (c8, c4)]
    print(f"{'paper: ' + name:28}{'':14}{f'{two} fps':>14}{text[0]:>18}{text[1]:>18}")

if options.sweep:
    print("\nSweep over points, pixels and overdraw (nested tori)")
    for count in (10000, 100000, 400000):
        for size in (512, 1024):
            for nested in (1, 4):
                print_times(f"{count} pts, {size} px, {nested} tori", splats(torus(count, nested)),
                            size)

if options.grouping:
    print("\nGrouping: points, groups, seconds, most memory of the process so far")
    for count in (10000, 100000, 1000000, 4000000):
        data = torus(count)
        # Radii as estimation gives them on an even sampling: 0.75 spacings.
        area = 4 * np.pi ** 2 * 0.4
        radius = numpy_to_vtk(np.full(count, 0.75 * np.sqrt(area / count), np.float32), deep=1)
        radius.SetName("SplatRadius")
        data.GetPointData().AddArray(radius)
        grouping = pointsplatting.vtkPointSplatGrouping()
        grouping.SetInputData(data)
        start = time.perf_counter()
        grouping.Update()
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
        print(f"  {count:9} {grouping.GetNumberOfGroups():4} {time.perf_counter() - start:8.2f} s {memory:6} MB")
    print("Copies for four groups, as a share of the points, and the groups' cover of the surface")
    for name, data in scenes:
        grouping = pointsplatting.vtkPointSplatGrouping()
        grouping.SetInputData(data)
        grouping.SetReach(1.0)
        grouping.SetColoringToWeighted()
        grouping.SetWantedNumberOfGroups(4)
        grouping.SetCoverageToDuplicate()
        grouping.Update()
        cover = [f"{grouping.GetGroupCoverage(k):.2f}" for k in range(4)]
        print(f"  {name:28}{grouping.GetNumberOfDuplicates() / data.GetNumberOfPoints():6.0%}   {' '.join(cover)}")
