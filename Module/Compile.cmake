# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# How builds save time, most of which reading VTK's and the standard library's headers would take: headers
# that most sources read are compiled once for each target, and a module's sources some at a time. A source
# names the headers that it uses all the same, and what is in unnamed namespaces has a name of its own in the
# whole module; builds without either (-DPointSplatting_PRECOMPILE=OFF -DPointSplatting_UNITY=OFF) fail
# where the first is not so.
option(PointSplatting_PRECOMPILE "Compile headers of VTK and of the standard library once for each target" ON)
option(PointSplatting_UNITY "Compile several sources of a module at a time" ON)

set(pointsplatting_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <string> <utility> <vector>
  <vtkDataArrayRange.h> <vtkFloatArray.h> <vtkMath.h> <vtkNew.h> <vtkPointData.h> <vtkPoints.h>
  <vtkPolyData.h> <vtkSMPThreadLocal.h> <vtkSMPTools.h> <vtkSmartPointer.h> <vtkUnsignedCharArray.h>)
set(pointsplatting_rendering_headers
  <vtkActor.h> <vtkCamera.h> <vtkOpenGLRenderWindow.h> <vtkOpenGLState.h> <vtkProperty.h> <vtkRenderer.h>)

# Sets in a variable the target of a name, which may be a module's.
function (pointsplatting_get_target name variable)
  get_target_property(_aliased ${name} ALIASED_TARGET)
  if (NOT _aliased)
    set(_aliased ${name})
  endif ()
  set(${variable} ${_aliased} PARENT_SCOPE)
endfunction ()

# Headers compiled once; with RENDERING those of rendering, too.
function (pointsplatting_precompile name)
  if (NOT PointSplatting_PRECOMPILE)
    return ()
  endif ()
  pointsplatting_get_target(${name} _target)
  set(_headers ${pointsplatting_headers})
  if ("RENDERING" IN_LIST ARGN)
    list(APPEND _headers ${pointsplatting_rendering_headers})
  endif ()
  target_precompile_headers(${_target} PRIVATE ${_headers})
endfunction ()

# Sources compiled so many at a time.
function (pointsplatting_unite name size)
  if (NOT PointSplatting_UNITY)
    return ()
  endif ()
  pointsplatting_get_target(${name} _target)
  set_target_properties(${_target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A source is an included file then, whose classes must not have members of an unnamed namespace's types.
    target_compile_options(${_target} PRIVATE -Wno-subobject-linkage)
  endif ()
endfunction ()
