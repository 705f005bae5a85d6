// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatOctreeReader
 * @brief   reads the points of a vtkPointSplatOctreeWriter's file: all, or as many as there is room for
 *
 * 1. *Tree.* The blocks of all pieces are read: some 100 bytes for 80 points.
 * 2. *Cut.* From the coarsest blocks down, the one with the largest splats gives way to those below
 *    it, as long as there are at most MaximumNumberOfPoints splats in all (Pajarola, Sainz, Guidotti
 *    2004, Confetti: Object-Space Point Blending and Splatting, section 6). So the size of splats is
 *    even over the cloud, but where points themselves are larger. Blocks off Bounds are left out.
 * 3. *Splats.* Of each level the cut's runs of splats are read, and nothing else but the rest of
 *    their chunks.
 *
 * Output: a vtkPolyData of points (the written type), with normals, `SplatRadius`, or `SplatAxis1`
 * and `SplatAxis2`, so that vtkPointSplatMapper draws it as it is, a coarse version as smoothly as
 * the whole. Of other point data those arrays that all levels have which were read: the names of
 * points, for instance, are there if all splats are points. Field data is the first piece's.
 *
 * Bad input: a file that is not there, is no such file, is truncated or damaged, is an error, and the
 * output is empty. Numbers in the tree that lead out of the file are noticed.
 *
 * @sa vtkPointSplatOctreeWriter vtkPointSplatMapper
 */
#ifndef vtkPointSplatOctreeReader_h
#define vtkPointSplatOctreeReader_h

#include "vtkIOPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKIOPOINTSPLATTING_EXPORT vtkPointSplatOctreeReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatOctreeReader* New();
  vtkTypeMacro(vtkPointSplatOctreeReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// A file of vtkPointSplatOctreeWriter's.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Whether it is such a file, of a version that this class knows.
  static bool CanReadFile(const char* fileName);

  ///@{
  /**
   * At most so many splats are read, but for those of the coarsest blocks, which are some hundred a
   * piece. 0, the default: all points.
   */
  vtkSetClampMacro(MaximumNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Blocks whose splats reach into this box are read, as a whole: xmin, xmax, ymin, ymax, zmin, zmax.
   * Where a minimum is greater than its maximum, as by default, all are.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Of the whole file; known after UpdateInformation().
  vtkGetMacro(NumberOfPointsInFile, vtkIdType);
  vtkGetVector6Macro(BoundsInFile, double);
  ///@}

  /// Of the cut: 0 if it has the points themselves.
  vtkGetMacro(CoarsestLevelRead, int);

protected:
  vtkPointSplatOctreeReader();
  ~vtkPointSplatOctreeReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointSplatOctreeReader(const vtkPointSplatOctreeReader&) = delete;
  void operator=(const vtkPointSplatOctreeReader&) = delete;

  char* FileName = nullptr;
  vtkIdType MaximumNumberOfPoints = 0;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkIdType NumberOfPointsInFile = 0;
  double BoundsInFile[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int CoarsestLevelRead = 0;
};

VTK_ABI_NAMESPACE_END
#endif
