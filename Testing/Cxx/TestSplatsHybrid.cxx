// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes drawn as triangles where these are magnified, and as splats elsewhere: the pictures are those
// of VTK's mesh, whatever the property, and where both meet no seam shows.
#include "SplatScene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
using namespace SplatScene;
using Change = std::function<void(vtkRenderer*, vtkActor*)>;
using Mesh = vtkSmartPointer<vtkPolyData>;

// dB against VTK's mesh, both without smooth outlines: edges of triangles fall on the same pixels but
// for those that touch a pixel's middle. All have 50 at least.
constexpr double LikeMesh = 49.0;
// Pixels of outlines.
constexpr int MostOfOutline = 4;

template <typename Source>
Mesh Make(Source* source)
{
  source->Update();
  return source->GetOutput();
}

Mesh Cube()
{
  return Make<vtkCubeSource>(vtkNew<vtkCubeSource>());
}

/// Its caps are polygons of many corners.
Mesh Cylinder()
{
  vtkNew<vtkCylinderSource> source;
  source->SetResolution(24);
  return Make<vtkCylinderSource>(source);
}

void SetHeights(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[2]));
  }
  mesh->GetPointData()->SetScalars(heights);
}

/// The sphere's triangles as strips: two rows of corners each.
Mesh Strips()
{
  const int across = 60;
  const int down = 30;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> strips;
  for (int j = 0; j <= down; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      const double a = 2.0 * M_PI * i / across;
      const double b = M_PI * (0.05 + 0.9 * j / down);
      const double n[3] = { std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b) };
      points->InsertNextPoint(0.5 * n[0], 0.5 * n[1], 0.5 * n[2]);
      normals->InsertNextTuple(n);
    }
  }
  for (int j = 0; j < down; ++j)
  {
    strips->InsertNextCell(2 * across + 2);
    for (int i = 0; i <= across; ++i)
    {
      strips->InsertCellPoint(j * across + i % across);
      strips->InsertCellPoint((j + 1) * across + i % across);
    }
  }
  Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->SetStrips(strips);
  return mesh;
}

struct Scene
{
  Window Win;
  vtkSmartPointer<vtkPolyDataMapper> Mapper;
  vtkActor* Actor = nullptr;

  /// hybrid: -1 for VTK's mapper. samples: along each side of a pixel.
  Scene(vtkPolyData* mesh, int hybrid, int samples = 1)
    : Win(samples * Size)
  {
    if (hybrid < 0)
    {
      this->Mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    }
    else
    {
      auto splats = vtkSmartPointer<vtkPointSplatMapper>::New();
      splats->SetHybrid(hybrid);
      this->Mapper = splats;
    }
    this->Mapper->SetInputData(mesh);
    this->Mapper->SetScalarRange(-0.5, 0.5);
    this->Actor = this->Win.Add(this->Mapper);
    this->Win.Renderer->SetUseDepthPeeling(true);
    this->Win.Renderer->SetMaximumNumberOfPeels(20);
    this->Win.Renderer->SetOcclusionRatio(0.0);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Azimuth(30.0);
    this->Win.Renderer->GetActiveCamera()->Elevation(30.0);
  }
  vtkPointSplatMapper* Splats() { return vtkPointSplatMapper::SafeDownCast(this->Mapper); }
  Picture Draw(const Change& change)
  {
    change(this->Win.Renderer, this->Actor);
    this->Win.Renderer->ResetCameraClippingRange();
    return this->Win.Draw();
  }
};

/// The mean of samples x samples pixels.
Picture Shrink(const Picture& large, int samples)
{
  Picture small{ large.Width / samples, large.Height / samples, {} };
  for (int y = 0; y < small.Height; ++y)
  {
    for (int x = 0; x < small.Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        int sum = 0;
        for (int s = 0; s < samples * samples; ++s)
        {
          sum += large.At(samples * x + s % samples, samples * y + s / samples)[c];
        }
        small.Pixels.push_back(
          static_cast<unsigned char>((sum + samples * samples / 2) / (samples * samples)));
      }
    }
  }
  return small;
}

const Change Plain = [](vtkRenderer*, vtkActor*) {};

