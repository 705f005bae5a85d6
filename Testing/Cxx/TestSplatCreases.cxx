// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation finds creases where there are some and none elsewhere, and clips
// splats at them. Where the edges are is known in closed form.
#include "Expect.h"
#include "Gathered.h"
#include "ScatteredFaces.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <random>

namespace
{
/// How well lines are those of the scene's edges.
struct Judged
{
  int Lines = 0;   // found
  int Wrong = 0;   // of these, off every edge by more than a tenth of the spacing or 6 degrees
  int Needed = 0;  // edges that a point's disk reaches over
  int Missed = 0;  // of these, without a line
  int Clipped = 0; // points that have lines
  int AtBorder = 0; // lines where the surface ends, which are not counted above
};

/// Holds each line against the edges of its point: all of them meet what the line would.
Judged Judge(const ScatteredFaces& scene, const Estimated& splats)
{
  Judged judged;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    const std::vector<ScatteredFaces::Edge>& edges = scene.EdgesOf[id];
    std::vector<bool> found(edges.size(), false);
    const int before = judged.Lines;
    for (int k = 0; k < 2; ++k)
    {
      double c[3];
      const double length = splats.GetLine(id, k, c);
      if (length == 0)
      {
        continue;
      }
      if (scene.IsAtBorder(id, c, length))
      {
        ++judged.AtBorder;
        continue;
      }
      ++judged.Lines;
      bool right = false;
      for (std::size_t e = 0; e < edges.size(); ++e)
      {
        const bool same = std::abs(1 / length - edges[e].Distance) < 0.1 * scene.Spacing &&
          vtkMath::Dot(c, edges[e].Direction) > 0.995 * length;
        found[e] = found[e] || same;
        right = right || same;
      }
      judged.Wrong += !right;
    }
    judged.Clipped += judged.Lines > before;
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      if (edges[e].Distance < splats.GetRadius(id))
      {
        ++judged.Needed;
        judged.Missed += !found[e];
      }
    }
  }
  return judged;
}

/// Lines at the edges and none elsewhere.
void ExpectLines(const ScatteredFaces& scene, const std::string& what, double mostMissed)
{
  const Estimated splats(scene);
  const Judged judged = Judge(scene, splats);
  std::cout << what << ": " << judged.Lines << " lines, wrong " << judged.Wrong << ", needed "
            << judged.Needed << ", missed " << judged.Missed << "\n";
  Expect(judged.Needed > 50, what + " has edges");
  AtMost(judged.Wrong, 0, what + ", lines off the edges");
  AtMost(judged.Missed, mostMissed * judged.Needed, what + ", edges without a line");
}

/// No more than a share of the points have lines, and without any there is no array.
void ExpectSmooth(const ScatteredFaces& scene, const std::string& what, double mostLines)
{
  const Estimated splats(scene);
  const Judged judged = Judge(scene, splats);
  const double rate = double(judged.Clipped) / scene.GetNumberOfPoints();
  std::cout << what << ": " << judged.Clipped << " of " << scene.GetNumberOfPoints()
            << " points with lines\n";
  AtMost(rate, mostLines, what + ", points with lines");
  Expect(judged.Lines + judged.AtBorder > 0 || !splats.HasLines(), what + ": an array without lines");
}

void Cube()
{
  ScatteredFaces cube;
  cube.AddCube(5000);
  ExpectLines(cube, "cube", 0);
  // Two lines at corners.
  const Estimated splats(cube);
  int corners = 0, both = 0;
  for (vtkIdType id = 0; id < cube.GetNumberOfPoints(); ++id)
  {
    int near = 0;
    for (const ScatteredFaces::Edge& edge : cube.EdgesOf[id])
    {
      near += edge.Distance < cube.Spacing;
    }
    double c[3];
    corners += near > 1;
    both += near > 1 && splats.GetLine(id, 0, c) > 0 && splats.GetLine(id, 1, c) > 0;
  }
  Expect(corners > 10, "the cube has points at corners");
  AtMost(corners - both, 0.1 * corners, "points at corners without two lines");
}

void Prisms()
{
  for (int angle = 30; angle <= 150; angle += 30)
  {
    for (const bool convex : { true, false })
    {
      ScatteredFaces prism;
      prism.AddFold(angle, convex, 0.0);
      ExpectLines(prism,
        (convex ? "convex edge of " : "concave edge of ") + std::to_string(angle) + " degrees",
        0.02);
    }
  }
}

