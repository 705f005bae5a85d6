// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A disc of radius 1 with a rounded rim: what modelling programs make of flat things. The rim has many vertices,
// and the flat faces have few.
#ifndef RimmedDisc_h
#define RimmedDisc_h

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

class RimmedDisc
{
public:
  /// How many vertices the rim has around and across, and the faces have: rings, inner * k in the k-th.
  struct Sampling
  {
    int Around, Across, Rings, Inner;
  };
  static constexpr Sampling Coarse = { 400, 24, 2, 8 };
  static constexpr Sampling Fine = { 800, 64, 40, 64 };

  /// rim: its radius, half of the disc's thickness.
  explicit RimmedDisc(double rim)
    : Rim(rim)
  {
  }

  /// Triangles, points and normals.
  vtkSmartPointer<vtkPolyData> MakeMesh(const Sampling& sampling) const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    const vtkIdType around = sampling.Around;
    for (int j = 0; j <= sampling.Across; ++j)
    {
      const double t = vtkMath::Pi() * (double(j) / sampling.Across - 0.5);
      for (vtkIdType i = 0; i < around; ++i)
      {
        const double u = 2 * vtkMath::Pi() * i / around;
        const double n[3] = { std::cos(t) * std::cos(u), std::cos(t) * std::sin(u), std::sin(t) };
        points->InsertNextPoint(
          std::cos(u) + this->Rim * n[0], std::sin(u) + this->Rim * n[1], this->Rim * n[2]);
        normals->InsertNextTuple(n);
        if (j < sampling.Across)
        {
          const vtkIdType a = j * around + i, b = j * around + (i + 1) % around;
          const vtkIdType lower[3] = { a, b, b + around }, upper[3] = { a, b + around, a + around };
          triangles->InsertNextCell(3, lower);
          triangles->InsertNextCell(3, upper);
        }
      }
    }
    for (const int side : { -1, 1 })
    {
      std::vector<vtkIdType> outer(around), inner;
      for (vtkIdType i = 0; i < around; ++i)
      {
        outer[i] = (side < 0 ? 0 : sampling.Across * around) + i;
      }
      for (int k = sampling.Rings; k >= 0; --k, outer = inner)
      {
        inner.assign(std::max(sampling.Inner * k, 1), 0);
        for (std::size_t i = 0; i < inner.size(); ++i)
        {
          const double u = 2 * vtkMath::Pi() * i / inner.size();
          const double r = double(k) / (sampling.Rings + 1);
          inner[i] = points->InsertNextPoint(r * std::cos(u), r * std::sin(u), side * this->Rim);
          normals->InsertNextTuple3(0, 0, side);
        }
        Stitch(outer, inner, side, triangles);
      }
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->SetNormals(normals);
    mesh->SetPolys(triangles);
    return mesh;
  }

  /// How far a place is off the surface, and the surface's normal beside it.
  double GetDistance(const double x[3], double normal[3]) const
  {
    const double r = std::hypot(x[0], x[1]);
    normal[0] = r > 1 ? x[0] * (1 - 1 / r) : 0;
    normal[1] = r > 1 ? x[1] * (1 - 1 / r) : 0;
    normal[2] = x[2];
    return std::abs(vtkMath::Normalize(normal) - this->Rim);
  }

private:
  /// Triangles between two rings.
  static void Stitch(const std::vector<vtkIdType>& outer, const std::vector<vtkIdType>& inner,
    int side, vtkCellArray* triangles)
  {
    const std::size_t n = outer.size(), m = inner.size();
    for (std::size_t i = 0, j = 0; i < n || (m > 1 && j < m);)
    {
      const bool along = (m == 1 || j == m) || (i < n && (i + 1) * m <= (j + 1) * n);
      vtkIdType corners[3] = { outer[i % n], along ? outer[(i + 1) % n] : inner[(j + 1) % m],
        inner[j % m] };
      if (side < 0)
      {
        std::swap(corners[0], corners[2]);
      }
      triangles->InsertNextCell(3, corners);
      ++(along ? i : j);
    }
  }

  const double Rim;
};

#endif
