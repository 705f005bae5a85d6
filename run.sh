#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash run.sh [FILES and options]: sets up, builds, and runs splatview with what
# it was given. With nothing given, splatview makes a volume of its own and
# writes a picture; bash run.sh --help tells the rest.
#
# bash run.sh --paraview: ParaView's window with the plugin and that volume.
# bash run.sh --paraview [--ranks N] [--with PROGRAM] SCRIPT.py [arguments]: the script by pvbatch,
# or by another program, on N ranks, with the plugin.
set -eu
top=$(cd "$(dirname "$0")" && pwd)
. "$top/Module/setup.sh"

if [ "${1:-}" = --paraview ]; then
  shift
  . "$top/Module/ParaView/setup.sh"
  { install_paraview; use_paraview; build_paraview; } >&2
  run_paraview "$@"
  exit
fi

# Out of the way of what splatview says itself.
{ install_packages; build "$top/build" programs; } >&2
exec "$top/build/bin/splatview" "$@"
