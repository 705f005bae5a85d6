// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCurrentGLX.h"

#include <cstdlib>

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

namespace
{
template <typename Function>
Function Find(const char* name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

/**
 * GLX's functions, with its types as they are in memory.
 */
struct GLX
{
  void* (*GetCurrentContext)() = Find<void* (*)()>("glXGetCurrentContext");
  void* (*GetCurrentDisplay)() = Find<void* (*)()>("glXGetCurrentDisplay");
  unsigned long (*GetCurrentDrawable)() = Find<unsigned long (*)()>("glXGetCurrentDrawable");
  unsigned long (*GetCurrentReadDrawable)() =
    Find<unsigned long (*)()>("glXGetCurrentReadDrawable");
  int (*MakeContextCurrent)(void*, unsigned long, unsigned long, void*) =
    Find<int (*)(void*, unsigned long, unsigned long, void*)>("glXMakeContextCurrent");

  bool IsLoaded() const
  {
    return this->GetCurrentContext && this->GetCurrentDisplay && this->GetCurrentDrawable &&
      this->GetCurrentReadDrawable && this->MakeContextCurrent;
  }

  static const GLX& Get()
  {
    static const GLX glx;
    return glx;
  }
};
}

//------------------------------------------------------------------------------
vtkPointSplatCurrentGLX vtkPointSplatCurrentGLX::Get()
{
  const GLX& glx = GLX::Get();
  vtkPointSplatCurrentGLX current;
  if (glx.IsLoaded() && glx.GetCurrentContext())
  {
    current.Context = glx.GetCurrentContext();
    current.Display = glx.GetCurrentDisplay();
    current.Drawable = glx.GetCurrentDrawable();
    current.Readable = glx.GetCurrentReadDrawable();
  }
  return current;
}

//------------------------------------------------------------------------------
void vtkPointSplatCurrentGLX::Release()
{
  const vtkPointSplatCurrentGLX current = vtkPointSplatCurrentGLX::Get();
  if (current)
  {
    GLX::Get().MakeContextCurrent(current.Display, 0, 0, nullptr);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatCurrentGLX::MayCome()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display && GLX::Get().IsLoaded();
}

//------------------------------------------------------------------------------
void vtkPointSplatCurrentGLX::MakeCurrent() const
{
  if (*this)
  {
    GLX::Get().MakeContextCurrent(this->Display, this->Drawable, this->Readable, this->Context);
  }
}

#else

vtkPointSplatCurrentGLX vtkPointSplatCurrentGLX::Get()
{
  return vtkPointSplatCurrentGLX();
}
void vtkPointSplatCurrentGLX::Release() {}
bool vtkPointSplatCurrentGLX::MayCome()
{
  return false;
}
void vtkPointSplatCurrentGLX::MakeCurrent() const {}

#endif
