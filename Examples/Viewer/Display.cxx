// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#if defined(__unix__) && !defined(__APPLE__)
#include <cstdlib>
#include <dlfcn.h>

bool HasDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
  // By name, since a VTK that draws by X11 loads its library itself, or only when it opens a window.
  static void* library = []
  {
    void* found = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
    return found ? found : dlopen("libX11.so", RTLD_LAZY | RTLD_LOCAL);
  }();
  if (!library)
  {
    return false; // nobody can open a window then
  }
  auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  auto close = reinterpret_cast<int (*)(void*)>(dlsym(library, "XCloseDisplay"));
  if (!open || !close)
  {
    return false;
  }
  void* display = open(nullptr);
  if (display)
  {
    close(display);
  }
  return display != nullptr;
}
#else
bool HasDisplay()
{
  return true;
}
#endif
