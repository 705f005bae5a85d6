# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
# script-version: 2.0
"""What in_situ.py shows of its particles: a Catalyst script; pictures go to IN_SITU_FOLDER."""
import os

from paraview.catalyst import Options
from paraview.simple import (
    ColorBy, CreateExtractor, CreateRenderView, GetColorTransferFunction, Show, TrivialProducer,
)  # fmt: skip

particles = TrivialProducer(registrationName="particles")
view = CreateRenderView(ViewSize=[480, 360])
view.OrientationAxesVisibility = 0
view.CameraPosition = [1.2, -0.6, 1.0]
view.CameraFocalPoint = [0.36, 0.4, 0.37]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 24

splats = Show(particles, view)
splats.Representation = "Point Splats"
ColorBy(splats, ("POINTS", "Speed"))
colours = GetColorTransferFunction("Speed")
colours.AutomaticRescaleRangeMode = "Never"
colours.RescaleTransferFunction(0.0, 2.0)

pictures = CreateExtractor("PNG", view, registrationName="pictures")
pictures.Trigger = "TimeStep"
pictures.Writer.FileName = "splats_{timestep:03d}.png"
pictures.Writer.ImageResolution = [480, 360]

options = Options()
options.ExtractsOutputDirectory = os.environ.get("IN_SITU_FOLDER", ".")
