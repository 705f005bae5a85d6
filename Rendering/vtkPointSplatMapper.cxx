// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMapper.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointSplatCloud.h"
#include "vtkPointSplatCompositor.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatMapper);

namespace
{
// As many as the shaders take; VTK's own mappers take six.
constexpr int MaximumClipPlanes = 6;

/// How much a matrix stretches, at most.
double Stretch(const glm::dmat4& matrix)
{
  const glm::dmat3 linear(matrix);
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += glm::dot(linear[k], linear[k]);
  }
  return std::sqrt(sum);
}
}

struct vtkPointSplatMapper::vtkInternals
{
  /// What the user has been told of drawing in a renderer: once, not at every frame.
  struct Told
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    std::string Error;
    bool Refused = false;       // deferred blending, and still so
    bool NoEnvironment = false; // and still there is none
  };
  /// A mapper may be drawn by several renderers in turn, of which each has reasons of its own.
  Told& ToldOf(vtkRenderer* renderer)
  {
    this->AllTold.erase(std::remove_if(this->AllTold.begin(), this->AllTold.end(),
                          [](const Told& told) { return !told.Renderer; }),
      this->AllTold.end());
    auto found = std::find_if(this->AllTold.begin(), this->AllTold.end(),
      [renderer](const Told& told) { return told.Renderer == renderer; });
    if (found == this->AllTold.end())
    {
      found = this->AllTold.emplace(found);
      found->Renderer = renderer;
    }
    return *found;
  }

  std::vector<Told> AllTold;
  vtkPointSplatCloud Cloud;
  std::shared_ptr<vtkPointSplatCompositor> Compositor; // that drew last
  bool WarnedOfClipPlanes = false;
  const char* ProjectionUsed = "none"; // by the last frame
  const char* MethodUsed = "none";
  vtkPointSplatChoice Choice;
  std::string Choices;
  bool Points = false; // drawn in image space
  int LayersDrawn = 0;
  int FillSteps = 0;
  double ProjectedSpacing = 0.0;
  vtkIdType PointsProjected = 0;
  const char* TransparencyUsed = "none";
  int ShadowSamplesUsed = 0;
  std::string ShadowReason;
  unsigned long ShadowUpdates = 0;
};

