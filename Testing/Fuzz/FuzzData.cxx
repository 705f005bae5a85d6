// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzData.h"
#include "FuzzRoundTrip.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace
{
/**
 * How the values of an array are made.
 */
enum Values
{
  UnitVectors,
  Lengths,
  Small,
  Ghosts,
  Colours
};

struct Known
{
  const char* Name;
  int Components;
  Values Kind;
};
const Known KnownArrays[] = { { "Normals", 3, UnitVectors }, { "SplatRadius", 1, Lengths },
  { "SplatAxis1", 3, Lengths }, { "SplatAxis2", 3, Lengths }, { "SplatGroup", 1, Small },
  { "SplatCurvature", 6, Lengths }, { "SplatPlaneNormal", 3, UnitVectors },
  { "SplatClip", 6, Lengths }, { "SplatFold", 6, UnitVectors }, { "ShadowFactor", 1, Lengths }, { "Isovalue", 1, Small },
  { "vtkGhostType", 1, Ghosts }, { "scalars", 1, Lengths }, { "rgba", 4, Colours },
  { "vtkOriginalPointIds", 1, Small } };

/**
 * Whether everything of a data set is to have the right shape: readers and writers of VTK
 * cannot do without.
 */
struct Wrongness
{
  double Shape; // the probability of a wrong type, component or tuple count
  double Value; // of a value that is no number, or a number out of range
};

vtkSmartPointer<vtkDataArray> NewArray(FuzzRandom& random, int type)
{
  vtkSmartPointer<vtkDataArray> array;
  if ((type == VTK_FLOAT || type == VTK_DOUBLE) && random.Chance(0.1))
  {
    if (type == VTK_FLOAT)
    {
      array.TakeReference(vtkSOADataArrayTemplate<float>::New());
    }
    else
    {
      array.TakeReference(vtkSOADataArrayTemplate<double>::New());
    }
  }
  else
  {
    array.TakeReference(vtkDataArray::CreateDataArray(type));
  }
  return array;
}

/**
 * A value that the array's type can hold; C++ leaves the conversion of others undefined.
 */
double Held(vtkDataArray* array, double value)
{
  if (array->GetDataType() == VTK_FLOAT)
  {
    return std::isfinite(value) && std::abs(value) > VTK_FLOAT_MAX ? std::copysign(VTK_FLOAT_MAX, value)
                                                                   : value;
  }
  if (array->GetDataType() == VTK_DOUBLE)
  {
    return value;
  }
  // Doubles do not hold the ends of 64-bit types.
  const double least = std::max(array->GetDataTypeMin(), -9e15);
  const double most = std::min(array->GetDataTypeMax(), 9e15);
  return value >= least && value <= most ? std::trunc(value) : value > most ? most : least;
}

void Fill(FuzzRandom& random, vtkDataArray* array, Values kind, double wrong)
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> tuple(static_cast<size_t>(components));
  const double scale = random.Chance(0.2) ? random.Scale(1e-6, 1e3) : random.Uniform(0.05, 0.4);
  const bool integers = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (double& value : tuple)
    {
      value = kind == UnitVectors ? random.Uniform(-1, 1)
        : kind == Lengths         ? scale * random.Uniform(components == 1 ? 0.5 : -1.0, 1.0)
        : kind == Small           ? random.Below(8) - 1
        : kind == Ghosts ? (random.Chance(0.8) ? 0 : random.Pick({ 1, 2, 3, 8, 32, 255 }))
                         : random.Below(256);
      value *= kind == Lengths && integers ? 10 / scale : 1;
    }
    for (size_t c = 0; kind == UnitVectors && !integers && c + 3 <= tuple.size(); c += 3)
    {
      vtkMath::Normalize(&tuple[c]);
    }
    for (double& value : tuple)
    {
      value = Held(array, random.Chance(wrong) ? random.Nasty() : value);
    }
    array->SetTuple(i, tuple.data());
  }
}

