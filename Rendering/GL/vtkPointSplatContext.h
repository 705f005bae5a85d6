// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The OpenGL context that objects belong to. Mappers may outlive a context, and may be destroyed
// while another one is current. So who draws opens a vtkPointSplatContextScope; objects that are
// made within it remember the context, and objects that die elsewhere are deleted when their
// context is entered the next time.
#ifndef vtkPointSplatContext_h
#define vtkPointSplatContext_h

#include "vtkPointSplattingOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <cstddef>

class vtkPointSplatContext
{
public:
  /// No context.
  vtkPointSplatContext() = default;
  /// The window's context.
  explicit vtkPointSplatContext(vtkOpenGLRenderWindow* window);

  /// Of the innermost scope that is open; none outside of all.
  static const vtkPointSplatContext& Entered();

  /// Whether what is current draws on the processor, so that buffers are in main memory.
  static bool IsSoftware();
  /// Bytes that the card of what is current has free, where its driver tells; 0 where it does not, or there is none.
  static size_t GetFreeMemory();

  /// Whether it is there still: closed windows get another one when they open again.
  bool IsAlive() const;
  bool IsCurrent() const { return this->IsAlive() && this->Window->IsCurrent(); }
  bool operator==(const vtkPointSplatContext& other) const
  {
    return this->Window == other.Window && this->Time == other.Time;
  }
  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

private:
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkWeakPointer<vtkOpenGLRenderWindow> Living;
  vtkMTimeType Time = 0; // when it was made, which no other one was
};

/**
 * While it lives, objects are made in the window's context, which must be current.
 */
class vtkPointSplatContextScope
{
public:
  explicit vtkPointSplatContextScope(vtkOpenGLRenderWindow* window);
  ~vtkPointSplatContextScope();
  vtkPointSplatContextScope(const vtkPointSplatContextScope&) = delete;
  void operator=(const vtkPointSplatContextScope&) = delete;

private:
  vtkPointSplatContext Before;
};

#endif
