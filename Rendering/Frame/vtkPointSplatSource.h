// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What the frame knows of a mapper that draws splats: its settings, its splats, and whom to tell of
// errors. The mapper makes one for itself, by which the frame finds it among the renderer's actors.
#ifndef vtkPointSplatSource_h
#define vtkPointSplatSource_h

#include "vtkPointSplatCloud.h"
#include "vtkPointSplatSettings.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;
class vtkProp;
VTK_ABI_NAMESPACE_END

class vtkPointSplatSource
{
public:
  explicit vtkPointSplatSource(vtkMapper* mapper);
  virtual ~vtkPointSplatSource();
  vtkPointSplatSource(const vtkPointSplatSource&) = delete;
  void operator=(const vtkPointSplatSource&) = delete;

  /// Of the prop, if that is an actor whose mapper draws splats, and that is not shown as points or
  /// wireframe; else null.
  static vtkPointSplatSource* Of(vtkProp* prop);

  /**
   * Brings the pipeline and the splats up to date with what these settings need; false where there
   * is nothing to draw.
   */
  virtual bool Update(const vtkPointSplatSettings& settings) = 0;
  virtual vtkPointSplatSettings GetSettings() const = 0;
  /// The same, with what an actor says.
  vtkPointSplatSettings GetSettings(vtkActor* actor) const;

  vtkPointSplatCloud& GetCloud() { return this->Cloud; }
  vtkMapper* GetMapper() const { return this->Mapper; }

private:
  vtkMapper* Mapper;
  vtkPointSplatCloud Cloud;
};

#endif
