# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scanner of meshes: grids of ranges, as seen from one side."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from sweeps.measures import Window


def range_scan(mesh, direction, step, noise, rng):
    """What a scanner at infinity in that direction sees, in rows and columns a step apart: points
    whose ranges have a normal error of deviation noise, and normals by differences of these
    ranges. Where neighbours in the grid are missing or jump by more than four steps there is no
    point, as scanners leave grazing ones out."""
    w = np.asarray(direction, float) / np.linalg.norm(direction)
    u = np.cross(w, (0.0, 1.0, 0.0) if abs(w[1]) < 0.9 else (1.0, 0.0, 0.0))
    u /= np.linalg.norm(u)
    v = np.cross(w, u)
    low, high = (np.array(mesh.GetBounds()[i::2]) for i in range(2))
    centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    size = int(np.ceil(2 * radius / step))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = Window.of(size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(size * step / 2)
    camera.SetPosition(*(centre + 2 * radius * w))
    camera.SetFocalPoint(*centre)
    camera.SetViewUp(*v)
    camera.SetClippingRange(radius, 3 * radius)
    window.Render()
    values = vtkFloatArray()
    window.GetZbufferData(0, 0, size - 1, size - 1, values)
    window.RemoveRenderer(renderer)
    z = vtk_to_numpy(values).reshape(size, size).astype(float)
    height = np.where(z < 1, radius - 2 * radius * z, np.nan)  # over the centre, towards the scanner
    height += rng.normal(0, noise, height.shape)
    along = (np.arange(size) + 0.5) * step - size * step / 2
    x, y = np.meshgrid(along, along)
    # The camera's right hand is up x w = v x w = u.
    p = centre + x[..., None] * u + y[..., None] * v + height[..., None] * w
    du, dv = p[1:-1, 2:] - p[1:-1, :-2], p[2:, 1:-1] - p[:-2, 1:-1]
    n = np.cross(du, dv)
    jump = np.maximum(abs(du @ w), abs(dv @ w))
    keep = np.isfinite(n).all(2) & (jump < 8 * step) & np.isfinite(height[1:-1, 1:-1])
    p, n = p[1:-1, 1:-1][keep], n[keep]
    return p, n / np.linalg.norm(n, axis=1, keepdims=True)
