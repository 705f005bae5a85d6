// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

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
      firstError = Stripped(text);
    }
  }
  void DisplayWarningText(const char* text) override
  {
    MessageKeeper::AddWarning(Stripped(text));
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
  static std::string Stripped(const std::string& text)
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
    return OneLine(line);
  }
};
vtkStandardNewMacro(KeepingWindow);

bool IsUtf8(const std::string& text)
{
  int following = 0;
  for (const unsigned char c : text)
  {
    if (following > 0)
    {
      if ((c & 0xC0) != 0x80)
      {
        return false;
      }
      --following;
    }
    else if (c >= 0x80)
    {
      const bool two = c >= 0xC2 && c < 0xE0;
      const bool three = c >= 0xE0 && c < 0xF0;
      const bool four = c >= 0xF0 && c < 0xF5;
      following = two ? 1 : three ? 2 : four ? 3 : -1;
    }
    if (following < 0)
    {
      return false;
    }
  }
  return following == 0;
}
}

//------------------------------------------------------------------------------
std::string OneLine(std::string text)
{
  const bool ascii = !IsUtf8(text);
  for (char& c : text)
  {
    const unsigned char code = static_cast<unsigned char>(c);
    c = code < 0x20 || code == 0x7F ? ' ' : ascii && code >= 0x80 ? '?' : c;
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
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
void MessageKeeper::AddWarning(const std::string& text)
{
  warnings.push_back(OneLine(text));
  if (showWarnings)
  {
    MessageKeeper::ShowWarnings();
  }
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
