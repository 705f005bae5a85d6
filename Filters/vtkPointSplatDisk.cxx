// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDisk.h"

#include "vtkPointSplatNormals.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A neighbour whose normal parts by more than this cosine (78 degrees) is of another sheet ...
constexpr float LeastNormalCosine = 0.2f;
/// ... if it lies higher above the tangent plane than this part of its distance; normals may be
/// wrong, or oriented this way and that over one sheet.
constexpr float LargestElevationAcross = 0.3f;
/// So is any that lies higher than this.
constexpr float LargestElevation = 0.8f;
/// A normal is not that of the surface if its tangent plane leaves out more than this part of
/// the neighbours' squared distances, and another plane much less.
constexpr float LargestResidual = 0.25f;
constexpr float ResidualRatio = 0.3f;
/// A Voronoi vertex between two neighbours seen at a wider angle (150 degrees) is left to them.
constexpr float WidestAngleCosine = -0.8660254f;
/// Beyond the farthest vertex, for rounding and for what lies between the tangent planes.
constexpr float Margin = 1.02f;
/// The disk of a point for which neighbours give a distance only: half a square's diagonal.
constexpr float RadiusPerDistance = 0.70710678f;
/// Neighbours lie in a row if their variance across it is less than this part of that along
/// it; those of a point on a straight border have about a third.
constexpr float RowVariance = 0.15f;
/// The neighbour whose distance tells the spacing.
constexpr int SpacingRank = 6;
/// How far a disk on a border may reach, of the distance to the farthest of its nearby neighbours.
constexpr float BorderReach = 0.7f;
/// The longest ellipse, axis to axis.
constexpr float LargestAspect = 8.0f;
}

namespace
{
/// The part of the neighbours' squared distances that lies across a plane.
float Residual(const vtkPointSplatNeighbors::Neighborhood& around, const float n[3])
{
  float across = 0, all = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    const float height = around.X[i] * n[0] + around.Y[i] * n[1] + around.Z[i] * n[2];
    across += height * height;
    all += around.SquaredDistance[i];
  }
  return all > 0 ? across / all : 0;
}
}

/**
 * Vertex normals of meshes whose triangles are not oriented consistently cancel along seams,
 * and point anywhere: a disk across such a normal would stand off the surface as a fin.
 */
void vtkPointSplatDisk::ChoosePlane(
  const vtkPointSplatNeighbors::Neighborhood& around, const float* normals)
{
  const float* n = normals + std::size_t(3) * around.Center;
  std::copy(n, n + 3, this->Normal);
  const float residual = Residual(around, n);
  if (residual <= LargestResidual || around.Count < 4)
  {
    return;
  }
  float fitted[3];
  vtkPointSplatNormals::FitPlane(around, fitted);
  if (Residual(around, fitted) < ResidualRatio * residual)
  {
    const float side = n[0] * fitted[0] + n[1] * fitted[1] + n[2] * fitted[2] < 0 ? -1.0f : 1.0f;
    for (int i = 0; i < 3; ++i)
    {
      this->Normal[i] = side * fitted[i];
    }
  }
}

void vtkPointSplatDisk::Project(
  const vtkPointSplatNeighbors::Neighborhood& around, const float* normals)
{
  this->ChoosePlane(around, normals);
  const float* n = this->Normal;
  // An orthonormal frame without branches (Duff et al. 2017, Building an orthonormal basis).
  const float sign = std::copysign(1.0f, n[2]);
  const float a = -1.0f / (sign + n[2]);
  const float b = n[0] * n[1] * a;
  const float u[3] = { 1.0f + sign * n[0] * n[0] * a, sign * b, -sign * n[0] };
  const float v[3] = { b, sign + n[1] * n[1] * a, -n[1] };
  std::copy(u, u + 3, this->Axis1);
  std::copy(v, v + 3, this->Axis2);
  this->Scale1 = this->Scale2 = 1;

  this->Count = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    const float x = around.X[i], y = around.Y[i], z = around.Z[i];
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float height = x * n[0] + y * n[1] + z * n[2];
    const float cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
    const float elevation =
      cosine < LeastNormalCosine ? LargestElevationAcross : LargestElevation;
    if (height * height > elevation * elevation * around.SquaredDistance[i])
    {
      continue;
    }
    this->U[this->Count] = x * u[0] + y * u[1] + z * u[2];
    this->V[this->Count] = x * v[0] + y * v[1] + z * v[2];
    ++this->Count;
  }
}

