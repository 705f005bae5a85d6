# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real range scans against a mesh that was made of them."""
import functools

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from sweeps.measures import IMAGE_SPACE, TWO_PASSES, Scene, by_method, look
from sweeps.registry import Stable, Sweep
from sweeps.surfaces import Surface, cloud, random

READERS = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader, ".obj": vtkOBJReader,
           ".stl": vtkSTLReader}


def read(path):
    kind = path[path.rfind("."):].lower()
    if kind not in READERS:
        raise SystemExit("Cannot read %s: its name should end with one of %s." % (
            path, ", ".join(READERS)))
    reader = READERS[kind]()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def real_scans(points_path, mesh_path):
    """The sweep that leaves more and more of the points out, at random."""
    points = read(points_path)
    normals = vtkPolyDataNormals()
    normals.SetInputData(read(mesh_path))
    normals.SplittingOff()
    normals.ConsistencyOn()
    normals.Update()
    surface = Surface(normals.GetOutput(), None)
    p = vtk_to_numpy(points.GetPoints().GetData())
    m = points.GetPointData().GetNormals()
    m = None if m is None else vtk_to_numpy(m)
    bounds = np.array(surface.mesh.GetBounds()).reshape(3, 2)
    centre, size = bounds.mean(1), np.ptp(bounds, 1).max()

    @functools.lru_cache(maxsize=1)
    def scene(share):
        keep = random(1).uniform(0, 1, len(p)) < share
        return Scene([surface], [cloud(p[keep], None if m is None else m[keep])],
                     look(centre + (0, 0, 2.2 * size), centre))

    def measure(method, value, pixels):
        return scene(value).measure(pixels, by_method(method))[0]
    return Sweep("real_scans", "The share of the points that is taken.",
                 [0.003, 0.01, 0.03, 0.1, 0.3, 1],
                 {TWO_PASSES: Stable(), IMAGE_SPACE: Stable()}, measure)