/// On a sharp edge a point of one face that has few neighbours there looks as one with an average of the faces' normals
/// does; nothing goes on behind it as if that were one.
void SharpEdge()
{
  int folds = 0;
  for (int k = 0; k < 4; ++k)
  {
    ScatteredFaces edge;
    edge.AddFold(115 + 5 * k, true, 0.0, 0.05);
    const Estimated splats(edge);
    for (vtkIdType id = 0; id < edge.GetNumberOfPoints(); ++id)
    {
      double fold[3];
      folds += splats.GetFold(id, 0, fold) > 0 || splats.GetFold(id, 1, fold) > 0;
    }
  }
  AtMost(folds, 0, "splats that go on behind a sharp edge");
}

/// Normals that shade the faces of a cube as if it were round lean over by up to 16 degrees: disks lie on its faces.
void LeaningNormals()
{
  ScatteredFaces cube;
  cube.AddCube(20000);
  std::vector<double> lean;
  for (vtkIdType id = 0; id < cube.GetNumberOfPoints(); ++id)
  {
    double x[3], n[3];
    cube.Points->GetPoint(id, x);
    cube.Normals->GetTuple(id, n);
    double m[3];
    for (int c = 0; c < 3; ++c)
    {
      m[c] = n[c] != 0 ? n[c] : 0.4 * x[c];
    }
    vtkMath::Normalize(m);
    cube.Normals->SetTuple(id, m);
    lean.push_back(vtkMath::Dot(m, n));
  }
  const Estimated splats(cube);
  int leaning = 0, off = 0;
  for (vtkIdType id = 0; id < cube.GetNumberOfPoints(); ++id)
  {
    const bool inside = std::all_of(cube.EdgesOf[id].begin(), cube.EdgesOf[id].end(),
      [&](const ScatteredFaces::Edge& edge) { return edge.Distance > 4 * cube.Spacing; });
    if (inside && lean[id] < 0.985)
    {
      // Across the face is what is across the directions to its edges.
      double across[3];
      vtkMath::Cross(cube.EdgesOf[id][0].Direction, cube.EdgesOf[id][2].Direction, across);
      ++leaning;
      off += splats.GetPlanePart(id, across) < 0.9999;
    }
  }
  std::cout << "normals that lean: " << leaning << ", disks off their face " << off << "\n";
  Expect(leaning > 2000, "normals lean");
  AtMost(off, 0.01 * leaning, "disks across normals that lean over");
}

/// The end of a cylinder of so many spacings' radius: a curved edge, and one curved face.
void Cylinder()
{
  ScatteredFaces cylinder;
  cylinder.AddCylinder(20);
  ExpectLines(cylinder, "cylinder", 0.03);
}

void Smooth()
{
  for (const double radius : { 2.5, 3.0, 5.0 })
  {
    for (const int angle : { 30, 90, 150 })
    {
      ScatteredFaces fillet;
      fillet.AddFold(angle, true, radius);
      ExpectSmooth(fillet,
        "fillet of " + std::to_string(radius) + " spacings at " + std::to_string(angle) +
          " degrees",
        0.01);
    }
  }
  for (const double radius : { 1.0, 1.5, 2.0, 4.0 })
  {
    ScatteredFaces tube;
    tube.AddTube(radius);
    ExpectSmooth(tube, "tube of " + std::to_string(radius) + " spacings", 0);
  }
  for (const double noise : { 0.0, 0.1, 0.3, 0.6 })
  {
    for (const double turn : { 0.0, 5.0, 10.0, 20.0 })
    {
      ScatteredFaces sphere;
      sphere.AddSphere(10000, noise, turn);
      ExpectSmooth(sphere,
        "sphere with noise of " + std::to_string(noise) + " spacings and " + std::to_string(turn) +
          " degrees",
        noise + turn > 0 ? 0.001 : 0);
    }
  }
  ScatteredFaces sheets;
  sheets.AddSheets(0.3);
  ExpectSmooth(sheets, "sheets", 0);
}

