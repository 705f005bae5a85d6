# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DTOP=<source tree> -P CheckIncludes.cmake: what each folder may know of the others.
#
# 1. All files of Filters/, IO/, Rendering/ and its folders are found; a header or a shader belongs to
#    the folder that it lies in. "Rendering" is Rendering/'s root.
# 2. Each #include of a file of this project must name one that is there, in the same folder or in
#    one of those that the rules below allow. So must each shader that C++ names, since shaders
#    lie beside the class that runs them, or below.
# 3. VTK's headers are open to all, but OpenGL's not to Filters/ and Choice/.
# 4. No two files have one name: classes of one name in two libraries become one when these are loaded.
cmake_minimum_required(VERSION 3.16)

# What each folder may use: folders, or single files.
set(Filters)
set(IO Filters)
set(Choice)
set(GL)
set(Cloud GL Filters)
set(Project GL Cloud)
set(Select GL Cloud Project)
set(Reconstruct GL Cloud Project)
# Of reconstruction what all ways to reconstruct read and write.
set(Shade GL Cloud Project
  vtkPointSplatRequest.h vtkPointSplatLayers.h vtkPointSplatLayers.glsl vtkPointSplatTexel.glsl
  vtkPointSplatLook.glsl vtkPointSplatOutlines.h)
set(Shadow GL Cloud Project Reconstruct)
set(Frame GL Cloud Project Select Reconstruct Shade Shadow Choice)
set(Rendering ${Frame} Frame Filters)
set(without_opengl Filters IO Choice)
# Public headers are installed, and the private ones are not: of Rendering/'s root those that a class
# has for its own files.
set(public_headers)
set(internals "Internals\\.h$")
# Names that are made when the project is configured, or that all may use.
set(everywhere
  "^vtkPointSplat(SetMacros|Threads|tingABI|tingConfigure|tingFeatures)\\.h$")
set(opengl "^(vtk_gl|vtkgl|vtk_glew|vtk_glad|vtkOpenGL.*|GL/.*|GLES.*|EGL/.*|glm/.*)")

set(folders GL Cloud Project Select Reconstruct Shade Shadow Choice Frame)
set(files)
set(doubles)
macro (lies_in name folder)
  if (DEFINED "in_${name}")
    list(APPEND doubles "${name}: in ${in_${name}} and in ${folder}")
  endif ()
  set("in_${name}" "${folder}")
endmacro ()
foreach (_folder IN LISTS folders)
  file(GLOB _found "${TOP}/Rendering/${_folder}/*.*")
  foreach (_file IN LISTS _found)
    get_filename_component(_name "${_file}" NAME)
    lies_in("${_name}" "${_folder}")
    list(APPEND files "${_folder}|${_file}")
  endforeach ()
endforeach ()
foreach (_folder IN ITEMS Filters IO Rendering)
  file(GLOB _found "${TOP}/${_folder}/*.h" "${TOP}/${_folder}/*.cxx")
  foreach (_file IN LISTS _found)
    get_filename_component(_name "${_file}" NAME)
    lies_in("${_name}" "${_folder}")
    if (_name MATCHES "\\.h$" AND NOT _name MATCHES "${internals}" AND _folder STREQUAL "Rendering")
      set(_folder_of_file public_headers)
    else ()
      set(_folder_of_file "${_folder}")
    endif ()
    list(APPEND files "${_folder_of_file}|${_file}")
  endforeach ()
endforeach ()
# What lies in another folder than these would not be looked at.
file(GLOB _others LIST_DIRECTORIES true RELATIVE "${TOP}/Rendering" "${TOP}/Rendering/*")
set(count 0)
set(faults ${doubles})
foreach (_other IN LISTS _others)
  if (IS_DIRECTORY "${TOP}/Rendering/${_other}" AND NOT _other IN_LIST folders)
    list(APPEND faults "Rendering/${_other}: CheckIncludes.cmake has no rule for this folder")
  endif ()
endforeach ()

# check(<folder> <file> <name> <line>): whether the file may use the one of that name.
function (check folder file name line)
  file(RELATIVE_PATH _short "${TOP}" "${file}")
  set(_fault)
  if (name MATCHES "${everywhere}")
    return ()
  elseif (DEFINED "in_${name}")
    set(_to "${in_${name}}")
    if (NOT (_to STREQUAL folder OR _to IN_LIST ${folder} OR name IN_LIST ${folder} OR
        (folder STREQUAL "public_headers" AND _to STREQUAL "Rendering" AND
          NOT name MATCHES "${internals}")))
      set(_fault "${folder} may not use ${_to}")
    endif ()
  elseif (folder IN_LIST without_opengl AND name MATCHES "${opengl}")
    set(_fault "${folder} may not use OpenGL")
  elseif (name MATCHES "^vtk(PointSplat|PointShadow|Isosurface)" AND NOT name MATCHES "Module\\.h$")
    set(_fault "there is no such file")
  endif ()
  if (_fault)
    list(APPEND faults "${_short}: ${line}: ${_fault}")
    set(faults "${faults}" PARENT_SCOPE)
  endif ()
endfunction ()

foreach (_entry IN LISTS files)
  string(REPLACE "|" ";" _entry "${_entry}")
  list(GET _entry 0 _folder)
  list(GET _entry 1 _file)
  file(STRINGS "${_file}" _lines REGEX "^[ \t]*#[ \t]*include|\"vtkPointSplat[A-Za-z]*\"")
  foreach (_line IN LISTS _lines)
    string(STRIP "${_line}" _line)
    if (_line MATCHES "^#[ \t]*include[ \t]*[<\"]([^>\"]+)[>\"]")
      set(_name "${CMAKE_MATCH_1}")
      # Shaders include each other without an extension.
      if (_file MATCHES "\\.glsl$")
        string(APPEND _name ".glsl")
      endif ()
      math(EXPR count "${count} + 1")
      check("${_folder}" "${_file}" "${_name}" "${_line}")
    elseif (_line MATCHES "\"(vtkPointSplat[A-Za-z]*(CS|VS|FS))\"")
      check("${_folder}" "${_file}" "${CMAKE_MATCH_1}.glsl" "${_line}")
    endif ()
  endforeach ()
endforeach ()

if (faults OR count LESS 100)
  list(JOIN faults "\n  " _text)
  message(FATAL_ERROR "Of ${count} includes these break the rules:\n  ${_text}")
endif ()
message(STATUS "${count} includes keep to the rules.")
