# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The package pointsplatting: the two wrapped modules beside an __init__.py that
# has every class at its top level, and the package's own Python files. Same place in
# the build and install trees.
set(_package "pointsplatting")
set(_site "${PointSplatting_PYTHON_SITE}")
set(_soabi)
if (SKBUILD)
  # Wheels say which interpreter a module is for, as VTK's do.
  set(_soabi SOABI "${Python3_SOABI}")
endif ()
vtk_module_wrap_python(
  MODULES             ${_modules}
  INSTALL_HEADERS     OFF
  PYTHON_PACKAGE      "${_package}"
  MODULE_DESTINATION  "${_site}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${_cmake_destination}"
  BUILD_STATIC        OFF
  ${_soabi}
  TARGET              PointSplatting::Python)
# What just hands arguments over compiles in two thirds of the time so.
foreach (_module IN LISTS _modules)
  string(REPLACE "VTK::" "vtk" _wrapping "${_module}Python")
  target_compile_options(${_wrapping} PRIVATE "$<$<CONFIG:Release>:-O1>")
  pointsplatting_unite(${_wrapping} 12)
endforeach ()
set(_package_folder "${CMAKE_BINARY_DIR}/${_site}/${_package}")
configure_file(Module/__init__.py.in "${_package_folder}/__init__.py" @ONLY)
file(GLOB _python_files CONFIGURE_DEPENDS
  RELATIVE "${CMAKE_SOURCE_DIR}/Module/Python" "${CMAKE_SOURCE_DIR}/Module/Python/*.py")
foreach (_file IN LISTS _python_files)
  configure_file("Module/Python/${_file}" "${_package_folder}/${_file}" COPYONLY)
endforeach ()
install(
  DIRECTORY   "${_package_folder}/"
  DESTINATION "${_site}/${_package}"
  COMPONENT   python
  FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)

# Type hints, by VTK's own generator where this VTK has it.
execute_process(
  COMMAND "${Python3_EXECUTABLE}" -c "import vtkmodules.generate_pyi"
  RESULT_VARIABLE _no_hints OUTPUT_QUIET ERROR_QUIET)
if (NOT _no_hints AND NOT PointSplatting_SANITIZE)
  set(_hints)
  foreach (_module IN LISTS _modules)
    get_property(_library GLOBAL PROPERTY "_vtk_module_${_module}_library_name")
    list(APPEND _hints "${_library}")
  endforeach ()
  list(TRANSFORM _hints PREPEND "${_package_folder}/" OUTPUT_VARIABLE _hint_files)
  list(TRANSFORM _hint_files APPEND ".pyi")
  list(TRANSFORM _hints APPEND "Python" OUTPUT_VARIABLE _hint_targets)
  set(_path "${CMAKE_BINARY_DIR}/${_site}")
  if (DEFINED ENV{PYTHONPATH})
    # By which pip has VTK found while it builds.
    string(APPEND _path ":$ENV{PYTHONPATH}")
  endif ()
  add_custom_command(
    OUTPUT  ${_hint_files}
    COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${_path}"
      "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi
      -p "${_package}" -o "${_package_folder}" ${_hints}
    DEPENDS ${_hint_targets}
    COMMENT "Type hints of ${_package}"
    VERBATIM)
  add_custom_target(PointSplattingHints ALL DEPENDS ${_hint_files})
endif ()
