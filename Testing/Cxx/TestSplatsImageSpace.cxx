// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Image-space reconstruction: the fillings against a plain version to the last bit, both
// projections against each other, pictures against meshes and closed forms.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>

namespace
{
using namespace SplatScene;

//------------------------------------------------------------------------------
// The fillings. Small random images, many in a window with margins between them, are points in
// the middle of pixels; which point each pixel takes is what hardware selection answers.

constexpr int Side = 200;      // pixels of the window
constexpr int Tile = 20;       // pixels from one small image to the next
constexpr int TilePixels = 16; // pixels of a small image
constexpr double LayerDistance = 1.5;
constexpr int Nothing = -1;

struct Pixel
{
  int Code = Nothing; // the depth in 32nds, and the side
  vtkIdType Id = Nothing;
};
using Image = std::vector<Pixel>;

struct RandomImages
{
  vtkNew<vtkPolyData> Cloud;
  Image Projected = Image(Side * Side);
};

void MakeRandomImages(RandomImages& images, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<std::array<int, 4>> samples; // x, y, depth, side
  for (int tile = 0; tile < (Side / Tile) * (Side / Tile); ++tile)
  {
    // Of many kinds: sparse and dense, one surface or some.
    const unsigned int filled = 30 + random() % 70;
    const unsigned int depths = 1 + random() % 6;
    for (int k = 0; k < TilePixels * TilePixels; ++k)
    {
      for (int twice = random() % 8 == 0 ? 2 : 1; twice > 0; --twice)
      {
        if (random() % 100 < filled)
        {
          const int x = tile % (Side / Tile) * Tile + 2 + k % TilePixels;
          const int y = tile / (Side / Tile) * Tile + 2 + k / TilePixels;
          const int depth = static_cast<int>(random() % depths);
          // Of points equally near, the rasteriser keeps the first: all have one side.
          // Each twice, so that they count as dense enough for the masks alone; with texture coordinates of their own,
          // or one splat would be drawn for both.
          samples.insert(
            samples.end(), 2, { { x, y, depth, (7 * x + 13 * y + depth) % 5 == 0 ? 1 : 0 } });
        }
      }
    }
  }
  std::shuffle(samples.begin(), samples.end(), random);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Coordinates");
  for (const auto& s : samples)
  {
    const vtkIdType id =
      points->InsertNextPoint(s[0] + 0.5 - Side / 2, s[1] + 0.5 - Side / 2, -s[2]);
    coordinates->InsertNextValue(static_cast<float>(id));
    normals->InsertNextTuple3(0.0, 0.0, s[3] ? -1.0 : 1.0);
    Pixel& pixel = images.Projected[static_cast<size_t>(s[1] * Side + s[0])];
    // In sixteenths; what shows its back is taken for 3/8 of a layer farther.
    const int code = 2 * (16 * s[2] + static_cast<int>(6 * LayerDistance) * s[3]) + s[3];
    if (pixel.Code == Nothing || code < pixel.Code)
    {
      pixel = { code, id };
    }
  }
  images.Cloud->SetPoints(points);
  images.Cloud->GetPointData()->SetNormals(normals);
  images.Cloud->GetPointData()->SetTCoords(coordinates);
}

/**
 * One step of both fillings, as the paper draws the masks.
 */
Image Fill(const Image& from)
{
  static const int masks[8][5][2] = { { { 1, -1 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, -1 } },
    { { -1, -1 }, { -1, 0 }, { -1, 1 }, { 0, 1 }, { 0, -1 } },
    { { -1, 1 }, { 0, 1 }, { 1, 1 }, { -1, 0 }, { 1, 0 } },
    { { -1, -1 }, { 0, -1 }, { 1, -1 }, { -1, 0 }, { 1, 0 } },
    { { -1, 1 }, { 0, 1 }, { 1, 1 }, { 1, 0 }, { 1, -1 } },
    { { -1, -1 }, { -1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } },
    { { -1, 1 }, { -1, 0 }, { -1, -1 }, { 0, -1 }, { 1, -1 } },
    { { -1, -1 }, { 0, -1 }, { 1, -1 }, { 1, 0 }, { 1, 1 } } };
  // Of equally near ones, the first from the right one on, counter-clockwise.
  static const int ring[8][2] = { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { -1, -1 },
    { 0, -1 }, { 1, -1 } };
  auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= Side || y >= Side ? Pixel()
                                                    : from[static_cast<size_t>(y * Side + x)];
  };
  Image to = from;
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      const Pixel own = at(x, y);
      auto white = [&](const Pixel& other) {
        return other.Code == Nothing ||
          (own.Code != Nothing && other.Code / 2 >= own.Code / 2 - 16 * LayerDistance);
      };
      bool beyond = false;
      for (const auto& mask : masks)
      {
        beyond = beyond || std::all_of(std::begin(mask), std::end(mask), [&](const int* d) {
          return white(at(x + d[0], y + d[1]));
        });
      }
      if (beyond)
      {
        continue;
      }
      Pixel nearest;
      for (const auto& d : ring)
      {
        const Pixel other = at(x + d[0], y + d[1]);
        if (other.Code != Nothing && (nearest.Code == Nothing || other.Code < nearest.Code))
        {
          nearest = other;
        }
      }
      to[static_cast<size_t>(y * Side + x)] = nearest;
    }
  }
  return to;
}

