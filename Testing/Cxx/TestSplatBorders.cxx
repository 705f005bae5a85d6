// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation clips the splats of a regular sampling where its surface ends, and
// nothing else, however dense it is in one direction. Lengths are in spacings.
#include "Expect.h"
#include "ScatteredFaces.h"
#include "UnevenColumns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

namespace
{
/// A sheet of 41 x 31 points with a rectangular hole in it, whose corners lie on points.
constexpr int Columns = 40, Rows = 30;
constexpr int Left = 12, Right = 24, Low = 9, High = 19;

/// By how much a place lies outside of the sheet, ...
double OutsideAll(double x, double y)
{
  return std::max({ -x, x - Columns, -y, y - Rows });
}

/// ... or off it, in its hole.
double Outside(double x, double y)
{
  const double hole =
    std::min({ x - Left, Right - x, y - Low, High - y });
  return std::max(OutsideAll(x, y), hole);
}

/// The points of the sheet, bent about y; those inside are a little off the grid, as meshers do it.
ScatteredFaces Sheet(double bend)
{
  ScatteredFaces scene;
  for (int j = 0; j <= Rows; ++j)
  {
    for (int i = 0; i <= Columns; ++i)
    {
      const double to = Outside(i, j);
      if (to > 0)
      {
        continue;
      }
      const double x = i + (to < 0 ? 0.15 * std::sin(7.0 * i + 3.0 * j) : 0);
      const double y = j + (to < 0 ? 0.15 * std::sin(5.0 * i - 8.0 * j) : 0);
      const double turn = bend * x;
      const double p[3] = { bend > 0 ? std::sin(turn) / bend : x, y,
        bend > 0 ? (std::cos(turn) - 1) / bend : 0 };
      const double n[3] = { std::sin(turn), 0, std::cos(turn) };
      scene.Add(p, n, std::vector<ScatteredFaces::Edge>(to == 0 ? 1 : 0));
    }
  }
  return scene;
}

int CountLines(const Estimated& splats, vtkIdType id)
{
  double c[3];
  return (splats.GetLine(id, 0, c) > 0) + (splats.GetLine(id, 1, c) > 0);
}

void OfFlatSheet()
{
  const ScatteredFaces scene = Sheet(0);
  const Estimated splats(scene);
  double farthest = 0, atReflexCorner = 0;
  int missed = 0, wrong = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    const double* p = scene.Points->GetPoint(id);
    const double at[2] = { p[0], p[1] };
    const bool border = !scene.EdgesOf[id].empty();
    const double aside = std::min(std::abs(at[0] - Left), std::abs(at[0] - Right));
    const double below = std::min(std::abs(at[1] - Low), std::abs(at[1] - High));
    // A hole's corner may as well be one that a triangle cuts.
    const bool reflex = aside + below <= 2.5;
    const bool corner =
      (at[0] == 0 || at[0] == Columns) && (at[1] == 0 || at[1] == Rows);
    missed += border && aside + below > 1 && CountLines(splats, id) < (corner ? 2 : 1);
    double lines[2][3];
    for (int k = 0; k < 2; ++k)
    {
      // Of those inside, which end at the border where they would reach over it.
      const double length = splats.GetLine(id, k, lines[k]);
      const double off = length > 0 ? 1 / (length * length) : 0;
      wrong += !border && length > 0 &&
        std::abs(Outside(at[0] + off * lines[k][0], at[1] + off * lines[k][1])) > 0.1;
    }
    // Where what draws the disk reaches.
    for (int k = 0; k < 1080; ++k)
    {
      const double angle = vtkMath::Pi() * k / 36, r = splats.GetRadius(id) * (k / 72 + 1) / 10;
      const double d[3] = { r * std::cos(angle), r * std::sin(angle), 0 };
      if (vtkMath::Dot(lines[0], d) <= 1 && vtkMath::Dot(lines[1], d) <= 1)
      {
        double& most = reflex ? atReflexCorner : farthest;
        most = std::max(most, Outside(at[0] + d[0], at[1] + d[1]));
      }
    }
  }
  Expect(missed == 0, std::to_string(missed) + " points at the border without a line");
  Expect(wrong == 0, std::to_string(wrong) + " lines of points inside that are not the border's");
  AtMost(farthest, 0.03, "past the border");
  AtMost(atReflexCorner, 0.55, "past a hole's corner");
}

