#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Module/Versions/test.sh VERSION [--slice | --paraview] [ctest arguments]: builds and tests with a VTK that
# is not this system's, such as 9.3 or 9.6, in one of Debian's suites that has it, which is
# unpacked into build-vtk-VERSION (root, or sudo, is needed for that). Warnings are errors there.
# --slice runs those tests alone that differ with the version of VTK: pictures, picking,
# transparency, Python; --paraview those of the plugin, with that suite's ParaView.
set -eu
version=$1
shift
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/Module/setup.sh"
# The exact tests that tell most of a version in the least time.
slice='Test(SplatsPicture|SplatsPicking|SplatsTransparency|SplatsSorted|SplatsImageSpace'
slice+='|Package|Versions|LikeAnyMapper|SplatviewPicture)$'
targets=(all)
options=()
arguments=()
paraview=
if [ "${1:-}" = --paraview ]; then
  shift
  paraview=yes
elif [ "${1:-}" = --slice ]; then
  shift
  targets=(vtkRenderingPointSplattingCxxTests programs CheckPicture)
  options=("-DPointSplatting_CXX_TESTS=${slice%$}")
  arguments=(--tests-regex "$slice")
fi

packages=(debootstrap util-linux python3)
install_packages
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)

folder=$top/build-vtk-$version
root=$folder/root
mkdir -p "$folder"
found=$(python3 "$top/Module/Versions/suites.py" "$folder/lists" "$version")
suite=${found% *} mirror=${found#* }
echo "VTK $version is that of Debian $suite"
"${as_root[@]}" bash "$top/Module/Versions/prepare.sh" "$suite" "$mirror" "$root"

"${as_root[@]}" mkdir -p "$root/source"
tar --directory "$top" --exclude=./.git --exclude='./build*' --exclude='./install*' --create . |
  "${as_root[@]}" tar --directory "$root/source" --extract
environment=(LC_ALL=C.UTF-8)
inside() {
  "${as_root[@]}" bash "$top/Module/Versions/inside.sh" "$root" env "${environment[@]}" "$@"
}
mesa=$(inside dpkg-query -W -f '${Version}' libgl1-mesa-dri)
# From Mesa 26 on the cache of shaders, which is one file for all processes, ends programs by a bus error
# now and then; one of many files, as before, does not, and without any the tests take hours.
[ "${mesa%%.*}" -lt 26 ] || environment+=(MESA_DISK_CACHE_MULTI_FILE=true)
if [ -n "$paraview" ]; then
  inside bash /source/Module/ParaView/test.sh "$@"
  exit
fi
# Optimized as far as warnings need it: what takes time in the tests is OpenGL's.
inside cmake -G Ninja -S /source -B /build -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-Werror \
  '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG' "${options[@]}"
inside cmake --build /build --target "${targets[@]}" --parallel "$(nproc)"
inside ctest --test-dir /build --output-on-failure --parallel "$(nproc)" "${arguments[@]}" "$@"
