// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyVertices.h"

#include "Messages.h"
#include "Options.h"
#include "PointColors.h"
#include "Progress.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
enum class Type
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

struct Property
{
  std::string Name;
  Type ValueType;
  bool IsList = false;
  Type CountType = Type::UInt8;
};

struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<Property> Properties;
};

Type ParseType(const std::string& file, const std::string& name)
{
  static const std::map<std::string, Type> types = { { "char", Type::Int8 },
    { "int8", Type::Int8 }, { "uchar", Type::UInt8 }, { "uint8", Type::UInt8 },
    { "short", Type::Int16 }, { "int16", Type::Int16 }, { "ushort", Type::UInt16 },
    { "uint16", Type::UInt16 }, { "int", Type::Int32 }, { "int32", Type::Int32 },
    { "uint", Type::UInt32 }, { "uint32", Type::UInt32 }, { "float", Type::Float32 },
    { "float32", Type::Float32 }, { "double", Type::Float64 }, { "float64", Type::Float64 } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    throw UserError(file + ": unknown PLY type '" + name + "'");
  }
  return found->second;
}

/**
 * Gives one value after the other, from whichever format.
 */
class ValueReader
{
public:
  ValueReader(std::istream& in, const std::string& format)
    : In(in)
    , Ascii(format == "ascii")
  {
    const uint16_t one = 1;
    const bool bigHere = *reinterpret_cast<const unsigned char*>(&one) == 0;
    this->Swap = (format == "binary_big_endian") != bigHere;
  }

  /**
   * False at the end of the file, and where there is no number.
   */
  bool Next(Type type, double& value)
  {
    if (this->Ascii)
    {
      if (!(this->In >> this->Word))
      {
        return false;
      }
      char* end = nullptr;
      value = std::strtod(this->Word.c_str(), &end); // takes nan and inf, unlike streams
      return *end == '\0';
    }
    switch (type)
    {
      case Type::Int8:
        return this->NextBinary<int8_t>(value);
      case Type::UInt8:
        return this->NextBinary<uint8_t>(value);
      case Type::Int16:
        return this->NextBinary<int16_t>(value);
      case Type::UInt16:
        return this->NextBinary<uint16_t>(value);
      case Type::Int32:
        return this->NextBinary<int32_t>(value);
      case Type::UInt32:
        return this->NextBinary<uint32_t>(value);
      case Type::Float32:
        return this->NextBinary<float>(value);
      default:
        return this->NextBinary<double>(value);
    }
  }

  /**
   * The value, or how many a list has, which is passed over.
   */
  bool Next(const Property& property, double& value)
  {
    return property.IsList ? this->NextList(property, value, [](double) {})
                           : this->Next(property.ValueType, value);
  }

  /**
   * How many a list has, and each of them to a function. Nothing is made as long as a file says,
   * which may end before.
   */
  template <typename Take>
  bool NextList(const Property& property, double& count, const Take& take)
  {
    bool good = this->Next(property.CountType, count) && count >= 0.0;
    double value = 0.0;
    for (double i = 0.0; good && i < count; ++i)
    {
      good = this->Next(property.ValueType, value);
      take(value);
    }
    return good;
  }

private:
  template <typename T>
  bool NextBinary(double& value)
  {
    char bytes[sizeof(T)];
    if (this->In.rdbuf()->sgetn(bytes, sizeof(T)) != static_cast<std::streamsize>(sizeof(T)))
    {
      return false;
    }
    if (this->Swap)
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    T number;
    std::memcpy(&number, bytes, sizeof(T));
    value = static_cast<double>(number);
    return true;
  }

  std::istream& In;
  bool Ascii;
  bool Swap;
  std::string Word;
};

