# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The package pointsplatting: the two wrapped modules beside an __init__.py that
# has every class at its top level. Same place in the build and install trees.
set(_package "pointsplatting")
set(_site "lib/python3/dist-packages")
vtk_module_wrap_python(
  MODULES             ${_modules}
  INSTALL_HEADERS     OFF
  PYTHON_PACKAGE      "${_package}"
  MODULE_DESTINATION  "${_site}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${_cmake_destination}"
  BUILD_STATIC        OFF
  TARGET              PointSplatting::Python)
configure_file(Module/__init__.py.in "${CMAKE_BINARY_DIR}/${_site}/${_package}/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${_site}/${_package}/__init__.py"
  DESTINATION "${_site}/${_package}")