std::vector<vtkIdType> PickAll(vtkRenderer* renderer)
{
  std::vector<vtkIdType> ids(Side * Side, Nothing);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  if (selector->CaptureBuffers())
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const unsigned int pixel[2] = { static_cast<unsigned int>(x),
          static_cast<unsigned int>(y) };
        const auto hit = selector->GetPixelInformation(pixel);
        if (hit.Valid)
        {
          ids[static_cast<size_t>(y * Side + x)] = hit.AttributeID;
        }
      }
    }
  }
  return ids;
}

void TestFillings(Checks& checks, bool raster, int windows)
{
  Window window(Side);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Side);
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetClippingRange(1, 20);
  int different = 0;
  int filled = 0;
  int occluded = 0;
  for (int i = 0; i < windows; ++i)
  {
    RandomImages images;
    MakeRandomImages(images, static_cast<unsigned int>(1000 + i));
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetMethodToImageSpace();
    mapper->SetLayerDistance(LayerDistance);
    mapper->SetInputData(images.Cloud);
    if (raster)
    {
      mapper->SetProjectionToQuads();
    }
    window.Renderer->RemoveAllViewProps();
    window.Add(mapper);
    window.Win->Render();
    checks.AtMost(mapper->GetProjectedSpacing(), 1.2, "spacing of the random images");
    const int steps = mapper->GetNumberOfFillSteps();
    checks.AtLeast(steps, 1, "steps of filling");
    Image expected = images.Projected;
    for (int k = 0; k < steps; ++k)
    {
      expected = Fill(expected);
    }
    const std::vector<vtkIdType> ids = PickAll(window.Renderer);
    for (size_t p = 0; p < ids.size(); ++p)
    {
      // Points in the same place have one id as well as the other.
      const Pixel& was = images.Projected[p];
      filled += was.Code == Nothing && expected[p].Code != Nothing;
      occluded += was.Code != Nothing && expected[p].Code != was.Code;
      if (ids[p] != expected[p].Id)
      {
        double a[3] = { 0.0, 0.0, 1.0 };
        double b[3] = { 0.0, 0.0, 2.0 };
        if (ids[p] >= 0 && expected[p].Id >= 0)
        {
          images.Cloud->GetPoint(ids[p], a);
          images.Cloud->GetPoint(expected[p].Id, b);
        }
        different += !std::equal(a, a + 3, b);
      }
    }
    mapper->ReleaseGraphicsResources(window.Win);
  }
  const std::string kind = raster ? "raster" : "compute";
  std::cout << kind << ": " << windows * 100 << " images, " << filled << " background and "
            << occluded << " occluded pixels filled\n";
  checks.AtMost(different, 0, kind + ": pixels that a plain version fills otherwise");
  checks.AtLeast(filled, 10000, kind + ": background pixels that were filled");
  checks.AtLeast(occluded, 10000, kind + ": occluded pixels that were filled");
}