void Compare(Checks& checks, const std::string& name, vtkPolyData* mesh, const Change& change)
{
  Scene stock(mesh, -1);
  Scene hybrid(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  const Picture expected = stock.Draw(change);
  const Picture picture = hybrid.Draw(change);
  checks.AtLeast(Psnr(expected, picture), LikeMesh, name + ": psnr against the mesh");
  checks.AtMost(CountDifferentCoverage(expected, picture), MostOfOutline, name + ": outline");
  checks.AtLeast<vtkIdType>(
    hybrid.Splats()->GetNumberOfTrianglesProjected(), 1, name + ": triangles");
  const Picture host = picture;
  hybrid.Splats()->SetTileListsToDevice();
  checks.AtLeast(PsnrOfAll(host, hybrid.Draw(Plain)), 60.0, name + ": lists by the device");
}

void TestLikeMesh(Checks& checks)
{
  const Mesh sphere = MakeSphereMesh(60);
  Compare(checks, "sphere", sphere, Plain);
  Compare(checks, "cube", Cube(), Plain);
  Compare(checks, "cylinder", Cylinder(), Plain);
  Compare(checks, "strips", Strips(), Plain);
  Compare(checks, "parallel", sphere, [](vtkRenderer* renderer, vtkActor*) {
    renderer->GetActiveCamera()->ParallelProjectionOn();
  });
  Compare(checks, "scaled", sphere,
    [](vtkRenderer*, vtkActor* actor) { actor->SetScale(0.5, 1.0, 0.7); });
  Compare(checks, "flat", Cylinder(),
    [](vtkRenderer*, vtkActor* actor) { actor->GetProperty()->SetInterpolationToFlat(); });
  Compare(checks, "inside", Cube(), [](vtkRenderer* renderer, vtkActor*) {
    // Triangles reach behind the eye.
    renderer->GetActiveCamera()->SetPosition(0.2, -0.1, 0.03);
    renderer->GetActiveCamera()->SetFocalPoint(-0.5, 0.4, 0.1);
    renderer->GetActiveCamera()->SetViewAngle(80.0);
  });
  auto clip = [](vtkRenderer*, vtkActor* actor) {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.5, 0.2);
    actor->GetMapper()->AddClippingPlane(plane);
  };
  Compare(checks, "clipped", sphere, clip);
  Compare(checks, "culled", sphere, [&clip](vtkRenderer* renderer, vtkActor* actor) {
    clip(renderer, actor);
    renderer->GetActiveCamera()->Azimuth(-90.0);
    actor->GetProperty()->BackfaceCullingOn();
  });
  const Mesh heights = MakeSphereMesh(60);
  SetHeights(heights);
  Compare(checks, "colours", heights, Plain);
  Compare(checks, "values", heights, [](vtkRenderer*, vtkActor* actor) {
    actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
  });
  auto translucent = [](vtkRenderer*, vtkActor* actor) { actor->GetProperty()->SetOpacity(0.4); };
  Compare(checks, "translucent cube", Cube(), translucent);
  Compare(checks, "translucent sphere", heights, translucent);
}

/// z over x and y, both from -1 to 1, by waves that are flat enough to be seen at a low angle.
double Height(double x, double y)
{
  return 0.02 * std::sin(5.0 * x) * std::cos(4.0 * y);
}

void AddPoint(vtkPolyData* mesh, double x, double y)
{
  const double n[3] = { -0.1 * std::cos(5.0 * x) * std::cos(4.0 * y),
    0.08 * std::sin(5.0 * x) * std::sin(4.0 * y), 1.0 };
  mesh->GetPoints()->InsertNextPoint(x, y, Height(x, y));
  const double l = std::sqrt(n[0] * n[0] + n[1] * n[1] + 1.0);
  vtkFloatArray::SafeDownCast(mesh->GetPointData()->GetNormals())
    ->InsertNextTuple3(n[0] / l, n[1] / l, n[2] / l);
}

Mesh Empty()
{
  Mesh mesh = Mesh::New();
  mesh->SetPoints(vtkNew<vtkPoints>());
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  mesh->GetPointData()->SetNormals(normals);
  mesh->SetPolys(vtkNew<vtkCellArray>());
  return mesh;
}

/// Adds a square grid of triangles; extent: half of its side.
void AddGrid(vtkPolyData* mesh, int side, double extent)
{
  const vtkIdType first = mesh->GetNumberOfPoints();
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      AddPoint(
        mesh, extent * (2.0 * i / (side - 1) - 1.0), extent * (2.0 * j / (side - 1) - 1.0));
    }
  }
  for (int j = 0; j + 1 < side; ++j)
  {
    for (int i = 0; i + 1 < side; ++i)
    {
      const vtkIdType a = first + j * side + i;
      const vtkIdType corners[6] = { a, a + 1, a + side + 1, a, a + side + 1, a + side };
      mesh->GetPolys()->InsertNextCell(3, corners);
      mesh->GetPolys()->InsertNextCell(3, corners + 3);
    }
  }
}