void AddArray(FuzzRandom& random, vtkDataSetAttributes* to, const Known& known, vtkIdType tuples,
  const Wrongness& wrongness)
{
  const bool misshapen = random.Chance(wrongness.Shape);
  const int defect = misshapen ? random.Below(4) : -1;
  if (defect == 0)
  {
    vtkNew<vtkStringArray> strings;
    strings->SetName(known.Name);
    strings->SetNumberOfTuples(tuples);
    to->AddArray(strings);
    return;
  }
  int type = known.Kind == Ghosts || known.Kind == Colours ? VTK_UNSIGNED_CHAR
    : known.Kind == Small                                  ? VTK_INT
                                                           : VTK_FLOAT;
  if (defect == 1 || random.Chance(0.2))
  {
    type = random.Pick({ VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_CHAR,
      VTK_LONG_LONG, VTK_UNSIGNED_INT, VTK_ID_TYPE, VTK_SHORT });
  }
  const int components = defect == 2 ? random.Below(9) + 1 : known.Components;
  if (defect == 3)
  {
    tuples = random.Pick<vtkIdType>({ 0, 1, 3, tuples / 2, tuples + 1, 2 * tuples + 5 });
  }
  vtkSmartPointer<vtkDataArray> array = NewArray(random, type);
  array->SetName(known.Name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  Fill(random, array, known.Kind, random.Chance(0.5) ? wrongness.Value : 0.0);
  const bool active = random.Chance(0.9);
  if (std::strcmp(known.Name, "Normals") == 0 && active)
  {
    to->SetNormals(array); // which refuses what has not 3 components
  }
  else if (known.Kind != Ghosts && active && (known.Kind == Colours || known.Kind == Lengths) &&
    std::strncmp(known.Name, "Splat", 5) != 0)
  {
    to->SetScalars(array);
  }
  else
  {
    to->AddArray(array);
  }
}

vtkSmartPointer<vtkPoints> MakeCoordinates(FuzzRandom& random, double wrong)
{
  const int n = random.Chance(0.15) ? random.Below(4)
    : random.Chance(0.06)           ? 500 + random.Below(3000)
                                    : 4 + random.Below(300);
  auto points = vtkSmartPointer<vtkPoints>::New();
  if (random.Chance(0.1))
  {
    points->SetDataType(random.Pick({ VTK_INT, VTK_SHORT, VTK_UNSIGNED_CHAR, VTK_LONG_LONG }));
  }
  else
  {
    vtkSmartPointer<vtkDataArray> array =
      NewArray(random, random.Chance(0.6) ? VTK_FLOAT : VTK_DOUBLE);
    array->SetNumberOfComponents(3);
    points->SetData(array);
  }
  points->SetNumberOfPoints(n);
  const int shape = random.Below(8);
  const double scale = random.Chance(0.75) ? 1.0 : random.Scale(1e-30, 1e30);
  const double offset = random.Chance(0.85) ? 0.0 : random.Scale(1e3, 1e20);
  const int side = std::max(1, static_cast<int>(std::sqrt(n)));
  for (int i = 0; i < n; ++i)
  {
    double p[3] = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
    switch (shape)
    {
      case 0: // a cube's inside
        break;
      case 1: // a regular plane
        p[0] = static_cast<double>(i % side) / side;
        p[1] = static_cast<double>(i / side) / side;
        p[2] = 0;
        break;
      case 2: // a line
        p[1] = p[2] = 0;
        break;
      case 3: // duplicates of a few
        p[0] = i % 3;
        p[1] = i % 2;
        p[2] = 0;
        break;
      default: // a sphere
        vtkMath::Normalize(p);
        break;
    }
    for (double& x : p)
    {
      x = Held(points->GetData(), random.Chance(wrong) ? random.Nasty() : x * scale + offset);
    }
    points->SetPoint(i, p);
  }
  return points;
}

void AddArrays(FuzzRandom& random, vtkPointSet* data, const Wrongness& wrongness)
{
  // Most clouds have few of them.
  const double share = random.Pick({ 0.0, 0.15, 0.3, 0.6 });
  for (const Known& known : KnownArrays)
  {
    if (random.Chance(share) || (std::strcmp(known.Name, "Normals") == 0 && random.Chance(0.6)))
    {
      AddArray(random, data->GetPointData(), known, data->GetNumberOfPoints(), wrongness);
    }
    if (random.Chance(0.1 * share))
    {
      AddArray(random, data->GetCellData(), known, data->GetNumberOfCells(), wrongness);
    }
  }
}

vtkSmartPointer<vtkIdList> RandomIds(FuzzRandom& random, vtkIdType n, int count)
{
  auto ids = vtkSmartPointer<vtkIdList>::New();
  for (int k = 0; k < count && n > 0; ++k)
  {
    ids->InsertNextId(random.Below(static_cast<int>(n)));
  }
  return ids;
}

vtkSmartPointer<vtkCellArray> MakeCells(FuzzRandom& random, vtkIdType n, int least)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int c = random.Below(30); n > 0 && c > 0; --c)
  {
    cells->InsertNextCell(RandomIds(random, n, least + random.Below(3)));
  }
  return cells;
}

