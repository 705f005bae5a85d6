# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats and meshes in one scene: points of a knot cut the planes of a mesh, both translucent."""
import sys

import numpy as np
import pyvista as pv

t, a = np.random.default_rng(3).uniform(0, 2 * np.pi, (2, 150_000))
centre = np.column_stack(((2 + np.cos(3 * t)) * np.cos(2 * t), (2 + np.cos(3 * t)) * np.sin(2 * t),
                          np.sin(3 * t)))
radial = np.column_stack((np.cos(2 * t), np.sin(2 * t), np.zeros_like(t)))
knot = centre + 0.35 * (np.cos(a)[:, None] * radial + np.sin(a)[:, None] * [0, 0, 1])

pl = pv.Plotter(off_screen=True, window_size=(700, 600))
pl.enable_depth_peeling()
pl.disable_anti_aliasing()  # splats are smooth without; Mesa peels no multisampled windows
pl.splats.add(knot, scalars=np.cos(t), cmap="twilight", show_scalar_bar=False, opacity=0.8)
pl.add_mesh(pv.Plane(i_size=8, j_size=8), color="lightgray", opacity=0.5)
pl.camera_position = [(0, -9, 7), (0, 0, 0), (0, 0, 1)]
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "beside_meshes.png")
