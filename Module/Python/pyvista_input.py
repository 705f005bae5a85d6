# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What PyVista's users give for a point cloud, as what this package's classes take."""
import numpy as np
import pyvista as pv

from . import reading


def check_backend():
    """Refuse a PyVista that does not run on VTK itself: objects of the two do not mix.

    Raises
    ------
    ImportError
        Which says what to do.
    """
    backend = getattr(pv, "vtk_backend", lambda: "vtk")()
    if backend != "vtk":
        raise ImportError(
            f"pointsplatting is built for vtk, and PyVista runs on {backend} here, whose objects "
            "do not mix with VTK's. Start Python with the environment variable "
            "PYVISTA_VTK_BACKEND=vtk, or uninstall the other one.")


def read(path, **choices):
    """What `pyvista.read` does with scans: the entry points' function.

    Parameters
    ----------
    path : str
        The file.
    **choices
        `box` and `spacing` of :func:`pointsplatting.read`.

    Returns
    -------
    pyvista.PolyData
        The points and their arrays.
    """
    check_backend()
    return pv.wrap(reading.read(path, **choices))


def as_cloud(data):
    """Point clouds of any kind as pyvista.PolyData.

    Parameters
    ----------
    data : pyvista.DataSet, vtkDataSet or numpy.ndarray of shape (n, 3)
        Points in world units.

    Returns
    -------
    pyvista.PolyData
        The same object where it is one already, otherwise one that shares the points and arrays.

    Raises
    ------
    TypeError
        For what is no cloud of points, saying what to do with it.
    ValueError
        For an array that is not of shape (n, 3), or of no points.
    """
    if isinstance(data, (list, tuple)):
        data = np.asarray(data, dtype=float)
    if isinstance(data, np.ndarray):
        if data.ndim != 2 or data.shape[1] != 3:
            raise ValueError(f"Points are an array of shape (n, 3), not {data.shape}.")
        if not np.issubdtype(data.dtype, np.floating):
            data = data.astype(float)
        cloud = pv.PolyData()
        cloud.points = data
        return cloud
    data = pv.wrap(data)
    if isinstance(data, pv.PolyData):
        return data
    if isinstance(data, pv.MultiBlock):
        raise TypeError("A MultiBlock is many clouds: add its blocks one by one, or "
                        "`blocks.combine()`.")
    if isinstance(data, (pv.ImageData, pv.RectilinearGrid)):
        raise TypeError("A volume is no cloud: take `volume.splats.contour(isovalues)` of it.")
    if isinstance(data, (pv.PointSet, pv.UnstructuredGrid, pv.StructuredGrid)):
        cloud = pv.PolyData()
        cloud.points = data.points
        cloud.point_data.update(data.point_data)
        normals = data.GetPointData().GetNormals()
        if normals is not None and normals.GetName():
            cloud.point_data.active_normals_name = normals.GetName()
        if data.active_scalars_info.association == pv.FieldAssociation.POINT:
            cloud.set_active_scalars(data.active_scalars_name, preference="point")
        return cloud
    raise TypeError(f"A point cloud is a data set of PyVista or VTK, or an array of shape (n, 3), "
                    f"not {type(data).__name__}.")