std::vector<Element> ReadHeader(std::istream& in, const std::string& file, std::string& format)
{
  std::vector<Element> elements;
  std::string line;
  if (!std::getline(in, line) || line.substr(0, line.find_last_not_of(" \r\t") + 1) != "ply")
  {
    throw UserError(file + ": is not a PLY file");
  }
  while (std::getline(in, line))
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "format")
    {
      words >> format;
    }
    else if (word == "element")
    {
      elements.emplace_back();
      words >> elements.back().Name >> elements.back().Count;
      if (!words || elements.back().Count < 0)
      {
        throw UserError(file + ": '" + elements.back().Name + "' has no valid count");
      }
    }
    else if (word == "property" && !elements.empty())
    {
      Property property;
      std::string type;
      words >> type;
      property.IsList = type == "list";
      if (property.IsList)
      {
        words >> type;
        property.CountType = ParseType(file, type);
        words >> type;
      }
      property.ValueType = ParseType(file, type);
      words >> property.Name;
      elements.back().Properties.push_back(property);
    }
    else if (word == "end_header")
    {
      if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      {
        throw UserError(file + ": unknown PLY format '" + format + "'");
      }
      return elements;
    }
  }
  throw UserError(file + ": the PLY header has no end");
}

/**
 * Where each of three properties is, if all are there.
 */
struct Triple
{
  Triple(const Element& element, const std::array<const char*, 3>& names)
  {
    for (size_t i = 0; i < 3; ++i)
    {
      const auto found = std::find_if(element.Properties.begin(), element.Properties.end(),
        [&](const Property& property) { return property.Name == names[i] && !property.IsList; });
      this->Found = this->Found && found != element.Properties.end();
      this->At[i] = static_cast<size_t>(found - element.Properties.begin());
    }
  }
  bool Has(size_t property) const
  {
    return this->Found && std::find(this->At.begin(), this->At.end(), property) != this->At.end();
  }
  bool Found = true;
  std::array<size_t, 3> At;
};

/**
 * What red, green and blue of white are.
 */
double White(Type type)
{
  switch (type)
  {
    case Type::Float32:
    case Type::Float64:
      return 1.0;
    case Type::Int16:
    case Type::UInt16:
      return 65535.0;
    default:
      return 255.0;
  }
}

bool NeedsDouble(Type type)
{
  return type == Type::Float64 || type == Type::Int32 || type == Type::UInt32;
}

vtkSmartPointer<vtkPolyData> ReadVertices(
  ValueReader& reader, const Element& element, const std::string& file, ProgressBar& progress)
{
  const Triple position(element, { { "x", "y", "z" } });
  const Triple normal(element, { { "nx", "ny", "nz" } });
  Triple colour(element, { { "red", "green", "blue" } });
  if (!colour.Found)
  {
    colour = Triple(element, { { "diffuse_red", "diffuse_green", "diffuse_blue" } });
  }
  if (!position.Found)
  {
    throw UserError(file + ": the PLY vertices have no x, y, z");
  }
  const bool precise = std::any_of(position.At.begin(), position.At.end(),
    [&](size_t i) { return NeedsDouble(element.Properties[i].ValueType); });

  vtkNew<vtkPoints> points;
  points->SetDataType(precise ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  std::vector<float> colours;
  std::vector<std::pair<size_t, vtkSmartPointer<vtkDataArray>>> others;
  for (size_t i = 0; i < element.Properties.size(); ++i)
  {
    const Property& property = element.Properties[i];
    if (!property.IsList && !position.Has(i) && !normal.Has(i) && !colour.Has(i))
    {
      const int type = NeedsDouble(property.ValueType) ? VTK_DOUBLE : VTK_FLOAT;
      others.emplace_back(
        i, vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)));
      others.back().second->SetName(property.Name.c_str());
    }
  }

  std::vector<double> row(element.Properties.size());
  for (long long vertex = 0; vertex < element.Count; ++vertex)
  {
    for (size_t i = 0; i < row.size(); ++i)
    {
      if (!reader.Next(element.Properties[i], row[i]))
      {
        throw UserError(file + ": ends, or has no number, at vertex " + std::to_string(vertex) +
          " of " + std::to_string(element.Count));
      }
    }
    points->InsertNextPoint(row[position.At[0]], row[position.At[1]], row[position.At[2]]);
    if (normal.Found)
    {
      normals->InsertNextTuple3(row[normal.At[0]], row[normal.At[1]], row[normal.At[2]]);
    }
    for (size_t i = 0; colour.Found && i < 3; ++i)
    {
      colours.push_back(static_cast<float>(row[colour.At[i]]));
    }
    for (auto& other : others)
    {
      other.second->InsertNextTuple1(row[other.first]);
    }
    if (vertex % 4096 == 0)
    {
      progress.Update(static_cast<double>(vertex) / static_cast<double>(element.Count));
    }
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  for (auto& other : others)
  {
    data->GetPointData()->AddArray(other.second);
  }
  if (normal.Found)
  {
    data->GetPointData()->SetNormals(normals);
  }
  if (colour.Found)
  {
    data->GetPointData()->SetScalars(
      MakeColors(colours, White(element.Properties[colour.At[0]].ValueType)));
  }
  return data;
}

