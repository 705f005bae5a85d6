// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCollection.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSplatDeferred.h"
#include "vtkPointSplatTextures.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
/// How far apart an entry's points are.
struct Spacing
{
  double World;
  double Pixels;       // where they are nearest to the eye
  double MeanPixels;   // between the nearest and the farthest
  double LargestPixel; // world units
};

Spacing SpacingOf(const vtkPointSplatEntry& entry, const vtkPointSplatView& view)
{
  const vtkPointSplatItem& item = entry.Item;
  const glm::dvec2 pixels = view.PixelSizes(item.MCWC, item.Cloud->GetBounds().data());
  const double world = item.GetMeanStretch() * item.Cloud->GetSpacing();
  return { world, world / pixels.x, world / std::sqrt(pixels.x * pixels.y), pixels.y };
}

/// Splats for each pixel of the part of the window that they may cover.
double SplatsPerPixel(const vtkPointSplatEntry& entry, const vtkPointSplatView& view)
{
  const vtkPointSplatCloud& cloud = *entry.Item.Cloud;
  const glm::ivec4 window = view.Cover(entry.Item.MCWC, cloud.GetBounds().data(), 0.0);
  const double pixels =
    std::max(window.z - window.x + 1.0, 1.0) * std::max(window.w - window.y + 1.0, 1.0);
  return static_cast<double>(cloud.GetNumberOfSplats()) / pixels;
}

// From level to level radii grow by this, where points are spread evenly.
constexpr double LevelGrowth = 1.8;
// The largest splats of a block are as much larger than their mean.
constexpr double LevelExcess = 2.0;

// Pixels: where edges of triangles are longer, these are drawn. Meshes have twice as many triangles
// as points, and a record costs the same: below that splats are faster, and their picture is as good
// as the mesh's (Testing/Benchmark/hybrids.py).
constexpr double TrianglePixels = 4.0;

bool IsPoints(const vtkPointSplatEntry& entry)
{
  return entry.Settings.Method == vtkPointSplatSettings::ImageSpace;
}

/// What of an actor's look is blended beside colours.
vtkPointSplatItemLook LookOf(const vtkPointSplatEntry& entry)
{
  const vtkPointSplatCloud& cloud = *entry.Item.Cloud;
  vtkProperty* property = entry.Actor->GetProperty();
  vtkPointSplatItemLook look;
  const vtkPointSplatTextures textures =
    vtkPointSplatTextures::Of(entry.Actor, cloud.HasTangents());
  // As VTK has it, textures of colours have no effect beside values that are mapped at pixels.
  const bool shows = textures.Colours.empty() || !cloud.HasValues();
  look.Coordinates = cloud.HasCoordinates() && !textures.GetAll().empty() && shows;
  look.Tangents = textures.IsAnisotropic || (textures.NeedTangents() && look.Coordinates);
  look.Repeats = look.Coordinates && textures.Repeat();
  look.HasMore = look.Tangents || (look.Coordinates && textures.HasMore());
  look.EdgeWidth = property->GetEdgeVisibility() ? property->GetLineWidth() : 0.0f;
  look.Time = look.Coordinates || look.Tangents
    ? std::max(textures.GetMTime(), entry.Actor->GetMTime())
    : 0;
  return look;
}

/// The box about a cloud, world coordinates.
void FindBox(const vtkPointSplatItem& item, glm::dvec3& low, glm::dvec3& high)
{
  const std::array<double, 6>& b = item.Cloud->GetBounds();
  for (size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 p(item.MCWC *
      glm::dvec4(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)], 1.0));
    low = corner ? glm::min(low, p) : p;
    high = corner ? glm::max(high, p) : p;
  }
}
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkPointSplatCollection::VisibleProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      props.push_back(prop);
    }
  }
  return props;
}

