// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatView.h"

#include "vtkPointSplatProgram.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplattingOpenGL.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
glm::vec2 vtkPointSplatView::GetPixelSize() const
{
  return glm::vec2(this->PixelW.w - this->PixelW.z * static_cast<float>(this->Near),
           -this->PixelW.z) /
    glm::length(glm::vec3(this->PixelX));
}

//------------------------------------------------------------------------------
void vtkPointSplatView::SetPixelRays(vtkPointSplatProgram& program) const
{
  program.Set("RayOffset", glm::vec2(this->PixelX.z, this->PixelY.z));
  program.Set("RayScale",
    this->Parallel ? glm::vec2(0.0f) : 1.0f / glm::vec2(this->PixelX.x, this->PixelY.y));
}

//------------------------------------------------------------------------------
glm::dmat4 vtkPointSplatView::Matrix(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
vtkPointSplatView vtkPointSplatView::Current(vtkRenderer* renderer)
{
  vtkPointSplatView view;
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  view.Origin = { viewport[0], viewport[1] };
  view.Size = { viewport[2], viewport[3] };

  vtkCamera* camera = renderer->GetActiveCamera();
  view.WCVC = vtkPointSplatView::Matrix(camera->GetModelViewTransformMatrix());
  const glm::dmat4 p = glm::transpose(vtkPointSplatView::Matrix(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)));
  view.PixelX = glm::vec4(0.5 * view.Size.x * (p[0] + p[3]));
  view.PixelY = glm::vec4(0.5 * view.Size.y * (p[1] + p[3]));
  view.PixelZ = glm::vec4(p[2]);
  view.PixelW = glm::vec4(p[3]);
  camera->GetClippingRange(view.Near, view.Far);
  view.Parallel = camera->GetParallelProjection() != 0;
  return view;
}

//------------------------------------------------------------------------------
vtkPointSplatView vtkPointSplatView::Part(const glm::ivec2& first, const glm::ivec2& size) const
{
  vtkPointSplatView part = *this;
  part.Origin += first;
  part.Size = size;
  const glm::dvec4 w(this->PixelW);
  part.PixelX = glm::vec4(glm::dvec4(this->PixelX) - static_cast<double>(first.x) * w);
  part.PixelY = glm::vec4(glm::dvec4(this->PixelY) - static_cast<double>(first.y) * w);
  return part;
}

//------------------------------------------------------------------------------
bool vtkPointSplatView::operator==(const vtkPointSplatView& other) const
{
  // The origin is left out: the same images serve wherever they are presented.
  return this->Size == other.Size && this->WCVC == other.WCVC && this->PixelX == other.PixelX &&
    this->PixelY == other.PixelY && this->PixelW == other.PixelW && this->PixelZ == other.PixelZ &&
    this->Near == other.Near && this->Far == other.Far && this->Parallel == other.Parallel;
}

//------------------------------------------------------------------------------
glm::ivec4 vtkPointSplatView::Cover(
  const glm::dmat4& MCWC, const double bounds[6], double margin) const
{
  const glm::ivec4 all(0, 0, this->Size.x - 1, this->Size.y - 1);
  const glm::dmat4 MCVC = this->WCVC * MCWC;
  glm::dvec2 low(1e30);
  glm::dvec2 high(-1e30);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 p = MCVC *
      glm::dvec4(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
        bounds[4 + ((corner >> 2) & 1)], 1.0);
    // A box of the margin about the corner: its own corners bound its image.
    for (int k = 0; k < 8; ++k)
    {
      const glm::dvec4 q = p +
        glm::dvec4((k & 1) ? margin : -margin, (k & 2) ? margin : -margin,
          (k & 4) ? margin : -margin, 0.0);
      const double w = glm::dot(glm::dvec4(this->PixelW), q);
      if (w <= 1e-9 * (std::abs(q.z) + margin) || !std::isfinite(w))
      {
        return all;
      }
      const glm::dvec2 xy = glm::dvec2(glm::dot(glm::dvec4(this->PixelX), q),
                              glm::dot(glm::dvec4(this->PixelY), q)) / w;
      low = glm::min(low, xy);
      high = glm::max(high, xy);
    }
  }
  // Two pixels more: the prefilter widens what is thinner than a pixel.
  const glm::dvec2 size(this->Size);
  low = glm::clamp(low - 2.0, glm::dvec2(0.0), size);
  high = glm::clamp(high + 2.0, glm::dvec2(-1.0), size - 1.0);
  return { static_cast<int>(std::floor(low.x)), static_cast<int>(std::floor(low.y)),
    static_cast<int>(std::ceil(high.x)), static_cast<int>(std::ceil(high.y)) };
}

//------------------------------------------------------------------------------
glm::dvec2 vtkPointSplatView::PixelSizes(const glm::dmat4& MCWC, const double bounds[6]) const
{
  const glm::dmat4 MCVC = this->WCVC * MCWC;
  double least = 1e300;
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 p = MCVC *
      glm::dvec4(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
        bounds[4 + ((corner >> 2) & 1)], 1.0);
    const double z = std::min(p.z / p.w, -this->Near); // what is nearer is not drawn
    const double w = this->PixelW.z * z + this->PixelW.w;
    least = std::min(least, w);
    most = std::max(most, w);
  }
  return glm::dvec2(least, most) / static_cast<double>(glm::length(glm::vec3(this->PixelX)));
}
