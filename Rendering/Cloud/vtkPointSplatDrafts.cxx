// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDrafts.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace
{
using vtkPointSplatArrays::Geometry;

// Two thirds of a second until the first picture, on one core.
constexpr vtkIdType FirstPoints = vtkIdType(1) << 17;
// All drafts together take a seventh of the cloud's own time, at most.
constexpr vtkIdType Growth = 8;
// Fewer are there within three seconds: those whose sizes must be estimated, and others.
constexpr vtkIdType LeastPoints = vtkIdType(1) << 20;
constexpr vtkIdType LeastSizedPoints = vtkIdType(1) << 23;

bool IsSized(vtkPointSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  return arrays->GetNormals() &&
    (arrays->GetArray(vtkPointSplatArrays::Radius) || arrays->GetArray(vtkPointSplatArrays::Axis1));
}

/// Some number for each i, without order.
uint64_t Scatter(uint64_t i)
{
  i = (i ^ (i >> 31)) * 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 29)) * 0xbf58476d1ce4e5b9u;
  return i ^ (i >> 32);
}

template <typename Array>
vtkSmartPointer<Array> CopyOf(Array* array)
{
  vtkSmartPointer<Array> copy;
  copy.TakeReference(array->NewInstance());
  copy->DeepCopy(array);
  return copy;
}

/// All that splats are made from, and nothing else, in arrays that nobody else has.
vtkSmartPointer<vtkPointSet> CopyForThread(vtkPointSet* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(CopyOf(data->GetPoints()->GetData()));
  copy->SetPoints(points);
  vtkPointData* given = data->GetPointData();
  vtkPointData* arrays = copy->GetPointData();
  if (vtkDataArray* normals = given->GetNormals())
  {
    arrays->SetNormals(CopyOf(normals));
  }
  std::vector<const char*> names(std::begin(Geometry), std::end(Geometry));
  names.insert(names.end(),
    { vtkPointSplatArrays::Sensor, vtkPointSplatArrays::Scan, vtkPointSplatArrays::Group,
      vtkDataSetAttributes::GhostArrayName() });
  for (const char* name : names)
  {
    if (vtkAbstractArray* array = given->GetAbstractArray(name))
    {
      arrays->AddArray(CopyOf(array));
    }
  }
  // What tells points of one place apart, too.
  if (vtkDataArray* coordinates = given->GetTCoords())
  {
    arrays->SetTCoords(CopyOf(coordinates));
  }
  if (vtkDataArray* tangents = given->GetTangents())
  {
    arrays->SetTangents(CopyOf(tangents));
  }
  if (vtkDataArray* normals = data->GetCellData()->GetNormals())
  {
    copy->GetCellData()->SetNormals(CopyOf(normals));
  }
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(data))
  {
    copy->SetVerts(CopyOf(mesh->GetVerts()));
    copy->SetLines(CopyOf(mesh->GetLines()));
    copy->SetPolys(CopyOf(mesh->GetPolys()));
    copy->SetStrips(CopyOf(mesh->GetStrips()));
  }
  else if (auto grid = vtkUnstructuredGrid::SafeDownCast(data); grid && grid->GetCells())
  {
    // All that its cells say is which points are shown.
    copy->SetVerts(CopyOf(grid->GetCells()));
  }
  copy->GetFieldData()->DeepCopy(data->GetFieldData());
  return copy;
}

void Silence(vtkObject*, unsigned long, void*, void*) {}

vtkNew<vtkIdList> ListOf(const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), list->GetPointer(0));
  return list;
}
}

/**
 * What the thread does: a cloud, from a copy of some points. Nobody else has what is in it, but for
 * what is atomic.
 */
