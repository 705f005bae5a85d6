// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeReader.h"

#include "vtkPointSplatHDF5.h"
#include "vtkPointSplatOctreeCut.h"
#include "vtkPointSplatOctreeFile.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatOctreeReader);

namespace
{
using namespace vtkPointSplatHDF5;
namespace Names = vtkPointSplatOctreeFile;

/**
 * A file that is open, and what its root says.
 */
struct File
{
  explicit File(const char* name)
  {
    if (!name || !*name)
    {
      this->Error = "There is no FileName.";
      return;
    }
    const std::string quoted = "'" + std::string(name) + "' ";
    if (!vtksys::SystemTools::FileExists(name, true))
    {
      this->Error = quoted + "is not there.";
      return;
    }
    // Of a damaged file HDF5 may keep something open; not beyond the file itself.
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    this->Data = Handle(H5Fopen(name, H5F_ACC_RDONLY, access), H5Fclose);
    std::string type;
    std::vector<long long> version(1);
    if (!this->Data)
    {
      this->Error = quoted + "is truncated, or no HDF5 file.";
    }
    else if (!ReadText(this->Data, "Type", type) || type != Names::Type ||
      !ReadNumbers(this->Data, "Version", version))
    {
      this->Error = quoted + "is an HDF5 file, but was not written by vtkPointSplatOctreeWriter.";
    }
    else if (version[0] != Names::Version)
    {
      this->Error = quoted + "is of version " + std::to_string(version[0]) + "; known is " +
        std::to_string(Names::Version) + ".";
    }
    else if (!ReadNumbers(this->Data, "Pieces", this->Pieces) ||
      !ReadNumbers(this->Data, "Points", this->Points) ||
      !ReadNumbers(this->Data, "Bounds", this->Bounds))
    {
      this->Error = quoted + "is damaged.";
    }
  }

