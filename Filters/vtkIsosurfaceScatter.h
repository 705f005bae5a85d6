// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceScatter
 * @brief   points on isosurfaces of scattered samples
 *
 * Internal; see the stages in vtkIsosurfacePoints.
 */
#ifndef vtkIsosurfaceScatter_h
#define vtkIsosurfaceScatter_h

#include "vtkIsosurfaceExtraction.h"
#include "vtkIsosurfaceScatterField.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceScatter : public vtkIsosurfaceExtraction
{
public:
  struct Settings
  {
    double Spacing;       // of points; 0 for that of the samples
    int NumberOfNeighbors;
    double Radius;        // of neighbourhoods; 0 to take the number
    bool Correction;      // onto the fitted field
  };

  /// The isovalues are sorted ascending.
  vtkIsosurfaceScatter(std::unique_ptr<vtkIsosurfaceScatterField> field,
    const std::vector<double>& isovalues, const Settings& settings);
  ~vtkIsosurfaceScatter() override;

  /// Only with Correction are gaps between pairs of samples filled.
  bool KnowsSizes() const override { return this->Chosen.Correction; }
  bool Find(
    vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts) override;
  bool Write(vtkAlgorithm* self, double from, double to,
    const std::vector<Target>& targets) const override;

private:
  using Node = vtkIsosurfaceScatterField::Node;

  struct Point
  {
    double Position[3];
    double Gradient[3];
    double Distance; // to be kept to other points
    Node Nearest;
    bool Usable;
    bool HasGap; // beside it is a place that no point was found for
  };
  class Surface;

  double GetDistance(Node node) const;
  void FindOnPairs(std::size_t v, std::vector<Point>& points) const;
  Point PlaceOnPair(double isovalue, const vtkIsosurfaceScatterField::Pair& pair) const;
  bool Grow(vtkAlgorithm* self, std::size_t v, Surface& surface, double at) const;
  Point PlaceBeside(double isovalue, const Point& from, const double start[3]) const;
  bool Approach(double isovalue, double limit, Point& point) const;
  /// The size of a point's splat, by the distance to others, and its bend, by the field.
  void Shape(std::size_t v, const Point& point, vtkIsosurfaceSplat& splat) const;

  std::unique_ptr<vtkIsosurfaceScatterField> Field;
  std::vector<double> Isovalues;
  Settings Chosen;
  std::vector<std::vector<Point>> Surfaces;
};

VTK_ABI_NAMESPACE_END
#endif
