// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "vtkMath.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>

namespace
{
std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  size_t start = 0;
  for (size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, start))
  {
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  parts.push_back(text.substr(start));
  return parts;
}

double Number(const std::string& option, const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(value))
  {
    throw UserError(option + ": '" + text + "' is not a number");
  }
  return value;
}

std::vector<double> Numbers(const std::string& option, const std::string& text)
{
  std::vector<double> values;
  for (const std::string& part : Split(text, ','))
  {
    values.push_back(Number(option, part));
  }
  return values;
}

double Positive(const std::string& option, const std::string& text)
{
  const double value = Number(option, text);
  if (value <= 0.0)
  {
    throw UserError(option + ": '" + text + "' is not greater than 0");
  }
  return value;
}

double PositiveAtMost(const std::string& option, const std::string& text, double most)
{
  const double value = Positive(option, text);
  if (value > most)
  {
    std::ostringstream error;
    error << option << ": '" << text << "' is greater than " << most;
    throw UserError(error.str());
  }
  return value;
}

/**
 * Appends, so that a repeated option goes on with the next surface.
 */
void Append(std::vector<double>& values, const std::vector<double>& more)
{
  values.insert(values.end(), more.begin(), more.end());
}

int Whole(const std::string& option, const std::string& text, int low, int high)
{
  const double value = Number(option, text);
  if (value != std::floor(value) || value < low || value > high)
  {
    throw UserError(option + ": '" + text + "' is not a whole number from " +
      std::to_string(low) + " to " + std::to_string(high));
  }
  return static_cast<int>(value);
}

