// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How far to go down a ladder of choices while the user drags, so that frames take no longer than
// they may. Without OpenGL; times come from who draws.
//
// 1. A drag begins with the best choice whose last measured time fits, or is not known.
// 2. Two frames in a row that take too long, or one that takes thrice as long as it may, lead one
//    rung down. The first frame of a choice does not count: it compiles shaders and makes groups.
// 3. Patience frames in a row that would have fitted into Headroom of the time with the choice above
//    lead one rung up. What that would have taken is what it took last, times what the choice here
//    takes now over what it took just after the step down. Between Headroom and the whole time
//    nothing changes, so that choices do not swing.
// 4. A choice that does not take a quarter less time than the one above is left again, down to the next
//    or up, and not tried again in this drag.
// 5. At rest the best choice is taken, whatever it takes.
#ifndef vtkPointSplatBudget_h
#define vtkPointSplatBudget_h

#include "vtkPointSplatChoices.h"

#include <cstddef>
#include <vector>

class vtkPointSplatBudget
{
public:
  static constexpr double Headroom = 0.7;
  static constexpr double FarTooLong = 3.0;
  static constexpr int Patience = 8;
  static constexpr double WorthIt = 0.75;

  /**
   * Which rung of the ladder, from the best choice to the fastest, the next frame takes. seconds:
   * what it may take, or 0 at rest. frame: its number; asked again for it, the answer is the same.
   * The choice's BudgetReason gets why.
   */
  size_t Choose(std::vector<vtkPointSplatChoice>& ladder, double seconds, unsigned long frame);

  /**
   * What the frame with that choice took; 0 where that was not measured, as at rest.
   */
  void Measured(double seconds, unsigned long frame);
  /// Whether that is not yet known of this frame.
  bool IsNew(unsigned long frame) const { return frame != this->MeasuredFrame; }

private:
  /**
   * What is known of a choice.
   */
  struct Known
  {
    vtkPointSplatChoice Choice;
    int Frames = 0;
    double Seconds = 0.0;   // the last that was measured, or 0
    double Reference = 0.0; // of the rung below, after the step down from here
    bool Pays = true;
  };
  size_t Find(const vtkPointSplatChoice& choice);
  void Begin(double seconds);
  void Step(int step);
  Known& At(size_t rung) { return this->All[this->Rungs[rung]]; }
  /// The next rung in a direction that pays; Rungs.size() where there is none.
  size_t Next(size_t rung, int step);

  std::vector<Known> All;
  std::vector<size_t> Rungs; // of the ladder, in All
  size_t Rung = 0;
  bool Dragging = false;
  unsigned long Frame = 0;
  unsigned long MeasuredFrame = 0;
  double Allowed = 0.0;
  int TooLong = 0;   // frames in a row
  int Promising = 0; // frames in a row
};

#endif
