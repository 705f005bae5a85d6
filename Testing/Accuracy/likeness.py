# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""How much the picture of a cloud, every setting at its default, is like that of the mesh of the
same surface, and how well its splats' sizes fit the surface.

  likeness.py [--pictures FOLDER] [--size PIXELS] [--opacity O] [--light X Y Z] [STAND-IN or FILE of a mesh ...]

The mesh is drawn supersampled 3 x 3 as the truth, and once more as it is. psnr: in dB over the
pixels three inside the silhouette; gap: by how much the plain mesh's is higher; holes: of these
pixels those where nothing is drawn though all nine samples of the mesh show it; openings: pixels that
show something behind the mesh, by more than a hundredth of its diagonal (of opaque ones); spill: pixels
drawn more than two outside the silhouette, over its area; close up: the psnr of the last view; gap of
field: the gap where the truth is a finer mesh of the same surface, supersampled likewise, as there is
for some stand-ins and for files (meshes.py). --light: where the only lamp is, seen from the camera, whose view goes to
-z; else it is a headlight, by which an outline's two sides look much the same.
"""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer
import pointsplatting

from drawing import depth, save, window
from measures import grown, inner, openings, psnr
import meshes
import standins

BACKGROUND = (0.1, 0.2, 0.4)
ELEVATIONS = (-20, 15, 40, 5)
SAMPLES = 3
BEHIND = 0.01  # of the diagonal


class View:
    """A window with one actor."""

    def __init__(self, mapper, size, opacity, light=None):
        self.size = size
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(BACKGROUND)
        if opacity < 1:
            self.renderer.SetUseDepthPeeling(1)
            self.renderer.SetMaximumNumberOfPeels(30)
            self.renderer.SetOcclusionRatio(0.0)
        if light:
            lamp = vtkLight()
            lamp.SetLightTypeToCameraLight()
            lamp.SetPosition(light)
            lamp.SetFocalPoint(0, 0, 0)
            self.renderer.AddLight(lamp)
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.35, 0.55, 0.95)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetSpecular(0.3)
        actor.GetProperty().SetSpecularPower(20)
        self.renderer.AddActor(actor)
        self.window = window(size, size)
        self.window.AddRenderer(self.renderer)

    def draw(self, k, close, bounds):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -1, 0)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(30)
        self.renderer.ResetCamera(bounds)
        camera.Azimuth(25 + 95 * k)
        camera.Elevation(ELEVATIONS[k % 4])
        if close:
            camera.Dolly(3.0)
        self.renderer.ResetCameraClippingRange(bounds)
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(self.size, self.size, 3).astype(np.float32)


def of_mesh(mesh):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    return mapper


def of_cloud(cloud):
    mapper = pointsplatting.vtkPointSplatMapper()
    mapper.SetInputData(cloud)
    return mapper


def differs(picture):
    """Where something is drawn, by its shade."""
    return np.logical_or.reduce([np.abs(picture[..., c] - np.float32(round(255 * value))) > 2
                                 for c, value in enumerate(BACKGROUND)])


def samples_of(picture):
    """Pictures of each pixel's first sample, second sample and so on."""
    return [picture[j::SAMPLES, i::SAMPLES] for j in range(SAMPLES) for i in range(SAMPLES)]


def averaged(picture):
    return sum(samples_of(picture)) / np.float32(SAMPLES ** 2)


