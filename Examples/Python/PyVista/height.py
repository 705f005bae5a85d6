# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points at random and nothing else, as of a file: coloured by height, translucent."""
import sys

import numpy as np
import pyvista as pv

directions = np.random.default_rng(5).normal(size=(200_000, 3))
directions /= np.linalg.norm(directions, axis=1)[:, None]
x, y, z = directions.T
cloud = pv.PolyData(directions * (1 + 0.3 * np.sin(5 * x) * np.sin(5 * y) * np.cos(4 * z))[:, None])
cloud["height"] = cloud.points[:, 2]

pl = pv.Plotter(off_screen=True, window_size=(700, 600))
pl.splats.add(cloud, scalars="height", cmap="viridis", opacity=0.6)
pl.view_vector((0.5, -1, 0.3))
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "height.png")
