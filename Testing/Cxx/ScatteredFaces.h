// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points on faces that meet at edges, and on what has none, about one spacing of 1 apart; and what
// vtkPointSplatEstimation makes of them.
#ifndef ScatteredFaces_h
#define ScatteredFaces_h

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <cmath>
#include <vector>

class ScatteredFaces
{
public:
  /// An edge of a point's face: how far away it is, and where.
  struct Edge
  {
    double Distance;
    double Direction[3]; // unit length
  };

  ScatteredFaces()
  {
    this->Normals->SetNumberOfComponents(3);
    this->Random->SetSeed(5);
    for (int k = 0; k < 10; ++k)
    {
      this->Next(0, 1); // the first numbers of this sequence go by the seed
    }
  }

  void Add(const double x[3], const double n[3], const std::vector<Edge>& edges)
  {
    this->Points->InsertNextPoint(x);
    this->Normals->InsertNextTuple(n);
    this->EdgesOf.push_back(edges);
    this->BordersOf.emplace_back();
  }

  /// Turns points and normals, but not the edges that they know, about a slanted axis.
  void Turn(double degrees)
  {
    vtkNew<vtkTransform> turn;
    turn->RotateWXYZ(degrees, 1, 2, 3);
    for (vtkIdType id = 0; id < this->Points->GetNumberOfPoints(); ++id)
    {
      this->Points->SetPoint(id, turn->TransformPoint(this->Points->GetPoint(id)));
      this->Normals->SetTuple(id, turn->TransformNormal(this->Normals->GetTuple(id)));
    }
  }

  /// Whether a line of a point, with that vector and its length, is where the surface ends, or at
  /// most one and a half spacings inside, since the points end somewhere before it does.
  bool IsAtBorder(vtkIdType id, const double c[3], double length) const
  {
    for (const Edge& border : this->BordersOf[id])
    {
      const double along = vtkMath::Dot(c, border.Direction);
      if (along > 0.6 * length && 1 / along > border.Distance - 1.5 * this->Spacing)
      {
        return true;
      }
    }
    return false;
  }

  void Repeat(vtkIdType id)
  {
    double x[3], n[3];
    this->Points->GetPoint(id, x);
    this->Normals->GetTuple(id, n);
    this->Add(x, n, {});
  }

  vtkIdType GetNumberOfPoints() const { return this->Points->GetNumberOfPoints(); }

  /// A cube from -0.5 to 0.5.
  void AddCube(int count)
  {
    this->Spacing = std::sqrt(6.0 / count);
    for (int i = 0; i < count; ++i)
    {
      const int a = i % 3;
      double x[3], n[3] = { 0, 0, 0 };
      for (double& component : x)
      {
        component = this->Next(-0.5, 0.5);
      }
      n[a] = i / 3 % 2 ? 1 : -1;
      x[a] = 0.5 * n[a];
      std::vector<Edge> edges;
      for (int k = 0; k < 4; ++k)
      {
        Edge edge = { 0, { 0, 0, 0 } };
        const int b = (a + 1 + k / 2) % 3;
        edge.Direction[b] = k % 2 ? 1 : -1;
        edge.Distance = 0.5 - x[b] * edge.Direction[b];
        edges.push_back(edge);
      }
      this->Add(x, n, edges);
    }
  }

