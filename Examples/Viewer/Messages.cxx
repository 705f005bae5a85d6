// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <vector>

namespace
{
std::string firstError;
std::vector<std::string> warnings;
bool showWarnings = false;

class KeepingWindow : public vtkOutputWindow
{
public:
  static KeepingWindow* New();
  vtkTypeMacro(KeepingWindow, vtkOutputWindow);
  void DisplayErrorText(const char* text) override
  {
    if (firstError.empty())
    {
      firstError = OneLine(text);
    }
  }
  void DisplayWarningText(const char* text) override
  {
    warnings.push_back(OneLine(text));
    if (showWarnings)
    {
      MessageKeeper::ShowWarnings();
    }
  }
  // By these some readers tell that a file is broken off, and go on with what was in memory.
  void DisplayGenericWarningText(const char* text) override
  {
    if (showWarnings)
    {
      this->DisplayWarningText(text);
    }
    else
    {
      this->DisplayErrorText(text);
    }
  }
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}

private:
  // VTK's messages begin with where they come from: "ERROR: In ..., line ...\nvtkX (0x...): "
  static std::string OneLine(const std::string& text)
  {
    std::string line = text;
    const size_t place = line.find('\n');
    if (place != std::string::npos && line.substr(0, place).find(", line ") != std::string::npos)
    {
      line = line.substr(place + 1);
    }
    const size_t address = line.find("): ");
    if (address != std::string::npos && line.compare(0, 3, "vtk") == 0)
    {
      line = line.substr(address + 3);
    }
    std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  }
};
vtkStandardNewMacro(KeepingWindow);
}

//------------------------------------------------------------------------------
MessageKeeper::MessageKeeper()
  // MetaIO writes there, past VTK.
  : Before(std::cerr.rdbuf(this->Swallowed.rdbuf()))
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<KeepingWindow> window;
  vtkOutputWindow::SetInstance(window);
}

MessageKeeper::~MessageKeeper()
{
  vtkOutputWindow::SetInstance(nullptr);
  std::cerr.rdbuf(this->Before);
}

//------------------------------------------------------------------------------
std::string MessageKeeper::TakeError()
{
  std::string error;
  std::swap(error, firstError);
  return error;
}

//------------------------------------------------------------------------------
void MessageKeeper::ShowWarnings()
{
  showWarnings = true;
  for (const std::string& warning : warnings)
  {
    std::fprintf(stderr, "splatview: warning: %s\n", warning.c_str());
  }
  warnings.clear();
}
