// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPlainScene.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSplatMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"

#include <set>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatPlainScene);

class vtkPointSplatPlainScene::vtkInternals
{
public:
  struct Replaced
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkMapper> Splats;
    vtkSmartPointer<vtkMapper> Vertices;
  };
  /// The actors of all renderers, those in assemblies too.
  std::set<vtkActor*> FindActors() const;

  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<Replaced> All;
};

//------------------------------------------------------------------------------
std::set<vtkActor*> vtkPointSplatPlainScene::vtkInternals::FindActors() const
{
  std::set<vtkActor*> actors;
  vtkCollectionSimpleIterator at;
  this->Window->GetRenderers()->InitTraversal(at);
  while (vtkRenderer* renderer = this->Window->GetRenderers()->GetNextRenderer(at))
  {
    vtkCollectionSimpleIterator it;
    renderer->GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
    {
      prop->InitPathTraversal();
      while (vtkAssemblyPath* path = prop->GetNextPath())
      {
        if (auto actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp()))
        {
          actors.insert(actor);
        }
      }
    }
  }
  return actors;
}

//------------------------------------------------------------------------------
vtkPointSplatPlainScene::vtkPointSplatPlainScene()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkPointSplatPlainScene::~vtkPointSplatPlainScene()
{
  this->End();
}

//------------------------------------------------------------------------------
void vtkPointSplatPlainScene::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->Internals->Window != window)
  {
    this->End();
    this->Internals->Window = window;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkPointSplatPlainScene::GetRenderWindow()
{
  return this->Internals->Window;
}

//------------------------------------------------------------------------------
void vtkPointSplatPlainScene::Begin()
{
  this->End();
  if (!this->Internals->Window)
  {
    vtkErrorMacro("There is no window: call SetRenderWindow().");
    return;
  }
  for (vtkActor* actor : this->Internals->FindActors())
  {
    auto splats = vtkPointSplatMapper::SafeDownCast(actor->GetMapper());
    if (!splats || splats->GetNumberOfInputConnections(0) == 0)
    {
      continue;
    }
    vtkNew<vtkPolyData> points;
    splats->GetVertices(actor, points);
    auto mesh = vtkPolyData::SafeDownCast(splats->GetInputDataObject(0, 0));
    if (mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0)
    {
      continue;
    }
    vtkNew<vtkPolyDataMapper> vertices;
    vertices->SetInputData(points);
    this->Internals->All.push_back({ actor, splats, vertices });
    actor->SetMapper(vertices);
  }
  if (!this->Internals->All.empty())
  {
    vtkWarningMacro(<< this->Internals->All.size()
                    << " actors with splats are plain vertices with colours until End(): their "
                       "surfaces cannot be written.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPlainScene::End()
{
  for (const vtkInternals::Replaced& one : this->Internals->All)
  {
    if (one.Actor->GetMapper() == one.Vertices)
    {
      one.Actor->SetMapper(one.Splats);
    }
  }
  this->Internals->All.clear();
}

//------------------------------------------------------------------------------
int vtkPointSplatPlainScene::GetNumberOfActors()
{
  return static_cast<int>(this->Internals->All.size());
}

//------------------------------------------------------------------------------
void vtkPointSplatPlainScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RenderWindow: " << this->Internals->Window.Get() << "\n";
  os << indent << "NumberOfActors: " << this->GetNumberOfActors() << "\n";
}

VTK_ABI_NAMESPACE_END