def compare(standin, size=512, views=4, opacity=1.0, pictures=None, light=None):
    """The figures, as a dictionary: psnr and gap a view, holes and openings of all views, the largest
    spill."""
    fine = View(of_mesh(standin.mesh), SAMPLES * size, opacity, light)
    plain = View(of_mesh(standin.mesh), size, opacity, light)
    splats = View(of_cloud(standin.cloud), size, opacity, light)
    field = View(of_mesh(standin.fine()), SAMPLES * size, opacity, light) if standin.fine else None
    found = {"psnr": [], "gap": [], "holes": 0, "openings": 0, "spill": 0.0}
    if field:
        found["gap of field"] = []

    for k in range(views):
        close = k == views - 1 and views > 1
        drawn = [view.draw(k, close, standin.mesh.GetBounds()) for view in (fine, plain, splats)]
        truth = averaged(drawn[0])
        covered = differs(truth)
        whole = np.logical_and.reduce(samples_of(differs(drawn[0])))
        is_drawn = differs(drawn[2])
        if opacity == 1:
            depths = [depth(view.window, view.renderer) for view in (splats, plain)]
            found["openings"] += openings(*depths, BEHIND * standin.mesh.GetLength())
            is_drawn |= np.isfinite(depths[0])  # also where its shade is the background's
        inside = inner(covered, 3)
        judged = inside & is_drawn
        found["holes"] += int((inside & whole & ~is_drawn).sum())
        spill = (is_drawn & ~grown(covered, 2)).sum() / max(1, covered.sum())
        found["spill"] = max(found["spill"], float(spill))
        both = [psnr(picture, truth, judged) or 0.0 for picture in drawn[1:]]
        found["psnr"].append(round(both[1], 1))
        found["gap"].append(round(both[0] - both[1], 1))
        if field:
            surface = averaged(field.draw(k, close, standin.mesh.GetBounds()))
            both = [psnr(picture, surface, judged) or 0.0 for picture in drawn[1:]]
            found["gap of field"].append(round(both[0] - both[1], 1))
        if pictures:
            os.makedirs(pictures, exist_ok=True)
            save(os.path.join(pictures, "%s-%d.png" % (standin.name.replace(" ", "_"), k)),
                 np.concatenate([truth, drawn[2], 4 * np.abs(truth - drawn[2])], 1))
    for view in filter(None, (fine, plain, splats, field)):
        view.window.Finalize()
    return found


def estimated(cloud, fill_gaps=False):
    estimation = pointsplatting.vtkPointSplatEstimation()
    estimation.SetInputData(cloud)
    estimation.SetFillGaps(fill_gaps)
    estimation.Update()
    return estimation


def sizes(standin, samples=16):
    """Of the default estimation: percentiles 1, 50, 99 and 100 of the radii in spacings, and the share
    of the disks' area, bent as they are drawn, that is farther than a fifth of the radius from the
    true surface."""
    data = estimated(standin.cloud).GetOutput()
    found = data.GetPointData()
    p = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    radius = vtk_to_numpy(found.GetArray("SplatRadius")).astype(float)
    n = vtk_to_numpy(found.GetArray("SplatPlaneNormal")).astype(float)
    # Bodies alone have no plane: any is as good.
    n[~n.any(1)] = (0, 0, 1)
    c = vtk_to_numpy(found.GetArray("SplatCurvature")).astype(float)
    form = np.stack([c[:, [0, 3, 5]], c[:, [3, 1, 4]], c[:, [5, 4, 2]]], 1)
    s = np.cross(n, np.eye(3)[np.argmin(np.abs(n), 1)])
    s /= np.linalg.norm(s, axis=1)[:, None]
    t = np.cross(n, s)
    off = area = 0.0
    for k in range(samples):
        r, a = np.sqrt((k + 0.5) / samples), k * np.pi * (3 - np.sqrt(5))
        d = radius[:, None] * r * (np.cos(a) * s + np.sin(a) * t)
        bend = np.einsum("ij,ijk,ik->i", d, form, d)
        q = p + d - 0.5 * bend[:, None] * n
        off += (radius ** 2 * (standin.distance(q) > 0.2 * radius)).sum()
        area += (radius ** 2).sum()
    return {"radii": np.percentile(radius, (1, 50, 99, 100)) / standin.spacing, "off": off / area}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pictures")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--opacity", type=float, default=1.0)
    parser.add_argument("--light", type=float, nargs=3, metavar=("X", "Y", "Z"))
    parser.add_argument("standins", nargs="*", metavar="STAND-IN", help=", ".join(standins.ALL) + ", or a mesh's file")
    options = parser.parse_args()
    for name in options.standins or standins.ALL:
        standin = standins.ALL[name]() if name in standins.ALL else meshes.of_file(name)
        line = "%-16s %7d points" % (standin.name, standin.cloud.GetNumberOfPoints())
        if standin.distance:
            fit = sizes(standin)
            line += ", radii %s, off %.4f" % (" ".join("%.2f" % r for r in fit["radii"]), fit["off"])
        if standin.mesh:
            found = compare(standin, options.size, 4, options.opacity, options.pictures, options.light)
            line += ", psnr {psnr}, gap {gap}, holes {holes}, openings {openings}".format(**found)
            line += ", spill {spill:.4f}".format(**found)
            if standin.fine:
                line += ", gap of field {gap of field}".format(**found)
        print(line, flush=True)


if __name__ == "__main__":
    main()
