# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats where a browser draws by itself: their points, as VTK draws points.

trame's local views look up by a mapper's class how it is sent to the browser. `register` has
vtkPointSplatMapper sent as a mapper of one vertex a point, with the same colours, since the
browser knows no splats.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper


def vertices_of(cloud):
    """The points of a cloud, each as a vertex.

    Parameters
    ----------
    cloud : vtkPolyData
        With cells or without.

    Returns
    -------
    vtkPolyData
        The same points and arrays.
    """
    count = cloud.GetNumberOfPoints()
    cells = vtkCellArray()
    # One cell of all points: a browser is sent half of what as many cells take.
    cells.SetData(numpy_to_vtkIdTypeArray(np.array([0, count] if count else [0]), deep=True),
                  numpy_to_vtkIdTypeArray(np.arange(count), deep=True))
    made = vtkPolyData()
    made.SetPoints(cloud.GetPoints())
    made.SetVerts(cells)
    made.GetPointData().ShallowCopy(cloud.GetPointData())
    return made


def register():
    """Teach trame's local views vtkPointSplatMapper; where trame is not there, nothing is done."""
    try:
        from trame_vtk.modules.vtk.serializers.mappers import generic_mapper_serializer
        from trame_vtk.modules.vtk.serializers.registry import register_instance_serializer
    except ImportError:
        return

    def serialize(parent, mapper, mapper_id, context, depth):
        plain = vtkPolyDataMapper()
        plain.ShallowCopy(mapper)
        mapper.GetInputAlgorithm().Update()
        plain.SetInputData(vertices_of(mapper.GetInput()))
        return generic_mapper_serializer(parent, plain, mapper_id, context, depth)

    register_instance_serializer("vtkPointSplatMapper", serialize)
