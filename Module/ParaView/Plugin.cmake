# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The project as a ParaView plugin: both modules, the representation and the proxies.
# A ParaView that was built with Python names targets of the same interpreter.
if (NOT DEFINED Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The interpreter that ParaView uses")
endif ()
find_package(Python3 COMPONENTS Interpreter Development.Module)

# By name, since all of ParaView's components want Qt.
find_package(ParaView REQUIRED COMPONENTS
  ProcessXML RemotingViews WrapClientServer)
find_package(VTK REQUIRED COMPONENTS CommonMisc FiltersParallelMPI RenderingOpenGL2)

paraview_plugin_scan(
  PLUGIN_FILES        "${CMAKE_SOURCE_DIR}/Module/ParaView/paraview.plugin"
  PROVIDES_PLUGINS    _plugins
  ENABLE_BY_DEFAULT   ON)
paraview_plugin_build(
  RUNTIME_DESTINATION    "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION    "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY   "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS                ${_plugins})

if (BUILD_TESTING)
  enable_testing()
  add_subdirectory(Testing/ParaView)
endif ()
