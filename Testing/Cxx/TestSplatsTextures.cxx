// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures, normal maps and anisotropy on splats must look as on the mesh of the same points drawn by
// stock VTK.
#include "SplatScene.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataTangents.h"
#include "vtkTexture.h"
#include "vtkTexturedSphereSource.h"
#include "vtkTransform.h"
#include "vtkTriangleFilter.h"

namespace
{
using namespace SplatScene;

// What pictures must reach, dB.
constexpr double LeastPsnr = 38.0;

using Colour = std::function<void(double u, double v, unsigned char* rgba)>;
using Change = std::function<void(vtkRenderer*, vtkActor*)>;

vtkSmartPointer<vtkTexture> MakeTexture(int size, int components, const Colour& colour)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      unsigned char rgba[4] = { 0, 0, 0, 255 };
      colour((x + 0.5) / size, (y + 0.5) / size, rgba);
      std::copy_n(
        rgba, components, static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0)));
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

unsigned char Byte(double value)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::min(std::max(value, 0.0), 1.0)));
}

/// Waves of different lengths in each channel, the shortest of a sixteenth of the width.
vtkSmartPointer<vtkTexture> MakeWaves(int components = 3)
{
  return MakeTexture(256, components, [components](double u, double v, unsigned char* p) {
    p[0] = Byte(0.5 + 0.5 * std::sin(2 * M_PI * 8 * u) * std::cos(2 * M_PI * 5 * v));
    p[1] = Byte(0.5 + 0.4 * std::sin(2 * M_PI * (3 * u + 4 * v)));
    p[2] = Byte(0.5 + 0.4 * std::cos(2 * M_PI * 16 * v));
    p[3] = components == 4 ? Byte(0.5 + 0.5 * std::sin(2 * M_PI * 4 * u)) : 255;
    if (components == 2)
    {
      p[1] = 255;
    }
  });
}

vtkSmartPointer<vtkPolyData> MakePlane(int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(resolution, resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeGlobe(int resolution = 100)
{
  vtkNew<vtkTexturedSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution / 2);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithTangents(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  tangents->Update();
  return tangents->GetOutput();
}

/// Points and what is of points, without cells.
vtkSmartPointer<vtkPolyData> PointsOf(vtkPolyData* mesh)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(mesh->GetPoints());
  cloud->GetPointData()->ShallowCopy(mesh->GetPointData());
  return cloud;
}

Picture Draw(vtkMapper* mapper, vtkDataObject* data, const Change& change)
{
  Window window;
  mapper->SetInputDataObject(data);
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetDiffuse(0.9);
  window.Win->AlphaBitPlanesOn();
  window.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.1, 0.1);
  window.Renderer->GetActiveCamera()->Zoom(1.4);
  change(window.Renderer, actor);
  window.Renderer->ResetCameraClippingRange(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  return window.Draw();
}

Picture Compare(Checks& checks, const std::string& name, vtkPolyData* mesh, const Change& change,
  double least = LeastPsnr)
{
  const Picture wanted = Draw(vtkNew<vtkPolyDataMapper>(), mesh, change);
  const Picture picture = Draw(vtkNew<vtkPointSplatMapper>(), PointsOf(mesh), change);
  const Picture plain =
    Draw(vtkNew<vtkPolyDataMapper>(), mesh, [&change](vtkRenderer* r, vtkActor* a) {
      change(r, a);
      a->SetTexture(nullptr);
      a->GetProperty()->RemoveAllTextures();
      a->GetProperty()->SetAnisotropy(0.0);
    });
  checks.AtLeast(Psnr(wanted, picture), least, name + ": psnr");
  checks.AtMost(Psnr(wanted, plain), 30.0, name + ": without textures, psnr");
  return picture;
}

const Change FromTheSide = [](vtkRenderer* r, vtkActor*) {
  r->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  r->GetActiveCamera()->SetPosition(3.0, 0.9, 0.8); // the seam is before the middle
  r->GetActiveCamera()->SetViewUp(0, 0, 1);
};

/// Nothing of the border is seen, which points without cells do not know.
const Change Inside = [](vtkRenderer* r, vtkActor*) { r->GetActiveCamera()->Zoom(1.2); };

void TestColours(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> waves = MakeWaves();
  const Change set = [&waves](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(waves);
    Inside(r, a);
  };
  Compare(checks, "plane", MakePlane(40), set);
  Compare(checks, "globe", MakeGlobe(), [&](vtkRenderer* r, vtkActor* a) {
    set(r, a);
    FromTheSide(r, a);
  });
  // Filters must not take the seam, nor what lies behind outlines, for a change of coordinates.
  const vtkSmartPointer<vtkTexture> smaller = MakeWaves();
  smaller->MipmapOn();
  Compare(checks, "globe with mipmaps", MakeGlobe(), [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(smaller);
    FromTheSide(r, a);
  });
  // Coarser points than waves, since coordinates are linear.
  Compare(checks, "coarse", MakePlane(12), set);
  Compare(checks, "turned", MakePlane(40), [&](vtkRenderer* r, vtkActor* a) {
    set(r, a);
    r->GetActiveCamera()->Elevation(-65);
    r->GetActiveCamera()->Zoom(2.4);
  });
  for (const int components : { 1, 2, 4 })
  {
    const vtkSmartPointer<vtkTexture> others = MakeWaves(components);
    Compare(checks, std::to_string(components) + " components", MakePlane(40),
      [&](vtkRenderer* r, vtkActor* a) {
        a->SetTexture(others);
        Inside(r, a);
      });
  }
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 3.0, 1.0);
  transform->RotateZ(20);
  const vtkSmartPointer<vtkTexture> moved = MakeWaves();
  moved->SetTransform(transform);
  Compare(checks, "transform", MakePlane(40), [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(moved);
    Inside(r, a);
  });
  const vtkSmartPointer<vtkTexture> clear = MakeWaves(4);
  Compare(checks, "translucent", MakeGlobe(), [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(clear);
    a->GetProperty()->SetOpacity(0.7);
    FromTheSide(r, a);
    r->UseDepthPeelingOn();
    r->SetOcclusionRatio(0.0);
    r->SetMaximumNumberOfPeels(20);
  }, 34.0);
}

