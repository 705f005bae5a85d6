// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Splats in the pipelines that users have: blocks, viewports, windows, clipping, far
// coordinates, other actors, passes, both projections.
#include "SplatPassChain.h"
#include "SplatScene.h"

#include "vtkAssembly.h"
#include "vtkCameraPass.h"
#include "vtkCubeSource.h"
#include "vtkEDLShading.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPointSplatPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWindowToImageFilter.h"

namespace
{
using namespace SplatScene;

vtkSmartPointer<vtkPointSplatMapper> Splats(vtkPolyData* cloud)
{
  auto mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
  mapper->SetInputData(cloud);
  return mapper;
}

vtkSmartPointer<vtkPolyDataMapper> Mesh(vtkPolyData* mesh)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(mesh);
  return mapper;
}

vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* data, double x, double y, double z, bool precise)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(x, y, z);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(data);
  filter->SetTransform(transform);
  filter->SetOutputPointsPrecision(precise ? vtkAlgorithm::DOUBLE_PRECISION
                                           : vtkAlgorithm::SINGLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

Picture DrawOne(vtkMapper* mapper, const std::function<void(Window&, vtkActor*)>& change)
{
  Window window;
  vtkActor* actor = window.Add(mapper);
  window.Renderer->ResetCamera();
  change(window, actor);
  window.Renderer->ResetCameraClippingRange();
  return window.Draw();
}

void Same(Checks& checks, const std::string& name, const Picture& a, const Picture& b,
  double psnr, int coverage)
{
  checks.AtLeast(a.CountDrawn(), 500, name + ": drawn");
  checks.AtLeast(Psnr(a, b), psnr, name + ": psnr");
  checks.AtMost(CountDifferentCoverage(a, b), coverage, name + ": outline");
}
}

