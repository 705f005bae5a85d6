// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkPointSplatMapper has inside, for its own files.
#ifndef vtkPointSplatMapperInternals_h
#define vtkPointSplatMapperInternals_h

#include "vtkPointSplatFrame.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatPrimitives.h"
#include "vtkRenderer.h" // For the frame's weak pointer

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * What the frame knows of the mapper.
 */
class vtkPointSplatMapper::vtkInternals : public vtkPointSplatSource
{
public:
  explicit vtkInternals(vtkPointSplatMapper* mapper)
    : vtkPointSplatSource(mapper)
    , Self(mapper)
  {
  }
  bool Update(const vtkPointSplatSettings& settings) override;
  /// Brings the pipeline up to date; null without an input.
  vtkDataObject* UpdateInput();
  /// The bounds of points as they are given, where their splats are not there and take long; else
  /// null.
  const std::array<double, 6>* FindGivenBounds(
    vtkDataObject* data, const vtkPointSplatSettings& settings);
  using vtkPointSplatSource::GetSettings;
  vtkPointSplatSettings GetSettings() const override;
  /// Brings the splats up to date with an input that is.
  void UpdateSplats(vtkDataObject* data, const vtkPointSplatSettings& settings);

  /**
   * A renderer that the mapper was drawn in, and what the user was told of that: once, not at every
   * frame.
   */
  struct Drawn
  {
    std::shared_ptr<vtkPointSplatFrame> Frame;
    std::string Error;
    bool Refused = false;       // deferred blending
    bool NoEnvironment = false;
  };
  Drawn& DrawnIn(vtkRenderer* renderer);

  vtkPointSplatReport Report;
  std::string Choices;
  bool WarnedOfClipPlanes = false;
  std::set<std::string> WarnedOf; // of what the actors' looks have that is not shown
  vtkPointSplatPrimitives Primitives;
  std::vector<Drawn> AllDrawn;

  /// Whether VTK's mapper draws the input: by the actor's representation, or, with one warning,
  /// because there cannot be splats.
  bool ArePrimitivesShown(vtkRenderer* renderer, vtkActor* actor);

private:
  vtkPointSplatCloudInput MakeInput(vtkDataObject* data, const vtkPointSplatSettings& settings);
  vtkPointSplatColours MapColours(vtkDataSet* data);
  vtkPointSplatValues MapValues(vtkDataSet* data);
  std::string GetColourKey();
  /// Of composite data: how blocks look by the display attributes.
  void LookAtBlocks(vtkPointSplatCloudInput& input);

  vtkPointSplatMapper* Self;
  bool WarnedOfPrimitives = false;
  std::array<double, 4> ActorColour{ { 1.0, 1.0, 1.0, 1.0 } }; // of the one drawn last
  bool NeedCoordinates = false; // of any that was drawn
  bool NeedTangents = false;
  vtkPointSplatCloud::Key GivenKey;
  std::array<double, 6> GivenBounds;
};

VTK_ABI_NAMESPACE_END
#endif
