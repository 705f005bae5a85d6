// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeFiles.h"

#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkNew.h"
#include "vtkPointSet.h"

#if SPLATVIEW_HDF5
#include "vtkPointSplatOctreeReader.h"
#include "vtkPointSplatOctreeWriter.h"

#include <cstdio>

namespace
{
/// What VTK said is wrong, as the user's error.
void ThrowError()
{
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    throw UserError(error);
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadOctree(const std::string& file, long most, bool quiet)
{
  vtkNew<vtkPointSplatOctreeReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetMaximumNumberOfPoints(most);
  ShowProgress(reader, "reading", quiet);
  reader->Update();
  return reader->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
void ConvertFiles(const Options& options)
{
  vtkNew<vtkPointSplatOctreeWriter> writer;
  writer->SetFileName(options.Output.c_str());
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
void ConvertFiles(const Options&)
{
  throw UserError("--convert: this VTK was built without HDF5");
}
#endif
