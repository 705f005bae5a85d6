# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of files as stand-ins, whose surface is taken for the one that their vertices lie on: a mesh
divided twice by the butterfly scheme, which keeps vertices where they are, has it. Edges that are sharp,
and what is noise, that scheme makes round."""
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from reference.surfaces import unit
from scenes import polydata
from standin import StandIn, vertices

READERS = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader}


def with_normals(mesh, splitting=False):
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SetSplitting(splitting)
    normals.Update()
    return normals.GetOutput()


def finer(mesh, divisions=2):
    """The mesh divided, with normals; None where edges have more than two triangles."""
    division = vtkButterflySubdivisionFilter()
    division.SetInputData(mesh)
    division.SetNumberOfSubdivisions(divisions)
    division.Update()
    return with_normals(division.GetOutput()) if division.GetOutput().GetNumberOfCells() else None


def of_file(path):
    """Its vertices' normals are the finer mesh's, so that both have those of one surface."""
    reader = READERS[os.path.splitext(path)[1].lower()]()
    reader.SetFileName(path)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    mesh = with_normals(triangles.GetOutput())
    fine = finer(mesh)
    if fine:
        count = mesh.GetNumberOfPoints()
        normals = vtk_to_numpy(mesh.GetPointData().GetNormals())
        normals[:] = vtk_to_numpy(fine.GetPointData().GetNormals())[:count]
    edges = np.diff(vtk_to_numpy(mesh.GetPoints().GetData())[
        vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)], axis=1)
    spacing = float(np.median(np.linalg.norm(edges, axis=2)))
    return StandIn(os.path.basename(path), vertices(mesh), None, spacing, mesh, (lambda: fine) if fine else None)


def triangles_of(standin, shared=True, normals=False):
    """Its mesh as files have them: triangles that share their corners or not, mostly without normals. Then edges of 30
    degrees tell faces apart."""
    mesh = standin.mesh
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    p, n = (vtk_to_numpy(array)
            for array in (mesh.GetPoints().GetData(), mesh.GetPointData().GetNormals()))
    if not shared:
        p, n = p[triangles.ravel()], n[triangles.ravel()]
        triangles = np.arange(len(p)).reshape(-1, 3)
    cloud = polydata(p, n if normals else None, triangles)
    truth = mesh if normals else with_normals(mesh, splitting=True)
    return StandIn(standin.name + ", triangles", cloud, None, standin.spacing, truth)


def wound_both_ways(standin, patches=60, seed=11):
    """Its mesh's vertices with the means of triangles' normals, of which those in some of so many patches are wound the other
    way: along the patches' seams these cancel."""
    mesh = standin.mesh
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    p = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    rng = np.random.default_rng(seed)
    seeds = p[rng.choice(len(p), patches, False)]
    centres = p[triangles].mean(1)
    patch = np.linalg.norm(centres[:, None] - seeds, axis=2).argmin(1)
    normals = np.cross(p[triangles[:, 1]] - p[triangles[:, 0]], p[triangles[:, 2]] - p[triangles[:, 0]])
    normals = unit(normals) * np.where(patch % 2, -1, 1)[:, None]
    sums = np.zeros_like(p)
    for corner in triangles.T:
        np.add.at(sums, corner, normals)
    return StandIn(standin.name + ", wound both ways", polydata(p, unit(sums + 1e-9)), standin.distance, standin.spacing, mesh)