//------------------------------------------------------------------------------
void TestProjections(Checks& checks)
{
  // Opaque, coloured and translucent: the same picture from compute shaders and the rasteriser.
  for (int kind = 0; kind < 3; ++kind)
  {
    vtkSmartPointer<vtkPolyData> cloud = RandomTorus(60000);
    if (kind == 1)
    {
      vtkNew<vtkFloatArray> scalars;
      for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
      {
        scalars->InsertNextValue(static_cast<float>(cloud->GetPoint(i)[0]));
      }
      cloud->GetPointData()->SetScalars(scalars);
    }
    Picture pictures[2];
    for (int raster = 0; raster < 2; ++raster)
    {
      Window window;
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetMethodToImageSpace();
      mapper->SetInputData(cloud);
      mapper->SetScalarRange(-1.4, 1.4);
      mapper->SetProjection(raster ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::COMPUTE);
      vtkActor* actor = window.Add(mapper);
      actor->GetProperty()->SetOpacity(kind == 2 ? 0.5 : 1.0);
      window.Renderer->ResetCamera();
      window.Renderer->GetActiveCamera()->Elevation(-50);
      window.Renderer->ResetCameraClippingRange();
      pictures[raster] = window.Draw();
      checks.Expect(std::string(mapper->GetMethodUsed()) == "image-space", "method used");
      checks.Expect(
        std::string(mapper->GetProjectionUsed()) == (raster ? "quads" : "compute"), "projection");
    }
    const std::string name = "projections, kind " + std::to_string(kind);
    int apart = 0;
    for (size_t i = 0; i < pictures[0].Pixels.size(); ++i)
    {
      apart += std::abs(pictures[0].Pixels[i] - pictures[1].Pixels[i]) > 2;
    }
    // Ties: depths that round to one side or the other.
    checks.AtMost(apart, static_cast<int>(pictures[0].Pixels.size() / 2000), name + ": values apart");
    checks.AtMost(CountDifferentCoverage(pictures[0], pictures[1]), 4, name + ": coverage");
  }
}

//------------------------------------------------------------------------------
void TestLikeMesh(Checks& checks)
{
  // Denser than pixels.
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(400);
  for (const bool parallel : { false, true })
  {
    Picture pictures[2];
    for (int k = 0; k < 2; ++k)
    {
      Window window;
      vtkSmartPointer<vtkMapper> mapper;
      if (k == 0)
      {
        vtkNew<vtkPolyDataMapper> stock;
        stock->SetInputData(mesh);
        mapper = stock;
      }
      else
      {
        vtkNew<vtkPointSplatMapper> splats;
        splats->SetMethodToImageSpace();
        splats->SetInputData(RandomSphere(400000));
        mapper = splats;
      }
      vtkActor* actor = window.Add(mapper);
      // The sphere of the mesh has half the radius.
      actor->SetScale(k == 0 ? 2.0 : 1.0);
      window.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      window.Renderer->ResetCamera(-1, 1, -1, 1, -1, 1);
      pictures[k] = window.Draw();
    }
    const std::string kind = parallel ? "parallel" : "perspective";
    const double psnr = Psnr(pictures[0], pictures[1]);
    std::cout << "a dense sphere, " << kind << ": " << psnr << " dB\n";
    // Points mark the pixel that they fall in, even at its rim: there are 421 and 461 more.
    checks.AtLeast(psnr, parallel ? 38.0 : 34.0, "a dense sphere against its mesh, " + kind);
    checks.AtMost(
      CountDifferentCoverage(pictures[0], pictures[1]), 500, "outline of a dense sphere");
  }
}