  Handle Data;
  std::string Error; // empty where all is well
  std::vector<long long> Pieces{ 0 };
  std::vector<long long> Points{ 0 };
  std::vector<double> Bounds = std::vector<double>(6);
};

/**
 * A level of a piece, of which some runs are read.
 */
struct Source
{
  Handle Group;
  std::vector<Run> Runs;
  vtkIdType Count;
  std::vector<std::string> Names; // of Array0, Array1, ...
};

std::vector<Source> SourcesOf(hid_t file, vtkPointSplatOctreeCut::Runs runs)
{
  std::vector<Source> sources;
  for (auto& one : runs)
  {
    Source source;
    source.Group = OpenGroup(file,
      "Piece" + std::to_string(one.first.first) + "/Level" + std::to_string(one.first.second));
    source.Runs = std::move(one.second);
    source.Count = 0;
    for (const Run& run : source.Runs)
    {
      source.Count += run.Count;
    }
    ArrayHead head;
    while (ReadHead(source.Group, "Array" + std::to_string(source.Names.size()), head))
    {
      source.Names.push_back(head.Name);
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

bool IsOfLevelsAlone(const std::string& name)
{
  return std::any_of(std::begin(Names::LevelArrays), std::end(Names::LevelArrays),
    [&name](const char* other) { return name == other; });
}

/// Which data set of each source has the array; empty where one has none, or one of another kind.
std::vector<std::string> DataSetsOf(
  const std::vector<Source>& sources, const std::string& name, bool points)
{
  std::vector<std::string> found;
  ArrayHead first;
  for (const Source& source : sources)
  {
    const auto begin = source.Names.begin() + (points ? 0 : 1);
    const auto at = points ? begin : std::find(begin, source.Names.end(), name);
    ArrayHead head;
    const std::string dataset = "Array" + std::to_string(at - source.Names.begin());
    if (at == source.Names.end() || !ReadHead(source.Group, dataset, head))
    {
      return {};
    }
    first = found.empty() ? head : first;
    if (head.DataType != first.DataType || head.Components != first.Components)
    {
      return {};
    }
    found.push_back(dataset);
  }
  return found;
}

/// The array's tuples of all sources; none: they cannot be read.
vtkSmartPointer<vtkAbstractArray> ReadArray(
  const std::vector<Source>& sources, const std::vector<std::string>& datasets, vtkIdType count)
{
  vtkSmartPointer<vtkAbstractArray> array = NewArray(sources[0].Group, datasets[0]);
  if (!array)
  {
    return nullptr;
  }
  array->SetNumberOfTuples(count);
  vtkIdType at = 0;
  for (size_t i = 0; i < sources.size(); ++i)
  {
    if (!ReadTuples(sources[i].Group, datasets[i], sources[i].Runs, array, at))
    {
      return nullptr;
    }
    at += sources[i].Count;
  }
  return array;
}

bool ReadFieldData(hid_t file, vtkFieldData* data)
{
  const Handle group = OpenGroup(file, "Piece0/FieldData");
  for (int a = 0; group; ++a)
  {
    const std::string dataset = "Array" + std::to_string(a);
    ArrayHead head;
    if (!ReadHead(group, dataset, head))
    {
      return true;
    }
    vtkSmartPointer<vtkAbstractArray> array = NewArray(group, dataset);
    if (!array)
    {
      return false;
    }
    array->SetNumberOfTuples(head.Tuples);
    if (!ReadTuples(group, dataset, { { 0, head.Tuples } }, array, 0))
    {
      return false;
    }
    data->AddArray(array);
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeReader::vtkPointSplatOctreeReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeReader::~vtkPointSplatOctreeReader()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeReader::CanReadFile(const char* fileName)
{
  const Silence silence;
  return File(fileName).Error.empty();
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const Silence silence;
  const File file(this->FileName);
  if (!file.Error.empty())
  {
    vtkErrorMacro(<< file.Error);
    return 0;
  }
  this->NumberOfPointsInFile = static_cast<vtkIdType>(file.Points[0]);
  std::copy(file.Bounds.begin(), file.Bounds.end(), this->BoundsInFile);
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::BOUNDS(), this->BoundsInFile, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const Silence silence;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->CoarsestLevelRead = 0;
  const File file(this->FileName);
  if (!file.Error.empty())
  {
    vtkErrorMacro(<< file.Error);
    return 0;
  }
  const auto damaged = [&] {
    output->Initialize();
    vtkErrorMacro("'" << this->FileName << "' is damaged.");
    return 0;
  };
  vtkPointSplatOctreeCut cut;
  for (int piece = 0; piece < file.Pieces[0]; ++piece)
  {
    if (!cut.AddPiece(file.Data, piece))
    {
      return damaged();
    }
  }
  this->UpdateProgress(0.1);
  vtkBoundingBox box;
  if (this->Bounds[0] <= this->Bounds[1] && this->Bounds[2] <= this->Bounds[3] &&
    this->Bounds[4] <= this->Bounds[5])
  {
    box.SetBounds(this->Bounds);
  }
  const vtkPointSplatOctreeCut::Runs runs = cut.Make(this->MaximumNumberOfPoints, box);
  const std::vector<Source> sources = SourcesOf(file.Data, runs);
  vtkIdType count = 0;
  for (const Source& source : sources)
  {
    count += source.Count;
  }
  for (const auto& one : runs)
  {
    this->CoarsestLevelRead = std::max(this->CoarsestLevelRead, one.first.second);
  }
  if (count == 0)
  {
    return 1;
  }
  vtkPointData* data = output->GetPointData();
  const std::vector<std::string>& names = sources[0].Names;
  for (size_t a = 0; a < names.size() && !this->AbortExecute; ++a)
  {
    if (a > 0 && IsOfLevelsAlone(names[a]))
    {
      continue;
    }
    const std::vector<std::string> datasets = DataSetsOf(sources, names[a], a == 0);
    if (datasets.empty() && a > 0)
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> array =
      datasets.empty() ? nullptr : ReadArray(sources, datasets, count);
    ArrayHead head;
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (!array || (a == 0 && (!numbers || numbers->GetNumberOfComponents() != 3)) ||
      !ReadHead(sources[0].Group, datasets[0], head))
    {
      return damaged();
    }
    if (a == 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(numbers);
      output->SetPoints(points);
    }
    else
    {
      const int index = data->AddArray(array);
      if (head.Role >= 0 && head.Role < vtkDataSetAttributes::NUM_ATTRIBUTES)
      {
        data->SetActiveAttribute(index, head.Role);
      }
    }
    this->UpdateProgress(0.1 + 0.9 * (a + 1.0) / names.size());
  }
  if (!ReadFieldData(file.Data, output->GetFieldData()))
  {
    return damaged();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* b) {
    os << indent << name << ": " << b[0] << ", " << b[1] << ", " << b[2] << ", " << b[3] << ", "
       << b[4] << ", " << b[5] << "\n";
  };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  print("Bounds", this->Bounds);
  os << indent << "NumberOfPointsInFile: " << this->NumberOfPointsInFile << "\n";
  print("BoundsInFile", this->BoundsInFile);
  os << indent << "CoarsestLevelRead: " << this->CoarsestLevelRead << "\n";
}
VTK_ABI_NAMESPACE_END
