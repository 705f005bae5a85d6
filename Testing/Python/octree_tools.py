# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the tests of vtkPointSplatOctreeWriter and -Reader: a cloud, its file, and what VTK said."""
import os
import shutil
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkBitArray, vtkFileOutputWindow, vtkLogger, vtkOutputWindow, vtkPoints, vtkStringArray)
from vtkmodules.vtkCommonDataModel import vtkPolyData
import pointsplatting

FAR = 1e6  # of the torus, so that floats would not hold its coordinates
COUNT = 60000
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # errors are read from a file


def torus(count=COUNT, seed=1):
    draws = np.random.default_rng(seed)
    u, v = 2 * np.pi * draws.random((2, count))
    out = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], 1)
    ring = np.stack([np.cos(u), np.sin(u), 0 * u], 1)
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(ring + 0.4 * out + FAR, deep=1))
    data.SetPoints(points)
    for name, values in (("Normals", out.astype(np.float32)), ("a/b", np.arange(count, dtype="i2")),
                         ("pair", draws.random((count, 2), "f4")), ("height", out[:, 2])):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    data.GetPointData().SetActiveNormals("Normals")
    data.GetPointData().SetActiveScalars("height")
    data.GetPointData().GetArray("pair").SetComponentName(1, "second")
    texts, bits = vtkStringArray(), vtkBitArray()
    texts.SetName("texts")
    bits.SetName("bits")
    for i in range(count):
        texts.InsertNextValue(f"point {i} ö")
        bits.InsertNextValue(i % 3 == 0)
    data.GetPointData().AddArray(texts)
    data.GetPointData().AddArray(bits)
    field = numpy_to_vtk(np.array([[1.5, 2.5, 3.5]]), deep=1)
    field.SetName("SensorPosition")
    data.GetFieldData().AddArray(field)
    return data


def arrays(data):
    return [data.GetPointData().GetArrayName(i)
            for i in range(data.GetPointData().GetNumberOfArrays())]


def positions(data):
    return vtk_to_numpy(data.GetPoints().GetData())


class OctreeTest(unittest.TestCase):
    """Each test in a folder of its own; what VTK says goes to a file there."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.name = os.path.join(self.folder, "cloud.h5")
        self.log = os.path.join(self.folder, "log")
        output = vtkFileOutputWindow()
        output.SetFileName(self.log)
        output.FlushOn()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(output)
        self.addCleanup(vtkOutputWindow.SetInstance, before)

    def said(self):
        """What VTK has said since the last time."""
        if not os.path.exists(self.log):
            return ""
        with open(self.log, "r+", encoding="utf-8") as file:
            text = file.read()
            file.truncate(0)
        return text

    def write(self, data, name=None):
        writer = pointsplatting.vtkPointSplatOctreeWriter()
        writer.SetFileName(self.name if name is None else name)
        writer.SetInputData(data)
        return writer.Write(), writer

    def read(self, most=0, bounds=None, name=None):
        reader = pointsplatting.vtkPointSplatOctreeReader()
        reader.SetFileName(self.name if name is None else name)
        reader.SetMaximumNumberOfPoints(most)
        if bounds:
            reader.SetBounds(bounds)
        reader.Update()
        return reader.GetOutput(), reader


def main():
    if not hasattr(pointsplatting, "vtkPointSplatOctreeReader"):
        print("SKIPPED: this VTK has no HDF5")
    else:
        unittest.main()
