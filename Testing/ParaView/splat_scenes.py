# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For scripts that pvbatch runs: clouds, pictures, and how two pictures compare."""
import os
import tempfile

import numpy as np
from paraview.simple import (
    CreateRenderView, ProgrammableSource, Render, SaveScreenshot, Show,
    _DisableFirstRenderCameraReset,
)  # fmt: skip
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

_DisableFirstRenderCameraReset()

# Each process makes its own share of points, so that all together have the same for any number of
# processes: those whose heights lie in its part of [0, 1], as SHARES cuts it. No share, no points.
CLOUD = '''
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid, VTK_VERTEX
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.util.numpy_support import numpy_to_vtk

def sphere(radius, count):
    i = np.arange(count) + 0.5
    z = 1 - 2 * i / count
    angle = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z * z)
    return radius * np.stack([r * np.cos(angle), r * np.sin(angle), z], 1)

def fill(data, points, first_id):
    controller = vtkMultiProcessController.GetGlobalController()
    rank = controller.GetLocalProcessId() if controller else 0
    cuts = SHARES[controller.GetNumberOfProcesses() if controller else 1]
    # By x: a half of the sphere each, or what the cuts say.
    along = (points[:, 0] / np.abs(points).max() + 1) / 2
    if len(cuts) == 1 and len(points) > 1:
        # No points for the first, exactly one for the second, the others for the last.
        least = np.sort(along)[:2].mean()
        cuts = (0, 0, least, 1)
    own = (along >= cuts[rank]) & ((along < cuts[rank + 1]) | (cuts[rank + 1] == 1))
    ids = first_id + np.arange(len(points))[own]
    points = np.ascontiguousarray(points[own])
    where = vtkPoints()
    where.SetDataTypeToDouble()
    where.SetData(numpy_to_vtk(points, deep=1))
    data.SetPoints(where)
    def add(name, values):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    add("Id", ids.astype(np.int64))
    add("Height", points[:, 2])
    add("Size", np.full(len(points), 0.06))
    if NORMALS:
        add("Normals", points / np.maximum(np.linalg.norm(points, axis=1), 1e-9)[:, None])
        data.GetPointData().SetActiveNormals("Normals")
    if data.IsA("vtkUnstructuredGrid"):
        data.AllocateExact(len(points), 1)
        for p in range(len(points)):
            data.InsertNextCell(VTK_VERTEX, 1, [p])
'''
ONE_SPHERE = "fill(self.GetOutput(), sphere(1.0, COUNT), 0)"
THREE_SPHERES = '''
blocks = self.GetOutput()
blocks.SetNumberOfBlocks(3)
for block in range(3):
    data = vtkPolyData()
    fill(data, sphere((1.0, 0.7, 0.4)[block], COUNT), block * COUNT)
    if data.GetNumberOfPoints():
        blocks.SetBlock(block, data)
'''
EVEN = {1: (0, 1), 2: (0, 0.5, 1), 4: (0, 0.25, 0.5, 0.75, 1)}
# Most points with one process, none with the last but one, where there are four.
UNEVEN = {1: (0, 1), 2: (0, 0.9, 1), 4: (0, 0.8, 0.85, 0.85, 1)}
# Of three the first has none, the second one point, and the last the others.
SINGLE = {1: (0, 1), 3: (0,)}


def cloud(body=ONE_SPHERE, type="vtkPolyData", count=20000, shares=EVEN, normals=True):
    source = ProgrammableSource()
    source.OutputDataSetType = type
    source.Script = f"COUNT = {count}\nSHARES = {shares}\nNORMALS = {normals}\n{CLOUD}\n{body}"
    source.UpdatePipeline()
    return source


def new_view():
    view = CreateRenderView(ViewSize=[400, 300])
    view.OrientationAxesVisibility = 0
    place(view)
    return view


def place(view):
    """The camera of all pictures."""
    view.CameraParallelProjection = 0
    view.CameraPosition = [3, -2, 2]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]


def show(source, view, representation="Point Splats"):
    shown = Show(source, view)
    shown.Representation = representation
    shown.ColorArrayName = [None, ""]
    return shown


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3]


def picture(view, file=None):
    """The view's pixels, and its picture in a file if it has a name."""
    Render(view)
    name = file or os.path.join(tempfile.mkdtemp(prefix="splats-"), "picture.png")
    SaveScreenshot(name, view)
    return read(name).astype(float)


def psnr(a, b):
    error = np.mean((np.asarray(a, float) - np.asarray(b, float)) ** 2)
    return 10 * np.log10(255**2 / error) if error > 0 else np.inf


def covered(image):
    """The pixels that are not the background's."""
    return np.abs(image - image[0, 0]).max(-1) > 1


def at_least(value, least, what):
    print(f"{what}: {value:.1f}, at least {least}")
    assert value >= least, f"{what}: {value} is less than {least}"


def information(shown, name):
    shown.UpdatePropertyInformation()
    return shown.GetProperty(name).GetElement(0)
