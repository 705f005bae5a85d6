// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatTimers.h"

#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWeakPointer.h"

namespace
{
/// An interactor without an event loop of its own has timers only if somebody gives it some.
bool HasTimers(vtkRenderWindowInteractor* interactor)
{
  static vtkWeakPointer<vtkRenderWindowInteractor> last;
  static bool has = false;
  if (last != interactor || !has)
  {
    const int timer = interactor->CreateRepeatingTimer(vtkPointSplatTimers::Period);
    has = timer > 0;
    last = interactor;
    if (has)
    {
      interactor->DestroyTimer(timer);
    }
  }
  return has;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatTimers::AreOf(vtkRenderWindow* window)
{
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  return interactor && interactor->GetInitialized() && window->GetShowWindow() &&
    HasTimers(interactor);
}
