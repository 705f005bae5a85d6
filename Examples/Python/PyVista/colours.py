# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours of points (RGB), as photographs give them, unlit and lit."""
import sys

import numpy as np
import pyvista as pv

globe = pv.Sphere(theta_resolution=400, phi_resolution=300)
x, y, z = globe.points.T / 0.5
land = np.sin(5 * x + 2 * np.sin(3 * y)) + np.sin(4 * y + 3 * z) + np.sin(6 * z - 2 * x) > 0.4
colours = np.where(land[:, None], (70, 130, 60), (30, 70, 160)).astype(np.uint8)
colours[np.abs(z) > 0.9] = 240

pl = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(900, 450))
for column, lighting in enumerate((False, True)):
    pl.subplot(0, column)
    pl.splats.add(globe, scalars=colours, rgb=True, lighting=lighting)
    pl.camera.zoom(1.5)
    pl.add_text("lit" if lighting else "unlit", font_size=10)
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "colours.png")
