# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# For run.sh and test.sh, which source it: Debian's packages, then the build.

packages=(
  cmake ninja-build g++                 # to build
  libvtk9-dev python3-vtk9              # VTK and its Python modules
  libglm-dev libegl-dev libegl1         # matrices, contexts without an X server
  libgl1-mesa-dri                       # OpenGL where there is no GPU
)
test_packages=(
  python3-numpy                         # the accuracy tests' reference, and splatbench
  'libembree3-3|libembree4-4|'           # the same for triangle meshes; without it they are skipped
  xvfb xdotool                          # windows on a display of the tests' own, and a user's hands
)

# Whether one of a|b|c is installed, or is a package of this Debian at all.
installed() {
  dpkg-query -W -f='${db:Status-Status}\n' ${1//|/ } 2>/dev/null | grep -qx installed
}
known() {
  local one
  for one in ${1//|/ }; do
    if apt-cache show "$one" >/dev/null 2>&1; then
      echo "$one"
      return
    fi
  done
}

# Installs what is missing from Debian, saying what; names it where it cannot. Of a|b the first that
# this Debian has is installed; of a|b| none is needed.
install_packages() {
  command -v dpkg-query >/dev/null || return 0 # not Debian: CMake says what it misses
  local missing=() package
  for package in "${packages[@]}"; do
    installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Neither root nor sudo here. Have these installed, then start again: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing Debian's packages ${missing[*]}"
  local chosen=() one
  "${as_root[@]}" apt-get update -q || true # what follows tells whether it was needed
  for package in "${missing[@]}"; do
    one=$(known "$package")
    # An unknown one is left to apt, which says so, unless none is needed.
    [ -z "$one" ] && [ "${package%|}" != "$package" ] || chosen+=("${one:-$package}")
  done
  if [ ${#chosen[@]} -gt 0 ] && ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y -o DPkg::Lock::Timeout=600 --no-install-recommends "${chosen[@]}"; then
    echo "Could not install them. Have these installed, then start again: ${missing[*]}" >&2
    return 1
  fi
}

# build FOLDER TARGET [CMake options]: configures the first time only, since a
# configured folder looks after itself, and builds what is not up to date.
build() {
  local folder=$1 target=$2
  shift 2
  if [ ! -f "$folder/build.ninja" ]; then
    cmake -G Ninja -S "$top" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@"
  fi
  cmake --build "$folder" --target "$target" --parallel "$(nproc)"
}
