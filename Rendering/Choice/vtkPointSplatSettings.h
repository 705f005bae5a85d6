// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a user sets, as the frame takes it: the properties of vtkPointSplatMapper, which says what
// they mean.
#ifndef vtkPointSplatSettings_h
#define vtkPointSplatSettings_h

#include "vtkType.h"

#include <array>
#include <optional>

struct vtkPointSplatSettings
{
  enum MethodType
  {
    AutomaticMethod,
    TwoPass,
    Deferred,
    ImageSpace
  };
  enum TransparencyType
  {
    AutomaticTransparency,
    Peeling,
    Sorted,
    NearestExact
  };
  enum ProjectionType
  {
    AutomaticProjection,
    Compute,
    Quads
  };
  enum HybridType
  {
    HybridOff,
    AutomaticHybrid
  };
  enum ListsType
  {
    AutomaticLists,
    Processor,
    Device
  };

  double TargetError = 1.0 / 256.0;
  bool LevelOfDetail = true;
  int Hybrid = HybridOff;
  bool Progressive = true;
  /// Whether another frame will follow, so that this one may show less than all.
  bool MayBeDraft = false;
  int Method = AutomaticMethod;
  int Transparency = AutomaticTransparency;
  int Projection = AutomaticProjection;
  int TileLists = AutomaticLists;
  int MaximumNumberOfLayers = 32;
  bool GatherRemaining = false;
  double PickOpacityThreshold = 0.0;
  double LayerDistance = 0.0;
  double RadiusScale = 1.0;
  vtkIdType MaximumImageMemory = vtkIdType(1) << 30;
  vtkIdType MaximumWindowMemory = vtkIdType(1) << 32;

  bool PlateauKernel = false;
  double KernelSigma = 0.6;
  double PlateauFalloff = 4.0;
  double PlateauExponent = 5.0;
  double KernelSupport = 1.5;

  double OverlapFactor = 0.8;
  bool VoronoiDepth = true;
  int MaximumNumberOfFillSteps = 2;
  bool AntiAliasing = true;

  bool Refraction = false;
  double RefractiveIndex = 1.5;
  double Dispersion = 0.0;
  std::array<double, 3> Absorption{ { 0.0, 0.0, 0.0 } };

  /// Diffuse colour and opacity of the actor that is drawn, if that is known.
  std::optional<std::array<double, 4>> ActorColour;

  /// Whether the actor that is drawn has textures; whether its light goes by tangents.
  bool NeedCoordinates = false;
  bool NeedTangents = false;

  bool Shadows = false;
  int NumberOfShadowSamples = 16;
  int NumberOfInteractiveShadowSamples = 1;
  double ShadowLightRadius = 0.0;
  int ShadowSeed = 1;
  double ShadowLayerDistance = 0.0;
  int ShadowResolution = 0;
};

#endif
