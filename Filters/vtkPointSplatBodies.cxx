// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBodies.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Points lie on a curve if the second variance is less than this part of the first: 12 neighbours
/// on a circle of a hundred points have 0.008, rows of a surface six times as dense along them as
/// across have more than 0.1.
constexpr float CurveVariance = 0.03f;
/// Tighter curves are seen in their nearest six, if the sphere about twice as many has nearly twice
/// the radius, as on a curve (2) and not in a plane (1.4).
constexpr int FewNeighbors = 6;
constexpr float FewVariance = 0.05f;
constexpr float CurveGrowth = 1.7f;
/// Points fill a volume if the third variance is more than this part of their sum, and the mean
/// squared cosine of the normals with their neighbours' is less than that. In a volume nine of ten
/// points are so, and on a plane with noise of 0.3 spacings 2 of 1000, of 0.5 spacings 40.
constexpr float VolumeVariance = 0.08f;
constexpr float VolumeCosine2 = 0.7f;
/// ... and if this part of the neighbours is so.
constexpr float VolumeShare = 0.75f;
/// How many times the spacing of its neighbours an outlier is away from the nearest.
constexpr float OutlierDistance = 2.0f;
/// What lies along a row does so within 20 degrees.
constexpr float RowCosine = 0.94f;
}

vtkPointSplatBodies::vtkPointSplatBodies(Slot slots)
  : OnCurve(slots, 0)
  , InRow(slots, 0)
  , Scattered(slots, 0)
  , Suspected(slots)
  , Guessed(slots, 0)
{
}

void vtkPointSplatBodies::GetVariances(
  const Neighborhood& around, int count, float variances[3])
{
  double sum[3] = { 0, 0, 0 }, m[6] = { 0, 0, 0, 0, 0, 0 };
  for (int i = 0; i < count; ++i)
  {
    const double d[3] = { around.X[i], around.Y[i], around.Z[i] };
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += d[c];
      m[c] += d[c] * d[c];
      m[3 + c] += d[c] * d[(c + 1) % 3];
    }
  }
  const double n = count + 1; // the centre is one of them
  for (int c = 0; c < 3; ++c)
  {
    m[c] = (m[c] - sum[c] * sum[c] / n) / n;
    m[3 + c] = (m[3 + c] - sum[c] * sum[(c + 1) % 3] / n) / n;
  }
  // Eigenvalues by the trigonometric solution of the characteristic polynomial.
  const double mean = (m[0] + m[1] + m[2]) / 3;
  const double x = m[0] - mean, y = m[1] - mean, z = m[2] - mean;
  const double off = m[3] * m[3] + m[4] * m[4] + m[5] * m[5];
  const double p = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
  const double det = x * (y * z - m[4] * m[4]) - m[3] * (m[3] * z - m[4] * m[5]) +
    m[5] * (m[3] * m[4] - y * m[5]);
  const double cosine = p > 0 ? std::clamp(det / (2 * p * p * p), -1.0, 1.0) : 1.0;
  const double angle = std::acos(cosine) / 3, third = 2 * 3.14159265358979323846 / 3;
  for (int k = 0; k < 3; ++k)
  {
    // The angle is at most a sixth of a turn: so the next is the least, and the last between.
    const double turned = angle + (k == 0 ? 0 : k == 1 ? 2 * third : third);
    variances[k] = static_cast<float>(std::max(mean + 2 * p * std::cos(turned), 0.0));
  }
}

bool vtkPointSplatBodies::IsCurve(const Neighborhood& around, int count)
{
  count = std::min(count, around.Count);
  if (count < 2)
  {
    return false;
  }
  float variances[3];
  GetVariances(around, count, variances);
  if (variances[1] < CurveVariance * variances[0])
  {
    return true;
  }
  if (count < 2 * FewNeighbors ||
    around.SquaredDistance[2 * FewNeighbors - 1] <
      CurveGrowth * CurveGrowth * around.SquaredDistance[FewNeighbors - 1])
  {
    return false;
  }
  return IsRow(around);
}

bool vtkPointSplatBodies::IsRow(const Neighborhood& around)
{
  float variances[3];
  GetVariances(around, std::min(FewNeighbors, around.Count), variances);
  return variances[1] < FewVariance * variances[0];
}

bool vtkPointSplatBodies::IsPartOfCurve(Slot slot, const vtkPointSplatDisks& disks) const
{
  return (this->OnCurve[slot] || this->InRow[slot]) &&
    disks.AgreeWitnesses(slot, this->OnCurve);
}

