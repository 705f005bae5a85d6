#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash prepare.sh SUITE MIRROR FOLDER: one of Debian's suites unpacked into a folder, with its VTK
# and all that building and testing need. Takes root. What is complete is left as it is.
set -eu
suite=$1 mirror=$2 root=$3
[ ! -e "$root/.prepared" ] || exit 0

packages=(
  cmake ninja-build g++
  libvtk9-dev python3-vtk9
  libglm-dev libegl-dev libegl1 libgl1-mesa-dri
  python3-numpy xvfb xauth xdotool
)
mkdir -p "$root"
rm -rf "${root:?}"/*
# A suite that is newer than debootstrap is unpacked as the newest of all is.
scripts=/usr/share/debootstrap/scripts
script=$scripts/$suite
[ -e "$script" ] || script=$scripts/sid
debootstrap --variant=minbase "$suite" "$root" "$mirror" "$script"
echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/99valid"
# Nobody looks at documentation there, and writing all through takes half of the time.
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
printf 'path-exclude=/usr/share/%s/*\n' doc man locale >"$root/etc/dpkg/dpkg.cfg.d/exclude"
bash "$(dirname "$0")/inside.sh" "$root" env DEBIAN_FRONTEND=noninteractive sh -ec "
  apt-get update -q
  apt-get install -q -y --no-install-recommends ${packages[*]}
  # The reference renderer takes whichever of the two the suite has.
  apt-get install -q -y --no-install-recommends libembree4-4 ||
    apt-get install -q -y --no-install-recommends libembree3-3
  apt-get clean"
touch "$root/.prepared"