//------------------------------------------------------------------------------
vtkPointSplatMapper::vtkPointSplatMapper()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkPointSplatMapper::~vtkPointSplatMapper()
{
  // The OpenGL resources go with ReleaseGraphicsResources(), as in every mapper.
  if (this->Internals->Compositor)
  {
    this->Internals->Compositor->Leave(this, nullptr);
  }
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
vtkExecutive* vtkPointSplatMapper::CreateDefaultExecutive()
{
  return vtkCompositeDataPipeline::New();
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::HasCompositeInput()
{
  return this->GetNumberOfInputConnections(0) > 0 &&
    vtkCompositeDataSet::SafeDownCast(this->GetExecutive()->GetInputData(0, 0)) != nullptr;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::UpdateInput()
{
  if (!this->Static && this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->UpdateInformation();
    this->GetInputAlgorithm()->UpdatePiece(
      this->Piece, this->NumberOfPieces * this->NumberOfSubPieces, this->GhostLevel);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::UpdateCloud()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  this->UpdateInput();
  vtkDataObject* input = this->GetExecutive()->GetInputData(0, 0);
  if (!input)
  {
    return false;
  }
  this->Internals->Cloud.Update(this, input);
  return this->Internals->Cloud.GetNumberOfSplats() > 0;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud* vtkPointSplatMapper::GetCloud()
{
  return &this->Internals->Cloud;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("The mapper has no input: call SetInputConnection() or SetInputData().");
    return;
  }
  this->RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  const bool some = this->UpdateCloud();
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  if (!some)
  {
    return;
  }
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // Tells it how many passes the ids need.
    selector->UpdateMaximumPointId(this->Internals->Cloud.GetNumberOfPoints());
    selector->UpdateMaximumCellId(this->Internals->Cloud.GetNumberOfPoints());
  }
  auto compositor = vtkPointSplatCompositor::Of(renderer);
  if (this->Internals->Compositor && this->Internals->Compositor != compositor)
  {
    this->Internals->Compositor->Leave(this, nullptr);
  }
  this->Internals->Compositor = compositor;
  this->TimeToDraw = 0.0;
  vtkInternals::Told& told = this->Internals->ToldOf(renderer);
  if (!compositor->Present(renderer, actor, this) && told.Error != compositor->GetError())
  {
    told.Error = compositor->GetError();
    vtkErrorMacro("OpenGL cannot draw the splats: " << told.Error);
  }
  this->Internals->ProjectionUsed = compositor->IsCompute() ? "compute" : "quads";
  this->Internals->Choice = compositor->GetChoice();
  this->Internals->MethodUsed = compositor->IsDeferred() ? "deferred"
    : this->Internals->Points                             ? "image-space"
                                                          : "two-pass";
  this->Internals->FillSteps = compositor->GetNumberOfFillSteps();
  this->Internals->LayersDrawn = compositor->GetNumberOfLayers();
  this->Internals->TransparencyUsed = compositor->GetTransparencyUsed();
  this->Internals->ShadowSamplesUsed =
    this->Shadows ? compositor->GetShadows().GetSamplesUsed() : 0;
  this->Internals->ShadowReason = compositor->GetShadows().GetSamplesReason();
  this->Internals->ShadowUpdates = compositor->GetShadows().GetNumberOfUpdates();
  const bool refused = this->Method == DEFERRED && this->Internals->Choice.Refused;
  if (refused && !told.Refused)
  {
    vtkWarningMacro("Two passes instead of deferred blending: " << this->GetMethodReason() << ".");
  }
  told.Refused = refused;
  const bool noEnvironment =
    this->Refraction && !renderer->GetSelector() && !compositor->HasEnvironment();
  if (noEnvironment && !told.NoEnvironment)
  {
    vtkWarningMacro("Nothing is refracted: the renderer has no environment texture, or one without "
                    "a picture, or a cube map whose six faces are not of one size and type, of 3 "
                    "or 4 components of unsigned char (or of float, with "
                    "vtkTexture::SetColorModeToDirectScalars()). Call "
                    "vtkRenderer::SetEnvironmentTexture().");
  }
  told.NoEnvironment = noEnvironment || (told.NoEnvironment && renderer->GetSelector());
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
vtkPointSplatSpacing vtkPointSplatMapper::FindSpacing(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
{
  vtkPointSplatCloud& cloud = this->Internals->Cloud;
  const glm::dvec2 pixels = view.PixelSizes(item.MCWC, cloud.GetBounds().data());
  vtkPointSplatSpacing spacing;
  const double stretch = Stretch(item.MCWC) / std::sqrt(3.0);
  spacing.World = stretch * cloud.GetSpacing();
  spacing.Pixels = spacing.World / pixels.x;
  spacing.LargestPixel = pixels.y;
  spacing.Curvature = stretch > 0.0 ? cloud.GetMeanCurvature() / stretch : 0.0;
  return spacing;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::FillItem(vtkActor* actor, const vtkPointSplatView& view,
  const vtkPointSplatChoice& choice, vtkPointSplatItem& item)
{
  vtkPointSplatCloud& cloud = this->Internals->Cloud;
  item.Cloud = &cloud;
  vtkProperty* property = actor->GetProperty();
  item.Culling =
    (property->GetBackfaceCulling() ? 1 : 0) | (property->GetFrontfaceCulling() ? 2 : 0);
  item.RadiusScale = this->RadiusScale;
  const double stretch = Stretch(item.MCWC);
  const double largest = stretch * this->RadiusScale * cloud.GetMaximumRadius();
  item.LayerDistance = this->LayerDistance > 0.0 ? this->LayerDistance : -choice.LayerRadii;
  // The unit of depths in the sums; a few splats that are much larger than the
  // others must not coarsen it for all.
  const double common =
    std::min(largest, 1.5 * stretch * this->RadiusScale * cloud.GetMedianRadius());
  item.LargestLayer = this->LayerDistance > 0.0 ? this->LayerDistance : choice.LayerRadii * common;
  item.KernelType = this->Kernel;
  item.KernelShape = this->Kernel == GAUSSIAN
    ? glm::vec2(0.5 / (this->KernelSigma * this->KernelSigma), 0.0)
    : glm::vec2(this->PlateauFalloff, this->PlateauExponent);
  item.KernelSupport = this->KernelSupport;
  item.Points = this->Method == IMAGE_SPACE ||
    (this->Method == AUTOMATIC_METHOD && choice.Method == IMAGE_SPACE);
  this->Internals->Points = item.Points;
  if (item.Points)
  {
    const vtkPointSplatSpacing spacing = this->FindSpacing(view, item);
    item.PointLayer =
      this->LayerDistance > 0.0 ? this->LayerDistance : choice.LayerSpacings * spacing.World;
    item.PointLayerPixels = this->LayerDistance > 0.0 ? 0.0 : choice.LayerPixels;
    item.LargestLayer = std::max(item.PointLayer, item.PointLayerPixels * spacing.LargestPixel);
    item.Spacing = spacing.World;
    item.SpacingPixels = spacing.Pixels;
    item.Silhouettes = this->AntiAliasing;
    this->Internals->ProjectedSpacing = item.SpacingPixels;
  }
  const double* colour = property->GetColor();
  item.Colour = cloud.HasColours()
    ? glm::vec4(1.0, 1.0, 1.0, property->GetOpacity())
    : glm::vec4(colour[0], colour[1], colour[2], property->GetOpacity());
  item.ClipPlanes.clear();
  if (vtkPlaneCollection* planes = this->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      const double* n = plane->GetNormal();
      const double* o = plane->GetOrigin();
      if (item.ClipPlanes.size() == MaximumClipPlanes)
      {
        if (!this->Internals->WarnedOfClipPlanes)
        {
          vtkErrorMacro("Only " << MaximumClipPlanes << " clipping planes are honoured; remove "
                                << planes->GetNumberOfItems() - MaximumClipPlanes << ".");
          this->Internals->WarnedOfClipPlanes = true;
        }
        break;
      }
      item.ClipPlanes.emplace_back(n[0], n[1], n[2], -vtkMath::Dot(n, o));
    }
  }
  // Splats that bend rise at their rim by half the squared support, in radii, at most.
  const double farthest =
    std::hypot(this->KernelSupport, 0.5 * this->KernelSupport * this->KernelSupport);
  item.Window = view.Cover(item.MCWC, cloud.GetBounds().data(), farthest * largest);
  item.Batches = item.Points ? cloud.GetBatches().Select(view, item) : nullptr;
  this->Internals->PointsProjected =
    item.Points ? cloud.GetBatches().CountPoints(item.Batches.get()) : 0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> vtkPointSplatMapper::MapPointColours(
  vtkDataSet* data, int& cellFlag)
{
  // vtkMapper does not survive a lookup table that can make no colours of an array.
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
    data, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  const bool direct = this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (this->ColorMode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(scalars));
  if (scalars && direct &&
    (scalars->GetNumberOfComponents() > 4 || scalars->GetDataType() == VTK_BIT ||
      scalars->GetDataType() == VTK_CHAR || scalars->GetDataType() == VTK_SIGNED_CHAR))
  {
    vtkErrorMacro("The array " << (scalars->GetName() ? scalars->GetName() : "(without name)")
                               << " of bits, of signed char, or of more than 4 components, cannot "
                                  "be colours: choose "
                                  "another one, or SetColorModeToMapScalars().");
    return nullptr;
  }
  // Colours are interpolated, not texture coordinates.
  const vtkTypeBool interpolate = this->InterpolateScalarsBeforeMapping;
  this->InterpolateScalarsBeforeMapping = 0;
  this->MapScalars(data, 1.0, cellFlag);
  this->InterpolateScalarsBeforeMapping = interpolate;
  vtkSmartPointer<vtkUnsignedCharArray> colours = this->Colors;
  return colours;
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::HasTranslucentPolygonalGeometry()
{
  if (!this->ScalarVisibility || !this->GetLookupTable())
  {
    return false;
  }
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetExecutive()->GetInputData(0, 0) : nullptr;
  auto translucent = [this](vtkDataObject* object) {
    vtkDataSet* data = vtkDataSet::SafeDownCast(object);
    int cellFlag = 0;
    vtkAbstractArray* scalars = data ? vtkAbstractMapper::GetAbstractScalars(data, this->ScalarMode,
                                         this->ArrayAccessMode, this->ArrayId, this->ArrayName,
                                         cellFlag)
                                     : nullptr;
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
double* vtkPointSplatMapper::GetBounds()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return this->Bounds;
  }
  this->UpdateInput();
  this->ComputeBounds();
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::ComputeBounds()
{
  // The points' own bounds, as a mesh through them has: splats reach no farther
  // than the surface does. Of what is drawn only: a NaN or a ghost far off must
  // not spoil the camera's reset.
  vtkDataObject* input = this->GetExecutive()->GetInputData(0, 0);
  vtkMath::UninitializeBounds(this->Bounds);
  if (input)
  {
    this->Internals->Cloud.Update(this, input);
    if (this->Internals->Cloud.GetNumberOfSplats() > 0)
    {
      std::copy_n(this->Internals->Cloud.GetBounds().data(), 6, this->Bounds);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    window->MakeCurrent();
  }
  this->Internals->Cloud.Release(window);
  if (this->Internals->Compositor)
  {
    this->Internals->Compositor->Leave(this, window);
    this->Internals->Compositor.reset();
  }
  this->Superclass::ReleaseGraphicsResources(window);
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

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetMethodUsed()
{
  return this->Internals->MethodUsed;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfLayersDrawn()
{
  return this->Internals->LayersDrawn;
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetTransparencyUsed()
{
  return this->Internals->TransparencyUsed;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfShadowSamplesUsed()
{
  return this->Internals->ShadowSamplesUsed;
}

//------------------------------------------------------------------------------
unsigned long vtkPointSplatMapper::GetNumberOfShadowUpdates()
{
  return this->Internals->ShadowUpdates;
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetMethodReason()
{
  return this->Internals->Choice.MethodReason.c_str();
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetChoices()
{
  const vtkInternals& is = *this->Internals;
  std::ostringstream text;
  text << "method: " << is.MethodUsed << ", " << is.Choice.MethodReason
       << "\nprojection: " << is.ProjectionUsed << ", " << is.Choice.ProjectionReason
       << "\ntransparency: " << is.TransparencyUsed << ", " << is.Choice.TransparencyReason
       << "\nlayers: " << is.LayersDrawn << ", " << is.Choice.LayersReason
       << "\nlayer distance: " << this->GetLayerDistanceUsed() << ", "
       << (this->LayerDistance > 0.0 ? "it was asked for"
              : is.Points            ? "the spacing of points, and at least three pixels"
                                     : "the radius of each splat; this is the median")
       << "\nfill steps: " << is.FillSteps << ", " << is.Choice.FillReason
       << "\nshadow samples: " << is.ShadowSamplesUsed << ", "
       << (this->Shadows ? is.ShadowReason : "shadows are off")
       << "\nerror allowed: " << vtkPointSplatChoices::Text(is.Choice.Tolerance) << ", "
       << is.Choice.BudgetReason;
  this->Internals->Choices = text.str();
  return this->Internals->Choices.c_str();
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfFillSteps()
{
  return this->Internals->FillSteps;
}

//------------------------------------------------------------------------------
double vtkPointSplatMapper::GetProjectedSpacing()
{
  return this->Internals->ProjectedSpacing;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfPointsProjected()
{
  return this->Internals->PointsProjected;
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::MakeGroups()
{
  return this->Internals->Cloud.MakeGroups(
    this->OverlapFactor, this->RadiusScale * this->KernelSupport);
}

//------------------------------------------------------------------------------
double vtkPointSplatMapper::MakeCoveringGroups(const vtkPointSplatChoice& choice)
{
  this->Internals->Cloud.MakeGroups(1.0, this->RadiusScale, choice.CoveringGroups);
  return this->Internals->Cloud.HasGivenGroups() ? 1.0 : choice.CoveringScale;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfGroups()
{
  return this->Internals->Cloud.GetNumberOfGroups();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatMapper::GetGroupMTime()
{
  return this->Internals->Cloud.GetGroupMTime();
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetProjectionUsed()
{
  return this->Internals->ProjectionUsed;
}

//------------------------------------------------------------------------------
double vtkPointSplatMapper::GetLayerDistanceUsed()
{
  const vtkPointSplatChoice& choice = this->Internals->Choice;
  vtkPointSplatCloud& cloud = this->Internals->Cloud;
  return this->LayerDistance > 0.0 ? this->LayerDistance
    : this->Internals->Points || this->Method == IMAGE_SPACE
    ? choice.LayerSpacings * cloud.GetSpacing()
    : choice.LayerRadii * this->RadiusScale * cloud.GetMedianRadius();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfSplats()
{
  return this->Internals->Cloud.GetNumberOfSplats();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfSkippedPoints()
{
  return this->Internals->Cloud.GetNumberOfSkippedPoints();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetImageMemorySize()
{
  return this->Internals->Compositor ? this->Internals->Compositor->GetMemorySize() : 0;
}

VTK_ABI_NAMESPACE_END
