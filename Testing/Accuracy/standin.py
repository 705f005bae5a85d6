# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each of the stand-ins is (standins.py)."""
from vtkmodules.util.numpy_support import vtk_to_numpy

from scenes import polydata


class StandIn:
    """spacing: the distance from a point to the next ones that it was made with; fine: where the
    mesh's facets are coarse, what makes a mesh of the same surface whose facets are not."""

    def __init__(self, name, cloud, distance, spacing, mesh=None, fine=None):
        self.name, self.cloud, self.distance = name, cloud, distance
        self.spacing, self.mesh, self.fine = spacing, mesh, fine


def vertices(mesh):
    """The cloud of a mesh's vertices and normals."""
    return polydata(vtk_to_numpy(mesh.GetPoints().GetData()),
                    vtk_to_numpy(mesh.GetPointData().GetNormals()))
