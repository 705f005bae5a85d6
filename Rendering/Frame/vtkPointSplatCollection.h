// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The splat actors of a renderer that are drawn together, and what is known of them.
#ifndef vtkPointSplatCollection_h
#define vtkPointSplatCollection_h

#include "vtkPointSplatChoices.h"
#include "vtkPointSplatItem.h"
#include "vtkPointSplatMaterials.h"
#include "vtkPointSplatSource.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

/**
 * What a render pass wants: only some actors, with some settings of its own.
 */
struct vtkPointSplatWishes
{
  std::vector<vtkActor*> Actors;
  std::function<void(vtkPointSplatSettings&)> Change;
};

/**
 * An actor to draw, and the item that is made of it.
 */
struct vtkPointSplatEntry
{
  vtkActor* Actor = nullptr;
  vtkPointSplatSource* Source = nullptr;
  bool IsEmpty = false; // there are no splats
  vtkPointSplatSettings Settings;
  vtkPointSplatItem Item;
};

class vtkPointSplatCollection
{
public:
  using Entries = std::vector<vtkPointSplatEntry>;

  /// Props that are visible.
  static std::vector<vtkProp*> VisibleProps(vtkRenderer* renderer);

  /**
   * The splat actors to draw in a pass; those of a hardware selection are drawn as if they were
   * opaque. wishes: or null.
   */
  static Entries Collect(
    vtkRenderer* renderer, bool translucent, const vtkPointSplatWishes* wishes);
  /// What an actor is drawn as; the splats are brought up to date.
  static vtkPointSplatEntry MakeEntry(vtkRenderer* renderer, vtkActor* actor,
    vtkPointSplatSource* source, const vtkPointSplatWishes* wishes);

  /// Whether something translucent that is none of the entries may lie between their layers.
  static bool HasOthersBetween(vtkRenderer* renderer, const Entries& entries);

  /// Whether opaque props that are no splats are drawn after an actor, or may be.
  static bool HasOpaqueAfter(vtkRenderer* renderer, const vtkActor* actor);

  /// What choices depend on. tolerance: the greatest error that may be allowed.
  static vtkPointSplatFacts Describe(
    const Entries& entries, const vtkPointSplatView& view, bool translucent, double tolerance);

  /// Makes groups for deferred blending; facts get how many there are, and whether they fit.
  static void MakeGroups(
    const Entries& entries, const vtkPointSplatView& view, vtkPointSplatFacts& facts);

  /// Makes the item of an entry in a slot.
  static void MakeItem(vtkPointSplatEntry& entry, int slot, const vtkPointSplatView& view,
    const vtkPointSplatChoice& choice);
  /**
   * Lets splats of levels stand for others, if the entry's cloud has some; else asks for them where
   * they would be of use: where those of level 1 would be small enough to be drawn.
   */
  static void UseLevels(
    vtkPointSplatEntry& entry, const vtkPointSplatView& view, const vtkPointSplatChoice& choice);
  /// Lets triangles stand for splats where they are magnified, if the entry's cloud has some; after
  /// UseLevels().
  static void UseTriangles(vtkPointSplatEntry& entry, const vtkPointSplatView& view);
  static vtkPointSplatMaterials::Entry MakeMaterial(const vtkPointSplatEntry& entry);

  /// The least distance of layers for a splat of median size, or between points, world units.
  static double LayerDistanceOf(const vtkPointSplatSettings& settings,
    const vtkPointSplatChoice& choice, vtkPointSplatCloud& cloud);
};

#endif