UserError Ended(const std::string& file, const Element& element)
{
  return UserError(file + ": ends, or has no number, in its list of " + element.Name);
}

void SkipElement(ValueReader& reader, const Element& element, const std::string& file)
{
  double ignored = 0.0;
  for (long long i = 0; i < element.Count; ++i)
  {
    for (const Property& property : element.Properties)
    {
      if (!reader.Next(property, ignored))
      {
        throw Ended(file, element);
      }
    }
  }
}

/**
 * Polygons of "face", or strips of "tristrips" that -1 separates.
 */
struct Faces
{
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkCellArray> Strips;
  /// Those that name vertices which are not there: left out.
  long long Bad = 0;

  void Add(const std::vector<double>& corners, bool strip, vtkIdType vertices)
  {
    std::vector<vtkIdType> ids;
    for (const double corner : corners)
    {
      // NaN compares false.
      if (!(corner >= 0.0 && corner < static_cast<double>(vertices)))
      {
        ++this->Bad;
        return;
      }
      ids.push_back(static_cast<vtkIdType>(corner));
    }
    if (ids.size() >= 3)
    {
      vtkCellArray* cells = strip ? this->Strips : this->Polygons;
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
};

void ReadFaces(ValueReader& reader, const Element& element, const std::string& file,
  vtkIdType vertices, Faces& faces)
{
  const bool strips = element.Name == "tristrips";
  std::vector<double> corners;
  double ignored = 0.0;
  for (long long i = 0; i < element.Count; ++i)
  {
    corners.clear();
    for (const Property& property : element.Properties)
    {
      const bool isFace =
        property.IsList && (property.Name == "vertex_indices" || property.Name == "vertex_index");
      const auto take = [&](double corner) {
        if (strips && corner == -1.0)
        {
          faces.Add(corners, strips, vertices);
          corners.clear();
          return;
        }
        corners.push_back(corner);
      };
      if (!(isFace ? reader.NextList(property, ignored, take) : reader.Next(property, ignored)))
      {
        throw Ended(file, element);
      }
    }
    faces.Add(corners, strips, vertices);
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& file, ProgressBar& progress)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
  {
    throw UserError(file + ": cannot be opened");
  }
  std::string format;
  const std::vector<Element> elements = ReadHeader(in, file, format);
  ValueReader reader(in, format);
  vtkSmartPointer<vtkPolyData> vertices;
  Faces faces;
  for (const Element& element : elements)
  {
    if (element.Name == "vertex" && !vertices)
    {
      vertices = ReadVertices(reader, element, file, progress);
      if (vertices->GetPointData()->GetNormals())
      {
        return vertices;
      }
    }
    else if (vertices && (element.Name == "face" || element.Name == "tristrips"))
    {
      ReadFaces(reader, element, file, vertices->GetNumberOfPoints(), faces);
    }
    else
    {
      SkipElement(reader, element, file);
    }
  }
  if (!vertices)
  {
    throw UserError(file + ": has no vertices");
  }
  if (faces.Bad > 0)
  {
    MessageKeeper::AddWarning(file + ": " + std::to_string(faces.Bad) +
      " faces name vertices that are not there; they are left out");
  }
  vertices->SetPolys(faces.Polygons);
  vertices->SetStrips(faces.Strips);
  return vertices;
}
