# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation on all types of data, and what it obeys: colours, blocks, opacity, clips."""
import numpy as np
from paraview.simple import (
    Clip, ColorBy, Delete, FastUniformGrid, GetColorTransferFunction, GetOpacityTransferFunction,
    Hide, Plane, Sphere,
)  # fmt: skip

import splat_scenes as scenes
from splat_scenes import at_least, covered, picture, psnr

view = scenes.new_view()

# A cloud is what its mesh is.
mesh = Sphere(Radius=1, ThetaResolution=256, PhiResolution=256)
shown = scenes.show(mesh, view, "Surface")
assert "Point Splats" in shown.GetProperty("Representation").GetAvailable()
surface = picture(view)
Hide(mesh, view)
polydata = scenes.cloud()
splats = scenes.show(polydata, view)
reference = picture(view)
at_least(psnr(surface, reference), 35, "splats against the mesh, dB")

# Types of data.
Hide(polydata, view)
grid = scenes.cloud(type="vtkUnstructuredGrid")
scenes.show(grid, view)
at_least(psnr(reference, picture(view)), 55, "unstructured grid against poly data, dB")
Hide(grid, view)
bare = scenes.cloud(normals=False)
scenes.show(bare, view)
at_least(psnr(reference, picture(view)), 35, "estimated normals against given ones, dB")
Hide(bare, view)
image = FastUniformGrid(WholeExtent=[-1, 1, -1, 1, 0, 0])
scenes.show(image, view)
assert covered(picture(view)).sum() > 5000, "nothing is drawn of an image's points"
Hide(image, view)

# Clips, opacity, and back.
clip = Clip(Input=grid)
clip.ClipType = "Plane"
clip.ClipType.Origin, clip.ClipType.Normal = [0, 0, 0], [0, 0, 1]
scenes.show(clip, view)
half = covered(picture(view)).sum() / covered(reference).sum()
assert 0.4 < half < 0.8, f"{half} of the picture is left of a clipped cloud"
Hide(clip, view)
splats.Visibility = 1
splats.Opacity = 0.5
translucent = picture(view)
assert covered(translucent).sum() > 0.98 * covered(reference).sum()
assert psnr(translucent, reference) < 35, "opacity does nothing"
assert scenes.information(splats, "SplatLayersDrawn") == 2
assert "peel" in scenes.information(splats, "SplatChoices")
splats.Opacity = 1
at_least(psnr(reference, picture(view)), 60, "opaque again, dB")
splats.Representation = "Points"
picture(view)
splats.Representation = "Point Splats"
at_least(psnr(reference, picture(view)), 60, "splats again after points, dB")
splats.SplatRadiusScale = 0.2
assert psnr(reference, picture(view)) < 35, "the size factor does nothing"
splats.SplatRadiusScale = 1
splats.SplatSizeArray = "Size"
splats.SplatSizeByArray = 1
assert psnr(reference, picture(view)) < 60, "the size array does nothing"
splats.SplatSizeByArray = 0
at_least(psnr(reference, picture(view)), 60, "sizes of its own again, dB")

# Colours by arrays are those of the representation Points, on the same pixels.
splats.Visibility = 0
view.UseFXAA = 0  # it blurs single pixels
plane = Plane(XResolution=200, YResolution=200)
# Each point is in the middle of a pixel: 0.005 apart are both.
view.CameraParallelProjection, view.CameraParallelScale = 1, 0.75
view.CameraFocalPoint, view.CameraViewUp = [0.0025, 0.0025, 0], [0, 1, 0]
view.CameraPosition = [0.0025, 0.0025, 1.5]
coloured = scenes.show(plane, view)
coloured.Ambient, coloured.Diffuse = 1, 0
ColorBy(coloured, ("POINTS", "TextureCoordinates", "X"))
by_splats = picture(view)
coloured.Representation = "Points"
coloured.PointSize = 1
by_points = picture(view)
both = covered(by_splats) & covered(by_points)
assert both.sum() > 10000
worst = np.abs(by_splats - by_points)[both].max()
print("colours differ by", worst)
assert worst <= 2, f"colours differ by {worst} of 255"
coloured.Representation = "Point Splats"
table = GetColorTransferFunction("TextureCoordinates")
table.EnableOpacityMapping = 1
opacities = GetOpacityTransferFunction("TextureCoordinates")
opacities.Points = [0, 0, 0.5, 0, 1, 1, 0.5, 0]
mapped = picture(view)
right = covered(mapped)[100:200, 250:280].mean()
assert psnr(mapped, by_splats) < 30 and right > 0.99, "opacities are not mapped"
Hide(plane, view)
view.UseFXAA = 1
scenes.place(view)

# Blocks, hidden, coloured and translucent.
blocks = scenes.cloud(scenes.THREE_SPHERES, "vtkMultiblockDataSet")
spheres = scenes.show(blocks, view)
at_least(psnr(reference, picture(view)), 60, "the outermost of three blocks against it alone, dB")
spheres.BlockSelectors = ["/Root/Block1", "/Root/Block2"]
inner = picture(view)
assert 0.4 < covered(inner).sum() / covered(reference).sum() < 0.6, "a block is not hidden"
spheres.BlockColors = ["/Root/Block1", "1", "0", "0"]
red = picture(view)
middle = red[150, 200]
assert middle[0] > 2 * middle[1] and middle[0] > 2 * middle[2], f"a block is not red but {middle}"
spheres.BlockOpacities = ["/Root/Block1", "0.3"]
assert psnr(red, picture(view)) < 35, "a block is not translucent"
spheres.BlockSelectors = ["/"]
spheres.BlockOpacities, spheres.BlockColors = [], []
at_least(psnr(reference, picture(view)), 60, "all blocks again, dB")
ColorBy(spheres, ("FIELD", "vtkBlockColors"))
spheres.BlockSelectors = ["/Root/Block2"]
assert covered(picture(view)).sum() > 1000
Delete(blocks)
