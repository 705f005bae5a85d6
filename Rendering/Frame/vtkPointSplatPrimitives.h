// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a property's representation as points or wireframe shows, by VTK's own mapper.
//
// Poly data whose cells name points that are there are drawn as they are: points of their cells, or
// edges. Of others, of data without cells and of other point sets each point is a vertex, which VTK
// shows as a point in both representations; but for ghosts, points that are not finite and, where
// there are cells, points that belong to none, as VTK does not draw these. A vertex has the scalars
// of its point's first cell, and its id; without cells its point's id, as splats have.
#ifndef vtkPointSplatPrimitives_h
#define vtkPointSplatPrimitives_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "vtkPointSplattingABI.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkHardwareSelector;
class vtkPolyDataMapper;
class vtkProp;
class vtkRenderer;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkPointSplatPrimitives
{
public:
  /// Whether the actor's representation is one of those.
  static bool AreShown(vtkActor* actor);

  /// settings: the mapper whose lookup table, scalars and clipping planes are taken.
  void Render(vtkPolyDataMapper* settings, vtkDataObject* data, vtkRenderer* renderer,
    vtkActor* actor);
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop);
  void Release(vtkWindow* window);

private:
  void SetInput(vtkDataObject* data);

  vtkSmartPointer<vtkPolyDataMapper> Mapper;
  bool IsComposite = false;
  vtkDataObject* Data = nullptr; // that the mapper's input was made of; only compared
  vtkMTimeType DataTime = 0;
  vtkMTimeType SettingsTime = 0;
};

#endif
