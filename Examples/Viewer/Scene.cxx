// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Camera.h"
#include "HydrogenVolume.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkImageResample.h"
#include "vtkIsosurfacePoints.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParticleSurfacePoints.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatProjection.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace
{
const std::array<double, 3> palette[] = { { { 0.35, 0.55, 0.95 } }, { { 0.35, 0.80, 0.40 } },
  { { 0.85, 0.55, 0.30 } }, { { 0.8, 0.8, 0.8 } } };

/**
 * The error that says which arrays there are.
 */
UserError NoSuchArray(const std::string& name, const std::string& array, vtkDataSet* data)
{
  std::string all;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const char* one = data->GetPointData()->GetArrayName(i);
    all += (all.empty() ? "; it has " : ", ") + std::string(one ? one : "one without a name");
  }
  return UserError(name + ": has no point array '" + array + "'" + all);
}

void SetLit(Surface& surface, bool lit)
{
  surface.Lit = lit;
  surface.Actor->GetProperty()->SetLighting(lit);
}

/**
 * An actor for a cloud, in the next colour.
 */
Surface& AddSurface(
  Scene& scene, const Options& options, const std::string& name, vtkDataObject* data)
{
  Surface surface;
  surface.Colours = "actor";
  surface.Name = name;
  surface.Mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
  surface.Mapper->SetInputDataObject(data);
  surface.Mapper->ScalarVisibilityOff();
  surface.Mapper->SetRadiusScale(options.RadiusScale);
  surface.Mapper->SetTargetError(options.TargetError);
  if (options.Method == "two-pass")
  {
    surface.Mapper->SetMethodToTwoPass();
  }
  else if (options.Method == "deferred")
  {
    surface.Mapper->SetMethodToDeferred();
  }
  else if (options.Method == "image-space")
  {
    surface.Mapper->SetMethodToImageSpace();
  }
  if (options.Transparency == "peeling")
  {
    surface.Mapper->SetTransparencyToPeeling();
  }
  else if (options.Transparency == "sorted")
  {
    surface.Mapper->SetTransparencyToSorted();
  }
  else if (options.Transparency == "nearest-exact")
  {
    surface.Mapper->SetTransparencyToNearestExact();
  }
  surface.Mapper->SetMaximumNumberOfLayers(options.Layers);
  if (options.Shadows > 0)
  {
    surface.Mapper->ShadowsOn();
    surface.Mapper->SetShadowLightRadius(0.05);
    surface.Mapper->SetNumberOfShadowSamples(options.Shadows);
  }
  if (options.Projection != "automatic")
  {
    surface.Mapper->SetProjection(options.Projection == "quads" ? vtkPointSplatMapper::QUADS
                                                                : vtkPointSplatMapper::COMPUTE);
  }
  surface.Actor = vtkSmartPointer<vtkActor>::New();
  surface.Actor->SetMapper(surface.Mapper);
  const size_t number = scene.Surfaces.size();
  const std::array<double, 3>& colour = options.Colours.empty()
    ? palette[number % 4]
    : options.Colours[number % options.Colours.size()];
  surface.Actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  surface.Actor->GetProperty()->SetSpecular(0.3);
  surface.Actor->GetProperty()->SetSpecularPower(20);
  SetLit(surface, !options.Unlit);
  if (!options.Opacities.empty())
  {
    surface.Actor->GetProperty()->SetOpacity(options.Opacities[number % options.Opacities.size()]);
  }
  scene.Renderer->AddActor(surface.Actor);
  scene.Surfaces.push_back(surface);
  return scene.Surfaces.back();
}

/**
 * A lamp over the camera's left shoulder that stays there when the camera moves, and a faint
 * headlight.
 */
void AddLamp(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* focus = camera->GetFocalPoint();
  const double* back = camera->GetViewPlaneNormal();
  double up[3];
  double right[3];
  double position[3];
  vtkMath::Cross(camera->GetViewUp(), back, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(back, right, up);
  for (int k = 0; k < 3; ++k)
  {
    position[k] = focus[k] - 0.5 * right[k] + 0.7 * up[k] + 0.6 * back[k];
  }
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(position);
  lamp->SetFocalPoint(camera->GetFocalPoint());
  lamp->SetIntensity(0.8);
  renderer->AddLight(lamp);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.35);
  renderer->AddLight(fill);
}

