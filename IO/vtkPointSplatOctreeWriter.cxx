// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeWriter.h"

#include "vtkPointSplatArrays.h"
#include "vtkPointSplatHDF5.h"
#include "vtkPointSplatOctree.h"
#include "vtkPointSplatOctreeFile.h"
#include "vtkPointSplatOctreeInput.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatOctreeWriter);

namespace
{
using namespace vtkPointSplatHDF5;
namespace Names = vtkPointSplatOctreeFile;

std::vector<double> BoundsOf(const vtkBoundingBox& box)
{
  std::vector<double> bounds(6);
  box.GetBounds(bounds.data());
  return bounds;
}

bool IsOfBlocks(const char* name)
{
  return name &&
    std::any_of(std::begin(Names::BlockArrays), std::end(Names::BlockArrays),
      [name](const char* other) { return std::string(other) == name; });
}

/// Whether there is data at the pipeline's beginning, which comes as a whole whatever is asked for.
bool IsInMemory(vtkAlgorithm* algorithm)
{
  if (vtkTrivialProducer::SafeDownCast(algorithm))
  {
    return true;
  }
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      if (IsInMemory(algorithm->GetInputAlgorithm(port, i)))
      {
        return true;
      }
    }
  }
  return false;
}

/// Point data and coordinates of some points. unknown: names of arrays that cannot be written.
bool WritePoints(hid_t piece, const std::string& name, vtkPolyData* from, const ArrayWish& wish,
  std::string& unknown)
{
  const Handle group = CreateGroup(piece, name);
  bool good = group && from->GetPoints();
  int number = 0;
  if (good)
  {
    // They have a name of VTK's, which programs need not know.
    const vtkSmartPointer<vtkDataArray> points = from->GetPoints()->GetData();
    const std::string own = points->GetName() ? points->GetName() : "";
    points->SetName("Points");
    good = WriteArray(group, number++, points, wish);
    points->SetName(own.empty() ? nullptr : own.c_str());
  }
  vtkPointData* data = from->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays() && good; ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (!IsKnown(array))
    {
      unknown += std::string(" '") + (array->GetName() ? array->GetName() : "") + "'";
      continue;
    }
    ArrayWish own = wish;
    own.Role = data->IsArrayAnAttribute(a);
    good = WriteArray(group, number++, array, own);
  }
  return good;
}

/// Those of the blocks, or all others.
bool WriteFieldData(hid_t piece, const char* name, vtkFieldData* data, bool blocks, int deflate)
{
  const Handle group = CreateGroup(piece, name);
  bool good = static_cast<bool>(group);
  int number = 0;
  for (int a = 0; a < data->GetNumberOfArrays() && good; ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (IsOfBlocks(array->GetName()) == blocks && IsKnown(array))
    {
      good = WriteArray(
        group, number++, array, { { 0, array->GetNumberOfTuples() }, -1, deflate });
    }
  }
  return good;
}
}

/**
 * What is written, beside its place.
 */
