// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Levels of detail of a composite input: hidden, coloured and translucent blocks are as exact as without
// levels, where they meet and where the surface ends, and the same points and blocks are picked.
#include "LevelScene.h"
#include "PickedPoints.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"

#include <map>

namespace
{
using namespace LevelScene;

constexpr int Count = 1 << 21;
constexpr int BlockCount = 6;
// dB over the pixels that are covered.
constexpr double Alike = 45.0;

/// The flat indices. Block 4 is that of the nested ones.
enum Block : unsigned int
{
  Hidden = 1,
  Coloured = 2,
  Translucent = 3,
  OfNested = 5
};

/// The torus in parts of equal angles about its axis and about the tube's; nested: half of them below
/// another node.
vtkSmartPointer<vtkMultiBlockDataSet> Divide(
  vtkPolyData* whole, int around, int about, bool nested)
{
  auto partOf = [](double y, double x, int count) {
    const double turn = std::atan2(y, x) / (2.0 * vtkMath::Pi()) + 0.5;
    return std::min(static_cast<int>(turn * count), count - 1);
  };
  const int parts = around * about;
  vtkFloatArray* radii =
    vtkFloatArray::SafeDownCast(whole->GetPointData()->GetArray("SplatRadius"));
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  for (int i = 0; i < parts; ++i)
  {
    auto block = vtkSmartPointer<vtkPolyData>::New();
    block->SetPoints(vtkNew<vtkPoints>());
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> own;
    own->SetName("SplatRadius");
    block->GetPointData()->SetNormals(normals);
    block->GetPointData()->AddArray(own);
    blocks.push_back(block);
  }
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    double p[3];
    whole->GetPoint(i, p);
    vtkPolyData* block = blocks[static_cast<size_t>(about * partOf(p[1], p[0], around) +
      partOf(p[2], std::hypot(p[0], p[1]) - 1.0, about))];
    block->GetPoints()->InsertNextPoint(p);
    block->GetPointData()->GetNormals()->InsertNextTuple(i, whole->GetPointData()->GetNormals());
    block->GetPointData()->GetArray("SplatRadius")->InsertNextTuple(i, radii);
  }
  auto root = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> half;
  for (int i = 0; i < parts; ++i)
  {
    const bool below = nested && i >= parts / 2;
    vtkMultiBlockDataSet* parent = below ? half.Get() : root.Get();
    parent->SetBlock(parent->GetNumberOfBlocks(), blocks[static_cast<size_t>(i)]);
  }
  if (nested)
  {
    root->SetBlock(root->GetNumberOfBlocks(), half);
  }
  return root;
}

bool Compare(Scene& scene, const std::string& what)
{
  bool good = Expect(scene.Wait(), what + ": levels are made");
  const Picture levels = scene.Win.Draw();
  const vtkIdType drawn = scene.Mapper->GetNumberOfPointsProjected();
  good = IsLike(levels, scene.DrawAll(), Alike, what) && good;
  std::cout << what << ", drawn: " << drawn << "\n";
  return Expect(drawn <= Count / 4, what + ", drawn: " + std::to_string(drawn)) && good;
}

bool TestLooks()
{
  vtkSmartPointer<vtkPolyData> whole = Torus(Count, 0.0, false);
  Scene scene(Divide(whole, BlockCount, 1, true));
  bool good = Compare(scene, "blocks");
  const Picture plain = scene.Win.Draw();
  scene.Mapper->SetBlockVisibility(Hidden, false);
  good = Expect(!scene.HasLevels() || Psnr(scene.Win.Draw(), plain) < 30.0, "a block is hidden") &&
    good;
  good = Compare(scene, "a hidden block") && good;
  scene.Mapper->SetBlockColor(Coloured, 1.0, 0.2, 0.1);
  scene.Mapper->SetBlockColor(OfNested, 0.2, 0.9, 0.1);
  good = Compare(scene, "coloured blocks") && good;
  scene.Mapper->SetBlockOpacity(Translucent, 0.4);
  good = Compare(scene, "a translucent block") && good;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.1, 0.1);
  plane->SetNormal(0.2, -0.3, -1.0);
  scene.Mapper->AddClippingPlane(plane);
  good = Compare(scene, "clipped blocks") && good;
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Mapper->RemoveBlockOpacity(Translucent);

  // What is picked is no matter of levels, but for some pixels at outlines: before points are
  // selected VTK draws a frame, and keeps its depth.
  good = Expect(scene.Wait(), "levels for picking") && good;
  scene.Win.Draw();
  const auto picked = PickPoints(scene.Win);
  scene.Mapper->LevelOfDetailOff();
  scene.Win.Draw();
  const auto exact = PickPoints(scene.Win);
  int missed = 0;
  int others = 0;
  int found = 0;
  for (size_t i = 0; i < std::min(picked.size(), exact.size()); ++i)
  {
    found += exact[i].Block != 0;
    missed += exact[i].Block != 0 && picked[i].Block == 0;
    others += picked[i].Block != 0 && picked[i] != exact[i];
  }
  std::cout << "picked: " << found << ", missed beside levels: " << missed << "\n";
  good = Expect(found > 30000, "pixels with a point: " + std::to_string(found)) && good;
  good = Expect(others == 0, "other points are picked: " + std::to_string(others)) && good;
  good = Expect(missed <= found / 200, "points are not picked: " + std::to_string(missed)) && good;
  std::map<unsigned int, int> counts;
  for (const auto& hit : picked)
  {
    ++counts[hit.Block];
  }
  good = Expect(counts[Hidden] == 0 && counts[4] == 0, "what is hidden is not picked") && good;
  for (const unsigned int block : { Coloured, Translucent, OfNested })
  {
    good = Expect(counts[block] > 1000, "pixels of block " + std::to_string(block) + ": " +
                 std::to_string(counts[block])) &&
      good;
  }
  return good;
}

bool TestScalars()
{
  // Of one value a block, as of their numbers, and by values that are mapped at pixels.
  vtkSmartPointer<vtkPolyData> whole = Torus(Count, 0.0, false);
  vtkSmartPointer<vtkMultiBlockDataSet> blocks = Divide(whole, BlockCount, 1, false);
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    auto block = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    vtkNew<vtkFloatArray> values;
    values->SetName("Values");
    values->SetNumberOfTuples(block->GetNumberOfPoints());
    values->Fill(i % 2 ? -0.8 : 0.1 * i);
    block->GetPointData()->SetScalars(values);
  }
  Scene scene(blocks);
  bool good = Compare(scene, "a colour a block");
  scene.Mapper->InterpolateScalarsBeforeMappingOn();
  return Compare(scene, "a value a block") && good;
}

bool TestSmallBlocks()
{
  vtkSmartPointer<vtkPolyData> whole = Torus(Count, 0.0, false);
  Scene one(whole);
  bool good = Compare(one, "one block");
  const vtkIdType few = one.Mapper->GetNumberOfPointsProjected();
  one.Win.Draw();
  Scene many(Divide(whole, 50, 20, false));
  good = Compare(many, "many blocks") && good;
  many.Win.Draw();
  const vtkIdType drawn = many.Mapper->GetNumberOfPointsProjected();
  return Expect(drawn <= 1.1 * double(few),
           "of many blocks are drawn: " + std::to_string(drawn) + ", of one: " +
             std::to_string(few)) &&
    good;
}
}

int TestSplatsBlockLevels(int, char*[])
{
  bool good = TestLooks();
  good = TestScalars() && good;
  good = TestSmallBlocks() && good;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
