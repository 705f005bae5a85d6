// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCoordinates.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSplatCodes.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPThreadLocal.h"
#include "vtkStaticPointLocator.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace
{
using Splats = vtkPointSplatCoordinates::Splats;

/// Points that a change is fitted to, with the splat's own.
constexpr int MostNeighbours = 17;
/// Of how much farther off a point counts for that lies out of the splat's plane.
constexpr double PlaneWeight = 16.0;
/// A fit is good where it errs by less than this share of the greatest difference of coordinates.
constexpr double GoodError = 0.25;
/// Neighbours that a proposed change is judged by.
constexpr double TypicalShare = 0.4;
/// Of several that fit as well, on a grid's seam those to a row beyond and to what is along it, the
/// least counts: how much of a change counts as an error.
constexpr double LeastChange = 0.1;
/// Neighbours whose coordinates go on err by no more than so many times what is typical.
constexpr double InlierErrors = 3.0;

/// A neighbour: its offset by the splat's axes, the difference of coordinates, its weight.
struct Neighbour
{
  glm::dvec2 At;
  glm::dvec2 Difference;
  double Weight;
};

/// Changes of the coordinates along the axes, its columns.
using Change = glm::dmat2;

glm::dvec3 PositionOf(const Splats& splats, vtkIdType i)
{
  float p[3];
  std::memcpy(p, splats.Data + splats.WordsPerSplat * static_cast<size_t>(i), sizeof(p));
  return glm::dvec3(p[0], p[1], p[2]);
}

vtkIdType PointOf(const Splats& splats, vtkIdType i)
{
  return splats.Data[splats.WordsPerSplat * static_cast<size_t>(i) + 7];
}

/// The axes, in units of which uniforms and codes have a place on the splat.
void AxesOf(const Splats& splats, vtkIdType i, glm::dvec3& first, glm::dvec3& second)
{
  double s[3];
  double t[3];
  vtkPointSplatCodes::AxesOf(
    splats.Data + splats.WordsPerSplat * static_cast<size_t>(i), splats.Circular, s, t);
  first = glm::dvec3(s[0], s[1], s[2]);
  second = glm::dvec3(t[0], t[1], t[2]);
}

double ErrorOf(const Change& change, const Neighbour& n)
{
  return glm::length(n.Difference - change * n.At);
}

Change Fit(const std::vector<Neighbour>& all)
{
  glm::dmat2 squares(0.0);
  Change sums(0.0); // of differences times offsets
  for (const Neighbour& n : all)
  {
    squares += n.Weight * glm::outerProduct(n.At, n.At);
    sums += n.Weight * glm::outerProduct(n.Difference, n.At);
  }
  // Points in a row say nothing of the change across it: then there is none.
  const double trace = squares[0][0] + squares[1][1];
  squares += glm::dmat2(1e-6 * trace + 1e-300);
  return sums * glm::inverse(squares);
}

double GreatestError(const Change& change, const std::vector<Neighbour>& all)
{
  double most = 0.0;
  for (const Neighbour& n : all)
  {
    most = std::max(most, ErrorOf(change, n));
  }
  return most;
}

/// Of the errors by the distance that which TypicalShare of all do not exceed: less than a half,
/// since on a seam as many neighbours are of the other side, and more where points are there twice.
double TypicalError(const Change& change, const std::vector<Neighbour>& all)
{
  std::array<double, MostNeighbours> errors{};
  size_t count = 0;
  for (const Neighbour& n : all)
  {
    errors[count++] = ErrorOf(change, n) / glm::length(n.At);
  }
  const auto typical =
    errors.begin() + static_cast<std::ptrdiff_t>(TypicalShare * static_cast<double>(count));
  std::nth_element(errors.begin(), typical, errors.begin() + static_cast<std::ptrdiff_t>(count));
  return *typical;
}

/// A change that most neighbours agree with, and by how much they do not.
struct Proposal
{
  Change Best{ 0.0 };
  double Error = 1e300;
};

Proposal FitRobustly(const std::vector<Neighbour>& all)
{
  Proposal proposal;
  for (size_t a = 0; a < all.size(); ++a)
  {
    for (size_t b = a + 1; b < all.size(); ++b)
    {
      const glm::dmat2 at(all[a].At, all[b].At);
      const double across = std::abs(glm::determinant(at));
      if (across < 0.3 * glm::length(at[0]) * glm::length(at[1]))
      {
        continue;
      }
      const Change change = Change(all[a].Difference, all[b].Difference) * glm::inverse(at);
      const double error = TypicalError(change, all) +
        LeastChange * std::sqrt(glm::dot(change[0], change[0]) + glm::dot(change[1], change[1]));
      if (error < proposal.Error)
      {
        proposal = { change, error };
      }
    }
  }
  // What rounding of coordinates leaves of errors is none.
  const Change& best = proposal.Best;
  const double bound = InlierErrors * TypicalError(best, all) +
    1e-3 * std::max(glm::length(best[0]), glm::length(best[1]));
  std::vector<Neighbour> inliers;
  std::copy_if(all.begin(), all.end(), std::back_inserter(inliers), [&](const Neighbour& n) {
    return ErrorOf(best, n) <= bound * glm::length(n.At);
  });
  proposal.Best = inliers.size() < 2 ? best : Fit(inliers);
  return proposal;
}

Change ChangeOf(const std::vector<Neighbour>& all)
{
  const Change change = Fit(all);
  double most = 0.0;
  for (const Neighbour& n : all)
  {
    most = std::max(most, glm::length(n.Difference));
  }
  if (GreatestError(change, all) <= GoodError * most)
  {
    return change;
  }
  // Where a texture repeats, coordinates may be less or more by whole numbers on the other side.
  std::vector<Neighbour> wrapped = all;
  for (Neighbour& n : wrapped)
  {
    n.Difference -= glm::round(n.Difference);
  }
  const Proposal plain = FitRobustly(all);
  const Proposal repeated = FitRobustly(wrapped);
  return repeated.Error < plain.Error ? repeated.Best : plain.Best;
}

/// Coordinates of points; what has one component is a row of texels.
struct Reader
{
  vtkDataArray* Array;
  glm::dvec2 operator()(vtkIdType point) const
  {
    return glm::dvec2(this->Array->GetComponent(point, 0),
      this->Array->GetNumberOfComponents() > 1 ? this->Array->GetComponent(point, 1) : 0.0);
  }
};

bool IsFinite(const glm::dvec2& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y);
}