const Change Low = [](vtkRenderer* renderer, vtkActor*) {
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.1, 0.25);
  camera->SetFocalPoint(0.0, 0.0, -0.1);
  camera->SetViewUp(0.0, 0.0, 1.0);
};

/// Near the eye there are triangles, far from it splats.
void TestMixed(Checks& checks)
{
  Mesh mesh = Empty();
  AddGrid(mesh, 300, 1.0);
  Scene fine(mesh, -1, 3);
  Scene stock(mesh, -1);
  Scene splats(mesh, vtkPointSplatMapper::HYBRID_OFF);
  Scene hybrid(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  const Picture reference = Shrink(fine.Draw(Low), 3);
  const Picture off = splats.Draw(Low);
  const Picture both = hybrid.Draw(Low);
  checks.AtLeast<vtkIdType>(
    hybrid.Splats()->GetNumberOfTrianglesProjected(), 1000, "mixed: triangles");
  checks.AtLeast<vtkIdType>(hybrid.Splats()->GetNumberOfPointsProjected(), 1000, "mixed: splats");
  const double worse =
    std::min(PsnrOfAll(reference, stock.Draw(Low)), PsnrOfAll(reference, off));
  checks.AtLeast(PsnrOfAll(reference, both), worse - 0.5, "mixed: psnr against 3 x 3 samples");

  // Unlit and coloured by a value that changes linearly, triangles and splats show the same, so that
  // a seam would be all that is seen.
  SetHeights(mesh);
  auto unlit = [](vtkRenderer* renderer, vtkActor* actor) {
    Low(renderer, actor);
    actor->GetProperty()->LightingOff();
    actor->GetMapper()->SetScalarRange(-0.02, 0.02);
  };
  mesh->GetPointData()->GetScalars()->Modified();
  const Picture expected = stock.Draw(unlit);
  const Picture picture = hybrid.Draw(unlit);
  int largest = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      // Farther up the picture pixels hold several triangles, which the mesh has one of.
      for (int c = 0; c < 3 && y < Size / 2; ++c)
      {
        largest = std::max(largest, std::abs(int(expected.At(x, y)[c]) - picture.At(x, y)[c]));
      }
    }
  }
  checks.AtMost(largest, 3, "mixed: largest difference to the mesh");

  // Translucent, the far side of the border is another layer for none of them.
  auto translucent = [](vtkRenderer*, vtkActor* actor) { actor->GetProperty()->SetOpacity(0.5); };
  hybrid.Draw(translucent);
  checks.AtMost(hybrid.Splats()->GetNumberOfLayersDrawn(), 1, "mixed: layers of one surface");
  checks.AtLeast(PsnrOfAll(stock.Draw(translucent), hybrid.Draw(Plain)), 40.0,
    "mixed: translucent, psnr against the mesh");
}

/// Points of a scan about a square that a mesh closes.
void TestPatch(Checks& checks)
{
  Mesh patched = Empty();
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  auto next = [&random] {
    random->Next();
    return random->GetRangeValue(-1.0, 1.0);
  };
  while (patched->GetNumberOfPoints() < 40000)
  {
    const double x = next();
    const double y = next();
    if (std::max(std::abs(x), std::abs(y)) > 0.4)
    {
      AddPoint(patched, x, y);
    }
  }
  vtkNew<vtkCellArray> vertices; // points of no cell are not drawn beside cells
  for (vtkIdType id = 0; id < patched->GetNumberOfPoints(); ++id)
  {
    vertices->InsertNextCell(1, &id);
  }
  patched->SetVerts(vertices);
  AddGrid(patched, 17, 0.42);
  Mesh whole = Empty();
  AddGrid(whole, 300, 1.0);
  const Change above = [](vtkRenderer* renderer, vtkActor*) {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.3, -1.2, 1.6);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->Zoom(1.6); // the rim is out of view
  };
  Scene stock(whole, -1);
  Scene hybrid(patched, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  const Picture expected = stock.Draw(above);
  const Picture picture = hybrid.Draw(above);
  checks.AtLeast<vtkIdType>(
    hybrid.Splats()->GetNumberOfTrianglesProjected(), 1, "patch: triangles");
  checks.AtLeast<vtkIdType>(hybrid.Splats()->GetNumberOfPointsProjected(), 5000, "patch: splats");
  checks.AtMost(CountDifferentCoverage(expected, picture), 0, "patch: holes");
  checks.AtLeast(PsnrOfAll(expected, picture), 55.0, "patch: psnr against one mesh");
  checks.AtMost(LargestDifference(expected, picture), 4, "patch: largest difference");
}

