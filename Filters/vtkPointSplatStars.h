// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatStars
 * @brief   the sizes of splats where points are uneven or the surface bends, and the triangles there
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there. One round disk a point cannot cover
 * what is around it where points are many times as dense on one side as on the other, or where the
 * surface bends by much from one to the next: it would stand off the surface. There disks are as small as they have
 * to be, and vtkPointSplatRefinement puts others between.
 *
 * A site is a slot of a cloud, or a point of a mesh.
 * 1. *Size.* About how far points are apart: the mean distance of the neighbours of a site's star that are
 *    no more than twice as far as the third. Where given normals turn by more than MostTurn (34 degrees)
 *    within that, it is the distance within which they turn by so much, and at least LeastBent of the former.
 *    No size is less than a Grain (vtkPointSplatSheet.h) of the median; of an isosurface's vertices, of which several may lie
 *    next to one sample, none is less than a tenth of it.
 * 2. *Uneven* sites are those with a neighbour in their star that is farther than FarNeighbor sizes, or, of
 *    a cloud, those beside a gap that their disk does not close (3.), those with some witness of less than half of their
 *    size, or, where normals tell that the surface bends, those with a disk of more than LargeDisk times the radius that
 *    their size asks for. Even samplings have none of them, random ones some percent. Those are not looked at any more
 *    about which, as far as stars may reach, all is flat, but for those beside gaps.
 * 3. Their stars are found once more: the triangles between a site and neighbours that are next to each other
 *    around it (Delaunay's in the tangent plane), but for those that reach over holes or lie past borders, and those
 *    over creases at which both splats end at lines, or one does and normals turn by much. All corners of one past a
 *    border are on this, or not in the triangle by their own stars: of a hole's border some neighbours are points behind
 *    that across it. Sites where all is flat, as far as the disk reaches, and no neighbour
 *    is so small that it bounds this, are not uneven: there one large disk harms nothing. Of their triangles those count
 *    that such a disk covers by half, since a corner's own disk is small where all points that it was made from lie to one
 *    side and the surface does not end there, and those over gaps. What is a hole goes by
 *    the spacing of the corner whose nearest points are sparsest: a ring of dense points has no lid. But a ring around a tube,
 *    all of whose nearest points may be its own, has such triangles on both sides: they count, unless the
 *    spacing of the site's sheet tells of a hole. And what no border surrounds (vtkPointSplatBorders.h), and is no wider than a
 *    border is sure to be by the densest corner's, is a gap of a regular sampling, as where a scanner saw nothing and its mesh
 *    was closed; normals of the corners part by less than 60 degrees there. Nor does a triangle count whose corners face both of its sides, where normals tell that: it leads from a body to the next one. No size is
 *    more than the longest edge of its triangles, or if there are none than its spacing: a star may reach to another body in
 *    the same plane, as from an animal's sole to the next.
 * 4. *Grading.* No size is larger than that of a site next to it in such a triangle and Slope of the way to that:
 *    a disk does not reach over a denser part to what lies beyond, which may be an edge. Of a mesh a site that this makes
 *    smaller, and its disk LargeDisk times too large, becomes uneven, too.
 *    Of a mesh, whose curvature triangles tell, sizes are those within which it turns by MostBend, but for WidthShare of
 *    triangles' width, also where a flat face, whose curvature is none, goes over into a round edge of narrow triangles
 *    (vtkPointSplatFans::Bend): fill points that are as near to that have no larger ones. Disks at borders have the room
 *    that these leave (vtkPointSplatMeshBorders.h), and at tips, from which all triangles fall off steeply, as a cone's do, next
 *    to none.
 * 5. *Continued borders.* Where a triangle goes on past a border (vtkPointSplatBorders.h) to a point that is much
 *    sparser, just the denser part of the points ends there, and not the surface.
 */
#ifndef vtkPointSplatStars_h
#define vtkPointSplatStars_h

#include "vtkPointSplatBorders.h"
#include "vtkPointSplatDisks.h"
#include "vtkPointSplatLargeArray.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

class vtkAlgorithm;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatStars
{
public:
  using Site = vtkPointSplatNeighbors::Slot;
  using Triangle = std::array<Site, 3>; // in ascending order
  using PositionGetter = std::function<void(Site, double[3])>;

  /// How a site lies to its neighbours (vtkPointSplatDisks).
  struct Measures
  {
    float Distance, Turn, Farthest;
  };

  /// getPosition: in world coordinates.
  vtkPointSplatStars(std::size_t sites, PositionGetter getPosition);

  /// bends: whether normals tell where the surface bends.
  void SetSize(Site site, const Measures& measures, bool bends);

  /// Whether the surface bends on the way to a disk's rim, and the disk is much larger than its size asks
  /// for. turn: as in vtkPointSplatDisks.
  bool StandsOff(Site site, float turn, float reach) const;

  /// Of those that have a star.
  float GetMedianSize() const;

  /// Makes a site uneven whose splat's radius may be no more than this.
  void Bound(Site site, float radius);

  /// The same where a mesh bends so much that no size is larger than that, and a disk of that radius would stand off.
  void BoundBent(Site site, float size, float radius);
  /// The same at a mesh's tip, of whose disk next to nothing is left.
  void BoundTip(Site site, float radius);
  /// The largest size of what bends so much (1 / world units), as triangles of that width tell.
  static float GetBent(float bend, float width = 0);

  /// Gives all sites with a star this size at least.
  void RaiseSizes(float least);

  /**
   * Finds the triangles of a cloud's uneven sites. normals: 3 floats a slot, of the disks' planes; count: of
   * neighbours. creased: of each slot the splat at a crease, or null. mayBend: as SetSize()'s bends.
   * Returns false if self was aborted.
   */
  struct Cloud
  {
    const vtkPointSplatNeighbors* Neighbors;
    const float* Normals;
    const vtkPointSplatDisks* Disks;
    const vtkPointSplatBorders* Borders;
    const vtkPointSplatCreases* Creases;
    const vtkPointSplatLargeArray<const vtkPointSplatCreases::Splat*>* Creased;
    int Count;
    std::function<bool(Site)> MayBend;
  };
  bool Find(vtkAlgorithm* self, const Cloud& cloud);

  /// The sites at which the borders say that the surface ends, and a triangle that it goes on to where points are
  /// sparser: there just their denser part ends. In order.
  std::vector<Site> FindContinued(const Cloud& cloud) const;

  /// Takes the triangles of a mesh's uneven sites, and of those that grading makes uneven. getRadius: of a site's disk, or 0 if
  /// that stays as it is.
  void Find(const vtkPointSplatFans& mesh, const std::function<float(Site)>& getRadius);

  /// The radius of the splat of an uneven site.
  float GetRadius(Site site) const { return RadiusPerSize * this->Sizes[site]; }
  static float GetRadius(float size) { return RadiusPerSize * size; }
  static float GetSize(float radius) { return radius / RadiusPerSize; }
  /// The size that a site some way off one of another size may have.
  static float GetGraded(float size, float way) { return size + Slope * way; }

  const PositionGetter GetPosition;
  vtkPointSplatLargeArray<float> Sizes; // 0 where there is no star
  vtkPointSplatLargeArray<unsigned char> Uneven;
  std::vector<Site> Tips; // of a mesh, in order
  std::vector<Triangle> Triangles; // each once, in order

private:
  static constexpr float RadiusPerSize = 0.65f;
  static constexpr float Slope = 0.3f;

  bool IsOpen(const Cloud& cloud, Site site) const;
  bool IsHalfCovered(const Cloud& cloud, const Triangle& triangle) const;
  static bool IsBesideGap(const Cloud& cloud, Site site);
  static bool IsOverGap(const Cloud& cloud, const Triangle& triangle, float circumscribed);
  void FindUneven(const Cloud& cloud);
  void Grade();

  static bool IsOverCrease(const Cloud& cloud, const Triangle& triangle);
  bool HasTwoSides(const Cloud& cloud, const Triangle& triangle) const;
  bool IsAway(const Cloud& cloud, const Triangle& triangle, int corner) const;
  bool IsOutside(const Cloud& cloud, const Triangle& triangle) const;
  bool IsOutside(const vtkPointSplatBorders& borders, const Triangle& triangle, int corner) const;
};

VTK_ABI_NAMESPACE_END
#endif
