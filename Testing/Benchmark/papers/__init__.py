# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of papers.py: a page, data, frames, and a module for each paper."""
