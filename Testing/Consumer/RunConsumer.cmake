# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
include("${TOOLS}/Run.cmake")

file(REMOVE_RECURSE "${WORK}/install" "${WORK}/build")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/install")
run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${EXAMPLES}/Cxx" -B "${WORK}/build"
  "-DVTK_DIR=${VTK_DIR}" "-DCMAKE_PREFIX_PATH=${WORK}/install")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run_for_picture("${WORK}/consumer.png" "${WORK}/build/SplatSphere")

if (PYTHON)
  set(ENV{PYTHONPATH} "${WORK}/install/lib/python3/dist-packages")
  run_for_picture("${WORK}/consumer_python.png" "${PYTHON}" "${EXAMPLES}/Python/splat_sphere.py")
endif ()
