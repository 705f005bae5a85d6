// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDisk.h"

#include "vtkPointSplatPrincipal.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A normal is not that of the surface if it leaves out more than this part of the neighbours'
/// squared distances, and another one much less.
constexpr float LargestResidual = 0.25f;
constexpr float ResidualRatio = 0.3f;
/// One that leaves out less, but more than this part, is not where the neighbours lie on a plane: ...
constexpr float LargestShadingResidual = 0.03f;
/// ... off that they are, in squares, by less than this part of what it leaves out (Testing/Accuracy/fit_constants.py).
constexpr float FlatPerResidual = 0.02f;
/// Nor is a plane the surface's that the neighbours' normals are not across, of either sign, by this
/// mean cosine: around a body of a few points they point everywhere.
constexpr float LeastAgreement = 0.7f;
/// The radius at borders, of the mean distance of the neighbours next to the point: no farther over
/// them than a triangle of equal sides needs, and a little for rounding.
constexpr float BorderPerDistance = 0.6f;
/// Neighbours lie in a row if their variance across it is less than this part of that along
/// it; those of a point on a straight border have about a third.
constexpr float RowVariance = 0.15f;
/// How far past the last neighbour, times its distance, a cell may reach where all neighbours are of
/// one sheet: more of them would cut little off then (Testing/Accuracy/fit_constants.py).
constexpr float WholeReach = 1.1f;
/// Neighbours tell how far apart points are up to so many times the third one's distance ...
constexpr float LikeThird = 2.0f;
/// ... and it is at least this part of the spacing.
constexpr float LeastDistance = 0.65f;
/// What is far of a flat sheet counts within so many distances of the sixth of all neighbours.
constexpr float FarReach = 2.0f;
/// The longest ellipse, axis to axis.
constexpr float LargestAspect = 8.0f;

/// Whether neighbours are off the plane across n through the centre by less than this part of their squared distances.
bool AreOnPlane(
  const vtkPointSplatNeighbors::Neighborhood& around, const float n[3], float mostOff)
{
  float off = 0, all = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    const float height = around.X[i] * n[0] + around.Y[i] * n[1] + around.Z[i] * n[2];
    off += height * height;
    all += around.SquaredDistance[i];
  }
  return off <= mostOff * all;
}
}

/**
 * Vertex normals of meshes whose triangles are not oriented consistently cancel along seams,
 * and point anywhere: a disk across such a normal would stand off the surface as a fin. On a flat face of a coarse mesh
 * those that are interpolated between its corners' lean over, all of them to about the same side: across these disks
 * would lie like shingles, and at a small angle one would see through between them.
 */
void vtkPointSplatDisk::ChoosePlane(
  const vtkPointSplatNeighbors::Neighborhood& around, int countNear, const float* normals)
{
  const float* n = normals + std::size_t(3) * around.Center;
  std::copy(n, n + 3, this->Normal);
  this->Sheet.Compare(around, normals, n);
  const float residual = this->Sheet.GetResidual(around, countNear);
  if (residual <= LargestShadingResidual || countNear < 4)
  {
    return;
  }
  vtkPointSplatNeighbors::Neighborhood near = around;
  near.Count = countNear;
  float fitted[3];
  vtkPointSplatPrincipal(near).GetNormal(fitted);
  const float side = n[0] * fitted[0] + n[1] * fitted[1] + n[2] * fitted[2] < 0 ? -1.0f : 1.0f;
  for (float& f : fitted)
  {
    f *= side;
  }
  if (residual <= LargestResidual && !AreOnPlane(near, fitted, FlatPerResidual * residual))
  {
    return;
  }
  float agreement = 0;
  for (int i = 0; i < countNear; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    agreement += std::abs(m[0] * fitted[0] + m[1] * fitted[1] + m[2] * fitted[2]) / countNear;
  }
  this->Sheet.Compare(around, normals, fitted);
  if (agreement > LeastAgreement &&
    this->Sheet.GetResidual(around, countNear) < ResidualRatio * residual)
  {
    std::copy(fitted, fitted + 3, this->Normal);
  }
  else
  {
    this->Sheet.Compare(around, normals, n);
  }
}