vtkIdType CellAt(Scene& scene, unsigned int x, unsigned int y)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Win.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(x, y, x, y);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  if (selection->GetNumberOfNodes() == 0)
  {
    return -1;
  }
  auto ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  return ids && ids->GetNumberOfTuples() > 0 ? ids->GetValue(0) : -1;
}

void TestSelection(Checks& checks)
{
  const Mesh sphere = MakeSphereMesh(60);
  Scene stock(sphere, -1);
  Scene hybrid(sphere, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  stock.Draw(Plain);
  hybrid.Draw(Plain);
  int same = 0;
  int tried = 0;
  for (unsigned int x = 80; x < 240; x += 20)
  {
    const vtkIdType cell = CellAt(hybrid, x, 140);
    same += cell >= 0 && cell == CellAt(stock, x, 140);
    ++tried;
  }
  checks.AtLeast(same, tried, "selection: cells that are those of the mesh");
}

/// Points say how much of a light reaches them, and triangles what lies between.
void TestShadows(Checks& checks)
{
  const Mesh sphere = MakeSphereMesh(60);
  vtkNew<vtkFloatArray> factors;
  factors->SetName("ShadowFactor");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    factors->InsertNextValue(static_cast<float>(0.5 + sphere->GetPoint(i)[0]));
  }
  const Change lamp = [](vtkRenderer* renderer, vtkActor*) {
    vtkNew<vtkLight> light;
    light->SetPosition(2.0, 1.0, 5.0);
    renderer->AddLight(light);
  };
  const Picture lit = Scene(sphere, vtkPointSplatMapper::AUTOMATIC_HYBRID).Draw(lamp);
  sphere->GetPointData()->AddArray(factors);
  Scene off(sphere, vtkPointSplatMapper::HYBRID_OFF);
  Scene hybrid(sphere, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  const Picture picture = hybrid.Draw(lamp);
  checks.AtLeast(LargestDifference(lit, picture), 50, "shadows: difference to what is lit");
  checks.AtLeast(Psnr(off.Draw(lamp), picture), 38.0, "shadows: psnr against splats");
  hybrid.Splats()->ShadowsOn();
  hybrid.Draw(Plain);
  checks.AtLeast<vtkIdType>(
    hybrid.Splats()->GetNumberOfTrianglesProjected(), 1, "shadows: triangles");
}

/// What no triangles are for is drawn as if Hybrid were off, and so is what has none.
void TestSplatsAlone(Checks& checks)
{
  auto compare = [&checks](const std::string& name, vtkPolyData* data, const Change& change) {
    Scene off(data, vtkPointSplatMapper::HYBRID_OFF);
    Scene hybrid(data, vtkPointSplatMapper::AUTOMATIC_HYBRID);
    checks.AtMost(
      LargestDifference(off.Draw(change), hybrid.Draw(change)), 0, name + ": difference");
    checks.AtMost<vtkIdType>(
      hybrid.Splats()->GetNumberOfTrianglesProjected(), 0, name + ": triangles");
  };
  const Mesh sphere = MakeSphereMesh(60);
  compare("points", Cloud(sphere), Plain);
  compare("quads", sphere, [](vtkRenderer*, vtkActor* actor) {
    vtkPointSplatMapper::SafeDownCast(actor->GetMapper())->SetProjectionToQuads();
  });
  compare("image space", sphere, [](vtkRenderer*, vtkActor* actor) {
    vtkPointSplatMapper::SafeDownCast(actor->GetMapper())->SetMethodToImageSpace();
  });
  compare("gathered", sphere, [](vtkRenderer*, vtkActor* actor) {
    vtkPointSplatMapper::SafeDownCast(actor->GetMapper())->GatherRemainingOn();
    actor->GetProperty()->SetOpacity(0.5);
  });
  Mesh cells = MakeSphereMesh(60);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 7) / 7.0f - 0.5f);
  }
  cells->GetCellData()->SetScalars(values);
  compare("scalars of cells", cells, Plain);
  compare("dense", MakeSphereMesh(600), [](vtkRenderer* renderer, vtkActor*) {
    renderer->GetActiveCamera()->Zoom(0.5);
  });
}