/**
 * Makes the array that is to have isosurfaces the active scalars.
 */
void ChooseScalars(const Options& options, const std::string& name, vtkDataSet* data)
{
  if (!options.Array.empty() &&
    data->GetPointData()->SetActiveScalars(options.Array.c_str()) < 0)
  {
    throw NoSuchArray(name, options.Array, data);
  }
  if (!data->GetPointData()->GetScalars())
  {
    throw UserError(name + ": has no scalars; name an array by --array");
  }
}

/**
 * The active scalars' isosurfaces, one actor each.
 */
void AddIsosurfaces(Scene& scene, const Options& options, const std::string& name, vtkDataSet* data,
  const std::vector<double>& isovalues)
{
  double range[2];
  data->GetPointData()->GetScalars()->GetFiniteRange(range);
  for (double isovalue : isovalues)
  {
    vtkNew<vtkIsosurfacePoints> points;
    points->SetInputData(data);
    points->SetValue(0, isovalue);
    points->SetPointSpacing(options.Spacing);
    ShowProgress(points, "isosurface", options.Quiet);
    points->Update();
    if (points->GetOutput()->GetNumberOfPoints() == 0)
    {
      std::ostringstream text;
      text << name << ": isovalue " << isovalue << " gives no points; the values are from "
           << range[0] << " to " << range[1];
      throw UserError(text.str());
    }
    Surface& surface = AddSurface(scene, options, name, points->GetOutput());
    surface.Isovalue = isovalue;
    surface.Normals = "gradient";
  }
}

void AddVolume(Scene& scene, const Options& options, const std::string& name, vtkImageData* volume)
{
  vtkSmartPointer<vtkImageData> image = volume;
  const int* size = image->GetDimensions();
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
  {
    throw UserError(name + ": is no volume");
  }
  ChooseScalars(options, name, image);
  if (options.Magnify > 1)
  {
    vtkNew<vtkImageResample> resample;
    resample->SetInputData(image);
    resample->SetInterpolationModeToCubic();
    for (int axis = 0; axis < 3; ++axis)
    {
      resample->SetAxisMagnificationFactor(axis, options.Magnify);
    }
    ShowProgress(resample, "magnifying", options.Quiet);
    resample->Update();
    image = resample->GetOutput();
  }
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range);
  std::vector<double> isovalues = options.Isovalues;
  for (int quarter = 1; options.Isovalues.empty() && quarter < 4; ++quarter)
  {
    isovalues.push_back(range[0] + 0.25 * quarter * (range[1] - range[0]));
  }
  AddIsosurfaces(scene, options, name, image, isovalues);
}

/**
 * Colours by the array that the options name, or by RGB scalars.
 */
void ColourPoints(Scene& scene, const Options& options, Surface& surface, vtkDataSet* data)
{
  vtkDataArray* named =
    options.Array.empty() ? nullptr : data->GetPointData()->GetArray(options.Array.c_str());
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  if (named)
  {
    surface.Colours = options.Array;
    surface.Mapper->ScalarVisibilityOn();
    surface.Mapper->SetScalarModeToUsePointFieldData();
    surface.Mapper->SelectColorArray(options.Array.c_str());
    surface.Mapper->SetScalarRange(named->GetFiniteRange());
    surface.Mapper->GetLookupTable()->Build();
    if (options.ScalarBar)
    {
      vtkNew<vtkScalarBarActor> bar;
      bar->SetLookupTable(surface.Mapper->GetLookupTable());
      bar->SetTitle(options.Array.c_str());
      scene.Renderer->AddViewProp(bar);
    }
  }
  else if (vtkUnsignedCharArray::SafeDownCast(scalars) && scalars->GetNumberOfComponents() >= 3 &&
    options.Colours.empty())
  {
    surface.Colours = scalars->GetName() ? scalars->GetName() : "RGB";
    surface.Mapper->ScalarVisibilityOn();
  }
}