/// Fine stripes that repeat, much finer than pixels farther off: they must be even grey there.
void TestMinified(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> stripes =
    MakeTexture(64, 3, [](double u, double v, unsigned char* p) {
      p[0] = p[1] = p[2] = (int(16 * u) + int(16 * v)) % 2 ? 240 : 30;
    });
  stripes->RepeatOn();
  stripes->MipmapOn();
  // What a filter does at flat angles is each driver's own.
  stripes->SetMaximumAnisotropicFiltering(1.0f);
  vtkSmartPointer<vtkPolyData> plane = MakePlane(60);
  vtkDataArray* at = plane->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < at->GetNumberOfTuples(); ++i)
  {
    at->SetTuple2(i, 24.0 * at->GetComponent(i, 0), 24.0 * at->GetComponent(i, 1));
  }
  Compare(checks, "minified", plane, [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(stripes);
    r->GetActiveCamera()->Elevation(-70);
    r->GetActiveCamera()->Zoom(3.6);
  });
}

/// Two charts meet in the middle, where coordinates jump, and texels beside them belong to neither.
void TestCharts(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> atlas =
    MakeTexture(256, 3, [](double u, double v, unsigned char* p) {
      const double x = u < 0.4 ? u : u - 0.6;
      const bool gutter = u > 0.42 && u < 0.58;
      p[0] = gutter ? 255 : Byte(0.5 + 0.4 * std::sin(30 * x));
      p[1] = gutter ? 0 : Byte(u);
      p[2] = gutter ? 0 : Byte(0.5 + 0.4 * std::sin(20 * v));
    });
  atlas->RepeatOff();
  vtkNew<vtkAppendPolyData> halves;
  for (int side = 0; side < 2; ++side)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(side == 0 ? -0.5 : 0.0, -0.5, 0.0);
    source->SetPoint1(side == 0 ? 0.0 : 0.5, -0.5, 0.0);
    source->SetPoint2(side == 0 ? -0.5 : 0.0, 0.5, 0.0);
    source->SetResolution(20, 40);
    source->Update();
    vtkDataArray* at = source->GetOutput()->GetPointData()->GetTCoords();
    for (vtkIdType i = 0; i < at->GetNumberOfTuples(); ++i)
    {
      at->SetComponent(i, 0, side == 0 ? 0.4 * at->GetComponent(i, 0)
                                       : 1.0 - 0.4 * at->GetComponent(i, 0));
    }
    halves->AddInputData(source->GetOutput());
  }
  halves->Update();
  Compare(checks, "charts", halves->GetOutput(), [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(atlas);
    Inside(r, a);
  });
}

void SetPhysical(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPBR();
  property->SetColor(0.9, 0.9, 0.9);
  property->SetMetallic(0.8);
  property->SetRoughness(0.7);
}

