// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzProperties.h"

#include "FuzzRandom.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointSplatMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

namespace
{
void SetShadows(FuzzRandom& random, vtkPointSplatMapper* mapper)
{
  mapper->SetShadows(random.Chance(0.25));
  // Few and small: many take long, and are no different.
  mapper->SetNumberOfShadowSamples(random.Pick({ 1, 2, 5, 0, -1 }));
  mapper->SetNumberOfInteractiveShadowSamples(random.Pick({ 1, 2, 0 }));
  mapper->SetShadowLightRadius(random.Chance(0.5) ? 0 : random.Property(0, 1));
  mapper->SetShadowSeed(static_cast<int>(random.Next()));
  mapper->SetShadowLayerDistance(random.Chance(0.5) ? 0 : random.Property(0, 0.1));
  mapper->SetShadowResolution(random.Pick({ 0, 1, 2, 33, 256, -5 }));
}

/// Of physically based interpolation.
void SetPhysical(FuzzRandom& random, vtkProperty* property)
{
  property->SetMetallic(random.Property(0, 1));
  property->SetRoughness(random.Property(0, 1));
  property->SetBaseIOR(random.Property(1, 3));
  property->SetEdgeTint(random.Uniform(), random.Uniform(), random.Uniform());
  property->SetAnisotropy(random.Chance(0.8) ? 0 : random.Uniform());
  if (random.Chance(0.4))
  {
    property->SetCoatStrength(random.Property(0, 1));
    property->SetCoatRoughness(random.Property(0, 1));
    property->SetCoatIOR(random.Property(1, 3));
    property->SetCoatColor(random.Uniform(), random.Uniform(), random.Uniform());
  }
}

void SetBlocks(FuzzRandom& random, vtkPointSplatMapper* mapper)
{
  mapper->SetCompositeDataDisplayAttributes(nullptr);
  for (int k = random.Chance(0.6) ? 0 : random.Below(5); k > 0; --k)
  {
    const unsigned int block = static_cast<unsigned int>(random.Below(8));
    switch (random.Below(4))
    {
      case 0:
        mapper->SetBlockVisibility(block, random.Chance(0.5));
        break;
      case 1:
        mapper->SetBlockOpacity(block, random.Property(0, 1));
        break;
      case 2:
        mapper->SetBlockColor(
          block, random.Property(0, 1), random.Property(0, 1), random.Property(0, 1));
        break;
      default:
        mapper->RemoveBlockVisibility(block);
        mapper->RemoveBlockOpacities();
        break;
    }
  }
}

vtkSmartPointer<vtkImageData> MakePicture(FuzzRandom& random, int side, bool wild)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(side > 0 ? side : 1 + random.Below(20), side > 0 ? side : 1 + random.Below(10), 1);
  const bool floats = random.Chance(0.4);
  picture->AllocateScalars(floats ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 1 + random.Below(4));
  vtkDataArray* values = picture->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      values->SetComponent(i, c,
        !floats                             ? random.Below(256)
          : wild && random.Chance(0.05)     ? static_cast<float>(random.Nasty())
                                            : random.Uniform(0, 2));
    }
  }
  return picture;
}
}

//------------------------------------------------------------------------------
void FuzzProperties::SetShared(FuzzRandom& random, vtkPointSplatMapper* mapper)
{
  mapper->SetMethod(random.Below(4));
  mapper->SetTransparency(random.Below(4));
  mapper->SetProjection(random.Below(3));
  mapper->SetMaximumNumberOfLayers(random.Pick({ 32, 32, 1, 2, 5, 0, 1000 }));
  mapper->SetGatherRemaining(random.Chance(0.2));
  mapper->SetVoronoiDepth(random.Chance(0.8));
  mapper->SetAntiAliasing(random.Chance(0.7));
  mapper->SetHybrid(random.Pick({ 0, 1, 1, 2 }));
  mapper->SetMaximumNumberOfFillSteps(random.Pick({ 32, 32, 1, 2, 0, 1000 }));
  mapper->SetTargetError(random.Pick({ 1.0 / 256.0, 0.0, 1.0 / 64.0, 1.0 / 16.0, 1.0, 2.0 }));
  SetShadows(random, mapper);
}

