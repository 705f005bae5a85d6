// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What of an actor's looks splats do not show.
#ifndef vtkPointSplatIgnored_h
#define vtkPointSplatIgnored_h

#include <set>
#include <string>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkObject;
VTK_ABI_NAMESPACE_END
class vtkPointSplatCloud;
struct vtkPointSplatReport;

class vtkPointSplatIgnored
{
public:
  /**
   * Warns of it, after it was drawn, if that is none of what was warned of already. report: how it
   * was drawn.
   */
  static void Warn(vtkObject* mapper, vtkActor* actor, const vtkPointSplatCloud& cloud,
    const vtkPointSplatReport& report, std::set<std::string>& warned);
};

#endif
