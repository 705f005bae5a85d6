# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Noisy points as they are, and as they are drawn by default: moved onto one surface."""
import sys

import numpy as np
import pyvista as pv

torus = pv.ParametricTorus(u_res=300, v_res=150).points
noisy = pv.PolyData(torus + np.random.default_rng(1).normal(0, 0.012, torus.shape))

pl = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(900, 450))
for column, (title, project) in enumerate({"as scanned": False, "by default": True}.items()):
    pl.subplot(0, column)
    pl.splats.add(noisy, color="wheat", project_noise=project)
    pl.add_text(title, font_size=10)
    pl.view_vector((0, -1, 1.2))
    pl.camera.zoom(1.5)
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "noise.png")
