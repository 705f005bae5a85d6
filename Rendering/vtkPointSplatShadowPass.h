// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatShadowPass
 * @brief   lets meshes receive the shadows of splats, and of one another
 *
 * A vtkPointSplatMapper with ShadowsOn() receives the shadows of all splats and meshes. This pass
 * draws the same shadows on what other mappers draw, by one line:
 *
 *     renderer->SetPass(vtkNew<vtkPointSplatShadowPass>());
 *
 * Lights, their radius and samples are those of the mappers' shadows (vtkPointSplatMapper,
 * Shadows); where no visible splat mapper has ShadowsOn() there are none, and the pass only draws.
 *
 * The algorithm, each frame:
 * 1. Where lights, splats, meshes or settings changed, shadow maps of all samples of the lights are
 *    drawn: of opaque splats and meshes depths, of translucent splats the share of red, green and
 *    blue light that passes their surface layers. What a layer of opacity a and colour c lets
 *    pass is (1 - a) (1 + a c): clear glass throws no shadow, coloured layers coloured ones, and
 *    what is nearly opaque black ones.
 * 2. The delegate draws the renderer's props.
 * 3. Meanwhile the shaders of vtkOpenGLPolyDataMapper get code by the hooks that it has for render
 *    passes (vtkOpenGLRenderPass), at the places that vtkShadowMapPass uses: each light is
 *    multiplied by what arrives of it at the pixel. One sample is blended between the map's pixels,
 *    of several the mean is taken (Monte-Carlo integration, Dobrev, Rosenthal, Linsen 2010,
 *    section 6). Splats have their own shaders, and take part by themselves.
 *
 * Hardware selections work as in a renderer without a pass, which VTK's own passes upset.
 *
 * Maps cover all that casts, by at most 4096 pixels along a side, and 256 MiB: in scenes that are
 * much larger than their splats shadows are coarse. Shadows fall on surfaces that lights light: on
 * what has LightingOff(), or is lit by headlights, none do. Translucent meshes receive shadows and
 * cast none. Only props that are visible in the renderer itself, and parts of assemblies, cast; of
 * translucent splats only the former.
 *
 * @sa vtkPointSplatMapper vtkPointShadowTexture vtkShadowMapPass
 */
#ifndef vtkPointSplatShadowPass_h
#define vtkPointSplatShadowPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro

#include "vtkPointSplattingABI.h"

#include <memory> // For internals

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatShadowPass : public vtkOpenGLRenderPass
{
public:
  static vtkPointSplatShadowPass* New();
  vtkTypeMacro(vtkPointSplatShadowPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Draws the props, camera and lights and all: a vtkRenderStepsPass by default. Null draws
   * nothing.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegate);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * What vtkOpenGLPolyDataMapper calls while the delegate draws.
   */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkPointSplatShadowPass();
  ~vtkPointSplatShadowPass() override;

private:
  vtkPointSplatShadowPass(const vtkPointSplatShadowPass&) = delete;
  void operator=(const vtkPointSplatShadowPass&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
  vtkRenderPass* DelegatePass = nullptr;
};

VTK_ABI_NAMESPACE_END
#endif
