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
 * 2. Their opaque geometry is drawn, then their translucent geometry: stages 2 to 5
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

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatPass : public vtkRenderPass
{
public:
  static vtkPointSplatPass* New();
  vtkTypeMacro(vtkPointSplatPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;

protected:
  vtkPointSplatPass() = default;
  ~vtkPointSplatPass() override = default;

private:
  vtkPointSplatPass(const vtkPointSplatPass&) = delete;
  void operator=(const vtkPointSplatPass&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
