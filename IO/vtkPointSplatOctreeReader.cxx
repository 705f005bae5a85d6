// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeReader.h"

#include "vtkPointSplatChunkCache.h"
#include "vtkPointSplatHDF5.h"
#include "vtkPointSplatOctreeCut.h"
#include "vtkPointSplatOctreeInput.h"
#include "vtkPointSplatOctreeSplats.h"
#include "vtkPointSplatOctreeView.h"

#include "vtkAbstractArray.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatOctreeReader);

namespace
{
using namespace vtkPointSplatHDF5;

constexpr vtkTypeInt64 Kibibyte = 1024;
// A cut is read anew where more of its splats than this share are others.
constexpr double ShareThatMatters = 0.02;

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

/**
 * What is kept between executions.
 */
class vtkPointSplatOctreeReader::Stream
{
public:
  Stream() { this->Cache.SetBudget(512 * Kibibyte * Kibibyte); }

  void Close()
  {
    this->File.reset();
    this->Cache.Clear();
    this->Read.clear();
    this->Ahead.reset();
  }
  /// The cut that is wanted of the file, seen so.
  vtkPointSplatOctreeCut::Runs Cut(
    const vtkPointSplatOctreeReader& self, const vtkPointSplatOctreeView* view) const
  {
    vtkPointSplatOctreeCut::Wish wish{ self.MaximumNumberOfPoints, vtkBoundingBox(), view,
      self.SplatPixels };
    const double* b = self.Bounds;
    if (b[0] <= b[1] && b[2] <= b[3] && b[4] <= b[5])
    {
      wish.Box.SetBounds(b);
    }
    if (view && !view->IsValid())
    {
      // Nothing is too large: the coarsest blocks.
      wish.View = nullptr;
      wish.Room = 1;
    }
    return this->File->GetTree().Make(wish);
  }
  /// Remembers how the camera moves.
  void Note(const vtkPointSplatOctreeView& view)
  {
    if (!this->Now || !(*this->Now == view))
    {
      this->Before = this->Now;
      this->Now = view;
    }
    this->Ahead.reset();
  }
  /// Chunks that are not in the cache, and will be wanted if the camera moves on.
  std::vector<vtkPointSplatChunkCache::Key> ChunksAhead(const vtkPointSplatOctreeReader& self) const
  {
    const vtkPointSplatOctreeView next = this->Now->After(*this->Before);
    if (!next.IsValid())
    {
      return {};
    }
    std::vector<vtkPointSplatChunkCache::Key> chunks =
      vtkPointSplatOctreeSplats(this->File->GetTree(), this->Cut(self, &next)).GetChunks();
    chunks.erase(std::remove_if(chunks.begin(), chunks.end(),
                   [this](const vtkPointSplatChunkCache::Key& key) { return this->Cache.Has(key); }),
      chunks.end());
    // The last is read first: coordinates, then others.
    std::reverse(chunks.begin(), chunks.end());
    return chunks;
  }
  /// False: it cannot be read, or there is no room.
  bool ReadAhead(const vtkPointSplatChunkCache::Key& key)
  {
    const vtkSmartPointer<vtkAbstractArray> chunk =
      vtkPointSplatOctreeSplats::ReadChunk(this->File->GetTree(), key);
    if (!chunk || !this->Cache.HasRoomBesideCut(chunk))
    {
      return false;
    }
    this->Cache.Add(key, chunk);
    return true;
  }

