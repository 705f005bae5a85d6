// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stage shade, before it: the textures of all items are looked up at the pixels of layers, an
// item after the other, so that layers of several can be shaded at once, whatever textures there are.
// What is looked up replaces the coordinates in the layers' texels of looks
// (vtkPointSplatLook.glsl), once after layers were made.
#ifndef vtkPointSplatLooks_h
#define vtkPointSplatLooks_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatTextures.h"
#include "vtkPointSplatView.h"

#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkRenderer;
VTK_ABI_NAMESPACE_END
class vtkPointSplatUnits;

class vtkPointSplatLooks
{
public:
  /**
   * An item that has textures, or whose light goes by tangents.
   */
  struct Entry
  {
    vtkActor* Actor;
    int Slot;
    bool Tangents;
  };

  /// False, with GetError(), where shaders do not build.
  bool Apply(vtkRenderer* renderer, const vtkPointSplatView& view,
    const std::vector<Entry>& entries, const vtkPointSplatLayers& layers);

  const std::string& GetError() const { return this->Error; }
  void Release() { this->Programs.clear(); }

private:
  bool ApplyOne(vtkRenderer* renderer, const vtkPointSplatView& view, const Entry& entry,
    const vtkPointSplatLayers& layers);

  std::map<std::string, vtkPointSplatProgram> Programs; // by defines
  std::string Error;
};

#endif
