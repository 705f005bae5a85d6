// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What frames have shown of how much fewer layers and splats would lose, and whether it still holds.
//
// It does for the same clouds and looks on the same background, until the camera has turned by half
// a right angle or things have twice or half the size, or layers were made some thirty times: then a
// frame is to be drawn with all of them and measured (vtkPointSplatFrameMeasures.cxx). While looks change in
// each frame, as in an animation of opacity, none is, and nothing is known.
#ifndef vtkPointSplatMeasuredErrors_h
#define vtkPointSplatMeasuredErrors_h

#include "vtkPointSplatCollection.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatMeasuredErrors
{
public:
  /// What is drawn now; of another scene nothing is known. generation: counts the times that layers were made.
  void Look(vtkRenderer* renderer, const vtkPointSplatCollection::Entries& entries,
    const vtkPointSplatView& view, double targetError, unsigned long generation);
  bool IsStale() const;
  /// Of what Look() saw last, as vtkPointSplatFacts has them.
  void Set(std::vector<double> ends, std::vector<double> apart);
  const std::vector<double>& GetEnds() const { return this->Ends; }
  const std::vector<double>& GetApart() const { return this->Apart; }

private:
  struct Sight
  {
    std::vector<double> Scene;
    glm::dvec3 Direction = glm::dvec3(0.0); // to the eye, world coordinates
    double PixelSize = 0.0;                 // world units, of the first cloud
    unsigned long Generation = 0;
  };
  Sight Now;
  Sight Measured;
  bool IsKnown = false;
  int Changes = 0; // of the scene, one soon after the other
  unsigned long ChangeGeneration = 0;
  std::vector<double> Ends;
  std::vector<double> Apart;
};

#endif
