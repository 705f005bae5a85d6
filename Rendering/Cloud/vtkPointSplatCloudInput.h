// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a cloud is made from, by whoever has it: a mapper, or a filter.
#ifndef vtkPointSplatCloudInput_h
#define vtkPointSplatCloudInput_h

#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/**
 * What vtkMapper makes of a block's scalars, where colours are blended.
 */
struct vtkPointSplatColours
{
  /// RGBA, 8 bits each, one a point, or one a cell; null: the block has none.
  vtkSmartPointer<vtkUnsignedCharArray> Array;
  bool OfCells = false;
  /// The one tuple that all points have; or -1: each has its own.
  vtkIdType Only = -1;
  /// RGBA, 8 bits each, of points without a cell.
  uint32_t WithoutCell = 0xffffffffu;
};

/**
 * What vtkMapper makes of values that are interpolated before they are mapped.
 */
struct vtkPointSplatValues
{
  /// Two a point: the place along the table, of which 0 to 1 is all; and 1 for NaN, else less than
  /// a half. Null: the block's scalars cannot be drawn so.
  vtkSmartPointer<vtkFloatArray> Coordinates;
  /// RGBA colours, 8 bits each: the first row is the table, the second one is NaN's colour.
  vtkSmartPointer<vtkImageData> Table;
};

/**
 * How a block looks, where that is not as its actor and its scalars have it.
 */
struct vtkPointSplatBlockLook
{
  bool Visible = true;
  std::optional<std::array<double, 3>> Colour;
  std::optional<double> Opacity;

  bool operator==(const vtkPointSplatBlockLook& other) const
  {
    return this->Visible == other.Visible && this->Colour == other.Colour &&
      this->Opacity == other.Opacity;
  }
};

struct vtkPointSplatCloudInput
{
  /// Points: a point set, or a composite data set of such.
  vtkDataObject* Data = nullptr;
  /// Where Data has but some of a data set's points: that data set, and their ids in it; or null.
  vtkPointSet* Whole = nullptr;
  const std::vector<vtkIdType>* WholeIds = nullptr;
  /// Who errors and warnings are said to come from.
  vtkObject* Owner = nullptr;
  /// Whether splats need sizes; points that are projected as single pixels do not.
  bool NeedSizes = true;
  /// Whether points whose normals and neighbours contradict one another are moved onto one surface.
  bool ProjectNoise = true;
  /// Whether points between others are drawn, too, where no splats about these cover what is there.
  bool FillGaps = false;
  /// The same of triangles' corners.
  bool FillMeshGaps = true;
  /// Whether sizes of an earlier frame are those of points that moved since, where that can be.
  bool FollowMotion = true;
  /// Whether some actor has textures; whether light goes by the points' tangents.
  bool NeedCoordinates = false;
  bool NeedTangents = false;
  /// A block's colours; null: of no worth.
  std::function<vtkPointSplatColours(vtkDataSet*)> MapColours;
  /// A block's values, that are blended and then mapped to colours; or null: colours are blended.
  std::function<vtkPointSplatValues(vtkDataSet*)> MapValues;
  /// The array of a block that colours come from, or null; cellFlag gets 0 where it is of points.
  std::function<vtkAbstractArray*(vtkDataSet*, int& cellFlag)> FindScalars;
  /// Changes with whatever colours depend on beside the scalars, or null.
  std::function<std::string()> ColourKey;
  /// By flat index; those that are missing look as actor and scalars have it.
  std::map<unsigned int, vtkPointSplatBlockLook> Looks;
  /// The actor's diffuse colour and opacity, for blocks without their own beside those with.
  std::array<double, 4> ActorColour{ { 1.0, 1.0, 1.0, 1.0 } };
};

#endif
