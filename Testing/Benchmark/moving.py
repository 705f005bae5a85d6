#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What frames of points that move cost, and how near they are to the surface.

  moving.py [--points MILLIONS ...] [--size PIXELS] [--motions NAME ...] [--sized]
  moving.py --strain [--points MILLIONS] [--size PIXELS]

Of a torus whose points move in each frame this prints the processor time and the wall-clock time of a frame (medians):
of points that stay, all of them and with levels; of moving ones whose sizes follow (SetFollowMotion), the first that moves and those after it;
and of moving ones whose sizes are estimated anew, one frame. With --sized the points have radii.

--strain: ever larger strains, from none, and the psnr of pictures with sizes that follow, and with new ones, against those of a fine mesh
that is moved likewise. LargestStrain in Rendering/Cloud/vtkPointSplatMotion.cxx is where the former begin to fall behind,
which is seen with a larger one: with that which is there, sizes are new where it says that they do not follow.
"""
import argparse
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

from levels import Drawing, cloud, psnr


def moved(points, normals, linear):
    """Points by a linear map, normals by its inverse's transpose."""
    turned = normals @ np.linalg.inv(linear)
    return points @ linear.T, turned / np.linalg.norm(turned, axis=1)[:, None]


def turn(points, normals, t):
    c, s = np.cos(t), np.sin(t)
    return moved(points, normals, np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]))


def swell(points, normals, t):
    return points * (1.0 + 0.3 * np.sin(t)), normals


def shear(points, normals, t):
    return moved(points, normals, np.array([[1.0, t, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]))


def stretch(points, normals, t):
    return moved(points, normals, np.diag([1.0 + t, 1.0, 1.0]))


def wave(points, normals, t):
    """z + 0.15 sin(3 x + t) - 0.15 sin(3 x)."""
    x = 3.0 * points[:, 0]
    slope = 0.45 * (np.cos(x + t) - np.cos(x))
    lifted = points.copy()
    lifted[:, 2] += 0.15 * (np.sin(x + t) - np.sin(x))
    turned = normals.copy()
    turned[:, 0] -= slope * normals[:, 2]
    return lifted, turned / np.linalg.norm(turned, axis=1)[:, None]


MOTIONS = {"turn": turn, "swell": swell, "wave": wave}
STRAINS = {"shear": shear, "stretch": stretch, "wave": wave}
STEP = 0.02


class Moving:
    """A cloud, and where its points are at a time."""

    def __init__(self, data, motion):
        self.data = data
        self.motion = motion
        self.places = data.GetPoints().GetData()
        self.normals = data.GetPointData().GetNormals()
        self.rest = vtk_to_numpy(self.places).copy(), vtk_to_numpy(self.normals).copy()

    def to(self, t):
        points, normals = self.motion(*self.rest, t)
        vtk_to_numpy(self.places)[:] = points
        vtk_to_numpy(self.normals)[:] = normals
        for changed in (self.places, self.normals, self.data.GetPoints()):
            changed.Modified()


def timed(drawing, frames, before):
    times = []
    for i in range(frames):
        before(i)
        drawing.renderer.GetActiveCamera().Azimuth(2.0)
        drawing.renderer.ResetCameraClippingRange()
        start = time.process_time(), time.perf_counter()
        drawing.picture()
        times.append((time.process_time() - start[0], time.perf_counter() - start[1]))
    return [1e3 * statistics.median(t[k] for t in times) for k in range(2)]


def measure(name, count, options):
    data = cloud("torus", count)
    if not options.sized:
        data.GetPointData().RemoveArray("SplatRadius")
    drawing = Drawing(data, options.size)
    moving = Moving(data, MOTIONS[name])
    still = lambda _: None
    step = lambda first: lambda i: moving.to(STEP * (first + i))
    drawing.mapper.LevelOfDetailOff()
    drawing.picture()
    rows = {"all points, still": timed(drawing, 6, still)}
    drawing.mapper.LevelOfDetailOn()
    drawing.wait()
    rows["still"] = timed(drawing, 6, still)
    rows["first that moves"] = timed(drawing, 1, step(1))
    rows["moving"] = timed(drawing, 12, step(2))
    drawing.mapper.FollowMotionOff()
    rows["moving, estimated anew"] = timed(drawing, 1, step(20))
    for row, (processor, wall) in rows.items():
        print(f"{name:8s} {count / 1e6:6.2f} {row:24s} {processor:9.0f} {wall:9.0f}", flush=True)
    drawing.window.Finalize()


def fine_mesh(steps=1000):
    """The torus of radii 1 and 0.4 of the cloud."""
    f, t = np.meshgrid(np.arange(2 * steps) * np.pi / steps, np.arange(steps) * 2 * np.pi / steps,
                       indexing="ij")
    normals = np.stack([np.cos(f) * np.cos(t), np.sin(f) * np.cos(t), np.sin(t)], axis=-1).reshape(-1, 3)
    points = np.stack([np.cos(f), np.sin(f), 0 * f], axis=-1).reshape(-1, 3) + 0.4 * normals
    at = lambda i, j: (i % (2 * steps)) * steps + j % steps
    i, j = np.meshgrid(np.arange(2 * steps), np.arange(steps), indexing="ij")
    quads = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], axis=-1).reshape(-1, 4)
    return points, normals, quads


def mesh_data(data):
    points, normals, quads = fine_mesh()
    data.GetPoints().SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype(np.float32), deep=True))
    cells = vtkCellArray()
    ids = numpy_to_vtk(quads.ravel().astype(np.int64), deep=True, array_type=vtkIdTypeArray().GetDataType())
    cells.SetData(4, ids)
    data.SetPolys(cells)
    return data


def strains(name, count, options):
    def drawing_of(data):
        return Drawing(data, options.size)

    clouds = [cloud("torus", count) for _ in range(2)]
    for data in clouds:
        data.GetPointData().RemoveArray("SplatRadius")
    mesh = mesh_data(cloud("torus", 8))
    mesh.GetPointData().RemoveArray("SplatRadius")
    following, anew = (drawing_of(data) for data in clouds)
    anew.mapper.FollowMotionOff()
    true = drawing_of(mesh)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    true.renderer.GetActors().GetLastActor().SetMapper(mapper)
    moving = [Moving(data, STRAINS[name]) for data in (*clouds, mesh)]
    following.picture()
    for t in np.arange(0.0, 0.81, 0.1):
        for one in moving:
            one.to(t)
        for other in (following, anew, true):
            other.renderer.ResetCameraClippingRange()
        pictures = [one.picture() for one in (following, anew, true)]
        follows = "sizes of an earlier" in following.mapper.GetChoices()
        print(f"{name:8s} {t:5.2f} {'yes' if follows else 'no':>8s} {psnr(pictures[0], pictures[2]):10.1f} "
              f"{psnr(pictures[1], pictures[2]):10.1f}", flush=True)
    for one in (following, anew, true):
        one.window.Finalize()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, nargs="+", default=[1.0, 4.0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--motions", nargs="+", default=list(MOTIONS), choices=list(MOTIONS))
    parser.add_argument("--sized", action="store_true")
    parser.add_argument("--strain", action="store_true")
    options = parser.parse_args()
    if options.strain:
        print("motion     by  follows  psnr, dB       anew")
        for name in STRAINS:
            strains(name, int(1e6 * options.points[0]), options)
        return
    print("motion   points,M                          processor, ms  wall, ms")
    for name in options.motions:
        for millions in options.points:
            measure(name, int(1e6 * millions), options)


if __name__ == "__main__":
    main()
