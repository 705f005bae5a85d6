// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctree.h"

#include "vtkPointSplatArrays.h"
#include "vtkPointSplatBatches.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatHierarchy.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatLevelLines.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatOctree);

namespace
{
using Hierarchy = vtkPointSplatHierarchy;
using Index = Hierarchy::Index;

vtkDataArray* ArrayOf(vtkPointData* data, const char* name, int components)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

/// The points of a data set with all that their splats take, about an origin.
class Reader : public Hierarchy::Source
{
public:
  explicit Reader(vtkPolyData* from)
    : Positions(from->GetPoints()->GetData())
  {
    vtkPointData* data = from->GetPointData();
    this->Normals.resize(3 * static_cast<size_t>(from->GetNumberOfPoints()));
    vtkPointSplatInput::ReadNormals(data->GetNormals(), this->Normals.data());
    this->ReadPlanes(data);
    vtkPointSplatInput::MarkUsable(from, this->Used);
    this->ReadRadii(data);
    this->Curvatures = ArrayOf(data, vtkPointSplatArrays::Curvature, 6);
    this->Ghosts = vtkPointSplatInput::GetGhosts(from);
    for (int k = 0; k < 3; ++k)
    {
      double range[2];
      this->Positions->GetFiniteRange(range, k);
      this->Origin[k] = range[0] <= range[1] ? 0.5 * range[0] + 0.5 * range[1] : 0.0;
    }
  }

  bool HasAxes() const { return this->Elliptical; }
  const double* GetOrigin() const { return this->Origin; }

  bool Read(Index id, Hierarchy::Point& point) const override
  {
    const float* n = this->Normals.data() + 3 * static_cast<size_t>(id);
    const float radius = this->Radii[id];
    // NaN compares false.
    const bool good = this->Used[id] && (n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f) &&
      radius > 0.0 && radius <= vtkPointSplatInput::LargestCoordinate &&
      !vtkPointSplatInput::IsDuplicate(this->Ghosts, id);
    if (!good)
    {
      return false;
    }
    point.Radius = radius;
    double p[3];
    this->Positions->GetTuple(id, p);
    for (int k = 0; k < 3; ++k)
    {
      point.Position[k] = static_cast<float>(p[k] - this->Origin[k]);
      point.Normal[k] = n[k];
    }
    point.HasCurvature = this->Curvatures != nullptr;
    for (int k = 0; k < 6 && this->Curvatures; ++k)
    {
      const double bend = this->Curvatures->GetComponent(id, k);
      point.Curvature[k] = std::isfinite(bend) ? static_cast<float>(bend) : 0.0f;
    }
    return true;
  }

private:
  /// A point on an edge, whose normal is an average of two faces', is of the face in whose plane it lies.
  void ReadPlanes(vtkPointData* data)
  {
    vtkDataArray* planes = ArrayOf(data, vtkPointSplatArrays::PlaneNormal, 3);
    vtkDataArray* folds = ArrayOf(data, vtkPointSplatArrays::Fold, 6);
    const vtkIdType count = planes && folds ? planes->GetNumberOfTuples() : 0;
    vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        double fold[6];
        folds->GetTuple(id, fold);
        double plane[3];
        planes->GetTuple(id, plane);
        if (std::any_of(fold, fold + 6, [](double x) { return x != 0.0; }) &&
          vtkMath::Normalize(plane) > 0.0)
        {
          std::copy_n(plane, 3, this->Normals.data() + 3 * static_cast<size_t>(id));
        }
      }
    });
  }
  void ReadRadii(vtkPointData* data)
  {
    vtkDataArray* radii = ArrayOf(data, vtkPointSplatArrays::Radius, 1);
    vtkDataArray* axes[2] = { ArrayOf(data, vtkPointSplatArrays::Axis1, 3),
      ArrayOf(data, vtkPointSplatArrays::Axis2, 3) };
    this->Elliptical = axes[0] && axes[1];
    this->Radii.resize(this->Normals.size() / 3);
    vtkPointSplatThreads::For(
      0, static_cast<vtkIdType>(this->Radii.size()), [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType id = begin; id < end; ++id)
        {
          double radius = this->Elliptical ? 0.0 : radii->GetComponent(id, 0);
          for (int k = 0; k < 2 && this->Elliptical; ++k)
          {
            double a[3];
            axes[k]->GetTuple(id, a);
            const double length = vtkMath::Norm(a);
            radius = length > radius || std::isnan(length) ? length : radius;
          }
          // What floats do not hold is infinite, and left out.
          this->Radii[id] = radius <= vtkPointSplatInput::LargestCoordinate
            ? static_cast<float>(radius)
            : std::numeric_limits<float>::infinity();
        }
      });
  }

  vtkDataArray* Positions;
  std::vector<float> Normals;
  std::vector<unsigned char> Used;
  bool Elliptical = false;
  std::vector<float> Radii;
  vtkDataArray* Curvatures;
  const unsigned char* Ghosts;
  double Origin[3];
};

