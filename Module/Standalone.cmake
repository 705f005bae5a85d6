# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The project on its own: settings, modules, Python, package, examples, tests.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo" FORCE)
endif ()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
if (NOT DEFINED CMAKE_INSTALL_RPATH)
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif ()

option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(BUILD_TESTING "Build the tests" ON)
option(PointSplatting_WRAP_PYTHON "Build the Python package pointsplatting" ON)
set(PointSplatting_PYTHON_SITE "lib/python3/dist-packages" CACHE STRING
  "Where the Python package is put, in the build and install trees")
option(PointSplatting_BUILD_EXAMPLES "Build splatview and the examples" ON)
option(PointSplatting_SANITIZE "Build with the address and undefined behaviour sanitizers" OFF)
if (PointSplatting_SANITIZE)
  add_compile_options(
    -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=address,undefined)
endif ()

option(PointSplatting_PARAVIEW
  "Build the ParaView plugin and nothing else: against ParaView's own VTK, not another" OFF)
if (PointSplatting_PARAVIEW)
  include(Module/ParaView/Plugin.cmake)
  return ()
endif ()

if (PointSplatting_WRAP_PYTHON)
  # Debian's vtkmodules belong to the system's interpreter; another one that is
  # first on the PATH could not load them.
  if (NOT DEFINED Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
    set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The interpreter that has vtkmodules")
  endif ()
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif ()

# By name, since all of a packaged VTK's components want Qt and much else.
set(_components
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore FiltersGeneral FiltersGeometry FiltersSources
  IOGeometry IOImage IOLegacy IOPLY IOXML ImagingCore InteractionStyle
  RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI
  RenderingVolumeOpenGL2)
if (PointSplatting_WRAP_PYTHON)
  list(APPEND _components WrappingPythonCore)
endif ()
if (BUILD_TESTING)
  list(APPEND _components TestingCore TestingRendering)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${_components} OPTIONAL_COMPONENTS glad hdf5 IOCore)

set(_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/PointSplatting")
set(_module_files
  "${CMAKE_SOURCE_DIR}/Filters/vtk.module"
  "${CMAKE_SOURCE_DIR}/Rendering/vtk.module")
if (TARGET VTK::hdf5 AND TARGET VTK::IOCore AND NOT SKBUILD)
  # Without HDF5 there is no reader and writer of octrees. Wheels of VTK have one of their own, whose
  # headers they do not have.
  list(APPEND _module_files "${CMAKE_SOURCE_DIR}/IO/vtk.module")
endif ()
vtk_module_scan(
  MODULE_FILES         ${_module_files}
  PROVIDES_MODULES     _modules
  WANT_BY_DEFAULT      ON
  # The tests are added below: they are the project's, and not one module's.
  ENABLE_TESTS         OFF)
set(_versions VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
if (SKBUILD)
  # A wheel holds no links, and would hold each library three times.
  set(_versions)
endif ()
vtk_module_build(
  MODULES              ${_modules}
  PACKAGE              PointSplatting
  ${_versions}
  INSTALL_EXPORT       PointSplatting
  INSTALL_HEADERS      ON
  HEADERS_DESTINATION  "${CMAKE_INSTALL_INCLUDEDIR}/pointsplatting"
  CMAKE_DESTINATION    "${_cmake_destination}")
set(_warnings)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(_warnings -Wall -Wextra)
endif ()
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  # False alarms about the vector<bool> inside vtkSMPThreadLocal.
  list(APPEND _warnings -Wno-array-bounds -Wno-stringop-overflow)
endif ()
foreach (_module IN LISTS _modules)
  vtk_module_compile_options(${_module} PRIVATE ${_warnings})
endforeach ()

# A module at the root cannot be built by a project at the same root, so the
# umbrella is a plain target here.
add_library(PointSplatting INTERFACE)
target_link_libraries(PointSplatting INTERFACE ${_modules})
add_library(VTK::PointSplatting ALIAS PointSplatting)

if (PointSplatting_WRAP_PYTHON)
  include(Module/Python.cmake)
endif ()
include(Module/Package.cmake)

# Not before: what the wrapping generates is not ours.
add_compile_options(${_warnings})
if (PointSplatting_BUILD_EXAMPLES)
  add_subdirectory(Examples)
endif ()
# What a user of this tree runs, without the tests.
add_custom_target(programs)
foreach (_target IN ITEMS splatview vtkFiltersPointSplattingPython vtkIOPointSplattingPython
    vtkRenderingPointSplattingPython)
  if (TARGET ${_target})
    add_dependencies(programs ${_target})
  endif ()
endforeach ()
if (BUILD_TESTING)
  enable_testing()
  add_subdirectory(Testing)
endif ()
