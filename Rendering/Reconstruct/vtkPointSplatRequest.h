// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What layers are made of, and how: the same request makes the same layers.
#ifndef vtkPointSplatRequest_h
#define vtkPointSplatRequest_h

#include "vtkPointSplatItem.h"

#include <string>

struct vtkPointSplatRequest
{
  vtkPointSplatView View;
  std::vector<vtkPointSplatItem> Items; // in the order of their slots
  std::vector<vtkMTimeType> CloudTimes;

  ///@{ How.
  bool Compute = true;       // by compute shaders, or by quads
  bool OnDevice = false;     // compute: whether the device makes the tiles' lists
  bool Deferred = false;     // splats by deferred blending, of one layer only
  bool Voronoi = true;       // then: rims lie behind centres
  int FillSteps = 0;         // of points that are projected as single pixels, at most
  ///@}

  ///@{ Layers: one only, unless there may be more or an opaque scene hides some.
  int MaximumLayers = 1;
  double LeastContribution = 1.0 / 256.0; // peeling ends where less of the light is left
  bool Gather = false;                    // the last layer takes all that is left
  bool ShowsEach = false;                 // layers are presented one by one
  GLuint SceneDepth = 0;                  // of the opaque scene, or 0
  unsigned long SceneFrame = 0;           // whose frame's that is
  vtkIdType MaximumMemory = 0;            // bytes of all layers; 0: no bound
  ///@}

  bool Outlines = false; // are smoothed; of tiles only
  bool HasIds = false;   // of the first layer
  vtkPointSplatCloud::IdKind Ids = vtkPointSplatCloud::PointIds;

  bool operator==(const vtkPointSplatRequest& other) const;

  bool IsPeeled() const
  {
    return this->MaximumLayers > 1 || this->Gather || this->SceneDepth != 0;
  }
  bool HasColours() const;
  /// Whether clouds have values in the place of colours.
  bool HasValues() const;
  /// Whether colours of cells are shown, of which a pixel has that of one splat; not for ids.
  bool HasCellColours() const;
  /// Lines for programs that make texels of sums, of a layer that is or is not gathered.
  std::string GetAppearanceDefines(bool gathered) const;
  /// Whether pixels of some clouds have the normal of one splat; not for ids.
  bool HasFacets() const;
  /// Whether something of the splat with the greatest weight is shown: its colour or its normal.
  bool ShowsGreatest() const { return this->HasCellColours() || this->HasFacets(); }
  bool HasClipLines() const;
  /// Texels beside a layer's for looks of items (vtkPointSplatLook.glsl), by tiles; none for ids.
  int GetLookTexels() const;
  /// Lines for programs of tiles that blend what looks need.
  std::string GetLookDefines() const;
  bool HasLook(bool (*test)(const vtkPointSplatItemLook&)) const;
  int GetFactorCount() const;
  /// The bits that tags of the items need (vtkPointSplatDepthCode.glsl).
  unsigned int GetTagMask() const;
  /// Layers that may be made where there is room for no more than this.
  int GetMostLayers(vtkIdType room) const;
  /// So many layers leave less than LeastContribution of the light behind them; at most MaximumLayers.
  int GetLayersThatCount() const;
  /// Then: what the rim of a disk lies behind its centre, world units; or 0.
  double GetVoronoiScale() const;
  /// Five times the largest least layer distance, world units.
  double GetDepthUnit() const;
  /// Pixels that items may cover: first x, y, last x, y; none where the latter are less.
  glm::ivec4 GetWindow() const;
};

#endif
