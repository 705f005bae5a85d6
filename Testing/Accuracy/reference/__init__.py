# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A reference renderer for scenes whose truth is known, by casting rays in double precision.

It shares no code with the module: where VTK's pictures are to be matched, the formulas are those of
VTK's documentation and shaders, written down again. See caster.render.
"""
from .camera import Camera
from .caster import Part, Picture, render
from .lighting import Light, Material, lights_of
from .shadows import Shadows
from .surfaces import Isosurfaces, Spheres, Torus
