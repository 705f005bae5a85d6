// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyVertices.h"

#include "Options.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace
{
struct Property
{
  std::string Name;
  std::string Type;
  std::string CountType; // of a list; empty otherwise
};

struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<Property> Properties;
};

size_t SizeOf(const std::string& type)
{
  static const std::map<std::string, size_t> sizes = { { "char", 1 }, { "int8", 1 },
    { "uchar", 1 }, { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 },
    { "uint16", 2 }, { "int", 4 }, { "int32", 4 }, { "uint", 4 }, { "uint32", 4 },
    { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

template <typename T>
double As(const unsigned char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

/**
 * Reads values one after the other, in whichever format.
 */
class Source
{
public:
  Source(std::istream& in, const std::string& format)
    : In(in)
    , Ascii(format == "ascii")
    , Swap(format == "binary_big_endian")
  {
  }
  double Read(const std::string& type)
  {
    if (this->Ascii)
    {
      double value = 0.0;
      this->In >> value;
      return value;
    }
    unsigned char bytes[8] = { 0 };
    const size_t size = SizeOf(type);
    this->In.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(size));
    if (this->Swap)
    {
      std::reverse(bytes, bytes + size);
    }
    const bool isUnsigned = type[0] == 'u';
    if (type.compare(0, 5, "float") == 0 && size == 4)
    {
      return As<float>(bytes);
    }
    switch (size)
    {
      case 1:
        return isUnsigned ? As<uint8_t>(bytes) : As<int8_t>(bytes);
      case 2:
        return isUnsigned ? As<uint16_t>(bytes) : As<int16_t>(bytes);
      case 4:
        return isUnsigned ? As<uint32_t>(bytes) : As<int32_t>(bytes);
      default:
        return As<double>(bytes);
    }
  }

private:
  std::istream& In;
  bool Ascii;
  bool Swap;
};

std::vector<Element> ReadHeader(std::istream& in, const std::string& file, std::string& format)
{
  std::vector<Element> elements;
  std::string line;
  if (!std::getline(in, line) || line.compare(0, 3, "ply") != 0)
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
    }
    else if (word == "property" && !elements.empty())
    {
      Property property;
      words >> property.Type;
      if (property.Type == "list")
      {
        words >> property.CountType >> property.Type;
      }
      words >> property.Name;
      if (!SizeOf(property.Type))
      {
        throw UserError(file + ": unknown PLY type '" + property.Type + "'");
      }
      elements.back().Properties.push_back(property);
    }
    else if (word == "end_header")
    {
      if (format != "ascii" && format.compare(0, 7, "binary_") != 0)
      {
        break;
      }
      return elements;
    }
  }
  throw UserError(file + ": the PLY header is broken off or of an unknown format");
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadPlyVertices(const std::string& file, bool& hasFaces)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
  {
    throw UserError(file + ": cannot be opened");
  }
  std::string format;
  const std::vector<Element> elements = ReadHeader(in, file, format);
  Source source(in, format);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  data->SetPoints(points);
  hasFaces = false;
  for (const Element& element : elements)
  {
    hasFaces = hasFaces || (element.Name == "face" && element.Count > 0);
  }
  for (const Element& element : elements)
  {
    const bool vertices = element.Name == "vertex";
    std::map<std::string, size_t> at;
    for (size_t i = 0; i < element.Properties.size(); ++i)
    {
      at[element.Properties[i].Name] = i;
    }
    if (vertices && !(at.count("x") && at.count("y") && at.count("z")))
    {
      throw UserError(file + ": the PLY vertices have no x, y, z");
    }
    const bool normals = at.count("nx") && at.count("ny") && at.count("nz");
    const bool colours = at.count("red") && at.count("green") && at.count("blue");
    vtkNew<vtkFloatArray> normalArray;
    normalArray->SetName("Normals");
    normalArray->SetNumberOfComponents(3);
    vtkNew<vtkUnsignedCharArray> colourArray;
    colourArray->SetName("RGB");
    colourArray->SetNumberOfComponents(3);
    std::vector<double> row(element.Properties.size());
    for (long long v = 0; v < element.Count; ++v)
    {
      for (size_t i = 0; i < row.size(); ++i)
      {
        const Property& property = element.Properties[i];
        row[i] = source.Read(property.CountType.empty() ? property.Type : property.CountType);
        for (double k = 0; !property.CountType.empty() && k < row[i]; ++k)
        {
          source.Read(property.Type);
        }
      }
      if (!in)
      {
        throw UserError(file + ": ends in the middle of its " + element.Name + " list");
      }
      if (vertices)
      {
        points->InsertNextPoint(row[at["x"]], row[at["y"]], row[at["z"]]);
        if (normals)
        {
          normalArray->InsertNextTuple3(row[at["nx"]], row[at["ny"]], row[at["nz"]]);
        }
        if (colours)
        {
          // Floating-point colours are from 0 to 1.
          const double unit =
            element.Properties[at["red"]].Type.find_first_of("fd") == 0 ? 255.0 : 1.0;
          colourArray->InsertNextTuple3(
            unit * row[at["red"]], unit * row[at["green"]], unit * row[at["blue"]]);
        }
      }
    }
    if (vertices)
    {
      if (normals)
      {
        data->GetPointData()->SetNormals(normalArray);
      }
      if (colours)
      {
        data->GetPointData()->SetScalars(colourArray);
      }
      break; // faces and what else follows is not wanted
    }
  }
  return data;
}