void OfBentSheet()
{
  const ScatteredFaces scene = Sheet(0.05);
  const Estimated splats(scene);
  int missed = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    missed += !scene.EdgesOf[id].empty() && CountLines(splats, id) == 0;
  }
  AtMost(missed, 4, "bent: points without a line, and the hole has four corners");
}

void HasNone(const ScatteredFaces& scene, const std::string& name)
{
  const Estimated splats(scene);
  int lines = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    double first[3], second[3], sum[3];
    const double length = splats.GetLine(id, 0, first);
    splats.GetLine(id, 1, second);
    vtkMath::Add(first, second, sum);
    // Of a pair to both sides a disk along a tube has two.
    lines += vtkMath::Norm(sum) < 1e-4 * length ? 0 : CountLines(splats, id);
  }
  Expect(lines == 0, name + ": " + std::to_string(lines) + " lines");
}

/// Of a sheet whose places have two parameters: where it is, and by how much such a place is off it.
struct Parametric
{
  using Place = std::array<double, 3>;
  std::function<Place(double u, double v)> At;
  std::function<Place(double u, double v)> Normal;
  std::function<double(const Place&)> Outside; // in v's unit of 1 from row to row or less
  int Columns;
  int Rows;
  bool Closed; // in u
  double Most;   // that splats end past a border, which is straight only between its points
};

/// Columns that are many times denser than rows, or rows than columns: where splats are drawn, and
/// whether they cover all.
void OfStretched(const Parametric& sheet, const std::string& name)
{
  ScatteredFaces scene;
  for (int j = 0; j < sheet.Rows; ++j)
  {
    for (int i = 0; i < sheet.Columns; ++i)
    {
      scene.Add(sheet.At(i, j).data(), sheet.Normal(i, j).data(), {});
    }
  }
  const Estimated splats(scene);
  double farthest = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    const double* p = scene.Points->GetPoint(id);
    double lines[2][3], u[3], v[3];
    splats.GetLine(id, 0, lines[0]);
    splats.GetLine(id, 1, lines[1]);
    vtkMath::Perpendiculars(scene.Normals->GetTuple(id), u, v, 0);
    for (int k = 0; k < 360; ++k)
    {
      const double angle = vtkMath::Pi() * k / 36, r = splats.GetRadius(id) * 0.3 * (k / 72 + 1);
      double d[3];
      for (int c = 0; c < 3; ++c)
      {
        d[c] = r * (std::cos(angle) * u[c] + std::sin(angle) * v[c]);
      }
      if (vtkMath::Dot(lines[0], d) <= 1 && vtkMath::Dot(lines[1], d) <= 1)
      {
        farthest = std::max(farthest, sheet.Outside({ p[0] + d[0], p[1] + d[1], p[2] + d[2] }));
      }
    }
  }
  AtMost(farthest, sheet.Most, name + ": past the border");
  int bare = 0;
  for (int k = 0; k < 3000; ++k)
  {
    // By steps of two irrational numbers, and often at the first row.
    const double i = std::fmod(0.6180339887 * k, 1.0) * (sheet.Columns - (sheet.Closed ? 0 : 1));
    const double j = std::fmod(0.7548776662 * k, 1.0) * (k % 3 == 0 ? 1 : sheet.Rows - 1);
    const Parametric::Place at = sheet.At(i, j);
    bool covered = false;
    for (vtkIdType id = 0; id < scene.GetNumberOfPoints() && !covered; ++id)
    {
      const double* p = scene.Points->GetPoint(id);
      const double d[3] = { at[0] - p[0], at[1] - p[1], at[2] - p[2] };
      double line[2][3];
      splats.GetLine(id, 0, line[0]);
      splats.GetLine(id, 1, line[1]);
      covered = vtkMath::Norm(d) <= 1.01 * splats.GetRadius(id) &&
        vtkMath::Dot(line[0], d) <= 1.01 && vtkMath::Dot(line[1], d) <= 1.01;
    }
    bare += !covered;
  }
  AtMost(bare, 3, name + ": places of 3000 that no splat covers");
}

