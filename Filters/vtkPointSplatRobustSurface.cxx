// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRobustSurface.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The support reaches a little past the farthest neighbour, so that it has a weight, too.
constexpr float SupportReach = 1.1f;
/// Steps at most, each a Newton step to the surface and one of reweighting; ten suffice where
/// the samples hold a surface.
constexpr int MaximumSteps = 12;
/// Steps end where the surface is nearer than this, in supports, a three-hundredth of a spacing,
constexpr float NearEnough = 1e-3f;
/// and the squared sine of its normal's turn is less: one degree.
constexpr float StillEnough = 3e-4f;
/// The surface has to be within reach of its samples.
constexpr float LargestMove = 1.0f;
/// The share of neighbours that has to agree with a point's own normal for it to be believed: at
/// a corner of three faces a third does, and on a thin sheet half.
constexpr float BelievedAgreement = 0.25f;
/// One that points the other way is of a thin sheet's other side, unless next to none agrees with
/// the point's own: then that points the wrong way.
constexpr float LonelyAgreement = 0.05f;
/// Where most neighbours agree with it, it is.
constexpr float EnoughAgreement = 0.6f;
/// A point is in the middle of neighbours whose centre is nearer than this share of their mean
/// distance; on the border of a half plane it has 0.64.
constexpr float LargestAside = 0.4f;
/// Normals agree within 60 degrees.
constexpr float AgreeingCosine = 0.5f;
/// Where normals that agree cancel one another to less than this, a crease is near: across one of
/// 36 degrees, half of the samples on each face, their mean has 0.951.
constexpr float EvenNormals = 0.95f;
/// Every so many of the neighbours, nearest first, has its normal tried where the centre's is in
/// doubt.
constexpr int Every = 2;
/// Samples farther off a plane than this, in supports, are not of it, whatever their distance:
/// a third of the mean distance in a kernel's reach of 24 samples.
constexpr float OffPlane = 0.1f;
/// The least weight that is not rounding.
constexpr float LeastWeight = 1e-6f;

/// The value, or 0 where it is negative. Without a branch: compilers turn loops of it into vectors.
inline float GetPositive(float value)
{
  return 0.5f * (value + std::abs(value));
}

/// (1 - t)^4 where t < 1, else 0: the paper's kernel of the squared distance, and near exp(-4 t).
inline float Falloff(float t)
{
  const float a = GetPositive(1 - t);
  return a * a * a * a;
}
}

/// Where the surface is evaluated, in supports, and the normal there as far as it is known.
struct vtkPointSplatRobustSurface::Place
{
  float X[3];
  float N[3];
};

/// What the surface's value and gradient sum over samples, each lane for itself.
struct vtkPointSplatRobustSurface::Sums
{
  enum Name
  {
    Weight,
    Value,
    Square,
    NormalX,
    NormalY,
    NormalZ,
    GradientX, // of the weight
    GradientY,
    GradientZ,
    SlopeX, // the weight's gradient times the value
    SlopeY,
    SlopeZ,
    NumberOfSums
  };
  float Parts[NumberOfSums][Lanes] = {};

  float Get(int name) const
  {
    float sum = 0;
    for (int l = 0; l < Lanes; ++l)
    {
      sum += this->Parts[name][l];
    }
    return sum;
  }
};

vtkPointSplatRobustSurface::vtkPointSplatRobustSurface(
  float normalBandwidth, float residualBandwidth)
  // exp(-(x / sigma)^2) is near Falloff((x / sigma)^2 / 4).
  : NormalScale(0.25f / (normalBandwidth * normalBandwidth))
  , ResidualScale(0.25f / (residualBandwidth * residualBandwidth))
{
}

void vtkPointSplatRobustSurface::Begin(float support, float spacing, const float normal[3])
{
  std::fill_n(this->Offset, 3, 0.0f);
  std::copy_n(normal, 3, this->Normal);
  this->Noise = 0;
  this->Spacing = spacing;
  this->Support = support;
  this->Count = 0;
}

bool vtkPointSplatRobustSurface::Add(const float offset[3], const float normal[3])
{
  const int i = this->Count++;
  this->X[i] = offset[0] / this->Support;
  this->Y[i] = offset[1] / this->Support;
  this->Z[i] = offset[2] / this->Support;
  this->NX[i] = normal[0];
  this->NY[i] = normal[1];
  this->NZ[i] = normal[2];
  return this->Count < MaximumNumberOfSamples;
}

/// Fills up the last lanes.
void vtkPointSplatRobustSurface::End()
{
  this->Padded = (this->Count + Lanes - 1) / Lanes * Lanes;
  for (int i = this->Count; i < this->Padded; ++i)
  {
    // Farther than the centre moves and the kernel reaches together.
    this->X[i] = this->Y[i] = this->Z[i] = 4;
    this->NX[i] = this->NY[i] = this->NZ[i] = 0;
  }
}

