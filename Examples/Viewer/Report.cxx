// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Messages.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace
{
/// Of the points of the file: fill points may lie a little outside.
void FindBounds(const Surface& surface, double bounds[6])
{
  surface.Mapper->GetBounds(bounds);
  auto data = vtkDataSet::SafeDownCast(surface.Mapper->GetInputDataObject(0, 0));
  if (!data || surface.NumberOfFillPoints == 0)
  {
    return;
  }
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints() - surface.NumberOfFillPoints; ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    box.AddPoint(x);
  }
  box.GetBounds(bounds);
}

std::string Quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : OneLine(text))
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
    }
    out += c;
  }
  return out + "\"";
}

/**
 * With all digits. JSON has no infinity and no NaN.
 */
std::string Number(double value)
{
  std::ostringstream out;
  out.precision(17);
  out << value;
  return std::isfinite(value) ? out.str() : "null";
}

std::string List(const double* begin, const double* end)
{
  std::string out = "[";
  for (const double* value = begin; value != end; ++value)
  {
    out += (value == begin ? "" : ", ") + Number(*value);
  }
  return out + "]";
}

/**
 * Of lines `name: value`.
 */
std::string Object(const std::string& text)
{
  std::string out = "{";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const size_t colon = line.find(": ");
    if (colon != std::string::npos)
    {
      out += (out.size() > 1 ? ", " : "") + Quoted(line.substr(0, colon)) + ": " +
        Quoted(line.substr(colon + 2));
    }
  }
  return out + "}";
}

/**
 * The value of one line of vtkRenderWindow::ReportCapabilities().
 */
std::string Capability(vtkRenderWindow* window, const std::string& name)
{
  std::istringstream lines(window->ReportCapabilities());
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.compare(0, name.size(), name) == 0)
    {
      const size_t start = line.find_first_not_of(" :", name.size());
      return start == std::string::npos ? "" : line.substr(start);
    }
  }
  return "";
}
}

//------------------------------------------------------------------------------
double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

//------------------------------------------------------------------------------
void WriteReport(const std::string& file, const Scene& scene, vtkRenderWindow* window,
  const std::vector<double>& milliseconds)
{
  std::ofstream out(file);
  out << "{\n  \"surfaces\": [";
  vtkIdType total = 0;
  const char* separator = "\n";
  for (const Surface& surface : scene.Surfaces)
  {
    vtkPointSplatMapper* mapper = surface.Mapper;
    const vtkIdType points =
      mapper->GetNumberOfSplats() - surface.NumberOfFillPoints + mapper->GetNumberOfCopies();
    total += points;
    double bounds[6];
    FindBounds(surface, bounds);
    const double* colour = surface.Actor->GetProperty()->GetColor();
    out << separator << "    {\"name\": " << Quoted(surface.Name) << ", \"isovalue\": "
        << (surface.Isovalue ? Number(*surface.Isovalue) : "null")
        << ", \"points\": " << points
        << ", \"points_in_file\": "
        << (surface.Stream ? std::to_string(surface.Stream->GetNumberOfPointsInFile()) : "null")
        << ", \"fill_points\": " << surface.NumberOfFillPoints
        << ", \"skipped\": " << mapper->GetNumberOfSkippedPoints()
        << ", \"method\": " << Quoted(mapper->GetMethodUsed())
        << ", \"transparency\": " << Quoted(mapper->GetTransparencyUsed())
        << ", \"layers\": " << mapper->GetNumberOfLayersDrawn()
        << ", \"groups\": " << mapper->GetNumberOfGroups()
        << ", \"shadow_samples\": " << mapper->GetNumberOfShadowSamplesUsed()
        << ", \"projection\": " << Quoted(mapper->GetProjectionUsed())
        << ", \"layer_distance\": " << Number(mapper->GetLayerDistanceUsed())
        << ", \"choices\": " << Object(mapper->GetChoices())
        << ", \"normals\": " << Quoted(surface.Normals)
        << ", \"lit\": " << (surface.Lit ? "true" : "false")
        << ", \"coloured_by\": " << Quoted(surface.Colours) << ", \"color\": "
        << List(colour, colour + 3)
        << ", \"opacity\": " << Number(surface.Actor->GetProperty()->GetOpacity())
        << ", \"bounds\": " << List(bounds, bounds + 6) << "}";
    separator = ",\n";
  }
  const int* size = window->GetSize();
  out << "\n  ],\n  \"points\": " << total << ",\n  \"image_bytes\": "
      << scene.Surfaces[0].Mapper->GetImageMemorySize()
      << ",\n  \"size\": [" << size[0] << ", " << size[1]
      << "],\n  \"median_frame_ms\": " << Number(Median(milliseconds)) << ",\n  \"frames_ms\": "
      << List(milliseconds.data(), milliseconds.data() + milliseconds.size())
      << ",\n  \"vtk\": " << Quoted(vtkVersion::GetVTKVersion())
      << ",\n  \"opengl_renderer\": " << Quoted(Capability(window, "OpenGL renderer string"))
      << ",\n  \"opengl_version\": " << Quoted(Capability(window, "OpenGL version string"))
      << "\n}\n";
  out.flush();
  if (!out)
  {
    throw UserError(file + ": cannot be written");
  }
}
