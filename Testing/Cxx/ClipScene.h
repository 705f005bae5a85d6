// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies of plane faces as splats that end at exact clip lines, what rays hit of them, and how
// pictures of them compare with that.
#ifndef ClipScene_h
#define ClipScene_h

#include "SplatScene.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ClipScene
{
using SplatScene::Picture;
using SplatScene::Window;

using Vector = std::array<double, 3>;

inline Vector Sum(const Vector& a, double factor, const Vector& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  Vector c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

inline Vector Unit(const Vector& a)
{
  return Sum({ 0.0, 0.0, 0.0 }, 1.0 / std::sqrt(Dot(a, a)), a);
}

/**
 * A polygon, of which only reflex corners are no convex ones; counter-clockwise about its normal.
 */
struct Face
{
  std::vector<Vector> Corners;
  std::array<unsigned char, 3> Colour;
  Vector Normal{ { 0.0, 0.0, 0.0 } };
  Vector Along; // the first edge
  Vector Across;
  std::vector<std::array<double, 2>> Flat; // the corners along and across

  Face(const std::vector<Vector>& corners, const std::array<unsigned char, 3>& colour)
    : Corners(corners)
    , Colour(colour)
  {
    for (size_t i = 0; i < corners.size(); ++i)
    {
      this->Normal = Sum(this->Normal, 1.0, Cross(corners[i], this->Corner(i + 1)));
    }
    this->Normal = Unit(this->Normal);
    this->Along = Unit(Sum(this->Corner(1), -1.0, this->Corner(0)));
    this->Across = Cross(this->Normal, this->Along);
    for (const Vector& corner : corners)
    {
      this->Flat.push_back({ Dot(corner, this->Along), Dot(corner, this->Across) });
    }
  }
  const Vector& Corner(size_t i) const { return this->Corners[i % this->Corners.size()]; }

  /// Whether a point of the plane is inside: edges that a ray from it along the first one crosses.
  bool Contains(const Vector& p) const
  {
    const double along = Dot(p, this->Along);
    const double across = Dot(p, this->Across);
    bool inside = false;
    for (size_t i = 0, last = this->Flat.size() - 1; i < this->Flat.size(); last = i++)
    {
      const auto& a = this->Flat[last];
      const auto& b = this->Flat[i];
      if ((a[1] > across) != (b[1] > across))
      {
        inside ^= a[0] + (a[1] - across) / (a[1] - b[1]) * (b[0] - a[0]) > along;
      }
    }
    return inside;
  }

  /// The nearest two lines about a point inside, no farther than reach, as SplatClip has them:
  /// edges that it is beside, and through reflex corners the lines across the way there.
  std::array<double, 6> Lines(const Vector& p, double reach) const
  {
    std::vector<std::pair<double, Vector>> found;
    for (size_t i = 0; i < this->Corners.size(); ++i)
    {
      const Vector a = Sum(p, -1.0, this->Corner(i));
      const Vector along = Sum(this->Corner(i + 1), -1.0, this->Corner(i));
      const Vector out = Unit(Cross(along, this->Normal));
      const double at = Dot(a, along) / Dot(along, along);
      const double off = -Dot(a, out);
      if (at >= 0.0 && at <= 1.0 && off > 0.0 && off < reach)
      {
        found.push_back({ off, out });
      }
      const Vector before = Sum(this->Corner(i), -1.0, this->Corner(i + this->Corners.size() - 1));
      const double length = std::sqrt(Dot(a, a));
      const bool reflex = Dot(Cross(before, along), this->Normal) < 0.0;
      if (reflex && at < 0.0 && Dot(a, before) > 0.0 && length < reach)
      {
        found.push_back({ length, Unit(Sum({ 0.0, 0.0, 0.0 }, -1.0, a)) });
      }
    }
    std::sort(found.begin(), found.end());
    std::array<double, 6> lines{};
    for (size_t k = 0; k < std::min<size_t>(found.size(), 2); ++k)
    {
      for (size_t c = 0; c < 3; ++c)
      {
        lines[3 * k + c] = found[k].second[c] / std::max(found[k].first, 1e-6 * reach);
      }
    }
    return lines;
  }
};

struct Hit
{
  int Face = -1;
  double At = std::numeric_limits<double>::infinity(); // along the ray
};

/**
 * A closed body.
 */
struct Body
{
  std::vector<Face> Faces;

  /// All hits of a ray, nearest first.
  std::vector<Hit> Cast(const Vector& from, const Vector& to) const
  {
    std::vector<Hit> hits;
    const Vector ray = Sum(to, -1.0, from);
    for (size_t i = 0; i < this->Faces.size(); ++i)
    {
      const Vector& n = this->Faces[i].Normal;
      const double at = Dot(Sum(this->Faces[i].Corner(0), -1.0, from), n) / Dot(ray, n);
      if (std::isfinite(at) && at > 0.0 && this->Faces[i].Contains(Sum(from, at, ray)))
      {
        hits.push_back({ static_cast<int>(i), at });
      }
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.At < b.At; });
    return hits;
  }
};

/// A prism over a polygon of the plane z = 0, of height 1.
inline Body Prism(const std::vector<std::array<double, 2>>& outline)
{
  static const std::array<unsigned char, 3> colours[] = { { { 255, 0, 0 } }, { { 0, 255, 0 } },
    { { 0, 0, 255 } }, { { 255, 255, 0 } }, { { 0, 255, 255 } }, { { 255, 0, 255 } },
    { { 255, 128, 0 } }, { { 255, 255, 255 } } };
  std::vector<Vector> top;
  std::vector<Vector> bottom;
  for (const auto& p : outline)
  {
    top.push_back({ p[0], p[1], 1.0 });
    bottom.insert(bottom.begin(), Vector{ p[0], p[1], 0.0 });
  }
  Body body;
  body.Faces = { { top, colours[0] }, { bottom, colours[1] } };
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    const std::vector<Vector> side = { { a[0], a[1], 0.0 }, { b[0], b[1], 0.0 },
      { b[0], b[1], 1.0 }, { a[0], a[1], 1.0 } };
    body.Faces.emplace_back(side, colours[2 + i % 6]);
  }
  return body;
}

