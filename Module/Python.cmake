# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The package pointsplatting: the two wrapped modules beside an __init__.py that
# has every class at its top level. Same place in the build and install trees.
set(_package "pointsplatting")
set(_site "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")
set(_site "lib/python3/dist-packages")
set(VTK_PYTHON_VERSION 3)
vtk_module_wrap_python(
  MODULES           ${_modules}
  INSTALL_EXPORT    PointSplattingPython
  INSTALL_HEADERS   OFF
  PYTHON_PACKAGE    "${_package}"
  MODULE_DESTINATION "${_site}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/PointSplatting"
  BUILD_STATIC      OFF
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  TARGET            PointSplatting::Python)
configure_file("${CMAKE_SOURCE_DIR}/Module/__init__.py.in"
  "${CMAKE_BINARY_DIR}/${_site}/${_package}/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${_site}/${_package}/__init__.py"
  DESTINATION "${_site}/${_package}")
