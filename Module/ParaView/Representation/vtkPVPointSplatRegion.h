// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVPointSplatRegion
 * @brief   lets a process show only what its part of space has of a surface
 *
 * Processes that share a cloud draw the points of others near their border, too, so that both have
 * the whole surface there, and each shows the pixels whose surface lies in its own box: together
 * they have each pixel once, with the very normals and colours that one process alone would give
 * it. It is no pass that draws: it stands among an actor's render passes (the information key
 * vtkOpenGLRenderPass::RenderPasses()) for what it adds to the shader that presents layers.
 */
#ifndef vtkPVPointSplatRegion_h
#define vtkPVPointSplatRegion_h

#include "vtkBoundingBox.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPVPointSplattingModule.h" // For export macro
#include "vtkSmartPointer.h"

#include "vtkPointSplattingABI.h"

#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
VTK_ABI_NAMESPACE_END

class VTKPVPOINTSPLATTING_EXPORT vtkPVPointSplatRegion : public vtkOpenGLRenderPass
{
public:
  static vtkPVPointSplatRegion* New();
  vtkTypeMacro(vtkPVPointSplatRegion, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The box, in the coordinates of the actor's data; sides at +-VTK_DOUBLE_MAX are open. One that
   * is not valid shows nothing. Default: not valid.
   */
  void SetBox(const vtkBoundingBox& box) { this->Box = box; }

  /**
   * The camera by which the actor is drawn.
   */
  void SetCamera(vtkCamera* camera);

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

protected:
  vtkPVPointSplatRegion();
  ~vtkPVPointSplatRegion() override;

private:
  vtkPVPointSplatRegion(const vtkPVPointSplatRegion&) = delete;
  void operator=(const vtkPVPointSplatRegion&) = delete;

  vtkBoundingBox Box;
  vtkSmartPointer<vtkCamera> Camera;
};

#endif
