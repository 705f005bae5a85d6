// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatGrouping.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatBatches.h"
#include "vtkPointSplatColoring.h"
#include "vtkPointSplatCoverage.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatOverlap.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatGrouping);

namespace
{
// Edges beyond which radii or points cannot be what they should be.
constexpr std::size_t MostEdgesPerSplat = 64;
constexpr std::size_t MostEdgesOfFew = 4000000;
// No group's radii grow by more: it would reach to other parts of the body.
constexpr double MostScale = 4.0;

bool Finite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

vtkDataArray* ArrayOf(vtkPointSet* data, const char* name, int components)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == data->GetNumberOfPoints()
    ? array
    : nullptr;
}

/// Arrays without one tuple a point cannot be read by points.
void RemoveMisshapen(vtkPointData* data, vtkIdType count)
{
  for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (data->GetAbstractArray(a)->GetNumberOfTuples() != count)
    {
      data->RemoveArray(a);
    }
  }
}
}

/**
 * The points that are splats, with what grouping wants of them.
 */
struct vtkPointSplatGrouping::Splats
{
  std::vector<vtkIdType> Ids;
  std::vector<double> Positions; // from the first splat
  std::vector<double> Normals;
  std::vector<double> Radii; // times Reach
  vtkUnsignedCharArray* Colors = nullptr;

  vtkPointSplatOverlap::Index Count() const
  {
    return static_cast<vtkPointSplatOverlap::Index>(this->Ids.size());
  }
};

//------------------------------------------------------------------------------
vtkPointSplatGrouping::vtkPointSplatGrouping() = default;
vtkPointSplatGrouping::~vtkPointSplatGrouping() = default;

//------------------------------------------------------------------------------
int vtkPointSplatGrouping::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
double vtkPointSplatGrouping::GetGroupCoverageBefore(int group)
{
  return group >= 0 && group < static_cast<int>(this->Figures.size()) ? this->Figures[group].Before
                                                                       : 0;
}

//------------------------------------------------------------------------------
double vtkPointSplatGrouping::GetGroupCoverage(int group)
{
  return group >= 0 && group < static_cast<int>(this->Figures.size()) ? this->Figures[group].After
                                                                       : 0;
}

//------------------------------------------------------------------------------
double vtkPointSplatGrouping::GetGroupRadiusScale(int group)
{
  return group >= 0 && group < static_cast<int>(this->Figures.size()) ? this->Figures[group].Scale
                                                                       : 1;
}

