#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash inside.sh ROOT COMMAND...: runs a command with ROOT as the root folder, with what programs
# expect of a system's kernel. What is mounted for it is gone with it.
set -eu
root=$1
shift
# What helps this system's compilers is not there.
unset CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER
exec unshare --mount bash -c '
  set -eu
  root=$1
  shift
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mkdir -p "$root/dev/shm"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  cp -L /etc/hosts "$root/etc/hosts"
  exec chroot "$root" "$@"' inside "$root" "$@"
