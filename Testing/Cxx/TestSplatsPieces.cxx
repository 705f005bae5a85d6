// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks that are pieces of one cloud, dealt out at random or cut along planes, are drawn as that cloud in one data set:
// sizes, fill points, colours, levels, and what is picked. Bodies do not know of one another, be it that they touch, cross or lie
// a spacing apart.
#include "LevelScene.h"
#include "PickedPoints.h"
#include "RimmedDisc.h"

#include "vtkDataSetAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSplatEstimation.h"

namespace
{
using namespace LevelScene;
using Mapper = vtkPointSplatMapper;
using Chooser = std::function<int(vtkIdType, const double*)>;

// dB: sums over neighbours come in another order, and fill points between pieces have the values of one.
constexpr double Same = 55.0;

/// Some of the points, with all their arrays.
vtkSmartPointer<vtkPolyData> Some(vtkPolyData* whole, const std::vector<vtkIdType>& ids)
{
  auto some = vtkSmartPointer<vtkPolyData>::New();
  some->SetPoints(vtkNew<vtkPoints>());
  some->GetPointData()->CopyAllOn();
  some->GetPointData()->CopyAllocate(whole->GetPointData());
  for (vtkIdType id : ids)
  {
    const vtkIdType own = some->GetPoints()->InsertNextPoint(whole->GetPoint(id));
    some->GetPointData()->CopyData(whole->GetPointData(), id, own);
  }
  return some;
}

struct Pieces
{
  vtkNew<vtkMultiBlockDataSet> Blocks;
  std::vector<std::vector<vtkIdType>> Ids; // of each block, in the whole

  Pieces(vtkPolyData* whole, int count, const Chooser& choose)
    : Ids(static_cast<size_t>(count))
  {
    for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
    {
      this->Ids[static_cast<size_t>(choose(i, whole->GetPoint(i)))].push_back(i);
    }
    for (unsigned int b = 0; b < this->Ids.size(); ++b)
    {
      this->Blocks->SetBlock(b, Some(whole, this->Ids[b]));
    }
  }
  /// The number in the whole; flat indices count the root.
  vtkIdType GetId(const PickedPoint& hit) const
  {
    return hit.Point < 0 ? -1 : this->Ids[hit.Block - 1][static_cast<size_t>(hit.Point)];
  }
};

Chooser AtRandom(int count)
{
  return [count](vtkIdType i, const double*) {
    return static_cast<int>((static_cast<uint64_t>(i) * 0x9e3779b97f4a7c15u >> 40) % static_cast<uint64_t>(count));
  };
}

Chooser InHalves()
{
  return [](vtkIdType, const double* p) { return p[0] + 0.3 * p[1] > 0.1 ? 1 : 0; };
}

/// From -1 to 1 each way.
vtkSmartPointer<vtkPolyData> RandomBox(int count)
{
  int face = 0;
  return RandomCloud(count, [&face](double u, double v, double* p, double* n) {
    const int axis = face / 2 % 3;
    const double side = face % 2 ? 1.0 : -1.0;
    face = (face + 1) % 6;
    for (int k = 0; k < 3; ++k)
    {
      n[k] = k == axis ? side : 0.0;
    }
    p[axis] = side;
    p[(axis + 1) % 3] = 2.0 * u - 1.0;
    p[(axis + 2) % 3] = 2.0 * v - 1.0;
  });
}

struct View
{
  vtkNew<Mapper> Splats;
  Window Win;

  explicit View(vtkDataObject* data, const vtkCamera* like = nullptr)
  {
    this->Splats->SetInputDataObject(data);
    this->Splats->SetScalarRange(-1.0, 1.0);
    this->Win.Add(this->Splats);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(-50.0);
    this->Win.Renderer->ResetCameraClippingRange();
    if (like)
    {
      this->Win.Renderer->GetActiveCamera()->DeepCopy(const_cast<vtkCamera*>(like));
    }
  }
};

vtkSmartPointer<vtkPolyData> WithValues(vtkSmartPointer<vtkPolyData> data)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    values->InsertNextValue(static_cast<float>(std::sin(3.0 * p[0]) * std::cos(2.0 * p[1])));
  }
  data->GetPointData()->SetScalars(values);
  return data;
}