/// A polydata of the points of splats, each once, and which splat is of each.
vtkSmartPointer<vtkPolyData> PointsOf(
  const Splats& splats, const Reader& read, std::vector<vtkIdType>& splatOf)
{
  vtkNew<vtkPoints> points;
  vtkIdType most = -1;
  for (vtkIdType i = 0; i < splats.Count; ++i)
  {
    most = std::max(most, PointOf(splats, i));
  }
  std::vector<bool> there(static_cast<size_t>(most + 1), false);
  for (vtkIdType i = 0; i < splats.Count; ++i)
  {
    const vtkIdType point = PointOf(splats, i);
    if (!there[static_cast<size_t>(point)] && IsFinite(read(point)))
    {
      there[static_cast<size_t>(point)] = true;
      const glm::dvec3 p = PositionOf(splats, i);
      points->InsertNextPoint(p.x, p.y, p.z);
      splatOf.push_back(i);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatCoordinates::Make(
  const Splats& splats, vtkDataArray* coordinates, uint32_t* codes)
{
  const Reader read{ coordinates };
  std::vector<vtkIdType> splatOf;
  const vtkSmartPointer<vtkPolyData> points = PointsOf(splats, read, splatOf);
  vtkNew<vtkStaticPointLocator> locator;
  if (!splatOf.empty())
  {
    locator->SetDataSet(points);
    locator->BuildLocator();
  }
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkPointSplatThreads::For(0, splats.Count, [&](vtkIdType begin, vtkIdType end) {
    vtkIdList* nearest = lists.Local();
    std::vector<Neighbour> all;
    for (vtkIdType i = begin; i < end; ++i)
    {
      uint32_t* code = codes + Words * static_cast<size_t>(i);
      const glm::dvec2 own = read(PointOf(splats, i));
      code[0] = code[1] = None;
      code[2] = code[3] = 0;
      if (!IsFinite(own))
      {
        continue;
      }
      code[0] = vtkPointSplatCodes::Bits(own.x);
      code[1] = vtkPointSplatCodes::Bits(own.y);
      const glm::dvec3 p = PositionOf(splats, i);
      glm::dvec3 first;
      glm::dvec3 second;
      AxesOf(splats, i, first, second);
      const glm::dvec3 normal = glm::cross(first, second);
      const double area = glm::length(normal);
      if (!(area > 0.0))
      {
        continue; // without sizes
      }
      locator->FindClosestNPoints(MostNeighbours, &p.x, nearest);
      all.clear();
      for (vtkIdType k = 0; k < nearest->GetNumberOfIds(); ++k)
      {
        const vtkIdType other = splatOf[static_cast<size_t>(nearest->GetId(k))];
        const glm::dvec3 d = PositionOf(splats, other) - p;
        const glm::dvec2 at(glm::dot(d, first) / glm::dot(first, first),
          glm::dot(d, second) / glm::dot(second, second));
        const double square = glm::dot(at, at);
        const double height = glm::dot(d, normal) / area;
        const double off = height * height / area;
        if (square > 1e-8)
        {
          all.push_back(
            { at, read(PointOf(splats, other)) - own, 1.0 / (square + PlaneWeight * off) });
        }
      }
      const Change change = all.size() < 2 ? Change(0.0) : ChangeOf(all);
      code[2] = glm::packHalf2x16(glm::vec2(change[0]));
      code[3] = glm::packHalf2x16(glm::vec2(change[1]));
    }
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatCoordinates::MakeTangents(
  const Splats& splats, vtkDataArray* tangents, uint32_t* codes)
{
  vtkPointSplatThreads::For(0, splats.Count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double t[3];
      for (int k = 0; k < 3; ++k)
      {
        t[k] = tangents->GetComponent(PointOf(splats, i), k);
      }
      const double length = vtkMath::Norm(t);
      const double any[3] = { 1.0, 0.0, 0.0 };
      vtkMath::MultiplyScalar(t, 1.0 / length);
      codes[i] = vtkPointSplatCodes::CodeNormal(length > 0.0 && std::isfinite(length) ? t : any);
    }
  });
}