vtkSmartPointer<vtkDataSet> Project(vtkDataSet* points, int outliers, bool quiet)
{
  vtkNew<vtkPointSplatProjection> projection;
  projection->SetOutliers(outliers);
  projection->SetInputData(points);
  ShowProgress(projection, "projection", quiet);
  projection->Update();
  return projection->GetOutput();
}

vtkSmartPointer<vtkPointSplatEstimation> Estimate(vtkDataSet* points, bool quiet)
{
  auto estimation = vtkSmartPointer<vtkPointSplatEstimation>::New();
  estimation->SetInputData(points);
  estimation->FillGapsOn();
  ShowProgress(estimation, "normals and splat sizes", quiet);
  estimation->Update();
  return estimation;
}

/// Whether a window does not wait for the points' sizes, and the mapper estimates them while it draws
/// some of the points.
bool AreShownAtOnce(const Options& options, vtkDataSet* points)
{
  constexpr vtkIdType many = vtkIdType(1) << 20;
  return options.InWindow && !options.Project && options.Json.empty() &&
    vtkPointSet::SafeDownCast(points) && points->GetNumberOfPoints() >= many;
}

void AddPoints(Scene& scene, const Options& options, const std::string& name, vtkDataSet* data)
{
  if (!options.Isovalues.empty())
  {
    ChooseScalars(options, name, data);
    AddIsosurfaces(scene, options, name, data, options.Isovalues);
    return;
  }
  if (!options.Array.empty() && !data->GetPointData()->GetArray(options.Array.c_str()))
  {
    throw NoSuchArray(name, options.Array, data);
  }

  if (options.Particles)
  {
    vtkNew<vtkParticleSurfacePoints> particles;
    particles->SetInputData(data);
    particles->SetPointSpacing(options.Spacing);
    ShowProgress(particles, "particles' surface", options.Quiet);
    particles->Update();
    if (particles->GetOutput()->GetNumberOfPoints() == 0)
    {
      throw UserError(name + ": its particles have no surface");
    }
    Surface& surface = AddSurface(scene, options, name, particles->GetOutput());
    surface.Normals = "density";
    ColourPoints(scene, options, surface, particles->GetOutput());
    return;
  }

  std::string normals = "file";
  vtkSmartPointer<vtkDataSet> points = data;
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(data);
  if (options.Normals == "estimate")
  {
    data->GetPointData()->SetNormals(nullptr);
    normals = "estimated";
  }
  else if (!data->GetPointData()->GetNormals() && mesh &&
    mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0)
  {
    vtkNew<vtkPolyDataNormals> fromTriangles;
    fromTriangles->SetInputData(mesh);
    fromTriangles->SplittingOff();
    ShowProgress(fromTriangles, "normals", options.Quiet);
    fromTriangles->Update();
    points = fromTriangles->GetOutput();
    normals = "triangles";
  }
  else if (!data->GetPointData()->GetNormals())
  {
    normals = "estimated";
  }
  // Else here and not in the mapper, so that there are progress bars.
  if (options.Project)
  {
    points = Project(points, vtkPointSplatProjection::Remove, options.Quiet);
  }
  vtkSmartPointer<vtkPointSplatEstimation> estimation;
  vtkSmartPointer<vtkDataSet> drawn = points;
  if (!AreShownAtOnce(options, points))
  {
    estimation = Estimate(points, options.Quiet);
    if (estimation->IsNoisy() && !options.Project)
    {
      // As the mapper does by itself where it estimates.
      const auto projected = Project(points, vtkPointSplatProjection::Keep, options.Quiet);
      const auto again = Estimate(projected, options.Quiet);
      if (!again->IsCrumpled(estimation->GetContradiction()))
      {
        points = projected;
        estimation = again;
      }
      else
      {
        estimation->ReliefOn();
        estimation->Update();
      }
    }
    drawn = estimation->GetOutput();
  }
  Surface& surface = AddSurface(scene, options, name, drawn);
  surface.Normals = normals;
  surface.NumberOfFillPoints = estimation ? static_cast<vtkIdType>(estimation->GetFillPoints().size()) : 0;

  ColourPoints(scene, options, surface, points);
  // What colours without normals come from, cameras and laser scanners, has seen them in the light.
  const bool photographed = normals == "estimated" && options.Normals != "estimate" &&
    options.Array.empty() && surface.Colours != "actor";
  if (photographed && surface.Lit && !options.Lit && options.Shadows == 0)
  {
    SetLit(surface, false);
    if (!options.Quiet)
    {
      std::printf(
        "%s: has colours and no normals, and is not lit; --lit lights it\n", name.c_str());
    }
  }
}

