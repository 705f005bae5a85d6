// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeInput.h"

#include "vtkPointSplatOctreeFile.h"

#include <vtksys/SystemTools.hxx>

#include <system_error>

namespace
{
using namespace vtkPointSplatHDF5;
namespace Names = vtkPointSplatOctreeFile;
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeInput::Stamp vtkPointSplatOctreeInput::StampOf(const std::string& name)
{
  // Of a file that is not there both say so by a value of their own.
  std::error_code error;
  const std::filesystem::file_time_type time = std::filesystem::last_write_time(name, error);
  return { time, std::filesystem::file_size(name, error) };
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeInput::vtkPointSplatOctreeInput(const char* name)
  : Name(name ? name : "")
  , Opened(vtkPointSplatOctreeInput::StampOf(this->Name))
{
  if (this->Name.empty())
  {
    this->Error = "There is no FileName.";
    return;
  }
  const std::string quoted = "'" + this->Name + "' ";
  if (!vtksys::SystemTools::FileExists(this->Name, true))
  {
    this->Error = quoted + "is not there.";
    return;
  }
  // Of a damaged file HDF5 may keep something open; not beyond the file itself.
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
  this->Data = Handle(H5Fopen(this->Name.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
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

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeInput::Is(const char* name) const
{
  const Stamp now = vtkPointSplatOctreeInput::StampOf(this->Name);
  return name && this->Name == name && now.Time == this->Opened.Time &&
    now.Size == this->Opened.Size;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeInput::ReadTree()
{
  for (int piece = 0; piece < this->Pieces[0] && !this->HasTree; ++piece)
  {
    if (!this->Tree.AddPiece(this->Data, piece))
    {
      return false;
    }
  }
  this->HasTree = true;
  return true;
}