//------------------------------------------------------------------------------
void FuzzProperties::SetOwn(FuzzRandom& random, vtkPointSplatMapper* mapper)
{
  mapper->SetOverlapFactor(random.Property(0, 1));
  mapper->SetPickOpacityThreshold(random.Chance(0.8) ? 0 : random.Property(0, 1));
  mapper->SetKernel(random.Below(2));
  mapper->SetFillGaps(random.Chance(0.8));
  mapper->SetFollowMotion(random.Chance(0.8));
  if (random.Chance(0.3))
  {
    mapper->SetKernelSigma(random.Property(0, 2));
    mapper->SetPlateauFalloff(random.Property(0, 20));
    mapper->SetPlateauExponent(random.Property(0, 20));
    mapper->SetKernelSupport(random.Property(1, 4));
  }
  if (random.Chance(0.3))
  {
    mapper->SetRadiusScale(random.Chance(0.8) ? random.Uniform(0.1, 3) : random.Nasty());
  }
  if (random.Chance(0.3))
  {
    mapper->SetLayerDistance(random.Chance(0.5) ? random.Nasty() : random.Scale(1e-6, 10));
  }
  if (random.Chance(0.1))
  {
    mapper->SetMaximumImageMemory(random.Pick<vtkIdType>({ 0, 1, 1000, 1 << 20 }));
  }
  mapper->SetMaximumWindowMemory(random.Pick<vtkIdType>({ vtkIdType(1) << 32, 0, 1, 1000000 }));
  SetBlocks(random, mapper);
  mapper->SetRefraction(random.Chance(0.25));
  if (mapper->GetRefraction())
  {
    mapper->SetRefractiveIndex(random.Property(1, 2.5));
    mapper->SetDispersion(random.Chance(0.5) ? 0 : random.Property(0, 0.1));
    mapper->SetAbsorption(random.Property(0, 3), random.Property(0, 3), random.Property(0, 3));
  }
  mapper->RemoveAllClippingPlanes();
  for (int p = random.Chance(0.8) ? 0 : random.Below(9); p > 0; --p)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
    plane->SetNormal(random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
    mapper->AddClippingPlane(plane);
  }
}

//------------------------------------------------------------------------------
void FuzzProperties::SetColouring(FuzzRandom& random, vtkPointSplatMapper* mapper)
{
  mapper->SetScalarVisibility(random.Chance(0.8));
  mapper->SetScalarMode(random.Below(6));
  mapper->SetColorMode(random.Below(3));
  mapper->SetInterpolateScalarsBeforeMapping(random.Chance(0.2));
  mapper->SetScalarRange(random.Property(-1, 0), random.Property(0, 1));
  mapper->SetUseLookupTableScalarRange(random.Chance(0.3));
  if (random.Chance(0.4))
  {
    mapper->SelectColorArray(random.Pick(
      { "scalars", "rgba", "Normals", "SplatRadius", "Isovalue", "vtkGhostType", "none" }));
  }
  if (random.Chance(0.3))
  {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(random.Pick({ 1, 2, 256 }));
    table->SetAlphaRange(random.Uniform(), random.Uniform());
    table->SetTableRange(random.Property(-1, 0), random.Property(0, 1));
    table->SetScale(random.Below(2));
    table->SetVectorMode(random.Below(3));
    table->SetVectorComponent(random.Below(5));
    table->Build();
    mapper->SetLookupTable(table);
  }
  else if (random.Chance(0.2))
  {
    vtkNew<vtkColorTransferFunction> colours;
    for (int k = random.Below(4); k > 0; --k)
    {
      colours->AddRGBPoint(random.Uniform(), random.Uniform(), random.Uniform(), random.Uniform());
    }
    mapper->SetLookupTable(colours);
  }
  else
  {
    mapper->SetLookupTable(nullptr);
  }
}

//------------------------------------------------------------------------------
void FuzzProperties::SetActor(FuzzRandom& random, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetOpacity(random.Chance(0.6) ? 1.0 : random.Property(0, 1));
  property->SetColor(random.Uniform(), random.Uniform(), random.Uniform());
  property->SetSpecular(random.Property(0, 1));
  property->SetSpecularPower(random.Property(0, 100));
  property->SetAmbient(random.Uniform());
  property->SetInterpolation(random.Below(4));
  property->SetRepresentation(random.Chance(0.6) ? VTK_SURFACE : random.Below(3));
  SetPhysical(random, property);
  property->SetBackfaceCulling(random.Chance(0.2));
  property->SetFrontfaceCulling(random.Chance(0.1));
  property->SetLighting(random.Chance(0.9));
  property->SetEdgeVisibility(random.Chance(0.1));
  actor->SetForceTranslucent(random.Chance(0.05));
  actor->SetPickable(random.Chance(0.9));
  if (random.Chance(0.3))
  {
    vtkNew<vtkMatrix4x4> matrix;
    const bool wild = random.Chance(0.4);
    const double scale = random.Scale(1e-3, 1e3);
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        matrix->SetElement(row, column,
          wild && random.Chance(0.15) ? random.Nasty()
            : row == 3                ? (column == 3 ? 1 : 0)
            : column == 3             ? random.Uniform(-0.5, 0.5)
                                      : scale * random.Uniform(-1, 1));
      }
    }
    if (random.Chance(0.1))
    {
      matrix->Zero();
    }
    actor->SetUserMatrix(matrix);
  }
}