/**
 * Of a large file, the coarsest splats at first: the camera is yet to be placed.
 */
void AddStream(Scene& scene, const Options& options, const std::string& name,
  const std::shared_ptr<OctreeStream>& stream)
{
  vtkPolyData* coarsest = stream->GetSource()->GetOutput();
  if (!options.Array.empty() && !coarsest->GetPointData()->GetArray(options.Array.c_str()))
  {
    throw NoSuchArray(name, options.Array, coarsest);
  }
  Surface& surface = AddSurface(scene, options, name, coarsest);
  surface.Mapper->SetInputConnection(stream->GetSource()->GetOutputPort());
  surface.Normals = "file";
  surface.Stream = stream;
}

/**
 * Now with what the camera sees.
 */
void ShowStreams(Scene& scene, const Options& options)
{
  for (Surface& surface : scene.Surfaces)
  {
    if (surface.Stream)
    {
      surface.Stream->SetCamera(scene.Renderer->GetActiveCamera(), options.Size.data());
      ColourPoints(scene, options, surface, surface.Stream->GetSource()->GetOutput());
    }
  }
  scene.Renderer->ResetCameraClippingRange();
}

vtkBoundingBox BoundsOfStreams(const Scene& scene)
{
  vtkBoundingBox box;
  for (const Surface& surface : scene.Surfaces)
  {
    if (surface.Stream)
    {
      box.AddBox(surface.Stream->GetBoundsInFile());
    }
  }
  return box;
}
}

//------------------------------------------------------------------------------
Scene Scene::Make(const Options& options)
{
  Scene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Renderer->SetBackground(
    options.Background[0], options.Background[1], options.Background[2]);
  Options own = options;
  if (options.Files.empty())
  {
    if (own.Isovalues.empty())
    {
      own.Isovalues = { 4.0, 18.0, 50.0 };
    }
    if (own.Spacing <= 0.0)
    {
      own.Spacing = 0.1;
    }
    AddVolume(scene, own, "hydrogen orbital", MakeHydrogenVolume(128));
    if (options.Opacities.empty())
    {
      // Opaque shells hide one another: the outer ones are cut open.
      for (size_t i = 0; i + 1 < scene.Surfaces.size(); ++i)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.0, i == 0 ? -0.6 : 0.0, 0.0);
        plane->SetNormal(0.0, 1.0, 0.0);
        scene.Surfaces[i].Mapper->AddClippingPlane(plane);
      }
    }
    if (own.Camera.empty())
    {
      // From the side that is cut away, z up.
      scene.Renderer->GetActiveCamera()->SetPosition(0.0, -1.0, 0.0);
      scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
      own.Camera = { 25.0, 20.0, 1.3 };
    }
  }
  for (const std::string& file : options.Files)
  {
    if (const std::shared_ptr<OctreeStream> stream = OpenStream(file, options))
    {
      AddStream(scene, options, file.substr(file.find_last_of("/\\") + 1), stream);
      continue;
    }
    for (const auto& [name, data] : ReadFile(file, options.Quiet, options.MostPoints))
    {
      if (vtkImageData* volume = vtkImageData::SafeDownCast(data))
      {
        AddVolume(scene, options, name, volume);
      }
      else
      {
        AddPoints(scene, options, name, data);
      }
    }
  }
  PlaceCamera(scene.Renderer, own.Camera, BoundsOfStreams(scene));
  ShowStreams(scene, options);
  if (options.Shadows > 0)
  {
    AddLamp(scene.Renderer);
  }
  return scene;
}
