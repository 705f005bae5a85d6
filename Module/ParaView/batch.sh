#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Module/ParaView/batch.sh [--ranks N] [--with PROGRAM] SCRIPT.py [arguments]: as run.sh
# --paraview does, without building anything. The folder of the build is PARAVIEW_FOLDER, or build-paraview.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/Module/setup.sh"
. "$top/Module/ParaView/setup.sh"
install_paraview >&2
use_paraview
run_paraview "$@"
