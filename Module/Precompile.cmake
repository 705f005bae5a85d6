# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Headers that most sources read, compiled once for each target: half of the time of a build without them is
# spent on reading VTK's and the standard library's. A source names what it uses all the same; builds
# without them (-DPointSplatting_PRECOMPILE=OFF) fail where one does not.
option(PointSplatting_PRECOMPILE "Compile headers of VTK and of the standard library once for each target" ON)

set(pointsplatting_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <string> <utility> <vector>
  <vtkDataArrayRange.h> <vtkFloatArray.h> <vtkMath.h> <vtkNew.h> <vtkPointData.h> <vtkPoints.h>
  <vtkPolyData.h> <vtkSMPThreadLocal.h> <vtkSMPTools.h> <vtkSmartPointer.h> <vtkUnsignedCharArray.h>)
set(pointsplatting_rendering_headers
  <vtkActor.h> <vtkCamera.h> <vtkOpenGLRenderWindow.h> <vtkOpenGLState.h> <vtkProperty.h> <vtkRenderer.h>)

# Adds them to a target, which may be a module's name; with RENDERING those of rendering, too.
function (pointsplatting_precompile target)
  if (NOT PointSplatting_PRECOMPILE)
    return ()
  endif ()
  get_target_property(_aliased ${target} ALIASED_TARGET)
  if (_aliased)
    set(target ${_aliased})
  endif ()
  set(_headers ${pointsplatting_headers})
  if ("RENDERING" IN_LIST ARGN)
    list(APPEND _headers ${pointsplatting_rendering_headers})
  endif ()
  target_precompile_headers(${target} PRIVATE ${_headers})
endfunction ()