  /**
   * Two half planes, the normals at an angle in degrees, that meet at an edge along z or, where
   * radius is not 0, in a fillet. off: how far normals are off, as a slope.
   */
  void AddFold(double degrees, bool convex, double radius, double off = 0.0)
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees), arc = radius * angle;
    const double width = 12, height = 240;
    const int count = static_cast<int>((2 * width + arc) * height);
    for (int i = 0; i < count; ++i)
    {
      const double s = this->Next(-width, width + arc), z = this->Next(0, height);
      const double turn = radius > 0 ? std::min(std::max(s / radius, 0.0), angle) : s < 0 ? 0 : angle;
      const double before = std::min(s, 0.0), after = std::max(s - arc, 0.0);
      const double side = convex ? 1 : -1;
      const double t[2] = { std::cos(turn), -std::sin(turn) };
      const double x[3] = { radius * std::sin(turn) + before + after * t[0],
        side * (radius * (std::cos(turn) - 1) + after * t[1]), z };
      double n[3] = { -t[1], side * t[0], 0 };
      for (int c = 0; c < 3 && off > 0; ++c)
      {
        n[c] += off * this->NextNormal();
      }
      vtkMath::Normalize(n);
      std::vector<Edge> edges;
      if (radius == 0)
      {
        const double to = s < 0 ? 1 : -1;
        edges.push_back({ std::abs(s), { to * t[0], to * side * t[1], 0 } });
      }
      this->Add(x, n, edges);
      this->BordersOf.back() = { { z, { 0, 0, -1 } }, { height - z, { 0, 0, 1 } },
        { s + width, { -t[0], -side * t[1], 0 } },
        { width + arc - s, { t[0], side * t[1], 0 } } };
    }
  }

  /**
   * The vertices of a mesh of two half planes that meet at a right angle in a row of them: with the
   * average of both normals, or split, with one of both each. Of their edges that one is the first,
   * and those at the mesh's border follow.
   */
  void AddGridFold(bool split)
  {
    const double half = std::sqrt(0.5);
    for (int row = 0; row < 40; ++row)
    {
      for (int k = -12; k <= 12; ++k)
      {
        // A little off the grid but on the edge and at the borders, as meshers do it.
        const bool end = std::abs(k) == 12, first = row == 0, last = row == 39;
        const double s = k + (k && !end ? this->Next(-0.2, 0.2) : 0.0);
        const double z = row + (first || last ? 0.0 : this->Next(-0.2, 0.2));
        const double x[3] = { std::min(s, 0.0), -std::max(s, 0.0), z };
        const double n[3] = { k < 0 ? 0.0 : k > 0 ? 1.0 : half, k < 0 ? 1.0 : k > 0 ? 0.0 : half, 0 };
        const double top[3] = { 0, 1, 0 }, wall[3] = { 1, 0, 0 };
        const Edge onTop = { std::abs(s), { 1, 0, 0 } }, onWall = { std::abs(s), { 0, 1, 0 } };
        std::vector<Edge> edges = { k > 0 ? onWall : onTop };
        if (first || last)
        {
          edges.push_back({ 0, { 0, 0, first ? -1.0 : 1.0 } });
        }
        if (end)
        {
          edges.push_back({ 0, { k < 0 ? -1.0 : 0.0, k > 0 ? -1.0 : 0.0, 0 } });
        }
        this->Add(x, k == 0 && split ? top : n, edges);
        this->BordersOf.back() = { { z, { 0, 0, -1 } }, { 39 - z, { 0, 0, 1 } },
          { 12 - std::abs(s), { k < 0 ? -1.0 : 0.0, k > 0 ? -1.0 : 0.0, 0 } } };
        if (k == 0 && split)
        {
          edges.front() = onWall;
          this->Add(x, wall, edges);
        }
      }
    }
  }

  /**
   * The vertices of a cube's mesh, so many to an edge, whose normals are averaged over its faces:
   * on an edge a vertex has one fold, at a corner two, of directions that are not told.
   */
  void AddGridCube(int count)
  {
    this->Spacing = 1.0 / (count - 1);
    const int last = count - 1;
    for (int i = 0; i < count * count * count; ++i)
    {
      const int at[3] = { i % count, i / count % count, i / count / count };
      double x[3], n[3];
      int faces = 0;
      for (int c = 0; c < 3; ++c)
      {
        x[c] = at[c] * this->Spacing - 0.5;
        n[c] = at[c] == 0 ? -1 : at[c] == last ? 1 : 0;
        faces += n[c] != 0;
      }
      if (faces > 0)
      {
        vtkMath::Normalize(n);
        this->Add(x, n, std::vector<Edge>(faces - 1));
      }
    }
  }

  /// A cylinder along z and its end.
  void AddCylinder(double radius)
  {
    const double length = 12, side = 2 * vtkMath::Pi() * radius * length;
    const double end = vtkMath::Pi() * radius * radius;
    const int count = static_cast<int>(side + end);
    for (int i = 0; i < count; ++i)
    {
      const double turn = this->Next(0, 2 * vtkMath::Pi());
      const double u[3] = { std::cos(turn), std::sin(turn), 0 };
      if (i < side)
      {
        const double z = this->Next(-length, 0);
        const double x[3] = { radius * u[0], radius * u[1], z };
        this->Add(x, u, { { -z, { 0, 0, 1 } } });
        this->BordersOf.back() = { { z + length, { 0, 0, -1 } } };
      }
      else
      {
        const double r = radius * std::sqrt(this->Next(0, 1));
        const double x[3] = { r * u[0], r * u[1], 0 }, n[3] = { 0, 0, 1 };
        this->Add(x, n, { { radius - r, { u[0], u[1], 0 } } });
      }
    }
  }

  void AddTube(double radius)
  {
    const double length = 2000 / radius;
    const int count = static_cast<int>(2 * vtkMath::Pi() * radius * length);
    for (int i = 0; i < count; ++i)
    {
      const double turn = this->Next(0, 2 * vtkMath::Pi());
      const double n[3] = { std::cos(turn), std::sin(turn), 0 };
      const double z = this->Next(0, length);
      const double x[3] = { radius * n[0], radius * n[1], z };
      this->Add(x, n, {});
      this->BordersOf.back() = { { z, { 0, 0, -1 } }, { length - z, { 0, 0, 1 } } };
    }
  }

  /// noise: of positions, in spacings; degrees: of normals.
  void AddSphere(int count, double noise, double degrees)
  {
    const double radius = std::sqrt(count / (4 * vtkMath::Pi()));
    const double slope = std::tan(vtkMath::RadiansFromDegrees(degrees)) * std::sqrt(0.5);
    for (int i = 0; i < count; ++i)
    {
      double x[3], n[3];
      for (double& component : n)
      {
        component = this->NextNormal();
      }
      vtkMath::Normalize(n);
      for (int c = 0; c < 3; ++c)
      {
        x[c] = radius * n[c] + noise * this->NextNormal();
      }
      for (double& component : n)
      {
        component += slope * this->NextNormal();
      }
      vtkMath::Normalize(n);
      this->Add(x, n, {});
    }
  }

  /// Two sheets that face away from each other.
  void AddSheets(double gap)
  {
    for (int i = 0; i < 4000; ++i)
    {
      const double side = i % 2 ? 1 : -1;
      const double width = 45;
      const double x[3] = { this->Next(0, width), this->Next(0, width), 0.5 * gap * side };
      const double n[3] = { 0, 0, side };
      this->Add(x, n, {});
      this->BordersOf.back() = { { x[0], { -1, 0, 0 } }, { width - x[0], { 1, 0, 0 } },
        { x[1], { 0, -1, 0 } }, { width - x[1], { 0, 1, 0 } } };
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  std::vector<std::vector<Edge>> EdgesOf;   // each point
  std::vector<std::vector<Edge>> BordersOf; // each point: where its surface ends
  double Spacing = 1;

private:
  double Next(double low, double high)
  {
    this->Random->Next();
    return this->Random->GetRangeValue(low, high);
  }
  double NextNormal()
  {
    double sum = 0;
    for (int k = 0; k < 12; ++k)
    {
      sum += this->Next(-0.5, 0.5);
    }
    return sum;
  }

  vtkNew<vtkMinimalStandardRandomSequence> Random;
};

class Estimated
{
public:
  explicit Estimated(const ScatteredFaces& scene)
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(scene.Points);
    data->GetPointData()->SetNormals(scene.Normals);
    this->Estimate(data, false);
  }
  explicit Estimated(vtkPolyData* data, bool fills = false) { this->Estimate(data, fills); }

  vtkIdType GetNumberOfPoints() const { return this->Data->GetNumberOfPoints(); }
  void GetPoint(vtkIdType id, double x[3]) const { this->Data->GetPoint(id, x); }

  bool HasLines() const { return this->GetArray(vtkPointSplatArrays::Clip) != nullptr; }
  /// One of two vectors of a point, and its length; 0 without the array.
  double GetLine(vtkIdType id, int k, double c[3]) const
  {
    return this->GetVector(vtkPointSplatArrays::Clip, id, k, c);
  }
  double GetFold(vtkIdType id, int k, double f[3]) const
  {
    return this->GetVector(vtkPointSplatArrays::Fold, id, k, f);
  }
  /// How much of a direction is along the normal of a disk's plane.
  double GetPlanePart(vtkIdType id, const double v[3]) const
  {
    double n[3];
    this->GetArray(vtkPointSplatArrays::PlaneNormal)->GetTuple(id, n);
    return std::abs(vtkMath::Dot(n, v));
  }
  double GetRadius(vtkIdType id) const
  {
    return this->GetArray(vtkPointSplatArrays::Radius)->GetComponent(id, 0);
  }

private:
  void Estimate(vtkPolyData* data, bool fills)
  {
    vtkNew<vtkPointSplatEstimation> estimation;
    estimation->SetInputData(data);
    estimation->SetFillGaps(fills);
    estimation->Update();
    this->Data = estimation->GetOutput();
  }
  vtkDataArray* GetArray(const char* name) const
  {
    return this->Data->GetPointData()->GetArray(name);
  }
  double GetVector(const char* name, vtkIdType id, int k, double v[3]) const
  {
    vtkDataArray* array = this->GetArray(name);
    for (int c = 0; c < 3; ++c)
    {
      v[c] = array ? array->GetComponent(id, 3 * k + c) : 0;
    }
    return vtkMath::Norm(v);
  }

  vtkSmartPointer<vtkPolyData> Data;
};

#endif
