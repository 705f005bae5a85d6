# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The CMake package PointSplatting, in the build tree as in the install tree.
# It offers VTK::FiltersPointSplatting, VTK::RenderingPointSplatting, with HDF5
# VTK::IOPointSplatting and, for who wants all, VTK::PointSplatting.
include(CMakePackageConfigHelpers)

# Which components of VTK the exported targets refer to.
set(PointSplatting_VTK_COMPONENTS)
foreach (_module IN LISTS _modules)
  foreach (_kind IN ITEMS depends private_depends)
    get_property(_depends GLOBAL PROPERTY "_vtk_module_${_module}_${_kind}")
    list(APPEND PointSplatting_VTK_COMPONENTS ${_depends})
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES PointSplatting_VTK_COMPONENTS)
list(REMOVE_ITEM PointSplatting_VTK_COMPONENTS ${_modules})
list(TRANSFORM PointSplatting_VTK_COMPONENTS REPLACE "^VTK::" "")
string(REPLACE ";" " " PointSplatting_VTK_COMPONENTS "${PointSplatting_VTK_COMPONENTS}")

configure_package_config_file(Module/PointSplattingConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${_cmake_destination}/PointSplattingConfig.cmake"
  INSTALL_DESTINATION "${_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${_cmake_destination}/PointSplattingConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${_cmake_destination}/PointSplattingConfig.cmake"
    "${CMAKE_BINARY_DIR}/${_cmake_destination}/PointSplattingConfigVersion.cmake"
  DESTINATION "${_cmake_destination}")
