// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLattice
 * @brief   which vertices of a volume's isosurface are next to one another, told by their positions
 *
 * An internal helper of vtkPointSplatEstimation. Where the surface has noise of the volume's, or bends within a voxel, no
 * distance and no normal tells a point's neighbours on it from others. But the vertices of isosurfaces that marching
 * cubes and their like extract lie on the edges of the volume's lattice, and so say which edges the surface crosses:
 *
 * 1. *Lattice.* Two coordinates of each vertex are those of planes of the lattice (vtkPointSplatLatticePlanes.h).
 * 2. *Crossings.* Each point is assigned to its edge; or to a sample of the volume where all three coordinates are planes',
 *    as where a sample is the isovalue. Points that share one are one. Up to a quarter of the points may be on no edge, as
 *    those are along which a surface was clipped.
 * 3. *Samples.* From one end of an edge to the other the side of the surface changes where a point lies on it, and stays
 *    where none does. Of an edge that has a point at an end that is not known. Of what stays apart by this
 *    normals say which side is outside (vtkPointSplatLatticeSides.h).
 * 4. *Triangles* are those of marching cubes (vtkMarchingCubesTriangleCases), and where the surface was cut off those of
 *    vtkPointSplatLatticeTorn. Few points have none: where one sample alone is the isovalue and all around it are less, the
 *    surface has no area.
 *
 * Of many labels' surfaces 3 and 4 are those of vtkPointSplatLatticeLabels, of several isosurfaces of one volume those of
 * vtkPointSplatLatticeLevels: where edges have several points, or normals contradict the sides of one.
 *
 * All points have to be such vertices, or on a cut, of nearly all of the surface within the box that they span, or nothing is
 * found: a voxel around whose faces the sides contradict one another is one outside of the volume, or one of which points are
 * missing, beside a cut or where the surface was cropped, or the points are no isosurface's. Of such voxels there may be a tenth
 * as many as points, and of their points nearly all have to be in a triangle, which those are not where a mesh spans several
 * voxels. But where all of its points are another process' (DUPLICATEPOINT), the rest is elsewhere.
 * What was cut off has to be one surface, not several ones' or labels'. Points most of which lie equally far between planes
 * are a mask's, unless all normals lie along their edges: those are of a grid on each of a box's faces, and are searched as
 * others are.
 */
#ifndef vtkPointSplatLattice_h
#define vtkPointSplatLattice_h

#include "vtkPointSplatLatticeCases.h"
#include "vtkPointSplatLatticePlanes.h"
#include "vtkPointSplatLatticeSides.h"
#include "vtkPointSplatLatticeTorn.h"
#include "vtkPointSplatLatticeVoxel.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLattice
{
public:
  /// Points with used[id] not 0, 3 coordinates and 3 floats of a unit normal each, to the outside or 0. ghosts: vtkGhostType,
  /// or null.
  struct Cloud
  {
    const std::vector<double>& Positions;
    const std::vector<unsigned char>& Used;
    const float* Normals;
    const unsigned char* Ghosts;
  };

  explicit vtkPointSplatLattice(const Cloud& cloud)
    : Points(cloud)
    , Torn(cloud.Positions, cloud.Normals)
  {
  }

  /// Returns whether the points are an isosurface's vertices.
  bool Find();

  std::vector<vtkIdType> Corners; // 3 a triangle
  /// The point that stands for a point, which is itself, or the first one at the same place; empty where all are.
  std::vector<vtkIdType> Same;

private:
  using Crossing = vtkPointSplatLatticeCases::Crossing;
  using Voxel = vtkPointSplatLatticeVoxel;
  struct Row
  {
    std::int64_t Index; // over all y and z
    std::size_t First, Last;
  };

  /// Where a point lies: of each coordinate the plane, or the last one before it.
  struct Place
  {
    vtkIdType Id;
    std::int64_t Index[3];
    bool IsPlane[3];

    bool IsOnEdge() const { return this->IsPlane[0] + this->IsPlane[1] + this->IsPlane[2] >= 2; }
    /// Of the edge, or AtSample.
    int GetAxis() const
    {
      return !this->IsPlane[0] ? 0 : !this->IsPlane[1] ? 1 : !this->IsPlane[2] ? 2 : vtkPointSplatLatticeCases::AtSample;
    }
  };

  bool FindPlanes();
  Place GetPlace(vtkIdType id) const;
  bool FindPlaces(std::vector<Place>& places, std::vector<Place>& off) const;
  bool FindBox(const std::vector<Place>& places, const std::vector<Place>& off);
  std::int64_t GetSample(const Place& place) const;
  void AddOff(const Place& place);
  bool FindCrossings();
  bool IsGrid() const;
  double GetBetween(std::size_t crossing, int axis) const;
  bool HasLabels() const;
  bool JoinPoints();
  void FindRows();
  const Row* GetRow(std::int64_t index) const;
  bool FindSurface();
  bool FindLabels();
  bool FindSides();
  bool HasOneSurface() const;
  bool HasTornVoxels() const;
  void FindTriangles();
  template <typename Visitor>
  bool March(const Row& row, const Visitor& visit) const;
  template <typename Visitor>
  bool MarchAlong(std::int64_t index, const Visitor& visit) const;
  template <typename Element, typename Visitor>
  bool VisitVoxels(std::vector<Element>& all, const Visitor& visit) const;

  bool HasPolygons(const std::vector<unsigned char>& cornered) const;
  bool IsElsewhere(const Voxel& voxel) const;

  const Cloud Points;
  vtkPointSplatLatticePlanes Axes[3];
  std::int64_t First[3] = { 0, 0, 0 }; // of the planes that points lie on
  std::int64_t Size[3] = { 0, 0, 0 }; // of the box in samples, and one on each side
  std::vector<Crossing> Crossings;
  vtkPointSplatLatticeTorn Torn; // with the points on no edge
  bool Several = false; // points on an edge
  std::vector<Row> Rows;
  std::vector<vtkPointSplatLatticeSides::Part> Sides; // of all voxels
};

VTK_ABI_NAMESPACE_END
#endif
