# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of points that are not there, and cells that are not there themselves: said, and survived."""
import unittest

from pointsplatting import (
    vtkEGLHeadlessRenderWindow,
    vtkPointShadowTexture,
    vtkPointSplatEstimation,
    vtkPointSplatMapper,
)
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (
    VTK_TRIANGLE,
    vtkCellArray,
    vtkDataObject,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkHardwareSelector, vtkLight, vtkRenderer

CELLS = {  # offsets, ids, whether they can be read
    "far": ([0, 3, 6], [0, 1, 2, 5, 10**9, 7], True),
    "negative": ([0, 3, 6], [0, 1, 2, 5, -(10**9), 7], True),
    "hexagon": ([0, 6], [0, 1, 2, 5, 10**9, 7], True),
    "beyond": ([0, 3, 10**8], [0, 1, 2, 5, 6, 7], False),
    "before": ([0, -5, 6], [0, 1, 2, 5, 6, 7], False),
    "falling": ([6, 3, 0], [0, 1, 2, 5, 6, 7], False),
}


def ids_of(values):
    array = vtkIdTypeArray()
    for value in values:
        array.InsertNextValue(value)
    return array


def ball(offsets, ids, grid=False):
    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(20)
    source.Update()
    cells = vtkCellArray()
    cells.SetData(ids_of(offsets), ids_of(ids))
    data = vtkUnstructuredGrid() if grid else vtkPolyData()
    data.SetPoints(source.GetOutput().GetPoints())
    data.GetPointData().SetNormals(source.GetOutput().GetPointData().GetNormals())
    if grid:
        data.SetCells(VTK_TRIANGLE, cells)
    else:
        data.SetPolys(cells)
    return data


class TestBadCells(unittest.TestCase):
    def draw(self, data):
        """Frames and a selection of cells; how many errors the data set has."""
        errors = []
        data.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        mapper = vtkPointSplatMapper()
        mapper.SetInputDataObject(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        window = vtkEGLHeadlessRenderWindow()
        window.SetSize(100, 100)
        window.AddRenderer(renderer)
        for _ in range(3):
            window.Render()
        selector = vtkHardwareSelector()
        selector.SetRenderer(renderer)
        selector.SetArea(0, 0, 99, 99)
        selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
        selector.Select()
        return len(errors)

    def test_mapper(self):
        for name, (offsets, ids, readable) in CELLS.items():
            for grid in (False, True):
                data = ball(offsets, ids, grid)
                scalars = vtkFloatArray()
                scalars.InsertNextValue(0.0)
                scalars.InsertNextValue(1.0)
                data.GetCellData().SetScalars(scalars)
                errors = self.draw(data)
                # Once for the colours, once for the selection.
                self.assertEqual(errors, 0 if readable else 2, (name, grid))

    def test_estimation(self):
        for offsets, ids, _ in CELLS.values():
            data = ball(offsets, ids)
            data.GetPointData().SetNormals(None)
            estimation = vtkPointSplatEstimation()
            estimation.SetInputData(data)
            estimation.Update()
            self.assertEqual(estimation.GetOutput().GetNumberOfPoints(), data.GetNumberOfPoints())

    def test_shadows_of_meshes(self):
        for name, (offsets, ids, readable) in CELLS.items():
            errors = []
            occluder = ball(offsets, ids)
            occluder.AddObserver("ErrorEvent", lambda *_, errors=errors: errors.append(1))
            texture = vtkPointShadowTexture()
            texture.AddLight(vtkLight())
            texture.AddOccluderData(occluder)
            texture.SetInputData(ball([0, 3], [0, 1, 2]))
            texture.Update()
            factors = texture.GetOutput().GetPointData().GetArray("ShadowFactor")
            self.assertEqual(factors.GetNumberOfTuples(), occluder.GetNumberOfPoints(), name)
            self.assertEqual(len(errors), 0 if readable else 1, name)


if __name__ == "__main__":
    unittest.main()
