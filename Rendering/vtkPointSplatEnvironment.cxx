// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEnvironment.h"

#include "vtkOpenGLTexture.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/type_ptr.hpp>

//------------------------------------------------------------------------------
bool vtkPointSplatEnvironment::Prepare(vtkRenderer* renderer)
{
  this->Texture = nullptr;
  auto texture = vtkOpenGLTexture::SafeDownCast(renderer->GetEnvironmentTexture());
  if (!texture)
  {
    return false;
  }
  texture->Render(renderer);
  vtkTextureObject* object = texture->GetTextureObject();
  if (!object || object->GetHandle() == 0)
  {
    return false;
  }
  this->Texture = object;
  this->Defines = object->GetTarget() == GL_TEXTURE_CUBE_MAP ? "#define ENVIRONMENT_CUBE\n" : "";
  if (texture->GetUseSRGBColorSpace() || object->GetVTKDataType() == VTK_FLOAT)
  {
    this->Defines += "#define ENVIRONMENT_LINEAR\n";
  }
  texture->PostRender(renderer);

  if (!this->Sampler)
  {
    glGenSamplers(1, &this->Sampler);
  }
  const GLint filter = texture->GetInterpolate() ? GL_LINEAR : GL_NEAREST;
  const bool mipmap = object->GetMinificationFilter() == vtkTextureObject::LinearMipmapLinear;
  glSamplerParameteri(
    this->Sampler, GL_TEXTURE_MIN_FILTER, mipmap ? GL_LINEAR_MIPMAP_LINEAR : filter);
  glSamplerParameteri(this->Sampler, GL_TEXTURE_MAG_FILTER, filter);
  glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

  glm::dvec3 up;
  glm::dvec3 right;
  renderer->GetEnvironmentUp(&up.x);
  renderer->GetEnvironmentRight(&right.x);
  this->FromWorld = glm::transpose(glm::dmat3(right, up, glm::cross(right, up)));
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatEnvironment::Bind(
  const vtkPointSplatView& view, vtkShaderProgram* program) const
{
  this->Texture->Activate();
  const int unit = this->Texture->GetTextureUnit();
  glBindSampler(static_cast<GLuint>(unit), this->Sampler);
  program->SetUniformi("Environment", unit);
  glm::mat3 fromView(this->FromWorld * glm::transpose(glm::dmat3(view.WCVC)));
  program->SetUniformMatrix3x3("EnvironmentFromView", glm::value_ptr(fromView));
}

//------------------------------------------------------------------------------
void vtkPointSplatEnvironment::Unbind() const
{
  glBindSampler(static_cast<GLuint>(this->Texture->GetTextureUnit()), 0);
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkPointSplatEnvironment::Release()
{
  glDeleteSamplers(1, &this->Sampler);
  this->Sampler = 0;
}
