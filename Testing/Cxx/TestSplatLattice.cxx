// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation knows the vertices of a volume's isosurface by their lattice: it estimates of them what it
// does of the mesh, and takes nothing else for such.
#include "Expect.h"
#include "Gathered.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
using Field = std::function<double(const double[3])>;

struct Volume
{
  int Size = 40;
  double Spacing[3] = { 1, 1, 1 };
  double Origin[3] = { 0, 0, 0 };
  double Noise = 0; // deviation
  bool Bytes = false; // rounded to whole numbers
};

/// A field over voxels.
vtkSmartPointer<vtkImageData> MakeVolume(const Volume& volume, const Field& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(volume.Size, volume.Size, volume.Size);
  image->SetSpacing(volume.Spacing);
  image->SetOrigin(volume.Origin);
  vtkNew<vtkFloatArray> values;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (int k = 0; k < volume.Size; ++k)
  {
    for (int j = 0; j < volume.Size; ++j)
    {
      for (int i = 0; i < volume.Size; ++i)
      {
        const double p[3] = { double(i), double(j), double(k) };
        const double value = field(p) + volume.Noise * noise(random);
        values->InsertNextValue(static_cast<float>(volume.Bytes ? std::round(value) : value));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkPolyData> Contour(vtkImageData* image, std::initializer_list<double> values)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->ComputeScalarsOff();
  int count = 0;
  for (const double value : values)
  {
    contour->SetValue(count++, value);
  }
  contour->Update();
  return contour->GetOutput();
}

/// The points alone, and with one more, so far away that no lattice spans all.
vtkSmartPointer<vtkPolyData> MakeCloud(vtkPolyData* mesh, bool more = false)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    points->InsertNextPoint(mesh->GetPoint(id));
    normals->InsertNextTuple(mesh->GetPointData()->GetNormals()->GetTuple(id));
  }
  if (more)
  {
    double x[3];
    mesh->GetPoint(0, x);
    points->InsertNextPoint(x[0] + 2e6, x[1] + 3e6, x[2] + 4e6);
    normals->InsertNextTuple(mesh->GetPointData()->GetNormals()->GetTuple(0));
  }
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  return cloud;
}

vtkSmartPointer<vtkPolyData> Estimate(vtkPolyData* data, bool fill = false)
{
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(data);
  estimation->SetFillGaps(fill);
  estimation->Update();
  return estimation->GetOutput();
}

const std::vector<const char*> Disks = { vtkPointSplatArrays::Radius, vtkPointSplatArrays::PlaneNormal };
const std::vector<const char*> Faces = { vtkPointSplatArrays::PlaneNormal, vtkPointSplatArrays::Clip };
const std::vector<const char*> All = { vtkPointSplatArrays::Radius, vtkPointSplatArrays::PlaneNormal,
  vtkPointSplatArrays::Clip };

/// The share of points that one estimation says of what the other does, of these arrays.
double GetLikeness(vtkPolyData* a, vtkPolyData* b, const std::vector<const char*>& names = All)
{
  const vtkIdType count = std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  vtkIdType like = 0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    bool same = true;
    for (const char* name : names)
    {
      vtkDataArray* values[2] = { a->GetPointData()->GetArray(name), b->GetPointData()->GetArray(name) };
      for (int c = 0; values[0] && values[1] && c < values[0]->GetNumberOfComponents(); ++c)
      {
        const double x = values[0]->GetComponent(id, c), y = values[1]->GetComponent(id, c);
        same = same && std::abs(x - y) <= 1e-4 * std::max(std::abs(x), 0.01);
      }
      same = same && !values[0] == !values[1];
    }
    like += same ? 1 : 0;
  }
  return static_cast<double>(like) / count;
}

double Gyroid(const double p[3])
{
  const double k = 2 * M_PI / 20;
  return std::sin(k * p[0]) * std::cos(k * p[1]) + std::sin(k * p[1]) * std::cos(k * p[2]) +
    std::sin(k * p[2]) * std::cos(k * p[0]);
}

