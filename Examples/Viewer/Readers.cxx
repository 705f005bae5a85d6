// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Messages.h"
#include "ObjIndices.h"
#include "OctreeFiles.h"
#include "Options.h"
#include "PlyVertices.h"
#include "Progress.h"
#include "TextPoints.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkOBJReader.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <map>
#include <utility>

namespace
{
std::string Extension(const std::string& file)
{
  const size_t dot = file.rfind('.');
  std::string extension = dot == std::string::npos ? "" : file.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/**
 * What to do with a file that has no reader here.
 */
std::string WhyNotRead(const std::string& file)
{
  const std::string extension = Extension(file);
  if (extension != "las" && extension != "laz" && extension != "e57")
  {
    return "files of this kind are not read; --help lists those that are";
  }
  const std::string cloud = file.substr(0, file.rfind('.')) + ".vtp";
  return "the Python package reads scans: python3 -m pointsplatting.convert \"" + file + "\" \"" +
    cloud + "\" makes one that splatview reads";
}

template <typename Reader>
vtkSmartPointer<vtkDataObject> Read(const std::string& file, bool quiet)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  ShowProgress(reader, "reading", quiet);
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> ReadText(const std::string& file, bool quiet)
{
  ProgressBar progress("reading", quiet);
  return ReadTextPoints(file, progress);
}

vtkSmartPointer<vtkDataObject> ReadPlyFile(const std::string& file, bool quiet)
{
  ProgressBar progress("reading", quiet);
  return ReadPly(file, progress);
}

/**
 * vtkOBJReader takes indices as they are.
 */
vtkSmartPointer<vtkDataObject> ReadObj(const std::string& file, bool quiet)
{
  CheckObjIndices(file);
  return Read<vtkOBJReader>(file, quiet);
}

/**
 * Whether cells lie within their own list and name only points that are there.
 */
bool AreValid(vtkCellArray* cells, vtkIdType points)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return true;
  }
  if (!cells->IsValid())
  {
    return false;
  }
  double range[2];
  cells->GetConnectivityArray()->GetRange(range);
  return cells->GetNumberOfConnectivityIds() == 0 ||
    (range[0] >= 0.0 && range[1] < static_cast<double>(points));
}

/**
 * The same, or its points alone where its cells are not valid: filters take indices as they are.
 */
vtkSmartPointer<vtkDataSet> WithValidCells(const std::string& file, vtkDataSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  bool valid = true;
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(data))
  {
    valid = AreValid(mesh->GetVerts(), points) && AreValid(mesh->GetLines(), points) &&
      AreValid(mesh->GetPolys(), points) && AreValid(mesh->GetStrips(), points);
  }
  else if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    valid = AreValid(grid->GetCells(), points);
  }
  if (valid)
  {
    return data;
  }
  MessageKeeper::AddWarning(
    file + ": its cells name points that are not there; the points alone are taken");
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(vtkPointSet::SafeDownCast(data)->GetPoints());
  bare->GetPointData()->ShallowCopy(data->GetPointData());
  bare->GetFieldData()->ShallowCopy(data->GetFieldData());
  return bare;
}

/**
 * Point arrays that are not as long as there are points, as vtkOBJReader's normals that no face
 * names.
 */
void RemoveBadArrays(const std::string& file, vtkDataSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  for (int i = arrays->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      MessageKeeper::AddWarning(file + ": its point array " +
        (array->GetName() ? array->GetName() : "without a name") + " has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples for " +
        std::to_string(data->GetNumberOfPoints()) + " points; it is left out");
      arrays->RemoveArray(i);
    }
  }
}

/**
 * vtkNrrdReader crashes where the file is no volume.
 */
vtkSmartPointer<vtkDataObject> ReadNrrd(const std::string& file, bool quiet)
{
  vtkNew<vtkNrrdReader> reader;
  reader->SetFileName(file.c_str());
  ShowProgress(reader, "reading", quiet);
  reader->UpdateInformation();
  const int* extent = reader->GetDataExtent();
  if (extent[1] < 1 || extent[3] < 1 || extent[5] < 1)
  {
    const std::string error = MessageKeeper::TakeError();
    throw UserError(file + ": " + (error.empty() ? "is no volume" : error));
  }
  reader->Update();
  return reader->GetOutput();
}

using ReadFunction = std::function<vtkSmartPointer<vtkDataObject>(const std::string&, bool)>;

std::map<std::string, ReadFunction> GetReaders(long mostPoints)
{
  const auto octree = [mostPoints](const std::string& file, bool quiet) {
    return ReadOctree(file, mostPoints, quiet);
  };
  return { { "csv", ReadText }, { "h5", octree },
    { "mha", Read<vtkMetaImageReader> }, { "mhd", Read<vtkMetaImageReader> },
    { "nhdr", ReadNrrd }, { "nrrd", ReadNrrd },
    { "obj", ReadObj }, { "ply", ReadPlyFile }, { "pts", ReadText },
    { "stl", Read<vtkSTLReader> }, { "txt", ReadText }, { "vti", Read<vtkXMLImageDataReader> },
    { "vtk", Read<vtkGenericDataObjectReader> }, { "vtm", Read<vtkXMLMultiBlockDataReader> },
    { "vtp", Read<vtkXMLPolyDataReader> }, { "vts", Read<vtkXMLStructuredGridReader> },
    { "vtu", Read<vtkXMLUnstructuredGridReader> }, { "xyz", ReadText } };
}
}

//------------------------------------------------------------------------------
bool IsOctree(const std::string& file)
{
  return Extension(file) == "h5";
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> ReadFile(
  const std::string& file, bool quiet, long mostPoints)
{
  // Folders open, but have nothing to read.
  std::ifstream in(file);
  if (!in || (in.peek() == std::ifstream::traits_type::eof() && in.bad()))
  {
    throw UserError(file + ": cannot be opened");
  }
  const std::map<std::string, ReadFunction> readers = GetReaders(mostPoints);
  const auto reader = readers.find(Extension(file));
  if (reader == readers.end())
  {
    throw UserError(file + ": " + WhyNotRead(file));
  }
  vtkSmartPointer<vtkDataObject> object = reader->second(file, quiet);
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    throw UserError(file + ": " + error);
  }

  const std::string name = file.substr(file.find_last_of("/\\") + 1);
  std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> found;
  const auto add = [&](vtkDataObject* leaf, const std::string& leafName) {
    vtkDataSet* data = vtkDataSet::SafeDownCast(leaf);
    if (!data || data->GetNumberOfPoints() == 0)
    {
      return;
    }
    if (!vtkImageData::SafeDownCast(data) && !vtkPointSet::SafeDownCast(data))
    {
      throw UserError(
        file + ": holds a " + data->GetClassName() + "; points or image data are wanted");
    }
    RemoveBadArrays(file, data);
    found.emplace_back(leafName, WithValidCells(file, data));
  };
  if (vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkInformation* info = iterator->GetCurrentMetaData();
      const char* block = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
      add(iterator->GetCurrentDataObject(),
        name + " " + (block ? block : std::to_string(iterator->GetCurrentFlatIndex())));
    }
  }
  else
  {
    add(object, name);
  }
  if (found.empty())
  {
    throw UserError(file + ": has no points");
  }
  return found;
}