void vtkPointSplatRobustSurface::Gather(
  const vtkPointSplatNeighbors::Neighborhood& around, const float* normals)
{
  const float* own = normals + std::size_t(3) * around.Center;
  const float farthest =
    around.Count > 0 ? std::sqrt(around.SquaredDistance[around.Count - 1]) : 0.0f;
  this->Begin(SupportReach * farthest,
    farthest * std::sqrt(static_cast<float>(vtkMath::Pi()) / std::max(around.Count, 1)), own);
  if (around.Count == 0)
  {
    return;
  }
  const float zero[3] = { 0, 0, 0 };
  this->Add(zero, own);
  for (int i = 0; i < around.Count; ++i)
  {
    const float offset[3] = { around.X[i], around.Y[i], around.Z[i] };
    this->Add(offset, normals + std::size_t(3) * around.Slots[i]);
  }
  this->End();
  for (int i = 0; i < this->Padded; ++i)
  {
    this->Weights[i] =
      Falloff(this->X[i] * this->X[i] + this->Y[i] * this->Y[i] + this->Z[i] * this->Z[i]);
  }
}

/// The share of the neighbours whose normals agree with one. Not by weight: the few that came with
/// it from the same scan are the nearest.
float vtkPointSplatRobustSurface::GetAgreement(const float normal[3]) const
{
  int agreeing = 0;
  for (int i = 1; i < this->Count; ++i)
  {
    const float cosine =
      normal[0] * this->NX[i] + normal[1] * this->NY[i] + normal[2] * this->NZ[i];
    agreeing += cosine >= AgreeingCosine ? 1 : 0;
  }
  return static_cast<float>(agreeing) / std::max(1, this->Count - 1);
}

/**
 * Whether the neighbours whose normals agree with one have a sheet that the centre belongs to: it
 * lies within a spacing of their plane, and they lie about it there. At a crease they lie to one
 * side of it, and another side of a thin sheet lies off.
 */
bool vtkPointSplatRobustSurface::IsWithin(const float n[3]) const
{
  float weight = 0, mean[3] = { 0, 0, 0 }, away = 0;
  for (int i = 1; i < this->Count; ++i)
  {
    if (n[0] * this->NX[i] + n[1] * this->NY[i] + n[2] * this->NZ[i] >= AgreeingCosine)
    {
      const float x[3] = { this->X[i], this->Y[i], this->Z[i] };
      weight += this->Weights[i];
      away += this->Weights[i] * vtkMath::Norm(x);
      for (int c = 0; c < 3; ++c)
      {
        mean[c] += this->Weights[i] * x[c];
      }
    }
  }
  const float height = vtkMath::Dot(mean, n);
  const float aside = std::sqrt(std::max(0.0f, vtkMath::Dot(mean, mean) - height * height));
  return std::abs(height) * this->Support <= this->Spacing * weight && aside <= LargestAside * away;
}

/**
 * The normal to begin with: the centre's. Where hardly any neighbour agrees with it, or more agree
 * with another, of a sheet that the centre is in the middle of, the other one.
 */
void vtkPointSplatRobustSurface::FindSheet()
{
  const float own[3] = { this->Normal[0], this->Normal[1], this->Normal[2] };
  const float agreement = this->GetAgreement(own);
  if (agreement >= EnoughAgreement)
  {
    return;
  }
  float best = agreement;
  for (int i = 1; i < this->Count; i += Every)
  {
    const float other[3] = { this->NX[i], this->NY[i], this->NZ[i] };
    const float cosine = vtkMath::Dot(own, other);
    if (cosine < -AgreeingCosine && agreement >= LonelyAgreement)
    {
      continue;
    }
    const float found = this->GetAgreement(other);
    if (found > best && (agreement < BelievedAgreement || (cosine > 0 && this->IsWithin(other))))
    {
      best = found;
      std::copy_n(other, 3, this->Normal);
    }
  }
}

/// The weight of the samples in one sample's plane, each by how far it looks to the same side.
float vtkPointSplatRobustSurface::GetFlatness(int sample) const
{
  constexpr float perOffPlane = 1 / (OffPlane * OffPlane);
  const float x = this->NX[sample], y = this->NY[sample], z = this->NZ[sample];
  const float offset = x * this->X[sample] + y * this->Y[sample] + z * this->Z[sample];
  float sums[Lanes] = {};
  for (int first = 0; first < this->Padded; first += Lanes)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      const int i = first + l;
      const float side = GetPositive(x * this->NX[i] + y * this->NY[i] + z * this->NZ[i]);
      const float height = x * this->X[i] + y * this->Y[i] + z * this->Z[i] - offset;
      sums[l] += side * this->Weights[i] * Falloff(height * height * perOffPlane);
    }
  }
  return std::accumulate(sums, sums + Lanes, 0.0f);
}

