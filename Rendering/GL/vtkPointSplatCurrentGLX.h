// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The GLX context that is current in this thread, of whatever window of an X server: an EGL context
// cannot become current beside it. GLX is asked for at run time, so that nothing is linked with it;
// where the program has not loaded it there is no such context.
#ifndef vtkPointSplatCurrentGLX_h
#define vtkPointSplatCurrentGLX_h

class vtkPointSplatCurrentGLX
{
public:
  /// None.
  vtkPointSplatCurrentGLX() = default;

  static vtkPointSplatCurrentGLX Get();

  /// Leaves the thread without one.
  static void Release();

  /// Whether a window of this program may want one: GLX is loaded and a server named.
  static bool MayCome();

  explicit operator bool() const { return this->Context != nullptr; }

  /// Nothing where it is none.
  void MakeCurrent() const;

private:
  void* Display = nullptr;
  unsigned long Drawable = 0;
  unsigned long Readable = 0;
  void* Context = nullptr;
};

#endif
