// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPass.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPointSplatMapper.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

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
  for (vtkActor* actor : actors)
  {
    this->NumberOfRenderedProps += actor->RenderOpaqueGeometry(s->GetRenderer());
  }
  for (vtkActor* actor : actors)
  {
    this->NumberOfRenderedProps += actor->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