void CompareWithWhole(Checks& checks)
{
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkPolyData> Whole;
  };
  const auto noNormals = [](vtkSmartPointer<vtkPolyData> data) {
    data->GetPointData()->SetNormals(nullptr);
    return data;
  };
  // The rimmed disc has fill points.
  for (const Case& c : { Case{ "torus", WithValues(RandomTorus(20000)) },
         Case{ "torus without normals", noNormals(RandomTorus(20000)) },
         Case{ "rimmed disc", Cloud(RimmedDisc(0.1).MakeMesh(RimmedDisc::Coarse)) } })
  {
    View whole(c.Whole);
    const Picture expected = whole.Win.Draw();
    const vtkIdType splats = whole.Splats->GetNumberOfPointsProjected();
    struct Cut
    {
      const char* Name;
      int Count;
      Chooser Choose;
    };
    for (const Cut& cut : { Cut{ "dealt out", 40, AtRandom(40) }, Cut{ "in halves", 2, InHalves() } })
    {
      const std::string name = std::string(c.Name) + ", " + cut.Name;
      View pieces(Pieces(c.Whole, cut.Count, cut.Choose).Blocks);
      checks.AtLeast(Psnr(pieces.Win.Draw(), expected), Same, name);
      // Fill points go by the points' order.
      const double more = double(pieces.Splats->GetNumberOfPointsProjected()) / double(splats);
      checks.AtMost(std::abs(more - 1.0), 0.002, name + ": splats");
    }
  }
}

void HidePieces(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> whole = RandomTorus(20000);
  View pieces(Pieces(whole, 2, InHalves()).Blocks);
  const Picture both = pieces.Win.Draw();
  // Sizes are kept from the first time on that some block has a look of its own.
  pieces.Splats->SetBlockVisibility(1u, false);
  pieces.Win.Draw();
  pieces.Splats->SetBlockVisibility(1u, true);
  pieces.Win.Draw();
  vtkNew<ProgressCounter> counter;
  pieces.Splats->AddObserver(vtkCommand::ProgressEvent, counter);
  pieces.Splats->SetBlockVisibility(1u, false);
  const Picture right = pieces.Win.Draw();
  pieces.Splats->SetBlockVisibility(1u, true);
  pieces.Splats->SetBlockVisibility(2u, false);
  const Picture left = pieces.Win.Draw();
  pieces.Splats->SetBlockVisibility(2u, true);
  checks.AtLeast(Psnr(pieces.Win.Draw(), both), Same, "both halves again");
  checks.Expect(counter->Partial == 0, "to hide a piece makes sizes anew");
  // What is not beside the cut, and is seen of one half, is as it was.
  int drawn = 0;
  int others = 0;
  for (int y = 0; y < both.Height; ++y)
  {
    for (int x = 0; x < both.Width; ++x)
    {
      if (right.IsBackground(x, y) != left.IsBackground(x, y))
      {
        const Picture& one = right.IsBackground(x, y) ? left : right;
        ++drawn;
        others += std::abs(one.At(x, y)[0] - both.At(x, y)[0]) > 2;
      }
    }
  }
  checks.AtLeast(drawn, 10000, "pixels of one half");
  checks.AtMost(others, drawn / 50, "pixels that another half changes");
}