/**
 * Turns the plane's coordinates to the principal axes of the neighbours and scales them
 * such that their distribution is round: the disk is a circle there and an ellipse in world
 * units. The covariance is the upper left 2 x 2 block of Confetti's M_H (section 4.2,
 * equation 3, and section 4.3), T moving the centre to the origin and R turning the tangent
 * plane to the xy-plane. Axis lengths are the square roots of its eigenvalues, which is
 * what has the unit of a length.
 */
void vtkPointSplatDisk::Whiten()
{
  float uu = 0, uv = 0, vv = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    uu += this->U[i] * this->U[i];
    uv += this->U[i] * this->V[i];
    vv += this->V[i] * this->V[i];
  }
  const float mean = 0.5f * (uu + vv);
  const float half = std::sqrt(0.25f * (uu - vv) * (uu - vv) + uv * uv);
  if (!(mean > 0) || !std::isfinite(mean))
  {
    return;
  }
  const float angle = 0.5f * std::atan2(2 * uv, uu - vv);
  const float c = std::cos(angle), s = std::sin(angle);
  const float long1 = std::sqrt(mean + half);
  const float long2 = std::max(std::sqrt(std::max(mean - half, 0.0f)), long1 / LargestAspect);
  // Keep distances of the size that they had.
  const float scale = 1 / std::sqrt(long1 * long2);
  this->Scale1 = long1 * scale;
  this->Scale2 = long2 * scale;
  for (int i = 0; i < this->Count; ++i)
  {
    const float x = this->U[i], y = this->V[i];
    this->U[i] = (c * x + s * y) / this->Scale1;
    this->V[i] = (c * y - s * x) / this->Scale2;
  }
  for (int i = 0; i < 3; ++i)
  {
    const float x = this->Axis1[i], y = this->Axis2[i];
    this->Axis1[i] = c * x + s * y;
    this->Axis2[i] = c * y - s * x;
  }
}

/// Keeps of the (convex) cell what has nx * x + ny * y <= offset.
void vtkPointSplatDisk::Clip(float nx, float ny, float offset, int edge)
{
  Vertex result[MaximumNumberOfVertices];
  int size = 0;
  float before = nx * this->Cell[0].X + ny * this->Cell[0].Y - offset;
  for (int i = 0; i < this->Size; ++i)
  {
    const Vertex& from = this->Cell[i];
    const Vertex& to = this->Cell[i + 1 < this->Size ? i + 1 : 0];
    const float after = nx * to.X + ny * to.Y - offset;
    if (before <= 0)
    {
      result[size++] = from;
    }
    if ((before <= 0) != (after <= 0) && size < MaximumNumberOfVertices - 1)
    {
      const float t = before / (before - after);
      // Where the boundary leaves the half-plane the new edge begins.
      result[size++] = { from.X + t * (to.X - from.X), from.Y + t * (to.Y - from.Y),
        before <= 0 ? edge : from.Edge };
    }
    before = after;
  }
  std::copy(result, result + size, this->Cell);
  this->Size = size;
}

/// Cuts the frame down to the Voronoi cell; true if nothing of the frame is left.
bool vtkPointSplatDisk::ClipByBisectors()
{
  const float side = 2 * this->Reach;
  this->Size = 4;
  this->Cell[0] = { -side, -side, Frame };
  this->Cell[1] = { side, -side, Frame };
  this->Cell[2] = { side, side, Frame };
  this->Cell[3] = { -side, side, Frame };
  float farthest = 2 * side * side;
  for (int i = 0; i < this->Count && this->Size > 0; ++i)
  {
    const float squared = this->U[i] * this->U[i] + this->V[i] * this->V[i];
    // A bisector is half way to its neighbour.
    if (squared >= 4 * farthest || squared <= 0)
    {
      continue;
    }
    this->Clip(this->U[i], this->V[i], 0.5f * squared, i);
    farthest = 0;
    for (int j = 0; j < this->Size; ++j)
    {
      farthest = std::max(
        farthest, this->Cell[j].X * this->Cell[j].X + this->Cell[j].Y * this->Cell[j].Y);
    }
  }
  for (int j = 0; j < this->Size; ++j)
  {
    if (this->Cell[j].Edge == Frame)
    {
      return false;
    }
  }
  return true;
}