std::array<double, 3> Colour(const std::string& option, const std::string& text)
{
  vtkNew<vtkNamedColors> named;
  if (named->ColorExists(text))
  {
    std::array<double, 3> colour;
    named->GetColorRGB(text, colour.data());
    return colour;
  }
  if (text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
  {
    const long code = std::strtol(text.c_str() + 1, nullptr, 16);
    return { { ((code >> 16) & 255) / 255.0, ((code >> 8) & 255) / 255.0, (code & 255) / 255.0 } };
  }
  std::vector<double> values;
  if (text.find_first_not_of("0123456789.,eE+-") == std::string::npos)
  {
    values = Numbers(option, text);
  }
  if (values.size() != 3 || *std::min_element(values.begin(), values.end()) < 0.0 ||
    *std::max_element(values.begin(), values.end()) > 1.0)
  {
    throw UserError(
      option + ": '" + text + "' is no colour; it takes r,g,b from 0 to 1, #rrggbb or a name");
  }
  return { { values[0], values[1], values[2] } };
}

std::vector<double> CameraNumbers(const std::string& option, const std::string& text)
{
  const std::vector<double> c = Numbers(option, text);
  if (c.size() != 2 && c.size() != 3 && c.size() != 9 && c.size() != 10)
  {
    throw UserError(option +
      ": takes azimuth,elevation[,zoom] or the nine numbers of position, focal point and view "
      "up[,angle]");
  }
  if (c.size() == 3 && c[2] <= 0.0)
  {
    throw UserError(option + ": the zoom must be greater than 0");
  }
  if (c.size() == 10 && (c[9] <= 0.0 || c[9] >= 180.0))
  {
    throw UserError(option + ": the angle must be between 0 and 180");
  }
  if (c.size() >= 9)
  {
    const double view[3] = { c[3] - c[0], c[4] - c[1], c[5] - c[2] };
    const double up[3] = { c[6], c[7], c[8] };
    double side[3];
    vtkMath::Cross(view, up, side);
    if (vtkMath::Norm(side) <= 1e-9 * vtkMath::Norm(view) * vtkMath::Norm(up))
    {
      throw UserError(option + ": the view up lies along the view, or one of both is zero");
    }
  }
  return c;
}

bool EndsIn(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

std::string OneOf(
  const std::string& option, const std::string& text, const std::vector<std::string>& choices)
{
  if (std::find(choices.begin(), choices.end(), text) == choices.end())
  {
    std::string all;
    for (const std::string& choice : choices)
    {
      all += (all.empty() ? "" : ", ") + choice;
    }
    throw UserError(option + ": '" + text + "' is none of " + all);
  }
  return text;
}
}

//------------------------------------------------------------------------------
Options Options::Parse(int argc, char* argv[])
{
  Options o;
  using Setter = std::function<void(const std::string&, const std::string&)>;
  const std::map<std::string, Setter> withValue = {
    { "--iso", [&o](auto& n, auto& v) { Append(o.Isovalues, Numbers(n, v)); } },
    { "--opacity",
      [&o](auto& n, auto& v) {
        for (double opacity : Numbers(n, v))
        {
          if (opacity < 0.0 || opacity > 1.0)
          {
            throw UserError(n + ": opacities are from 0 to 1");
          }
          o.Opacities.push_back(opacity);
        }
      } },
    { "--color",
      [&o](auto& n, auto& v) {
        for (const std::string& part : Split(v, ';'))
        {
          o.Colours.push_back(Colour(n, part));
        }
      } },
    { "--spacing", [&o](auto& n, auto& v) { o.Spacing = Positive(n, v); } },
    { "--magnify", [&o](auto& n, auto& v) { o.Magnify = Whole(n, v, 1, 16); } },
    { "--size",
      [&o](auto& n, auto& v) {
        const std::vector<std::string> parts = Split(v, 'x');
        if (parts.size() != 2)
        {
          throw UserError(n + ": '" + v + "' is not WIDTHxHEIGHT");
        }
        o.Size = { { Whole(n, parts[0], 1, 16384), Whole(n, parts[1], 1, 16384) } };
      } },
    { "--camera", [&o](auto& n, auto& v) { o.Camera = CameraNumbers(n, v); } },
    { "--background", [&o](auto& n, auto& v) { o.Background = Colour(n, v); } },
    { "--array", [&o](auto&, auto& v) { o.Array = v; } },
    { "--target-error",
      [&o](auto& n, auto& v) {
        o.TargetError = Number(n, v);
        if (o.TargetError < 0.0 || o.TargetError > 1.0)
        {
          throw UserError(n + ": '" + v + "' is not from 0 to 1");
        }
      } },
    { "--method",
      [&o](auto& n, auto& v) {
        o.Method = OneOf(n, v, { "automatic", "two-pass", "deferred", "image-space" });
      } },
    { "--transparency",
      [&o](auto& n, auto& v) {
        o.Transparency = OneOf(n, v, { "automatic", "peeling", "sorted", "nearest-exact" });
      } },
    { "--layers", [&o](auto& n, auto& v) { o.Layers = Whole(n, v, 1, 256); } },
    { "--shadows", [&o](auto& n, auto& v) { o.Shadows = Whole(n, v, 1, 1024); } },
    { "--projection",
      [&o](auto& n, auto& v) {
        o.Projection = OneOf(n, v, { "automatic", "compute", "quads" });
      } },
    { "--normals", [&o](auto& n, auto& v) { o.Normals = OneOf(n, v, { "keep", "estimate" }); } },
    { "--radius-scale", [&o](auto& n, auto& v) { o.RadiusScale = PositiveAtMost(n, v, 8.0); } },
    { "--frames", [&o](auto& n, auto& v) { o.Frames = Whole(n, v, 1, 10000); } },
    { "--output",
      [&o](auto& n, auto& v) {
        if (!EndsIn(v, ".png") && !EndsIn(v, ".h5"))
        {
          throw UserError(n + ": '" + v + "' does not end in .png");
        }
        o.Output = v;
      } },
    { "--points", [&o](auto& n, auto& v) { o.MostPoints = Whole(n, v, 1, VTK_INT_MAX); } },
    { "--json", [&o](auto&, auto& v) { o.Json = v; } },
  };
  const std::map<std::string, bool Options::*> flags = { { "--append", &Options::AppendToFile },
    { "--convert", &Options::Convert },
    { "--particles", &Options::Particles },
    { "--project", &Options::Project }, { "--scalar-bar", &Options::ScalarBar },
    { "--unlit", &Options::Unlit }, { "--lit", &Options::Lit },
    { "--quiet", &Options::Quiet }, { "--help", &Options::Help }, { "-h", &Options::Help },
    { "--version", &Options::Version } };

  for (int i = 1; i < argc; ++i)
  {
    std::string name = argv[i];
    std::string value;
    const size_t equals = name.find('=');
    const bool attached = name.compare(0, 2, "--") == 0 && equals != std::string::npos;
    if (attached)
    {
      value = name.substr(equals + 1);
      name = name.substr(0, equals);
    }
    auto flag = flags.find(name);
    auto setter = withValue.find(name);
    if (flag != flags.end())
    {
      if (attached)
      {
        throw UserError(name + ": takes no value");
      }
      o.*(flag->second) = true;
    }
    else if (setter != withValue.end())
    {
      if (!attached)
      {
        if (i + 1 >= argc)
        {
          throw UserError(name + ": needs a value");
        }
        value = argv[++i];
      }
      setter->second(name, value);
    }
    else if (name.size() > 1 && name[0] == '-')
    {
      throw UserError("unknown option " + name + "; --help lists all");
    }
    else
    {
      o.Files.push_back(argv[i]);
    }
  }
  if (o.Convert && (o.Files.empty() || !EndsIn(o.Output, ".h5")))
  {
    throw UserError("--convert: needs files, and --output with a name that ends in .h5");
  }
  if (!o.Convert && EndsIn(o.Output, ".h5"))
  {
    throw UserError("--output: '" + o.Output + "' does not end in .png; --convert writes .h5");
  }
  if (o.AppendToFile && !o.Convert)
  {
    throw UserError("--append: goes with --convert");
  }
  if (o.Particles && !o.Isovalues.empty())
  {
    throw UserError("--particles: goes without --iso; the surface is where the fluid ends");
  }
  if (o.Unlit && (o.Lit || o.Shadows > 0))
  {
    throw UserError(std::string("--unlit: goes without ") + (o.Lit ? "--lit" : "--shadows"));
  }
  if (o.ScalarBar && o.Array.empty())
  {
    throw UserError("--scalar-bar: needs --array");
  }
  return o;
}

//------------------------------------------------------------------------------
std::string Options::HelpText()
{
  return R"(splatview: draws point clouds, and isosurfaces as such, as smooth surfaces

  splatview [FILES] [options]

FILES  points: .vtp .ply .obj .stl .xyz .pts .txt .csv .vtu .vts .vtk .vtm .h5
       volumes: .vti .mhd .mha .nrrd .nhdr .vtk .vtm
       scans (.las .laz .copc.laz .e57) by Python: python3 -m pointsplatting.convert IN OUT.vtp
       Without files splatview makes a hydrogen orbital of its own, cut open to show three
       nested isosurfaces, and writes hydrogen.png.
       Text points: a line a point, x y z [nx ny nz] [r g b]; an intensity, other orders,
       # comments and a line with the count are understood. A line of names above the columns
       decides: x y z, nx ny nz, r g b (or red green blue) and radius in any order, quoted or not,
       in capitals or not; all others are arrays by their names (--array intensity).
       Missing normals are taken from a mesh's triangles, or estimated.

What is drawn
  --iso V[,V...]       isovalues of volumes; default: a quarter, half and three quarters of
                       the range. Or of points that are samples of an array
  --particles          points are particles of a fluid: draw the fluid's surface. Sizes are from
                       arrays smoothing_length (or h), mass and density, if there are any
  --spacing S          wanted distance between isosurface points, world units; default: the
                       grid's or samples', or 0.4 of the particles'
  --magnify N          resample volumes N times finer first, cubically (1 to 16)
  --array NAME         point array to contour, or to colour points by
  --normals WHICH      keep (default) or estimate
  --project            move noisy points onto one smooth surface with sharp edges first, and leave
                       outliers out
  --radius-scale F     multiplies all splats' radii, by 8 at most

How it looks
  --color C[;C...]     a colour for each surface: r,g,b (0 to 1), #rrggbb, or a name as in
                       HTML; repeated options and lists go on with the next surface
  --opacity A[,A...]   an opacity for each surface, 0 to 1
  --background C       default 0.1,0.2,0.4
  --camera A,E[,Z]     azimuth and elevation in degrees from the default view, and a zoom; or
  --camera PX,PY,PZ,FX,FY,FZ,UX,UY,UZ[,ANGLE]
                       position, focal point, view up, and view angle in degrees
  --size WxH           default 1024x768
  --scalar-bar         show the colour scale of --array
  --unlit              show colours as they are, without light. Points that have colours and no
                       normals, as of photographs and laser scans, are shown so by themselves
  --lit                light these, too
  --shadows N          light by a lamp up on the left that casts shadows: hard ones (1), or
                       soft ones by so many samples (1 to 1024)

How it is drawn
  --target-error X     how much the picture may differ from the best one, 0 to 1, if that saves
                       time (default 0.0039: 1/256)
  --method M           automatic (default), two-pass, deferred, image-space
  --transparency T     automatic (default), peeling, sorted, nearest-exact
  --layers N           the most layers that are peeled (32)
  --projection P       automatic (default), compute, quads

Large clouds
  --convert            write the files' points, one file after the other, with coarser versions of
                       them to --output F.h5, and end: of that any number of points is read
  --append             with --convert: add them to those that the file has
  --points N           of .h5 files, draw at most N splats that stand for all points (4 million): of
                       files with more points those that the camera needs

What comes out
  --output F.png       write a picture and end; without it a window opens where there is a
                       display, and splatview.png is written where there is none
  --json F.json        write points, method, automatic choices and frame times
  --frames N           with --json: frames to time (5)
  --quiet              no progress bars and no summary
  --help, --version

In the window: h lists the keys; p tells of the point under the pointer its id, coordinates and
arrays, on the screen and on standard output (unless --quiet).

Examples
  splatview
  splatview bunny.ply --output bunny.png
  splatview head.vti --iso 500,1150 --opacity .4,1 --color 'orange;white' --output head.png
  splatview scan.xyz --normals estimate --camera 30,20,1.5 --json report.json --output scan.png
  splatview scans.ply --project --output scans.png
  splatview flow.vtp --array pressure --scalar-bar
  splatview --convert scan1.ply scan2.ply --output scans.h5
  splatview --convert scan3.ply --append --output scans.h5
  splatview scans.h5 --points 1000000
  splatview tank.vtp --particles --opacity 0.5 --array velocity
  splatview before.ply after.ply --color '#5588ee;1,.6,.2'

Exit codes: 0 done, 1 OpenGL or VTK failed, 2 a bad option or file.
)";
}