/// Near a crease: of the nearest samples' planes, the one that most samples lie in. The centre is
/// on the face that reaches farther about it.
void vtkPointSplatRobustSurface::FindFace()
{
  const float begin[3] = { this->Normal[0], this->Normal[1], this->Normal[2] };
  // Not by weight: the nearest have averages over the crease, perhaps.
  float mean[3] = { 0, 0, 0 };
  int count = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    const float cosine =
      begin[0] * this->NX[i] + begin[1] * this->NY[i] + begin[2] * this->NZ[i];
    const float part = cosine > 0 ? 1.0f : 0.0f;
    count += cosine > 0 ? 1 : 0;
    mean[0] += part * this->NX[i];
    mean[1] += part * this->NY[i];
    mean[2] += part * this->NZ[i];
  }
  if (vtkMath::Norm(mean) >= EvenNormals * count)
  {
    return;
  }
  float best = 0;
  for (int j = 0; j < this->Count; j += Every)
  {
    const float n[3] = { this->NX[j], this->NY[j], this->NZ[j] };
    const float flatness = vtkMath::Dot(n, begin) >= AgreeingCosine ? this->GetFlatness(j) : 0.0f;
    if (flatness > best)
    {
      best = flatness;
      std::copy_n(n, 3, this->Normal);
    }
  }
}

void vtkPointSplatRobustSurface::FindNormal()
{
  if (this->Count > 0)
  {
    this->FindSheet();
    this->FindFace();
  }
}

void vtkPointSplatRobustSurface::Evaluate(const Place& place, bool robust, Sums& sums) const
{
  const float x = place.X[0], y = place.X[1], z = place.X[2];
  const float gx = place.N[0], gy = place.N[1], gz = place.N[2];
  const float residualScale = robust ? this->ResidualScale : 0;
  for (int first = 0; first < this->Padded; first += Lanes)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      const int i = first + l;
      const float dx = x - this->X[i], dy = y - this->Y[i], dz = z - this->Z[i];
      const float nx = this->NX[i], ny = this->NY[i], nz = this->NZ[i];
      const float value =
        0.5f * ((nx + gx) * dx + (ny + gy) * dy + (nz + gz) * dz);
      const float tx = nx - gx, ty = ny - gy, tz = nz - gz;
      const float alpha = Falloff(this->NormalScale * (tx * tx + ty * ty + tz * tz)) *
        Falloff(residualScale * value * value);
      const float a = GetPositive(1 - (dx * dx + dy * dy + dz * dz));
      const float slope = -8 * alpha * a * a * a;
      const float weight = alpha * a * a * a * a;
      sums.Parts[Sums::Weight][l] += weight;
      sums.Parts[Sums::Value][l] += weight * value;
      sums.Parts[Sums::Square][l] += weight * value * value;
      sums.Parts[Sums::NormalX][l] += weight * nx;
      sums.Parts[Sums::NormalY][l] += weight * ny;
      sums.Parts[Sums::NormalZ][l] += weight * nz;
      sums.Parts[Sums::GradientX][l] += slope * dx;
      sums.Parts[Sums::GradientY][l] += slope * dy;
      sums.Parts[Sums::GradientZ][l] += slope * dz;
      sums.Parts[Sums::SlopeX][l] += slope * dx * value;
      sums.Parts[Sums::SlopeY][l] += slope * dy * value;
      sums.Parts[Sums::SlopeZ][l] += slope * dz * value;
    }
  }
}

bool vtkPointSplatRobustSurface::Project()
{
  if (this->Count < 4)
  {
    // Three points and fewer lie in a plane, whatever their surface.
    return false;
  }
  this->End();
  Place place = { { 0, 0, 0 }, { this->Normal[0], this->Normal[1], this->Normal[2] } };
  float deviation = 0;
  for (int step = 0; step < MaximumSteps; ++step)
  {
    Sums sums;
    this->Evaluate(place, step > 0, sums);
    const float weight = sums.Get(Sums::Weight);
    if (!(weight > LeastWeight))
    {
      return false;
    }
    const float value = sums.Get(Sums::Value) / weight;
    deviation = sums.Get(Sums::Square) / weight;
    float gradient[3];
    for (int c = 0; c < 3; ++c)
    {
      gradient[c] = (sums.Get(Sums::SlopeX + c) - value * sums.Get(Sums::GradientX + c) +
                      sums.Get(Sums::NormalX + c)) /
        weight;
    }
    if (!(vtkMath::Normalize(gradient) > 0))
    {
      return false;
    }
    float turn = 0, move = 0;
    for (int c = 0; c < 3; ++c)
    {
      turn += (gradient[c] - place.N[c]) * (gradient[c] - place.N[c]);
      place.N[c] = gradient[c];
      place.X[c] -= value * gradient[c];
      move += place.X[c] * place.X[c];
    }
    if (!(move <= LargestMove * LargestMove))
    {
      return false;
    }
    if (step > 0 && std::abs(value) <= NearEnough && turn <= StillEnough)
    {
      break;
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    this->Offset[c] = place.X[c] * this->Support;
    this->Normal[c] = place.N[c];
  }
  this->Noise = std::sqrt(std::max(0.0f, deviation)) * this->Support / this->Spacing;
  return true;
}

VTK_ABI_NAMESPACE_END
