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
#include "vtkPNGWriter.h"
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

void Save(const Picture& p, std::string name)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(p.Width, p.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(p.Pixels.begin(), p.Pixels.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  for (char& c : name) { c = c == ' ' || c == ',' ? '_' : c; }
  writer->SetFileName(("/tmp/looks/" + name + ".png").c_str());
  writer->Write();
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
  window.Renderer->ResetCameraClippingRange();
  return window.Draw();
}

Picture Compare(Checks& checks, const std::string& name, vtkPolyData* mesh, const Change& change,
  double least = LeastPsnr)
{
  const Picture wanted = Draw(vtkNew<vtkPolyDataMapper>(), mesh, change);
  const Picture picture = Draw(vtkNew<vtkPointSplatMapper>(), PointsOf(mesh), change);
  Save(wanted, name + " mesh");
  Save(picture, name);
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

void TestColours(Checks& checks)
{
  const vtkSmartPointer<vtkTexture> waves = MakeWaves();
  const Change set = [&waves](vtkRenderer*, vtkActor* a) { a->SetTexture(waves); };
  Compare(checks, "plane", MakePlane(40), set);
  Compare(checks, "globe", MakeGlobe(), set);
  Compare(checks, "turned", MakePlane(40), [&](vtkRenderer* r, vtkActor* a) {
    set(r, a);
    r->GetActiveCamera()->Elevation(-65);
    r->GetActiveCamera()->Zoom(1.5);
  });
}
}

int TestSplatsTextures(int, char*[])
{
  Checks checks;
  TestColours(checks);
  return checks.Result();
}
