// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Coarse meshes that are hybrids cast the shadows of their triangles, as the same meshes do by VTK's
// mapper, and of points that belong to no triangle.
#include "SplatScene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataSetAttributes.h"
#include "vtkLight.h"
#include "vtkPointSplatEstimation.h"

namespace
{
using namespace SplatScene;
using Mesh = vtkSmartPointer<vtkPolyData>;

enum class Caster
{
  None,
  Stock,
  Splats,
  Hybrid
};

/// A beam of six faces: its corners are its only points.
Mesh Beam()
{
  vtkNew<vtkCubeSource> source;
  source->SetXLength(2.4);
  source->SetYLength(0.3);
  source->SetZLength(0.3);
  source->SetCenter(0.0, 0.0, 1.0);
  source->Update();
  Mesh mesh = source->GetOutput();
  mesh->GetPointData()->SetTCoords(nullptr);
  return mesh;
}

/// Balls beside the beam, as points of no cell.
Mesh Balls()
{
  const Mesh balls = RandomSphere(4000);
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < balls->GetNumberOfPoints(); ++i)
  {
    double p[3];
    balls->GetPoint(i, p);
    points->InsertNextPoint(0.8 * p[0], 0.8 * p[1] + 1.2, 0.8 * p[2] + 1.0);
  }
  balls->SetPoints(points);
  return balls;
}

/// One input of both: the beam's faces, and the balls' points as vertices.
Mesh Together(vtkPolyData* beam, vtkPolyData* balls)
{
  Mesh both = Mesh::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> vertices;
  for (vtkPolyData* part : { beam, balls })
  {
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const vtkIdType id = points->InsertNextPoint(part->GetPoint(i));
      normals->InsertNextTuple(part->GetPointData()->GetNormals()->GetTuple(i));
      if (part == balls)
      {
        vertices->InsertNextCell(1, &id);
      }
    }
  }
  both->SetPoints(points);
  both->GetPointData()->SetNormals(normals);
  both->SetVerts(vertices);
  both->SetPolys(beam->GetPolys());
  return both;
}

/// A floor of splats under what casts, in the light of one lamp above, aside.
struct Scene
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Floor;
  std::vector<vtkSmartPointer<vtkPolyDataMapper>> Mappers;
  Scene()
  {
    this->Floor->SetInputData(RandomSquare(60000));
    this->Floor->ShadowsOn();
    this->Win.Add(this->Floor);
    vtkRenderer* renderer = this->Win.Renderer;
    renderer->RemoveAllLights();
    renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> light;
    light->SetPosition(1.0, -1.5, 6.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->PositionalOn();
    light->SetConeAngle(90.0);
    renderer->AddLight(light);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.0, -6.0, 7.0);
    camera->SetFocalPoint(0.0, 0.0, 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  void Add(vtkPolyData* data, Caster caster)
  {
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    if (caster == Caster::Stock)
    {
      mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    }
    else
    {
      auto splats = vtkSmartPointer<vtkPointSplatMapper>::New();
      splats->SetHybrid(caster == Caster::Hybrid ? vtkPointSplatMapper::AUTOMATIC_HYBRID
                                                 : vtkPointSplatMapper::HYBRID_OFF);
      mapper = splats;
    }
    mapper->SetInputData(data);
    this->Win.Add(mapper);
    this->Mappers.push_back(mapper);
  }
  Picture Draw()
  {
    this->Win.Renderer->ResetCameraClippingRange();
    return this->Win.Draw();
  }
};

Picture Draw(vtkPolyData* data, Caster caster)
{
  Scene scene;
  if (caster != Caster::None)
  {
    scene.Add(data, caster);
  }
  return scene.Draw();
}

void TestBeam(Checks& checks)
{
  const Mesh beam = Beam();
  const Picture none = Draw(beam, Caster::None);
  const Picture stock = Draw(beam, Caster::Stock);
  checks.AtMost(PsnrOfAll(none, stock), 25.0, "beam: psnr of no beam");
  checks.AtLeast(PsnrOfAll(stock, Draw(beam, Caster::Hybrid)), 50.0, "beam: psnr against mesh");
}

/// By quads a frame has no triangles, but shadows have: of the shadow alone, the beam being out of view.
void TestQuads(Checks& checks)
{
  std::vector<Picture> pictures;
  for (const Caster caster : { Caster::None, Caster::Stock, Caster::Hybrid })
  {
    Scene scene;
    scene.Floor->SetProjectionToQuads();
    if (caster != Caster::None)
    {
      scene.Add(Beam(), caster);
    }
    vtkCamera* camera = scene.Win.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -6.0, 1.5);
    camera->SetFocalPoint(0.0, 0.3, 0.0);
    camera->SetViewAngle(10.0);
    pictures.push_back(scene.Draw());
  }
  checks.AtMost(PsnrOfAll(pictures[0], pictures[1]), 25.0, "quads: psnr of no beam");
  checks.AtLeast(PsnrOfAll(pictures[1], pictures[2]), 50.0, "quads: psnr against mesh");
}

void TestLoose(Checks& checks)
{
  const Mesh beam = Beam();
  const Mesh balls = Balls();
  Scene apart;
  apart.Add(beam, Caster::Stock);
  apart.Add(balls, Caster::Splats);
  const Picture expected = apart.Draw();
  checks.AtMost(
    PsnrOfAll(expected, Draw(beam, Caster::Stock)), 25.0, "beam and ball: psnr of beam alone");
  // Shadow maps of one actor and of two have their pixels elsewhere, which shows at edges.
  checks.AtLeast(PsnrOfAll(expected, Draw(Together(beam, balls), Caster::Hybrid)), 30.0,
    "beam and ball: psnr against two actors");
}

/// Faces that are taken away, and corners that move, take their shadows with them.
void TestChanges(Checks& checks)
{
  const Mesh beam = Beam();
  Scene scene;
  scene.Add(beam, Caster::Hybrid);
  scene.Draw();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < beam->GetNumberOfPoints(); ++i)
  {
    double p[3];
    beam->GetPoint(i, p);
    points->InsertNextPoint(p[0], p[1] + 0.7, p[2]);
  }
  beam->SetPoints(points);
  checks.AtLeast(PsnrOfAll(Draw(beam, Caster::Stock), scene.Draw()), 50.0, "moved: psnr");

  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < beam->GetNumberOfCells(); ++i)
  {
    ghosts->InsertNextValue(vtkDataSetAttributes::HIDDENCELL);
  }
  beam->GetCellData()->AddArray(ghosts);
  beam->Modified();
  checks.AtLeast(
    PsnrOfAll(Draw(beam, Caster::None), scene.Draw()), 50.0, "blanked: psnr against no beam");
}
}

int TestSplatsHybridShadows(int, char*[])
{
  Checks checks;
  TestBeam(checks);
  TestQuads(checks);
  TestLoose(checks);
  TestChanges(checks);
  return checks.Result();
}
