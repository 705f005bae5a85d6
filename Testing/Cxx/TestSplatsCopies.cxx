// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Corners of triangles that share their places but not their points, as readers of files with texture
// coordinates leave them: one splat is drawn for those that are the same, with the picture of points that are shared.
#include "MeshScene.h"
#include "PickedPoints.h"
#include "SplatTables.h"

#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPointShadowTexture.h"
#include "vtkTriangle.h"

#include <algorithm>

namespace
{
using namespace SplatScene;
using Mesh = vtkSmartPointer<vtkPolyData>;

/// A mesh's triangles, each with points of its own; and which points these were.
struct Soup
{
  Mesh Data;
  std::vector<vtkIdType> Of;

  Soup(vtkPolyData* mesh, bool triangles)
    : Data(MeshScene::MakeSoup(mesh))
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      this->Of.insert(this->Of.end(), ids->begin(), ids->end());
    }
    if (!triangles)
    {
      this->Data->SetPolys(nullptr);
    }
  }
  /// Gives corners their triangles' normals.
  void TakeNormalsOfFaces()
  {
    vtkPoints* points = this->Data->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i += 3)
    {
      double corners[3][3];
      double normal[3];
      for (vtkIdType k = 0; k < 3; ++k)
      {
        points->GetPoint(i + k, corners[k]);
      }
      vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        this->Data->GetPointData()->GetNormals()->SetTuple(i + k, normal);
      }
    }
  }
};

struct Scene
{
  vtkNew<vtkPointSplatMapper> Mapper;
  Window Win;
  vtkActor* Actor;

  explicit Scene(vtkPolyData* data)
  {
    this->Mapper->SetInputData(data);
    this->Actor = this->Win.Add(this->Mapper);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(40.0);
    this->Win.Renderer->ResetCameraClippingRange();
  }
  Picture Draw() { return this->Win.Draw(); }
  bool Tells(const std::string& text)
  {
    return std::string(this->Mapper->GetChoices()).find(text) != std::string::npos;
  }
};

/// By every method, opaque and translucent: as many splats as places, and the same picture.
void TestPictures(Checks& checks, bool triangles)
{
  const std::string what = triangles ? "triangles, " : "points, ";
  const Mesh mesh = MakeSphereMesh(80);
  const Mesh shared = triangles ? mesh : Cloud(mesh);
  const Soup soup(mesh, triangles);
  for (const Way& way : Ways)
  {
    for (const double opacity : { 1.0, 0.5 })
    {
      if (opacity < 1.0 && way.Method == vtkPointSplatMapper::DEFERRED)
      {
        continue;
      }
      Picture pictures[2];
      vtkIdType splats[2];
      for (const int k : { 0, 1 })
      {
        Scene scene(k == 0 ? shared : soup.Data);
        scene.Mapper->SetMethod(way.Method);
        scene.Mapper->SetProjection(way.Projection);
        scene.Actor->GetProperty()->SetOpacity(opacity);
        pictures[k] = scene.Draw();
        splats[k] = scene.Mapper->GetNumberOfSplats();
        checks.Expect(scene.Tells("by the splats of others") == (k == 1), what + "copies are told");
        checks.Expect(splats[k] + scene.Mapper->GetNumberOfCopies() ==
            (k == 0 ? shared : soup.Data)->GetNumberOfPoints(), what + "points are splats or copies");
        checks.AtMost(scene.Mapper->GetNumberOfSkippedPoints(), vtkIdType(0), what + "skipped");
      }
      const std::string name = what + way.Name + (opacity < 1.0 ? ", translucent" : "");
      checks.Expect(splats[0] == splats[1], name + ": as many splats as places, not " +
          std::to_string(splats[1]) + " for " + std::to_string(splats[0]));
      checks.AtLeast(Psnr(pictures[0], pictures[1]), 60.0, name + ": psnr to shared points");
    }
  }
}