/// The vertices of a mesh: those on the edge have a normal between the faces', or are there twice.
void Vertices(bool split)
{
  const std::string what = split ? "split vertices" : "vertices";
  ScatteredFaces mesh;
  mesh.AddGridFold(split);
  const Estimated splats(mesh);
  int wrong = 0, missed = 0, folded = 0, edge = 0;
  for (vtkIdType id = 0; id < mesh.GetNumberOfPoints(); ++id)
  {
    if (mesh.EdgesOf[id].size() > 1)
    {
      continue; // at the border
    }
    const ScatteredFaces::Edge& truth = mesh.EdgesOf[id][0];
    double c[3], f[3];
    const double length = splats.GetLine(id, 0, c);
    const bool onEdge = truth.Distance == 0;
    if (length == 0)
    {
      missed += truth.Distance < 1.5 * mesh.Spacing;
      continue;
    }
    if (!onEdge && mesh.IsAtBorder(id, c, length))
    {
      continue; // its splat would reach over that
    }
    // What is on the edge may have its line to either side.
    wrong += std::abs(1 / length - truth.Distance) > 0.1 * mesh.Spacing ||
      (!onEdge && vtkMath::Dot(c, truth.Direction) < 0.995 * length);
    edge += onEdge;
    folded += splats.GetFold(id, 0, f) > 0;
    Expect(onEdge || splats.GetFold(id, 0, f) == 0, what + ": a fold beside the edge");
  }
  Expect(edge > 20, what + ": lines on the edge");
  Expect(folded == (split ? 0 : edge), what + ": each averaged normal is a fold's");
  AtMost(wrong, 0, what + ", lines off the edge");
  AtMost(missed, 0, what + ", points at the edge without a line");
}

/// Two faces at an angle, with points at random; those on their edge, which are there twice, lie together by sevens.
void SplitClumps(double degrees)
{
  const std::string what = "clumps on an edge of " + std::to_string(static_cast<int>(degrees)) + " degrees";
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const double ways[2][3] = { { 0, 1, 0 }, { 0, std::cos(angle), std::sin(angle) } }; // from the edge, along x
  const double normals[2][3] = { { 0, 0, -1 }, { 0, -std::sin(angle), std::cos(angle) } };
  ScatteredFaces scene;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> anywhere(0.01, 1);
  constexpr int length = 60, width = 20;
  for (const int face : { 0, 1 })
  {
    for (int k = 0; k < length * width; ++k)
    {
      const double across = width * anywhere(random), along = length * anywhere(random);
      const double p[3] = { along, across * ways[face][1], across * ways[face][2] };
      scene.Add(p, normals[face], {});
    }
    for (int k = 0; k < length; ++k)
    {
      const double p[3] = { k / 7 * 7 + 0.01 * (k % 7), 0, 0 };
      scene.Add(p, normals[face], std::vector<ScatteredFaces::Edge>(1));
    }
  }
  const Estimated splats(scene);
  int missed = 0, wrong = 0;
  for (vtkIdType id = 0; id < scene.GetNumberOfPoints(); ++id)
  {
    // At its ends lines are the border's, too.
    const double along = scene.Points->GetPoint(id)[0];
    if (scene.EdgesOf[id].empty() || along < 3 || along > length - 3)
    {
      continue;
    }
    double c[3], n[3];
    scene.Normals->GetTuple(id, n);
    const double l = splats.GetLine(id, 0, c);
    missed += l == 0;
    // From the face that lies on its own side of the edge.
    wrong += l > 0 && !(vtkMath::Dot(c, ways[n[1] == 0 ? 0 : 1]) < -0.99 * l);
  }
  AtMost(missed, 0, what + ", without a line");
  AtMost(wrong, 7, what + ", with the other face's line, as where all neighbours of one clump are on that");
}

/// Where three faces meet whose normals were averaged, the disk folds twice, and not into its own plane, also
/// where the faces lie aslant and their normals are rounded.
void AveragedCorners(double degrees)
{
  ScatteredFaces mesh;
  mesh.AddGridCube(21);
  mesh.Turn(degrees);
  const Estimated splats(mesh);
  int edge = 0, corner = 0, wrong = 0, flat = 0;
  for (vtkIdType id = 0; id < mesh.GetNumberOfPoints(); ++id)
  {
    const int expected = static_cast<int>(mesh.EdgesOf[id].size());
    int lines = 0, folds = 0;
    for (int k = 0; k < 2; ++k)
    {
      double v[3];
      lines += splats.GetLine(id, k, v) > 0;
      const bool is = splats.GetFold(id, k, v) > 0;
      folds += is;
      flat += is && splats.GetPlanePart(id, v) > 0.5;
    }
    edge += expected == 1;
    corner += expected == 2;
    // A line of the third face may reach the vertex beside a corner.
    wrong += lines < expected || folds != expected;
  }
  Expect(edge == 12 * 19 && corner == 8, "the mesh has edges and corners");
  AtMost(wrong, 0, "vertices at edges that do not fold once, and at corners twice");
  AtMost(flat, 0, "folds into the disk's own plane");
}

