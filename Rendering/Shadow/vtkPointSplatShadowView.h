// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a light looks from, and how its shadow map lies over the points.
//
// Directional lights see in parallel, through a box about the points. Lights that stand aside see
// all points through one frustum; a spot light whose cone is narrower, through a frustum about
// that. Lights that stand among the points, or close to them, look through the six faces of a
// cube. Casters in front of all points count, whose depth then is 0.
#ifndef vtkPointSplatShadowView_h
#define vtkPointSplatShadowView_h

#include <glm/glm.hpp>

#include <vector>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
VTK_ABI_NAMESPACE_END

/**
 * A light, or one sample of it. World coordinates.
 */
struct vtkPointSplatShadowLight
{
  bool Positional = false;
  glm::dvec3 Position{ 0.0 };           // of a positional light
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 }; // unit length, from the light
  double ConeAngle = 180.0;             // half of a spot light's, degrees; from 90 on there is none
  double Radius = 0.0; // of the disk across the direction: world units if positional,
                       // else the tangent of the angle at which it is seen

  bool operator==(const vtkPointSplatShadowLight& other) const;

  static vtkPointSplatShadowLight From(vtkLight* light, double radius);
  bool IsFinite() const;
  /// Of the angle at which the radius is seen from a place, at most 1 for a positional light.
  double GetTangent(const glm::dvec3& place) const;

  /**
   * Point samples of the light's disk, of equal weight: jittered, one in each of count parts of
   * equal area (Dobrev, Rosenthal, Linsen 2010, section 6). The same for the same seed. A single
   * one is the centre.
   */
  std::vector<vtkPointSplatShadowLight> Sample(int count, unsigned int seed) const;
};

struct vtkPointSplatShadowView
{
  glm::dmat4 WCLC{ 1.0 };      // world to the light's coordinates: x, y across, z away from it
  bool Parallel = true;
  bool Cube = false;           // six faces, whose axes are the light's own
  glm::ivec2 Size{ 0 };        // of the map, or of each face
  glm::dvec2 Scale{ 1.0 };     // pixels = Scale xy + Offset; of xy / z, if not parallel
  glm::dvec2 Offset{ 0.0 };
  double PixelSize = 1.0;      // world units; at a depth of 1, if not parallel
  double Depth = 1.0;          // of the farthest point
  double NearDistance = 0.0;   // of the near plane, if not parallel
  double Distance = 1.0;       // where pixels are as large as the spacing, if not parallel

  /**
   * corners: of boxes about the points; spacing: how large a pixel should be there, world units.
   * resolution: pixels along the map's longer side, or 0: as the spacing wants it. maximum: what
   * that may reach. Where corners are not finite, or all are one and the spacing is 0, no map can
   * be laid: its size is 0.
   */
  static vtkPointSplatShadowView Fit(const vtkPointSplatShadowLight& light,
    const std::vector<glm::dvec3>& corners, double spacing, int resolution, int maximum);
};

#endif