double Ball(const double p[3])
{
  const double middle = 19.5;
  return 15 - std::hypot(p[0] - middle, std::hypot(p[1] - middle, p[2] - middle));
}

/// Its faces are as far from the next plane of the lattice as from one another's.
double Box(const double p[3])
{
  return std::min({ 12.3 - std::abs(p[0] - 19), 9.7 - std::abs(p[1] - 20), 7.2 - std::abs(p[2] - 18) });
}

/// A volume's surface turned about all axes, by the same angle, and moved, as those of oblique scans are.
vtkSmartPointer<vtkPolyData> Turn(vtkPolyData* data, double degrees = 24, double mirror = 1)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(30, -50, 10);
  transform->RotateZ(degrees);
  transform->RotateX(-degrees);
  transform->RotateY(degrees);
  transform->Scale(mirror, 1, 1);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  transform->TransformPoints(data->GetPoints(), points);
  transform->TransformNormals(data->GetPointData()->GetNormals(), normals);
  auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->ShallowCopy(data);
  turned->SetPoints(points);
  turned->GetPointData()->SetNormals(normals);
  return turned;
}

void IsKnown(
  vtkPolyData* mesh, double least, const std::string& what, const std::vector<const char*>& names = All)
{
  AtLeast(mesh->GetNumberOfPoints(), 1000, "points of " + what);
  AtLeast(GetLikeness(Estimate(MakeCloud(mesh)), Estimate(mesh), names), least, what);
}

void IsKnown(vtkImageData* image, double value, double least, const std::string& what,
  const std::vector<const char*>& names = All)
{
  IsKnown(Contour(image, { value }), least, what, names);
}

/// Labels inside of a ball: what the field is more than, of the others, and of a ball within.
double GetLabel(const double p[3])
{
  return Ball(p) < 0 ? 0 : Ball(p) > 9 ? 3 : Gyroid(p) > 0.1 ? 2 : 1;
}

/// Each label's surface; where two touch there are points of both.
vtkSmartPointer<vtkPolyData> ContourLabels(const Volume& volume)
{
  vtkNew<vtkAppendPolyData> all;
  for (int label = 1; label <= 3; ++label)
  {
    all->AddInputData(
      Contour(MakeVolume(volume, [&](const double p[3]) { return GetLabel(p) == label ? 1.0 : 0.0; }), { 0.5 }));
  }
  all->Update();
  return all->GetOutput();
}

/// What of a surface is on one side of a plane, with new points along that.
vtkSmartPointer<vtkPolyData> Clip(vtkPolyData* mesh, double x, double y, double z)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(20.3, 19.1, 20.5);
  plane->SetNormal(x, y, z);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(mesh);
  clip->SetClipFunction(plane);
  clip->Update();
  return clip->GetOutput();
}

/// The triangles of a surface all of whose corners stay, and these.
vtkSmartPointer<vtkPolyData> Keep(vtkPolyData* mesh, const std::function<bool(const double[3])>& stays)
{
  vtkNew<vtkPolyData> kept;
  kept->DeepCopy(mesh);
  kept->BuildLinks();
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    if (!stays(mesh->GetPoint(id)))
    {
      vtkIdType count;
      vtkIdType* cells;
      kept->GetPointCells(id, count, cells);
      std::for_each(cells, cells + count, [&](vtkIdType cell) { kept->DeleteCell(cell); });
    }
  }
  kept->RemoveDeletedCells();
  vtkNew<vtkCleanPolyData> clean; // of points without triangles
  clean->PointMergingOff();
  clean->SetInputData(kept);
  clean->Update();
  return clean->GetOutput();
}

/// Without a share of the vertices, at random.
vtkSmartPointer<vtkPolyData> Thin(vtkPolyData* mesh, double share)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(0, 1);
  return Keep(mesh, [&](const double*) { return draw(random) >= share; });
}

