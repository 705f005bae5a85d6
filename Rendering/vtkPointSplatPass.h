// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatPass
 * @brief   the splat mapper's work as a render pass
 */
#ifndef vtkPointSplatPass_h
#define vtkPointSplatPass_h

#include "vtkRenderingPointSplattingModule.h" // For export macro
#include "vtkRenderPass.h"
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
  vtkPointSplatPass();
  ~vtkPointSplatPass() override;

private:
  vtkPointSplatPass(const vtkPointSplatPass&) = delete;
  void operator=(const vtkPointSplatPass&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
