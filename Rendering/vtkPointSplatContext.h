// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The OpenGL context that resources belong to, for those who own them and may outlive it, or
// go without ReleaseGraphicsResources(), as mappers do that their actors exchange for others.
#ifndef vtkPointSplatContext_h
#define vtkPointSplatContext_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

class vtkPointSplatContext
{
public:
  /// The window's context, which is current.
  void Set(vtkOpenGLRenderWindow* window)
  {
    this->Window = window;
    this->Time = window ? window->GetContextCreationTime() : 0;
  }
  /// Whether it is the window's context still: closed windows get another one when they open again.
  bool IsOf(vtkOpenGLRenderWindow* window) const
  {
    return window && this->Window == window && this->Time == window->GetContextCreationTime();
  }
  /// Calls the function if that context is there still and current. It is not made so: who lets
  /// resources go may be amid a frame of another window.
  template <typename Function>
  void Use(const Function& function) const
  {
    if (this->IsOf(this->Window) && this->Window->IsCurrent())
    {
      function();
    }
  }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType Time = 0;
};

#endif
