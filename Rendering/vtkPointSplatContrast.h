// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How far colours of a scene may be apart: what errors of opacity, of order and of shadows are
// multiplied with.
#ifndef vtkPointSplatContrast_h
#define vtkPointSplatContrast_h

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPointSplatMapper;
class vtkProp;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatContrast
{
public:
  /**
   * The greatest difference (rms of red, green and blue, 0 to 1) among the background and what
   * the splats' materials show in no light and in all of it, highlights left out: these are small.
   * 1 where colours are not known: of points with colours of their own, of whatever else than
   * splats is there, of images as background.
   */
  static double Of(vtkRenderer* renderer);

  /**
   * How much brighter light of intensity 1 makes an actor's surfaces: rms of their diffuse colour.
   */
  static double OfLight(vtkActor* actor, vtkPointSplatMapper* mapper);
};

#endif
