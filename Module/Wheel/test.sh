#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Module/Wheel/test.sh: makes the wheel by pip and tests it in a clean environment, beside
# PyVista and the newest release of vtk that it may be used with, and then the oldest one. PYTHON is
# the interpreter (python3). Nothing of this tree's build is used.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/Module/setup.sh"
packages=(g++ python3-dev python3-venv binutils libegl1 libgl1-mesa-dri chromium)
install_packages

python=${PYTHON:-/usr/bin/python3}
tag=$("$python" -c 'import sys; print(sys.implementation.cache_tag)')
folder=$top/build/wheel/test-$tag
rm -rf "$folder"
mkdir -p "$folder"
unset LD_LIBRARY_PATH PYTHONPATH

"$python" -m venv "$folder/environment"
environment=$folder/environment/bin/python
pip() { "$environment" -m pip --quiet --disable-pip-version-check "$@"; }

CXXFLAGS="-Werror ${CXXFLAGS:-}" pip wheel "$top" --no-deps --wheel-dir "$folder"
POINTSPLATTING_WHEEL=$(echo "$folder"/pointsplatting-*.whl)
export POINTSPLATTING_WHEEL
pip install "$POINTSPLATTING_WHEEL[pyvista,las,e57,app]" 'pyvista[jupyter]' nbclient ipykernel \
  playwright sphinx myst-parser

# Away from the tree, so that nothing is found there by chance.
cd "$folder"
export PYVISTA_OFF_SCREEN=true
run() { echo "$*"; "$environment" "$@"; }
wheel=$top/Testing/Wheel
# What another patch release of vtk could break: what is linked, and what is drawn.
test_with_vtk() {
  pip check
  run "$wheel/TestWheel.py"
  run "$top/Testing/Python/TestPackage.py"
  run "$top/Testing/Python/TestVersions.py"
}
# Which wait for a browser most of the time.
(run "$wheel/TestApp.py" && run "$wheel/TestNotebook.py") &
browsers=$!
test_with_vtk
run "$wheel/TestPyVista.py"
run "$top/Testing/Python/TestLikeAnyMapper.py"
run "$wheel/TestReading.py"
run "$wheel/TestDocstrings.py"
run "$wheel/TestExamples.py"
run "$wheel/TestDocumentation.py"
wait "$browsers"
# The requirement's lower bound.
oldest=$("$environment" -c '
import importlib.metadata, re
print(re.search(r">=([0-9.]+)", importlib.metadata.requires("pointsplatting")[0])[1])')
pip install "vtk==$oldest"
test_with_vtk
