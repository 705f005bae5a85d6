// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Options.h"
#include "PlyVertices.h"
#include "TextPoints.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkOBJReader.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSTLReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

#if defined(_WIN32)
#include <io.h>
#define isatty _isatty
#else
#include <unistd.h>
#endif

namespace
{
std::string firstError;

/**
 * Errors are kept, warnings go out in one line each.
 */
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
    std::fprintf(stderr, "splatview: warning: %s\n", OneLine(text).c_str());
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}

private:
  // VTK's messages begin with where they come from: "ERROR: In ..., line ...\nvtkX (0x...): "
  static std::string OneLine(const std::string& text)
  {
    std::string line = text;
    const size_t address = line.find("): ");
    if (address != std::string::npos)
    {
      line = line.substr(address + 3);
    }
    std::replace(line.begin(), line.end(), '\n', ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  }
};
vtkStandardNewMacro(KeepingWindow);

void DrawBar(vtkObject* caller, unsigned long, void* label, void*)
{
  const double done = static_cast<vtkAlgorithm*>(caller)->GetProgress();
  std::fprintf(stderr, "\r%-28s [%-30.*s] %3d %%", static_cast<const char*>(label),
    static_cast<int>(30 * std::clamp(done, 0.0, 1.0)), "##############################",
    static_cast<int>(100 * std::clamp(done, 0.0, 1.0)));
}

void EndBar(vtkObject*, unsigned long, void*, void*)
{
  std::fprintf(stderr, "\r%-70s\r", "");
}

void FreeLabel(void* label)
{
  delete[] static_cast<char*>(label);
}

void Observe(vtkAlgorithm* algorithm, unsigned long event, const std::string& label,
  void (*callback)(vtkObject*, unsigned long, void*, void*))
{
  char* copy = new char[label.size() + 1];
  std::copy(label.begin(), label.end() + 1, copy);
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(callback);
  command->SetClientData(copy);
  command->SetClientDataDeleteCallback(FreeLabel);
  algorithm->AddObserver(event, command);
}

std::string Extension(const std::string& file)
{
  const size_t dot = file.rfind('.');
  std::string extension = dot == std::string::npos ? "" : file.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(const std::string& file, bool quiet)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  ShowProgress(reader, "reading", quiet);
  reader->Update();
  return reader->GetOutputDataObject(0);
}

/**
 * Meshes without normals get those of their triangles, as VTK's mesh pictures have.
 */
vtkSmartPointer<vtkDataObject> WithNormals(vtkDataObject* object)
{
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(object);
  if (!mesh || mesh->GetPointData()->GetNormals() ||
    (mesh->GetNumberOfPolys() == 0 && mesh->GetNumberOfStrips() == 0))
  {
    return object;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkDataObject> ReadPly(const std::string& file, bool quiet)
{
  bool hasFaces = false;
  vtkSmartPointer<vtkPolyData> vertices = ReadPlyVertices(file, hasFaces);
  if (vertices->GetPointData()->GetNormals() || !hasFaces)
  {
    return vertices;
  }
  vtkSmartPointer<vtkDataObject> mesh = WithNormals(Read<vtkPLYReader>(file, quiet));
  vtkPolyData* withNormals = vtkPolyData::SafeDownCast(mesh);
  if (withNormals && withNormals->GetNumberOfPoints() == vertices->GetNumberOfPoints())
  {
    vertices->GetPointData()->SetNormals(withNormals->GetPointData()->GetNormals());
  }
  return vertices;
}

vtkSmartPointer<vtkDataObject> ReadByExtension(const std::string& file, bool quiet)
{
  const std::string kind = Extension(file);
  if (kind == "ply")
  {
    return ReadPly(file, quiet);
  }
  if (kind == "xyz" || kind == "pts" || kind == "txt" || kind == "csv")
  {
    return ReadTextPoints(file);
  }
  if (kind == "vtp")
  {
    return WithNormals(Read<vtkXMLPolyDataReader>(file, quiet));
  }
  if (kind == "obj")
  {
    return WithNormals(Read<vtkOBJReader>(file, quiet));
  }
  if (kind == "stl")
  {
    return WithNormals(Read<vtkSTLReader>(file, quiet));
  }
  if (kind == "vti")
  {
    return Read<vtkXMLImageDataReader>(file, quiet);
  }
  if (kind == "vtu")
  {
    return Read<vtkXMLUnstructuredGridReader>(file, quiet);
  }
  if (kind == "vts")
  {
    return Read<vtkXMLStructuredGridReader>(file, quiet);
  }
  if (kind == "mhd" || kind == "mha")
  {
    return Read<vtkMetaImageReader>(file, quiet);
  }
  if (kind == "nrrd" || kind == "nhdr")
  {
    return Read<vtkNrrdReader>(file, quiet);
  }
  if (kind == "vtk")
  {
    return WithNormals(Read<vtkGenericDataObjectReader>(file, quiet));
  }
  throw UserError(file + ": files of this kind are not read; --help lists those that are");
}
}

//------------------------------------------------------------------------------
MessageKeeper::MessageKeeper()
{
  vtkNew<KeepingWindow> window;
  vtkOutputWindow::SetInstance(window);
}

MessageKeeper::~MessageKeeper()
{
  vtkOutputWindow::SetInstance(nullptr);
}

std::string MessageKeeper::TakeError()
{
  std::string error;
  std::swap(error, firstError);
  return error;
}

//------------------------------------------------------------------------------
void ShowProgress(vtkAlgorithm* algorithm, const std::string& label, bool quiet)
{
  if (!quiet && isatty(2))
  {
    Observe(algorithm, vtkCommand::ProgressEvent, label, DrawBar);
    Observe(algorithm, vtkCommand::EndEvent, label, EndBar);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadFile(const std::string& file, bool quiet)
{
  if (!std::ifstream(file))
  {
    throw UserError(file + ": cannot be opened");
  }
  vtkSmartPointer<vtkDataObject> object = ReadByExtension(file, quiet);
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    throw UserError(file + ": " + error);
  }
  vtkDataSet* data = vtkDataSet::SafeDownCast(object);
  if (!data || data->GetNumberOfPoints() == 0)
  {
    throw UserError(file + ": has no points");
  }
  if (!vtkImageData::SafeDownCast(data) && !vtkPointSet::SafeDownCast(data))
  {
    throw UserError(
      file + ": holds a " + data->GetClassName() + "; points or image data are wanted");
  }
  return object;
}