class Hash
{
public:
  void Add(const void* data, size_t bytes)
  {
    const auto* p = static_cast<const unsigned char*>(data);
    for (size_t i = 0; i < bytes; ++i)
    {
      this->Value = (this->Value ^ p[i]) * 0x100000001b3ull;
    }
  }
  void Add(std::uint64_t value) { this->Add(&value, sizeof(value)); }
  void Add(vtkAbstractArray* array)
  {
    if (!array)
    {
      this->Add(std::uint64_t(0));
      return;
    }
    const char* name = array->GetName() ? array->GetName() : "";
    this->Add(name, std::strlen(name));
    this->Add(static_cast<std::uint64_t>(array->GetDataType()));
    this->Add(static_cast<std::uint64_t>(array->GetNumberOfComponents()));
    this->Add(static_cast<std::uint64_t>(array->GetNumberOfTuples()));
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      {
        for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
        {
          const double value = numbers->GetComponent(i, k);
          this->Add(&value, sizeof(value));
        }
      }
    }
  }
  void Add(vtkFieldData* fields)
  {
    for (int a = 0; fields && a < fields->GetNumberOfArrays(); ++a)
    {
      this->Add(fields->GetAbstractArray(a));
    }
  }
  std::uint64_t Value = 0xcbf29ce484222325ull;
};
}

namespace FuzzData
{
vtkSmartPointer<vtkPointSet> MakePoints(FuzzRandom& random)
{
  Wrongness wrongness = { random.Pick({ 0.0, 0.0, 0.1, 0.3 }), random.Pick({ 0.0, 0.01, 0.3 }) };
  const double wrongPoints = random.Pick({ 0.0, 0.0, 0.01, 0.3, 1.0 });
  const int kind = random.Below(10);
  const bool file = kind < 2;
  if (file)
  {
    wrongness.Shape = 0;
  }
  vtkSmartPointer<vtkPointSet> data;
  if (kind == 9)
  {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(MakeCoordinates(random, wrongPoints));
    grid->Allocate(10);
    for (int c = random.Below(30); grid->GetNumberOfPoints() > 0 && c > 0; --c)
    {
      const bool tetra = random.Chance(0.5);
      grid->InsertNextCell(tetra ? VTK_TETRA : VTK_VERTEX,
        RandomIds(random, grid->GetNumberOfPoints(), tetra ? 4 : 1));
    }
    data = grid;
  }
  else if (kind == 8)
  {
    vtkNew<vtkStructuredGrid> grid;
    vtkSmartPointer<vtkPoints> points = MakeCoordinates(random, wrongPoints);
    grid->SetDimensions(static_cast<int>(points->GetNumberOfPoints()), 1, 1);
    grid->SetPoints(points);
    data = grid;
  }
  else
  {
    vtkNew<vtkPolyData> poly;
    if (!random.Chance(0.03))
    {
      poly->SetPoints(MakeCoordinates(random, wrongPoints));
    }
    if (random.Chance(0.3))
    {
      poly->SetVerts(MakeCells(random, poly->GetNumberOfPoints(), 1));
      poly->SetPolys(MakeCells(random, poly->GetNumberOfPoints(), 3));
    }
    data = poly;
  }
  AddArrays(random, data, wrongness);
  if (file)
  {
    return FuzzRoundTrip(random, vtkPolyData::SafeDownCast(data));
  }
  return data;
}

vtkSmartPointer<vtkImageData> MakeImage(FuzzRandom& random)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  for (int k = 0; k < 3; ++k)
  {
    extent[2 * k] = random.Chance(0.3) ? random.Below(20) - 10 : 0;
    extent[2 * k + 1] =
      extent[2 * k] + (random.Chance(0.05) ? random.Below(2) - 1 : 1 + random.Below(12));
  }
  image->SetExtent(extent);
  double spacing[3];
  double origin[3];
  for (int k = 0; k < 3; ++k)
  {
    spacing[k] = random.Chance(0.05) ? random.Nasty() : random.Uniform(0.1, 2);
    origin[k] = random.Chance(0.05) ? random.Nasty() : random.Uniform(-5, 5);
  }
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  if (random.Chance(0.2))
  {
    double direction[9];
    for (double& d : direction)
    {
      d = random.Chance(0.02) ? random.Nasty() : random.Uniform(-1, 1);
    }
    image->SetDirectionMatrix(direction);
  }
  const vtkIdType n = image->GetNumberOfPoints();
  vtkSmartPointer<vtkDataArray> scalars =
    NewArray(random, random.Pick({ VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_UNSIGNED_CHAR, VTK_SHORT,
                       VTK_UNSIGNED_SHORT, VTK_LONG_LONG, VTK_FLOAT, VTK_BIT }));
  scalars->SetName("scalars");
  scalars->SetNumberOfComponents(random.Chance(0.8) ? 1 : 1 + random.Below(4));
  scalars->SetNumberOfTuples(n);
  const bool smooth = random.Chance(0.5);
  const double wrong = random.Pick({ 0.0, 0.0, 0.02, 0.5 });
  const double factor = random.Chance(0.9) ? 100.0 : random.Scale(1e-40, 1e36);
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (int c = 0; c < scalars->GetNumberOfComponents(); ++c)
    {
      double value = random.Uniform();
      if (smooth)
      {
        // A ball, in steps of the grid.
        const int nx = extent[1] - extent[0] + 1, ny = extent[3] - extent[2] + 1;
        value = std::hypot(std::hypot(i % nx - 0.5 * nx, i / nx % ny - 0.5 * ny), i / (nx * ny) - 3.0) / 8;
      }
      value = random.Chance(wrong) ? random.Nasty() : factor * value;
      scalars->SetComponent(i, c, Held(scalars, value));
    }
  }
  if (!random.Chance(0.03))
  {
    image->GetPointData()->SetScalars(scalars);
  }
  const Known ghosts = { "vtkGhostType", 1, Ghosts };
  const Wrongness wrongness = { random.Pick({ 0.0, 0.3 }), 0.0 };
  if (random.Chance(0.15))
  {
    AddArray(random, image->GetPointData(), ghosts, n, wrongness);
  }
  if (random.Chance(0.15))
  {
    AddArray(random, image->GetCellData(), ghosts, image->GetNumberOfCells(), wrongness);
  }
  return image;
}

