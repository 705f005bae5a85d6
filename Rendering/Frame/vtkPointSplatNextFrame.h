// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Another frame of a renderer's window, that nobody but its splats wants: what they make in the
// background is ready.
//
// 1. A window can be asked for one where its interactor's timers serve it (vtkPointSplatTimers.h).
// 2. While anything is under way, a repeating timer of the interactor looks after the sources, on
//    the thread that draws and never during a frame. Its events are for nobody else.
// 3. While the user drags there is no timer: a style that drags takes all timers' events, and moves
//    the camera by the mouse's last step at each. There are frames then anyway, and what is ready is
//    taken when one begins.
// 4. Where there is something new to see, the interactor renders. Where nothing is under way, the
//    timer ends, with the next frame that somebody else wants: who ends a timer within its own event
//    crashes VTK's interactor of X windows.
#ifndef vtkPointSplatNextFrame_h
#define vtkPointSplatNextFrame_h

#include "vtkPointSplatSource.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <set>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
class vtkRenderWindowInteractor;
VTK_ABI_NAMESPACE_END

class vtkPointSplatNextFrame
{
public:
  /// sources: whom to look after; they may change between calls.
  explicit vtkPointSplatNextFrame(const std::set<vtkPointSplatSource*>& sources);
  ~vtkPointSplatNextFrame();
  vtkPointSplatNextFrame(const vtkPointSplatNextFrame&) = delete;
  void operator=(const vtkPointSplatNextFrame&) = delete;

  /// After a frame: looks after the sources from now on, if any has something under way.
  void Ask(vtkRenderer* renderer);
  /// Before a frame: ends the timer, where there shall be none; in a drag what is ready is taken.
  void Begin(vtkRenderer* renderer);

private:
  class Observer;
  void Look();
  bool IsUnderWay() const;
  /// Whether there is something new.
  bool Advance();
  void End();

  const std::set<vtkPointSplatSource*>& Sources;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; // that the timer is of
  int Timer = 0;                                        // 0: none
  vtkSmartPointer<Observer> Follower;                   // of its events
  unsigned long Tag = 0;                                // of the observer
  bool InEvent = false;
  bool Drags = false; // and waits for something
  bool Looking = false;
};

#endif
