// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums up one layer of splats and of points that are projected as single pixels, by the rasteriser
// (OpenGL 3.2):
// 1. Visibility: the nearest depth of all disks and points, by the depth test.
// 2. Accumulation: sums over all that belongs to that layer, by additive blending.
// 3. For hardware selection, the ids, by the depth test again.
#ifndef vtkPointSplatRaster_h
#define vtkPointSplatRaster_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatPeel.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatSums.h"

#include <map>
#include <string>

class vtkPointSplatRaster
{
public:
  /**
   * codes (R32UI) gets the coded depths. empty: whether there was nothing to peel. False, with
   * GetError(), where shaders do not build.
   */
  bool Project(const vtkPointSplatRequest& request, const vtkPointSplatPeel& peel,
    vtkPointSplatSums& sums, const vtkPointSplatImage& codes, bool& empty);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  vtkPointSplatProgram* Use(const vtkPointSplatItem& item, const std::string& file,
    const std::string& defines);
  bool DrawAll(const vtkPointSplatRequest& request, const vtkPointSplatPeel& peel,
    const vtkPointSplatSums& sums, const vtkPointSplatImage& codes, const std::string& file);

  std::map<std::string, vtkPointSplatProgram> Programs; // by file and defines
  vtkPointSplatFramebuffer Visibility;
  vtkPointSplatFramebuffer Accumulation;
  vtkPointSplatFramebuffer Identification;
  vtkPointSplatHandle Samples{ vtkPointSplatHandle::Query };
  std::string Error;
};

#endif
