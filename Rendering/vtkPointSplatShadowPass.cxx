// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowPass.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatFrame.h"
#include "vtkPointSplatUnits.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Where the code comes to lie, once it is known that the mapper lights what it draws.
const char* const DeclarationTag = "//PointSplat::LightMaps::Dec";
const char* const ImplementationTag = "//PointSplat::LightMaps::Impl";
}

/**
 * What is at hand while the delegate draws.
 */
class vtkPointSplatShadowPass::vtkInternals
{
public:
  vtkRenderer* Renderer = nullptr;
  vtkPointSplatLightMaps* Maps = nullptr; // or none
  std::unique_ptr<vtkPointSplatUnits> Units;
  std::string Defines; // that shaders were last made with
  vtkTimeStamp ShaderTime;
  std::string Error; // that the user was told last
};

vtkStandardNewMacro(vtkPointSplatShadowPass);
vtkCxxSetObjectMacro(vtkPointSplatShadowPass, DelegatePass, vtkRenderPass);

//------------------------------------------------------------------------------
vtkPointSplatShadowPass::vtkPointSplatShadowPass()
  : Internals(new vtkInternals)
{
  this->DelegatePass = vtkRenderStepsPass::New();
}

//------------------------------------------------------------------------------
vtkPointSplatShadowPass::~vtkPointSplatShadowPass()
{
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  if (!this->DelegatePass)
  {
    return;
  }
  vtkInternals& internals = *this->Internals;
  vtkRenderer* renderer = s->GetRenderer();
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // A renderer lets its selector draw, who numbers the props, only where it has no pass.
    renderer->GetActiveCamera()->Render(renderer);
    selector->Render(renderer, s->GetPropArray(), s->GetPropArrayCount());
    this->NumberOfRenderedProps = s->GetPropArrayCount();
    return;
  }
  // Lights that follow the camera are moved with it by the delegate only.
  renderer->UpdateLightsGeometryToFollowCamera();
  const std::shared_ptr<vtkPointSplatFrame> frame = vtkPointSplatFrame::Of(renderer);
  internals.Renderer = renderer;
  internals.Maps = frame->PrepareLightMaps();
  if (frame->GetError() != internals.Error)
  {
    internals.Error = frame->GetError();
    vtkErrorMacro("OpenGL cannot draw the shadows: " << internals.Error);
  }
  if (internals.Maps)
  {
    const std::string defines = internals.Maps->GetDefines(true);
    if (defines != internals.Defines)
    {
      internals.Defines = defines;
      internals.ShaderTime.Modified();
    }
    internals.Units.reset(new vtkPointSplatUnits(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())));
    this->PreRender(s);
  }
  this->DelegatePass->Render(s);
  this->NumberOfRenderedProps += this->DelegatePass->GetNumberOfRenderedProps();
  if (internals.Maps)
  {
    this->PostRender(s);
    internals.Units.reset();
    internals.Maps = nullptr;
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Dec",
    std::string(DeclarationTag) + "\n//VTK::Light::Dec", false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl",
    std::string(ImplementationTag) + "\n//VTK::Light::Impl", false);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  std::string passed;
  for (size_t i = 0; i < this->Internals->Maps->Lights.size(); ++i)
  {
    const std::string index = std::to_string(i);
    const std::string colour = "lightColor" + index;
    const std::string dimmed = "passed" + index + " * " + colour;
    bool found = false;
    // The terms that vtkShadowMapPass changes, too.
    for (const char* term : { "diffuse += (df * ", "specular += (sf * ", "radiance = " })
    {
      const std::string end = term[0] == 'r' ? ";" : ");";
      found = vtkShaderProgram::Substitute(
                fragmentShader, term + colour + end, term + dimmed + end, false) ||
        found;
    }
    passed += found
      ? "vec3 passed" + index + " = lightPassed(" + index + ", vertexVC.xyz, normalVCVSOutput);\n"
      : std::string();
  }
  if (!passed.empty())
  {
    vtkShaderProgram::Substitute(fragmentShader, DeclarationTag,
      this->Internals->Defines + vtkPointSplatProgram::Source("vtkPointSplatLightMaps"), false);
    vtkShaderProgram::Substitute(fragmentShader, ImplementationTag, passed, false);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  vtkInternals& internals = *this->Internals;
  if (internals.Maps && program->IsUniformUsed("LightMapTable"))
  {
    const vtkPointSplatContextScope scope(
      static_cast<vtkOpenGLRenderWindow*>(internals.Renderer->GetRenderWindow()));
    vtkPointSplatProgram borrowed;
    borrowed.Borrow(static_cast<GLuint>(program->GetHandle()));
    internals.Maps->Bind(
      vtkPointSplatView::Matrix(
        internals.Renderer->GetActiveCamera()->GetModelViewTransformMatrix()),
      *internals.Units, borrowed);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatShadowPass::GetShaderStageMTime()
{
  return this->Internals->ShaderTime;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  // The maps are the frame's, and go with the last mapper's resources.
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: ";
  if (this->DelegatePass)
  {
    os << "\n";
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}
VTK_ABI_NAMESPACE_END