/// The input with normals and sizes: what of them is missing, estimated.
void Complete(vtkPointSet* input, vtkPolyData* whole)
{
  whole->SetPoints(input->GetPoints());
  vtkPointData* data = whole->GetPointData();
  data->PassData(input->GetPointData());
  whole->GetFieldData()->PassData(input->GetFieldData());
  // Arrays without one tuple a point cannot be put into another order.
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != input->GetNumberOfPoints())
    {
      data->RemoveArray(i);
    }
  }
  const bool sized = ArrayOf(data, vtkPointSplatArrays::Radius, 1) ||
    (ArrayOf(data, vtkPointSplatArrays::Axis1, 3) && ArrayOf(data, vtkPointSplatArrays::Axis2, 3));
  if (data->GetNormals() && sized)
  {
    return;
  }
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(input->GetPoints());
  bare->GetPointData()->SetNormals(data->GetNormals());
  bare->GetPointData()->AddArray(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(bare);
  estimation->Update();
  vtkPointData* estimated = estimation->GetOutput()->GetPointData();
  for (const char* name : { vtkPointSplatArrays::Axis1, vtkPointSplatArrays::Axis2 })
  {
    data->RemoveArray(name);
  }
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::Curvature, vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    if (vtkDataArray* array = estimated->GetArray(name))
    {
      data->AddArray(array);
    }
  }
  data->SetNormals(estimated->GetNormals());
}

/// The points in the hierarchy's order, with all that they have.
void CopyPoints(vtkPolyData* whole, const std::vector<Index>& order, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(order.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(whole->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkPointData* from = whole->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->SetNumberOfTuples(count);
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double x[3];
      whole->GetPoints()->GetData()->GetTuple(order[i], x);
      points->GetData()->SetTuple(i, x);
    }
  });
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* source = from->GetAbstractArray(to->GetAbstractArray(a)->GetName());
    source = source ? source : from->GetAbstractArray(a);
    vtkAbstractArray* target = to->GetAbstractArray(a);
    // Threads may not write to strings at once.
    const auto copy = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        target->SetTuple(i, order[i], source);
      }
    };
    if (vtkArrayDownCast<vtkDataArray>(target) && target->GetDataType() != VTK_BIT)
    {
      vtkPointSplatThreads::For(0, count, copy);
    }
    else
    {
      copy(0, count);
    }
  }
  output->SetPoints(points);
  output->GetFieldData()->PassData(whole->GetFieldData());
  if (!to->GetAbstractArray(vtkPointSplatArrays::OriginalIds))
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(vtkPointSplatArrays::OriginalIds);
    ids->SetNumberOfTuples(count);
    std::copy(order.begin(), order.end(), ids->GetPointer(0));
    to->AddArray(ids);
  }
}

template <typename Array>
Array* Add(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array;
}

