// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What the frame knows of a mapper that draws splats: its settings, its splats, and whom to tell of
// errors. The mapper makes one for itself, by which the frame finds it among the renderer's actors.
#ifndef vtkPointSplatSource_h
#define vtkPointSplatSource_h

#include "vtkPointSplatCloud.h"
#include "vtkPointSplatDrafts.h"
#include "vtkPointSplatSettings.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;
class vtkProp;
class vtkRenderer;
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
  ///@{
  /// The same, with what an actor says, if there is one, and with what a renderer's window allows.
  vtkPointSplatSettings GetSettings(vtkActor* actor) const;
  vtkPointSplatSettings GetSettings(vtkRenderer* renderer, vtkActor* actor) const;
  ///@}

  /// The splats to draw; after Update() they may be others.
  vtkPointSplatCloud& GetCloud()
  {
    return this->Drafts.AreDrawn() ? this->Drafts.GetCloud() : *this->Cloud;
  }
  const vtkPointSplatDrafts& GetDrafts() const { return this->Drafts; }
  vtkMapper* GetMapper() const { return this->Mapper; }

  ///@{
  /**
   * Whether something is made in the background, or will be; and, between frames, what there is to
   * do for it: true where another frame will show more, or cost less.
   */
  bool IsUnderWay() const;
  bool Advance();
  ///@}

protected:
  /// Brings the splats up to date, or, where that may be, a draft of them.
  void UpdateCloud(const vtkPointSplatCloudInput& input, bool mayBeDraft);
  /// Whether the splats are there.
  bool IsMadeFrom(const vtkPointSplatCloudInput& input) const
  {
    return this->Cloud->IsMadeFrom(input);
  }

private:
  vtkMapper* Mapper;
  vtkPointSplatDrafts::CloudPointer Cloud{ new vtkPointSplatCloud };
  vtkPointSplatDrafts Drafts;
  vtkMTimeType LevelsAskedFor = 0; // when it was last looked
};

#endif