void vtkPointSplatDisk::SelectSheet(const vtkPointSplatNeighbors::Neighborhood& around,
  int countNear, const float* normals, float spacing)
{
  this->ChoosePlane(around, countNear, normals);
  this->Sheet.Select(around, countNear, spacing);
}

void vtkPointSplatDisk::Project(const vtkPointSplatNeighbors::Neighborhood& around)
{
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
  for (int k = 0; k < this->Sheet.Count; ++k)
  {
    const int i = this->Sheet.Members[k];
    const float x = around.X[i], y = around.Y[i], z = around.Z[i];
    const float p = x * u[0] + y * u[1] + z * u[2];
    const float q = x * v[0] + y * v[1] + z * v[2];
    // Unrolled onto the plane, as far away as in space.
    const float squared = p * p + q * q;
    const float longer = squared > 0 ? std::sqrt(around.SquaredDistance[i] / squared) : 0.0f;
    this->U[k] = longer * p;
    this->V[k] = longer * q;
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
  for (int i = 0; i < this->Sheet.Count; ++i)
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
  for (int i = 0; i < this->Sheet.Count; ++i)
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

/**
 * Keeps of the (convex) cell what has nx * x + ny * y <= offset. If that cuts something off,
 * `farthest` is the squared distance of the farthest vertex that is left.
 */
void vtkPointSplatDisk::Clip(float nx, float ny, float offset, int edge, float& farthest)
{
  float off[MaximumNumberOfVertices];
  bool cuts = false;
  for (int i = 0; i < this->Size; ++i)
  {
    off[i] = nx * this->Cell[i].X + ny * this->Cell[i].Y - offset;
    cuts = cuts || off[i] > 0;
  }
  if (!cuts)
  {
    return;
  }
  Vertex* result = this->Cell == this->Cells[0] ? this->Cells[1] : this->Cells[0];
  int size = 0;
  farthest = 0;
  const auto add = [&](const Vertex& vertex) {
    result[size++] = vertex;
    farthest = std::max(farthest, vertex.X * vertex.X + vertex.Y * vertex.Y);
  };
  for (int i = 0; i < this->Size; ++i)
  {
    const int next = i + 1 < this->Size ? i + 1 : 0;
    const Vertex& from = this->Cell[i];
    const Vertex& to = this->Cell[next];
    if (off[i] <= 0)
    {
      add(from);
    }
    if ((off[i] <= 0) != (off[next] <= 0) && size < MaximumNumberOfVertices - 1)
    {
      const float t = off[i] / (off[i] - off[next]);
      // Where the boundary leaves the half-plane the new edge begins.
      add({ from.X + t * (to.X - from.X), from.Y + t * (to.Y - from.Y),
        off[i] <= 0 ? edge : from.Edge });
    }
  }
  this->Cell = result;
  this->Size = size;
}

/// Cuts the frame down to the Voronoi cell; true if nothing of the frame is left.
bool vtkPointSplatDisk::ClipByBisectors(int count)
{
  float reach = 0;
  for (int i = 0; i < count; ++i)
  {
    reach = std::max(reach, this->U[i] * this->U[i] + this->V[i] * this->V[i]);
  }
  const float side = 2 * std::sqrt(reach);
  this->Cell = this->Cells[0];
  this->Size = 4;
  this->Cell[0] = { -side, -side, Frame };
  this->Cell[1] = { side, -side, Frame };
  this->Cell[2] = { side, side, Frame };
  this->Cell[3] = { -side, side, Frame };
  float farthest = 2 * side * side;
  for (int i = 0; i < count && this->Size > 0; ++i)
  {
    const float squared = this->U[i] * this->U[i] + this->V[i] * this->V[i];
    // A bisector is half way to its neighbour.
    if (squared >= 4 * farthest || squared <= 0)
    {
      continue;
    }
    this->Clip(this->U[i], this->V[i], 0.5f * squared, i, farthest);
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
 * The mean distance of the neighbours that share an edge of the cell with the centre, the Delaunay
 * neighbours, weighted by these edges: where four points lie on a circle, which of them are
 * neighbours is up to rounding, but these edges have no length then. A neighbour across a hole,
 * both ends of whose edge are farther than `most`, is not next to the centre.
 */
float vtkPointSplatDisk::MeanDistance(float most) const
{
  const auto isFar = [most](const Vertex& v) { return v.X * v.X + v.Y * v.Y > most * most; };
  float sum = 0, weights = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    const int i = this->Cell[j].Edge;
    const Vertex& to = this->Cell[j + 1 < this->Size ? j + 1 : 0];
    if (i != Frame && !(isFar(this->Cell[j]) && isFar(to)))
    {
      const float x = to.X - this->Cell[j].X, y = to.Y - this->Cell[j].Y;
      const float distance = std::sqrt(this->U[i] * this->U[i] + this->V[i] * this->V[i]);
      // Edges of open cells have any length.
      const float weight = std::min(std::sqrt(x * x + y * y), distance);
      sum += weight * distance;
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights : 0;
}

float vtkPointSplatDisk::GetSquaredReach(float aa, float bb, float ab, float circumscribed2)
{
  if (ab >= std::min(aa, bb))
  {
    // Obtuse at a neighbour: the bisector of the way to it meets the far side.
    return 0.25f * std::min(aa, bb) * aa * bb / (ab * ab);
  }
  if (ab < 0)
  {
    // Obtuse at the centre: both bisectors meet the far side, farther off the longer one.
    const float longer = std::max(aa, bb);
    return 0.25f * longer * longer * (aa + bb - 2 * ab) / ((longer - ab) * (longer - ab));
  }
  return circumscribed2;
}

/**
 * How far the centre's part of the Delaunay triangles around it reaches: to the circumcentre of an
 * acute one; of an obtuse one, whose circumcentre lies outside, to where bisectors leave it. That a
 * triangle is one of Delaunay's is known if its circumcircle lies within the distance `known` of the
 * last neighbour; else its circumcentre counts, and none that is farther than that neighbour: past a
 * border triangles have it anywhere.
 */
float vtkPointSplatDisk::Reach(float known, bool closed) const
{
  float farthest = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    const Vertex& vertex = this->Cell[j];
    const int a = this->Cell[j > 0 ? j - 1 : this->Size - 1].Edge;
    const int b = vertex.Edge;
    float squared = vertex.X * vertex.X + vertex.Y * vertex.Y;
    const bool certain = 4 * squared <= known * known;
    if (a == Frame || b == Frame || (!certain && !closed))
    {
      continue;
    }
    if (certain)
    {
      const float aa = this->U[a] * this->U[a] + this->V[a] * this->V[a];
      const float bb = this->U[b] * this->U[b] + this->V[b] * this->V[b];
      const float ab = this->U[a] * this->U[b] + this->V[a] * this->V[b];
      squared = GetSquaredReach(aa, bb, ab, squared);
    }
    else
    {
      squared = std::min(squared, known * known);
    }
    farthest = std::max(farthest, squared);
  }
  return std::sqrt(farthest);
}

/// The distance of the cell's vertex that is farthest, but not past `most`.
float vtkPointSplatDisk::Farthest(float most) const
{
  float farthest = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    const float squared =
      this->Cell[j].X * this->Cell[j].X + this->Cell[j].Y * this->Cell[j].Y;
    farthest = squared <= most * most ? std::max(farthest, squared) : farthest;
  }
  return std::sqrt(farthest);
}

float vtkPointSplatDisk::GetDistance(const float* squared, int count, float spacing)
{
  if (count == 0)
  {
    return 0;
  }
  const float most = LikeThird * LikeThird * squared[std::min(2, count - 1)];
  float sum = 0;
  int near = 0;
  for (; near < count && squared[near] <= most; ++near)
  {
    sum += std::sqrt(squared[near]);
  }
  return near > 0 ? std::max(sum / near, LeastDistance * spacing) : 0.0f;
}

float vtkPointSplatDisk::MeasureDistance() const
{
  float squared[MaximumNumberOfVertices];
  int count = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    const int i = this->Cell[j].Edge;
    const float distance2 =
      i != Frame ? this->U[i] * this->U[i] + this->V[i] * this->V[i] : -1.0f;
    if (distance2 >= 0) // NaN is not
    {
      squared[count++] = distance2;
    }
  }
  std::sort(squared, squared + count);
  return GetDistance(squared, count, this->Spacing);
}

float vtkPointSplatDisk::FindBorder(float most, int next[2]) const
{
  if (this->Sheet.Count == 0)
  {
    return 0; // no cell
  }
  const auto isFar = [&](int j) {
    const Vertex& v = this->Cell[j < this->Size ? j : j - this->Size];
    return v.X * v.X + v.Y * v.Y > most * most;
  };
  int runs = 0;
  for (int j = 0; j < this->Size; ++j)
  {
    // An edge is that of its first vertex.
    const int edge = this->Cell[j].Edge;
    if (isFar(j) != isFar(j + 1))
    {
      if (edge == Frame)
      {
        return 0;
      }
      runs += isFar(j) ? 1 : 0;
      next[isFar(j) ? 1 : 0] = this->Sheet.Members[edge];
    }
  }
  return runs == 1 && next[0] != next[1]
    ? this->Farthest(std::numeric_limits<float>::infinity())
    : 0.0f;
}

bool vtkPointSplatDisk::InRow(int nearest) const
{
  const int count = std::min(nearest, this->Sheet.Count);
  float u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  for (int i = 0; i < count; ++i)
  {
    u += this->U[i];
    v += this->V[i];
    uu += this->U[i] * this->U[i];
    uv += this->U[i] * this->V[i];
    vv += this->V[i] * this->V[i];
  }
  const float n = static_cast<float>(std::max(count, 1));
  uu -= u * u / n;
  uv -= u * v / n;
  vv -= v * v / n;
  const float mean = 0.5f * (uu + vv);
  const float root = std::sqrt(0.25f * (uu - vv) * (uu - vv) + uv * uv);
  return mean - root < RowVariance * (mean + root);
}

void vtkPointSplatDisk::Limit(float most)
{
  const float share = this->Length1 > most ? most / this->Length1 : 1.0f;
  this->Length1 *= share;
  this->Length2 *= share;
  this->Gap = std::min(this->Gap, most);
}

bool vtkPointSplatDisk::Estimate(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, bool elliptical, float usual, float holeLimit)
{
  const float spacing = std::min(vtkPointSplatSheet::GetSpacing(around), usual);
  this->SelectSheet(around, vtkPointSplatSheet::CountNear(around, spacing), normals, spacing);
  this->Project(around);
  if (elliptical)
  {
    this->Whiten();
  }
  this->Spacing = this->Gap = this->Opening = this->Distance = 0;
  int count = this->Sheet.Count;
  const auto distance = [this](int i) {
    return std::sqrt(this->U[i] * this->U[i] + this->V[i] * this->V[i]);
  };
  const float all = std::numeric_limits<float>::infinity();
  const bool closed = this->ClipByBisectors(count) &&
    this->Farthest(all) <= (this->Sheet.Whole ? WholeReach : 1.0f) * distance(count - 1);
  if (!closed && this->Sheet.Near < count)
  {
    // What is far counts where it is all around, on a sparse flat face, or where it is known how wide triangles are
    // and it is no farther: so the next row does, of points that are much denser along rows.
    const bool known = holeLimit < std::numeric_limits<float>::max();
    const int rank = std::min(vtkPointSplatSheet::SpacingRank, count);
    const float widest = std::max(known ? 2 * holeLimit * distance(rank - 1) : 0.0f,
      this->Sheet.IsFlatAfar ? FarReach * vtkPointSplatSheet::GetSpacing(around) : 0.0f);
    while (count > this->Sheet.Near && distance(count - 1) >= widest)
    {
      --count;
    }
    this->ClipByBisectors(count);
  }
  float radius = 0;
  if (count > 0)
  {
    this->Spacing = distance(std::min(vtkPointSplatSheet::SpacingRank, count) - 1);
    this->Opening = closed ? this->Farthest(all) : 0.0f;
    this->Distance = this->MeasureDistance() * this->Scale1;
    const float most = holeLimit * this->Spacing;
    const float mean = this->MeanDistance(most);
    radius = closed ? std::min(mean, this->Farthest(most)) : BorderPerDistance * mean;
    if (!(radius > 0))
    {
      // There are holes all around.
      radius = BorderPerDistance * distance(0);
    }
    // A disk that covers its cell covers what it has to.
    const bool covers = closed && radius >= this->Opening;
    this->Gap = covers ? 0.0f : this->Reach(distance(count - 1), closed) * this->Scale1;
  }
  this->Length1 = radius * this->Scale1;
  this->Length2 = radius * this->Scale2;
  return closed;
}

VTK_ABI_NAMESPACE_END
