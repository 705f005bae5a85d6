# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Inside a VTK tree: the umbrella has no code of its own, only dependencies.
vtk_module_add_module(VTK::PointSplatting HEADER_ONLY)
