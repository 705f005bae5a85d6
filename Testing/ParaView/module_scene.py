# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Of TestAgainstModule.py: a scene whose camera, light and colours the VTK module can have, too.

Argument: a folder to write the points and pictures to.
"""
import os
import sys

from paraview.simple import AddLight, SaveData

import splat_scenes as scenes

folder = sys.argv[1]
view = scenes.new_view()
view.UseFXAA = 0
view.UseLight = 0  # the light kit
light = AddLight(view)
light.Coords, light.Position, light.FocalPoint = "Scene", [4, -1, 5], [0, 0, 0]
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode, view.Background = "Single Color", [0, 0, 0]
points = scenes.cloud()
SaveData(os.path.join(folder, "points.vtp"), points)
splats = scenes.show(points, view)
splats.AmbientColor = splats.DiffuseColor = [0.9, 0.6, 0.3]
splats.Specular, splats.SpecularPower, splats.SpecularColor = 0.4, 30, [1, 1, 1]
scenes.picture(view, os.path.join(folder, "opaque.png"))
splats.Opacity = 0.5
scenes.picture(view, os.path.join(folder, "translucent.png"))