vtkSmartPointer<vtkDataObject> MakeAny(FuzzRandom& random)
{
  const int kind = random.Below(12);
  if (kind == 0)
  {
    vtkNew<vtkPartitionedDataSet> parts;
    parts->SetNumberOfPartitions(3);
    parts->SetPartition(0, MakePoints(random));
    parts->SetPartition(2, MakePoints(random));
    return parts;
  }
  if (kind == 1 || kind == 2)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    const unsigned int n = static_cast<unsigned int>(random.Below(5));
    blocks->SetNumberOfBlocks(n);
    for (unsigned int b = 0; b < n; ++b)
    {
      if (random.Chance(0.8))
      {
        blocks->SetBlock(b,
          random.Chance(0.1)
            ? MakeAny(random)
            : random.Chance(0.1) ? vtkSmartPointer<vtkDataObject>(MakeImage(random))
                                 : vtkSmartPointer<vtkDataObject>(MakePoints(random)));
      }
    }
    return blocks;
  }
  return MakePoints(random);
}

vtkSmartPointer<vtkPolyData> MakeSphere(const double centre[3], double radius)
{
  constexpr int Count = 600;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < Count; ++i)
  {
    // A spiral of equal areas.
    const double z = 1 - (2 * i + 1.0) / Count;
    const double r = std::sqrt(1 - z * z);
    const double angle = 2.399963229728653 * i;
    const double n[3] = { r * std::cos(angle), r * std::sin(angle), z };
    points->InsertNextPoint(
      centre[0] + radius * n[0], centre[1] + radius * n[1], centre[2] + radius * n[2]);
    normals->InsertNextTuple(n);
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->GetPointData()->SetNormals(normals);
  return sphere;
}

void Change(FuzzRandom& random, vtkDataObject* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  if (!points || !points->GetPoints() || points->GetNumberOfPoints() == 0)
  {
    data->Modified();
    return;
  }
  switch (random.Below(4))
  {
    case 0:
      AddArrays(random, points, { 0.1, 0.1 });
      break;
    case 1:
      points->SetPoints(MakeCoordinates(random, 0.01)); // the arrays are then too long or short
      break;
    case 2:
      points->GetPointData()->Initialize();
      break;
    default:
      points->GetPoints()->SetPoint(0, random.Uniform(), random.Uniform(), random.Uniform());
      points->GetPoints()->Modified();
      break;
  }
  points->Modified();
}

std::uint64_t Digest(vtkDataObject* data)
{
  Hash hash;
  auto add = [&hash](vtkDataObject* object) {
    hash.Add(object->GetFieldData());
    auto* set = vtkDataSet::SafeDownCast(object);
    if (!set)
    {
      return;
    }
    hash.Add(static_cast<vtkFieldData*>(set->GetPointData()));
    hash.Add(static_cast<vtkFieldData*>(set->GetCellData()));
    auto* points = vtkPointSet::SafeDownCast(set);
    if (points && points->GetPoints())
    {
      hash.Add(points->GetPoints()->GetData());
    }
    hash.Add(static_cast<std::uint64_t>(set->GetNumberOfPoints()));
    hash.Add(static_cast<std::uint64_t>(set->GetNumberOfCells()));
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; points && c < set->GetNumberOfCells(); ++c)
    {
      set->GetCellPoints(c, ids);
      hash.Add(ids->GetPointer(0), sizeof(vtkIdType) * static_cast<size_t>(ids->GetNumberOfIds()));
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      hash.Add(static_cast<std::uint64_t>(it->GetCurrentFlatIndex()));
      add(it->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return hash.Value;
}
}
