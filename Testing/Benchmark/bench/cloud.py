# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene's points, in the forms that the settings draw."""
import time

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
import pointsplatting


class Cloud:
    def __init__(self, scene, count):
        self.meshes = scene.meshes(count)
        self.points = sum(mesh.GetNumberOfPoints() for mesh in self.meshes)
        self.estimation_ms = None
        self._splats = self._dots = None

    def splats(self):
        """With the radii and curvatures that the mapper would estimate: once, and timed."""
        if self._splats is None:
            start = time.perf_counter()
            self._splats = []
            for mesh in self.meshes:
                data = vtkPolyData()
                data.SetPoints(mesh.GetPoints())
                data.GetPointData().SetNormals(mesh.GetPointData().GetNormals())
                estimation = pointsplatting.vtkPointSplatEstimation()
                estimation.SetInputData(data)
                estimation.Update()
                self._splats.append(estimation.GetOutput())
            self.estimation_ms = 1e3 * (time.perf_counter() - start)
        return self._splats

    def dots(self):
        """With a vertex cell for each point, which VTK's own point mappers want."""
        if self._dots is None:
            self._dots = []
            for splats in self.splats():
                data = vtkPolyData()
                data.SetPoints(splats.GetPoints())
                data.GetPointData().SetNormals(splats.GetPointData().GetNormals())
                glyphs = vtkVertexGlyphFilter()
                glyphs.SetInputData(data)
                glyphs.Update()
                self._dots.append(glyphs.GetOutput())
        return self._dots
