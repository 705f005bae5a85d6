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
  /// Makes it current for the function, which is not called where there is no such context any more.
  template <typename Function>
  void Use(const Function& function) const
  {
    if (!this->IsOf(this->Window))
    {
      return;
    }
    this->Window->PushContext();
    if (this->Window->IsCurrent())
    {
      function();
    }
    this->Window->PopContext();
  }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType Time = 0;
};

#endif
