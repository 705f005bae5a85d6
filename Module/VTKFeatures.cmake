# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What this VTK has, asked of its headers and not of its version number.

# pointsplatting_find_header(<out> <target> <header>): the header's path among a
# module's include directories, or empty. The directories of a module that is
# being built stand inside generator expressions.
function (pointsplatting_find_header out target header)
  set(${out} "" PARENT_SCOPE)
  get_target_property(_dirs ${target} INTERFACE_INCLUDE_DIRECTORIES)
  foreach (_dir IN LISTS _dirs)
    string(REGEX REPLACE "^\\$<BUILD_INTERFACE:(.*)>$" "\\1" _dir "${_dir}")
    if (EXISTS "${_dir}/${header}")
      set(${out} "${_dir}/${header}" PARENT_SCOPE)
      return ()
    endif ()
  endforeach ()
endfunction ()

# pointsplatting_file_has(<out> <file> <regex>): 1 where there is such a file and a line of it
# matches, otherwise 0.
function (pointsplatting_file_has out file regex)
  set(${out} 0 PARENT_SCOPE)
  if (EXISTS "${file}")
    file(STRINGS "${file}" _lines REGEX "${regex}" LIMIT_COUNT 1)
    if (_lines)
      set(${out} 1 PARENT_SCOPE)
    endif ()
  endif ()
endfunction ()

# pointsplatting_header_has(<out> <target> <header> <regex>): 1 where a line of
# the header matches, otherwise 0.
function (pointsplatting_header_has out target header regex)
  pointsplatting_find_header(_file ${target} ${header})
  pointsplatting_file_has(_has "${_file}" "${regex}")
  set(${out} ${_has} PARENT_SCOPE)
endfunction ()

# pointsplatting_shaders_have(<out> <target> <source> <regex>): 1 where a line of the shaders in a
# module's library matches, or, of a module that is being built, in that source file; otherwise 0.
function (pointsplatting_shaders_have out target source regex)
  get_target_property(_imported ${target} IMPORTED)
  if (_imported)
    get_target_property(_configurations ${target} IMPORTED_CONFIGURATIONS)
    get_target_property(_file ${target} IMPORTED_LOCATION)
    foreach (_configuration IN LISTS _configurations)
      get_target_property(_location ${target} "IMPORTED_LOCATION_${_configuration}")
      if (_location)
        set(_file "${_location}")
      endif ()
    endforeach ()
  else ()
    get_target_property(_file ${target} SOURCE_DIR)
    set(_file "${_file}/${source}")
  endif ()
  pointsplatting_file_has(_has "${_file}" "${regex}")
  set(${out} ${_has} PARENT_SCOPE)
endfunction ()
