// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// In a window that OpenGL does not draw, VTK's mapper for that window draws the cells, or plain vertices
// with the colours, and one warning says so.
#include "SplatScene.h"

#include "vtkCallbackCommand.h"
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#ifndef VTK_FUTURE_CONST // in older versions the factory's methods are not const
#define VTK_FUTURE_CONST
#endif

namespace
{
using namespace SplatScene;

// Another graphics system's window, renderer and mapper.
class OtherWindow : public vtkRenderWindow
{
public:
  static OtherWindow* New() { VTK_STANDARD_NEW_BODY(OtherWindow); }
  vtkTypeMacro(OtherWindow, vtkRenderWindow);
};

class OtherRenderer : public vtkRenderer
{
public:
  static OtherRenderer* New() { VTK_STANDARD_NEW_BODY(OtherRenderer); }
  vtkTypeMacro(OtherRenderer, vtkRenderer);
};

class OtherMapper : public vtkPolyDataMapper
{
public:
  static OtherMapper* New() { VTK_STANDARD_NEW_BODY(OtherMapper); }
  static vtkObject* Make() { return New(); }
  vtkTypeMacro(OtherMapper, vtkPolyDataMapper);
  void RenderPiece(vtkRenderer*, vtkActor*) override
  {
    ++Drawn;
    Data = this->GetInput();
    Colours = this->MapScalars(1.0);
  }

  static int Drawn;
  static vtkSmartPointer<vtkPolyData> Data;
  static vtkSmartPointer<vtkUnsignedCharArray> Colours;
};
int OtherMapper::Drawn = 0;
vtkSmartPointer<vtkPolyData> OtherMapper::Data;
vtkSmartPointer<vtkUnsignedCharArray> OtherMapper::Colours;

class OtherFactory : public vtkObjectFactory
{
public:
  static OtherFactory* New() { VTK_STANDARD_NEW_BODY(OtherFactory); }
  vtkTypeMacro(OtherFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "Another graphics system"; }

protected:
  OtherFactory()
  {
    this->RegisterOverride("vtkPolyDataMapper", "OtherMapper", "", 1, OtherMapper::Make);
  }
};

void Count(vtkObject*, unsigned long, void* counter, void*)
{
  ++*static_cast<int*>(counter);
}

void Equal(Checks& checks, vtkIdType value, vtkIdType wanted, const std::string& what)
{
  checks.AtLeast(value, wanted, what);
  checks.AtMost(value, wanted, what);
}
}

int TestSplatsElsewhere(int, char*[])
{
  Checks checks;
  vtkObjectFactory::SetAllEnableFlags(0, "vtkPolyDataMapper");
  vtkNew<OtherFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);

  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(30);
  vtkNew<vtkFloatArray> heights;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[1]));
  }
  mesh->GetPointData()->SetScalars(heights);
  vtkSmartPointer<vtkPolyData> points = Cloud(mesh);
  points->GetPointData()->SetScalars(heights);
  for (vtkPolyData* data : { mesh.Get(), points.Get() })
  {
    vtkNew<OtherWindow> window;
    vtkNew<OtherRenderer> renderer;
    window->AddRenderer(renderer);
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    int warnings = 0;
    vtkNew<vtkCallbackCommand> count;
    count->SetCallback(Count);
    count->SetClientData(&warnings);
    mapper->AddObserver(vtkCommand::WarningEvent, count);
    OtherMapper::Drawn = 0;
    mapper->Render(renderer, actor);
    mapper->Render(renderer, actor);
    const std::string name = data == mesh ? "mesh: " : "points: ";
    Equal(checks, OtherMapper::Drawn, 2, name + "frames drawn");
    Equal(checks, warnings, 1, name + "warnings");
    if (!OtherMapper::Data)
    {
      continue;
    }
    Equal(checks, OtherMapper::Data->GetNumberOfVerts(),
      data == mesh ? 0 : points->GetNumberOfPoints(), name + "vertices");
    Equal(checks, OtherMapper::Data->GetNumberOfPolys(), data->GetNumberOfPolys(),
      name + "polygons");
    Equal(checks, OtherMapper::Colours ? OtherMapper::Colours->GetNumberOfTuples() : 0,
      points->GetNumberOfPoints(), name + "colours");
    OtherMapper::Data = nullptr;
    OtherMapper::Colours = nullptr;
  }
  return checks.Result();
}