void vtkPointSplatBodies::Look(const Neighborhood& around, const float* normals)
{
  const Slot s = around.Center;
  this->Guessed[s] = 1;
  this->OnCurve[s] = IsCurve(around, around.Count);
  this->InRow[s] = IsRow(around);
  float variances[3];
  GetVariances(around, around.Count, variances);
  const float* n = normals + std::size_t(3) * s;
  float cosine2 = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
    cosine2 += cosine * cosine;
  }
  if (variances[2] > VolumeVariance * (variances[0] + variances[1] + variances[2]) &&
    cosine2 < VolumeCosine2 * around.Count)
  {
    this->Scattered[s] = 1;
    this->AnyScattered.store(true, std::memory_order_relaxed);
    this->Suspected[s].store(true, std::memory_order_relaxed);
    for (int i = 0; i < around.Count; ++i)
    {
      this->Suspected[around.Slots[i]].store(true, std::memory_order_relaxed);
    }
  }
}

void vtkPointSplatBodies::LookAtRow(const Neighborhood& around, int nearest)
{
  this->OnCurve[around.Center] = IsCurve(around, nearest);
  this->InRow[around.Center] = IsRow(around);
}

void vtkPointSplatBodies::AddRow(
  const Neighborhood& around, const vtkPointSplatSheet& sheet, float length)
{
  Row row;
  row.At = around.Center;
  row.Length = length;
  // The nearest, and the nearest beside the row, since all of the first may be of the row itself, of whose
  // direction the nearest tells.
  std::vector<Slot> models, beside;
  const float first[3] = { around.X[0], around.Y[0], around.Z[0] };
  for (int k = 0; k < sheet.Count; ++k)
  {
    const int i = sheet.Members[k];
    const float dot = first[0] * around.X[i] + first[1] * around.Y[i] + first[2] * around.Z[i];
    const bool isAlong =
      dot * dot > RowCosine * RowCosine * around.SquaredDistance[0] * around.SquaredDistance[i];
    std::vector<Slot>& list = models.size() < NumberOfNearest ? models : beside;
    if (&list == &models || (!isAlong && list.size() < NumberOfModels - NumberOfNearest))
    {
      list.push_back(around.Slots[i]);
    }
  }
  models.insert(models.end(), beside.begin(), beside.end());
  models.resize(NumberOfModels, vtkPointSplatNeighbors::None);
  std::copy(models.begin(), models.end(), row.Models);
  const std::lock_guard<std::mutex> lock(this->RowsMutex);
  this->Rows.push_back(row);
}

bool vtkPointSplatBodies::Finish(vtkAlgorithm* self, double from, double to,
  const vtkPointSplatNeighbors& neighbors, int count, vtkPointSplatDisks& disks)
{
  std::vector<unsigned char> body(this->OnCurve.size(), 0);
  for (std::size_t s = 0; s < body.size(); ++s)
  {
    const Slot slot = static_cast<Slot>(s);
    body[s] = this->Guessed[s] &&
      (this->IsPartOfCurve(slot, disks) || disks.IsOutlier(slot, OutlierDistance));
  }
  auto isVolume = [&](const Neighborhood& around, int) {
    int scattered = 0;
    for (int i = 0; i < around.Count; ++i)
    {
      scattered += this->Scattered[around.Slots[i]];
    }
    if (scattered > 0 && scattered >= VolumeShare * around.Count)
    {
      body[around.Center] = 1;
    }
    return true;
  };
  if (this->AnyScattered.load() &&
    !neighbors.Visit(self, from, to, count, isVolume,
      [this](Slot s) { return this->Guessed[s] && this->Suspected[s].load(); }))
  {
    return false;
  }
  std::vector<const Row*> bends;
  for (const Row& row : this->Rows)
  {
    if (disks.Opening[row.At] > 0 && !disks.HasClosedWitness(row.At))
    {
      bends.push_back(&row);
    }
  }
  for (const Row* bend : bends)
  {
    disks.Open(bend->At, bend->Length);
  }
  // Lengths of points with neighbours all around stay as they are, so that the rows' order is of
  // no concern.
  for (const Row& row : this->Rows)
  {
    const Slot* end = row.Models + NumberOfModels;
    const Slot* model = std::find_if(row.Models, end, [&](Slot m) {
      return m != vtkPointSplatNeighbors::None && disks.Opening[m] > 0;
    });
    if (disks.Opening[row.At] > 0)
    {
      continue; // neighbours that were found later
    }
    if (model != end)
    {
      disks.Length[row.At] = std::max(disks.Length[row.At], disks.Length[*model]);
    }
    else
    {
      body[row.At] = body[row.At] || this->IsPartOfCurve(row.At, disks);
    }
  }
  for (std::size_t s = 0; s < body.size(); ++s)
  {
    if (body[s])
    {
      disks.SetAlone(static_cast<Slot>(s));
    }
  }
  return true;
}

VTK_ABI_NAMESPACE_END
