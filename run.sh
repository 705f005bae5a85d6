#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash run.sh [FILES and options]: sets up, builds, and runs splatview with what
# it was given. With nothing given, splatview makes a volume of its own and
# writes a picture; bash run.sh --help tells the rest.
set -eu
top=$(cd "$(dirname "$0")" && pwd)
. "$top/Module/setup.sh"

# Out of the way of what splatview says itself.
{ install_packages && build "$top/build" programs; } >&2
exec "$top/build/bin/splatview" "$@"