void TestPhysical(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> albedo = MakeWaves();
  albedo->UseSRGBColorSpaceOn();
  const vtkSmartPointer<vtkTexture> material =
    MakeTexture(128, 3, [](double u, double v, unsigned char* p) {
      p[0] = Byte(0.6 + 0.4 * std::sin(25 * u));
      p[1] = Byte(0.6 + 0.4 * std::sin(18 * v));
      p[2] = Byte(0.5 + 0.5 * std::sin(14 * (u + v)));
    });
  const vtkSmartPointer<vtkTexture> glow =
    MakeTexture(128, 3, [](double u, double v, unsigned char* p) {
      p[0] = Byte(0.3 + 0.3 * std::sin(40 * u));
      p[2] = Byte(0.2 + 0.2 * std::sin(35 * v));
    });
  glow->UseSRGBColorSpaceOn();
  const vtkSmartPointer<vtkPolyData> globe = WithTangents(MakeGlobe(160));
  Compare(checks, "physical", globe, [&](vtkRenderer* r, vtkActor* a) {
    SetPhysical(a);
    a->GetProperty()->SetBaseColorTexture(albedo);
    a->GetProperty()->SetORMTexture(material);
    a->GetProperty()->SetEmissiveTexture(glow);
    a->GetProperty()->SetOcclusionStrength(0.7);
    a->GetProperty()->SetEmissiveFactor(0.9, 0.5, 0.8);
    FromTheSide(r, a);
  });
  const vtkSmartPointer<vtkTexture> bumps =
    MakeTexture(256, 3, [](double u, double v, unsigned char* p) {
      p[0] = Byte(0.5 + 0.2 * std::sin(50 * u));
      p[1] = Byte(0.5 + 0.2 * std::sin(40 * v));
      p[2] = 235;
    });
  Compare(checks, "normals", globe, [&](vtkRenderer* r, vtkActor* a) {
    SetPhysical(a);
    a->GetProperty()->SetNormalTexture(bumps);
    a->GetProperty()->SetNormalScale(0.8);
    FromTheSide(r, a);
  });
  const vtkSmartPointer<vtkTexture> brushed =
    MakeTexture(128, 3, [](double u, double v, unsigned char* p) {
      p[0] = Byte(0.7 + 0.3 * std::sin(20 * u));
      p[1] = Byte(0.5 + 0.4 * std::sin(15 * v));
    });
  for (const bool lights : { false, true })
  {
    Compare(checks, lights ? "anisotropy by lights" : "anisotropy", globe,
      [&](vtkRenderer* r, vtkActor* a) {
        SetPhysical(a);
        a->GetProperty()->SetRoughness(0.4);
        a->GetProperty()->SetAnisotropy(0.9);
        a->GetProperty()->SetAnisotropyRotation(0.3);
        a->GetProperty()->SetAnisotropyTexture(brushed);
        a->GetProperty()->SetCoatStrength(0.5);
        a->GetProperty()->SetCoatNormalTexture(bumps);
        FromTheSide(r, a);
        if (lights)
        {
          vtkNew<vtkLight> light;
          light->SetLightTypeToSceneLight();
          light->SetPosition(3, -2, 3);
          r->AddLight(light);
        }
      });
  }
}

/// Of one large splat, opaque and translucent: a ring of the edges' colour and width.
void TestEdges(Checks& checks)
{
  constexpr double radius = 0.3;
  constexpr double width = 6.0;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0, 0, 1);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  radii->InsertNextValue(radius);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  cloud->GetPointData()->AddArray(radii);
  for (const double tilt : { 0.0, 60.0 })
  {
    for (const double opacity : { 1.0, 0.6 })
    {
      const std::string label = "edge, tilted by " + std::to_string(int(tilt)) + ", opacity " +
        std::to_string(opacity);
      const Picture picture =
        Draw(vtkNew<vtkPointSplatMapper>(), cloud, [&](vtkRenderer* r, vtkActor* a) {
          a->GetProperty()->EdgeVisibilityOn();
          a->GetProperty()->SetEdgeColor(0, 1, 0);
          a->GetProperty()->SetColor(1, 0, 0);
          a->GetProperty()->SetSpecular(0.0);
          a->GetProperty()->SetLineWidth(width);
          a->GetProperty()->SetOpacity(opacity);
          r->GetActiveCamera()->ParallelProjectionOn();
          r->GetActiveCamera()->SetParallelScale(0.5);
          r->GetActiveCamera()->Elevation(tilt);
        });
      // From the middle upwards: where it is green, and how much of it.
      double sum = 0.0;
      double moment = 0.0;
      for (int y = Size / 2; y < Size; ++y)
      {
        const double green = picture.At(Size / 2, y)[1] / (255.0 * opacity);
        sum += green;
        moment += green * (y + 0.5 - Size / 2);
      }
      const double wanted = radius * Size * std::cos(tilt * M_PI / 180);
      checks.AtMost(std::abs(sum - width), 0.7, label + ": width is off by");
      checks.AtMost(std::abs(moment / sum - wanted), 0.7, label + ": radius is off by");
    }
  }
}

