// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCopies.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCodes.h"

#include <algorithm>

namespace
{
constexpr std::size_t NormalWord = 5;
constexpr std::size_t IdWord = 7;
// A cosine: where normals are farther apart they are of two surfaces.
constexpr double LeastAlike = 0.5;
// Splats at one place that each other one is compared with: where more differ, copies stay.
constexpr std::size_t MostCompared = 32;

bool ArePlacesEqual(const uint32_t* a, const uint32_t* b)
{
  return std::equal(a, a + 3, b);
}

/// The sum of the normals of a kept splat and of its copies.
struct Sum
{
  uint32_t* Splat;
  double Normal[3];
  bool Differ;
};

double DotOfNormals(uint32_t a, uint32_t b)
{
  double n[3], m[3];
  vtkPointSplatCodes::DecodeNormal(a, n);
  vtkPointSplatCodes::DecodeNormal(b, m);
  return vtkMath::Dot(n, m);
}

/// Adds a copy's normal to those of its splat, whose sum is among the last ones.
void AddNormal(std::vector<Sum>& sums, uint32_t* splat, uint32_t code)
{
  const auto first = sums.end() - static_cast<std::ptrdiff_t>(std::min(sums.size(), MostCompared));
  auto sum = std::find_if(first, sums.end(), [splat](const Sum& one) { return one.Splat == splat; });
  if (sum == sums.end())
  {
    sums.push_back({ splat, { 0.0, 0.0, 0.0 }, false });
    sum = sums.end() - 1;
    vtkPointSplatCodes::DecodeNormal(splat[NormalWord], sum->Normal);
  }
  double normal[3];
  vtkPointSplatCodes::DecodeNormal(code, normal);
  vtkMath::Add(sum->Normal, normal, sum->Normal);
  sum->Differ = sum->Differ || code != splat[NormalWord];
}

/// Gives splats the means of these normals, where they differ.
void TakeMeans(std::vector<Sum>& sums)
{
  for (Sum& sum : sums)
  {
    if (sum.Differ && vtkMath::Normalize(sum.Normal) > 0.0)
    {
      sum.Splat[NormalWord] = vtkPointSplatCodes::CodeNormal(sum.Normal);
    }
  }
}

/// Of no array, or of one that is too short, all are.
bool AreTuplesEqual(vtkDataArray* array, vtkIdType a, vtkIdType b)
{
  const bool there = array && std::max(a, b) < array->GetNumberOfTuples();
  for (int c = 0; there && c < array->GetNumberOfComponents(); ++c)
  {
    if (array->GetComponent(a, c) != array->GetComponent(b, c))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
std::array<vtkDataArray*, 3> vtkPointSplatCopies::GetTelling(vtkPointSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  return { { arrays->GetTCoords(), arrays->GetTangents(), arrays->GetArray(vtkPointSplatArrays::Group) } };
}

//------------------------------------------------------------------------------
std::size_t vtkPointSplatCopies::TakeOut(
  uint32_t* splats, std::size_t words, std::size_t count, vtkPointSet* data, vtkDataArray* clip)
{
  const std::size_t points = static_cast<std::size_t>(data->GetNumberOfPoints());
  const std::array<vtkDataArray*, 3> telling = vtkPointSplatCopies::GetTelling(data);
  const auto isCopy = [&](const uint32_t* splat, const uint32_t* other) {
    return splat[IdWord] < points && other[IdWord] < points && splat[IdWord] != other[IdWord] &&
      std::equal(splat, splat + NormalWord, other) && splat[NormalWord + 1] == other[NormalWord + 1] &&
      std::equal(splat + IdWord + 1, splat + words, other + IdWord + 1) &&
      (splat[NormalWord] == other[NormalWord] ||
        DotOfNormals(splat[NormalWord], other[NormalWord]) > LeastAlike) &&
      AreTuplesEqual(clip, splat[IdWord], other[IdWord]) &&
      std::all_of(telling.begin(), telling.end(),
        [&](vtkDataArray* array) { return AreTuplesEqual(array, splat[IdWord], other[IdWord]); });
  };
  std::size_t kept = 0;
  const auto findSame = [&](const uint32_t* splat) -> uint32_t* {
    for (std::size_t k = kept; k > 0 && kept - k < MostCompared; --k)
    {
      uint32_t* other = splats + words * (k - 1);
      if (!ArePlacesEqual(splat, other))
      {
        return nullptr;
      }
      if (isCopy(splat, other))
      {
        return other;
      }
    }
    return nullptr;
  };
  std::vector<Sum> sums;
  for (std::size_t i = 0; i < count; ++i)
  {
    const uint32_t* splat = splats + words * i;
    if (uint32_t* same = findSame(splat))
    {
      this->Copies.push_back({ same[IdWord], splat[IdWord] });
      AddNormal(sums, same, splat[NormalWord]);
    }
    else
    {
      std::copy_n(splat, kept != i ? words : 0, splats + words * kept);
      ++kept;
    }
  }
  TakeMeans(sums);
  this->Sort();
  return kept;
}

//------------------------------------------------------------------------------
/// Each once: folded splats are several of one point.
void vtkPointSplatCopies::Sort()
{
  std::sort(this->Copies.begin(), this->Copies.end());
  this->Copies.erase(std::unique(this->Copies.begin(), this->Copies.end()), this->Copies.end());
}

//------------------------------------------------------------------------------
bool vtkPointSplatCopies::HaveSame(vtkDataArray* array) const
{
  return std::all_of(this->Copies.begin(), this->Copies.end(),
    [array](const Copy& copy) { return AreTuplesEqual(array, copy.Of, copy.Point); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatCopies::AreSame(vtkPointSet* data) const
{
  const std::array<vtkDataArray*, 3> telling = vtkPointSplatCopies::GetTelling(data);
  return std::all_of(
    telling.begin(), telling.end(), [this](vtkDataArray* array) { return this->HaveSame(array); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatCopies::AreTogether(vtkPointSet* data) const
{
  return this->HaveSame(data->GetPoints()->GetData()) &&
    this->HaveSame(data->GetPointData()->GetArray(vtkPointSplatArrays::Radius));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkPointSplatCopies::MakeAverage(vtkDataArray* array) const
{
  auto means = vtk::TakeSmartPointer(array->NewInstance());
  means->DeepCopy(array);
  const vtkIdType tuples = array->GetNumberOfTuples();
  for (auto first = this->Copies.begin(); first != this->Copies.end();)
  {
    const auto end = std::find_if(
      first, this->Copies.end(), [&](const Copy& copy) { return copy.Of != first->Of; });
    for (int c = 0; c < array->GetNumberOfComponents() && first->Of < tuples; ++c)
    {
      double sum = array->GetComponent(first->Of, c);
      int count = 1;
      for (auto copy = first; copy != end; ++copy)
      {
        if (copy->Point < tuples)
        {
          sum += array->GetComponent(copy->Point, c);
          ++count;
        }
      }
      means->SetComponent(first->Of, c, sum / count);
    }
    first = end;
  }
  return means;
}
