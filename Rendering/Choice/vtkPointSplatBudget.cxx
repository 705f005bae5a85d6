// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBudget.h"

#include <algorithm>
#include <cmath>

namespace
{
// More than the choices that one scene has.
constexpr size_t MostKnown = 64;

std::string Milliseconds(double seconds)
{
  return std::to_string(std::lround(1000.0 * seconds)) + " ms";
}
}

//------------------------------------------------------------------------------
size_t vtkPointSplatBudget::Find(const vtkPointSplatChoice& choice)
{
  const auto found = std::find_if(this->All.begin(), this->All.end(),
    [&choice](const Known& known) { return known.Choice.IsLike(choice); });
  if (found != this->All.end())
  {
    return static_cast<size_t>(found - this->All.begin());
  }
  this->All.emplace_back();
  this->All.back().Choice = choice;
  return this->All.size() - 1;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatBudget::Next(size_t rung, int step)
{
  while (step > 0 ? rung + 1 < this->Rungs.size() : rung > 0)
  {
    rung = step > 0 ? rung + 1 : rung - 1;
    if (this->At(rung).Pays)
    {
      return rung;
    }
  }
  return this->Rungs.size();
}

//------------------------------------------------------------------------------
void vtkPointSplatBudget::Begin(double seconds)
{
  // A drag begins, or shows what it did not show before.
  for (Known& known : this->All)
  {
    known.Pays = true;
  }
  this->Rung = 0;
  while (this->Rung + 1 < this->Rungs.size() && this->At(this->Rung).Seconds > seconds)
  {
    ++this->Rung;
  }
  this->TooLong = this->Promising = 0;
}

//------------------------------------------------------------------------------
void vtkPointSplatBudget::Step(int step)
{
  const size_t next = this->Next(this->Rung, step);
  if (next == this->Rungs.size())
  {
    return;
  }
  if (step > 0)
  {
    this->At(this->Rung).Reference = 0.0;
  }
  this->Rung = next;
  this->TooLong = this->Promising = 0;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatBudget::Choose(
  std::vector<vtkPointSplatChoice>& ladder, double seconds, unsigned long frame)
{
  if (this->All.size() + ladder.size() > MostKnown)
  {
    this->All.clear();
    this->Dragging = false;
  }
  const size_t before = this->Dragging ? this->Rungs[this->Rung] : 0;
  this->Rungs.clear();
  for (const vtkPointSplatChoice& choice : ladder)
  {
    this->Rungs.push_back(this->Find(choice));
  }
  this->Allowed = seconds;
  if (!(seconds > 0.0))
  {
    this->Dragging = false;
    this->Rung = 0;
    ladder[0].BudgetReason = "at rest, a frame may take as long as it needs";
    return 0;
  }
  const auto last = std::find(this->Rungs.begin(), this->Rungs.end(), before);
  if (!this->Dragging || last == this->Rungs.end())
  {
    this->Begin(seconds);
  }
  else
  {
    this->Rung = static_cast<size_t>(last - this->Rungs.begin());
    if (frame != this->Frame)
    {
      const size_t down = this->Next(this->Rung, 1);
      if (!this->At(this->Rung).Pays || (this->TooLong >= 2 && down < this->Rungs.size()))
      {
        this->Step(down < this->Rungs.size() ? 1 : -1);
      }
      else if (this->Promising >= Patience && this->Rung > 0)
      {
        this->Step(-1);
      }
    }
  }
  this->Frame = frame;
  this->Dragging = true;
  const double best = this->All[this->Rungs[0]].Seconds;
  ladder[this->Rung].BudgetReason = "a frame may take " + Milliseconds(seconds) +
    (best > 0.0 ? ", full quality took " + Milliseconds(best) : "");
  return this->Rung;
}

//------------------------------------------------------------------------------
void vtkPointSplatBudget::Measured(double seconds, unsigned long frame)
{
  this->MeasuredFrame = frame;
  if (this->Rungs.empty())
  {
    return;
  }
  Known& here = this->All[this->Rungs[this->Rung]];
  if (++here.Frames == 1 || !(seconds > 0.0) || !this->Dragging)
  {
    return;
  }
  here.Seconds = seconds;
  this->TooLong = seconds > FarTooLong * this->Allowed ? 2
    : seconds > this->Allowed                          ? this->TooLong + 1
                                                       : 0;
  // No rung above pays where one is the best of a ladder now that did not pay in another.
  const size_t up = this->Next(this->Rung, -1);
  if (up == this->Rungs.size())
  {
    return;
  }
  Known& above = this->At(up);
  if (above.Reference == 0.0)
  {
    above.Reference = seconds;
  }
  // The first frames of a choice make buffers.
  here.Pays = here.Frames < 3 || above.Seconds == 0.0 || seconds <= WorthIt * above.Seconds;
  const bool fits = above.Seconds * seconds / above.Reference < Headroom * this->Allowed;
  this->Promising = fits ? this->Promising + 1 : 0;
}
