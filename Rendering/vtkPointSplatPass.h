// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatPass
 * @brief   draws the splat actors of a renderer at a chosen place of a pass chain
 *
 * vtkPointSplatMapper works in any renderer with no pass installed, and in any pass
 * chain by way of the passes that draw geometry (vtkOpaquePass, vtkTranslucentPass).
 * This pass is for who builds a chain and wants to say when splats are drawn, and
 * that nothing else is: before an image filter that is to act on them alone, say.
 *
 * The algorithm, each frame:
 * 1. Of the props of the render state, those are taken whose mapper is a
 *    vtkPointSplatMapper.
 * 2. The renderer's frame is told that only these draw, and with which settings.
 * 3. Their opaque geometry is drawn, then their translucent geometry: stages 1 to 5
 *    of vtkPointSplatMapper, done for all of them together.
 *
 * Lights and camera must be set before, as for every pass that draws: put a
 * vtkLightsPass in front and a vtkCameraPass around. Props of other kinds, and splat
 * actors inside assemblies, are left to other passes. GetNumberOfRenderedProps()
 * counts the props drawn.
 *
 * @sa vtkPointSplatMapper vtkCameraPass vtkLightsPass vtkSequencePass
 */
#ifndef vtkPointSplatPass_h
#define vtkPointSplatPass_h

#include "vtkRenderPass.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro

#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatPass : public vtkRenderPass
{
public:
  static vtkPointSplatPass* New();
  vtkTypeMacro(vtkPointSplatPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Properties of vtkPointSplatMapper that hold for all actors while this pass draws them; their
   * mappers' own stay as they are. -1, the default: each mapper's own.
   */
  vtkSetClampMacro(Method, int, -1, 3);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(0); }
  void SetMethodToTwoPass() { this->SetMethod(1); }
  void SetMethodToDeferred() { this->SetMethod(2); }
  void SetMethodToImageSpace() { this->SetMethod(3); }
  vtkSetClampMacro(Transparency, int, -1, 3);
  vtkGetMacro(Transparency, int);
  void SetTransparencyToAutomatic() { this->SetTransparency(0); }
  void SetTransparencyToPeeling() { this->SetTransparency(1); }
  void SetTransparencyToSorted() { this->SetTransparency(2); }
  void SetTransparencyToNearestExact() { this->SetTransparency(3); }
  vtkSetClampMacro(MaximumNumberOfLayers, int, -1, 256);
  vtkGetMacro(MaximumNumberOfLayers, int);
  vtkPointSplatSetClampMacro(LayerDistance, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LayerDistance, double);
  vtkPointSplatSetClampMacro(TargetError, -1.0, 1.0);
  vtkGetMacro(TargetError, double);
  ///@}

  /**
   * The translucent layers that the last frame had, 1 where all is opaque.
   */
  vtkGetMacro(NumberOfLayersDrawn, int);

  void Render(const vtkRenderState* s) override;

protected:
  vtkPointSplatPass() = default;
  ~vtkPointSplatPass() override = default;

private:
  vtkPointSplatPass(const vtkPointSplatPass&) = delete;
  void operator=(const vtkPointSplatPass&) = delete;

  int Method = -1;
  int Transparency = -1;
  int MaximumNumberOfLayers = -1;
  double LayerDistance = -1.0;
  double TargetError = -1.0;
  int NumberOfLayersDrawn = 0;
};

VTK_ABI_NAMESPACE_END
#endif
