// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBodies.h"

#include "vtkPointSplatRows.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
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

bool vtkPointSplatBodies::IsPartOfCurve(Slot slot, const vtkPointSplatDisks& disks) const
{
  return (this->OnCurve[slot] || this->InRow[slot]) &&
    disks.AgreeWitnesses(slot, this->OnCurve);
}

void vtkPointSplatBodies::Look(const Neighborhood& around, const float* normals,
  const std::vector<unsigned char>& onSurface)
{
  const Slot s = around.Center;
  this->Guessed[s] = 1;
  const vtkPointSplatPrincipal principal(around);
  const float* variances = principal.Variances;
  this->OnCurve[s] = vtkPointSplatRows::IsCurve(around, around.Count, variances);
  this->InRow[s] = vtkPointSplatRows::IsRow(around);
  const float* n = normals + std::size_t(3) * s;
  float cosine2 = 0;
  int surface = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    surface += onSurface[around.Slots[i]];
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
    cosine2 += cosine * cosine;
  }
  if (variances[2] > VolumeVariance * (variances[0] + variances[1] + variances[2]) &&
    cosine2 < VolumeCosine2 * around.Count && !(onSurface[s] && 2 * surface > around.Count))
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
  const int count = std::min(nearest, around.Count);
  const vtkPointSplatPrincipal principal(around, count);
  this->OnCurve[around.Center] = vtkPointSplatRows::IsCurve(around, count, principal.Variances);
  this->InRow[around.Center] = vtkPointSplatRows::IsRow(around);
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

void vtkPointSplatBodies::ForgetRows(const std::vector<unsigned char>& slots)
{
  this->Rows.erase(
    std::remove_if(this->Rows.begin(), this->Rows.end(), [&slots](const Row& row) { return slots[row.At] != 0; }),
    this->Rows.end());
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
      disks.Lengthen(row.At, disks.Length[*model]);
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
