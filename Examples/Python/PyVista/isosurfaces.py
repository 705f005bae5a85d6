# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Nested isosurfaces of a volume as oriented points, without a triangle."""
import sys

import numpy as np
import pyvista as pv

grid = pv.ImageData(dimensions=(100, 100, 100), spacing=(0.4, 0.4, 0.4), origin=(-19.8,) * 3)
x, y, z = grid.points.T
r = np.sqrt(x * x + y * y + z * z)
grid["density"] = (np.exp(-r / 3) * (3 * z * z - r * r)) ** 2  # an orbital of hydrogen, 3d

pl = pv.Plotter(off_screen=True, window_size=(700, 600))
for value, colour, opacity in ((4, "steelblue", 0.3), (8, "gold", 0.5), (16, "firebrick", 1.0)):
    surface = grid.splats.contour(value, spacing=0.1)
    pl.splats.add(surface, color=colour, opacity=opacity, specular=0.4)
pl.view_vector((0.5, -1, 0.4))
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "isosurfaces.png")