/**
 * On a border of the surface the cell is open. If the centre is a corner of the convex hull
 * of its neighbours, what of the cell lies outside the hull is no surface.
 */
void vtkPointSplatDisk::ClipByHull()
{
  float angles[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  for (int i = 0; i < this->Count; ++i)
  {
    angles[i] = std::atan2(this->V[i], this->U[i]);
  }
  std::sort(angles, angles + this->Count);
  const float pi = 3.14159265f;
  for (int i = 0; i < this->Count; ++i)
  {
    const float from = angles[i];
    const float to = i + 1 < this->Count ? angles[i + 1] : angles[0] + 2 * pi;
    if (to - from >= pi)
    {
      // The hull's sides through the centre point to where the gap begins and ends.
      this->Clip(-std::sin(from), std::cos(from), 0, Hull);
      this->Clip(std::sin(to), -std::cos(to), 0, Hull);
      return;
    }
  }
}

float vtkPointSplatDisk::FarthestVertex(float limit) const
{
  float farthest = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    const Vertex& vertex = this->Cell[j];
    const int a = this->Cell[j > 0 ? j - 1 : this->Size - 1].Edge;
    const int b = vertex.Edge;
    const float squared = vertex.X * vertex.X + vertex.Y * vertex.Y;
    if (a == Frame || b == Frame || squared <= farthest || squared > limit * limit)
    {
      continue;
    }
    if (a >= 0 && b >= 0)
    {
      const float cosine = this->U[a] * this->U[b] + this->V[a] * this->V[b];
      const float lengths = (this->U[a] * this->U[a] + this->V[a] * this->V[a]) *
        (this->U[b] * this->U[b] + this->V[b] * this->V[b]);
      if (cosine < 0 && cosine * cosine > WidestAngleCosine * WidestAngleCosine * lengths)
      {
        continue;
      }
    }
    farthest = squared;
  }
  return std::sqrt(farthest);
}

bool vtkPointSplatDisk::InRow() const
{
  float u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    u += this->U[i];
    v += this->V[i];
    uu += this->U[i] * this->U[i];
    uv += this->U[i] * this->V[i];
    vv += this->V[i] * this->V[i];
  }
  const float n = static_cast<float>(std::max(this->Count, 1));
  uu -= u * u / n;
  uv -= u * v / n;
  vv -= v * v / n;
  const float mean = 0.5f * (uu + vv);
  const float root = std::sqrt(0.25f * (uu - vv) * (uu - vv) + uv * uv);
  return mean - root < RowVariance * (mean + root);
}

bool vtkPointSplatDisk::Estimate(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, bool elliptical, int nearby, bool border, float limit)
{
  this->Project(around, normals);
  if (elliptical)
  {
    this->Whiten();
  }
  this->Reach = 0;
  float nearest = std::numeric_limits<float>::max(), borderReach = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    const float squared = this->U[i] * this->U[i] + this->V[i] * this->V[i];
    this->Reach = std::max(this->Reach, squared);
    nearest = std::min(nearest, squared);
    borderReach = i < nearby ? this->Reach : borderReach;
    this->Spacing = i < SpacingRank ? std::sqrt(squared) : this->Spacing;
  }
  this->Reach = std::sqrt(this->Reach);
  const bool closed = this->Count > 2 && this->ClipByBisectors();
  if (!closed && !border)
  {
    return false;
  }
  float radius = 0;
  if (this->Count > 2)
  {
    if (!closed)
    {
      this->ClipByHull();
      this->Reach = BorderReach * std::sqrt(borderReach);
    }
    radius = std::min(Margin * this->FarthestVertex(limit * this->Spacing), this->Reach);
  }
  if (radius <= 0)
  {
    // No vertex: nothing but neighbours in a row, or of other sheets.
    radius = this->Count > 0
      ? RadiusPerDistance * std::sqrt(nearest)
      : (around.Count > 0 ? RadiusPerDistance * std::sqrt(around.SquaredDistance[0]) : 0.0f);
  }
  this->Length1 = radius * this->Scale1;
  this->Length2 = radius * this->Scale2;
  return closed;
}

VTK_ABI_NAMESPACE_END
