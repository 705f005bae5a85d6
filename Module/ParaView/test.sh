#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Module/ParaView/test.sh [ctest arguments]: builds the ParaView plugin and runs its tests.
# What its pictures are compared with is the module of this tree's own build.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/Module/setup.sh"
. "$top/Module/ParaView/setup.sh"
packages+=("${test_packages[@]}")
install_paraview
# With another VTK than ParaView's, hence before that is found.
build "$top/build" all
use_paraview
build_paraview
exec ctest --test-dir "$paraview_folder" --output-on-failure --parallel "$(nproc)" "$@"
