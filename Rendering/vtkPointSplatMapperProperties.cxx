// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the mapper: what goes through all of its properties, and what is answered by them alone.
#include "vtkPointSplatMapper.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkPointSplatScalars.h"
#include "vtkScalarsToColors.h"

#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkPointSplatMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto other = vtkPointSplatMapper::SafeDownCast(mapper))
  {
    this->SetTargetError(other->TargetError);
    this->SetMethod(other->Method);
    this->SetTransparency(other->Transparency);
    this->SetMaximumNumberOfLayers(other->MaximumNumberOfLayers);
    this->SetGatherRemaining(other->GatherRemaining);
    this->SetPickOpacityThreshold(other->PickOpacityThreshold);
    this->SetRefraction(other->Refraction);
    this->SetRefractiveIndex(other->RefractiveIndex);
    this->SetDispersion(other->Dispersion);
    this->SetAbsorption(other->Absorption);
    this->SetOverlapFactor(other->OverlapFactor);
    this->SetVoronoiDepth(other->VoronoiDepth);
    this->SetMaximumImageMemory(other->MaximumImageMemory);
    this->SetMaximumWindowMemory(other->MaximumWindowMemory);
    this->SetMaximumNumberOfFillSteps(other->MaximumNumberOfFillSteps);
    this->SetAntiAliasing(other->AntiAliasing);
    this->SetLevelOfDetail(other->LevelOfDetail);
    this->SetHybrid(other->Hybrid);
    this->SetProgressive(other->Progressive);
    this->SetProjectNoise(other->ProjectNoise);
    this->SetFillGaps(other->FillGaps);
    this->SetFollowMotion(other->FollowMotion);
    this->SetShadows(other->Shadows);
    this->SetNumberOfShadowSamples(other->NumberOfShadowSamples);
    this->SetNumberOfInteractiveShadowSamples(other->NumberOfInteractiveShadowSamples);
    this->SetShadowLightRadius(other->ShadowLightRadius);
    this->SetShadowSeed(other->ShadowSeed);
    this->SetShadowLayerDistance(other->ShadowLayerDistance);
    this->SetShadowResolution(other->ShadowResolution);
    this->SetProjection(other->Projection);
    this->SetTileLists(other->TileLists);
    this->SetKernel(other->Kernel);
    this->SetKernelSigma(other->KernelSigma);
    this->SetPlateauFalloff(other->PlateauFalloff);
    this->SetPlateauExponent(other->PlateauExponent);
    this->SetKernelSupport(other->KernelSupport);
    this->SetRadiusScale(other->RadiusScale);
    this->SetLayerDistance(other->LayerDistance);
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetError: " << this->TargetError << "\n";
  os << indent << "Choices:\n";
  std::istringstream choices(this->GetChoices());
  for (std::string line; std::getline(choices, line);)
  {
    os << indent.GetNextIndent() << line << "\n";
  }
  os << indent << "Method: " << this->Method << " (used: " << this->GetMethodUsed() << ")\n";
  os << indent << "MethodReason: " << this->GetMethodReason() << "\n";
  os << indent << "Transparency: " << this->Transparency
     << " (used: " << this->GetTransparencyUsed() << ")\n";
  os << indent << "MaximumNumberOfLayers: " << this->MaximumNumberOfLayers << "\n";
  os << indent << "NumberOfLayersDrawn: " << this->GetNumberOfLayersDrawn() << "\n";
  os << indent << "GatherRemaining: " << (this->GatherRemaining ? "On" : "Off") << "\n";
  os << indent << "PickOpacityThreshold: " << this->PickOpacityThreshold << "\n";
  os << indent << "Refraction: " << (this->Refraction ? "On" : "Off") << "\n";
  os << indent << "RefractiveIndex: " << this->RefractiveIndex << "\n";
  os << indent << "Dispersion: " << this->Dispersion << "\n";
  os << indent << "Absorption: " << this->Absorption[0] << ", " << this->Absorption[1] << ", "
     << this->Absorption[2] << "\n";
  os << indent << "OverlapFactor: " << this->OverlapFactor << "\n";
  os << indent << "VoronoiDepth: " << (this->VoronoiDepth ? "On" : "Off") << "\n";
  os << indent << "MaximumImageMemory: " << this->MaximumImageMemory << "\n";
  os << indent << "MaximumWindowMemory: " << this->MaximumWindowMemory << "\n";
  os << indent << "MaximumNumberOfFillSteps: " << this->MaximumNumberOfFillSteps << "\n";
  os << indent << "NumberOfFillSteps: " << this->GetNumberOfFillSteps() << "\n";
  os << indent << "ProjectNoise: " << (this->ProjectNoise ? "On" : "Off") << "\n";
  os << indent << "FillGaps: " << (this->FillGaps ? "On" : "Off") << "\n";
  os << indent << "FollowMotion: " << (this->FollowMotion ? "On" : "Off") << "\n";
  os << indent << "LevelOfDetail: " << (this->LevelOfDetail ? "On" : "Off") << "\n";
  os << indent << "Hybrid: " << (this->Hybrid == HYBRID_OFF ? "Off" : "Automatic") << "\n";
  os << indent << "NumberOfTrianglesProjected: " << this->GetNumberOfTrianglesProjected() << "\n";
  os << indent << "Progressive: " << (this->Progressive ? "On" : "Off") << "\n";
  os << indent << "AntiAliasing: " << (this->AntiAliasing ? "On" : "Off") << "\n";
  os << indent << "ProjectedSpacing: " << this->GetProjectedSpacing() << "\n";
  os << indent << "NumberOfPointsProjected: " << this->GetNumberOfPointsProjected() << "\n";
  os << indent << "NumberOfGroups: " << this->GetNumberOfGroups() << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "On" : "Off") << "\n";
  os << indent << "NumberOfShadowSamples: " << this->NumberOfShadowSamples
     << " (used: " << this->GetNumberOfShadowSamplesUsed() << ")\n";
  os << indent << "NumberOfInteractiveShadowSamples: " << this->NumberOfInteractiveShadowSamples
     << "\n";
  os << indent << "NumberOfShadowUpdates: " << this->GetNumberOfShadowUpdates() << "\n";
  os << indent << "ShadowLightRadius: " << this->ShadowLightRadius << "\n";
  os << indent << "ShadowSeed: " << this->ShadowSeed << "\n";
  os << indent << "ShadowLayerDistance: " << this->ShadowLayerDistance << "\n";
  os << indent << "ShadowResolution: " << this->ShadowResolution << "\n";
  os << indent << "Projection: " << this->Projection << " (used: " << this->GetProjectionUsed()
     << ")\n";
  os << indent << "TileLists: " << this->TileLists << "\n";
  os << indent << "Kernel: " << (this->Kernel == GAUSSIAN ? "Gaussian" : "plateau") << "\n";
  os << indent << "KernelSigma: " << this->KernelSigma << "\n";
  os << indent << "PlateauFalloff: " << this->PlateauFalloff << "\n";
  os << indent << "PlateauExponent: " << this->PlateauExponent << "\n";
  os << indent << "KernelSupport: " << this->KernelSupport << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "LayerDistance: " << this->LayerDistance
     << " (used: " << this->GetLayerDistanceUsed() << ")\n";
  os << indent << "NumberOfSplats: " << this->GetNumberOfSplats() << "\n";
  os << indent << "Stride: " << this->GetStride() << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->GetNumberOfSkippedPoints() << "\n";
  os << indent << "NumberOfCopies: " << this->GetNumberOfCopies() << "\n";
  os << indent << "ImageMemorySize: " << this->GetImageMemorySize() << "\n";
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::HasTranslucentPolygonalGeometry()
{
  bool translucentBlock = false;
  this->VisitBlockLooks([&translucentBlock](unsigned int, const BlockLook& look) {
    translucentBlock = translucentBlock || (look.Visible && look.HasOpacity && look.Opacity < 1.0);
  });
  if (translucentBlock)
  {
    return true;
  }
  if (!this->ScalarVisibility || !this->GetLookupTable())
  {
    return false;
  }
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetExecutive()->GetInputData(0, 0) : nullptr;
  auto translucent = [this](vtkDataObject* object) {
    vtkDataSet* data = vtkDataSet::SafeDownCast(object);
    vtkAbstractArray* scalars = data ? vtkPointSplatScalars(this, data).Array : nullptr;
    if (!scalars)
    {
      return false;
    }
    vtkScalarsToColors* table = this->GetLookupTable();
    table->Build();
    return table->IsOpaque(scalars, this->ColorMode, this->ArrayComponent) == 0;
  };
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (translucent(it->GetCurrentDataObject()))
      {
        return true;
      }
    }
    return false;
  }
  return translucent(input);
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::SetAbsorption(double red, double green, double blue)
{
  const double wanted[3] = { red, green, blue };
  for (int c = 0; c < 3; ++c)
  {
    const double absorption = wanted[c] > 0.0 ? wanted[c] : 0.0; // of NaN too
    if (this->Absorption[c] != absorption)
    {
      this->Absorption[c] = absorption;
      this->Modified();
    }
  }
}

VTK_ABI_NAMESPACE_END