void TestHoles(Checks& checks)
{
  // Fewer and fewer points; no pixel well inside may show the background, or the far side,
  // which is dark here: its normals point away, and it is culled from no picture.
  for (const int count : { 200000, 40000, 10000, 2500 })
  {
    Window window;
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetMethodToImageSpace();
    mapper->SetInputData(RandomSphere(count));
    window.Add(mapper);
    window.Renderer->ResetCamera();
    const Picture picture = window.Draw();
    const double spacing = mapper->GetProjectedSpacing();
    const std::vector<double> depth = window.Depth();
    const vtkCamera* camera = window.Renderer->GetActiveCamera();
    const double distance = const_cast<vtkCamera*>(camera)->GetDistance();
    const double angle = const_cast<vtkCamera*>(camera)->GetViewAngle() * M_PI / 180.0;
    const double radius = 0.5 * Size * std::tan(std::asin(1.0 / distance)) / std::tan(0.5 * angle);
    const double within = radius - spacing - 3.0;
    int holes = 0;
    int farSide = 0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        if (std::hypot(x + 0.5 - 0.5 * Size, y + 0.5 - 0.5 * Size) < within)
        {
          holes += picture.IsBackground(x, y);
          farSide += depth[static_cast<size_t>(y * Size + x)] > distance;
        }
      }
    }
    const std::string what = std::to_string(count) + " points, " + std::to_string(spacing) +
      " pixels apart: ";
    std::cout << what << mapper->GetNumberOfFillSteps() << " steps\n";
    checks.AtMost(spacing, 8.0, what + "spacing");
    checks.AtMost(holes, 0, what + "holes");
    checks.AtMost(farSide, 0, what + "pixels of the far side");
  }
}

void TestHolesAtBorder(Checks& checks)
{
  // Close up, the surface fills the window: no pixel may show the background, not even in its
  // corners, five of whose eight neighbours lie outside.
  for (const double zoom : { 2.5, 3.5, 5.0 })
  {
    for (const int projection : { vtkPointSplatMapper::COMPUTE, vtkPointSplatMapper::QUADS })
    {
      Window window;
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetMethodToImageSpace();
      mapper->SetProjection(projection);
      mapper->SetInputData(RandomSphere(40000));
      window.Add(mapper);
      window.Renderer->ResetCamera();
      window.Renderer->GetActiveCamera()->Zoom(zoom);
      const Picture picture = window.Draw();
      int holes = 0;
      for (int y = 0; y < Size; ++y)
      {
        for (int x = 0; x < Size; ++x)
        {
          holes += picture.IsBackground(x, y);
        }
      }
      checks.AtMost(holes, 0,
        "holes at the window's border, points " + std::to_string(mapper->GetProjectedSpacing()) +
          " pixels apart");
    }
  }
}

