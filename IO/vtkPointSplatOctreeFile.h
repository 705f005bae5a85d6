// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names in the files of vtkPointSplatOctreeWriter, which says what they hold.
#ifndef vtkPointSplatOctreeFile_h
#define vtkPointSplatOctreeFile_h

#include "vtkPointSplatArrays.h"

namespace vtkPointSplatOctreeFile
{
constexpr const char* Type = "PointSplatOctree";
constexpr int Version = 1;

// Of the tree of blocks, as vtkPointSplatOctree has them.
constexpr const char* BlockArrays[] = { vtkPointSplatArrays::BlockRange,
  vtkPointSplatArrays::BlockChildren, vtkPointSplatArrays::BlockBounds,
  vtkPointSplatArrays::BlockCone, vtkPointSplatArrays::BlockSize,
  vtkPointSplatArrays::BlockOrigin };
// Of coarser splats: those that they stand for, which is of use beside these alone.
constexpr const char* LevelArrays[] = { vtkPointSplatArrays::Level,
  vtkPointSplatArrays::FirstChild, vtkPointSplatArrays::ChildCount };
}

#endif
