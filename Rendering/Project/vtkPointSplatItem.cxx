// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatItem.h"

#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointSplatProgram.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkPointSplatItem::ClipPlanesOf(vtkMapper* mapper)
{
  std::vector<glm::dvec4> result;
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    vtkPlane* plane = nullptr;
    while (result.size() < MostClipPlanes && (plane = planes->GetNextPlane(it)))
    {
      const double* n = plane->GetNormal();
      result.emplace_back(n[0], n[1], n[2], -vtkMath::Dot(n, plane->GetOrigin()));
    }
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkPointSplatItem::operator==(const vtkPointSplatItem& other) const
{
  return this->Cloud == other.Cloud && this->MCWC == other.MCWC && this->Slot == other.Slot &&
    this->Culling == other.Culling && this->RadiusScale == other.RadiusScale &&
    this->UsualRadius == other.UsualRadius &&
    this->StrideShift == other.StrideShift && this->LayerDistance == other.LayerDistance &&
    this->LayerRadii == other.LayerRadii && this->Kernel == other.Kernel &&
    this->ClipPlanes == other.ClipPlanes && this->Colour == other.Colour &&
    this->Opacities == other.Opacities && this->CoveringScale == other.CoveringScale &&
    this->Factors == other.Factors &&
    this->FactorCount == other.FactorCount && this->FactorVersion == other.FactorVersion &&
    this->IsFlat == other.IsFlat && this->Look == other.Look &&
    this->IsPoints == other.IsPoints && this->Points == other.Points &&
    this->Levels == other.Levels && this->IsStreamed == other.IsStreamed &&
    this->TrianglePixels == other.TrianglePixels;
}

//------------------------------------------------------------------------------
glm::vec4 vtkPointSplatItem::GetValueMap(size_t first) const
{
  if (!this->Cloud->HasValues())
  {
    return glm::vec4(this->Cloud->HasCellColours() ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f);
  }
  const std::array<double, 2>& scale = this->Cloud->GetValueScale();
  return glm::vec4(first, this->Cloud->GetValueTable().size() - 1, scale[0], scale[1]);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkPointSplatItem::GetMCVC(const vtkPointSplatView& view) const
{
  // In double precision: only the product of a far camera and a far cloud is small.
  const auto& origin = this->Cloud->GetOrigin();
  glm::dmat4 MCVC = view.WCVC * this->MCWC;
  MCVC[3] = MCVC * glm::dvec4(origin[0], origin[1], origin[2], 1.0);
  return MCVC;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkPointSplatItem::GetClipPlanesVC(const vtkPointSplatView& view) const
{
  std::vector<glm::dvec4> planes;
  const glm::dmat4 VCWCTransposed = glm::transpose(glm::inverse(view.WCVC));
  for (const glm::dvec4& plane : this->ClipPlanes)
  {
    planes.emplace_back(VCWCTransposed * plane);
  }
  return planes;
}

//------------------------------------------------------------------------------
double vtkPointSplatItem::GetStretch() const
{
  const glm::dmat3 linear(this->MCWC);
  return std::sqrt(
    glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) + glm::dot(linear[2], linear[2]));
}

//------------------------------------------------------------------------------
double vtkPointSplatItem::GetMeanStretch() const
{
  return this->GetStretch() / std::sqrt(3.0);
}

//------------------------------------------------------------------------------
double vtkPointSplatItem::GetStrideScale() const
{
  return std::exp2(0.5 * this->StrideShift);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatItem::GetNumberOfInvocations() const
{
  const vtkIdType size = vtkIdType(1) << this->GetBlockShift();
  const vtkIdType blocks = this->Runs ? static_cast<vtkIdType>(this->Runs->Runs.size())
                                      : (this->Cloud->GetNumberOfSplats() + size - 1) / size;
  return blocks * (size >> this->StrideShift);
}

//------------------------------------------------------------------------------
double vtkPointSplatItem::GetLargestRadius() const
{
  return std::max({ this->Cloud->GetMaximumRadius(), this->UsualRadius,
    this->Runs ? this->Runs->LargestRadius : 0.0 });
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatItem::Upload(const vtkPointSplatCloud::IdKind* ids) const
{
  // Triangles' corners are among all splats.
  return this->IsStreamed && this->Runs && this->TrianglePixels == 0.0 ? this->Cloud->UploadRuns(this->Runs, ids)
    : ids                                                              ? this->Cloud->UploadIds(*ids)
                                                                       : this->Cloud->Upload();
}

//------------------------------------------------------------------------------
void vtkPointSplatItem::SetBlockUniforms(vtkPointSplatProgram& program) const
{
  program.Set("InvocationCount", static_cast<unsigned int>(this->GetNumberOfInvocations()));
  program.Set("SplatCount", static_cast<unsigned int>(this->Runs ? this->Cloud->GetNumberOfStoredSplats()
                                         : this->Cloud->GetNumberOfSplats()));
  program.Set("StrideShift", this->StrideShift);
  program.Set("BlockShift", this->GetBlockShift());
  program.Set("DrawBlocks", this->Runs != nullptr);
}

//------------------------------------------------------------------------------
void vtkPointSplatItem::SetUniforms(
  vtkPointSplatProgram& program, const vtkPointSplatView& view) const
{
  const glm::dmat4 MCVC = this->GetMCVC(view);
  const std::vector<glm::dvec4> clip = this->GetClipPlanesVC(view);
  program.Set("MCVC", glm::mat4(MCVC));
  program.Set("NormalMatrix", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(MCVC)))));
  program.Set("PixelX", view.PixelX);
  program.Set("PixelY", view.PixelY);
  program.Set("PixelW", view.PixelW);
  program.Set("Window", this->Window);
  program.Set("DepthRange",
    glm::vec2(static_cast<float>(view.Near), static_cast<float>(view.Far - view.Near)));
  program.Set("Parallel", view.Parallel);
  program.Set("Circular", this->Cloud->IsCircular());
  program.Set("RadiusScale", static_cast<float>(this->RadiusScale * this->GetStrideScale()));
  program.Set("UsualRadius", static_cast<float>(this->UsualRadius));
  program.Set("Culling", this->Culling);
  program.Set("NormalBend", this->IsFlat ? 0.0f : 1.0f);
  program.Set("Tag", static_cast<unsigned int>(this->Slot) << 1);
  program.Set("LayerDistance", static_cast<float>(this->LayerDistance));
  program.Set("LayerRadii", static_cast<float>(this->LayerRadii / this->GetStrideScale()));
  program.Set("ClipPlaneCount", static_cast<int>(clip.size()));
  program.Set("ClipPlanes", std::vector<glm::vec4>(clip.begin(), clip.end()));
  program.Set("KernelSupport", static_cast<float>(this->Kernel.Support));
}
