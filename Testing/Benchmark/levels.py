#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What levels of detail gain and cost.

  levels.py [--points MILLIONS ...] [--size PIXELS] [--scenes NAME ...] [--method METHOD] [--shadows]

For a torus, a bumpy ball, one whose normals are noisy as scans' are, and a torus with colours, this
prints of several numbers of points the processor time of a frame (median) with all points drawn
and with levels, the splats that were projected, the time until levels were there, and of the picture
with levels against that of all points the psnr and the share of pixels that differ by more than
1/256. FilterPixels, SmoothPixels, SmoothDeviation and PointPixels of Rendering/Choice/vtkPointSplatChoices.cxx are
such that all smooth scenes have 45 dB at least, by image space and in shadows, too; with other values they are to be changed there.
"""
import argparse
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer
import pointsplatting

from bench.shapes import bumpy, rough, torus

SCENES = {
    "torus": torus,
    "bumpy ball": bumpy,
    "noisy ball": rough,
    "painted torus": torus,
}
# Seconds, and seconds for each million points; where they are of no use they never come.
LONGEST_WAIT = 60.0, 5.0


def cloud(name, count):
    points, normals = SCENES[name](count, np.random.default_rng(1))
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    data.SetPoints(places)
    data.GetPointData().SetNormals(numpy_to_vtk(normals.astype(np.float32), deep=True))
    # Of evenly random points disks of one and a half spacings cover all but a few places.
    area = 4 * np.pi ** 2 * 0.4 if "torus" in name else 4 * np.pi * 1.1
    radii = numpy_to_vtk(np.full(count, 1.5 * np.sqrt(area / count), np.float32), deep=True)
    radii.SetName("SplatRadius")
    data.GetPointData().AddArray(radii)
    if name.startswith("painted"):
        values = np.sin(3 * np.arctan2(points[:, 1], points[:, 0])) * points[:, 2]
        scalars = numpy_to_vtk(values.astype(np.float32), deep=True)
        scalars.SetName("Values")
        data.GetPointData().SetScalars(scalars)
    return data


class Drawing:
    def __init__(self, data, size, method="Automatic", shadows=False):
        self.size = size
        self.mapper = pointsplatting.vtkPointSplatMapper()
        self.mapper.SetInputData(data)
        getattr(self.mapper, "SetMethodTo" + method)()
        self.mapper.SetShadows(shadows)
        self.mapper.SetNumberOfShadowSamples(4)
        self.mapper.SetShadowLightRadius(0.1)
        if data.GetPointData().GetScalars():
            self.mapper.SetScalarRange(data.GetPointData().GetScalars().GetRange())
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        actor.GetProperty().SetColor(0.35, 0.55, 0.95)
        actor.GetProperty().SetSpecular(0.3)
        actor.GetProperty().SetSpecularPower(20)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.2, 0.4)
        self.renderer.AddActor(actor)
        if shadows:
            lamp = vtkLight()
            lamp.SetLightTypeToSceneLight()
            lamp.SetPosition(3.0, -0.5, 1.0)
            self.renderer.AddLight(lamp)
        self.window = pointsplatting.vtkEGLHeadlessRenderWindow()
        self.window.SetSize(size, size)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()
        self.renderer.GetActiveCamera().Elevation(-50)
        self.renderer.GetActiveCamera().Zoom(1.3)
        self.renderer.ResetCameraClippingRange()

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).astype(float)

    def milliseconds(self, frames=6):
        times = []
        for _ in range(frames):
            self.renderer.GetActiveCamera().Azimuth(360.0 / frames)
            self.renderer.ResetCameraClippingRange()
            start = time.process_time()
            self.picture()
            times.append(1e3 * (time.process_time() - start))
        return statistics.median(times[1:])

    def wait(self):
        """Draws until there are levels; the seconds it took, or None where there are none."""
        start = time.perf_counter()
        points = self.mapper.GetInput().GetNumberOfPoints()
        while time.perf_counter() - start < LONGEST_WAIT[0] + LONGEST_WAIT[1] * points / 1e6:
            self.renderer.GetActiveCamera().Azimuth(1e-6)
            self.window.Render()
            if "stand for others" in self.mapper.GetChoices():
                return time.perf_counter() - start
            time.sleep(0.1)
        return None


def psnr(a, b):
    return 10 * np.log10(255.0 ** 2 / max(np.mean((a - b) ** 2), 1e-9))


def measure(name, count, options):
    drawing = Drawing(cloud(name, count), options.size, options.method, options.shadows)
    drawing.mapper.LevelOfDetailOff()
    drawing.picture()
    whole = drawing.milliseconds()
    drawing.mapper.LevelOfDetailOn()
    waited = drawing.wait()
    levels = drawing.picture()
    drawn = drawing.mapper.GetNumberOfPointsProjected()
    fast = drawing.milliseconds()
    drawing.mapper.LevelOfDetailOff()
    every = drawing.picture()
    drawing.mapper.LevelOfDetailOn()
    levels = drawing.picture()
    apart = np.abs(every - levels).reshape(-1, 3).max(axis=1)
    made = "-" if waited is None else f"{waited:.1f}"
    print(f"{name:14s} {count / 1e6:6.1f} {whole:9.0f} {fast:9.0f} {drawn:10d} {made:>7s} "
          f"{psnr(every, levels):7.1f} {100 * np.mean(apart > 1):8.2f}", flush=True)
    drawing.window.Finalize()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, nargs="+", default=[4.0, 16.0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=list(SCENES))
    parser.add_argument("--method", default="Automatic", choices=["Automatic", "TwoPass", "ImageSpace"])
    parser.add_argument("--shadows", action="store_true")
    options = parser.parse_args()
    print("scene          points,M   all, ms levels, ms  projected made, s  psnr, dB  > 1/256, %")
    for name in options.scenes:
        for millions in options.points:
            measure(name, int(1e6 * millions), options)


if __name__ == "__main__":
    main()
