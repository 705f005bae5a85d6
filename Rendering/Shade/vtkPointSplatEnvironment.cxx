// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEnvironment.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLTexture.h"
#include "vtkPointData.h"
#include "vtkPointSplatProgram.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
/**
 * Whether VTK can load a cube map's faces. It reads all of them by the first one's size and type,
 * and scalars that it has to map to colours when it has freed them.
 */
bool IsLoadable(vtkTexture* texture)
{
  if (!texture->GetCubeMap())
  {
    return true;
  }
  vtkDataArray* first = nullptr;
  int size[3] = { 0, 0, 0 };
  for (int face = 0; face < 6; ++face)
  {
    if (texture->GetNumberOfInputConnections(face) == 0)
    {
      return face == 0; // a texture object of the application's own
    }
    texture->GetInputAlgorithm(face, 0)->Update();
    auto image = vtkImageData::SafeDownCast(texture->GetInputDataObject(face, 0));
    vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
    if (image && !scalars)
    {
      scalars = image->GetCellData()->GetScalars();
    }
    if (!scalars || scalars->GetNumberOfComponents() < 3)
    {
      return false;
    }
    const int type = scalars->GetDataType();
    const bool direct = texture->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS;
    if (!(type == VTK_UNSIGNED_CHAR && texture->GetColorMode() != VTK_COLOR_MODE_MAP_SCALARS) &&
      !(direct && (type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT)))
    {
      return false;
    }
    if (face == 0)
    {
      first = scalars;
      image->GetDimensions(size);
    }
    else if (type != first->GetDataType() ||
      scalars->GetNumberOfComponents() != first->GetNumberOfComponents() ||
      !std::equal(size, size + 3, image->GetDimensions()))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatEnvironment::Prepare(vtkRenderer* renderer)
{
  this->Texture = nullptr;
  auto texture = vtkOpenGLTexture::SafeDownCast(renderer->GetEnvironmentTexture());
  if (!texture || !IsLoadable(texture))
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

  this->Sampler.Make();
  const GLuint sampler = this->Sampler.Get();
  const GLint filter = texture->GetInterpolate() ? GL_LINEAR : GL_NEAREST;
  const bool mipmap = object->GetMinificationFilter() == vtkTextureObject::LinearMipmapLinear;
  glSamplerParameteri(
    sampler, GL_TEXTURE_MIN_FILTER, mipmap ? GL_LINEAR_MIPMAP_LINEAR : filter);
  glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

  this->FromWorld = FromWorldOf(renderer);
  return true;
}

//------------------------------------------------------------------------------
glm::dmat3 vtkPointSplatEnvironment::FromWorldOf(vtkRenderer* renderer)
{
  glm::dvec3 up;
  glm::dvec3 right;
  renderer->GetEnvironmentUp(&up.x);
  renderer->GetEnvironmentRight(&right.x);
  return glm::transpose(glm::dmat3(right, up, glm::cross(right, up)));
}

//------------------------------------------------------------------------------
void vtkPointSplatEnvironment::Bind(
  const vtkPointSplatView& view, vtkPointSplatProgram& program) const
{
  this->Texture->Activate();
  const int unit = this->Texture->GetTextureUnit();
  glBindSampler(static_cast<GLuint>(unit), this->Sampler.Get());
  program.Set("Environment", unit);
  program.Set("EnvironmentFromView",
    glm::mat3(this->FromWorld * glm::transpose(glm::dmat3(view.WCVC))));
}

//------------------------------------------------------------------------------
void vtkPointSplatEnvironment::Unbind() const
{
  glBindSampler(static_cast<GLuint>(this->Texture->GetTextureUnit()), 0);
  this->Texture->Deactivate();
  vtkPointSplatProgram::ForgetSamplers();
}