void KeepApart(Checks& checks)
{
  // A sphere beside a dense one, of another radius: each is as if alone.
  vtkSmartPointer<vtkPolyData> sparse = RandomSphere(1500);
  vtkSmartPointer<vtkPolyData> dense = Moved(RandomTorus(20000), 1.0, 2.8);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sparse);
  blocks->SetBlock(1, dense);
  View together(blocks);
  View apart(sparse, together.Win.Renderer->GetActiveCamera());
  vtkNew<Mapper> other;
  other->SetInputData(dense);
  apart.Win.Add(other);
  apart.Win.Renderer->ResetCameraClippingRange();
  checks.AtLeast(Psnr(together.Win.Draw(), apart.Win.Draw()), Same, "bodies apart");

  // Shells that are half a spacing apart, boxes that share a face, spheres that cross: as with each body's own sizes.
  struct Bodies
  {
    const char* Name;
    vtkSmartPointer<vtkPolyData> One;
    vtkSmartPointer<vtkPolyData> Other;
  };
  for (const Bodies& c : { Bodies{ "shells", RandomSphere(5000), Moved(RandomSphere(5000), 0.975, 0.0) },
         Bodies{ "boxes", RandomBox(5000), Moved(RandomBox(5000), 1.0, 2.0) },
         Bodies{ "crossing", RandomSphere(5000), Moved(RandomSphere(8000), 0.8, 0.9) } })
  {
    vtkNew<vtkMultiBlockDataSet> bare;
    vtkNew<vtkMultiBlockDataSet> sized;
    for (vtkPolyData* body : { c.One.Get(), c.Other.Get() })
    {
      vtkNew<vtkPointSplatEstimation> estimation;
      estimation->FillGapsOn();
      estimation->SetInputData(body);
      estimation->Update();
      sized->SetBlock(sized->GetNumberOfBlocks(), estimation->GetOutput());
      bare->SetBlock(bare->GetNumberOfBlocks(), body);
    }
    View own(sized);
    checks.AtLeast(Psnr(View(bare).Win.Draw(), own.Win.Draw()), Same, c.Name);
  }

  // With their neighbours' points, as partitions with ghosts have them, pieces are whole already.
  vtkSmartPointer<vtkPolyData> torus = RandomTorus(20000);
  Pieces halves(torus, 2, InHalves());
  vtkNew<vtkMultiBlockDataSet> haloed;
  for (unsigned int b = 0; b < 2; ++b)
  {
    std::vector<vtkIdType> ids = halves.Ids[b];
    const vtkIdType own = static_cast<vtkIdType>(ids.size());
    ids.insert(ids.end(), halves.Ids[1 - b].begin(), halves.Ids[1 - b].end());
    vtkSmartPointer<vtkPolyData> block = Some(torus, ids);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      ghosts->InsertNextValue(i < own ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
    }
    block->GetPointData()->AddArray(ghosts);
    haloed->SetBlock(b, block);
  }
  View whole(torus);
  checks.AtLeast(Psnr(View(haloed).Win.Draw(), whole.Win.Draw()), 50.0, "pieces with ghosts");

  // Hidden points of one piece, and one without normals beside them.
  auto hiding = vtkPolyData::SafeDownCast(halves.Blocks->GetBlock(0));
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < hiding->GetNumberOfPoints(); ++i)
  {
    ghosts->InsertNextValue(i % 2 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  hiding->GetPointData()->AddArray(ghosts);
  vtkSmartPointer<vtkPolyData> bare = RandomTorus(5000);
  bare->GetPointData()->SetNormals(nullptr);
  halves.Blocks->SetBlock(2, bare);
  View mixed(halves.Blocks);
  vtkObject::GlobalWarningDisplayOff();
  checks.AtLeast(mixed.Win.Draw().CountDrawn(), 20000, "pixels of unlike pieces");
  vtkObject::GlobalWarningDisplayOn();
  checks.AtMost(std::abs(double(mixed.Splats->GetNumberOfSkippedPoints()) - double(hiding->GetNumberOfPoints() / 2)),
    0.5, "hidden points are counted");
}

void BadPoints(Checks& checks)
{
  // One of each twenty points is bad in each way, in all pieces; and some lie far off.
  vtkSmartPointer<vtkPolyData> torus = RandomTorus(20000);
  View good(Pieces(torus, 40, AtRandom(40)).Blocks);
  const Picture expected = good.Win.Draw();
  const double bad[] = { NAN, INFINITY, -INFINITY, 1e36, 3e38, 1e9 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkDataArray* own = torus->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(torus->GetPoint(i));
    normals->InsertNextTuple(i, own);
    if (i % 20 == 0)
    {
      const double x = bad[i / 20 % 6];
      points->InsertNextPoint(x, i % 40 ? x : 0.0, 0.0);
      normals->InsertNextTuple(i, own);
      points->InsertNextPoint(torus->GetPoint(i));
      normals->InsertNextTuple3(0.0, i % 40 ? 0.0 : NAN, 0.0);
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  vtkObject::GlobalWarningDisplayOff();
  View spoilt(Pieces(cloud, 40, AtRandom(40)).Blocks, good.Win.Renderer->GetActiveCamera());
  spoilt.Win.Renderer->ResetCameraClippingRange(-2, 2, -2, 2, -2, 2);
  checks.AtLeast(Psnr(spoilt.Win.Draw(), expected), 40.0, "bad points in pieces");
  // Nothing but bad points, one point, and many at one place.
  for (int kind = 0; kind < 3; ++kind)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned int b = 0; b < 3; ++b)
    {
      vtkSmartPointer<vtkPolyData> block = RandomTorus(kind == 1 ? 1 : 100);
      for (vtkIdType i = 0; kind != 1 && i < block->GetNumberOfPoints(); ++i)
      {
        const double x = kind == 0 ? NAN : 0.5;
        block->GetPoints()->SetPoint(i, x, x, x);
      }
      blocks->SetBlock(b, block);
    }
    View few(blocks);
    few.Win.Draw();
    checks.AtMost(double(few.Splats->GetNumberOfSplats()), 300.0, "splats of next to nothing");
  }
  vtkObject::GlobalWarningDisplayOn();
}

void MixLevels(Checks& checks)
{
  constexpr int count = 1 << 20;
  constexpr int blocks = 40;
  vtkSmartPointer<vtkPolyData> whole = Torus(count, 0.0, true);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < count; ++i)
  {
    places->InsertNextTuple2(whole->GetPoint(i)[0], whole->GetPoint(i)[1]);
  }
  whole->GetPointData()->SetTCoords(places);
  const Pieces pieces(whole, blocks, AtRandom(blocks));
  Scene one(whole);
  Scene many(pieces.Blocks);
  checks.Expect(one.Wait() && many.Wait(), "levels are not made");
  one.Win.Draw();
  const Picture levels = many.Win.Draw();
  checks.AtMost(double(many.Mapper->GetNumberOfPointsProjected()) / double(one.Mapper->GetNumberOfPointsProjected()), 1.1,
    "splats of many blocks, of one's");
  checks.AtLeast(Psnr(levels, many.DrawAll()), Psnr(one.Win.Draw(), one.DrawAll()) - 0.5, "levels of mixed blocks");
  one.Wait();
  many.Wait();

  // The numbers of points, whatever block they are in.
  const auto exact = PickPoints(one.Win);
  const auto picked = PickPoints(many.Win);
  int found = 0;
  int others = 0;
  for (size_t i = 0; i < std::min(exact.size(), picked.size()); ++i)
  {
    found += exact[i].Point >= 0;
    others += exact[i].Point >= 0 && pieces.GetId(picked[i]) != exact[i].Point;
  }
  checks.AtLeast(found, 30000, "pixels with a point");
  checks.AtMost(others, found / 100, "pixels where another point is picked");

  // Looks of blocks, and what is hidden.
  many.Mapper->ScalarVisibilityOff();
  for (unsigned int b = 1; b <= blocks; ++b)
  {
    many.Mapper->SetBlockColor(b, b % 2 ? 1.0 : 0.0, 0.4, 0.4);
  }
  checks.Expect(many.Wait(), "levels with colours");
  const Picture coloured = many.Win.Draw();
  checks.AtLeast(Psnr(coloured, many.DrawAll()), 40.0, "mixed colours");
  many.Wait();
  for (unsigned int b = 1; b <= blocks; b += 2)
  {
    many.Mapper->SetBlockVisibility(b, false);
  }
  many.Win.Draw();
  for (const PickedPoint& hit : PickPoints(many.Win))
  {
    checks.Expect(hit.Block % 2 == 0, "a hidden block is picked");
    if (hit.Block % 2)
    {
      break;
    }
  }
}