int TestSplatsInPipelines(int, char*[])
{
  Checks checks;
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh();
  vtkSmartPointer<vtkPolyData> cloud = Cloud(mesh);
  auto nothing = [](Window&, vtkActor*) {};
  const Picture alone = DrawOne(Splats(cloud), nothing);

  // Both projections draw the same.
  {
    vtkSmartPointer<vtkPointSplatMapper> quads = Splats(cloud);
    quads->SetProjectionToQuads();
    Same(checks, "quads", alone, DrawOne(quads, nothing), 50.0, 0);
    checks.Expect(std::string(quads->GetProjectionUsed()) == "quads", "quads were not used");
  }
  // Blocks.
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, Moved(cloud, -1, 0, 0, false));
    blocks->SetBlock(2, Moved(cloud, 1, 0, 0, false));
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputDataObject(blocks);
    double bounds[6];
    mapper->GetBounds(bounds);
    checks.Expect(std::abs(bounds[0] + 1.5) < 0.01 && std::abs(bounds[1] - 1.5) < 0.01,
      "blocks: bounds");
    Window two;
    two.Add(Splats(Moved(cloud, -1, 0, 0, false)));
    two.Add(Splats(Moved(cloud, 1, 0, 0, false)));
    two.Renderer->ResetCamera();
    Same(checks, "blocks as two actors", two.Draw(), DrawOne(mapper, nothing), 50.0, 0);
    // Each by its own scalars.
    for (const int block : { 0, 2 })
    {
      vtkNew<vtkFloatArray> values;
      values->SetNumberOfTuples(cloud->GetNumberOfPoints());
      values->Fill(block);
      vtkPolyData::SafeDownCast(blocks->GetBlock(block))->GetPointData()->SetScalars(values);
    }
    mapper->SetScalarRange(0, 2);
    const Picture coloured = DrawOne(mapper, nothing);
    const unsigned char* red = coloured.At(Size / 4, Size / 2);
    const unsigned char* blue = coloured.At(3 * Size / 4, Size / 2);
    checks.Expect(red[0] > red[2] + 100 && blue[2] > blue[0] + 100,
      "blocks with scalars have each other's colours");
  }
  // Far coordinates, a millimetre between points: as at the origin.
  {
    vtkSmartPointer<vtkPolyData> small = Moved(cloud, 0, 0, 0, true);
    for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
    {
      double p[3];
      small->GetPoint(i, p);
      small->GetPoints()->SetPoint(i, 0.1 * p[0], 0.1 * p[1], 0.1 * p[2]);
    }
    const Picture here = DrawOne(Splats(small), nothing);
    const Picture far = DrawOne(Splats(Moved(small, 5e5, 4e6, 200, true)), nothing);
    Same(checks, "UTM coordinates", here, far, 60.0, 0);
  }
  // Clipping planes, against the mesh clipped by the same.
  {
    auto clip = [](Window&, vtkActor* actor) {
      const double normals[2][3] = { { 1, 0.3, 0 }, { 0, 1, 0.5 } };
      for (const auto& normal : normals)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(-0.1, -0.1, 0);
        plane->SetNormal(normal[0], normal[1], normal[2]);
        actor->GetMapper()->AddClippingPlane(plane);
      }
    };
    Same(checks, "clipping planes", DrawOne(Mesh(mesh), clip), DrawOne(Splats(cloud), clip), 42.0, 10);
  }
  // Inside an assembly, and two actors with one mapper.
  {
    Window window;
    vtkSmartPointer<vtkPointSplatMapper> mapper = Splats(cloud);
    mapper->AntiAliasingOff(); // as Window::Add() does
    vtkNew<vtkAssembly> assembly;
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(1.2 * i, 0, 0);
      assembly->AddPart(actor);
    }
    assembly->SetScale(0.5);
    window.Renderer->AddActor(assembly);
    window.Renderer->ResetCamera();
    Window meshes;
    vtkNew<vtkAssembly> other;
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkActor> actor;
      actor->SetMapper(Mesh(mesh));
      actor->SetPosition(1.2 * i, 0, 0);
      other->AddPart(actor);
    }
    other->SetScale(0.5);
    meshes.Renderer->AddActor(other);
    meshes.Renderer->ResetCamera();
    Same(checks, "assembly", meshes.Draw(), window.Draw(), 43.0, 30);
  }
  // Viewports, resizing, and a second window that outlives the first.
  {
    vtkSmartPointer<vtkPointSplatMapper> mapper = Splats(cloud);
    {
      Window first;
      first.Add(mapper);
      vtkNew<vtkRenderer> second;
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      second->AddActor(actor);
      first.Win->AddRenderer(second);
      first.Renderer->SetViewport(0, 0, 0.5, 1);
      second->SetViewport(0.5, 0, 1, 1);
      const Picture both = first.Draw();
      int left = 0, right = 0;
      for (int y = 0; y < Size; ++y)
      {
        for (int x = 0; x < Size; ++x)
        {
          (x < Size / 2 ? left : right) += !both.IsBackground(x, y);
        }
      }
      checks.AtLeast(left, 5000, "left viewport");
      checks.AtMost(std::abs(left - right), 200, "viewports draw the same");
      first.Win->SetSize(2 * Size, Size);
      // The view angle is vertical: wider viewports show the spheres as large.
      checks.AtMost(std::abs(first.Draw().CountDrawn() - left - right), 200, "after resizing");
      Window other;
      other.Add(mapper);
      Same(checks, "second window", alone, other.Draw(), 50.0, 0);
      mapper->ReleaseGraphicsResources(other.Win);
      mapper->ReleaseGraphicsResources(other.Win);
      Same(checks, "after release", alone, other.Draw(), 50.0, 0);
    }
    Same(checks, "after the first window", alone, DrawOne(mapper, nothing), 50.0, 0);
  }
  // Among ordinary actors, in either order, and in depth.
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.45, 0.1, 0.1);
    cube->SetXLength(0.6);
    cube->SetYLength(0.3);
    cube->SetZLength(1.2);
    cube->Update();
    auto draw = [&](bool splats, bool first) {
      Window window;
      vtkSmartPointer<vtkMapper> sphere =
        splats ? vtkSmartPointer<vtkMapper>(Splats(cloud)) : vtkSmartPointer<vtkMapper>(Mesh(mesh));
      if (first)
      {
        window.Add(sphere);
      }
      window.Add(Mesh(cube->GetOutput()))->GetProperty()->SetColor(0.2, 0.4, 1);
      if (!first)
      {
        window.Add(sphere);
      }
      window.Renderer->ResetCamera();
      return window.Draw();
    };
    const Picture reference = draw(false, true);
    Same(checks, "beside a mesh", reference, draw(true, true), 43.0, 24);
    Same(checks, "order of actors", draw(true, true), draw(true, false), 60.0, 0);
  }
  // More actors than the tags of coded depths can tell apart.
  {
    Window many, one;
    for (int i = 0; i < 70; ++i)
    {
      vtkActor* actor = many.Add(Splats(cloud));
      actor->SetPosition(1.1 * (i % 10), 1.1 * (i / 10), 0);
      vtkActor* other = one.Add(Mesh(mesh));
      other->SetPosition(actor->GetPosition());
    }
    many.Renderer->ResetCamera();
    one.Renderer->ResetCamera();
    Same(checks, "70 actors", one.Draw(), many.Draw(), 32.0, 600);
  }
  // A translucent actor: the front and the back of the sphere, each at its opacity.
  {
    auto translucent = [](Window& window, vtkActor* actor) {
      actor->GetProperty()->SetOpacity(0.5);
      actor->GetProperty()->LightingOff();
      actor->GetProperty()->SetColor(1, 1, 1);
      actor->GetProperty()->SetAmbient(1);
      actor->GetProperty()->SetDiffuse(0);
      window.Renderer->SetBackground(0, 0.4, 0);
    };
    const Picture picture = DrawOne(Splats(cloud), translucent);
    const unsigned char* centre = picture.At(Size / 2, Size / 2);
    checks.AtMost(std::abs(centre[0] - 191), 2, "translucent: red");
    checks.AtMost(std::abs(centre[1] - 217), 2, "translucent: green");
  }
  // In pass chains: the default steps with ambient occlusion, and the pass by itself.
  {
    auto occluded = [](Window& window, vtkActor*) {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAOPass> ssao;
      ssao->SetRadius(0.2);
      ssao->SetKernelSize(32);
      ssao->SetDelegatePass(steps);
      vtkOpenGLRenderer::SafeDownCast(window.Renderer)->SetPass(ssao);
    };
    Same(checks, "ambient occlusion", DrawOne(Mesh(mesh), occluded),
      DrawOne(Splats(cloud), occluded), 45.0, 16);
    auto smoothed = [](Window& window, vtkActor*) { window.Renderer->UseFXAAOn(); };
    Same(checks, "FXAA", DrawOne(Mesh(mesh), smoothed), DrawOne(Splats(cloud), smoothed), 48.0, 16);
    auto sampled = [](Window& window, vtkActor*) { window.Win->SetMultiSamples(8); };
    Same(checks, "multisampled window", alone, DrawOne(Splats(cloud), sampled), 60.0, 0);
    auto lit = [](Window& window, vtkActor*) {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkEDLShading> edl;
      edl->SetDelegatePass(steps);
      window.Renderer->SetPass(edl);
    };
    Same(checks, "eye-dome lighting", DrawOne(Mesh(mesh), lit), DrawOne(Splats(cloud), lit), 46.0, 300);
    auto byPass = [](Window& window, vtkActor*) { DrawByPass(window); };
    Same(checks, "by the pass", alone, DrawOne(Splats(cloud), byPass), 60.0, 0);
    checks.AtMost(DrawOne(Mesh(mesh), byPass).CountDrawn(), 0, "the pass draws no meshes");
    // What the pass wants holds while it draws, and the mappers' own settings stay.
    vtkNew<vtkPointSplatPass> imposing;
    auto byImposingPass = [&imposing](Window& window, vtkActor* actor) {
      actor->GetProperty()->SetOpacity(0.5);
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkRenderPassCollection> passes;
      passes->AddItem(lights);
      passes->AddItem(imposing);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(passes);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      window.Renderer->SetPass(camera);
    };
    imposing->SetMaximumNumberOfLayers(1);
    imposing->SetTransparencyToPeeling();
    imposing->SetLayerDistance(0.25);
    imposing->SetTargetError(0.125);
    imposing->SetMethodToTwoPass();
    vtkSmartPointer<vtkPointSplatMapper> imposed = Splats(cloud);
    imposed->SetMethodToImageSpace();
    const Picture layer = DrawOne(imposed, byImposingPass);
    checks.AtLeast(layer.CountDrawn(), 1000, "translucent by the pass");
    checks.Expect(imposing->GetNumberOfLayersDrawn() == 1 && imposing->GetNumberOfRenderedProps() == 1,
      "the pass' number of layers");
    checks.Expect(std::string(imposed->GetMethodUsed()) == "two-pass" &&
        imposed->GetLayerDistanceUsed() == 0.25 &&
        std::string(imposed->GetChoices()).find("error allowed: 1/8") != std::string::npos,
      "what the pass wanted: " + std::string(imposed->GetChoices()));
    checks.Expect(imposed->GetMethod() == vtkPointSplatMapper::IMAGE_SPACE &&
        imposed->GetTransparency() == vtkPointSplatMapper::AUTOMATIC_TRANSPARENCY &&
        imposed->GetMaximumNumberOfLayers() == 32 && imposed->GetLayerDistance() == 0.0 &&
        imposed->GetTargetError() == 1.0 / 256.0,
      "the mapper's settings after the pass");
    imposed->SetMethodToAutomatic();
    DrawOne(imposed, [](Window&, vtkActor* actor) { actor->GetProperty()->SetOpacity(0.5); });
    checks.Expect(imposed->GetNumberOfLayersDrawn() == 2, "the mapper's layers after the pass");
  }
  // A picture in tiles is the picture of a larger window.
  {
    auto tiled = [&](vtkMapper* mapper) {
      Window window;
      window.Add(mapper);
      window.Renderer->ResetCamera();
      window.Draw();
      vtkNew<vtkWindowToImageFilter> filter;
      filter->SetInput(window.Win);
      filter->SetScale(2);
      filter->ReadFrontBufferOff();
      filter->Update();
      vtkImageData* image = filter->GetOutput();
      Picture picture;
      picture.Width = image->GetDimensions()[0];
      picture.Height = image->GetDimensions()[1];
      const unsigned char* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
      picture.Pixels.assign(pixels, pixels + 3 * picture.Width * picture.Height);
      return picture;
    };
    Same(checks, "tiles", tiled(Mesh(mesh)), tiled(Splats(cloud)), 43.0, 100);
  }
  // Data that changes is followed.
  {
    Window window;
    vtkSmartPointer<vtkPolyData> changing = Moved(cloud, 0, 0, 0, false);
    window.Add(Splats(changing));
    window.Renderer->ResetCamera();
    const int before = window.Draw().CountDrawn();
    for (vtkIdType i = 0; i < changing->GetNumberOfPoints(); ++i)
    {
      double p[3];
      changing->GetPoint(i, p);
      changing->GetPoints()->SetPoint(i, 0.5 * p[0], 0.5 * p[1], 0.5 * p[2]);
    }
    changing->GetPoints()->Modified();
    changing->Modified();
    const int after = window.Draw().CountDrawn();
    checks.AtMost(after, before / 3, "points that moved");
  }
  return checks.Result();
}