/// A cylinder whose rows along the lids' edges lie so many times as far apart as the points in them and on the lids: all
/// faces have points on the edges, with their own normals. Places: of 480 between the edge and the next row those that no disk covers.
void Lidded(double aspect, bool inward, int places)
{
  const int number = 120;
  const double pi = std::acos(-1.0), step = 2 * pi / number, side = inward ? -1 : 1;
  const int rows = 5;
  const double height = aspect * step * (rows - 1);
  Gathered gathered;
  for (int row = 0; row < rows; ++row)
  {
    for (int i = 0; i < number; ++i)
    {
      const double x[3] = { std::cos(i * step), std::sin(i * step), row * aspect * step };
      const double n[3] = { side * x[0], side * x[1], 0 };
      gathered.Add(x, n);
    }
  }
  for (const double z : { 0.0, height })
  {
    for (int ring = 0; ring * step < 1; ++ring)
    {
      const double radius = 1 - ring * step;
      const int count = static_cast<int>(std::round(2 * pi * radius / step));
      for (int i = 0; i < count; ++i)
      {
        const double angle = 2 * pi * i / count;
        const double x[3] = { radius * std::cos(angle), radius * std::sin(angle), z };
        const double n[3] = { 0, 0, z > 0 ? side : -side };
        gathered.Add(x, n);
      }
    }
  }
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(gathered.Cloud);
  estimation->Update();
  vtkPolyData* splats = estimation->GetOutput();
  vtkDataArray* normals = splats->GetPointData()->GetNormals();
  vtkDataArray* radii = splats->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  vtkDataArray* lines = splats->GetPointData()->GetArray(vtkPointSplatArrays::Clip);
  const std::string what =
    "rows " + std::to_string(aspect) + " spacings apart" + (inward ? ", inward" : "");
  Expect(lines != nullptr, what + ": no lines");
  int off = 0;
  for (int i = 0; lines && i < number; ++i)
  {
    for (const int row : { 0, rows - 1 })
    {
      double line[6];
      lines->GetTuple(row * number + i, line);
      const double length = vtkMath::Norm(line);
      const double along = (row == 0 ? -1 : 1) * line[2];
      // Nearer than a twentieth of the way to the next row.
      off += !(length * 0.05 * aspect * step > 1) || along < 0.99 * length || vtkMath::Norm(line + 3) > 0;
    }
  }
  AtMost(off, 0, what + ": disks on the edges that do not end there");

  // Between the edge and the next row places are in somebody's disk.
  int bare = 0;
  for (int i = 0; i < 4 * number; ++i)
  {
    const double angle = (i + 0.5) * step / 4;
    const double x[3] = { std::cos(angle), std::sin(angle), (i % 4 + 0.5) / 4 * aspect * step };
    bool covered = false;
    for (vtkIdType id = 0; id < splats->GetNumberOfPoints() && !covered; ++id)
    {
      double p[3], n[3];
      splats->GetPoint(id, p);
      normals->GetTuple(id, n);
      const double radius = radii->GetComponent(id, 0);
      covered = vtkMath::Distance2BetweenPoints(x, p) < radius * radius &&
        std::abs(n[0] * x[0] + n[1] * x[1]) > 0.8;
    }
    bare += !covered;
  }
  AtMost(bare, places, what + ": places between rows that no disk covers");
}

/// The edge of a block whose upper face has rows next to the edge that are much nearer to it than the front's are, as where a
/// mesh was divided until its triangles were good; normals are averaged at the edge. degrees: by which the front's normals
/// turn to and fro from column to column, as where facets stand for a bent face.
void DenseBeside(double next, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const double upper[3] = { 0, 0, 1 };
  const double fronts[2][3] = { { std::sin(angle), -std::cos(angle), 0 },
    { -std::sin(angle), -std::cos(angle), 0 } };
  const double edge[3] = { 0, -std::sqrt(0.5), std::sqrt(0.5) };
  const int columns = 60;
  Gathered gathered;
  auto addRow = [&](double y, double z, double step, const double n[3], const double m[3]) {
    for (int i = 0; i * step <= columns; ++i)
    {
      const double x[3] = { i * step, y, z };
      gathered.Add(x, i % 2 ? m : n);
    }
  };
  addRow(0, 0, 1, edge, edge);
  const vtkIdType edges = gathered.Cloud->GetNumberOfPoints();
  for (const double y : { 0.125, 0.3, 0.55 })
  {
    addRow(y, 0, 0.5, upper, upper);
  }
  const vtkIdType beside = gathered.Cloud->GetNumberOfPoints();
  for (int row = 1; row < 20; ++row)
  {
    addRow(row, 0, 1, upper, upper);
    addRow(0, -row * next, 1, fronts[0], fronts[1]);
  }
  const Estimated splats(gathered.Cloud);
  int open = 0;
  for (vtkIdType id = 0; id < beside; ++id)
  {
    double x[3];
    gathered.Cloud->GetPoint(id, x);
    if (x[0] < 5 || x[0] > columns - 5)
    {
      continue;
    }
    // Beyond the edge nothing is left of a splat of the upper face, and below it nothing of the front's.
    bool ends = false;
    for (int k = 0; k < 2; ++k)
    {
      double c[3];
      const double length = splats.GetLine(id, k, c);
      const double part = id < edges ? std::max(-c[1], c[2]) : -c[1];
      ends = ends || (length > 0 && part > 0.99 * length && std::abs(1 / length - x[1]) < 0.1);
    }
    open += !ends;
  }
  AtMost(open, 0, "front's rows " + std::to_string(next) + " spacings apart, turned by " +
      std::to_string(degrees) + " degrees: disks beside the edge that do not end there");
}

