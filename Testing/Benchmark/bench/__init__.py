# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of splatbench: what is drawn, timed, held against the truth, charted and told."""
