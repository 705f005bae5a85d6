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
  const vtkPointSplatOctreeCut::Level* Level;
  std::vector<Run> Runs;
  vtkIdType Count;
};

std::vector<Source> SourcesOf(const vtkPointSplatOctreeCut& cut, vtkPointSplatOctreeCut::Runs runs)
{
  std::vector<Source> sources;
  for (auto& one : runs)
  {
    Source source{ &cut.GetLevel(one.first.first, one.first.second), std::move(one.second), 0 };
    for (const Run& run : source.Runs)
    {
      source.Count += run.Count;
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

/// Which of its arrays each source has for one of the first source's; empty where one has none, or one
/// of another kind.
std::vector<int> NumbersOf(const std::vector<Source>& sources, size_t wanted)
{
  const ArrayHead& first = sources[0].Level->Heads[wanted];
  std::vector<int> numbers;
  for (const Source& source : sources)
  {
    // Coordinates come first, whatever their name is, and others after.
    const std::vector<ArrayHead>& heads = source.Level->Heads;
    const auto at = wanted == 0
      ? heads.begin()
      : std::find_if(heads.begin() + 1, heads.end(),
          [&first](const ArrayHead& head) { return head.Name == first.Name; });
    if (at == heads.end() || at->DataType != first.DataType || at->Components != first.Components)
    {
      return {};
    }
    numbers.push_back(static_cast<int>(at - heads.begin()));
  }
  return numbers;
}

/// The array's tuples of all sources; none: they cannot be read.
vtkSmartPointer<vtkAbstractArray> ReadOfAll(
  const std::vector<Source>& sources, const std::vector<int>& numbers, vtkIdType count)
{
  vtkSmartPointer<vtkAbstractArray> array =
    NewArray(sources[0].Level->Heads[static_cast<size_t>(numbers[0])]);
  if (!array)
  {
    return nullptr;
  }
  array->SetNumberOfTuples(count);
  vtkIdType at = 0;
  for (size_t i = 0; i < sources.size(); ++i)
  {
    if (!ReadTuples(sources[i].Level->Group, numbers[i], sources[i].Runs, array, at))
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
  if (!group)
  {
    return false;
  }
  const std::vector<ArrayHead> heads = ReadHeads(group);
  for (size_t a = 0; a < heads.size(); ++a)
  {
    const auto array = ReadArray(group, static_cast<int>(a), heads[a]);
    if (!array)
    {
      return false;
    }
    data->AddArray(array);
  }
  return true;
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
  const std::vector<Source> sources = SourcesOf(cut, runs);
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
  const std::vector<ArrayHead>& heads = sources[0].Level->Heads;
  for (size_t a = 0; a < heads.size() && !this->AbortExecute; ++a)
  {
    const std::vector<int> numbers =
      a > 0 && IsOfLevelsAlone(heads[a].Name) ? std::vector<int>() : NumbersOf(sources, a);
    if (numbers.empty() && a > 0)
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> array =
      numbers.empty() ? nullptr : ReadOfAll(sources, numbers, count);
    auto* coordinates = a == 0 ? vtkDataArray::SafeDownCast(array) : nullptr;
    if (!array || (a == 0 && !coordinates))
    {
      return damaged();
    }
    if (a == 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(coordinates);
      output->SetPoints(points);
    }
    else
    {
      const int index = data->AddArray(array);
      const int role = heads[a].Role;
      if (role >= 0 && role < vtkDataSetAttributes::NUM_ATTRIBUTES)
      {
        data->SetActiveAttribute(index, role);
      }
    }
    this->UpdateProgress(0.1 + 0.9 * (a + 1.0) / heads.size());
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
