// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What stages ask of an item by its slot: a buffer of twelve texels (RGBA32F) a slot.
//   0  opacity of front and of back faces, number of clipping planes, whether it is
//     projected as points
//   1  colour and opacity, by which what is gathered is multiplied
//   2  kernel: shape, support, whether it is a plateau
//   3  of points: least layer distance in world units, in pixels; spacing; silhouettes
//   4  to 9: clipping planes, view coordinates
//   10 how values are mapped (vtkPointSplatValue.glsl)
//   11 whether each splat has one tone; width of edges, pixels; whether texture coordinates repeat
// And beside it (R32UI) the tables of colours of all items whose clouds have values, one after the
// other.
#ifndef vtkPointSplatItemTable_h
#define vtkPointSplatItemTable_h

#include "vtkPointSplatItem.h"

class vtkPointSplatItemTable
{
public:
  /// As many as 15 bits of a tag tell apart.
  static constexpr size_t MostSlots = 16384;

  void Upload(const std::vector<vtkPointSplatItem>& items, const vtkPointSplatView& view);
  GLuint GetTexture() const { return this->Table.GetTexture(); }
  GLuint GetValueTables() const { return this->ValueTables.GetTexture(); }
  void Release();

private:
  vtkPointSplatBuffer Table{ GL_RGBA32F };
  vtkPointSplatBuffer ValueTables{ GL_R32UI };
};

#endif
