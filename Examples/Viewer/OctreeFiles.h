// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of points with levels of detail, in HDF5.
#ifndef OctreeFiles_h
#define OctreeFiles_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

struct Options;
class vtkBoundingBox;
class vtkCamera;
class vtkPolyDataAlgorithm;

/**
 * At most so many splats that stand for a file's points; 0: all points.
 */
vtkSmartPointer<vtkDataObject> ReadOctree(const std::string& file, long most, bool quiet);

/**
 * A file with more points than are to be drawn: of these what a camera sees.
 */
class OctreeStream
{
public:
  virtual ~OctreeStream() = default;

  virtual vtkPolyDataAlgorithm* GetSource() = 0;
  virtual vtkIdType GetNumberOfPointsInFile() const = 0;
  virtual vtkBoundingBox GetBoundsInFile() const = 0;
  /// Who looks at a picture of a size; before that there are the coarsest splats. Throws UserError.
  virtual void SetCamera(vtkCamera* camera, const int size[2]) = 0;
  /// Whether there is something else to be drawn.
  virtual bool Follow(const int size[2]) = 0;
  /// Reads for so long what may come next; whether there is more.
  virtual bool Prefetch(double seconds) = 0;
};

/**
 * None where it is no such file, or has no more points than the options allow, so that it is read as any
 * other. Throws UserError.
 */
std::shared_ptr<OctreeStream> OpenStream(const std::string& file, const Options& options);

/**
 * Writes all files' points, file after file, into one.
 */
void ConvertFiles(const Options& options);

#endif