/// The splats themselves.
void CopyLevels(const Hierarchy& hierarchy, const Reader& reader, int pointType, vtkPolyData* output)
{
  vtkIdType count = 0;
  for (int level = 1; level < hierarchy.GetNumberOfLevels(); ++level)
  {
    count += hierarchy.GetNumberOfSplats(level);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  points->SetNumberOfPoints(count);
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  auto* normals = Add<vtkFloatArray>(data, "Normals", 3, count);
  data->SetNormals(normals);
  vtkFloatArray* axes[2] = { nullptr, nullptr };
  vtkFloatArray* radii = nullptr;
  if (reader.HasAxes())
  {
    axes[0] = Add<vtkFloatArray>(data, vtkPointSplatArrays::Axis1, 3, count);
    axes[1] = Add<vtkFloatArray>(data, vtkPointSplatArrays::Axis2, 3, count);
  }
  else
  {
    radii = Add<vtkFloatArray>(data, vtkPointSplatArrays::Radius, 1, count);
  }
  auto* bends = Add<vtkFloatArray>(data, vtkPointSplatArrays::Curvature, 6, count);
  auto* levels = Add<vtkUnsignedCharArray>(data, vtkPointSplatArrays::Level, 1, count);
  auto* firsts = Add<vtkIdTypeArray>(data, vtkPointSplatArrays::FirstChild, 1, count);
  auto* counts = Add<vtkIntArray>(data, vtkPointSplatArrays::ChildCount, 1, count);
  auto* deviations = Add<vtkFloatArray>(data, vtkPointSplatArrays::NormalDeviation, 1, count);
  vtkIdType to = 0;
  for (int level = 1; level < hierarchy.GetNumberOfLevels(); ++level)
  {
    for (Index i = 0; i < hierarchy.GetNumberOfSplats(level); ++i, ++to)
    {
      const Hierarchy::Splat& splat = hierarchy.GetSplats(level)[i];
      const double* origin = reader.GetOrigin();
      points->SetPoint(to, origin[0] + splat.Position[0], origin[1] + splat.Position[1],
        origin[2] + splat.Position[2]);
      normals->SetTypedTuple(to, splat.Normal);
      if (radii)
      {
        radii->SetValue(to, splat.Radius);
      }
      else
      {
        float second[3];
        vtkMath::Cross(splat.Normal, splat.Axis, second);
        for (int k = 0; k < 3; ++k)
        {
          axes[0]->SetTypedComponent(to, k, splat.Radius * splat.Axis[k]);
          axes[1]->SetTypedComponent(to, k, splat.Radius * splat.Shorter * second[k]);
        }
      }
      bends->SetTypedTuple(to, splat.Curvature);
      levels->SetValue(to, static_cast<unsigned char>(level));
      firsts->SetValue(to, splat.First);
      counts->SetValue(to, static_cast<int>(hierarchy.GetEnd(level, i) - splat.First));
      deviations->SetValue(to, std::sqrt(splat.Variance));
    }
  }
}

/// An array of the levels like one that the points have.
vtkDataArray* AddLike(vtkDataArray* array, vtkPolyData* levels)
{
  vtkSmartPointer<vtkDataArray> like;
  like.TakeReference(array->NewInstance());
  like->SetName(array->GetName());
  like->SetNumberOfComponents(array->GetNumberOfComponents());
  like->SetNumberOfTuples(levels->GetNumberOfPoints());
  levels->GetPointData()->AddArray(like);
  return like;
}

/// Means of all else that points have and that has a mean.
void AverageData(const Hierarchy& hierarchy, const Reader& reader, vtkPolyData* points,
  vtkPolyData* output)
{
  std::vector<vtkDataArray*> from;
  std::vector<vtkDataArray*> to;
  vtkPointData* data = output->GetPointData();
  for (int a = 0; a < points->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = points->GetPointData()->GetArray(a);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    const bool hasMean = array &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE ||
        array->GetDataType() == VTK_UNSIGNED_CHAR) &&
      array != points->GetPointData()->GetNormals() && name != vtkPointSplatArrays::Clip &&
      name != vtkPointSplatArrays::Fold && name != vtkPointSplatArrays::PlaneNormal &&
      name != vtkDataSetAttributes::GhostArrayName() && !data->GetAbstractArray(name.c_str());
    if (hasMean && !name.empty())
    {
      vtkDataArray* mean = AddLike(array, output);
      if (array == points->GetPointData()->GetScalars())
      {
        data->SetScalars(mean);
      }
      from.push_back(array);
      to.push_back(mean);
    }
  }
  // Areas, summed upward; of each level the splats of the one below.
  const std::vector<Index>& order = hierarchy.GetOrder();
  std::vector<double> below(order.size());
  for (size_t i = 0; i < order.size(); ++i)
  {
    Hierarchy::Point point;
    reader.Read(order[i], point);
    below[i] = double(point.Radius) * point.Radius;
  }
  vtkIdType first = 0; // of the level below, in the arrays
  vtkIdType at = 0;
  for (int level = 1; level < hierarchy.GetNumberOfLevels(); ++level)
  {
    const Index count = hierarchy.GetNumberOfSplats(level);
    std::vector<double> areas(count, 0.0);
    vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index child = hierarchy.GetSplats(level)[i].First;
        const Index last = hierarchy.GetEnd(level, static_cast<Index>(i));
        for (Index c = child; c < last; ++c)
        {
          areas[i] += below[c];
        }
        for (size_t a = 0; a < to.size(); ++a)
        {
          vtkDataArray* source = level == 1 ? from[a] : to[a];
          for (int k = 0; k < source->GetNumberOfComponents(); ++k)
          {
            double sum = 0.0;
            for (Index c = child; c < last; ++c)
            {
              sum += below[c] * source->GetComponent(first + c, k);
            }
            const double mean = sum / areas[i];
            to[a]->SetComponent(
              at + i, k, to[a]->GetDataType() == VTK_UNSIGNED_CHAR ? std::round(mean) : mean);
          }
        }
      }
    });
    first = at;
    at += count;
    below = std::move(areas);
  }
}