void MoveMixed(Checks& checks)
{
  constexpr int count = 1 << 20;
  vtkSmartPointer<vtkPolyData> whole = Torus(count, 0.0, true);
  const Pieces pieces(whole, 3, AtRandom(3));
  Scene scene(pieces.Blocks);
  checks.Expect(scene.Wait(), "levels before the motion");
  for (int step = 1; step < 4; ++step)
  {
    for (unsigned int b = 0; b < 3; ++b)
    {
      Moved(vtkPolyData::SafeDownCast(pieces.Blocks->GetBlock(b)), 1.0, 0.05);
    }
    scene.Win.Draw();
  }
  checks.Expect(std::strstr(scene.Mapper->GetChoices(), "sizes of an earlier frame") != nullptr,
    "blocks that move are not followed");
  const Picture moving = scene.Win.Draw();
  Scene anew(pieces.Blocks);
  anew.Win.Renderer->GetActiveCamera()->DeepCopy(scene.Win.Renderer->GetActiveCamera());
  checks.AtLeast(Psnr(moving, anew.DrawAll()), 45.0, "moved");
  checks.Expect(scene.Wait(), "levels while points move no more");
  checks.AtLeast(Psnr(scene.Win.Draw(), anew.DrawAll()), 45.0, "moved, with levels");
}
}

int TestSplatsPieces(int, char*[])
{
  Checks checks;
  CompareWithWhole(checks);
  HidePieces(checks);
  KeepApart(checks);
  BadPoints(checks);
  MixLevels(checks);
  MoveMixed(checks);
  return checks.Result();
}