//------------------------------------------------------------------------------
bool vtkPointSplatGrouping::Color(const Splats& splats, std::vector<int>& colors)
{
  const auto count = splats.Count();
  const double leastCosine = std::cos(vtkMath::RadiansFromDegrees(this->CoplanarAngle));
  const double mostSine = std::sin(vtkMath::RadiansFromDegrees(this->CoplanarAngle));
  auto keep = [&](std::uint32_t i, std::uint32_t j) {
    const double* n = &splats.Normals[3 * std::size_t(i)];
    const double* m = &splats.Normals[3 * std::size_t(j)];
    const double facing = vtkMath::Dot(n, m);
    if (this->IgnoreOpposite && facing < 0)
    {
      return false;
    }
    if (this->CoplanarAngle > 0 && facing >= leastCosine)
    {
      const double* p = &splats.Positions[3 * std::size_t(i)];
      const double* q = &splats.Positions[3 * std::size_t(j)];
      const double d[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
      const double off = mostSine * vtkMath::Norm(d);
      bool alike = std::abs(vtkMath::Dot(d, n)) <= off && std::abs(vtkMath::Dot(d, m)) <= off;
      for (int c = 0; alike && splats.Colors && c < splats.Colors->GetNumberOfComponents(); ++c)
      {
        const int a = splats.Colors->GetTypedComponent(splats.Ids[i], c);
        const int b = splats.Colors->GetTypedComponent(splats.Ids[j], c);
        alike = std::abs(a - b) <= this->ColorTolerance;
      }
      return !alike;
    }
    return true;
  };
  vtkPointSplatOverlap graph;
  const bool relaxed = this->IgnoreOpposite || this->CoplanarAngle > 0;
  if (!graph.Build(splats.Positions.data(), splats.Radii.data(), count, this->OverlapFactor,
        std::max<std::size_t>(MostEdgesPerSplat * count, MostEdgesOfFew),
        relaxed ? std::function<bool(std::uint32_t, std::uint32_t)>(keep) : nullptr))
  {
    vtkErrorMacro("Each splat overlaps more than " << 2 * MostEdgesPerSplat
                                                   << " others on average: look whether "
                                                   << vtkPointSplatArrays::Radius
                                                   << " is in the points' unit, remove duplicate "
                                                      "points, or lower OverlapFactor.");
    return false;
  }
  this->UpdateProgress(0.5);
  if (vtkPointSplatBatches::IsAborted(this))
  {
    return false;
  }
  std::size_t largest = 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    largest = std::max(largest, graph.GetDegree(i));
  }
  this->MaximumDegree = static_cast<vtkIdType>(largest);
  this->MeanDegree = count ? 2.0 * graph.GetNumberOfEdges() / count : 0;

  this->NumberOfGroups = vtkPointSplatColoring::LargestFirst(graph, colors);
  this->UpdateProgress(0.6);
  if (this->Coloring == Weighted && count > 0)
  {
    const std::vector<float> weights = vtkPointSplatColoring::OverlapAreas(
      graph, splats.Positions.data(), splats.Radii.data());
    // Weights are in units of a splat's mean area.
    const std::vector<int> first = colors;
    int few = 0; // that leave too much, or as many as are wanted
    int enough = this->NumberOfGroups;
    double left = 0;
    if (this->WantedNumberOfGroups > 0)
    {
      enough = this->WantedNumberOfGroups;
      left = vtkPointSplatColoring::Weighted(graph, weights, first, enough, colors);
    }
    while (this->WantedNumberOfGroups == 0 && enough - few > 1)
    {
      const int middle = (few + enough) / 2;
      std::vector<int> tried;
      const double remains =
        vtkPointSplatColoring::Weighted(graph, weights, first, middle, tried);
      if (remains <= this->MaximumOverlap * count)
      {
        enough = middle;
        left = remains;
        colors = std::move(tried);
      }
      else
      {
        few = middle;
      }
      if (vtkPointSplatBatches::IsAborted(this))
      {
        return false;
      }
    }
    this->NumberOfGroups = enough;
    this->OverlapWithinGroups = left / count;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatGrouping::Cover(const Splats& splats, const std::vector<int>& colors,
  vtkPointSet* input, vtkPolyData* output)
{
  using Index = vtkPointSplatOverlap::Index;
  // Measuring looks at each overlap many times: also of few splats, too many have no end.
  vtkPointSplatOverlap graph;
  if (!graph.Build(splats.Positions.data(), splats.Radii.data(), splats.Count(), 1.0,
        std::max<std::size_t>(MostEdgesPerSplat * splats.Count(), 10000)))
  {
    vtkErrorMacro("Each splat overlaps more than " << 2 * MostEdgesPerSplat
                                                   << " others on average: groups are left without "
                                                      "coverage. Look whether "
                                                   << vtkPointSplatArrays::Radius
                                                   << " is in the points' unit, or lower Reach.");
    return;
  }
  const vtkPointSplatCoverage coverage(
    splats.Positions.data(), splats.Normals.data(), splats.Radii.data(), graph);
  std::vector<std::vector<Index>> groups(this->NumberOfGroups);
  for (Index i = 0; i < splats.Count(); ++i)
  {
    groups[colors[i]].push_back(i);
  }
  this->Figures.assign(this->NumberOfGroups, GroupFigures());
  std::vector<std::pair<vtkIdType, int>> copies; // of a point, to a group
  vtkNew<vtkDoubleArray> shares;
  shares->SetName(vtkPointSplatArrays::GroupCoverage);
  for (int k = 0; k < this->NumberOfGroups; ++k)
  {
    this->UpdateProgress(0.7 + 0.2 * k / this->NumberOfGroups);
    if (vtkPointSplatBatches::IsAborted(this))
    {
      return;
    }
    GroupFigures& figures = this->Figures[k];
    vtkPointSplatCoverage::Cover cover = coverage.Measure(groups[k]);
    figures.Before = cover.GetShare(1.0);
    if (this->Coverage == Duplicate)
    {
      for (const Index i : coverage.Fill(groups[k], this->MaximumClipped))
      {
        copies.emplace_back(splats.Ids[i], k);
        groups[k].push_back(i);
      }
      cover = coverage.Measure(groups[k]);
    }
    else
    {
      figures.Scale = cover.GetFullScale(MostScale);
    }
    figures.After = cover.GetShare(figures.Scale);
    shares->InsertNextValue(cover.GetShare(figures.Scale / this->Reach));
  }
  this->NumberOfDuplicates = static_cast<vtkIdType>(copies.size());
  output->GetFieldData()->AddArray(shares);

  const vtkIdType count = input->GetNumberOfPoints();
  auto* group = vtkIntArray::SafeDownCast(
    output->GetPointData()->GetAbstractArray(vtkPointSplatArrays::Group));
  if (this->Coverage == Enlarge)
  {
    for (const char* name :
      { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1, vtkPointSplatArrays::Axis2 })
    {
      if (vtkDataArray* given = output->GetPointData()->GetArray(name))
      {
        auto scaled = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
        scaled->DeepCopy(given);
        for (vtkIdType id = 0; id < count; ++id)
        {
          const int k = group->GetValue(id);
          for (int c = 0; k >= 0 && c < scaled->GetNumberOfComponents(); ++c)
          {
            scaled->SetComponent(id, c, this->Figures[k].Scale * scaled->GetComponent(id, c));
          }
        }
        output->GetPointData()->AddArray(scaled);
      }
    }
  }
  else
  {
    // All points, then the copies.
    vtkNew<vtkPoints> points;
    points->SetDataType(input->GetPoints()->GetDataType());
    points->DeepCopy(input->GetPoints());
    points->Resize(count + this->NumberOfDuplicates);
    vtkNew<vtkPointData> data;
    data->CopyAllOn();
    data->CopyAllocate(output->GetPointData(), count + this->NumberOfDuplicates);
    data->CopyData(output->GetPointData(), 0, count, 0);
    double x[3];
    for (const auto& copy : copies)
    {
      input->GetPoints()->GetPoint(copy.first, x);
      data->CopyData(output->GetPointData(), copy.first, points->InsertNextPoint(x));
    }
    auto* grown = vtkIntArray::SafeDownCast(data->GetAbstractArray(vtkPointSplatArrays::Group));
    for (std::size_t c = 0; c < copies.size(); ++c)
    {
      grown->SetValue(count + static_cast<vtkIdType>(c), copies[c].second);
    }
    output->SetPoints(points);
    output->GetPointData()->ShallowCopy(data);
  }
  if (!input->GetPointData()->GetAbstractArray(vtkPointSplatArrays::OriginalIds))
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(vtkPointSplatArrays::OriginalIds);
    for (vtkIdType id = 0; id < count; ++id)
    {
      ids->InsertNextValue(id);
    }
    for (const auto& copy : copies)
    {
      ids->InsertNextValue(copy.first);
    }
    output->GetPointData()->AddArray(ids);
  }
}

//------------------------------------------------------------------------------
int vtkPointSplatGrouping::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->NumberOfGroups = 0;
  this->MaximumDegree = 0;
  this->MeanDegree = 0;
  this->NumberOfSkippedPoints = 0;
  this->NumberOfDuplicates = 0;
  this->OverlapWithinGroups = 0;
  this->Figures.clear();
  const vtkIdType count = input->GetNumberOfPoints();
  output->GetPointData()->PassData(input->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  if (count == 0)
  {
    return 1;
  }
  if (count >= static_cast<vtkIdType>(std::numeric_limits<vtkPointSplatOverlap::Index>::max()))
  {
    vtkErrorMacro(<< count << " points are too many for one data set; group blocks of it.");
    return 1;
  }
  output->SetPoints(input->GetPoints());
  RemoveMisshapen(output->GetPointData(), count);

  vtkDataArray* normals = input->GetPointData()->GetNormals();
  vtkDataArray* radius = ArrayOf(input, vtkPointSplatArrays::Radius, 1);
  vtkDataArray* axes[2] = { ArrayOf(input, vtkPointSplatArrays::Axis1, 3),
    ArrayOf(input, vtkPointSplatArrays::Axis2, 3) };
  vtkNew<vtkPointSplatEstimation> estimation;
  if (!normals || !(radius || (axes[0] && axes[1])))
  {
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(input->GetPoints());
    bare->GetPointData()->SetNormals(normals);
    if (vtkDataArray* ghosts = ArrayOf(input, vtkDataSetAttributes::GhostArrayName(), 1))
    {
      bare->GetPointData()->AddArray(ghosts);
    }
    estimation->SetInputData(bare);
    estimation->Update();
    vtkPointData* estimated = estimation->GetOutput()->GetPointData();
    normals = estimated->GetNormals();
    radius = estimated->GetArray(vtkPointSplatArrays::Radius);
    axes[0] = axes[1] = nullptr;
    output->GetPointData()->SetNormals(normals);
    output->GetPointData()->AddArray(radius);
    output->GetPointData()->AddArray(estimated->GetArray(vtkPointSplatArrays::PlaneNormal));
    for (const char* name : { vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
    {
      if (vtkDataArray* lines = estimated->GetArray(name))
      {
        output->GetPointData()->AddArray(lines);
      }
    }
  }
  this->UpdateProgress(0.2);

  vtkNew<vtkIntArray> group;
  group->SetName(vtkPointSplatArrays::Group);
  group->SetNumberOfTuples(count);
  group->FillValue(-1);
  output->GetPointData()->AddArray(group);

  Splats splats;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    ArrayOf(input, vtkDataSetAttributes::GhostArrayName(), 1));
  auto* colors = vtkUnsignedCharArray::SafeDownCast(input->GetPointData()->GetScalars());
  splats.Colors = colors && colors->GetNumberOfComponents() >= 3 &&
      colors->GetNumberOfTuples() == count
    ? colors
    : nullptr;
  if (normals->GetNumberOfTuples() != count || normals->GetNumberOfComponents() != 3)
  {
    vtkErrorMacro("The point normals " << (normals->GetName() ? normals->GetName() : "")
                                       << " have " << normals->GetNumberOfTuples()
                                       << " tuples for " << count
                                       << " points: remove them, or give one for each point.");
    return 1;
  }
  double origin[3] = { 0, 0, 0 };
  for (vtkIdType id = 0; id < count; ++id)
  {
    double p[3], n[3], r = 0;
    input->GetPoints()->GetPoint(id, p);
    normals->GetTuple(id, n);
    if (axes[0] && axes[1])
    {
      for (vtkDataArray* axis : axes)
      {
        double a[3];
        axis->GetTuple(id, a);
        const double length = vtkMath::Norm(a);
        r = length > r || std::isnan(length) ? length : r;
      }
    }
    else
    {
      r = radius->GetComponent(id, 0);
    }
    r *= this->Reach;
    const unsigned char ghost = ghosts
      ? ghosts->GetValue(id) &
        (vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT)
      : 0;
    const double length = vtkMath::Norm(n);
    if (ghost || !Finite(p) || !(length > 0) || !std::isfinite(length) || !(r > 0) ||
      !std::isfinite(r * r))
    {
      ++this->NumberOfSkippedPoints;
      continue;
    }
    if (splats.Ids.empty())
    {
      std::copy_n(p, 3, origin);
    }
    splats.Ids.push_back(id);
    splats.Radii.push_back(r);
    for (int k = 0; k < 3; ++k)
    {
      splats.Positions.push_back(p[k] - origin[k]);
      splats.Normals.push_back(n[k] / length);
    }
  }
  if (this->NumberOfSkippedPoints > 0)
  {
    vtkWarningMacro(<< this->NumberOfSkippedPoints << " of " << count
                    << " points are in no group: ghosts, or coordinates, normals or splat sizes "
                       "that are not finite and not zero.");
  }
  this->UpdateProgress(0.3);

  std::vector<int> found;
  if (!this->Color(splats, found))
  {
    this->NumberOfGroups = 0;
    return 1;
  }
  for (std::size_t i = 0; i < splats.Ids.size(); ++i)
  {
    group->SetValue(splats.Ids[i], found[i]);
  }
  output->GetFieldData()->RemoveArray(vtkPointSplatArrays::GroupCoverage);
  if (this->Coverage != AsIs)
  {
    this->Cover(splats, found, input, output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPointSplatGrouping::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const coverages[] = { "AsIs", "Duplicate", "Enlarge" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Coloring: " << (this->Coloring == Weighted ? "Weighted" : "LargestFirst")
     << "\n";
  os << indent << "OverlapFactor: " << this->OverlapFactor << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "IgnoreOpposite: " << (this->IgnoreOpposite ? "On" : "Off") << "\n";
  os << indent << "CoplanarAngle: " << this->CoplanarAngle << "\n";
  os << indent << "ColorTolerance: " << this->ColorTolerance << "\n";
  os << indent << "WantedNumberOfGroups: " << this->WantedNumberOfGroups << "\n";
  os << indent << "MaximumOverlap: " << this->MaximumOverlap << "\n";
  os << indent << "Coverage: " << coverages[this->Coverage] << "\n";
  os << indent << "MaximumClipped: " << this->MaximumClipped << "\n";
  os << indent << "NumberOfGroups: " << this->NumberOfGroups << "\n";
  os << indent << "MaximumDegree: " << this->MaximumDegree << "\n";
  os << indent << "MeanDegree: " << this->MeanDegree << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
  os << indent << "NumberOfDuplicates: " << this->NumberOfDuplicates << "\n";
  os << indent << "OverlapWithinGroups: " << this->OverlapWithinGroups << "\n";
}

VTK_ABI_NAMESPACE_END