/// The lines by which the levels' splats end, where points have some. They lie in the planes of their
/// normals, and behind the lines the splats do not go on.
void AddLines(const Hierarchy& hierarchy, vtkPolyData* points, vtkPolyData* levels)
{
  vtkPointData* data = points->GetPointData();
  vtkDataArray* from = ArrayOf(data, vtkPointSplatArrays::Clip, 6);
  if (!from)
  {
    return;
  }
  vtkDataArray* normals = levels->GetPointData()->GetNormals();
  vtkDataArray* planes = ArrayOf(data, vtkPointSplatArrays::PlaneNormal, 3);
  planes = planes ? AddLike(planes, levels) : nullptr;
  if (vtkDataArray* folds = ArrayOf(data, vtkPointSplatArrays::Fold, 6))
  {
    AddLike(folds, levels)->Fill(0.0);
  }
  vtkDataArray* to = AddLike(from, levels);
  vtkDataArray* radii = ArrayOf(levels->GetPointData(), vtkPointSplatArrays::Radius, 1);
  vtkDataArray* axes = ArrayOf(levels->GetPointData(), vtkPointSplatArrays::Axis1, 3);
  vtkIdType first = 0; // of the level below, in the arrays
  vtkIdType at = 0;
  for (int level = 1; level < hierarchy.GetNumberOfLevels(); ++level)
  {
    vtkPolyData* below = level == 1 ? points : levels;
    vtkDataArray* lines = level == 1 ? from : to;
    const vtkIdType count = hierarchy.GetNumberOfSplats(level);
    vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      std::vector<vtkPointSplatLevelLines::Splat> splats;
      for (vtkIdType i = begin; i < end; ++i)
      {
        splats.clear();
        const Index last = hierarchy.GetEnd(level, static_cast<Index>(i));
        for (Index c = hierarchy.GetSplats(level)[i].First; c < last; ++c)
        {
          splats.emplace_back();
          below->GetPoints()->GetData()->GetTuple(first + c, splats.back().Position);
          lines->GetTuple(first + c, splats.back().Lines);
        }
        vtkPointSplatLevelLines::Disk disk;
        levels->GetPoints()->GetData()->GetTuple(at + i, disk.Position);
        normals->GetTuple(at + i, disk.Normal);
        if (planes)
        {
          planes->SetTuple(at + i, disk.Normal);
        }
        double axis[3] = { 0.0, 0.0, 0.0 };
        if (axes)
        {
          axes->GetTuple(at + i, axis);
        }
        disk.Radius = axes ? vtkMath::Norm(axis) : radii->GetComponent(at + i, 0);
        double found[6];
        vtkPointSplatLevelLines::Find(splats, disk, found);
        to->SetTuple(at + i, found);
      }
    });
    first = at;
    at += count;
  }
}

