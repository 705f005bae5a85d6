# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# For run.sh and test.sh, which source it after Module/setup.sh: Debian's ParaView, the plugin's
# build, and how its programs are run.

# Besides what the module needs: one display for programs that want one, and many processes.
paraview_packages=(xvfb xauth openmpi-bin python3-numpy python3-mpi4py)
paraview_folder=${PARAVIEW_FOLDER:-$top/build-paraview}

# Debian's ParaView conflicts with the Python modules of its VTK, so that it is not installed but
# unpacked, with the libraries that are missing. One that is installed all the same is taken.
install_paraview() {
  packages+=("${paraview_packages[@]}")
  install_packages || return 1
  paraview_root=
  if command -v pvbatch >/dev/null && [ -n "$(ls -d /usr/lib/*/cmake/paraview-* 2>/dev/null)" ]; then
    return 0
  fi
  paraview_root=$paraview_folder/debian
  [ ! -f "$paraview_root/unpacked" ] || return 0
  local debs=$paraview_folder/debs missing
  rm -rf "$debs" "$paraview_root"
  mkdir -p "$debs" "$paraview_root"
  # apt-get only says what it would do. What it would upgrade has its old version in brackets.
  # Icons are drawn by Qt's plugin for SVG, which no package of these depends on.
  missing=$(apt-get install -s --no-install-recommends paraview paraview-dev python3-paraview \
    $(known "libqt5svg5|") |
    awk '$1 == "Inst" && $3 !~ /^\[/ && $2 ~ /^(lib|paraview|python3-paraview)/ { print $2 }')
  if [ -z "$missing" ]; then
    echo "Debian has no ParaView here: try apt-get update." >&2
    return 1
  fi
  echo "Unpacking Debian's packages" $missing
  (cd "$debs" && apt-get download -q $missing 2>&1 | grep -v unsandboxed) || return 1
  local deb
  for deb in "$debs"/*.deb; do
    dpkg -x "$deb" "$paraview_root" || return 1
  done
  rm -rf "$debs"
  # Debian forky's CMake files name Python's modules without their ABI, files have it in their names.
  local module
  find "$paraview_root" -name '*.cpython-*.so' | while read -r module; do
    ln -sf "$(basename "$module")" "${module%%.cpython-*}.so"
  done
  touch "$paraview_root/unpacked"
}

# Lets programs and CMake find what was unpacked.
use_paraview() {
  local lib
  [ -n "$paraview_root" ] || return 0
  lib=$(dirname "$(dirname "$(ls -d "$paraview_root"/usr/lib/*/cmake/paraview-*)")")
  lib=$(dirname "$lib")/$(basename "$lib")
  # Some of ParaView 6's libraries lie in a folder that another one knows by its whole path.
  export LD_LIBRARY_PATH=$lib:$lib/libproxy${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
  export PYTHONPATH=$paraview_root/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
  export PATH=$paraview_root/usr/bin:$PATH
  export QT_PLUGIN_PATH=$lib/qt5/plugins:$lib/qt6/plugins${QT_PLUGIN_PATH:+:$QT_PLUGIN_PATH}
}

build_paraview() {
  local options=(-DPointSplatting_PARAVIEW=ON)
  if [ -n "$paraview_root" ]; then
    options+=("-DParaView_DIR=$(ls -d "$paraview_root"/usr/lib/*/cmake/paraview-*)")
  fi
  build "$paraview_folder" all "${options[@]}" "$@"
  # ParaView's programs read what plugins to load from this file.
  local plugin
  plugin=$(find "$paraview_folder" -name PointSplatting.so | head -n 1)
  cat >"$paraview_folder/plugins.xml" <<END
<Plugins>
  <Plugin name="PointSplatting" filename="$plugin" auto_load="1"/>
</Plugins>
END
}

# on_display COMMAND...: on the display that is there, or on one of its own.
on_display() {
  export PV_PLUGIN_CONFIG_FILE=$paraview_folder/plugins.xml
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
  fi
}

# on_ranks N COMMAND...: as many processes.
on_ranks() {
  local ranks=$1 options=(--oversubscribe)
  shift
  if [ "$ranks" -eq 1 ]; then
    on_display "$@"
    return
  fi
  [ "$(id -u)" -ne 0 ] || options+=(--allow-run-as-root)
  on_display mpirun "${options[@]}" -np "$ranks" "$@"
}

# run_paraview [--ranks N] [--with PROGRAM] [SCRIPT [arguments]]: the script by pvbatch or that
# program; without a script the client.
run_paraview() {
  local ranks=1 program=pvbatch
  while [ $# -gt 0 ]; do
    case $1 in
    --ranks) ranks=$2 ;;
    --with) program=$2 ;;
    *) break ;;
    esac
    shift 2
  done
  if [ $# -gt 0 ]; then
    on_ranks "$ranks" "$program" "$@"
  elif [ -z "${DISPLAY:-}" ]; then
    echo "ParaView's window needs a display; name a script to run without one." >&2
    return 1
  else
    on_display paraview --script="$top/Examples/ParaView/hydrogen.py"
  fi
}
