// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What of an actor's looks splats do not show.
#ifndef vtkPointSplatIgnored_h
#define vtkPointSplatIgnored_h

#include <string>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
VTK_ABI_NAMESPACE_END

class vtkPointSplatIgnored
{
public:
  /// Their names, or nothing where all is shown. points: whether it is drawn by points of one pixel.
  static std::string Of(vtkActor* actor, bool points);
};

#endif