//------------------------------------------------------------------------------
void TestLayers(Checks& checks)
{
  // Nested shells, the colour of their layers in closed form: unlit, so that only layers count.
  const double radii[3] = { 1.0, 0.7, 0.4 };
  const double opacities[3] = { 0.3, 0.5, 1.0 };
  const double colours[3][3] = { { 0.2, 0.4, 0.9 }, { 0.2, 0.8, 0.3 }, { 0.9, 0.6, 0.2 } };
  for (const bool mixed : { false, true })
  {
    Window window;
    vtkNew<vtkPointSplatMapper> mappers[3];
    for (int k = 0; k < 3; ++k)
    {
      // Mixed: one of the shells is splatted, in the same layers.
      if (!mixed || k != 1)
      {
        mappers[k]->SetMethodToImageSpace();
      }
      mappers[k]->SetInputData(RandomSphere(mixed && k == 1 ? 20000 : 300000));
      vtkActor* actor = window.Add(mappers[k]);
      actor->SetScale(radii[k]);
      actor->GetProperty()->SetColor(colours[k][0], colours[k][1], colours[k][2]);
      actor->GetProperty()->SetOpacity(opacities[k]);
      actor->GetProperty()->LightingOff();
      actor->GetProperty()->SetAmbient(1.0);
      actor->GetProperty()->SetDiffuse(0.0);
      actor->GetProperty()->SetSpecular(0.0);
    }
    window.Renderer->GetActiveCamera()->ParallelProjectionOn();
    window.Renderer->ResetCamera(-1, 1, -1, 1, -1, 1);
    const Picture picture = window.Draw();
    const double perUnit = 0.5 * Size / window.Renderer->GetActiveCamera()->GetParallelScale();
    int checked = 0;
    int wrong = 0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const double r = std::hypot(x + 0.5 - 0.5 * Size, y + 0.5 - 0.5 * Size) / perUnit;
        bool nearOutline = r > 1.0;
        std::vector<int> crossed;
        for (int k = 0; k < 3; ++k)
        {
          nearOutline = nearOutline || std::abs(r - radii[k]) < 5.0 / perUnit;
          if (r < radii[k])
          {
            crossed.push_back(k);
          }
        }
        if (nearOutline)
        {
          continue;
        }
        const std::vector<int> front = crossed;
        crossed.insert(crossed.end(), front.rbegin(), front.rend());
        double colour[3] = { 0.0, 0.0, 0.0 };
        double light = 1.0;
        for (const int k : crossed)
        {
          for (int c = 0; c < 3; ++c)
          {
            colour[c] += light * opacities[k] * colours[k][c];
          }
          light *= 1.0 - opacities[k];
        }
        ++checked;
        for (int c = 0; c < 3; ++c)
        {
          if (std::abs(picture.At(x, y)[c] - 255.0 * colour[c]) > 2.0)
          {
            ++wrong;
            break;
          }
        }
      }
    }
    const std::string kind = mixed ? "with a splatted shell" : "image-space shells";
    std::cout << kind << ": " << wrong << " of " << checked << " pixels wrong, "
              << mappers[0]->GetNumberOfLayersDrawn() << " layers\n";
    checks.AtLeast(checked, 12000, kind + ": pixels checked");
    checks.AtMost(mappers[0]->GetNumberOfLayersDrawn(), 6, kind + ": layers");
    checks.AtMost(wrong, 0, kind + ": pixels that differ from the closed form");
  }
}

//------------------------------------------------------------------------------
void TestNothingEstimated(Checks& checks)
{
  // Without sizes none are made, and points may change each frame; a switch to splats makes them.
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetMethodToImageSpace();
  vtkSmartPointer<vtkPolyData> cloud = RandomSphere(50000);
  mapper->SetInputData(cloud);
  window.Add(mapper);
  window.Renderer->ResetCamera();
  const int drawn = window.Draw().CountDrawn();
  checks.AtMost(mapper->GetLayerDistanceUsed(), 0.2, "layer distance of points");
  checks.AtLeast(mapper->GetLayerDistanceUsed(), 1e-4, "layer distance of points");
  for (int frame = 1; frame <= 3; ++frame)
  {
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      double p[3];
      cloud->GetPoint(i, p);
      cloud->GetPoints()->SetPoint(i, 0.9 * p[0], 0.9 * p[1], 0.9 * p[2]);
    }
    cloud->GetPoints()->Modified();
    cloud->Modified();
    const double expected = drawn * std::pow(0.81, frame);
    const int now = window.Draw().CountDrawn();
    checks.Expect(std::abs(now - expected) < 0.05 * drawn,
      "a sphere that shrinks covers " + std::to_string(now) + " pixels, not " +
        std::to_string(expected));
  }
  mapper->SetMethodToTwoPass();
  checks.AtLeast(window.Draw().CountDrawn(), drawn / 3, "splats after image space");
  checks.Expect(std::string(mapper->GetMethodUsed()) == "two-pass", "two passes after image space");
}
}

int TestSplatsImageSpace(int, char*[])
{
  Checks checks;
  TestFillings(checks, false, 20);
  TestFillings(checks, true, 10);
  TestProjections(checks);
  TestLikeMesh(checks);
  TestHoles(checks);
  TestHolesAtBorder(checks);
  TestLayers(checks);
  TestNothingEstimated(checks);
  return checks.Result();
}