/// A surface's points, those alone too, but a sixth of those between two planes, where a mesh's triangles would span several voxels.
vtkSmartPointer<vtkPolyData> MakeSeam(vtkPolyData* mesh)
{
  Gathered gathered;
  int between = 0;
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    double x[3];
    mesh->GetPoint(id, x);
    if (std::abs(0.3 * x[0] - 0.5 * x[1] + 0.8 * x[2] - 12) > 1.5 || between++ % 6 == 0)
    {
      gathered.Add(x, mesh->GetPointData()->GetNormals()->GetTuple(id));
    }
  }
  return gathered.Cloud;
}

/// Whether planes face as they do by the triangles where normals are reversed in a place, as a volume's gradients are where its
/// surface bends within a voxel.
void FacesAsTriangles(vtkPolyData* mesh)
{
  const auto cloud = MakeCloud(mesh);
  vtkDataArray* normals = cloud->GetPointData()->GetNormals();
  int reversed = 0;
  for (vtkIdType id = 0; id < cloud->GetNumberOfPoints(); ++id)
  {
    double x[3], n[3];
    cloud->GetPoint(id, x);
    if (std::hypot(x[0] - 20, std::hypot(x[1] - 20, x[2] - 20)) < 6)
    {
      normals->GetTuple(id, n);
      normals->SetTuple3(id, -n[0], -n[1], -n[2]);
      ++reversed;
    }
  }
  AtLeast(reversed, 100, "reversed normals");
  const auto known = Estimate(mesh, true), found = Estimate(cloud, true); // without copies no disk is a face's
  int against = 0;
  for (vtkIdType id = 0; id < cloud->GetNumberOfPoints(); ++id)
  {
    double a[3], b[3];
    known->GetPointData()->GetArray(vtkPointSplatArrays::PlaneNormal)->GetTuple(id, a);
    found->GetPointData()->GetArray(vtkPointSplatArrays::PlaneNormal)->GetTuple(id, b);
    against += a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0 ? 1 : 0;
  }
  AtMost(against, 5, "planes that face the other way");
}

/// Whether a cloud is estimated as it is with one more point, by which nothing can be known of it.
void IsSearched(vtkPolyData* cloud, const std::string& what)
{
  AtLeast(GetLikeness(Estimate(cloud), Estimate(MakeCloud(cloud, true))), 0.98, what);
}

/// Points of a volume itself: those of two layers, or heights over them.
vtkSmartPointer<vtkPolyData> MakeGrid(bool heights)
{
  Gathered gathered;
  const double up[3] = { 0, 0, 1 };
  std::mt19937 random(3);
  std::uniform_int_distribution<int> steps(0, 30);
  for (int layer = 0; layer < (heights ? 1 : 2); ++layer)
  {
    for (int j = 0; j < 60; ++j)
    {
      for (int i = 0; i < 60; ++i)
      {
        const double x[3] = { i + 0.0, j + 0.0, heights ? 0.1 * steps(random) : layer };
        gathered.Add(x, up);
      }
    }
  }
  return gathered.Cloud;
}

/// The middles of the squares on a box's faces, which lie as a mask's isosurface does.
vtkSmartPointer<vtkPolyData> MakeBoxGrid()
{
  constexpr int size = 20;
  Gathered gathered;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    for (int i = 0; i < size * size; ++i)
    {
      double x[3], n[3] = { 0, 0, 0 };
      x[axis] = face % 2 ? size : 0;
      x[(axis + 1) % 3] = i % size + 0.5;
      x[(axis + 2) % 3] = i / size + 0.5;
      n[axis] = face % 2 ? 1 : -1;
      gathered.Add(x, n);
    }
  }
  return gathered.Cloud;
}
}

