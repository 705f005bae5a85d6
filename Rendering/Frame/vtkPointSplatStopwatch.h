// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether time is short: what frames may take, and what they take.
#ifndef vtkPointSplatStopwatch_h
#define vtkPointSplatStopwatch_h

#include <vector>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatStopwatch
{
public:
  /// Begins to measure, if it is wanted.
  explicit vtkPointSplatStopwatch(bool wanted);
  /// Seconds since then, until the device has finished; 0 where they were not wanted.
  double GetSeconds() const;

  /// Whether the user drags: the window wants frames faster than at rest.
  static bool IsInteracting(vtkRenderer* renderer);
  /// Seconds that VTK allots to these actors together; 0 at rest.
  static double AllocatedSeconds(
    vtkRenderer* renderer, const std::vector<vtkActor*>& actors);

private:
  bool Wanted;
  double Start = 0.0;
};

#endif