class vtkPointSplatOctreeWriter::File
{
public:
  /// A new one, or a copy of what is in its place.
  File(const std::string& name, bool copy)
    : Name(name)
  {
    // As 1.10 writes it all has checksums, the file's own tables too.
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    const std::string part = name + ".part";
    if (!copy)
    {
      this->Data =
        Handle(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
      return;
    }
    std::error_code error;
    std::filesystem::copy_file(
      name, part, std::filesystem::copy_options::overwrite_existing, error);
    if (!error)
    {
      this->Data = Handle(H5Fopen(part.c_str(), H5F_ACC_RDWR, access), H5Fclose);
    }
    if (!this->Data)
    {
      vtksys::SystemTools::RemoveFile(part);
    }
  }
  ~File()
  {
    if (this->Data)
    {
      this->Data.Close();
      vtksys::SystemTools::RemoveFile(this->Name + ".part");
    }
  }
  /// Whether all is on the disk, and in its place.
  bool Finish()
  {
    const bool good = H5Fflush(this->Data, H5F_SCOPE_GLOBAL) >= 0;
    if (!(this->Data.Close() && good) || !this->PutInPlace())
    {
      vtksys::SystemTools::RemoveFile(this->Name + ".part");
      return false;
    }
    return true;
  }

  const std::string Name;
  Handle Data;
  vtkBoundingBox Bounds;

private:
  bool PutInPlace() const
  {
    // What was there before is replaced in one step.
    std::error_code error;
    std::filesystem::rename(this->Name + ".part", this->Name, error);
    return !error;
  }
};

//------------------------------------------------------------------------------
vtkPointSplatOctreeWriter::vtkPointSplatOctreeWriter() = default;

//------------------------------------------------------------------------------
vtkPointSplatOctreeWriter::~vtkPointSplatOctreeWriter()
{
  const Silence silence;
  this->Output.reset();
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeWriter::Write()
{
  vtkAlgorithmOutput* connection =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputConnection(0, 0) : nullptr;
  if (!connection)
  {
    vtkErrorMacro("There is no input; use SetInputConnection or SetInputData.");
    return 0;
  }
  vtkAlgorithm* producer = connection->GetProducer();
  producer->UpdateInformation();
  const bool divides = producer->GetOutputInformation(connection->GetIndex())
                         ->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) != 0 &&
    !IsInMemory(producer);
  this->Pieces = divides ? this->NumberOfPieces : 1;
  this->AbortExecute = 0;
  this->InvokeEvent(vtkCommand::StartEvent);
  bool good = this->Open();
  for (int piece = 0; piece < this->Pieces && good; ++piece)
  {
    this->Piece = piece;
    producer->UpdatePiece(piece, this->Pieces, 0);
    auto* points = vtkPointSet::SafeDownCast(producer->GetOutputDataObject(connection->GetIndex()));
    good = points && this->Append(points);
  }
  good = good && this->Close();
  this->Output.reset();
  this->Pieces = 1;
  this->Piece = 0;
  this->InvokeEvent(vtkCommand::EndEvent);
  return good ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeWriter::GiveUp(const char* why)
{
  const std::string name = this->FileName ? this->FileName : "";
  this->Output.reset();
  vtkErrorMacro("'" << name << "' was not written: " << why);
  return false;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeWriter::Open()
{
  const Silence silence;
  this->Output.reset();
  this->NumberOfPointsWritten = this->NumberOfSkippedPoints = 0;
  this->NumberOfPiecesWritten = this->NumberOfPiecesBefore = 0;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no FileName.");
    return false;
  }
  if (this->AppendToFile && vtksys::SystemTools::FileExists(this->FileName, true))
  {
    const std::string error = this->TakeOver();
    return error.empty() ? true : this->GiveUp(error.c_str());
  }
  this->Output.reset(new File(this->FileName, false));
  return this->Output->Data ? true : this->GiveUp("its folder is not there, or may not be written.");
}

//------------------------------------------------------------------------------
std::string vtkPointSplatOctreeWriter::TakeOver()
{
  vtkPointSplatOctreeInput input(this->FileName);
  if (!input.GetError().empty())
  {
    return "nothing can be added. " + input.GetError();
  }
  // What is damaged would be handed on, and who wrote this file would take the blame.
  if (!input.ReadTree())
  {
    return "nothing can be added, since it is damaged.";
  }
  this->Output.reset(new File(this->FileName, true));
  if (!this->Output->Data)
  {
    return "it cannot be copied beside its place; the disk may be full, or the folder may not be "
           "written.";
  }
  this->Output->Bounds.SetBounds(input.GetBounds().data());
  this->NumberOfPointsWritten = static_cast<vtkIdType>(input.GetNumberOfPoints());
  this->NumberOfPiecesWritten = this->NumberOfPiecesBefore =
    static_cast<int>(input.GetNumberOfPieces());
  return "";
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeWriter::Append(vtkPointSet* points)
{
  const Silence silence;
  if (!this->Output)
  {
    vtkErrorMacro("No file is open; call Open first.");
    return false;
  }
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return true;
  }
  vtkNew<vtkPointSplatOctree> octree;
  octree->SetInputData(points);
  octree->AddObserver(
    vtkCommand::ProgressEvent, this, &vtkPointSplatOctreeWriter::CarryProgress);
  octree->Update();
  if (this->AbortExecute)
  {
    return this->GiveUp("it was aborted.");
  }
  this->NumberOfSkippedPoints += octree->GetNumberOfSkippedPoints();
  if (octree->GetOutput(0)->GetNumberOfPoints() == 0)
  {
    return true;
  }
  return this->WritePiece(octree->GetOutput(0), octree->GetOutput(1), octree->GetNumberOfLevels())
    ? true
    : this->GiveUp("the disk may be full.");
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeWriter::CarryProgress(vtkObject* octree, unsigned long, void*)
{
  auto* caller = static_cast<vtkAlgorithm*>(octree);
  this->UpdateProgress((this->Piece + 0.9 * caller->GetProgress()) / this->Pieces);
  if (this->AbortExecute)
  {
    caller->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeWriter::WritePiece(
  vtkPolyData* points, vtkPolyData* levels, int numberOfLevels)
{
  const Handle piece =
    CreateGroup(this->Output->Data, "Piece" + std::to_string(this->NumberOfPiecesWritten));
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkBoundingBox box(points->GetBounds());
  bool good = piece && WriteNumbers(piece, "Points", std::vector<long long>{ count }) &&
    WriteNumbers(piece, "Levels", std::vector<long long>{ std::max(numberOfLevels, 1) }) &&
    WriteNumbers(piece, "Bounds", BoundsOf(box));
  std::string unknown;
  good = good &&
    WritePoints(piece, "Level0", points, { { 0, count }, -1, this->CompressionLevel }, unknown);
  vtkDataArray* named = levels->GetPointData()->GetArray(vtkPointSplatArrays::Level);
  Run run{ 0, 0 };
  for (int level = 1; level < numberOfLevels && good; ++level)
  {
    run.First += run.Count;
    run.Count = 0;
    while (run.First + run.Count < levels->GetNumberOfPoints() &&
      named->GetComponent(run.First + run.Count, 0) == level)
    {
      ++run.Count;
    }
    good = WritePoints(piece, "Level" + std::to_string(level), levels,
      { run, -1, this->CompressionLevel }, unknown);
  }
  good = good &&
    WriteFieldData(piece, "Blocks", levels->GetFieldData(), true, this->CompressionLevel) &&
    WriteFieldData(piece, "FieldData", points->GetFieldData(), false, this->CompressionLevel);
  if (!unknown.empty())
  {
    vtkWarningMacro("Arrays of this kind have no place in the file, and are left out:" << unknown);
  }
  this->Output->Bounds.AddBox(box);
  this->NumberOfPointsWritten += count;
  ++this->NumberOfPiecesWritten;
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeWriter::Close()
{
  const Silence silence;
  if (!this->Output)
  {
    vtkErrorMacro("No file is open; call Open first.");
    return false;
  }
  if (this->NumberOfPiecesWritten == this->NumberOfPiecesBefore)
  {
    return this->GiveUp("there is no point that can be drawn.");
  }
  const hid_t file = this->Output->Data;
  const bool good = WriteText(file, "Type", Names::Type) &&
    WriteNumbers(file, "Version", std::vector<long long>{ Names::Version }) &&
    WriteNumbers(file, "Pieces", std::vector<long long>{ this->NumberOfPiecesWritten }) &&
    WriteNumbers(file, "Points", std::vector<long long>{ this->NumberOfPointsWritten }) &&
    WriteNumbers(file, "Bounds", BoundsOf(this->Output->Bounds));
  if (!good || !this->Output->Finish())
  {
    return this->GiveUp("the disk may be full.");
  }
  this->Output.reset();
  this->UpdateProgress(1.0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "CompressionLevel: " << this->CompressionLevel << "\n";
  os << indent << "AppendToFile: " << (this->AppendToFile ? "on" : "off") << "\n";
  os << indent << "NumberOfPointsWritten: " << this->NumberOfPointsWritten << "\n";
  os << indent << "NumberOfPiecesWritten: " << this->NumberOfPiecesWritten << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
}
VTK_ABI_NAMESPACE_END