int TestSplatLattice(int, char*[])
{
  // Whose neighbours no distance and no normal tells. What is not known by its lattice is like no more than a tenth.
  Volume noisy;
  noisy.Noise = 0.4;
  IsKnown(MakeVolume(noisy, Gyroid), 0, 0.999, "noise");
  FacesAsTriangles(Contour(MakeVolume(noisy, Gyroid), { 0.0 }));
  Volume oblong = noisy;
  const double spacing[3] = { 0.1, 0.37, 1.0 / 3 }, origin[3] = { -3.7, 100.01, 0.3 };
  std::copy_n(spacing, 3, oblong.Spacing);
  std::copy_n(origin, 3, oblong.Origin);
  IsKnown(MakeVolume(oblong, Gyroid), 0, 0.999, "noise in oblong voxels");

  // Coordinates off the planes occur often, too: by symmetry, by flat faces, of few values, by samples that are the isovalue.
  IsKnown(MakeVolume(Volume(), Ball), 0, 0.999, "a ball");
  // Along creases triangles of a mesh bound disks, but not those of voxels, through which the creases go: a third of the points.
  IsKnown(MakeVolume(Volume(), Box), 0, 0.98, "a box's edges", Faces);
  IsKnown(MakeVolume(Volume(), Box), 0, 0.55, "a box");
  Volume bytes;
  bytes.Bytes = true;
  IsKnown(MakeVolume(bytes, [](const double p[3]) { return 20 * Gyroid(p); }), 3.5, 0.999, "few values");
  IsKnown(MakeVolume(bytes, [](const double p[3]) { return 20 * Gyroid(p); }), 3, 0.999, "samples that are the isovalue");
  Volume noisyBytes = bytes;
  noisyBytes.Noise = 8;
  IsKnown(MakeVolume(noisyBytes, [](const double p[3]) { return 20 * Gyroid(p); }), 3, 0.97, "noise of few values");

  // All of whose points lie in the middle between samples: bodies that touch along edges, and what is a voxel thick. Where a
  // mesh has creases that are these steps no lattice's disks are bounded. Searched for, none of the points is like.
  const auto is = [](bool inside) { return inside ? 1.0 : 0.0; };
  IsKnown(MakeVolume(Volume(), [&](const double p[3]) { return is(Ball(p) > 0); }), 0.5, 0.75, "a mask", Disks);
  IsKnown(MakeVolume(Volume(), [&](const double p[3]) { return is(Box(p) > 0); }), 0.5, 0.45, "a box's mask", Disks);
  IsKnown(MakeVolume(Volume(), [&](const double p[3]) { return is(std::abs(Gyroid(p)) < 0.15); }), 0.5, 0.999, "a thin mask", Disks);
  Volume slices;
  slices.Spacing[2] = 4;
  IsKnown(MakeVolume(slices, [&](const double p[3]) { return is(std::abs(Gyroid(p)) < 0.4); }), 0.5, 0.98, "a mask in slices", Disks);
  Volume salt;
  salt.Noise = 0.3;
  salt.Bytes = true;
  IsKnown(MakeVolume(salt, [&](const double p[3]) { return is(Gyroid(p) > 0); }), 0.5, 0.93, "a mask with noise", Disks);

  // Labels that touch.
  const auto labels = ContourLabels(Volume());
  IsKnown(labels, 0.97, "labels", Disks);

  // A plate, most of whose points lie along one axis.
  Volume rough;
  rough.Noise = 0.2;
  IsKnown(MakeVolume(rough, [](const double p[3]) { return std::min({ 4 - std::abs(p[2] - 19), p[0] - 3, p[1] - 3 }); }), 0,
    0.999, "a plate");

  // A face between samples where nothing lies beyond it, as of volumes of few values.
  IsKnown(MakeVolume(Volume(), [](const double p[3]) { return std::min(Ball(p), 26 - p[2]); }), 0, 0.9, "a face at samples", Disks);

  // Several isosurfaces of one volume: edges have two points, or of a ball one, but voxels both surfaces.
  IsKnown(Contour(MakeVolume(Volume(), Gyroid), { -0.9, 0.0, 0.05, 0.8 }), 0.98, "four isosurfaces");
  IsKnown(Contour(MakeVolume(Volume(), Ball), { 5, 6.05 }), 0.999, "two balls");
  IsKnown(Contour(MakeVolume(noisy, Gyroid), { 0.0, 0.05 }), 0.99, "two isosurfaces with noise");
  IsKnown(Turn(Contour(MakeVolume(noisy, Gyroid), { 0.0, 0.05 })), 0.99, "two isosurfaces with noise, turned");
  IsKnown(Contour(MakeVolume(noisyBytes, [](const double p[3]) { return 20 * Gyroid(p); }), { 3, 5, 12 }), 0.98,
    "isosurfaces of few values");

  // Lattices that are not along the axes.
  const auto volume = MakeVolume(noisy, Gyroid);
  const auto mesh = Contour(volume, { 0.0 });
  IsKnown(Turn(mesh), 0.999, "noise, turned");
  IsKnown(Turn(mesh, 0.5), 0.999, "noise, turned a little");
  IsKnown(Turn(mesh, 160), 0.999, "noise, turned to the other side");
  // Marching cubes divide polygons of mirrored voxels by other diagonals: half of the triangles are others.
  IsKnown(Turn(mesh, 24, -1), 0.4, "noise, turned and mirrored");
  IsKnown(Turn(Contour(MakeVolume(oblong, Gyroid), { 0.0 })), 0.999, "noise in oblong voxels, turned");
  IsKnown(Turn(Contour(MakeVolume(Volume(), Box), { 0.0 })), 0.98, "a box's edges, turned", Faces);
  const auto mask = Contour(MakeVolume(Volume(), [&](const double p[3]) { return is(Ball(p) > 0); }), { 0.5 });
  IsKnown(Turn(mask), 0.75, "a mask, turned", Disks);
  const auto boxMask = Contour(MakeVolume(Volume(), [&](const double p[3]) { return is(Box(p) > 0); }), { 0.5 });
  IsKnown(Turn(boxMask), 0.45, "a box's mask, turned", Disks);
  IsKnown(Turn(labels), 0.97, "labels, turned", Disks);

  // Isosurfaces that were clipped, whose cuts' points lie on no edge: up to a fifth of the points are on or beside one.
  IsKnown(Clip(mesh, 0, 0, 1), 0.9, "noise, clipped half way between planes");
  IsKnown(Clip(mesh, 0.3, -0.5, 0.8), 0.87, "noise, clipped");
  IsKnown(Turn(Clip(mesh, 0.3, -0.5, 0.8)), 0.87, "noise, clipped and turned");
  IsKnown(Clip(Clip(mesh, 0.3, -0.5, 0.8), -0.8, 0.1, 0.5), 0.79, "noise, clipped twice");
  IsKnown(Clip(mask, 0.3, -0.5, 0.8), 0.5, "a mask, clipped", Disks);

  // Isosurfaces of which points are missing.
  const auto cropped = Keep(mesh, [](const double p[3]) { return 0.3 * p[0] - 0.5 * p[1] + 0.8 * p[2] > 12; });
  IsKnown(cropped, 0.9, "noise, cropped");
  IsKnown(Turn(cropped), 0.9, "noise, cropped and turned");
  IsKnown(Thin(mesh, 0.01), 0.8, "noise, without one in a hundred points");
  const auto thinned = Thin(mesh, 0.1);
  AtMost(GetLikeness(Estimate(MakeCloud(thinned)), Estimate(thinned)), 0.5, "noise, without a tenth of the points");
  AtMost(GetLikeness(Estimate(MakeCloud(Turn(thinned))), Estimate(Turn(thinned))), 0.5,
    "noise, without a tenth of the points, turned");

  // What is not of one isosurface is none.
  IsSearched(MakeSeam(Contour(MakeVolume(Volume(), Gyroid), { 0.0 })), "a seam");
  IsSearched(MakeGrid(false), "samples");
  IsSearched(MakeGrid(true), "heights in steps");
  IsSearched(MakeBoxGrid(), "a box's squares");
  IsSearched(Turn(MakeGrid(false)), "samples, turned");
  IsSearched(Turn(MakeGrid(true)), "heights in steps, turned");
  IsSearched(Turn(MakeBoxGrid()), "a box's squares, turned");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