//------------------------------------------------------------------------------
vtkPointSplatEntry vtkPointSplatCollection::MakeEntry(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatSource* source, const vtkPointSplatWishes* wishes)
{
  vtkPointSplatEntry entry;
  entry.Actor = actor;
  entry.Source = source;
  entry.Settings = source->GetSettings(renderer, actor);
  if (wishes)
  {
    wishes->Change(entry.Settings);
  }
  entry.IsEmpty = !source->Update(entry.Settings);
  entry.Item.Cloud = &source->GetCloud();
  entry.Item.MCWC = vtkPointSplatView::Matrix(actor->GetMatrix());
  return entry;
}

//------------------------------------------------------------------------------
vtkPointSplatCollection::Entries vtkPointSplatCollection::Collect(
  vtkRenderer* renderer, bool translucent, const vtkPointSplatWishes* wishes)
{
  Entries entries;
  for (vtkProp* prop : vtkPointSplatCollection::VisibleProps(renderer))
  {
    vtkPointSplatSource* source = vtkPointSplatSource::Of(prop);
    const bool wanted = source &&
      (!wishes ||
        std::find(wishes->Actors.begin(), wishes->Actors.end(), prop) != wishes->Actors.end());
    if (!wanted)
    {
      continue;
    }
    vtkActor* actor = static_cast<vtkActor*>(prop);
    vtkPointSplatEntry entry = vtkPointSplatCollection::MakeEntry(renderer, actor, source, wishes);
    const bool selects = renderer->GetSelector() != nullptr;
    if (entry.IsEmpty ||
      !(selects ||
        (translucent ? actor->HasTranslucentPolygonalGeometry() : actor->HasOpaqueGeometry())))
    {
      continue;
    }
    // What cannot be picked does not hide what can.
    if (!selects ||
      (prop->GetPickable() &&
        actor->GetProperty()->GetOpacity() >= entry.Settings.PickOpacityThreshold))
    {
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCollection::HasOthersBetween(vtkRenderer* renderer, const Entries& entries)
{
  for (vtkProp* prop : vtkPointSplatCollection::VisibleProps(renderer))
  {
    const bool own = std::any_of(entries.begin(), entries.end(),
      [prop](const vtkPointSplatEntry& entry) { return entry.Actor == prop; });
    vtkPointSplatSource* source = vtkPointSplatSource::Of(prop);
    const bool isEmpty = !own && source &&
      !source->Update(source->GetSettings(renderer, nullptr));
    if ((!own && !isEmpty && prop->HasTranslucentPolygonalGeometry()) ||
      (vtkVolume::SafeDownCast(prop) && renderer->GetUseDepthPeelingForVolumes()))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCollection::HasOpaqueAfter(vtkRenderer* renderer, const vtkActor* actor)
{
  bool after = false;
  for (vtkProp* prop : vtkPointSplatCollection::VisibleProps(renderer))
  {
    after = after || prop == actor;
    if (vtkPointSplatSource::Of(prop) || !vtkProp3D::SafeDownCast(prop))
    {
      continue;
    }
    // Assemblies cannot be asked: that would upset the traversal of the one which is drawn now.
    if (!vtkActor::SafeDownCast(prop) ? !vtkVolume::SafeDownCast(prop)
                                      : after && prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkPointSplatFacts vtkPointSplatCollection::Describe(
  const Entries& entries, const vtkPointSplatView& view, bool translucent, double tolerance)
{
  vtkPointSplatFacts facts;
  facts.Translucent = translucent;
  facts.MaximumLayers = 1;
  facts.MaximumFillSteps = 1;
  facts.TargetError = 1.0;
  for (const vtkPointSplatEntry& entry : entries)
  {
    const vtkPointSplatSettings& s = entry.Settings;
    facts.AsksDeferred = facts.AsksDeferred || s.Method == vtkPointSplatSettings::Deferred;
    facts.AsksPoints = facts.AsksPoints || IsPoints(entry);
    // All share the layers, so that one mapper's wish decides.
    facts.AsksQuads = facts.AsksQuads || s.Projection == vtkPointSplatSettings::Quads;
    // Sorting by hand counts for more than peeling by hand, and the first of its kind decides.
    if (facts.Transparency <= vtkPointSplatSettings::Peeling &&
      s.Transparency != vtkPointSplatSettings::AutomaticTransparency)
    {
      facts.Transparency = s.Transparency;
    }
    facts.MaximumLayers = std::max(facts.MaximumLayers, s.MaximumNumberOfLayers);
    facts.MaximumFillSteps = std::max(facts.MaximumFillSteps, s.MaximumNumberOfFillSteps);
    facts.TargetError = std::min(facts.TargetError,
      s.TargetError >= 0.0 ? s.TargetError : vtkPointSplatChoices::FullQuality); // of NaN
  }
  tolerance = std::max(tolerance, facts.TargetError);
  for (const vtkPointSplatEntry& entry : entries)
  {
    const vtkPointSplatLevels& levels = entry.Item.Cloud->GetLevels();
    const bool wanted = entry.Settings.LevelOfDetail;
    facts.Levels = facts.Levels || (wanted && levels.AreMade());
    facts.LevelsUnderWay = facts.LevelsUnderWay || (wanted && levels.IsUnderWay());
    // To find it takes a pass over the points, once: only where it can matter.
    const bool matters = IsPoints(entry) || tolerance > vtkPointSplatChoices::FullQuality;
    facts.Clouds.push_back({ static_cast<double>(entry.Item.Cloud->GetNumberOfSplats()),
      !matters            ? 0.0
        : IsPoints(entry) ? SpacingOf(entry, view).Pixels
                          : SpacingOf(entry, view).MeanPixels,
      SplatsPerPixel(entry, view),
      entry.Item.Cloud->HasColours() || entry.Item.Cloud->GetFactorCount() > 0 ||
        entry.Settings.Shadows });
  }
  return facts;
}

//------------------------------------------------------------------------------
void vtkPointSplatCollection::MakeGroups(
  const Entries& entries, const vtkPointSplatView& view, vtkPointSplatFacts& facts)
{
  vtkIdType bytes = 0;
  bool made = true;
  for (const vtkPointSplatEntry& entry : entries)
  {
    const vtkPointSplatSettings& s = entry.Settings;
    made = made &&
      entry.Item.Cloud->MakeGroups({ s.OverlapFactor, s.RadiusScale * s.KernelSupport, 0, false });
    facts.Groups = std::max(facts.Groups, entry.Item.Cloud->GetGroups().GetNumberOfGroups());
    bytes = std::max(bytes, s.MaximumImageMemory);
  }
  facts.Groups = made ? facts.Groups : 0;
  facts.GroupsFit = vtkPointSplatDeferred::Fits(view.Size, facts.Groups, bytes);
}

//------------------------------------------------------------------------------
void vtkPointSplatCollection::MakeItem(vtkPointSplatEntry& entry, int slot,
  const vtkPointSplatView& view, const vtkPointSplatChoice& choice)
{
  const vtkPointSplatSettings& s = entry.Settings;
  vtkPointSplatItem& item = entry.Item;
  vtkPointSplatCloud& cloud = *item.Cloud;
  vtkProperty* property = entry.Actor->GetProperty();
  vtkProperty* back = entry.Actor->GetBackfaceProperty();
  const bool given = s.LayerDistance > 0.0;
  item.Slot = slot;
  item.Culling =
    (property->GetBackfaceCulling() ? 1 : 0) | (property->GetFrontfaceCulling() ? 2 : 0);
  item.IsFlat = property->GetInterpolation() == VTK_FLAT && property->GetLighting() &&
    !IsPoints(entry);
  item.Look = LookOf(entry);
  item.RadiusScale = s.RadiusScale;
  item.StrideShift = choice.StrideShifts[static_cast<size_t>(slot)];
  if (choice.Transparency > vtkPointSplatSettings::Peeling)
  {
    // So that those nearer than their radii are apart.
    cloud.MakeGroups({ 1.0, s.RadiusScale, choice.CoveringGroups, false });
    item.CoveringScale = cloud.GetGroups().GetLargestScale();
  }
  item.LayerDistance = given ? s.LayerDistance : 0.0;
  item.LayerRadii = given ? 0.0 : choice.LayerRadii;
  const double scale = item.GetStretch() * s.RadiusScale;
  const double largest = scale * cloud.GetMaximumRadius();
  // A few splats that are much larger than the others must not coarsen the unit of depths for all.
  const double common = std::min(largest, 1.5 * scale * cloud.GetMedianRadius());
  item.LargestLayer = given ? s.LayerDistance : choice.LayerRadii * common;
  item.Kernel.Plateau = s.PlateauKernel;
  item.Kernel.Shape = s.PlateauKernel
    ? glm::vec2(s.PlateauFalloff, s.PlateauExponent)
    : glm::vec2(0.5 / (s.KernelSigma * s.KernelSigma), 0.0);
  item.Kernel.Support = s.KernelSupport;
  item.IsPoints = IsPoints(entry);
  if (item.IsPoints)
  {
    const Spacing spacing = SpacingOf(entry, view);
    vtkPointSplatPoints& points = item.Points;
    points.Layer = given ? s.LayerDistance : spacing.World;
    points.LayerPixels = given ? 0.0 : choice.LayerPixels;
    points.Spacing = spacing.World;
    points.SpacingPixels = spacing.Pixels;
    points.Silhouettes = s.AntiAliasing;
    item.LargestLayer = std::max(points.Layer, points.LayerPixels * spacing.LargestPixel);
  }
  const double* colour = property->GetColor();
  const double opacity = cloud.HasOwnOpacity() ? 1.0 : property->GetOpacity();
  item.Colour = cloud.HasColours() ? glm::vec4(1.0, 1.0, 1.0, opacity)
                                   : glm::vec4(colour[0], colour[1], colour[2], opacity);
  item.Opacities =
    glm::vec2(opacity, back && !cloud.HasColours() ? back->GetOpacity() : opacity);
  if (item.Look.Coordinates && vtkPointSplatTextures::Of(entry.Actor, false).AreTranslucent())
  {
    item.Opacities = glm::vec2(0.0f); // how little light comes through is not known before
  }
  item.ClipPlanes = vtkPointSplatItem::ClipPlanesOf(entry.Source->GetMapper());
  // Splats that bend rise at their rim by half the squared support, in radii, at most.
  const double farthest =
    std::max(std::hypot(s.KernelSupport, 0.5 * s.KernelSupport * s.KernelSupport),
      std::hypot(1.0, 0.5) * item.CoveringScale);
  item.Window = view.Cover(
    item.MCWC, cloud.GetBounds().data(), farthest * item.GetStrideScale() * largest);
}

//------------------------------------------------------------------------------
void vtkPointSplatCollection::UseLevels(
  vtkPointSplatEntry& entry, const vtkPointSplatView& view, const vtkPointSplatChoice& choice)
{
  vtkPointSplatItem& item = entry.Item;
  item.Levels = vtkPointSplatLevelBounds();
  const bool held = item.IsStreamed || item.Cloud->Fits(item.Cloud->GetNumberOfStoredSplats());
  // What textures need is known of points alone.
  if (choice.LevelPixels <= 0.0 || !item.Look.IsPlain() ||
    !entry.Settings.LevelOfDetail || !held)
  {
    return;
  }
  const glm::dvec2 pixels = view.PixelSizes(item.MCWC, item.Cloud->GetBounds().data());
  if (!item.Cloud->GetLevels().AreMade())
  {
    // As dense as all will be.
    const double radius = item.GetMeanStretch() * item.RadiusScale *
      item.Cloud->GetUsualRadius() * std::sqrt(item.Cloud->GetShare());
    const double most = item.IsPoints ? choice.PointLevelPixels : choice.SmoothLevelPixels;
    if (LevelGrowth * radius <= most * std::sqrt(pixels.x * pixels.y))
    {
      item.Cloud->WantLevels();
    }
    return;
  }
  if (item.IsPoints)
  {
    if (item.StrideShift == 0) // else they are fewer still
    {
      item.Levels = { 0.5 * choice.PointLevelPixels, choice.PointLevelPixels, choice.LevelDeviation };
    }
    return;
  }
  item.Levels = { choice.LevelPixels, choice.SmoothLevelPixels, choice.LevelDeviation };
  item.StrideShift = 0;
  // What is drawn is larger than the points' splats, but never by more than some pixels.
  const double largest = LevelExcess * choice.SmoothLevelPixels;
  const int margin = static_cast<int>(std::ceil(item.Kernel.Support * largest));
  item.Window = { std::max(item.Window.x - margin, 0), std::max(item.Window.y - margin, 0),
    std::min(item.Window.z + margin, view.Size.x - 1),
    std::min(item.Window.w + margin, view.Size.y - 1) };
  if (item.LayerRadii > 0.0)
  {
    // As above, of common splats.
    item.LargestLayer =
      std::max(item.LargestLayer, item.LayerRadii * choice.SmoothLevelPixels * pixels.y);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCollection::UseTriangles(
  vtkPointSplatEntry& entry, const vtkPointSplatView& view)
{
  vtkPointSplatItem& item = entry.Item;
  vtkPointSplatCloud& cloud = *item.Cloud;
  item.TrianglePixels = 0.0;
  // Looks and colours of cells are known of splats alone.
  if (entry.Settings.Hybrid == vtkPointSplatSettings::HybridOff || !item.Look.IsPlain() ||
    item.IsPoints || cloud.HasCellColours() || !cloud.Fits(cloud.GetNumberOfStoredSplats()))
  {
    return;
  }
  cloud.MakeTriangles();
  const double nearest = view.PixelSizes(item.MCWC, cloud.GetBounds().data()).x;
  const bool magnified =
    item.GetMeanStretch() * cloud.GetTriangles().GetLongestEdge() >= TrianglePixels * nearest;
  item.TrianglePixels = cloud.GetTriangles().AreMade() && magnified ? TrianglePixels : 0.0;
}

//------------------------------------------------------------------------------
vtkPointSplatMaterials::Entry vtkPointSplatCollection::MakeMaterial(
  const vtkPointSplatEntry& entry)
{
  const vtkPointSplatSettings& s = entry.Settings;
  const vtkPointSplatItemLook& look = entry.Item.Look;
  vtkPointSplatMaterials::Entry material{ entry.Actor, entry.Item.Cloud->HasColours(),
    entry.Item.Cloud->HasOwnOpacity(), s.Shadows, {}, look.Coordinates || look.Tangents,
    look.Tangents, look.EdgeWidth > 0.0f };
  if (s.Refraction)
  {
    material.Medium.Refracts = true;
    material.Medium.Index = s.RefractiveIndex;
    material.Medium.Dispersion = s.Dispersion;
    material.Medium.Absorption = { s.Absorption[0], s.Absorption[1], s.Absorption[2] };
    FindBox(entry.Item, material.Medium.Low, material.Medium.High);
  }
  return material;
}

//------------------------------------------------------------------------------
double vtkPointSplatCollection::LayerDistanceOf(const vtkPointSplatSettings& settings,
  const vtkPointSplatChoice& choice, vtkPointSplatCloud& cloud)
{
  return settings.LayerDistance > 0.0                       ? settings.LayerDistance
    : settings.Method == vtkPointSplatSettings::ImageSpace ? cloud.GetSpacing()
    : choice.LayerRadii * settings.RadiusScale * cloud.GetMedianRadius();
}
