# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
include("${TOOLS}/Run.cmake")

# Copied, since the scan follows no links and adds directories by their path
# below the project's own.
file(REMOVE_RECURSE "${WORK}/source")
file(COPY "${TREE}/Testing/Superbuild/Project/" DESTINATION "${WORK}/source")
file(COPY
  "${TREE}/CMakeLists.txt" "${TREE}/vtk.module" "${TREE}/Module"
  "${TREE}/Filters" "${TREE}/Rendering" "${TREE}/Testing" "${TREE}/Examples"
  DESTINATION "${WORK}/source/Remote/PointSplatting")

run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${WORK}/source" -B "${WORK}/build" "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${WORK}/build" --target UseUmbrella)
run_for_picture("${WORK}/superbuild.png" "${WORK}/build/UseUmbrella")
