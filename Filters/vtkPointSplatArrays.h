// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatArrays.h
 * @brief names of the point arrays by which filters and renderers understand each other
 *
 * Normals are the data set's active point normals.
 */
#ifndef vtkPointSplatArrays_h
#define vtkPointSplatArrays_h

namespace vtkPointSplatArrays
{
/// 1 float, world units: the radius such that the splats' disks cover the surface.
inline constexpr const char* Radius = "SplatRadius";
///@{
/// 3 floats each, world units: a disk's principal axes, in its tangent plane.
inline constexpr const char* Axis1 = "SplatAxis1";
inline constexpr const char* Axis2 = "SplatAxis2";
///@}
/// 3 floats, unit length: the normal of a disk's plane, where it is not the point normal. It points to where the
/// front is seen from, as the order of a triangle's corners tells: a point normal on the other side is dark, as a mesh's. All 0:
/// the point is a body alone and has no plane; what draws it turns its disk to who looks.
inline constexpr const char* PlaneNormal = "SplatPlaneNormal";
/// 6 floats, XX, YY, ZZ, XY, YZ, XZ, 1 / world units: the second fundamental form, by which the
/// normal changes from point to point, in the tangent plane. Its sign goes by the normal of the
/// disk's plane. Of a body
/// alone: the unit tensor over a ball's radius, for a ball with its own normals; or 0, for a disk
/// with the point's.
inline constexpr const char* Curvature = "SplatCurvature";
/// 6 floats, two vectors c1 and c2, 1 / world units, in the points' coordinates: clip lines, by
/// which splats end at creases and borders (Zwicker et al. 2004, Perspective accurate splatting).
/// The splat at p keeps what of its disk fulfils c1 . (x - p) <= 1 and c2 . (x - p) <= 1: c = n / d
/// for a line at the distance d > 0 from p whose unit normal n, in the disk's plane, points to what
/// is cut away. A zero vector cuts nothing, and one that is not finite counts as zero. The centre
/// is kept always; a point on the line itself has a small positive d. What of c is along the normal
/// of the disk's plane has no effect; a bent disk's line is taken in that plane as well. Lines stay where
/// they are, whatever a mapper scales radii with. Splats with lines join no layer that shows the other side,
/// since just behind an edge lies the face that is turned away: best give lines to all within 2.5 times
/// their size of an edge. Splats are drawn for a sixteenth of a pixel beyond a line, where they hardly weigh,
/// so that there are no gaps at edges.
inline constexpr const char* Clip = "SplatClip";
/// 6 floats, two vectors f1 and f2, unit length or zero, with SplatClip: the splat goes on behind
/// its lines c1 and c2 in the planes with these normals. So a point on an edge, whose normal is an
/// average of its faces', has a part of its splat on each of them: as in a mesh, the shading turns
/// from face to face.
inline constexpr const char* Fold = "SplatFold";
/// What splats are made from, beside points and normals.
inline constexpr const char* Geometry[] = { Radius, PlaneNormal, Curvature, Axis1, Axis2, Clip, Fold };
/// 1 vtkIdType, where vtkPointSplatEstimation made fill points: the point of its input that a point is, or that a
/// fill point, which lies between some, is nearest to.
inline constexpr const char* Source = "SplatSource";
/// 1 vtkIdType: the point of the input that a point is, where a filter changes their order.
inline constexpr const char* OriginalIds = "vtkOriginalPointIds";
/// 1 int: the minimal independent group that a splat belongs to.
inline constexpr const char* Group = "SplatGroup";
/// Field data, 1 double for each group: the share of the surface that its disks cover by themselves.
inline constexpr const char* GroupCoverage = "SplatGroupCoverage";
/// A float for each light, 0 (in its shadow) to 1 (lit): vtkPointShadowTexture.
inline constexpr const char* Shadow = "ShadowFactor";
/// 3 floats or doubles, world units: where the sensor stood that saw a point; or, as field data,
/// one tuple a scan, with Scan.
inline constexpr const char* Sensor = "SensorPosition";
/// 1 integer: the scan that a point is of, counted from 0.
inline constexpr const char* Scan = "ScanId";
/// 1 float, world units: how far vtkPointSplatProjection moved a point.
inline constexpr const char* ProjectionDistance = "ProjectionDistance";
/// 1 unsigned char: 1 for a point that vtkPointSplatProjection takes for an outlier, else 0.
inline constexpr const char* Outlier = "Outlier";
/// 1 double: the isovalue of the surface that a point lies on.
inline constexpr const char* Isovalue = "Isovalue";

///@{
/// Of vtkPointSplatOctree's levels, which says what they hold: point data, then field data of its blocks.
inline constexpr const char* Level = "SplatLevel";
inline constexpr const char* FirstChild = "SplatFirstChild";
inline constexpr const char* ChildCount = "SplatChildCount";
inline constexpr const char* NormalDeviation = "SplatNormalDeviation";
inline constexpr const char* BlockRange = "SplatBlockRange";
inline constexpr const char* BlockChildren = "SplatBlockChildren";
inline constexpr const char* BlockBounds = "SplatBlockBounds";
inline constexpr const char* BlockCone = "SplatBlockCone";
inline constexpr const char* BlockSize = "SplatBlockSize";
inline constexpr const char* BlockOrigin = "SplatBlockOrigin";
///@}
}

#endif