void OfStretchedSheets()
{
  using Place = Parametric::Place;
  for (const int ratio : { 1, 3, 8, 20 })
  {
    const int columns = 21, rows = 14 * ratio + 1;
    const double height = 14.0;
    OfStretched({ [=](double i, double j) { return Place{ i, j / ratio, 0 }; },
                  [](double, double) { return Place{ 0, 0, 1 }; },
                  [=](const Place& p) {
                    return std::max({ -p[0], p[0] - columns + 1, -p[1], p[1] - height });
                  },
                  columns, rows, false, 0.03 },
      "columns " + std::to_string(ratio) + " times as dense");
    const int spokes = 80, rings = 10 * ratio + 1;
    const double spacing = 2 * vtkMath::Pi() / spokes;
    OfStretched({ [=](double i, double j) {
                   const double r = (0.4 + j * 0.06 / ratio) / spacing;
                   return Place{ r * std::cos(i * spacing), r * std::sin(i * spacing), 0 };
                 },
                  [](double, double) { return Place{ 0, 0, 1 }; },
                  [=](const Place& p) {
                    const double r = std::hypot(p[0], p[1]) * spacing;
                    return std::max(r - 1.0, 0.4 - r) / spacing;
                  },
                  spokes, rings, true, 0.07 },
      "annulus " + std::to_string(ratio) + " times as dense across");
  }
  // A tube whose rings are one to five times as far apart as its points along them.
  const int count = 200;
  const double radius = count / (2 * vtkMath::Pi());
  const auto apart = [](double turn) { return 3 + 2 * std::cos(turn); };
  OfStretched({ [=](double i, double j) {
                 const double turn = i / radius;
                 return Place{ radius * std::cos(turn), radius * std::sin(turn), j * apart(turn) };
               },
                [=](double i, double) {
                  return Place{ std::cos(i / radius), std::sin(i / radius), 0 };
                },
                [=](const Place& p) {
                  return std::max(-p[2], p[2] - 20 * apart(std::atan2(p[1], p[0])));
                },
                count, 21, true, 0.3 },
    "tube of uneven rings");
  // Rings farther apart than the tube is wide, along which disks reach from one to the next: they end beside
  // the axis before they leave the tube, but at its ends.
  const double thin = 15 / (2 * vtkMath::Pi()), step = 1.5 * thin;
  OfStretched({ [=](double i, double j) {
                 return Place{ thin * std::cos(i / thin), thin * std::sin(i / thin), j * step };
               },
                [=](double i, double) { return Place{ std::cos(i / thin), std::sin(i / thin), 0 }; },
                [=](const Place& p) {
                  const double inside = std::min(p[2], 39 * step - p[2]);
                  const double beside = std::hypot(p[0], p[1]) - 1.05 * thin;
                  return std::max(-inside, inside > 2.5 * step ? beside : 0.0);
                },
                15, 40, true, 0.07 },
    "thin tube");
}

/**
 * A sheet of points that are off the places of uneven columns, as those of a mesh that is coarser where it may be: what
 * its cells reach differs by far from place to place, and little from one to the next. Its border is one all the same.
 */
void OfUnevenColumns(double dense)
{
  constexpr int size = 60;
  ScatteredFaces scene;
  const double up[3] = { 0, 0, 1 };
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  std::vector<bool> ofRim;
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const bool inner = i > 0 && j > 0 && i < size - 1 && j < size - 1;
      const double x = i + (inner ? off(generator) : 0), y = j + (inner ? off(generator) : 0);
      const double p[3] = { PlaceColumn(x, size, dense), y, 0 };
      scene.Add(p, up, {});
      ofRim.push_back(!inner);
    }
  }
  const Estimated splats(scene);
  int missed = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    missed += ofRim[id] && CountLines(splats, id) == 0;
  }
  Expect(missed == 0,
    "columns up to " + std::to_string(dense) + " times as dense: " + std::to_string(missed) + " points of the border without a line");
}

