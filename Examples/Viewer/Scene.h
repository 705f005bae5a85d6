// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces, their actors, and the camera.
#ifndef Scene_h
#define Scene_h

#include "OctreeFiles.h"
#include "Options.h"

#include "vtkActor.h"
#include "vtkPointSplatMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

struct Surface
{
  std::string Name;
  std::optional<double> Isovalue;
  /// Where the normals are from: "gradient", "density", "file", "triangles" or "estimated".
  std::string Normals;
  /// Where the colours are from: "actor", "RGB", or an array's name.
  std::string Colours;
  bool Lit = true;
  /// How many of the points that are drawn lie between those of the file.
  vtkIdType NumberOfFillPoints = 0;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkPointSplatMapper> Mapper;
  /// Where the mapper's input depends on the camera; else none.
  std::shared_ptr<OctreeStream> Stream;
};

struct Scene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Surface> Surfaces;

  /**
   * Reads and extracts what the options ask for. Throws UserError.
   */
  static Scene Make(const Options& options);
};

#endif
