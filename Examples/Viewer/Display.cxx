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
  // A VTK that draws by X11 has loaded its library; another one needs no server.
  auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  auto close = reinterpret_cast<int (*)(void*)>(dlsym(RTLD_DEFAULT, "XCloseDisplay"));
  if (!open || !close)
  {
    return true;
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
