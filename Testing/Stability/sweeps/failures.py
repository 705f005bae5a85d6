# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stays broken, beside what it should look like, in one picture."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkTextActor
import pointsplatting
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401

from sweeps import layers, samplings, sizes
from sweeps.measures import COUNTS, IMAGE_SPACE, TWO_PASSES, by_method

PIXELS, COLUMNS, LABEL, GAP = 150, 3, 24, 10
STEP = 6  # of colours, so that the file stays small


# Label, scene of a number of points, method.
PANELS = (
    ("A tube of half a spacing's radius", lambda n: sizes.tube_radius(0.5, n), TWO_PASSES),
    ("Sampled 50 to 1", lambda n: samplings.non_uniform(50, n), TWO_PASSES),
    ("1 % outliers", lambda n: samplings.outliers(0.01, n), TWO_PASSES),
    ("Isosurface, noise of a voxel", lambda n: samplings.volume_noise(1, n), TWO_PASSES),
    ("Normals off by 20 degrees", lambda n: samplings.normal_noise(20, n), TWO_PASSES),
    ("Translucent sheets 0.2 radii apart", lambda n: layers.sheets_in_one(0.003, n), TWO_PASSES),
    ("Image space, points 4 pixels apart", lambda n: samplings.density(5000, n), IMAGE_SPACE),
    ("Image space, sampled 20 to 1", lambda n: samplings.non_uniform(20, n), IMAGE_SPACE),
    ("Image space, sheets 0.8 spacings apart", lambda n: layers.parallel_sheets(0.003, n),
     IMAGE_SPACE),
)


def label(text, width):
    window = pointsplatting.vtkEGLHeadlessRenderWindow()
    window.SetSize(width, LABEL)
    window.SetMultiSamples(0)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    actor = vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontSize(13)
    style.SetColor(0, 0, 0)
    style.SetVerticalJustificationToCentered()
    actor.SetPosition(2, LABEL // 2)
    renderer.AddActor2D(actor)
    window.AddRenderer(renderer)
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, LABEL - 1, 0, pixels, 0)
    window.Finalize()
    return vtk_to_numpy(pixels).reshape(LABEL, width, 3)


def panel(text, make, method):
    """Row 0 is the lowest. The mesh stands on the left, the splats on the right."""
    scene = make(COUNTS[method])
    pair = np.concatenate([scene.truth(PIXELS).picture,
                           scene.draw(PIXELS, by_method(method))[0]], 1)
    pair = np.minimum(STEP * np.round(pair / STEP), 255)
    return np.concatenate([pair, label(text, 2 * PIXELS)])


def write(path):
    made = [np.pad(panel(*entry), ((0, GAP), (0, GAP), (0, 0)), constant_values=255)
            for entry in PANELS]
    made += [np.full_like(made[0], 255)] * (-len(made) % COLUMNS)
    rows = [np.concatenate(made[i:i + COLUMNS], 1) for i in range(0, len(made), COLUMNS)]
    whole = np.ascontiguousarray(np.concatenate(rows[::-1])[:, :-GAP], np.uint8)
    image = vtkImageData()
    image.SetDimensions(whole.shape[1], whole.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(whole.reshape(-1, 3), deep=1))
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
