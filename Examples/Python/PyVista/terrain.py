# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain's points at random, lit by a low sun that casts shadows."""
import sys

import numpy as np
import pyvista as pv

random = np.random.default_rng(7)
x, y = random.uniform(-10, 10, (2, 200_000))
z = sum(h * np.exp(-((x - u) ** 2 + (y - v) ** 2) / w)
        for u, v, h, w in random.uniform((-9, -9, 0.5, 1), (9, 9, 2.5, 6), (30, 4)))
points = np.column_stack((x, y, z))

pl = pv.Plotter(off_screen=True, window_size=(700, 500), lighting="none")
pl.splats.add(points, scalars=z, cmap="gist_earth", clim=(-2, 6), shadows=True,
              scalar_bar_args={"title": "height", "color": "white"})
pl.add_light(pv.Light(position=(40, 10, 12), light_type="scene light", intensity=1.0))
pl.add_light(pv.Light(light_type="headlight", intensity=0.25))
pl.camera_position = [(0, -24, 15), (0, 0, 0), (0, 0, 1)]
pl.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else "terrain.png")
