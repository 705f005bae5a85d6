// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPointSplatRepresentationProxy
 * @brief   keeps what the representation Point Splats says of the last frame true
 *
 * ParaView reads properties that are only information when a panel is made, and then no more. What
 * was chosen for a frame is known when that was drawn: so after each frame of a view that shows the
 * representation, at rest or while dragging, they are read again, and panels, which observe
 * properties, show them.
 *
 * They are read where the frame was drawn. ParaView asks the client's object, which knows nothing
 * where a server draws; of many processes the one is asked that has the most points
 * (vtkPVPointSplatRepresentation::GatherChoices()).
 */
#ifndef vtkSMPointSplatRepresentationProxy_h
#define vtkSMPointSplatRepresentationProxy_h

#include "vtkPVPointSplattingModule.h" // For export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // For vtkWeakPointer

#include "vtkPointSplattingABI.h"

class VTKPVPOINTSPLATTING_EXPORT vtkSMPointSplatRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMPointSplatRepresentationProxy* New();
  vtkTypeMacro(vtkSMPointSplatRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMPointSplatRepresentationProxy() = default;
  ~vtkSMPointSplatRepresentationProxy() override;

  void UpdatePropertyInformationInternal(vtkSMProperty* property = nullptr) override;

private:
  vtkSMPointSplatRepresentationProxy(const vtkSMPointSplatRepresentationProxy&) = delete;
  void operator=(const vtkSMPointSplatRepresentationProxy&) = delete;

  void Observe(vtkSMProxy* view);
  void OnFrame(vtkObject* view, unsigned long event, void* interactive);

  vtkWeakPointer<vtkSMProxy> View;
  unsigned long Observer = 0;
  bool DrawnByServer = false;
};

#endif
