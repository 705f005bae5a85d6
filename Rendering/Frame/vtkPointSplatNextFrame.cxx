// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNextFrame.h"

#include "vtkCommand.h"
#include "vtkPointSplatStopwatch.h"
#include "vtkPointSplatTimers.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
constexpr float BeforeStyles = 1.0f; // of priorities, theirs is 0
}

class vtkPointSplatNextFrame::Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const int timer = data ? *static_cast<int*>(data) : 0;
    this->SetAbortFlag(timer == this->Next->Timer);
    this->Next->InEvent = true;
    this->Next->Look();
    if (this->Next) // else its renderer has gone with the frame
    {
      this->Next->InEvent = false;
    }
  }
  vtkPointSplatNextFrame* Next = nullptr;
};

//------------------------------------------------------------------------------
vtkPointSplatNextFrame::vtkPointSplatNextFrame(const std::set<vtkPointSplatSource*>& sources)
  : Sources(sources)
{
}

//------------------------------------------------------------------------------
vtkPointSplatNextFrame::~vtkPointSplatNextFrame()
{
  this->End();
}

//------------------------------------------------------------------------------
void vtkPointSplatNextFrame::Ask(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const bool wanted = this->IsUnderWay();
  this->Drags = wanted && vtkPointSplatStopwatch::IsInteracting(renderer);
  const bool runs = this->Timer > 0 && this->Interactor == window->GetInteractor();
  if (!wanted || this->Drags || runs || this->InEvent ||
    !vtkPointSplatTimers::AreOf(window))
  {
    return;
  }
  this->End();
  this->Interactor = window->GetInteractor();
  this->Follower.TakeReference(Observer::New());
  this->Follower->Next = this;
  this->Tag = this->Interactor->AddObserver(vtkCommand::TimerEvent, this->Follower, BeforeStyles);
  this->Timer = this->Interactor->CreateRepeatingTimer(vtkPointSplatTimers::Period);
}

//------------------------------------------------------------------------------
void vtkPointSplatNextFrame::End()
{
  if (this->Follower)
  {
    this->Follower->Next = nullptr;
    this->Follower = nullptr;
  }
  if (this->Interactor && this->Timer > 0)
  {
    this->Interactor->RemoveObserver(this->Tag);
    if (!this->InEvent)
    {
      this->Interactor->DestroyTimer(this->Timer);
    }
  }
  this->Interactor = nullptr;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatNextFrame::IsUnderWay() const
{
  return std::any_of(this->Sources.begin(), this->Sources.end(),
    [](const vtkPointSplatSource* source) { return source->IsUnderWay(); });
}

//------------------------------------------------------------------------------
void vtkPointSplatNextFrame::Begin(vtkRenderer* renderer)
{
  if (this->Drags && !this->Looking)
  {
    this->Advance();
  }
  if (this->Timer > 0 && !this->InEvent &&
    (!this->IsUnderWay() || vtkPointSplatStopwatch::IsInteracting(renderer)))
  {
    this->End();
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatNextFrame::Advance()
{
  this->Looking = true;
  bool news = false;
  for (vtkPointSplatSource* source : this->Sources)
  {
    news = source->Advance() || news;
  }
  this->Looking = false;
  return news;
}

//------------------------------------------------------------------------------
void vtkPointSplatNextFrame::Look()
{
  vtkRenderWindow* window = this->Interactor->GetRenderWindow();
  // Programs that handle events while they draw, or while they show progress, get here meanwhile.
  if (this->Looking || !window || window->CheckInRenderStatus())
  {
    return;
  }
  const bool news = this->Advance();
  if (news)
  {
    // It may end what looks.
    this->Interactor->Render();
  }
}
