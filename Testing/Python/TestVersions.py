# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""One scene by whatever VTK is here: within 45 dB of the picture by VTK 9.1.

With --write, the picture becomes the baseline.
"""
import math
import pathlib
import sys

from pointsplatting import vtkEGLHeadlessRenderWindow, vtkPointSplatMapper
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter

BASELINE = pathlib.Path(__file__).parents[1] / "Data" / "Baseline" / "TestVersions.png"
LEAST = 45.0 # dB


def ball(radius, resolution):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def torus():
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricTorus())
    source.SetUResolution(200)
    source.SetVResolution(100)
    return source


def draw():
    """A translucent ball around one coloured by height, and a ring."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.1, 0.1, 0.2)
    height = vtkElevationFilter()
    inner = ball(0.35, 100)
    height.SetInputConnection(inner.GetOutputPort())
    height.SetLowPoint(0, 0, -0.35)
    height.SetHighPoint(0, 0, 0.35)
    for source, colour, opacity in (
            (ball(0.6, 120), (0.9, 0.9, 1), 0.4),
            (height, (1, 1, 1), 1),
            (torus(), (1, 0.6, 0.2), 1)):
        mapper = vtkPointSplatMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.SetScalarVisibility(source is height)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetSpecular(0.3)
        renderer.AddActor(actor)
    window = vtkEGLHeadlessRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(250, 200)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(-40)
    renderer.ResetCameraClippingRange()
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.Update()
    return picture.GetOutput()


def values(image):
    scalars = image.GetPointData().GetScalars()
    return [scalars.GetValue(i) for i in range(scalars.GetNumberOfValues())]


picture = draw()
if "--write" in sys.argv:
    writer = vtkPNGWriter()
    writer.SetFileName(str(BASELINE))
    writer.SetInputData(picture)
    writer.Write()
reader = vtkPNGReader()
reader.SetFileName(str(BASELINE))
reader.Update()
drawn, wanted = values(picture), values(reader.GetOutput())
if len(drawn) != len(wanted) or len(set(drawn)) < 50:
    sys.exit("The picture is of another size, or empty.")
error = sum((a - b) ** 2 for a, b in zip(drawn, wanted)) / len(wanted)
psnr = math.inf if error == 0 else 10 * math.log10(255**2 / error)
print(f"{psnr:.1f} dB to the baseline")
sys.exit(psnr < LEAST)
