# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points with levels of detail, as vtkPointSplatOctreeWriter writes them: .h5."""
import pointsplatting

from .reading import run_reader


def read(path, box=None, spacing=None):
    """Read all points of a file, or those about a box.

    Parameters
    ----------
    path : pathlib.Path
        The file.
    box : list of 6 float, optional
        Blocks of points that reach into it, as a whole.
    spacing : None
        Has no meaning here.

    Returns
    -------
    vtkmodules.vtkCommonDataModel.vtkPolyData
        The points with normals and sizes, and the arrays that all pieces have.

    Raises
    ------
    ImportError
        Where VTK was built without HDF5, as its wheels seem from outside.
    OSError
        For a file that is no such file, or is truncated or damaged.
    """
    if not hasattr(pointsplatting, "vtkPointSplatOctreeReader"):
        raise ImportError(f"{path}: this build of pointsplatting has no HDF5. Read it where "
                          "pointsplatting was built against an installed VTK.")
    reader = pointsplatting.vtkPointSplatOctreeReader()
    reader.SetCacheSize(0)  # it reads once
    if box is not None:
        reader.SetBounds(box)
    return run_reader(reader, path)
