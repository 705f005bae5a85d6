// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatStopwatch.h"

#include "vtkActor.h"
#include "vtkPointSplattingOpenGL.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <algorithm>

namespace
{
// Frames that may take longer than 100 s are at rest, where there is no interactor to ask:
// vtkRenderWindow wants 0.0001 a second of them, and ParaView 0.002.
constexpr double StillUpdateRate = 0.01;
}

//------------------------------------------------------------------------------
vtkPointSplatStopwatch::vtkPointSplatStopwatch(bool wanted)
  : Wanted(wanted)
{
  if (wanted)
  {
    glFinish();
    this->Start = vtkTimerLog::GetUniversalTime();
  }
}

//------------------------------------------------------------------------------
double vtkPointSplatStopwatch::GetSeconds() const
{
  if (!this->Wanted)
  {
    return 0.0;
  }
  glFinish();
  return vtkTimerLog::GetUniversalTime() - this->Start;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStopwatch::IsInteracting(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  const double still =
    std::max(interactor ? interactor->GetStillUpdateRate() : 0.0, StillUpdateRate);
  return window->GetDesiredUpdateRate() > still;
}

//------------------------------------------------------------------------------
double vtkPointSplatStopwatch::AllocatedSeconds(
  vtkRenderer* renderer, const std::vector<vtkActor*>& actors)
{
  if (!vtkPointSplatStopwatch::IsInteracting(renderer))
  {
    return 0.0;
  }
  // VTK shares the time that a frame may take out among the props; layers are made for all of
  // these together.
  double seconds = 0.0;
  for (vtkActor* actor : actors)
  {
    seconds += std::max(actor->GetAllocatedRenderTime(), 0.0);
  }
  return seconds > 0.0 ? seconds : 1.0 / renderer->GetRenderWindow()->GetDesiredUpdateRate();
}
