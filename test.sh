#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash test.sh [--sanitize | --vtk VERSION [--slice | --paraview] | --everything] [ctest arguments]:
# sets up, builds, runs every test. --sanitize does so with the address and undefined behaviour
# sanitizers, in a folder of its own; --vtk with another VTK, in a suite of Debian that has it, or the
# plugin's with that suite's ParaView; --everything, which CI runs, with this system's VTK, as a
# ParaView plugin, as a wheel with a newer VTK, and a slice of the tests with the VTK of the next
# stable Debian, warnings as errors.
set -eu
top=$(cd "$(dirname "$0")" && pwd)
. "$top/Module/setup.sh"

if [ "${1:-}" = --vtk ]; then
  shift
  exec bash "$top/Module/Versions/test.sh" "$@"
fi
if [ "${1:-}" = --everything ]; then
  shift
  # This system's VTK comes last, so that what is read last is the count of its tests.
  failed=
  bash "$top/Module/ParaView/test.sh" || failed="$failed ParaView"
  # At once, since both wait for downloads, packages and a browser two fifths of the time.
  mkdir -p "$top/build"
  bash "$top/test.sh" --vtk 9.3 --slice >"$top/build/slice.log" 2>&1 &
  slice=$!
  bash "$top/Module/Wheel/test.sh" || failed="$failed wheel"
  wait "$slice" || failed="$failed VTK-9.3"
  cat "$top/build/slice.log"
  [ -z "$failed" ] || echo "failed:$failed"
  bash "$top/test.sh" "$@"
  [ -z "$failed" ]
  exit
fi

folder=$top/build
options=()
if [ "${1:-}" = --sanitize ]; then
  shift
  folder=$top/build-sanitize
  # Nor is a header there unless a source names it.
  options=(-DPointSplatting_SANITIZE=ON -DPointSplatting_PRECOMPILE=OFF -DPointSplatting_UNITY=OFF)
  # Drivers and VTK keep what they allocate once until the process ends.
  export ASAN_OPTIONS=detect_leaks=0
  export UBSAN_OPTIONS=print_stacktrace=1
fi

packages+=("${test_packages[@]}")
install_packages
build "$folder" all "${options[@]}"
exec ctest --test-dir "$folder" --output-on-failure --parallel "$(nproc)" "$@"