void Threads()
{
  ScatteredFaces cube;
  cube.AddCube(5000);
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const Estimated one(cube);
  vtkSMPTools::SetBackend("STDThread");
  const Estimated many(cube);
  vtkSMPTools::SetBackend(backend.c_str());
  bool same = true;
  for (vtkIdType id = 0; id < cube.GetNumberOfPoints(); ++id)
  {
    for (int k = 0; k < 2; ++k)
    {
      double a[3], b[3];
      one.GetLine(id, k, a);
      many.GetLine(id, k, b);
      same = same && std::equal(a, a + 3, b);
    }
    same = same && one.GetRadius(id) == many.GetRadius(id);
  }
  Expect(same, "lines do not depend on threads");
}

/// Duplicates have the same line; what is bad spoils none.
void BadInput()
{
  ScatteredFaces cube;
  cube.AddCube(5000);
  const vtkIdType count = cube.GetNumberOfPoints();
  for (vtkIdType id = 0; id < count; id += 3)
  {
    cube.Repeat(id);
  }
  const double nan = vtkMath::Nan();
  for (int k = 0; k < 20; ++k)
  {
    const double x[3] = { 0.5, 0.05 * k - 0.5, k % 2 ? nan : 0.5 };
    const double n[3] = { k % 3 ? nan : 0.0, 0.0, 0.0 };
    cube.Add(x, n, {});
  }
  const Estimated splats(cube);
  int different = 0, bad = 0;
  for (vtkIdType id = 0; id < cube.GetNumberOfPoints(); ++id)
  {
    for (int k = 0; k < 2; ++k)
    {
      double c[3], d[3];
      bad += !std::isfinite(splats.GetLine(id, k, c));
      if (id < count && id % 3 == 0)
      {
        splats.GetLine(count + id / 3, k, d);
        different += !std::equal(c, c + 3, d);
      }
    }
  }
  AtMost(different, 0, "duplicates with other lines");
  AtMost(bad, 0, "lines that are not finite");
  cube.EdgesOf.resize(count);
  int missed = 0, needed = 0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    double c[3];
    for (const ScatteredFaces::Edge& edge : cube.EdgesOf[id])
    {
      needed += edge.Distance < 0.5 * cube.Spacing;
      missed += edge.Distance < 0.5 * cube.Spacing && splats.GetLine(id, 0, c) == 0;
    }
  }
  AtMost(missed, 0.02 * needed, "edges without a line beside bad points");
}
}

int TestSplatCreases(int, char*[])
{
  Cube();
  Prisms();
  SharpEdge();
  LeaningNormals();
  Cylinder();
  Smooth();
  Vertices(false);
  Vertices(true);
  for (const double degrees : { 40.0, 75.0, 110.0, 140.0 })
  {
    SplitClumps(degrees);
  }
  AveragedCorners(0);
  AveragedCorners(17);
  for (const bool inward : { false, true })
  {
    Lidded(4, inward, 0);
    // 266, 360 and 240 where disks on the edge were as small as the row's own points are apart.
    Lidded(6, inward, 20);
    Lidded(8, inward, 200);
    Lidded(12, inward, 150);
  }
  for (const double degrees : { 0.0, 2.0 })
  {
    for (const double next : { 1.0, 1.7, 2.0, 2.5, 3.5 })
    {
      DenseBeside(next, degrees);
    }
  }
  Threads();
  BadInput();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