class vtkPointSplatDrafts::Task
{
public:
  Task(Part part, vtkPointSet* data, const vtkPointSplatCloudInput& input, bool levels)
    : OfPart(std::move(part))
  {
    this->Input.Data = this->Copy = CopyForThread(data);
    this->Input.Owner = this->Owner;
    this->Input.NeedSizes = input.NeedSizes;
    this->Input.ProjectNoise = input.ProjectNoise;
    this->Input.FillGaps = input.FillGaps;
    this->Input.FillMeshGaps = input.FillMeshGaps;
    vtkNew<vtkCallbackCommand> follow;
    follow->SetCallback(Task::Follow);
    follow->SetClientData(this);
    for (unsigned long event :
      { vtkCommand::ProgressEvent, vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      this->Owner->AddObserver(event, follow);
    }
    this->Work = std::async(std::launch::async, [this, levels] {
      this->Cloud->Update(this->Input);
      if (levels && !this->Stopped)
      {
        this->Cloud->MakeLevels();
      }
      // Its sources are not needed any more.
      this->Input.Data = nullptr;
      this->Copy = nullptr;
    });
  }
  ~Task()
  {
    this->Stopped = true;
    this->Cloud->AbortLevels();
    this->Wait();
  }
  Task(const Task&) = delete;
  void operator=(const Task&) = delete;

  void Wait()
  {
    if (this->Work.valid())
    {
      this->Work.get();
    }
  }
  bool IsReady() const
  {
    return !this->Work.valid() ||
      this->Work.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  /// Repeats what was said in the thread in the name of another.
  void Repeat(vtkObject* owner) const
  {
    for (const std::pair<unsigned long, std::string>& message : this->Messages)
    {
      if (message.first == vtkCommand::ErrorEvent)
      {
        vtkErrorWithObjectMacro(owner, << message.second);
      }
      else
      {
        vtkWarningWithObjectMacro(owner, << message.second);
      }
    }
  }

  Part OfPart; // none: of all
  // Of all: what it is made from.
  vtkPointSplatCloud::Key MadeFrom;
  vtkPointSplatCloud::Key StaysFrom;
  CloudPointer Cloud{ new vtkPointSplatCloud };
  std::atomic<double> Progress{ 0.0 };

private:
  static void Follow(vtkObject*, unsigned long event, void* task, void* data)
  {
    Task& self = *static_cast<Task*>(task);
    if (event == vtkCommand::ProgressEvent)
    {
      self.Progress = *static_cast<double*>(data);
      self.Owner->SetAbortExecute(self.Stopped);
      return;
    }
    // "ERROR: In file, line 1\nvtkAlgorithm (0x...): text\n\n"
    std::string text = static_cast<const char*>(data);
    const size_t begin = text.find("): ");
    text = begin == std::string::npos ? text : text.substr(begin + 3);
    text.erase(text.find_last_not_of('\n') + 1);
    self.Messages.emplace_back(event, text);
  }

  vtkSmartPointer<vtkPointSet> Copy;
  vtkPointSplatCloudInput Input;
  vtkNew<vtkAlgorithm> Owner;
  std::atomic<bool> Stopped{ false };
  std::vector<std::pair<unsigned long, std::string>> Messages;
  std::future<void> Work;
};

//------------------------------------------------------------------------------
vtkPointSplatDrafts::vtkPointSplatDrafts() = default;
vtkPointSplatDrafts::~vtkPointSplatDrafts() = default;

//------------------------------------------------------------------------------
bool vtkPointSplatDrafts::AreOfUse(const vtkPointSplatCloudInput& input)
{
  vtkPointSet* data = vtkPointSet::SafeDownCast(input.Data);
  if (!data || !data->GetPoints() || !input.Looks.empty() ||
    data->GetNumberOfPoints() <
      (IsSized(data) || !input.NeedSizes ? LeastSizedPoints : LeastPoints))
  {
    return false;
  }
  int cellFlag = 0;
  return !input.FindScalars || !input.FindScalars(data, cellFlag) || cellFlag == 0;
}

//------------------------------------------------------------------------------
vtkPointSplatDrafts::Part vtkPointSplatDrafts::Choose(vtkPointSet* data, vtkIdType count)
{
  Part part;
  const vtkIdType n = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType begin = i * n / count;
    const uint64_t width = static_cast<uint64_t>((i + 1) * n / count - begin);
    part.Ids.push_back(begin + static_cast<vtkIdType>(Scatter(static_cast<uint64_t>(i)) % width));
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(data->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  data->GetPoints()->GetPoints(ListOf(part.Ids), points);
  part.Data = vtkSmartPointer<vtkPolyData>::New();
  part.Data->SetPoints(points);
  CopyArrays(data, part);
  return part;
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::CopyArrays(vtkPointSet* from, Part& part)
{
  const vtkIdType count = static_cast<vtkIdType>(part.Ids.size());
  vtkPointData* given = from->GetPointData();
  // Normals stay the same object, from which splats were made.
  vtkSmartPointer<vtkDataArray> normals = part.Data->GetPointData()->GetNormals();
  vtkSmartPointer<vtkDataArray> ghosts =
    part.Data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  part.Data->GetPointData()->Initialize();
  part.Data->GetFieldData()->PassData(from->GetFieldData());
  const vtkNew<vtkIdList> ids = ListOf(part.Ids);
  for (int a = 0; a < given->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = given->GetAbstractArray(a);
    const char* name = array->GetName();
    const bool geometry = name &&
      std::any_of(std::begin(Geometry), std::end(Geometry),
        [name](const char* other) { return std::string(name) == other; });
    const bool ofGhosts = name && std::string(name) == vtkDataSetAttributes::GhostArrayName();
    // Sizes are those of all points together; and what is too short is refused where it is read.
    if (geometry || ofGhosts || array->GetNumberOfTuples() != from->GetNumberOfPoints())
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> some;
    const int attribute = given->IsArrayAnAttribute(a);
    if (attribute == vtkDataSetAttributes::NORMALS && normals)
    {
      some = normals;
    }
    else
    {
      some.TakeReference(array->NewInstance());
      some->SetNumberOfComponents(array->GetNumberOfComponents());
      some->SetNumberOfTuples(count);
      some->SetName(name);
      array->GetTuples(ids, some);
      if (auto data = vtkDataArray::SafeDownCast(array))
      {
        // A table of its own, and the range of all that it maps.
        static_cast<vtkDataArray*>(some.Get())->SetLookupTable(data->GetLookupTable());
      }
    }
    const int index = part.Data->GetPointData()->AddArray(some);
    if (attribute >= 0)
    {
      part.Data->GetPointData()->SetActiveAttribute(index, attribute);
    }
  }
  const vtkSmartPointer<vtkUnsignedCharArray> all =
    ghosts ? nullptr : vtkPointSplatPacking::GhostsOf(from);
  if (all)
  {
    // The part has no cells that could tell.
    vtkNew<vtkUnsignedCharArray> some;
    some->SetName(vtkDataSetAttributes::GhostArrayName());
    some->SetNumberOfTuples(count);
    all->GetTuples(ids, some);
    ghosts = some;
  }
  if (ghosts)
  {
    part.Data->GetPointData()->AddArray(ghosts);
  }
}

//------------------------------------------------------------------------------
vtkPointSplatCloudInput vtkPointSplatDrafts::InputOf(const Part& part) const
{
  vtkPointSplatCloudInput input = this->Input;
  input.Data = part.Data;
  input.Whole = this->Data;
  input.WholeIds = &part.Ids;
  input.ProjectNoise = input.FillGaps = false;
  return input;
}

//------------------------------------------------------------------------------
bool vtkPointSplatDrafts::Update(
  const vtkPointSplatCloudInput& input, const vtkPointSplatCloud& cloud)
{
  if (!vtkPointSplatDrafts::AreOfUse(input) || cloud.IsMadeFrom(input))
  {
    this->Stop();
    return false;
  }
  const vtkPointSplatCloud::Key key = vtkPointSplatCloud::KeyOf(input);
  const bool alike = this->Draft && input.NeedSizes == this->Input.NeedSizes &&
    input.ProjectNoise == this->Input.ProjectNoise && input.FillGaps == this->Input.FillGaps &&
    input.FillMeshGaps == this->Input.FillMeshGaps;
  const bool same = alike && key == this->MadeFrom;
  const bool moved = alike && !same && this->IsMoved(input);
  this->Input = input;
  this->Data = static_cast<vtkPointSet*>(input.Data);
  if (moved)
  {
    ++this->Moves;
    if (this->Work && !this->IsWhole(*this->Work))
    {
      this->Work.reset();
    }
    this->MadeFrom = key;
    this->Rested = false;
    this->Drawn = vtkPointSplatDrafts::Choose(this->Data, static_cast<vtkIdType>(this->Drawn.Ids.size()));
    this->DataTime = this->Data->GetMTime();
  }
  else if (!same)
  {
    this->Stop();
    this->MadeFrom = key;
    this->StaysFrom = vtkPointSplatCloud::StayingKeyOf(input);
    if (auto algorithm = vtkAlgorithm::SafeDownCast(input.Owner))
    {
      algorithm->SetAbortExecute(0); // of a time before, as executives do
    }
    this->Drawn = vtkPointSplatDrafts::Choose(this->Data, FirstPoints);
    this->Draft.reset(new vtkPointSplatCloud);
    this->DataTime = this->Data->GetMTime();
  }
  else if (this->DataTime < this->Data->GetMTime())
  {
    vtkPointSplatDrafts::CopyArrays(this->Data, this->Drawn);
    this->DataTime = this->Data->GetMTime();
  }
  vtkPointSplatCloudInput drawn = this->InputOf(this->Drawn);
  // What there is to say of bad points is said of all of them, once.
  vtkNew<vtkAlgorithm> nobody;
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback(Silence);
  nobody->AddObserver(vtkCommand::ErrorEvent, silence);
  nobody->AddObserver(vtkCommand::WarningEvent, silence);
  drawn.Owner = nobody;
  this->Draft->Update(drawn);
  if (this->Draft->GetNumberOfSplats() == 0)
  {
    this->Stop();
    return false;
  }
  // Once may be by chance.
  if (this->Moves > 1 && !this->Work && !this->GivenUp)
  {
    this->BeginWhole();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatDrafts::IsMoved(const vtkPointSplatCloudInput& input) const
{
  return input.FollowMotion && vtkPointSplatCloud::StayingKeyOf(input) == this->StaysFrom;
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::Begin()
{
  const vtkIdType n = this->Data->GetNumberOfPoints();
  const vtkIdType count = Growth * static_cast<vtkIdType>(this->Drawn.Ids.size());
  if (2 * count > n)
  {
    this->BeginWhole();
    return;
  }
  Part part = vtkPointSplatDrafts::Choose(this->Data, count);
  vtkPointSet* data = part.Data;
  vtkPointSplatCloudInput input = this->InputOf(part);
  this->Work.reset(new Task(std::move(part), data, input, false));
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::BeginWhole()
{
  this->Work.reset(new Task(Part(), this->Data, this->Input, this->Draft->AreLevelsWanted()));
  this->Work->MadeFrom = this->MadeFrom;
  this->Work->StaysFrom = this->StaysFrom;
}

//------------------------------------------------------------------------------
bool vtkPointSplatDrafts::IsWhole(const Task& task) const
{
  return task.OfPart.Ids.empty();
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::TakeOver(CloudPointer& cloud)
{
  this->Work->Wait();
  if (this->IsWhole(*this->Work))
  {
    this->Work->Cloud->Adopt(std::move(this->Work->MadeFrom), std::move(this->Work->StaysFrom));
    cloud = std::move(this->Work->Cloud);
    this->Work->Cloud.reset(new vtkPointSplatCloud);
    this->Work->Repeat(this->Input.Owner);
    this->Stop();
    return;
  }
  this->Drawn = std::move(this->Work->OfPart);
  const vtkPointSplatCloudInput input = this->InputOf(this->Drawn);
  this->Work->Cloud->Adopt(vtkPointSplatCloud::KeyOf(input), vtkPointSplatCloud::StayingKeyOf(input));
  this->Draft = std::move(this->Work->Cloud);
  this->Work->Cloud.reset(new vtkPointSplatCloud);
  this->Work.reset();
}

//------------------------------------------------------------------------------
bool vtkPointSplatDrafts::Advance(CloudPointer& cloud)
{
  // Points that were changed since the last frame are for the next one to see.
  if (!this->IsUnderWay() || !this->Data ||
    vtkPointSplatCloud::KeyOf(this->Input) != this->MadeFrom)
  {
    return false;
  }
  auto algorithm = vtkAlgorithm::SafeDownCast(this->Input.Owner);
  if (algorithm && this->Work)
  {
    algorithm->UpdateProgress(this->GetProgress());
    if (algorithm->GetAbortExecute())
    {
      this->Work.reset();
      this->GivenUp = true;
      return false;
    }
  }
  if (!this->Work && this->Rested)
  {
    this->Begin();
  }
  this->Rested = true;
  if (!this->Work)
  {
    return false;
  }
  if (!this->Work->IsReady())
  {
    return false;
  }
  this->TakeOver(cloud);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::TakeMoving(CloudPointer& cloud)
{
  if (this->Moves > 0 && this->Work && this->IsWhole(*this->Work) && this->Work->IsReady())
  {
    this->TakeOver(cloud);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::Finish(CloudPointer& cloud)
{
  if (this->Work && this->IsWhole(*this->Work))
  {
    this->TakeOver(cloud);
  }
  this->Stop();
}

//------------------------------------------------------------------------------
void vtkPointSplatDrafts::Stop()
{
  this->Work.reset();
  this->Draft.reset();
  this->Drawn = Part();
  this->MadeFrom.clear();
  this->StaysFrom.clear();
  this->Moves = 0;
  this->GivenUp = this->Rested = false;
}

//------------------------------------------------------------------------------
double vtkPointSplatDrafts::GetProgress() const
{
  return this->Work ? this->Work->Progress.load() : 0.0;
}