/// Cells that name points which are not there, or too few of them, are left out.
void TestBadCells(Checks& checks)
{
  Mesh mesh = MakeSphereMesh(60);
  const vtkIdType bad[4] = { 0, 1, 1 << 30, -5 };
  mesh->GetPolys()->InsertNextCell(3, bad);
  mesh->GetPolys()->InsertNextCell(4, bad);
  mesh->GetPolys()->InsertNextCell(1, bad);
  mesh->GetPolys()->InsertNextCell(vtkIdType(0), bad);
  const vtkIdType same[3] = { 7, 7, 7 };
  mesh->GetPolys()->InsertNextCell(3, same);
  Scene good(MakeSphereMesh(60), vtkPointSplatMapper::AUTOMATIC_HYBRID);
  Scene hybrid(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  checks.AtLeast(Psnr(good.Draw(Plain), hybrid.Draw(Plain)), 60.0, "bad cells: psnr");
}

/// Blanked cells are not drawn, nor are points that no other cell uses.
void TestBlankedCells(Checks& checks)
{
  const Mesh mesh = MakeSphereMesh(60);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  Mesh rest = Mesh::New();
  rest->ShallowCopy(mesh);
  vtkNew<vtkCellArray> shown;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    const bool blanked = mesh->GetPoint(ids[0])[0] > 0.1;
    ghosts->InsertNextValue(blanked ? vtkDataSetAttributes::HIDDENCELL : 0);
    if (!blanked)
    {
      shown->InsertNextCell(size, ids);
    }
  }
  rest->SetPolys(shown);
  Scene hybrid(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  Scene splats(mesh, vtkPointSplatMapper::HYBRID_OFF);
  const int all = hybrid.Draw(Plain).CountDrawn();
  const Change fromThere = [&hybrid](vtkRenderer* renderer, vtkActor*) {
    renderer->GetActiveCamera()->DeepCopy(hybrid.Win.Renderer->GetActiveCamera());
  };
  const Picture expected = Scene(rest, -1).Draw(fromThere);
  mesh->GetCellData()->AddArray(ghosts);
  mesh->Modified();
  const Picture picture = hybrid.Draw(Plain);
  checks.AtMost(picture.CountDrawn(), all * 4 / 5, "blanked: pixels drawn");
  checks.AtLeast(Psnr(expected, picture), LikeMesh, "blanked: psnr against the other cells");
  // Splats of the last row reach over it by their radius.
  checks.AtMost(CountDifferentCoverage(expected, splats.Draw(Plain)), all / 100,
    "blanked: pixels of splats beyond the other cells");
}

/// What becomes of the input between frames.
void TestChanges(Checks& checks)
{
  Mesh mesh = MakeSphereMesh(60);
  Scene hybrid(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  const Picture before = hybrid.Draw(Plain);
  // A hole: a third of the triangles goes.
  vtkNew<vtkCellArray> fewer;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < 2 * mesh->GetPolys()->GetNumberOfCells() / 3; ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    fewer->InsertNextCell(ids);
  }
  mesh->SetPolys(fewer);
  const Picture after = hybrid.Draw(Plain);
  Scene anew(mesh, vtkPointSplatMapper::AUTOMATIC_HYBRID);
  // Points of no triangle are not drawn: what is left is smaller.
  const Change fromThere = [&hybrid](vtkRenderer* renderer, vtkActor*) {
    renderer->GetActiveCamera()->DeepCopy(hybrid.Win.Renderer->GetActiveCamera());
  };
  checks.AtMost(LargestDifference(after, anew.Draw(fromThere)), 0, "changed: as if new");
  checks.AtLeast(LargestDifference(after, before), 50, "changed: difference to before");
  hybrid.Splats()->SetHybridToOff();
  hybrid.Draw(Plain);
  checks.AtMost<vtkIdType>(
    hybrid.Splats()->GetNumberOfTrianglesProjected(), 0, "off again: triangles");
}
}

int TestSplatsHybrid(int, char*[])
{
  Checks checks;
  TestLikeMesh(checks);
  TestMixed(checks);
  TestPatch(checks);
  TestSelection(checks);
  TestShadows(checks);
  TestSplatsAlone(checks);
  TestBadCells(checks);
  TestBlankedCells(checks);
  TestChanges(checks);
  return checks.Result();
}
