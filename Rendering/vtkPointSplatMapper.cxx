// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMapper.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkPointSplatIgnored.h"
#include "vtkPointSplatMapperInternals.h"
#include "vtkPointSplatScalars.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointSplatMapper);

//------------------------------------------------------------------------------
vtkPointSplatMapper::vtkInternals::Drawn& vtkPointSplatMapper::vtkInternals::DrawnIn(
  vtkRenderer* renderer)
{
  this->AllDrawn.erase(std::remove_if(this->AllDrawn.begin(), this->AllDrawn.end(),
                         [](const Drawn& drawn) { return !drawn.Frame->GetRenderer(); }),
    this->AllDrawn.end());
  auto found = std::find_if(this->AllDrawn.begin(), this->AllDrawn.end(),
    [renderer](const Drawn& drawn) { return drawn.Frame->GetRenderer() == renderer; });
  if (found == this->AllDrawn.end())
  {
    found = this->AllDrawn.emplace(found);
    found->Frame = vtkPointSplatFrame::Of(renderer);
  }
  return *found;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkPointSplatMapper::vtkInternals::UpdateInput()
{
  if (this->Self->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  if (!this->Self->Static)
  {
    this->Self->GetInputAlgorithm()->UpdateInformation();
    this->Self->GetInputAlgorithm()->UpdatePiece(this->Self->Piece,
      this->Self->NumberOfPieces * this->Self->NumberOfSubPieces, this->Self->GhostLevel);
  }
  return this->Self->GetExecutive()->GetInputData(0, 0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::vtkInternals::Update(const vtkPointSplatSettings& settings)
{
  vtkDataObject* data = this->UpdateInput();
  if (data)
  {
    this->UpdateSplats(data, settings);
  }
  return data && this->GetCloud().GetNumberOfSplats() > 0;
}

//------------------------------------------------------------------------------
vtkPointSplatCloudInput vtkPointSplatMapper::vtkInternals::MakeInput(
  vtkDataObject* data, const vtkPointSplatSettings& settings)
{
  vtkPointSplatCloudInput input;
  input.Data = data;
  input.Owner = this->Self;
  input.NeedSizes = settings.Method != vtkPointSplatSettings::ImageSpace;
  input.ProjectNoise = this->Self->ProjectNoise;
  input.FollowMotion = this->Self->FollowMotion;
  input.FillGaps = this->Self->FillGaps;
  input.FillMeshGaps = this->Self->Hybrid == HYBRID_OFF;
  if (this->Self->ScalarVisibility)
  {
    input.MapColours = [this](vtkDataSet* block) { return this->MapColours(block); };
    if (this->Self->InterpolateScalarsBeforeMapping)
    {
      input.MapValues = [this](vtkDataSet* block) { return this->MapValues(block); };
    }
    input.FindScalars = [this](vtkDataSet* block, int& cellFlag) {
      const vtkPointSplatScalars scalars(this->Self, block);
      cellFlag = scalars.CellFlag;
      return scalars.Array;
    };
    input.ColourKey = [this] { return this->GetColourKey(); };
  }
  input.NeedCoordinates = this->NeedCoordinates;
  input.NeedTangents = this->NeedTangents;
  this->LookAtBlocks(input);
  return input;
}

//------------------------------------------------------------------------------
const std::array<double, 6>* vtkPointSplatMapper::vtkInternals::FindGivenBounds(
  vtkDataObject* data, const vtkPointSplatSettings& settings)
{
  const vtkPointSplatCloudInput input = this->MakeInput(data, settings);
  if (!settings.Progressive || !vtkPointSplatDrafts::AreOfUse(input) || this->IsMadeFrom(input))
  {
    return nullptr;
  }
  vtkPointSplatCloud::Key key = vtkPointSplatCloud::KeyOf(input);
  if (key != this->GivenKey)
  {
    this->GivenBounds = vtkPointSplatCloud::BoundsOf(vtkPointSet::SafeDownCast(data));
    this->GivenKey = std::move(key);
  }
  return &this->GivenBounds;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::vtkInternals::UpdateSplats(
  vtkDataObject* data, const vtkPointSplatSettings& settings)
{
  this->ActorColour = settings.ActorColour.value_or(this->ActorColour);
  this->NeedCoordinates = this->NeedCoordinates || settings.NeedCoordinates;
  this->NeedTangents = this->NeedTangents || settings.NeedTangents;
  this->UpdateCloud(this->MakeInput(data, settings), settings.MayBeDraft);
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::vtkInternals::LookAtBlocks(vtkPointSplatCloudInput& input)
{
  input.ActorColour = this->ActorColour;
  this->Self->VisitBlockLooks([&input](unsigned int index, const BlockLook& block) {
    vtkPointSplatBlockLook& look = input.Looks[index];
    look.Visible = block.Visible;
    if (block.HasColor)
    {
      look.Colour = { block.Color[0], block.Color[1], block.Color[2] };
    }
    if (block.HasOpacity)
    {
      look.Opacity = block.Opacity;
    }
  });
}

//------------------------------------------------------------------------------
std::string vtkPointSplatMapper::vtkInternals::GetColourKey()
{
  const vtkPointSplatMapper& m = *this->Self;
  vtkScalarsToColors* table = this->Self->GetLookupTable();
  std::ostringstream key;
  key << m.ScalarMode << ' ' << m.ColorMode << ' ' << m.ArrayAccessMode << ' ' << m.ArrayId << ' '
      << m.ArrayName << ' ' << m.ArrayComponent << ' ' << m.InterpolateScalarsBeforeMapping << ' '
      << m.UseLookupTableScalarRange << ' ' << m.ScalarRange[0] << ' ' << m.ScalarRange[1] << ' '
      << m.FieldDataTupleId << ' ' << table << ' ' << (table ? table->GetMTime() : 0);
  return key.str();
}

//------------------------------------------------------------------------------
vtkPointSplatSettings vtkPointSplatMapper::vtkInternals::GetSettings() const
{
  const vtkPointSplatMapper& m = *this->Self;
  vtkPointSplatSettings s;
  s.TargetError = m.TargetError;
  s.Method = m.Method;
  s.Transparency = m.Transparency;
  s.Projection = m.Projection;
  s.TileLists = m.TileLists;
  s.MaximumNumberOfLayers = m.MaximumNumberOfLayers;
  s.GatherRemaining = m.GatherRemaining;
  s.PickOpacityThreshold = m.PickOpacityThreshold;
  s.LayerDistance = m.LayerDistance;
  s.RadiusScale = m.RadiusScale;
  s.MaximumImageMemory = m.MaximumImageMemory;
  s.MaximumWindowMemory = m.MaximumWindowMemory;
  s.PlateauKernel = m.Kernel == PLATEAU;
  s.KernelSigma = m.KernelSigma;
  s.PlateauFalloff = m.PlateauFalloff;
  s.PlateauExponent = m.PlateauExponent;
  s.KernelSupport = m.KernelSupport;
  s.OverlapFactor = m.OverlapFactor;
  s.VoronoiDepth = m.VoronoiDepth;
  s.MaximumNumberOfFillSteps = m.MaximumNumberOfFillSteps;
  s.AntiAliasing = m.AntiAliasing;
  s.LevelOfDetail = m.LevelOfDetail;
  s.Hybrid = m.Hybrid;
  s.Progressive = m.Progressive;
  s.Refraction = m.Refraction;
  s.RefractiveIndex = m.RefractiveIndex;
  s.Dispersion = m.Dispersion;
  s.Absorption = { { m.Absorption[0], m.Absorption[1], m.Absorption[2] } };
  s.Shadows = m.Shadows;
  s.NumberOfShadowSamples = m.NumberOfShadowSamples;
  s.NumberOfInteractiveShadowSamples = m.NumberOfInteractiveShadowSamples;
  s.ShadowLightRadius = m.ShadowLightRadius;
  s.ShadowSeed = m.ShadowSeed;
  s.ShadowLayerDistance = m.ShadowLayerDistance;
  s.ShadowResolution = m.ShadowResolution;
  return s;
}

//------------------------------------------------------------------------------
vtkPointSplatMapper::vtkPointSplatMapper()
  : Internals(new vtkInternals(this))
{
}

//------------------------------------------------------------------------------
vtkPointSplatMapper::~vtkPointSplatMapper()
{
  for (vtkInternals::Drawn& drawn : this->Internals->AllDrawn)
  {
    drawn.Frame->Leave(*this->Internals, nullptr);
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
  vtkInternals& internals = *this->Internals;
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  const bool some = internals.Update(internals.GetSettings(renderer, actor));
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  if (!some)
  {
    return;
  }
  if (internals.ArePrimitivesShown(renderer, actor))
  {
    internals.Report = vtkPointSplatReport();
    internals.Primitives.Render(this, this->GetExecutive()->GetInputData(0, 0), renderer, actor);
    this->UpdateProgress(1.0);
    return;
  }
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    // Tells it how many passes the ids need.
    selector->UpdateMaximumPointId(internals.GetCloud().GetNumberOfPoints());
    selector->UpdateMaximumCellId(internals.GetCloud().GetNumberOfPoints());
  }
  vtkPlaneCollection* planes = this->GetClippingPlanes();
  const int many = planes ? planes->GetNumberOfItems() - vtkPointSplatItem::MostClipPlanes : 0;
  if (many > 0 && !internals.WarnedOfClipPlanes)
  {
    vtkErrorMacro("Only " << vtkPointSplatItem::MostClipPlanes
                          << " clipping planes are honoured; remove " << many << ".");
  }
  internals.WarnedOfClipPlanes = many > 0;
  this->TimeToDraw = 0.0;
  vtkInternals::Drawn& drawn = internals.DrawnIn(renderer);
  if (!drawn.Frame->Present(actor, internals, internals.Report) &&
    drawn.Error != drawn.Frame->GetError())
  {
    drawn.Error = drawn.Frame->GetError();
    vtkErrorMacro("OpenGL cannot draw the splats: " << drawn.Error);
  }
  if (!renderer->GetSelector())
  {
    vtkPointSplatIgnored::Warn(
      this, actor, internals.GetCloud(), internals.Report, internals.WarnedOf);
    const bool refused =
      internals.Report.Settings.Method == DEFERRED && internals.Report.Choice.Refused;
    if (refused && !drawn.Refused)
    {
      vtkWarningMacro(
        "Two passes instead of deferred blending: " << this->GetMethodReason() << ".");
    }
    drawn.Refused = refused;
    const bool noEnvironment = this->Refraction && !internals.Report.HasEnvironment;
    if (noEnvironment && !drawn.NoEnvironment)
    {
      vtkWarningMacro("Nothing is refracted: the renderer has no environment texture, or one "
                      "without a picture, or a cube map whose six faces are not of one size and "
                      "type, of 3 or 4 components of unsigned char (or of float, with "
                      "vtkTexture::SetColorModeToDirectScalars()). Call "
                      "vtkRenderer::SetEnvironmentTexture().");
    }
    drawn.NoEnvironment = noEnvironment;
  }
  drawn.Frame->AskForNext();
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::vtkInternals::ArePrimitivesShown(vtkRenderer* renderer, vtkActor* actor)
{
  if (vtkPointSplatPrimitives::AreShown(actor))
  {
    return true;
  }
  const bool foreign = !vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (foreign && !this->WarnedOfPrimitives)
  {
    this->WarnedOfPrimitives = true;
    vtkWarningWithObjectMacro(this->Self,
      "The window is not drawn by OpenGL, as splats are: the input's cells are drawn in their stead, "
      "or plain vertices where there are none.");
  }
  return foreign;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  // Splats write the ids themselves.
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  if (actor && vtkPointSplatPrimitives::AreShown(actor))
  {
    this->Internals->Primitives.ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
  }
}

//------------------------------------------------------------------------------
vtkPointSplatColours vtkPointSplatMapper::vtkInternals::MapColours(vtkDataSet* data)
{
  vtkPointSplatMapper* m = this->Self;
  vtkPointSplatScalars scalars(m, data);
  if (!scalars.CanBeColours)
  {
    vtkErrorWithObjectMacro(m,
      << "The array " << (scalars.Array->GetName() ? scalars.Array->GetName() : "(without name)")
      << " of bits, of signed char, or of more than 4 components, cannot be colours: choose another "
         "one, or SetColorModeToMapScalars().");
    return {};
  }
  // Of field data each cell has a tuple, unless one is chosen for all, as on meshes.
  vtkPointSplatColours colours;
  colours.Only = scalars.CellFlag == 2 ? m->FieldDataTupleId : -1;
  colours.OfCells = scalars.CellFlag != 0 && colours.Only < 0;
  if (colours.OfCells && data->GetNumberOfCells() == 0)
  {
    return {};
  }
  // Colours, not texture coordinates.
  const vtkTypeBool interpolate = m->InterpolateScalarsBeforeMapping;
  m->InterpolateScalarsBeforeMapping = 0;
  m->ClearColorArrays(); // else those of the block before are taken for this one's
  m->MapScalars(data, 1.0, scalars.CellFlag);
  m->InterpolateScalarsBeforeMapping = interpolate;
  colours.Array = m->Colors;
  if (colours.OfCells && !scalars.AreDirect && m->LookupTable)
  {
    vtkNew<vtkDoubleArray> nan;
    nan->InsertNextValue(vtkMath::Nan());
    vtkSmartPointer<vtkUnsignedCharArray> mapped;
    mapped.TakeReference(m->LookupTable->MapScalars(nan, VTK_COLOR_MODE_MAP_SCALARS, 0));
    if (mapped && mapped->GetNumberOfComponents() == 4)
    {
      std::memcpy(&colours.WithoutCell, mapped->GetPointer(0), 4);
    }
  }
  return colours;
}

//------------------------------------------------------------------------------
vtkPointSplatValues vtkPointSplatMapper::vtkInternals::MapValues(vtkDataSet* data)
{
  vtkPointSplatMapper* m = this->Self;
  vtkPointSplatScalars given(m, data);
  auto scalars = vtkDataArray::SafeDownCast(given.Array);
  // What vtkMapper makes coordinates of, but for types and components that it would stumble over.
  const bool mapped = scalars && given.CellFlag == 0 && scalars->GetDataType() != VTK_BIT &&
    scalars->GetNumberOfTuples() == data->GetNumberOfPoints() && !given.AreDirect;
  if (!mapped)
  {
    return {};
  }
  vtkScalarsToColors* own = scalars->GetLookupTable();
  vtkScalarsToColors* table = own ? own : m->GetLookupTable();
  if (table->GetIndexedLookup() ||
    table->GetVectorComponent() >= scalars->GetNumberOfComponents())
  {
    return {};
  }
  m->ClearColorArrays();
  m->MapScalars(data, 1.0, given.CellFlag);
  vtkPointSplatValues values;
  values.Coordinates = m->GetColorCoordinates();
  values.Table = m->GetColorTextureMap();
  return values;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::GetVertices(vtkActor* actor, vtkPolyData* vertices)
{
  this->Internals->Update(this->Internals->GetSettings(actor));
  this->Internals->GetCloud().MakeVertices(vertices);
}

//------------------------------------------------------------------------------
double* vtkPointSplatMapper::GetBounds()
{
  this->Internals->UpdateInput();
  this->ComputeBounds();
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::ComputeBounds()
{
  // The points' own bounds, as a mesh through them has: splats reach no farther
  // than the surface does. Of what is drawn only: a NaN or a ghost far off must
  // not spoil the camera's reset.
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetExecutive()->GetInputData(0, 0) : nullptr;
  vtkMath::UninitializeBounds(this->Bounds);
  if (input)
  {
    const vtkPointSplatSettings settings = this->Internals->GetSettings();
    if (const std::array<double, 6>* given = this->Internals->FindGivenBounds(input, settings))
    {
      std::copy_n(given->data(), given->at(0) <= given->at(1) ? 6 : 0, this->Bounds);
      return;
    }
    this->Internals->UpdateSplats(input, settings);
    if (this->Internals->GetCloud().GetNumberOfSplats() > 0)
    {
      std::copy_n(this->Internals->GetCloud().GetBounds().data(), 6, this->Bounds);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  auto own = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (own)
  {
    own->MakeCurrent();
    const vtkPointSplatContextScope scope(own);
    this->Internals->GetCloud().Release(own);
    std::vector<vtkInternals::Drawn>& all = this->Internals->AllDrawn;
    for (vtkInternals::Drawn& drawn : all)
    {
      vtkRenderer* renderer = drawn.Frame->GetRenderer();
      if (!renderer || renderer->GetRenderWindow() == own)
      {
        drawn.Frame->Leave(*this->Internals, own);
        drawn.Frame.reset();
      }
    }
    all.erase(std::remove_if(all.begin(), all.end(),
                [](const vtkInternals::Drawn& drawn) { return !drawn.Frame; }),
      all.end());
  }
  this->Internals->Primitives.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

VTK_ABI_NAMESPACE_END