void CopyBlocks(const Hierarchy& hierarchy, const Reader& reader, vtkFieldData* data)
{
  const std::vector<Hierarchy::Block>& blocks = hierarchy.GetBlocks();
  const vtkIdType count = static_cast<vtkIdType>(blocks.size());
  auto* ranges = Add<vtkIdTypeArray>(data, vtkPointSplatArrays::BlockRange, 3, count);
  auto* children = Add<vtkIdTypeArray>(data, vtkPointSplatArrays::BlockChildren, 2, count);
  auto* bounds = Add<vtkFloatArray>(data, vtkPointSplatArrays::BlockBounds, 6, count);
  auto* cones = Add<vtkFloatArray>(data, vtkPointSplatArrays::BlockCone, 4, count);
  auto* sizes = Add<vtkFloatArray>(data, vtkPointSplatArrays::BlockSize, 3, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Hierarchy::Block& b = blocks[i];
    const vtkIdType range[3] = { b.Level, b.First, b.Count };
    const vtkIdType child[2] = { b.FirstChild, b.ChildCount };
    const float box[6] = { b.Low[0], b.High[0], b.Low[1], b.High[1], b.Low[2], b.High[2] };
    const float cone[4] = { b.Cone[0], b.Cone[1], b.Cone[2], b.Angle };
    const float size[3] = { b.Radius, b.MeanRadius, b.Deviation };
    ranges->SetTypedTuple(i, range);
    children->SetTypedTuple(i, child);
    bounds->SetTypedTuple(i, box);
    cones->SetTypedTuple(i, cone);
    sizes->SetTypedTuple(i, size);
  }
  Add<vtkDoubleArray>(data, vtkPointSplatArrays::BlockOrigin, 3, 1)->SetTypedTuple(0, reader.GetOrigin());
}
}

//------------------------------------------------------------------------------
vtkPointSplatOctree::vtkPointSplatOctree()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkPointSplatOctree::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctree::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* points = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* levels = vtkPolyData::GetData(outputs, 1);
  this->NumberOfLevels = 0;
  this->NumberOfBlocks = this->NumberOfSkippedPoints = 0;
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  if (count >= static_cast<vtkIdType>(std::numeric_limits<Index>::max()))
  {
    vtkErrorMacro(<< count << " points are too many for one data set; divide it into blocks.");
    return 1;
  }
  vtkNew<vtkPolyData> whole;
  Complete(input, whole);
  vtkDataArray* normals = whole->GetPointData()->GetNormals();
  if (!normals || normals->GetNumberOfTuples() != count)
  {
    vtkErrorMacro("The points have no normals, nor can any be estimated: give them point normals.");
    return 1;
  }
  const Reader reader(whole);
  Hierarchy hierarchy;
  const bool made = hierarchy.Make(
    reader, { static_cast<Index>(count) }, reader.HasAxes(), [this](double share) {
      this->UpdateProgress(0.1 + 0.6 * share);
      return !vtkPointSplatBatches::IsAborted(this);
    });
  if (!made)
  {
    return 1;
  }
  this->NumberOfLevels = hierarchy.GetNumberOfLevels();
  this->NumberOfBlocks = static_cast<vtkIdType>(hierarchy.GetBlocks().size());
  this->NumberOfSkippedPoints = count - static_cast<vtkIdType>(hierarchy.GetOrder().size());
  if (this->NumberOfSkippedPoints > 0)
  {
    vtkWarningMacro(<< this->NumberOfSkippedPoints << " of " << count
                    << " points are left out: ghosts, or coordinates, normals or splat sizes that "
                       "are not finite and not zero.");
  }
  CopyPoints(whole, hierarchy.GetOrder(), points);
  this->UpdateProgress(0.8);
  CopyLevels(hierarchy, reader, whole->GetPoints()->GetDataType(), levels);
  AverageData(hierarchy, reader, points, levels);
  AddLines(hierarchy, points, levels);
  CopyBlocks(hierarchy, reader, levels->GetFieldData());
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPointSplatOctree::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "NumberOfBlocks: " << this->NumberOfBlocks << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
}

VTK_ABI_NAMESPACE_END