/// Blocks with texture coordinates beside one without; lists by the processor and by the device.
void TestBlocks(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> waves = MakeWaves();
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkAppendPolyData> all;
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-0.5 + i / 3.0, -0.5, 0.0);
    source->SetPoint1(-0.5 + (i + 1) / 3.0, -0.5, 0.0);
    source->SetPoint2(-0.5 + i / 3.0, 0.5, 0.0);
    source->SetResolution(15, 45);
    source->Update();
    all->AddInputData(source->GetOutput());
    vtkSmartPointer<vtkPolyData> block = PointsOf(source->GetOutput());
    if (i == 2)
    {
      block->GetPointData()->SetTCoords(nullptr);
    }
    blocks->SetBlock(static_cast<unsigned int>(i), block);
  }
  all->Update();
  const Change set = [&](vtkRenderer* r, vtkActor* a) {
    a->SetTexture(waves);
    Inside(r, a);
  };
  const Picture wanted = Draw(vtkNew<vtkPolyDataMapper>(), all->GetOutput(), set);
  Picture pictures[2];
  for (int lists = 0; lists < 2; ++lists)
  {
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetTileLists(1 + lists);
    pictures[lists] = Draw(mapper, blocks, set);
  }
  checks.AtMost(LargestDifference(pictures[0], pictures[1]), 0, "blocks by the device: difference");
  double sum = 0.0;
  int white = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size / 2; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum += std::pow(double(wanted.At(x, y)[c]) - pictures[0].At(x, y)[c], 2);
      }
    }
    const unsigned char* bare = pictures[0].At(Size - 10, y);
    white += bare[0] == bare[1] && bare[1] == bare[2] && bare[0] > 200;
  }
  checks.AtLeast(-10.0 * std::log10(sum / (1.5 * Size * Size * 255.0 * 255.0)), LeastPsnr,
    "blocks: psnr of those with coordinates");
  checks.AtLeast(white, Size, "block without coordinates: white pixels");
}

/// Outlines of textured surfaces, and of those with edges, are as smooth as others'.
void TestOutlines(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> waves = MakeWaves();
  for (const bool edges : { false, true })
  {
    std::array<std::vector<bool>, 2> smoothed;
    for (const bool looks : { false, true })
    {
      std::array<Picture, 2> pictures;
      for (const bool smooth : { false, true })
      {
        Window window;
        window.SmoothOutlines = smooth;
        vtkNew<vtkPointSplatMapper> mapper;
        mapper->SetInputDataObject(PointsOf(MakeGlobe()));
        vtkActor* actor = window.Add(mapper);
        actor->SetTexture(looks && !edges ? waves.Get() : nullptr);
        actor->GetProperty()->SetEdgeVisibility(looks && edges);
        actor->GetProperty()->SetEdgeColor(1.0, 1.0, 1.0);
        FromTheSide(window.Renderer, actor);
        window.Renderer->ResetCamera();
        pictures[smooth] = window.Draw();
      }
      for (size_t at = 0; at < pictures[0].Pixels.size(); at += 3)
      {
        smoothed[looks].push_back(!std::equal(pictures[0].Pixels.begin() + at,
          pictures[0].Pixels.begin() + at + 3, pictures[1].Pixels.begin() + at));
      }
    }
    const long wanted = std::count(smoothed[0].begin(), smoothed[0].end(), true);
    long both = 0;
    for (size_t at = 0; at < smoothed[0].size(); ++at)
    {
      both += smoothed[0][at] && smoothed[1][at];
    }
    const std::string name = edges ? "edges" : "texture";
    checks.AtLeast(wanted, 100l, name + ": pixels on the plain globe's outline");
    checks.AtLeast(both, wanted * 9 / 10, name + ": of these, smooth");
  }
}
}

int TestSplatsTextures(int, char*[])
{
  Checks checks;
  TestColours(checks);
  TestMinified(checks);
  TestCharts(checks);
  TestPhysical(checks);
  TestEdges(checks);
  TestBlocks(checks);
  TestOutlines(checks);
  return checks.Result();
}
