# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points alone, as of a file: a surface coloured by height, translucent."""
import sys

import pyvista as pv

cloud = pv.PolyData(pv.ParametricDini(u_res=300, v_res=300).points)
cloud["height"] = cloud.points[:, 2]

pl = pv.Plotter(off_screen=True, window_size=(700, 600))
pl.splats.add(cloud, scalars="height", cmap="viridis", opacity=0.6)
pl.camera_position = "xz"
pl.camera.azimuth = 30
pl.camera.elevation = 15
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "height.png")
