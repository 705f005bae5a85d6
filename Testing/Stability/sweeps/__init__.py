# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of stability.py: surfaces and points of them, what is measured, the sweeps, pictures."""
