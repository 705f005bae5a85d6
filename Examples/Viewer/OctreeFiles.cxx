// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeFiles.h"

#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#if SPLATVIEW_HDF5
#include "vtkPointSplatOctreeReader.h"
#include "vtkPointSplatOctreeWriter.h"

#include <cstdio>

namespace
{
// Splats that are drawn of a file unless --points says otherwise: 128 MB of the graphics card, and
// some more than a large window has pixels.
constexpr vtkIdType UsualPoints = 4000000;

/// What VTK said is wrong, as the user's error.
void ThrowError(const std::string& before = "")
{
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    throw UserError(before + error);
  }
}

class ReaderStream : public OctreeStream
{
public:
  ReaderStream(const std::string& file, const Options& options)
    : Name(file)
    , Most(options.MostPoints > 0 ? options.MostPoints : UsualPoints)
  {
    this->Reader->SetFileName(file.c_str());
    this->Reader->SetMaximumNumberOfPoints(1);
    this->Reader->UpdateInformation();
    ShowProgress(this->Reader, "reading", options.Quiet);
  }
  bool IsLarge() const { return this->Reader->GetNumberOfPointsInFile() > this->Most; }
  void Read()
  {
    this->Reader->Update();
    ThrowError(this->Name + ": ");
  }

  vtkPolyDataAlgorithm* GetSource() override { return this->Reader; }
  vtkIdType GetNumberOfPointsInFile() const override
  {
    return this->Reader->GetNumberOfPointsInFile();
  }
  vtkBoundingBox GetBoundsInFile() const override
  {
    return vtkBoundingBox(this->Reader->GetBoundsInFile());
  }
  void SetCamera(vtkCamera* camera, const int size[2]) override
  {
    this->Reader->SetCamera(camera);
    this->Reader->SetViewSize(size);
    this->Reader->SetMaximumNumberOfPoints(this->Most);
    this->Read();
  }
  bool Follow(const int size[2]) override
  {
    this->Reader->SetViewSize(size);
    return this->Reader->FollowCamera();
  }
  bool Prefetch(double seconds) override { return this->Reader->Prefetch(seconds); }

private:
  const std::string Name;
  const vtkIdType Most;
  vtkNew<vtkPointSplatOctreeReader> Reader;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadOctree(const std::string& file, long most, bool quiet)
{
  vtkNew<vtkPointSplatOctreeReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetMaximumNumberOfPoints(most);
  reader->SetCacheSize(0);
  ShowProgress(reader, "reading", quiet);
  reader->Update();
  return reader->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
std::shared_ptr<OctreeStream> OpenStream(const std::string& file, const Options& options)
{
  // What needs points, and not what stands for them, reads as many as there are.
  if (!IsOctree(file) || !vtkPointSplatOctreeReader::CanReadFile(file.c_str()) ||
    !options.Isovalues.empty() || options.Particles || options.Project ||
    options.Normals == "estimate")
  {
    return nullptr;
  }
  auto stream = std::make_shared<ReaderStream>(file, options);
  if (!stream->IsLarge())
  {
    return nullptr;
  }
  stream->Read();
  return stream;
}

//------------------------------------------------------------------------------
void ConvertFiles(const Options& options)
{
  vtkNew<vtkPointSplatOctreeWriter> writer;
  writer->SetFileName(options.Output.c_str());
  writer->SetAppendToFile(options.AppendToFile);
  ShowProgress(writer, "making levels", options.Quiet);
  writer->Open();
  ThrowError();
  for (const std::string& file : options.Files)
  {
    for (const auto& one : ReadFile(file, options.Quiet, 0))
    {
      vtkPointSet* points = vtkPointSet::SafeDownCast(one.second);
      if (!points)
      {
        throw UserError(file + ": holds a volume; points are wanted");
      }
      writer->Append(points);
      ThrowError();
    }
  }
  writer->Close();
  ThrowError();
  if (!options.Quiet)
  {
    std::printf("%lld points in %d pieces, written to %s\n",
      static_cast<long long>(writer->GetNumberOfPointsWritten()),
      writer->GetNumberOfPiecesWritten(), options.Output.c_str());
  }
}
#else
//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadOctree(const std::string& file, long, bool)
{
  throw UserError(file + ": cannot be read, since this VTK was built without HDF5");
}

//------------------------------------------------------------------------------
std::shared_ptr<OctreeStream> OpenStream(const std::string&, const Options&)
{
  return nullptr;
}

//------------------------------------------------------------------------------
void ConvertFiles(const Options&)
{
  throw UserError("--convert: this VTK was built without HDF5");
}
#endif
