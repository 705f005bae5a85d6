// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPointSplatRepresentationProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"

vtkStandardNewMacro(vtkSMPointSplatRepresentationProxy);

//------------------------------------------------------------------------------
vtkSMPointSplatRepresentationProxy::~vtkSMPointSplatRepresentationProxy()
{
  this->Observe(nullptr);
}

//------------------------------------------------------------------------------
void vtkSMPointSplatRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  this->Observe(view);
}

//------------------------------------------------------------------------------
void vtkSMPointSplatRepresentationProxy::Observe(vtkSMProxy* view)
{
  if (this->View == view)
  {
    return;
  }
  if (this->View)
  {
    this->View->RemoveObserver(this->Observer);
  }
  this->View = view;
  if (view)
  {
    this->Observer = view->AddObserver(
      vtkCommand::EndEvent, this, &vtkSMPointSplatRepresentationProxy::OnFrame);
  }
}

//------------------------------------------------------------------------------
void vtkSMPointSplatRepresentationProxy::OnFrame(
  vtkObject*, unsigned long, void* interactive)
{
  // Each representation of data has one of these, whatever type is chosen, and those that are not
  // are not visible.
  auto shown = vtkPVDataRepresentation::SafeDownCast(this->GetClientSideObject());
  auto view = vtkPVRenderView::SafeDownCast(this->View->GetClientSideObject());
  if (!shown || !view || !shown->GetVisibility())
  {
    return;
  }
  const bool dragging = interactive && *static_cast<int*>(interactive) != 0;
  const vtkTypeUInt32 by =
    dragging ? view->GetInteractiveRenderProcesses() : view->GetStillRenderProcesses();
  this->DrawnByServer = (by & vtkPVSession::RENDER_SERVER) != 0;
  if (this->DrawnByServer)
  {
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GatherChoices"
           << vtkClientServerStream::End;
    this->ExecuteStream(stream, false, vtkPVSession::RENDER_SERVER);
  }
  this->UpdatePropertyInformation();
}

//------------------------------------------------------------------------------
void vtkSMPointSplatRepresentationProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  const vtkTypeUInt32 everywhere = this->Location;
  if (this->DrawnByServer)
  {
    this->Location = vtkPVSession::RENDER_SERVER_ROOT;
  }
  this->Superclass::UpdatePropertyInformationInternal(property);
  this->Location = everywhere;
}

//------------------------------------------------------------------------------
void vtkSMPointSplatRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DrawnByServer: " << this->DrawnByServer << "\n";
}