inline Body Cube()
{
  return Prism({ { { 0.0, 0.0 } }, { { 1.0, 0.0 } }, { { 1.0, 1.0 } }, { { 0.0, 1.0 } } });
}

/// With a reflex edge.
inline Body Corner()
{
  return Prism({ { { 0.0, 0.0 } }, { { 1.0, 0.0 } }, { { 1.0, 0.45 } }, { { 0.45, 0.45 } },
    { { 0.45, 1.0 } }, { { 0.0, 1.0 } } });
}

/**
 * What a body is sampled by. Aspect: of ellipses, else 1; reach: of lines, in radii.
 */
struct Sampling
{
  double Spacing = 0.05;
  double Aspect = 1.0;
  double Reach = 2.5;
};

/// A body's faces as splats, in a grid that is shaken. The scalars are the faces' colours.
inline vtkSmartPointer<vtkPolyData> Splats(const Body& body, const Sampling& sampling)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colours");
  colours->SetNumberOfComponents(3);
  const auto make = [](const char* name, int components) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    return array;
  };
  const auto normals = make("Normals", 3);
  const auto radii = make("SplatRadius", 1);
  const auto axis1 = make("SplatAxis1", 3);
  const auto axis2 = make("SplatAxis2", 3);
  const auto lines = make("SplatClip", 6);
  const double radius = 1.1 * sampling.Spacing;
  for (const Face& face : body.Faces)
  {
    const Vector& n = face.Normal;
    const Vector& x = face.Along;
    const Vector& y = face.Across;
    double low[2] = { 1e9, 1e9 };
    double high[2] = { -1e9, -1e9 };
    for (const Vector& corner : face.Corners)
    {
      const Vector from = Sum(corner, -1.0, face.Corner(0));
      const double at[2] = { Dot(from, x), Dot(from, y) };
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
    const auto shaken = [&](double at) {
      random->Next();
      return at + 0.4 * sampling.Spacing * (random->GetValue() - 0.5);
    };
    for (double v = low[1] + 0.5 * sampling.Spacing; v < high[1]; v += sampling.Spacing)
    {
      for (double u = low[0] + 0.5 * sampling.Spacing; u < high[0]; u += sampling.Spacing)
      {
        const Vector p = Sum(Sum(face.Corner(0), shaken(u), x), shaken(v), y);
        if (!face.Contains(p))
        {
          continue;
        }
        points->InsertNextPoint(p.data());
        colours->InsertNextTypedTuple(face.Colour.data());
        normals->InsertNextTuple(n.data());
        radii->InsertNextValue(static_cast<float>(radius));
        const Vector none{ 0.0, 0.0, 0.0 };
        axis1->InsertNextTuple(Sum(none, radius * sampling.Aspect, Unit(Sum(x, 0.5, y))).data());
        axis2->InsertNextTuple(Sum(none, radius, Unit(Sum(y, -0.5, x))).data());
        lines->InsertNextTuple(
          face.Lines(p, sampling.Reach * std::max(sampling.Aspect, 1.0) * radius).data());
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(colours);
  data->GetPointData()->AddArray(lines);
  if (sampling.Aspect == 1.0)
  {
    data->GetPointData()->AddArray(radii);
  }
  else
  {
    data->GetPointData()->AddArray(axis1);
    data->GetPointData()->AddArray(axis2);
  }
  return data;
}

/**
 * The rays through a renderer's pixels, in the coordinates of an actor's data.
 */
class Rays
{
public:
  Rays(vtkRenderer* renderer, vtkActor* actor)
    : Size{ renderer->GetSize()[0], renderer->GetSize()[1] }
  {
    vtkMatrix4x4* toNDC = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      static_cast<double>(this->Size[0]) / this->Size[1], -1.0, 1.0);
    vtkNew<vtkMatrix4x4> all;
    vtkMatrix4x4::Multiply4x4(toNDC, actor->GetMatrix(), all);
    vtkMatrix4x4::Invert(all, this->FromNDC);
  }

  /// The hits of the ray through a place in the window, pixels.
  std::vector<Hit> Cast(const Body& body, double x, double y) const
  {
    return body.Cast(this->Place(x, y, -1.0), this->Place(x, y, 1.0));
  }

private:
  Vector Place(double x, double y, double depth) const
  {
    const double ndc[4] = { 2.0 * x / this->Size[0] - 1.0, 2.0 * y / this->Size[1] - 1.0, depth,
      1.0 };
    double p[4];
    this->FromNDC->MultiplyPoint(ndc, p);
    return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }

  int Size[2];
  vtkNew<vtkMatrix4x4> FromNDC;
};

/**
 * Where a camera looks from, and how far about an edge pixels may show either side of it.
 */
struct View
{
  const char* Name;
  Vector Position;
  Vector Focus;
  double Angle; // or height of the view, world units
  bool Parallel;
  double Blur; // pixels
};

/**
 * A window with a body that shows its colours as they are.
 */
struct Scene
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Mapper;
  vtkActor* Actor = nullptr;
  Body Shape;

  Scene(const Body& body, vtkPolyData* splats, bool smooth = false)
    : Shape(body)
  {
    this->Mapper->SetInputData(splats);
    this->Mapper->SetScalarModeToUsePointData();
    this->Win.SmoothOutlines = smooth;
    this->Actor = this->Win.Add(this->Mapper);
    this->Actor->GetProperty()->SetAmbient(1.0);
    this->Actor->GetProperty()->SetDiffuse(0.0);
    this->Actor->GetProperty()->SetSpecular(0.0);
  }
  void Look(const View& view)
  {
    vtkCamera* camera = this->Win.Renderer->GetActiveCamera();
    camera->SetPosition(view.Position.data());
    camera->SetFocalPoint(view.Focus.data());
    camera->SetViewUp(0, 0, 1);
    camera->SetParallelProjection(view.Parallel);
    view.Parallel ? camera->SetParallelScale(0.5 * view.Angle) : camera->SetViewAngle(view.Angle);
    this->Win.Renderer->ResetCameraClippingRange();
  }
};

/// The face of the nearest hit, or -1.
inline int Nearest(const std::vector<Hit>& hits)
{
  return hits.empty() ? -1 : hits[0].Face;
}

inline bool Shows(const unsigned char* pixel, const Body& body, int face)
{
  for (size_t c = 0; c < 3; ++c)
  {
    const int wanted = face < 0 ? 0 : body.Faces[static_cast<size_t>(face)].Colour[c];
    if (std::abs(wanted - pixel[c]) > 3)
    {
      return false;
    }
  }
  return true;
}

struct Count
{
  int Holes = 0;  // background where a face is
  int Spilt = 0;  // a face where background is
  int Wrong = 0;  // another colour than that of the face that is there
  int Edges = 0;  // pixels that an edge is near to
  int Inside = 0; // other pixels of faces
  int Faults() const { return this->Holes + this->Spilt + this->Wrong; }
};

/**
 * What pixels may show where an edge is near: one of the faces that meet there, or a mean of their
 * colours; a mean with what is beyond; or a mean of the faces' normals, which may be lit more than
 * either.
 */
enum Mean
{
  OfFaces,
  WithBackground,
  OfNormals
};

/// The colours that rays near a pixel may show, from the least to the greatest of each channel.
struct Range
{
  bool Background = false;
  bool Edge = false;
  int Low[3] = { 255, 255, 255 };
  int High[3] = { 0, 0, 0 };

  Range(const Scene& scene, const Rays& rays, double x, double y, double blur)
  {
    int first = -2;
    for (int k = 0; k < 9; ++k)
    {
      const std::vector<Hit> hits =
        rays.Cast(scene.Shape, x + blur * (k % 3 - 1), y + blur * (k / 3 - 1));
      const int nearest = hits.empty() ? -1 : hits[0].Face;
      this->Edge = this->Edge || (k > 0 && nearest != first);
      first = nearest;
      this->Background = this->Background || hits.empty();
      for (const Hit& hit : hits)
      {
        // And of the face that is turned away at the same edge.
        if (hit.Face == nearest || hit.At - hits[0].At < 0.02)
        {
          this->Add(scene.Shape.Faces[static_cast<size_t>(hit.Face)].Colour);
        }
      }
    }
    if (!this->Edge && !this->Background)
    {
      *this = Range(scene.Shape.Faces[static_cast<size_t>(first)].Colour);
    }
  }
  explicit Range(const std::array<unsigned char, 3>& colour) { this->Add(colour); }
  void Add(const std::array<unsigned char, 3>& colour)
  {
    for (size_t c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min<int>(this->Low[c], colour[c]);
      this->High[c] = std::max<int>(this->High[c], colour[c]);
    }
  }
  bool Has(const unsigned char* pixel, int tolerance, Mean mean) const
  {
    bool within = true;
    for (size_t c = 0; c < 3; ++c)
    {
      const int low = mean == WithBackground && this->Background ? 0 : this->Low[c];
      const int high = mean == OfNormals && this->Edge ? 255 : this->High[c];
      within = within && pixel[c] >= low - tolerance && pixel[c] <= high + tolerance;
    }
    return within;
  }
};

/**
 * What a picture shows that it should not. Each pixel shows the face that its ray meets; where an
 * edge is nearer than blur (pixels) a mean.
 */
inline Count Compare(const Picture& picture, const Scene& scene, double blur, Mean mean = OfFaces)
{
  const Rays rays(scene.Win.Renderer, scene.Actor);
  Count count;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const Range range(scene, rays, x + 0.5, y + 0.5, blur);
      const bool shown = !picture.IsBackground(x, y);
      count.Edges += range.Edge;
      count.Inside += !range.Edge && !range.Background;
      count.Holes += !shown && !range.Background;
      count.Spilt += shown && range.Background && !range.Edge;
      // Sums are of whole numbers, and where only margins are those are small.
      const bool good = range.Has(picture.At(x, y), range.Edge ? 6 : 2, mean);
      count.Wrong += shown && !(range.Background && !range.Edge) && !good;
    }
  }
  return count;
}
}

#endif