//------------------------------------------------------------------------------
void FuzzProperties::SetCamera(FuzzRandom& random, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(random.Chance(0.3));
  if (random.Chance(0.6))
  {
    camera->SetPosition(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(0.5, 4));
    camera->SetFocalPoint(0, 0, 0);
    renderer->ResetCamera();
    camera->Zoom(random.Scale(0.1, 20));
    return;
  }
  camera->SetPosition(random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
  camera->SetFocalPoint(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  camera->SetViewUp(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  camera->SetViewAngle(random.Chance(0.2) ? random.Uniform(0, 200) : 30);
  camera->SetParallelScale(random.Property(0, 2));
  const double near = random.Scale(1e-6, 10);
  camera->SetClippingRange(near, near * random.Scale(1.001, 1e9));
}

//------------------------------------------------------------------------------
void FuzzProperties::SetLights(FuzzRandom& random, vtkRenderer* renderer, bool wild)
{
  const auto number = [&](double least, double most) {
    return wild ? random.Property(least, most) : random.Uniform(least, most);
  };
  for (int k = random.Chance(0.5) ? 0 : random.Below(6); k > 0; --k)
  {
    vtkNew<vtkLight> light;
    light->SetLightType(
      random.Pick({ VTK_LIGHT_TYPE_SCENE_LIGHT, VTK_LIGHT_TYPE_SCENE_LIGHT,
        VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_HEADLIGHT }));
    light->SetPosition(number(-3, 3), number(-3, 3), number(-3, 3));
    light->SetFocalPoint(number(-1, 1), number(-1, 1), number(-1, 1));
    light->SetColor(random.Uniform(), random.Uniform(), random.Uniform());
    light->SetIntensity(number(0, 1));
    light->SetSwitch(random.Chance(0.9));
    light->SetPositional(random.Chance(0.5));
    light->SetConeAngle(random.Chance(0.5) ? 90 : number(0, 90));
    light->SetExponent(random.Chance(0.7) ? 1 : number(0, 10));
    if (wild && random.Chance(0.2))
    {
      light->SetAttenuationValues(random.Property(0, 1), random.Property(0, 1), random.Property(0, 1));
    }
    renderer->AddLight(light);
  }
}

//------------------------------------------------------------------------------
void FuzzProperties::SetEnvironment(FuzzRandom& random, vtkRenderer* renderer, bool wild)
{
  if (random.Chance(0.5))
  {
    return;
  }
  vtkNew<vtkTexture> texture;
  // Rarely: VTK filters the picture for each roughness, which takes long, and asks of smaller ones
  // levels of detail that they have not.
  const bool lights = random.Chance(0.03);
  if (lights)
  {
    texture->SetInputDataObject(MakePicture(random, 64, wild));
  }
  else if (random.Chance(0.3))
  {
    const int side = 1 + random.Below(8);
    const std::uint64_t seed = random.Next();
    texture->CubeMapOn();
    for (int face = 0; face < 6; ++face)
    {
      FuzzRandom same(seed); // sizes and types must agree
      texture->SetInputDataObject(face, MakePicture(same, side, wild));
    }
  }
  else if (!random.Chance(0.1)) // else without a picture
  {
    texture->SetInputDataObject(MakePicture(random, 0, wild));
  }
  texture->SetInterpolate(random.Chance(0.5));
  texture->SetMipmap(random.Chance(0.5));
  texture->SetUseSRGBColorSpace(random.Chance(0.3));
  renderer->SetEnvironmentTexture(texture);
  renderer->SetUseImageBasedLighting(lights);
  if (random.Chance(0.3))
  {
    renderer->SetEnvironmentUp(
      random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
    renderer->SetEnvironmentRight(
      random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
  }
}
