// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatEstimation
 * @brief   normals where missing and the size of a splat for each point of a cloud
 *
 * The splats are disks (circles, or ellipses) in the points' tangent planes that cover the
 * surface without holes and reach no farther than their own sheet's points say.
 *
 * Input: any vtkPointSet with points of any type; of cells only a vtkPolyData's polygons and
 * strips are used: where there are such, the points are a mesh's vertices, and their sizes, and
 * normals where these are missing, come from its triangles.
 * Coordinates may lie far from the origin: everything is measured from point to point.
 *
 * Output: a vtkPolyData with the same points in the same order, and behind them fill points if FillGaps
 * is on; all of the input's point data, of fill points interpolated, and field data, no cells, and
 * - the active normals (3 floats, unit length): those of the input, normalised and with their
 *   sign, where they are finite and not zero (but for stage 4's exception), otherwise those of the triangles, otherwise
 *   estimated;
 * - `SplatRadius` (1 float, world units) and `SplatPlaneNormal` (3 floats, unit length: the
 *   normal of the disk's plane, the point's normal but for stage 4's exception; 0 for bodies alone,
 *   stage 7, which have none; on the side that shows the front, which is that of the normal, but that of
 *   triangles, as marching cubes orders their corners, where a volume's gradients are of another surface) and
 *   `SplatCurvature` (6 floats, XX, YY, ZZ, XY, YZ, XZ, 1 / world units: the second fundamental
 *   form as a tensor across the normal, 1 / R on a sphere with outward normals; 0 where it is
 *   not known) if Shape is Circular, or
 * - `SplatAxis1`, `SplatAxis2` (3 floats each, world units) if it is Elliptical: the half axes,
 *   perpendicular to each other and to the normal, the first the longer.
 * Where there are creases and the input has normals, or borders, also
 * - `SplatClip` (6 floats, 1 / world units: two vectors c = n / d, each of a line in the disk's
 *   plane at the distance d from the point, where its face ends; n points to what is cut away; 0:
 *   no line), and for creases
 * - `SplatFold` (6 floats, two unit vectors or 0: the normals of the planes in which the splat goes
 *   on behind its lines) where given normals are averages of two or three faces'.
 * Where there are fill points, also `SplatSource` (1 vtkIdType: the input's point that a point is, or that a
 * fill point is nearest to).
 * A mapper's blending kernel reaches 1.5 to 2 times farther than these.
 *
 * Stages (for triangles' corners, unless Shape is Elliptical, stages 4 and 5 are those of
 * vtkPointSplatFans.h: the triangles' other corners are the neighbours, the radius follows from
 * the edges and from what covering each triangle by its three disks asks for, and nothing is
 * searched for if all points are such and have normals. Points with normals that are all vertices of
 * isosurfaces of one volume, turned or not, or of one that was cut off, tell its triangles by where they lie, vtkPointSplatLattice.h):
 * 1. *Neighbours.* For each point the NumberOfNeighbors nearest ones, found for all points at
 *    once. Of points at the same position one takes part, and the others share its result.
 * 2. *Normals*, where the input has none, or triangles that run the same way along an edge made them cancel
 *    (vtkPointSplatMeshNormals::MendSeams()): of triangles' corners the mean of their triangles' normals, on the side that
 *    the order of their corners tells, or at edges of more than 30 degrees of a mesh in which these end flat faces the mean of one face's
 *    (vtkPointSplatMeshNormals.h); of others that of a surface of second order through the neighbours (vtkPointSplatQuadric.h), which are
 *    two or three times as many where these are off it by noise. Where they lie in a row, of scan
 *    lines as of a solver's grid, that is any; there farther neighbours tell, if rows side by side lie in a surface, and
 *    where noise takes points off their row, four times as many (vtkPointSplatRows.h).
 * 3. *Orientation* of the normals from stage 2, either towards the Viewpoint, or consistently:
 *    along a minimum spanning tree over the neighbours (Hoppe et al. 1992, Surface
 *    Reconstruction from Unorganized Points, section 3.3), in which the normal is carried on
 *    as if along a circle's arc, and edges that leave the tangent planes cost more, so that
 *    it does not jump to another sheet; so do those to the tip of a wedge, which seems to be a sheet
 *    in the middle of its faces. Given normals start the tree; a piece of surface
 *    without any is turned outward at its extreme point. Where the input says where the sensor
 *    stood that saw a point, the normal faces it, and starts the tree for points of sensors that
 *    nobody knows (not finite): a point array `SensorPosition` (3 components, world units), or
 *    a field array `SensorPosition` of one position a scan with a point array `ScanId` (1
 *    component, counted from 0). Such arrays of wrong shape, or scans without position, are an error, and
 *    are not used.
 * 4. *Disk.* Of the neighbours only those of the point's own sheet count: between two points of a
 *    sheet the surface runs about as a circle's arc, so that their normals are mirror images in the
 *    plane half way (vtkPointSplatSheet.h). Neighbours within two spacings, the point's own or the
 *    median of its part, whichever is less, may be off by 0.6 spacings, for noise; farther ones only by a tenth of their
 *    distance, and they count only where a third of them is of the sheet, or a tenth and these are on exact arcs, as the next ring
 *    of a tube among other tubes. Normals more than 78
 *    degrees apart are of two faces at an edge, unless there is nothing else, as on a body of a few
 *    points. Where the normal does not fit the neighbours' at all (as at seams of meshes whose
 *    triangles are not oriented consistently), the plane that fits them takes its place, if their own
 *    normals are across it: those around a body of a few points are not. Then the point's normal, too, is replaced by that of
 *    the surface through the neighbours, if these are all around and theirs are across the plane (vtkPointSplatNormalSeams.h);
 *    GetNumberOfMendedNormals() counts them. The plane, but not the normal, is another where normals lean over by more than 7
 *    degrees from a plane that the neighbours lie on, as normals do that shade a coarse mesh's facets smoothly.
 *    The neighbours are projected to the tangent plane (Pajarola, Sainz, Guidotti 2004, Confetti,
 *    section 4.3), as far off as they are in space, and bisectors cut the point's Voronoi cell out
 *    of it. The radius is the mean distance (at borders 0.6 of it) of the neighbours that share
 *    the cell's edges, weighted by their lengths, and no more than the distance of the cell's
 *    farthest vertex; or more where a Delaunay triangle around the point needs it: what must be
 *    covered is each triangle by its three disks together, so that one with an obtuse angle asks
 *    less than its circumcentre's distance. Where the cell stays open, four times as
 *    many neighbours are looked at, and if the nearest lie in a row, one a leaf of the search tree,
 *    which reaches past it; what does not close the cell all around is left out then, but for rows
 *    at borders, which take the size of the points in the next row. Where a
 *    part of the cloud is as regular as a mesh's vertices are, gaps much larger than usual are holes in
 *    the surface; in random samplings such are to be closed. Parts are what neighbours connect that are as dense, if they have a
 *    thousand points: what is beside them, however many points it has, says nothing of them (vtkPointSplatSamplings.h). What holes and normals that do not fit
 *    tell is known after all points are looked at; so those beside a hole are looked at once more
 *    without the neighbours across it, and those beside such a normal with the plane in its place;
 *    and points of more than twice the median's spacing whose neighbours are as sparse, and mostly found others on their sheet, with
 *    their own spacing alone: where a mesh is coarser than elsewhere, or has something finer beside it, most points say nothing of
 *    which neighbours are near. Spray is as sparse all around, too, but alone.
 *    Points with given normals whose neighbours are mostly of other sheets, and not all around on their own, may be
 *    hemmed in: where dense points lie close to a sparse part of the surface, as those of a belt on a body, the nearest
 *    ones are all theirs. Such points are looked at once more among the points of sparse parts alone
 *    (vtkPointSplatSparsePart.h), and where those do not help with farther neighbours.
 *    For ellipses all this is done in the plane scaled along the principal axes of the neighbours'
 *    covariance (Confetti, section 4.2, equation 3) until it is round there.
 *    Circular disks also get the surface's *curvature*: the second fundamental form that fits
 *    normals and heights of the sheet's neighbours best, by least squares
 *    (vtkPointSplatCurvature.h has the equations). What those do not agree on is left out, since
 *    noise has no curvature, and a tenth of the rest. The normal turns by no more than 0.6 (34
 *    degrees) from the centre to the rim, but the disk keeps three quarters of its radius: it does
 *    not leave a tube or a fold.
 * 5. *Creases.* Where near neighbours' normals have turned by more than an arc between the two
 *    explains, and agree where to, points are looked at with their 32 nearest neighbours. Those whose
 *    normals and heights a surface of second order explains are on the point's own face
 *    (vtkPointSplatFace.h). The others vote where their faces meet it, at what angle: from 20
 *    degrees on, and more where normals are noisy, that is a crease (vtkPointSplatCrease.h); a
 *    fillet of more than two spacings' radius bends all the way, and is none. The nearest two lines
 *    clip the splat (Zwicker et al. 2004, Perspective Accurate Splatting, section 4), whose disk is
 *    estimated anew, as if the face went on behind them (vtkPointSplatCreases.h). Curved edges,
 *    convex and concave ones, corners, faces with reflex corners, and vertices that are there once
 *    for each face all are covered; where neighbours do not tell these vertices' lines, their normals do.
 *    A point with an average of faces' normals, as mesh vertices on edges have, lies on the planes
 *    of two or three faces that meet there. Its disk's plane is that of the face whose normal is
 *    nearest, ends at the lines, and `SplatFold` has the others: drawn in all of them with the
 *    point's own normal it shades as a mesh does, from face to face over a
 *    triangle's width. Of a face that is one or two spacings wide, as the top of a rib, a row of points alone lies
 *    between such edges, or none: then the plane through both edges is it. A disk that would reach over an edge that
 *    was not found is left to stage 6. Without given normals, or where IsRough(), creases are not looked for:
 *    estimated normals turn over the width of their neighbourhood, as on a fillet. Points without, as
 *    degenerate triangles of an isosurface leave some, say nothing of the others while most have one.
 *    *Borders*: where the sampling is as regular as a mesh's vertices, all over or from one point to the next, the surface ends between the
 *    points that its outline and its holes go through, and lines through these clip their splats, and
 *    those beside that would reach over (vtkPointSplatBorders.h). A mesh ends at edges that one triangle alone has, and so
 *    does each of its faces where it is split between them; where its outline turns inward there is a second splat, a fill
 *    point, since the surface is what either of two lines leaves. Random samplings
 *    end somewhere between their last points and the surface's border: there a line a little past the
 *    outermost of them clips all splats that reach over it. Where IsNoisy(), borders are not looked for.
 *    On tubes whose rings of points are farther apart than the tube is wide two lines clip disks beside the axis, which else would leave it.
 * 6. *Fill*, if FillGaps is on, Shape is Circular and the point is on no crease. Where points are much denser on one
 *    side than on the other, as of meshes whose triangles are few where faces are flat, where normals, given ones or those of
 *    points without noise, turn by more than 34 degrees from one point to the next, as on tubes, rims and small bodies, and where the surface bends and
 *    the disk would be 1.4 times as large as distances to the neighbours ask for, as it would between triangles that are long
 *    or of a face that is one triangle wide, no round disk covers
 *    what is around a point and does not stand off the surface. There disks are as small as the densest part and
 *    the bend ask for, graded from point to point (vtkPointSplatStars.h), and fill points lie between those that are
 *    farther apart than that (vtkPointSplatRefinement.h), with normals between theirs; so they do in holes of a regular
 *    sampling that no border surrounds, since these are gaps. Without it disks are as large as gaps are. Even samplings
 *    have no fill points but at meshes' borders, random ones few. A mesh, and so an isosurface's vertices, is
 *    split at its sharp edges, of 45 degrees, or of 30 where they end flat faces: there a point has a disk in the plane of each face, and
 *    those on other faces than its first one are fill points in its place. All are shaded with its normal, if it has one
 *    (vtkPointSplatMesh.h). A point on a crease whose splat, as small as the denser face asks for, is a third of those beside
 *    it on the other face has one more of their size there (vtkPointSplatFoldSides.h). Noise (IsNoisy()) of points at random does not count as bend,
 *    nor do steps that normals do not follow (vtkPointSplatDisks::TrustNormals()).
 * 7. *Bound.* No disk is larger than two and a half times those of its neighbours, which keeps
 *    outliers small. A point with no neighbour of its own sheet is a body alone, and so are points
 *    that no surface goes through (vtkPointSplatBodies.h): along a curve with nothing beside it;
 *    and, without given normals, where points fill a volume (those of tubes are on surfaces of second order), and far from all others. Half of the
 *    distance to what is nearest is a body's radius, and at most the cloud's median radius. It has
 *    no plane, and is seen from all sides, since what draws it turns it to who looks. Its
 *    curvature is a ball's, or 0 where the point's normal is given, which it then shades with.
 *    GetNumberOfPointsAlone() counts them. With no neighbour at all, for a lone point, the radius
 *    is 0.1. Ellipses of bodies lie across their points' normals.
 *
 * Bad input: points with a coordinate that is not finite (or beyond 1e37), and hidden ones
 * (vtkGhostType has HIDDENPOINT), take no part; they stay in the output, with radius 0, and
 * their number is reported. Duplicate ghost points (DUPLICATEPOINT, another process' points)
 * serve as neighbours, but get the radius 0, so that no splat is drawn twice. Polygons and
 * strips that index points which are not there are left out, and their number is reported. Points of
 * no other triangles than those without area get radius 0. An empty input gives an empty output.
 *
 * Results do not depend on the number of threads. The filter reports progress and can be
 * aborted, with an empty output then.
 */
#ifndef vtkPointSplatEstimation_h
#define vtkPointSplatEstimation_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkAbstractArray;
class vtkPointSet;
class vtkPoints;

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatEstimation : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatEstimation* New();
  vtkTypeMacro(vtkPointSplatEstimation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    Circular = 0,
    Elliptical = 1
  };
  enum OrientationType
  {
    Consistent = 0,
    TowardsViewpoint = 1
  };

  ///@{
  /**
   * How many neighbours of a point say how its surface runs there; 4 to 32, 12 by default.
   * More of them smooth estimated normals.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 4, 32);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Circular (default) gives `SplatRadius`, Elliptical `SplatAxis1` and `SplatAxis2`. Ellipses
   * fit samplings that are denser in one direction, as of scan lines.
   */
  vtkSetClampMacro(Shape, int, Circular, Elliptical);
  vtkGetMacro(Shape, int);
  void SetShapeToCircular() { this->SetShape(Circular); }
  void SetShapeToElliptical() { this->SetShape(Elliptical); }
  ///@}

  ///@{
  /**
   * Which way estimated normals point: Consistent (default) within each connected surface, towards
   * the sensors where the input says where they stood, otherwise outward if it is closed; or
   * TowardsViewpoint, whatever the input says. Normals that the input has keep their sign.
   */
  vtkSetClampMacro(Orientation, int, Consistent, TowardsViewpoint);
  vtkGetMacro(Orientation, int);
  void SetOrientationToConsistent() { this->SetOrientation(Consistent); }
  void SetOrientationToViewpoint() { this->SetOrientation(TowardsViewpoint); }
  ///@}

  ///@{
  /**
   * The point, in world coordinates, that estimated normals face if Orientation is
   * TowardsViewpoint; (0, 0, 0) by default.
   */
  virtual void SetViewpoint(double x, double y, double z);
  virtual void SetViewpoint(const double point[3])
  {
    this->SetViewpoint(point[0], point[1], point[2]);
  }
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

  ///@{
  /**
   * What radii and axes are multiplied with at the end; 1 by default, at least 0.
   */
  vtkPointSplatSetClampMacro(RadiusScale, 0.0, 1e9);
  vtkGetMacro(RadiusScale, double);
  ///@}

  ///@{
  /**
   * Whether the output has fill points where points are too uneven, or the surface bends too much, for disks
   * about them (stage 6): more points than the input then. Off by default; a mapper that estimates sizes
   * has it on.
   */
  vtkSetMacro(FillGaps, bool);
  vtkGetMacro(FillGaps, bool);
  vtkBooleanMacro(FillGaps, bool);
  ///@}

  ///@{
  /**
   * Whether FillGaps is also between triangles' corners, and in these on other faces where they have no normals; on by default. Off for what draws large triangles
   * as such, and not as splats: disks leave open what they cannot cover without reaching past a face's border.
   */
  vtkSetMacro(FillMeshGaps, bool);
  vtkGetMacro(FillMeshGaps, bool);
  vtkBooleanMacro(FillMeshGaps, bool);
  ///@}

  ///@{
  /**
   * Whether FillGaps is also where points are noise (IsNoisy()); on by default. Off for what goes through
   * vtkPointSplatProjection first: to fill what points that contradict one another seem to leave open takes long.
   */
  vtkSetMacro(FillNoise, bool);
  vtkGetMacro(FillNoise, bool);
  vtkBooleanMacro(FillNoise, bool);
  ///@}

  ///@{
  /**
   * Whether all points are known to lie on their surface, as an isosurface's do, however rough this is; off by
   * default. On, IsNoisy() is false: the surface has borders and bends as clean ones do.
   */
  vtkSetMacro(Relief, bool);
  vtkGetMacro(Relief, bool);
  vtkBooleanMacro(Relief, bool);
  ///@}

  /// The points of the input between which a fill point lies, the nearest one first, with weights whose sum is 1.
  struct FillPoint
  {
    int Count;
    vtkIdType Ends[3];
    float Weights[3];
  };
  /// Those behind the input's points in the output, in order; known after Update().
  const std::vector<FillPoint>& GetFillPoints() const { return this->FillPoints; }
  /**
   * An array of the input's points, and behind them what fill points have: means of their ends' by weights; of
   * whole numbers with one component, as ids and labels, and of texts, the nearest one's.
   */
  static vtkSmartPointer<vtkAbstractArray> WithFillPoints(
    vtkAbstractArray* array, const std::vector<FillPoint>& points);
  /**
   * Gives the output the points and point data of the input, and behind them fill points at these places, and
   * `SplatSource`. Arrays that have not a tuple for each point are left out.
   */
  static void AppendFillPoints(vtkPointSet* input, vtkPoints* places,
    const std::vector<FillPoint>& points, vtkPolyData* output);

  /**
   * How many points have no neighbour on a sheet of their own, or no surface through them, and are
   * drawn as a small body each (stage 7); known after Update().
   */
  vtkGetMacro(NumberOfPointsAlone, vtkIdType);

  /**
   * How many normals cancelled at seams of a mesh whose triangles are not oriented consistently, and were replaced
   * (stages 2 and 4); known after Update().
   */
  vtkGetMacro(NumberOfMendedNormals, vtkIdType);

  /**
   * The share of points, of every 32nd, whose 24 neighbours do not lie on one surface: by their
   * normals they are off it by more than 0.15 of their mean distance, and their positions off any
   * plane. Points of bodies that are smaller than what is looked at, a quarter of whose neighbours and more face
   * away, are none of these. 0 for meshes, for 24 points and fewer, and where most normals were estimated unless it is
   * more than 0.7: these are off where the surface turns within a few points, too.
   */
  vtkGetMacro(Noise, double);

  /**
   * The share of these points of which a neighbour lies above or below, by the normals of both,
   * which agree, and nothing that faces the other way lies between, as the next body's near side would: no surface goes
   * through the two. 0 where Noise is, and where the points are vertices of an isosurface, with its normals: these lie on the
   * edges of the volume's lattice. The volume's noise is a part of the surface.
   */
  vtkGetMacro(Contradiction, double);

  /**
   * Whether positions and normals are rough, by relief or noise: more than 0.3 of
   * the points are off their neighbours' surface. Meshes' vertices, isosurfaces of measured volumes
   * and parts with normals averaged over their edges have at most 0.1, one of a volume of whole
   * numbers magnified four times 0.75.
   */
  bool IsRough() const { return vtkPointSplatEstimation::IsRough(this->Noise); }
  static bool IsRough(double noise) { return noise > 0.3; }

  /**
   * Whether more than 0.04 of the points are in contradictions. Of noise of a fifth of the spacing 0.07 to
   * 0.2 are, of overlapping range scans 0.58, of the magnified volume 0.01, and of surfaces in coarse layers upon one
   * another, as clothes, 0.17 to 0.44.
   */
  bool IsContradicted() const { return vtkPointSplatEstimation::IsContradicted(this->Contradiction); }
  static bool IsContradicted(double contradiction) { return contradiction > 0.04; }

  /**
   * Whether the cloud is one for vtkPointSplatProjection: rough, and by contradictions rather than
   * relief. Of points without normals those of noise of 0.3 spacings and more are, of which 0.9 and more are rough, of scans
   * upon one another, and the two sides of a sheet that is no thicker than its points are apart.
   */
  bool IsNoisy() const { return this->IsNoisy(this->Noise, this->Contradiction); }
  bool IsNoisy(double noise, double contradiction) const
  {
    return !this->Relief && vtkPointSplatEstimation::IsRough(noise) &&
      vtkPointSplatEstimation::IsContradicted(contradiction);
  }

  /**
   * Whether points that vtkPointSplatProjection moved were no noise. before: the share of them that was contradicted. Some
   * are still, and they are no fewer, as on thin noisy tubes, or more than 0.065 of the points are off their neighbours'
   * surface: of clothes upon one another 0.11 are, and of trees and bushes in airborne
   * scans 0.08 to 0.19; of noise and range scans at most 0.04, and of rooms, whose far walls a depth camera sees in
   * steps of several spacings, 0.05 to 0.06. Of the scans that Testing/Stability/stability.py range_scans lays over one another
   * 0.02 where these are off by a spacing, 0.3 by one and a half.
   */
  bool IsCrumpled(double before) const
  {
    return this->IsContradicted() && (this->Noise > 0.065 || this->Contradiction >= before);
  }

protected:
  vtkPointSplatEstimation();
  ~vtkPointSplatEstimation() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// For subclasses that keep a part of them.
  void SetFillPoints(const std::vector<FillPoint>& points) { this->FillPoints = points; }

private:
  vtkPointSplatEstimation(const vtkPointSplatEstimation&) = delete;
  void operator=(const vtkPointSplatEstimation&) = delete;

  int NumberOfNeighbors = 12;
  int Shape = Circular;
  int Orientation = Consistent;
  double Viewpoint[3] = { 0, 0, 0 };
  double RadiusScale = 1;
  bool FillGaps = false;
  bool FillMeshGaps = true;
  bool FillNoise = true;
  bool Relief = false;
  std::vector<FillPoint> FillPoints;
  vtkIdType NumberOfPointsAlone = 0;
  vtkIdType NumberOfMendedNormals = 0;
  double Noise = 0; // that the last update found, and
  double Contradiction = 0;
};

VTK_ABI_NAMESPACE_END
#endif
