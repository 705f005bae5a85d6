// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPass.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPointSplatFrame.h"
#include "vtkPointSplatMapper.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatPass);

//------------------------------------------------------------------------------
void vtkPointSplatPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  std::vector<vtkActor*> actors;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(s->GetPropArray()[i]);
    if (actor && vtkPointSplatMapper::SafeDownCast(actor->GetMapper()) &&
      actor->HasKeys(s->GetRequiredKeys()))
    {
      actors.push_back(actor);
    }
  }
  this->NumberOfLayersDrawn = 0;
  if (actors.empty())
  {
    return;
  }
  const vtkPointSplatWishes wishes{ actors,
    [this](vtkPointSplatSettings& settings)
    {
      settings.Method = this->Method >= 0 ? this->Method : settings.Method;
      settings.Transparency =
        this->Transparency >= 0 ? this->Transparency : settings.Transparency;
      settings.MaximumNumberOfLayers = this->MaximumNumberOfLayers > 0
        ? this->MaximumNumberOfLayers
        : settings.MaximumNumberOfLayers;
      settings.LayerDistance =
        this->LayerDistance >= 0.0 ? this->LayerDistance : settings.LayerDistance;
      settings.TargetError = this->TargetError >= 0.0 ? this->TargetError : settings.TargetError;
    } };
  const std::shared_ptr<vtkPointSplatFrame> frame = vtkPointSplatFrame::Of(s->GetRenderer());
  frame->SetWishes(&wishes);
  for (vtkActor* actor : actors)
  {
    this->NumberOfRenderedProps += actor->RenderOpaqueGeometry(s->GetRenderer());
  }
  for (vtkActor* actor : actors)
  {
    this->NumberOfRenderedProps += actor->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
  frame->SetWishes(nullptr);
  for (vtkActor* actor : actors)
  {
    auto mapper = static_cast<vtkPointSplatMapper*>(actor->GetMapper());
    this->NumberOfLayersDrawn =
      std::max(this->NumberOfLayersDrawn, mapper->GetNumberOfLayersDrawn());
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Transparency: " << this->Transparency << "\n";
  os << indent << "MaximumNumberOfLayers: " << this->MaximumNumberOfLayers << "\n";
  os << indent << "LayerDistance: " << this->LayerDistance << "\n";
  os << indent << "TargetError: " << this->TargetError << "\n";
  os << indent << "NumberOfLayersDrawn: " << this->NumberOfLayersDrawn << "\n";
}
VTK_ABI_NAMESPACE_END