/// Of points up to `offset` beside a grid's, whose columns are `dense` times as close in the middle: round holes, with
/// points all along them, are no gaps of the sampling.
void OfHoles(double radius, double dense, double offset, const std::string& name)
{
  constexpr int size = 60;
  constexpr double centers[2] = { 0.25 * size, 0.75 * size };
  ScatteredFaces scene;
  const double up[3] = { 0, 0, 1 };
  const auto place = [&](double t) { return PlaceColumn(t, size, dense); };
  std::vector<bool> ofRing;
  std::vector<std::array<double, 2>> holes;
  for (const double x : centers)
  {
    for (const double y : centers)
    {
      holes.push_back({ place(x), y });
      const int count = static_cast<int>(2 * vtkMath::Pi() * radius);
      for (int k = 0; k < count; ++k)
      {
        const double turn = 2 * vtkMath::Pi() * k / count;
        const double p[3] = { place(x) + radius * std::cos(turn), y + radius * std::sin(turn), 0 };
        scene.Add(p, up, {});
        ofRing.push_back(true);
      }
    }
  }
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> off(-offset, offset);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const double p[3] = { place(i + off(generator)), j + off(generator), 0 };
      const bool free = std::all_of(holes.begin(), holes.end(), [&](const auto& hole) {
        return std::hypot(p[0] - hole[0], p[1] - hole[1]) > radius + 0.6;
      });
      if (free)
      {
        scene.Add(p, up, {});
        ofRing.push_back(false);
      }
    }
  }
  const Estimated splats(scene);
  int missed = 0, wrong = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    const double* p = scene.Points->GetPoint(id);
    const double inside = std::min({ p[0] - place(0), place(size - 1) - p[0], p[1], size - 1 - p[1] });
    const bool apart = inside > 3 && std::all_of(holes.begin(), holes.end(), [&](const auto& hole) {
      return std::hypot(p[0] - hole[0], p[1] - hole[1]) > radius + 3;
    });
    missed += ofRing[id] && CountLines(splats, id) == 0;
    wrong += apart && CountLines(splats, id) > 0;
  }
  Expect(missed == 0, name + ": " + std::to_string(missed) + " points at holes without a line");
  Expect(wrong == 0, name + ": " + std::to_string(wrong) + " points without a hole with a line");
}

/// Even points all around.
void OfClosedSurfaces()
{
  for (const double radius : { 1.0, 2.0, 20.0 })
  {
    // A tube with round ends.
    ScatteredFaces scene;
    const double length = 60;
    const int rings = static_cast<int>((length + vtkMath::Pi() * radius));
    for (int ring = 0; ring <= rings; ++ring)
    {
      const double s = ring * (length + vtkMath::Pi() * radius) / rings;
      const double cap = std::max(0.5 * vtkMath::Pi() - s / radius, 0.0) -
        std::max((s - length) / radius - 0.5 * vtkMath::Pi(), 0.0);
      const double z =
        radius * std::sin(cap) + std::clamp(s - 0.5 * vtkMath::Pi() * radius, 0.0, length) * -1;
      const double around = radius * std::cos(cap);
      const int count = std::max(static_cast<int>(2 * vtkMath::Pi() * around), 1);
      for (int k = 0; k < count; ++k)
      {
        const double turn = 2 * vtkMath::Pi() * (k + 0.5 * (ring % 2)) / count;
        const double n[3] = { std::cos(cap) * std::cos(turn), std::cos(cap) * std::sin(turn),
          std::sin(cap) };
        const double x[3] = { around * std::cos(turn), around * std::sin(turn), z };
        scene.Add(x, n, {});
      }
    }
    HasNone(scene, "tube of radius " + std::to_string(radius));
  }
}