/// Corners with their triangles' normals: one splat has the mean, to which several are blended where texture coordinates
/// keep them apart.
void TestNormals(Checks& checks)
{
  Soup soup(MakeSphereMesh(80), true);
  soup.TakeNormalsOfFaces();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Coordinates");
  for (vtkIdType i = 0; i < soup.Data->GetNumberOfPoints(); ++i)
  {
    coordinates->InsertNextValue(static_cast<float>(i));
  }
  vtkNew<vtkPolyData> apart;
  apart->ShallowCopy(soup.Data);
  apart->GetPointData()->SetTCoords(coordinates);
  for (const bool triangles : { true, false })
  {
    if (!triangles)
    {
      soup.Data->SetPolys(nullptr);
      apart->SetPolys(nullptr);
    }
    const std::string what = triangles ? "triangles' normals" : "triangles' normals, points alone";
    Scene scenes[2] = { Scene(soup.Data), Scene(apart) };
    checks.AtLeast(Psnr(scenes[0].Draw(), scenes[1].Draw()), 45.0, what + ": psnr to splats apart");
    checks.AtMost(scenes[0].Mapper->GetNumberOfSplats(), scenes[1].Mapper->GetNumberOfSplats() / 4,
      what + ": splats");
    // Copies that are told apart later have splats of their own.
    scenes[0].Mapper->SetInputData(apart);
    scenes[0].Draw();
    checks.AtMost(scenes[0].Mapper->GetNumberOfCopies(), vtkIdType(0), what + ": with coordinates");
  }
}

/// A splat has the mean of what its points have, before and after values are mapped.
void TestColours(Checks& checks)
{
  const Mesh mesh = MakeSphereMesh(40);
  const Mesh shared = Cloud(mesh);
  const Soup soup(mesh, false);
  vtkNew<vtkFloatArray> values;
  vtkNew<vtkFloatArray> means;
  means->SetNumberOfTuples(mesh->GetNumberOfPoints());
  means->FillValue(0.0f);
  std::vector<int> counts(static_cast<size_t>(mesh->GetNumberOfPoints()));
  for (size_t i = 0; i < soup.Of.size(); ++i)
  {
    // Of its face.
    const float value = static_cast<float>((i / 3 * 37) % 11) / 10.0f;
    values->InsertNextValue(value);
    means->SetValue(soup.Of[i], means->GetValue(soup.Of[i]) + value);
    ++counts[static_cast<size_t>(soup.Of[i])];
  }
  for (vtkIdType i = 0; i < means->GetNumberOfTuples(); ++i)
  {
    means->SetValue(i, means->GetValue(i) / static_cast<float>(std::max(counts[static_cast<size_t>(i)], 1)));
  }
  shared->GetPointData()->SetScalars(means);
  Scene scenes[2] = { Scene(shared), Scene(soup.Data) };
  Picture before = scenes[1].Draw();
  soup.Data->GetPointData()->SetScalars(values); // splats stay
  for (const bool interpolate : { true, false })
  {
    for (Scene& scene : scenes)
    {
      scene.Mapper->SetInterpolateScalarsBeforeMapping(interpolate);
      scene.Mapper->SetScalarRange(0.0, 1.0);
      // Grey, so that a mean of colours is that of the mean value.
      vtkNew<vtkLookupTable> grey;
      grey->SetHueRange(0.0, 0.0);
      grey->SetSaturationRange(0.0, 0.0);
      grey->SetValueRange(0.0, 1.0);
      grey->SetRampToLinear();
      scene.Mapper->SetLookupTable(grey);
    }
    const Picture after = scenes[1].Draw();
    checks.AtLeast(Psnr(scenes[0].Draw(), after), 45.0,
      interpolate ? "values: psnr to means" : "colours: psnr to means");
    checks.AtMost(Psnr(before, after), 30.0, "colours are seen");
  }
}

/// Copies that move together are moved along; once they part, all are drawn.
void TestMotion(Checks& checks, bool ofFaces)
{
  Soup soup(MakeSphereMesh(80), false);
  if (ofFaces)
  {
    soup.TakeNormalsOfFaces();
  }
  Scene scene(soup.Data);
  scene.Draw();
  const vtkIdType splats = scene.Mapper->GetNumberOfSplats();
  vtkPoints* points = soup.Data->GetPoints();
  const auto move = [&](bool apart) {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      p[2] = 1.1 * p[2] + (apart ? 1e-3 * static_cast<double>(i % 3) : 0.0);
      points->SetPoint(i, p);
    }
    points->Modified();
    const Picture moved = scene.Draw();
    Scene fresh(soup.Data);
    fresh.Win.Renderer->GetActiveCamera()->DeepCopy(scene.Win.Renderer->GetActiveCamera());
    return Psnr(moved, fresh.Draw());
  };
  checks.AtLeast(move(false), 40.0, "moved together: psnr to new splats");
  checks.Expect(scene.Tells("sizes of an earlier frame"), "splats are moved along");
  checks.Expect(scene.Mapper->GetNumberOfSplats() == splats, "as many as before");
  checks.AtLeast(move(true), 40.0, "moved apart: psnr to new splats");
  checks.AtLeast(scene.Mapper->GetNumberOfSplats(), points->GetNumberOfPoints() / 2,
    "splats of points that part");
}