  std::unique_ptr<vtkPointSplatOctreeInput> File; // with its tree, once something was read
  vtkPointSplatChunkCache Cache;
  vtkPointSplatOctreeCut::Runs Read; // the cut that is the output
  bool IsBehind = false;             // the camera wants another
  std::optional<vtkPointSplatOctreeView> Before;
  std::optional<vtkPointSplatOctreeView> Now;
  std::optional<std::vector<vtkPointSplatChunkCache::Key>> Ahead; // once it is known
};

//------------------------------------------------------------------------------
vtkPointSplatOctreeReader::vtkPointSplatOctreeReader()
  : Input(new Stream)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeReader::~vtkPointSplatOctreeReader()
{
  this->CloseFile();
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeReader::CanReadFile(const char* fileName)
{
  const Silence silence;
  return vtkPointSplatOctreeInput(fileName).GetError().empty();
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeReader::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    // How another camera has moved says nothing of this one.
    this->Input->Before.reset();
    this->Input->Now.reset();
    this->Input->Ahead.reset();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkPointSplatOctreeReader::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeReader::SetViewSize(int width, int height)
{
  const int size[2] = { std::max(width, 1), std::max(height, 1) };
  if (!std::equal(size, size + 2, this->ViewSize))
  {
    std::copy(size, size + 2, this->ViewSize);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeReader::SetCacheSize(vtkIdType size)
{
  // The output is the same, so that nothing has to run again.
  const vtkIdType most = VTK_ID_MAX / Kibibyte;
  this->Input->Cache.SetBudget(std::min(std::max<vtkIdType>(size, 0), most) * Kibibyte);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeReader::GetCacheSize()
{
  return static_cast<vtkIdType>(this->Input->Cache.GetBudget() / Kibibyte);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeReader::GetCacheSizeUsed()
{
  return static_cast<vtkIdType>(this->Input->Cache.GetSize() / Kibibyte);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkPointSplatOctreeReader::GetNumberOfBytesRead()
{
  return this->Input->Cache.GetSizeOfAdded();
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeReader::CloseFile()
{
  const Silence silence;
  this->Input->Close();
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeReader::OpenFile()
{
  if (this->Input->File && this->Input->File->Is(this->FileName))
  {
    return true;
  }
  // The old one is closed before: HDF5 would take the same file for what it knows of it.
  this->Input->Close();
  auto file = std::make_unique<vtkPointSplatOctreeInput>(this->FileName);
  if (!file->GetError().empty())
  {
    vtkErrorMacro(<< file->GetError());
    return false;
  }
  this->Input->File = std::move(file);
  return true;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeReader::GiveUp()
{
  this->Input->Close();
  vtkErrorMacro("'" << this->FileName << "' is damaged.");
  return 0;
}

//------------------------------------------------------------------------------
int vtkPointSplatOctreeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const Silence silence;
  if (!this->OpenFile())
  {
    // What was read of another file would stay, since RequestData() is not called.
    if (vtkPolyData* old = vtkPolyData::GetData(outputs))
    {
      old->Initialize();
    }
    return 0;
  }
  const vtkPointSplatOctreeInput& file = *this->Input->File;
  this->NumberOfPointsInFile = static_cast<vtkIdType>(file.GetNumberOfPoints());
  std::copy(file.GetBounds().begin(), file.GetBounds().end(), this->BoundsInFile);
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
  Stream& stream = *this->Input;
  this->CoarsestLevelRead = 0;
  if (!this->OpenFile())
  {
    return 0;
  }
  if (!stream.File->ReadTree())
  {
    return this->GiveUp();
  }
  this->UpdateProgress(0.1);
  std::optional<vtkPointSplatOctreeView> view;
  if (this->Camera)
  {
    view.emplace(this->Camera, this->ViewSize[0], this->ViewSize[1]);
    if (!view->IsValid())
    {
      vtkWarningMacro("The camera has no place, no direction, or numbers that are none; the "
                      "coarsest blocks are read.");
    }
    stream.Note(*view);
  }
  stream.Read = stream.Cut(*this, view ? &*view : nullptr);
  stream.IsBehind = false;
  stream.Cache.BeginCut();
  for (const auto& one : stream.Read)
  {
    this->CoarsestLevelRead = std::max(this->CoarsestLevelRead, one.first.second);
  }
  const vtkPointSplatOctreeSplats splats(stream.File->GetTree(), stream.Read);
  if (splats.GetNumberOfSplats() == 0)
  {
    return 1;
  }
  vtkPointData* data = output->GetPointData();
  const size_t count = splats.GetNumberOfArrays();
  bool good = count > 0;
  for (size_t a = 0; a < count && good && !this->AbortExecute; ++a)
  {
    const vtkSmartPointer<vtkAbstractArray> array = splats.Read(a, stream.Cache);
    auto* coordinates = a == 0 ? vtkDataArray::SafeDownCast(array) : nullptr;
    good = array && (a > 0 || coordinates);
    if (good && a == 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(coordinates);
      output->SetPoints(points);
    }
    else if (good)
    {
      const int index = data->AddArray(array);
      const int role = splats.GetHead(a).Role;
      if (role >= 0 && role < vtkDataSetAttributes::NUM_ATTRIBUTES)
      {
        data->SetActiveAttribute(index, role);
      }
    }
    this->UpdateProgress(0.1 + 0.9 * (a + 1.0) / count);
  }
  if (!good || !ReadFieldData(stream.File->GetData(), output->GetFieldData()))
  {
    output->Initialize();
    return this->GiveUp();
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeReader::FollowCamera()
{
  Stream& stream = *this->Input;
  if (!this->Camera || !stream.File || stream.Read.empty())
  {
    return false;
  }
  if (!stream.File->Is(this->FileName))
  {
    this->Modified();
    return true;
  }
  const vtkPointSplatOctreeView view(this->Camera, this->ViewSize[0], this->ViewSize[1]);
  if (stream.Now && *stream.Now == view)
  {
    return stream.IsBehind;
  }
  stream.Note(view);
  const vtkPointSplatOctreeCut::Runs wanted = stream.Cut(*this, &view);
  const vtkIdType all =
    vtkPointSplatOctreeCut::CountOf(wanted) + vtkPointSplatOctreeCut::CountOf(stream.Read);
  const vtkIdType common = vtkPointSplatOctreeCut::CountOfCommon(wanted, stream.Read);
  stream.IsBehind = all - 2 * common > ShareThatMatters * all;
  if (stream.IsBehind)
  {
    this->Modified();
  }
  return stream.IsBehind;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeReader::Prefetch(double seconds)
{
  const Silence silence;
  Stream& stream = *this->Input;
  if (!this->Camera || !stream.File || stream.Read.empty() || !stream.Before ||
    !stream.File->Is(this->FileName))
  {
    return false;
  }
  const auto start = std::chrono::steady_clock::now();
  if (!stream.Ahead)
  {
    stream.Ahead = stream.ChunksAhead(*this);
  }
  std::chrono::duration<double> spent(0.0);
  do
  {
    if (stream.Ahead->empty() || !stream.ReadAhead(stream.Ahead->back()))
    {
      // What is damaged is for the next Update() to say.
      stream.Ahead->clear();
      return false;
    }
    stream.Ahead->pop_back();
    spent = std::chrono::steady_clock::now() - start;
  } while (spent.count() < seconds);
  return !stream.Ahead->empty();
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
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewSize: " << this->ViewSize[0] << ", " << this->ViewSize[1] << "\n";
  os << indent << "SplatPixels: " << this->SplatPixels << "\n";
  os << indent << "CacheSize: " << this->GetCacheSize() << "\n";
  os << indent << "CacheSizeUsed: " << this->GetCacheSizeUsed() << "\n";
  os << indent << "NumberOfBytesRead: " << this->GetNumberOfBytesRead() << "\n";
  os << indent << "NumberOfPointsInFile: " << this->NumberOfPointsInFile << "\n";
  print("BoundsInFile", this->BoundsInFile);
  os << indent << "CoarsestLevelRead: " << this->CoarsestLevelRead << "\n";
}
VTK_ABI_NAMESPACE_END
