# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A simulation that draws its particles as it runs, by ParaView's Catalyst: a drop that is sheared
by a flow. Each process moves the particles of its part, and none writes them to a disk.

bash run.sh --paraview --ranks 2 --with python3 Examples/ParaView/in_situ.py FOLDER

The flow is the one by which surface tracking is tested since R. J. LeVeque, High-resolution
conservative algorithms for advection in incompressible flow, SIAM J. Numer. Anal. 33 (1996).
After FOLDER the numbers of particles and of steps may be given. ParaView 5.11 warns at the first step
that it is not after the last one; it means nothing. What is drawn, and where to, is the Catalyst script's matter: in_situ_splats.py, beside this one.
"""
import os
import sys

import numpy as np
from mpi4py import MPI
from paraview.catalyst import bridge
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

PERIOD = 3.0  # after it the flow has taken everything back
STEP = 0.04


def velocity(p, t):
    """p: positions, n by 3, in the unit cube; returns as many velocities."""
    s, s2 = np.sin(np.pi * p) ** 2, np.sin(2 * np.pi * p)
    (x, y, z), (x2, y2, z2) = s.T, s2.T
    flow = np.stack([2 * x * y2 * z2, -x2 * y * z2, -x2 * y2 * z], 1)
    return np.cos(np.pi * t / PERIOD) * flow


def moved(p, t, dt):
    """Where particles are after a step of the midpoint rule."""
    return p + dt * velocity(p + 0.5 * dt * velocity(p, t), t + 0.5 * dt)


def drop(count):
    """Particles on a sphere, evenly, by the golden angle."""
    i = np.arange(count) + 0.5
    z = 1 - 2 * i / count
    angle = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z * z)
    return 0.35 + 0.15 * np.stack([r * np.cos(angle), r * np.sin(angle), z], 1)


def as_polydata(positions, speeds):
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(positions, deep=1))
    data.SetPoints(points)
    vertices = vtkCellArray()
    for i in range(len(positions)):
        vertices.InsertNextCell(1, [i])
    data.SetVerts(vertices)
    array = numpy_to_vtk(speeds, deep=1)
    array.SetName("Speed")
    data.GetPointData().AddArray(array)
    return data


def main(folder, particles=20000, steps=10):
    os.makedirs(folder, exist_ok=True)
    os.environ["IN_SITU_FOLDER"] = folder
    world = MPI.COMM_WORLD
    bridge.initialize()
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "in_situ_splats.py")
    bridge.add_pipeline(script, 2)
    p = drop(int(particles))
    # Slices along x, of as many particles each.
    p = np.array_split(p[np.argsort(p[:, 0])], world.Get_size())[world.Get_rank()]
    for step in range(int(steps)):
        speeds = np.linalg.norm(velocity(p, step * STEP), axis=1)
        bridge.coprocess(step * STEP, step, as_polydata(p, speeds), name="particles")
        p = moved(p, step * STEP, STEP)
    bridge.finalize()


if __name__ == "__main__":
    main(*sys.argv[1:])