/// Random points end somewhere before their surface does: there lines are, and nowhere else.
void OfRandomSheets(double gap)
{
  ScatteredFaces sheets;
  sheets.AddSheets(gap);
  const Estimated splats(sheets);
  int outermost = 0, missed = 0, wrong = 0;
  for (vtkIdType id = 0; id < sheets.GetNumberOfPoints(); ++id)
  {
    double c[3];
    const double length = splats.GetLine(id, 0, c);
    wrong += length > 0 && !sheets.IsAtBorder(id, c, length);
    const std::vector<ScatteredFaces::Edge>& borders = sheets.BordersOf[id];
    int near = 0;
    for (const ScatteredFaces::Edge& border : borders)
    {
      near += border.Distance < 3 * sheets.Spacing;
    }
    // But not at corners, where borders do not agree.
    const bool counts = near == 1 &&
      std::any_of(borders.begin(), borders.end(), [](const ScatteredFaces::Edge& border) {
        return border.Distance < 0.3;
      });
    outermost += counts;
    missed += counts && length == 0;
  }
  const std::string what = "random sheets " + std::to_string(gap) + " apart";
  std::cout << what << ": " << outermost << " outermost points, " << missed << " without a line, "
            << wrong << " lines elsewhere\n";
  Expect(outermost > 60, what + ": outermost points");
  // Beside a sheet as near as its own points some are not seen to be at a border.
  Expect((gap > 2 ? 20 : 6) * missed <= outermost, what + ": outermost points without a line");
  // Where the last points leave a bay, it may end at the inmost of them.
  AtMost(wrong, 1, what + ": lines elsewhere");
}

/// A sheet without a hole, with points at random inside, of which some lie together, as many as around a node of a tetrahedral
/// grid: how far these are from one another says nothing of how far the border's points are.
void OfClumps()
{
  const std::string name = "clumps";
  std::mt19937 random(9);
  std::uniform_real_distribution<double> anywhere(-0.4, 0.4);
  ScatteredFaces scene;
  const double n[3] = { 0, 0, 1 };
  for (int j = 0; j <= Rows; ++j)
  {
    for (int i = 0; i <= Columns; ++i)
    {
      const double to = OutsideAll(i, j);
      const int count = to < 0 && (i + 2 * j) % 5 == 0 ? 7 : 1;
      const double middle[2] = { i + (to < 0 ? anywhere(random) : 0), j + (to < 0 ? anywhere(random) : 0) };
      for (int k = 0; k < count; ++k)
      {
        const double off = count > 1 ? 0.1 : 0;
        const double p[3] = { middle[0] + off * anywhere(random), middle[1] + off * anywhere(random), 0 };
        scene.Add(p, n, std::vector<ScatteredFaces::Edge>(to == 0 ? 1 : 0));
      }
    }
  }
  const Estimated splats(scene);
  int missed = 0, border = 0;
  double outside = 0, all = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    const double* p = scene.Points->GetPoint(id);
    const double x = p[0], y = p[1], radius = splats.GetRadius(id);
    border += scene.EdgesOf[id].empty() ? 0 : 1;
    missed += !scene.EdgesOf[id].empty() && CountLines(splats, id) == 0;
    double lines[2][3];
    splats.GetLine(id, 0, lines[0]);
    splats.GetLine(id, 1, lines[1]);
    for (int k = 0; k < 100; ++k)
    {
      const double angle = 2.4 * k, r = radius * std::sqrt((k + 0.5) / 100);
      const double d[3] = { r * std::cos(angle), r * std::sin(angle), 0 };
      const bool drawn = vtkMath::Dot(lines[0], d) <= 1 && vtkMath::Dot(lines[1], d) <= 1;
      all += radius * radius;
      outside += drawn && OutsideAll(x + d[0], y + d[1]) > 0.1 ? radius * radius : 0;
    }
  }
  std::cout << name << ": " << missed << " of " << border << " points of the border without a line, outside " << outside / all
            << "\n";
  AtMost(missed, 0.03 * border, name + ": points of the border without a line");
  AtMost(outside / all, 0.002, name + ": of the disks' area past the border");
}
}

int TestSplatBorders(int, char*[])
{
  OfClumps();
  OfFlatSheet();
  OfBentSheet();
  OfStretchedSheets();
  OfHoles(2.0, 1, 0.2, "small holes");
  OfHoles(2.5, 6, 0.005, "holes among uneven columns");
  OfUnevenColumns(10);
  OfUnevenColumns(16);
  OfClosedSurfaces();
  OfRandomSheets(20);
  OfRandomSheets(1);
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