/// Triangles that are magnified have other points' splats as corners.
void TestTriangles(Checks& checks)
{
  const Mesh mesh = MakeSphereMesh(40);
  const Soup soup(mesh, true);
  Picture pictures[2];
  vtkIdType triangles[2];
  for (const int k : { 0, 1 })
  {
    Scene scene(k == 0 ? mesh : soup.Data);
    scene.Mapper->SetHybridToAutomatic();
    scene.Win.Renderer->GetActiveCamera()->Zoom(3.0);
    pictures[k] = scene.Draw();
    triangles[k] = scene.Mapper->GetNumberOfTrianglesProjected();
  }
  checks.AtLeast(triangles[1], vtkIdType(100), "triangles of a soup");
  checks.Expect(triangles[0] == triangles[1], "as many triangles as with shared points");
  checks.AtLeast(Psnr(pictures[0], pictures[1]), 60.0, "hybrid: psnr to shared points");
}

void TestShadows(Checks& checks)
{
  const Mesh mesh = MakeSphereMesh(40);
  const Soup soup(mesh, false);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, 2.0, 4.0);
  vtkNew<vtkPointShadowTexture> texture;
  texture->SetInputData(soup.Data);
  texture->AddLight(light);
  texture->Update();
  vtkDataArray* factors = texture->GetOutput()->GetPointData()->GetArray("ShadowFactor");
  std::vector<double> seen(static_cast<size_t>(mesh->GetNumberOfPoints()), -1.0);
  int different = 0;
  int dark = 0;
  for (size_t i = 0; i < soup.Of.size(); ++i)
  {
    const double factor = factors->GetComponent(static_cast<vtkIdType>(i), 0);
    double& own = seen[static_cast<size_t>(soup.Of[i])];
    different += own >= 0.0 && own != factor;
    own = factor;
    dark += factor < 0.5;
  }
  checks.AtMost(different, 0, "copies whose shadow is another");
  checks.AtLeast(dark, static_cast<int>(soup.Of.size() / 4), "copies in the dark");
}

/// What is picked is a point at its place; what differs is drawn as it is.
void TestOthers(Checks& checks)
{
  const Mesh mesh = MakeSphereMesh(80);
  const Soup soup(mesh, false);
  double farthest[2];
  for (const int k : { 0, 1 })
  {
    const Mesh data = k == 0 ? Cloud(mesh) : soup.Data;
    Scene scene(data);
    scene.Draw();
    int picked = 0;
    farthest[k] = FarthestPicked(scene.Win, data, picked);
    checks.AtLeast(picked, 10000, "points picked");
  }
  checks.AtMost(farthest[1], farthest[0] + 1e-3, "pixels from points picked");

  // Two of a place with another size, one of which has copies.
  vtkNew<vtkPolyData> few;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  for (const float radius : { 0.1f, 0.2f, 0.1f, 0.1f })
  {
    points->InsertNextPoint(1.0, 2.0, 3.0);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    radii->InsertNextValue(radius);
  }
  // And as many of all directions as are at no place of a surface.
  for (int i = 0; i < 20000; ++i)
  {
    points->InsertNextPoint(1.5, 2.0, 3.0);
    normals->InsertNextTuple3(std::cos(0.001 * i), 0.0, std::sin(0.001 * i));
    radii->InsertNextValue(0.1f);
  }
  few->SetPoints(points);
  few->GetPointData()->SetNormals(normals);
  few->GetPointData()->AddArray(radii);
  Scene one(few);
  one.Draw();
  checks.Expect(one.Mapper->GetNumberOfSplats() == 2 + 20000, "splats that differ are drawn, and no copies");
}
}

int TestSplatsCopies(int, char*[])
{
  Checks checks;
  TestPictures(checks, false);
  TestPictures(checks, true);
  TestNormals(checks);
  TestColours(checks);
  TestMotion(checks, false);
  TestMotion(checks, true);
  TestTriangles(checks);
  TestShadows(checks);
  TestOthers(checks);
  return checks.Result();
}
