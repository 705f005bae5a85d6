// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPacking.h"

#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCells.h"
#include "vtkPointSplatCodes.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatFolds.h"
#include "vtkPointSplatProjection.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace
{
using namespace vtkPointSplatCodes;

bool Finite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

constexpr double LargestLength = vtkPointSplatPacking::LargestLength;
constexpr double SmallestLength = 1e-37;
/// By less than this, radians over a radius, splats of flat faces bend: what floats leave of parts', not what a rough surface has
/// here and there.
constexpr double LargestFlatBend = 1e-5;

/// Which part of a folded splat lies in the plane of that code; -1: none, it is the splat's first
/// one.
int FindPart(const vtkPointSplatFolds& folds, uint32_t code)
{
  for (int part = 0; part < 2; ++part)
  {
    if (folds.Has[part] && CodeNormal(folds.Normals[part]) == code)
    {
      return part;
    }
  }
  return -1;
}

bool Holdable(const double v[3], double most = LargestLength)
{
  // NaN compares false.
  return std::abs(v[0]) <= most && std::abs(v[1]) <= most && std::abs(v[2]) <= most;
}

/**
 * Runs filters as parts of an owner, which shows their progress and may abort them.
 */
struct Part
{
  vtkAlgorithm* Owner; // or null
  double From = 0.0;
  double To = 1.0;
  double Done = 0.0; // stages of a filter may begin where others before have ended

  static void Follow(vtkObject* caller, unsigned long, void* part, void*)
  {
    Part& self = *static_cast<Part*>(part);
    auto filter = static_cast<vtkAlgorithm*>(caller);
    self.Done =
      std::max(self.Done, self.From + (self.To - self.From) * filter->GetProgress());
    self.Owner->UpdateProgress(self.Done);
    if (self.Owner->GetAbortExecute())
    {
      filter->SetAbortExecute(1);
    }
  }

  /// The part must outlive the filter's last run.
  void Watch(vtkAlgorithm* filter)
  {
    if (this->Owner)
    {
      vtkNew<vtkCallbackCommand> command;
      command->SetCallback(Part::Follow);
      command->SetClientData(this);
      filter->AddObserver(vtkCommand::ProgressEvent, command);
    }
  }

  /// Whether it came to its end.
  bool Run(vtkAlgorithm* filter, double from, double to)
  {
    this->From = from;
    this->To = to;
    filter->Update();
    return !this->Owner || !this->Owner->GetAbortExecute();
  }
};

/**
 * An array of the wanted shape, or an error that says what is wrong with it.
 */
vtkDataArray* Usable(vtkObject* owner, vtkPointSet* data, vtkDataArray* array, int components)
{
  const char* name = array && array->GetName() ? array->GetName() : "Normals";
  if (array &&
    (array->GetNumberOfComponents() != components ||
      array->GetNumberOfTuples() != data->GetNumberOfPoints()))
  {
    vtkErrorWithObjectMacro(owner, << "The point array " << name << " has "
                                    << array->GetNumberOfTuples() << " tuples of "
                                    << array->GetNumberOfComponents() << " components, not "
                                    << data->GetNumberOfPoints() << " of " << components
                                    << ". It is not used: rename or remove it.");
    return nullptr;
  }
  return array;
}

/**
 * See vtkPointSplatPacking::Pack().
 */
struct PackWorker
{
  template <typename PointArray, typename NormalArray>
  void operator()(PointArray* pointArray, NormalArray* normalArray, const vtkPointSplatPacking& a,
    const std::array<double, 3>& origin, bool circular, uint32_t* splats, unsigned char* valid)
  {
    const auto points = vtk::DataArrayTupleRange<3>(pointArray);
    const auto normals = vtk::DataArrayTupleRange<3>(normalArray);
    const vtkIdType words = circular ? 8 : 16;
    vtkPointSplatThreads::For(0, points.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        valid[i] = 0;
        const double p[3] = { static_cast<double>(points[i][0]) - origin[0],
          static_cast<double>(points[i][1]) - origin[1],
          static_cast<double>(points[i][2]) - origin[2] };
        double n[3] = { static_cast<double>(normals[i][0]), static_cast<double>(normals[i][1]),
          static_cast<double>(normals[i][2]) };
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        const unsigned char ghost =
          a.Ghosts && i < a.Ghosts->GetNumberOfTuples() ? a.Ghosts->GetValue(i) & (vtkDataSetAttributes::HIDDENPOINT |
                                               vtkDataSetAttributes::DUPLICATEPOINT)
                   : 0;
        if (ghost || !Holdable(p, a.Reach) || !(length > 0.0) || !std::isfinite(length))
        {
          continue;
        }
        double radius = 0.0;
        double axis1[3] = { 0.0, 0.0, 0.0 };
        double axis2[3] = { 0.0, 0.0, 0.0 };
        if (a.Axis1)
        {
          a.Axis1->GetTuple(i, axis1);
          a.Axis2->GetTuple(i, axis2);
          radius = std::sqrt(
            std::max(axis1[0] * axis1[0] + axis1[1] * axis1[1] + axis1[2] * axis1[2],
              axis2[0] * axis2[0] + axis2[1] * axis2[1] + axis2[2] * axis2[2]));
          if (!Holdable(axis1) || !Holdable(axis2))
          {
            continue;
          }
        }
        else
        {
          radius = a.Radius ? a.Radius->GetComponent(i, 0) : 0.0;
          if (!circular)
          {
            // Beside blocks of ellipses, a disk is an ellipse of two equal axes.
            const int least = std::abs(n[0]) < std::abs(n[1])
              ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
              : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
            double other[3] = { 0.0, 0.0, 0.0 };
            other[least] = 1.0;
            vtkMath::Cross(n, other, axis1);
            vtkMath::Normalize(axis1);
            vtkMath::Cross(n, axis1, axis2);
            vtkMath::Normalize(axis2);
            vtkMath::MultiplyScalar(axis1, radius);
            vtkMath::MultiplyScalar(axis2, radius);
          }
        }
        if ((a.Radius || a.Axis1) && !(radius >= SmallestLength && radius <= LargestLength))
        {
          continue;
        }
        valid[i] = 1;
        const double normal[3] = { n[0] / length, n[1] / length, n[2] / length };
        double plane[3] = { normal[0], normal[1], normal[2] };
        bool body = false;
        if (a.Axis1)
        {
          vtkMath::Cross(axis1, axis2, plane);
          if (vtkMath::Dot(plane, normal) < 0.0)
          {
            vtkMath::MultiplyScalar(plane, -1.0); // whatever side the product has, the plane shows the normal's
          }
        }
        else if (a.Plane)
        {
          a.Plane->GetTuple(i, plane);
          body = circular && plane[0] == 0.0 && plane[1] == 0.0 && plane[2] == 0.0;
        }
        if (!(vtkMath::Normalize(plane) > 0.0) || !Finite(plane))
        {
          std::copy_n(normal, 3, plane);
        }
        uint32_t* out = splats + words * i;
        for (int k = 0; k < 3; ++k)
        {
          out[k] = Bits(p[k]);
        }
        out[4] = CodeNormal(plane);
        out[5] = CodeNormal(normal);
        out[6] = 0;
        if (circular && a.Curvature)
        {
          double curvature[6];
          a.Curvature->GetTuple(i, curvature);
          out[6] = CodeBend(out[4], curvature, radius);
          const bool flat = std::all_of(curvature, curvature + 6,
            [radius](double c) { return std::abs(c) * radius < LargestFlatBend; });
          out[6] |= flat ? FlatBit : 0u;
        }
        out[6] |= body ? BodyBit : 0u;
        out[3] = Bits(radius);
        out[7] = static_cast<uint32_t>(i);
        if (!circular)
        {
          for (int k = 0; k < 3; ++k)
          {
            out[8 + k] = Bits(axis1[k]);
            out[12 + k] = Bits(axis2[k]);
          }
          out[11] = out[15] = 0;
        }
      }
    });
  }
};
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkPointSplatPacking::GivenGhostsOf(vtkPointSet* data)
{
  auto given = vtkArrayDownCast<vtkUnsignedCharArray>(
    data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool good = given && given->GetNumberOfTuples() == data->GetNumberOfPoints() &&
    given->GetNumberOfComponents() == 1;
  return good ? given : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> vtkPointSplatPacking::GhostsOf(
  vtkPointSet* data, vtkIdType* unused)
{
  vtkUnsignedCharArray* given = vtkPointSplatPacking::GivenGhostsOf(data);
  const std::vector<unsigned char> used = vtkPointSplatCells::MarkUsed(data);
  if (used.empty())
  {
    return given;
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(data->GetNumberOfPoints());
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const unsigned char ghost = given ? given->GetValue(i) : 0;
    const bool hidden = !used[static_cast<size_t>(i)];
    ghosts->SetValue(i, hidden ? ghost | vtkDataSetAttributes::HIDDENPOINT : ghost);
    count += hidden;
  }
  if (unused)
  {
    *unused = count;
  }
  return ghosts;
}

//------------------------------------------------------------------------------
vtkPointSplatPacking vtkPointSplatPacking::Collect(
  vtkObject* owner, vtkPointSet* data, const Wanted& wanted)
{
  vtkPointSplatPacking a;
  a.Points = data->GetPoints()->GetData();
  a.Reach = LargestLength;
  a.Ghosts = vtkPointSplatPacking::GhostsOf(data, &a.Unused);
  vtkPointData* given = data->GetPointData();
  a.Normals = Usable(owner, data, given->GetNormals(), 3);
  a.Radius = Usable(owner, data, given->GetArray(vtkPointSplatArrays::Radius), 1);
  a.HasGivenRadii = a.Radius != nullptr;
  a.Plane = Usable(owner, data, given->GetArray(vtkPointSplatArrays::PlaneNormal), 3);
  // It says how these normals change, and nothing of others.
  a.Curvature = a.Normals
    ? Usable(owner, data, given->GetArray(vtkPointSplatArrays::Curvature), 6)
    : nullptr;
  a.Axis1 = Usable(owner, data, given->GetArray(vtkPointSplatArrays::Axis1), 3);
  a.Axis2 = Usable(owner, data, given->GetArray(vtkPointSplatArrays::Axis2), 3);
  a.Clip = Usable(owner, data, given->GetArray(vtkPointSplatArrays::Clip), 6);
  a.Fold = Usable(owner, data, given->GetArray(vtkPointSplatArrays::Fold), 6);
  if (!a.Axis1 || !a.Axis2)
  {
    a.Axis1 = a.Axis2 = nullptr;
  }
  vtkDataArray* ofCells = data->GetCellData()->GetNormals();
  if (!a.Normals && ofCells)
  {
    vtkWarningWithObjectMacro(owner,
      << "The cell normals " << (ofCells->GetName() ? ofCells->GetName() : "(without name)")
      << " are not used, since points are drawn: their normals are estimated. "
         "vtkCellDataToPointData makes point normals of them.");
  }
  if (!a.Normals || (wanted.Sizes && !a.Radius && !a.Axis1))
  {
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(data->GetPoints());
    if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(data))
    {
      bare->SetPolys(mesh->GetPolys());
      bare->SetStrips(mesh->GetStrips());
    }
    if (a.Normals)
    {
      bare->GetPointData()->SetNormals(a.Normals);
    }
    if (a.Ghosts)
    {
      bare->GetPointData()->AddArray(a.Ghosts);
    }
    for (vtkAbstractArray* sensors :
      { given->GetAbstractArray(vtkPointSplatArrays::Sensor),
        given->GetAbstractArray(vtkPointSplatArrays::Scan) })
    {
      if (sensors)
      {
        bare->GetPointData()->AddArray(sensors);
      }
    }
    bare->GetFieldData()->PassData(data->GetFieldData());
    Wanted more = wanted;
    // Groups that were given have no splats between theirs.
    more.FillPoints = wanted.Sizes && wanted.FillPoints && !given->GetArray(vtkPointSplatArrays::Group);
    a.Estimate(owner, bare, more);
  }
  return a;
}

//------------------------------------------------------------------------------
void vtkPointSplatPacking::Estimate(
  vtkObject* owner, vtkPolyData* bare, const Wanted& wanted)
{
  const bool sized = this->Radius || this->Axis1;
  const bool mayProject = wanted.Projection && !sized;
  Part part{ vtkAlgorithm::SafeDownCast(owner) };
  vtkSmartPointer<vtkPointSplatEstimation> estimation = vtkSmartPointer<vtkPointSplatEstimation>::New();
  vtkNew<vtkPointSplatEstimation> projected;
  vtkNew<vtkPointSplatProjection> projection;
  // What they leave out the mapper leaves out too, and reports: once is enough.
  vtkNew<vtkCallbackCommand> silence;
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{
         estimation.Get(), projected.Get(), projection.Get() })
  {
    filter->AddObserver(vtkCommand::WarningEvent, silence);
    part.Watch(filter);
  }
  for (vtkPointSplatEstimation* filter : { estimation.Get(), projected.Get() })
  {
    filter->SetFillGaps(wanted.FillPoints && !sized);
    filter->SetFillMeshGaps(wanted.FillMeshes);
  }
  // Noise is projected first.
  estimation->SetFillNoise(!mayProject);
  estimation->SetInputData(bare);
  bool good = part.Run(estimation, 0.0, mayProject ? 0.4 : 1.0);
  if (good && mayProject && estimation->IsNoisy())
  {
    // Colours and ids go by the points' numbers.
    projection->SetOutliersToKeep();
    projection->SetInputData(bare);
    good = part.Run(projection, 0.4, 0.6);
    projected->SetInputConnection(projection->GetOutputPort());
    good = good && part.Run(projected, 0.6, 1.0);
    // Noise lies on one surface once it is projected. What does not has lain on its own, as layers upon one
    // another and isosurfaces of noisy volumes.
    this->Projected = good && !projected->IsCrumpled(estimation->GetContradiction());
    if (this->Projected)
    {
      estimation = projected;
    }
    else if (good)
    {
      estimation->ReliefOn();
      good = part.Run(estimation, 0.6, 1.0);
    }
  }
  this->Aborted = !good;
  if (this->Aborted)
  {
    return;
  }
  this->Fill = estimation->GetFillPoints();
  if (this->Projected || !this->Fill.empty())
  {
    this->Points = estimation->GetOutput()->GetPoints()->GetData();
  }
  vtkPointData* estimated = estimation->GetOutput()->GetPointData();
  this->Normals = estimated->GetNormals();
  if (sized && !this->Plane)
  {
    this->Plane = estimated->GetArray(vtkPointSplatArrays::PlaneNormal);
  }
  if (!sized)
  {
    this->Radius = estimated->GetArray(vtkPointSplatArrays::Radius);
    this->Plane = estimated->GetArray(vtkPointSplatArrays::PlaneNormal);
    this->Curvature = estimated->GetArray(vtkPointSplatArrays::Curvature);
    if (!this->Clip)
    {
      this->Clip = estimated->GetArray(vtkPointSplatArrays::Clip);
      this->Fold = estimated->GetArray(vtkPointSplatArrays::Fold);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPacking::Pack(const std::array<double, 3>& origin, bool circular,
  uint32_t* splats, unsigned char* valid) const
{
  using Reals = vtkArrayDispatch::Reals;
  using Dispatcher = vtkArrayDispatch::Dispatch2ByValueType<Reals, Reals>;
  PackWorker worker;
  if (!Dispatcher::Execute(
        this->Points.Get(), this->Normals.Get(), worker, *this, origin, circular, splats, valid))
  {
    worker(this->Points.Get(), this->Normals.Get(), *this, origin, circular, splats, valid);
  }
}

//------------------------------------------------------------------------------
vtkPointSplatFolds vtkPointSplatPacking::GetFolds(vtkIdType id) const
{
  if (!this->Fold || !this->Clip || !this->Plane)
  {
    return vtkPointSplatFolds();
  }
  double fold[6], clip[6], normal[3], plane[3];
  this->Fold->GetTuple(id, fold);
  this->Clip->GetTuple(id, clip);
  this->Normals->GetTuple(id, normal);
  this->Plane->GetTuple(id, plane);
  return vtkPointSplatFolds(fold, clip, normal, plane);
}

//------------------------------------------------------------------------------
size_t vtkPointSplatPacking::PackFolds(std::vector<uint32_t>& splats, size_t kept) const
{
  splats.resize(8 * kept);
  for (size_t i = 0; i < kept; ++i)
  {
    const vtkPointSplatFolds folds = this->GetFolds(splats[8 * i + 7]);
    for (int part = 0; part < 2; ++part)
    {
      if (folds.Has[part])
      {
        uint32_t copy[8];
        std::copy_n(splats.data() + 8 * i, 8, copy);
        copy[4] = CodeNormal(folds.Normals[part]);
        copy[6] = 0; // the form is that of the first part
        splats.insert(splats.end(), copy, copy + 8);
      }
    }
  }
  return splats.size() / 8;
}

//------------------------------------------------------------------------------
bool vtkPointSplatPacking::HasClipLines() const
{
  if (!this->Clip)
  {
    return false;
  }
  for (int k = 0; k < 6; ++k)
  {
    double range[2];
    this->Clip->GetFiniteRange(range, k);
    if (range[0] < 0.0 || range[1] > 0.0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkPointSplatPacking::PackClipLines(
  const uint32_t* splats, vtkIdType count, bool circular, uint32_t* lines) const
{
  const vtkIdType words = circular ? 8 : 16;
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const uint32_t* splat = splats + words * i;
      double s[3];
      double t[3];
      AxesOf(splat, circular, s, t);
      double c[6];
      const vtkPointSplatFolds folds = this->GetFolds(splat[7]);
      const int part = circular ? FindPart(folds, splat[4]) : -1;
      if (part >= 0)
      {
        folds.GetLines(part, c);
      }
      else
      {
        this->Clip->GetTuple(splat[7], c);
      }
      CodeLine(c, s, t, lines + 4 * i);
      CodeLine(c + 3, s, t, lines + 4 * i + 2);
    }
  });
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkPointSplatPacking::CellsOfPoints(vtkPointSet* data)
{
  std::vector<vtkIdType> cells(static_cast<size_t>(data->GetNumberOfPoints()), -1);
  if (!vtkPointSplatCells::CanBeRead(data))
  {
    vtkErrorWithObjectMacro(data, "Cells reach beyond their own list: they are not used for "
                                  "colours or selections. Check the offsets of its cell arrays.");
    return cells;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = data->GetNumberOfCells() - 1; c >= 0; --c)
  {
    data->GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType id = ids->GetId(k);
      if (id >= 0 && id < data->GetNumberOfPoints())
      {
        cells[static_cast<size_t>(id)] = c;
      }
    }
  }
  return cells;
}
