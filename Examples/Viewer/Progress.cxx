// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdio>

#if defined(_WIN32)
#include <io.h>
#define isatty _isatty
#else
#include <unistd.h>
#endif

namespace
{
void FollowAlgorithm(vtkObject* caller, unsigned long event, void* bar, void*)
{
  auto* self = static_cast<ProgressBar*>(bar);
  if (event == vtkCommand::EndEvent)
  {
    self->Clear();
  }
  else
  {
    self->Update(static_cast<vtkAlgorithm*>(caller)->GetProgress());
  }
}

void DeleteBar(void* bar)
{
  delete static_cast<ProgressBar*>(bar);
}
}

//------------------------------------------------------------------------------
ProgressBar::ProgressBar(const std::string& label, bool quiet)
  : Label(label)
  , Enabled(!quiet && isatty(2))
{
}

ProgressBar::~ProgressBar()
{
  this->Clear();
}

void ProgressBar::Update(double done)
{
  const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
  if (!this->Enabled || percent == this->Percent)
  {
    return;
  }
  this->Percent = percent;
  std::fprintf(stderr, "\r%-28s [%-30.*s] %3d %%", this->Label.c_str(), percent * 30 / 100,
    "##############################", percent);
}

void ProgressBar::Clear()
{
  if (this->Percent >= 0)
  {
    std::fprintf(stderr, "\r%-68s\r", "");
    this->Percent = -1;
  }
}

//------------------------------------------------------------------------------
void ShowProgress(vtkAlgorithm* algorithm, const std::string& label, bool quiet)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(FollowAlgorithm);
  command->SetClientData(new ProgressBar(label, quiet));
  command->SetClientDataDeleteCallback(DeleteBar);
  algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->AddObserver(vtkCommand::EndEvent, command);
}
