// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatOctreeWriter
 * @brief   a point cloud and its levels of detail in one HDF5 file, which may be larger than memory
 *
 * Writes points with the hierarchy that vtkPointSplatOctree makes of them, so that
 * vtkPointSplatOctreeReader can read a coarse version, or a part, in a time that does not depend on
 * how large the file is.
 *
 * A file has pieces, each with a hierarchy of its own. Pieces are written one after the other, and
 * each is forgotten before the next comes: a cloud that does not fit into memory is written from a
 * reader that reads it in pieces (NumberOfPieces), or from several files (Open, Append, Close).
 *
 * Input: any vtkPointSet, as vtkPointSplatOctree takes it: points of any type, normals and sizes if
 * they are known (else they are estimated, piece by piece), any other point data and field data.
 *
 * The file (HDF5 1.10 and later), so that programs that know nothing of VTK can read it as well:
 * - attributes of the root: Type ("PointSplatOctree"), Version (1), Pieces, Points (of all pieces),
 *   Bounds (6 doubles);
 * - group Piece0, Piece1, ...: attributes Points, Levels and Bounds, and these groups:
 *   - Level0: the points; Level1, Level2, ...: ever fewer, larger splats that stand for them. Array0,
 *     Array1, ...: coordinates (named "Points"), then point data, those of vtkPointSplatOctree's
 *     outputs 0 and 1; `SplatLevel`, `SplatFirstChild` and `SplatChildCount` among the latter;
 *   - Blocks: the arrays of vtkPointSplatOctree's tree of blocks; none where there is one level only;
 *   - FieldData: the piece's field data.
 * Arrays are data sets of tuples by components and of the array's own type, so that coordinates are
 * exact; in chunks, shuffled, deflated, with checksums. Their attributes Name, DataType, Role and ComponentNames
 * are those of the array. Texts and bits are kept; variants are not, and reported.
 *
 * The file is written beside its place, with ".part" at its name's end, and renamed when it is
 * complete: where writing fails or is given up, what was there before is untouched. So it is where
 * pieces are added to a file that is there (AppendToFile): they are added to a copy, for which the disk
 * needs room. A vtkPointSplatOctreeReader that has the old file open goes on with it until its next
 * Update().
 *
 * Bad input: as vtkPointSplatOctree has it, points that cannot be drawn are left out and counted. A
 * folder that cannot be written, or a full disk, is an error, and no file is left. Pieces are not added
 * to a file of another kind or version, nor to a truncated or damaged one: that is an error.
 *
 * @sa vtkPointSplatOctreeReader vtkPointSplatOctree
 */
#ifndef vtkPointSplatOctreeWriter_h
#define vtkPointSplatOctreeWriter_h

#include "vtkIOPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkWriter.h"

#include <memory> // For the file
#include <string> // For what is wrong

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSet;
class vtkPolyData;

class VTKIOPOINTSPLATTING_EXPORT vtkPointSplatOctreeWriter : public vtkWriter
{
public:
  static vtkPointSplatOctreeWriter* New();
  vtkTypeMacro(vtkPointSplatOctreeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where to; ".h5" is what splatview and pointsplatting.read() know.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * How many pieces the input is asked for, one after the other, if what makes it can make pieces;
   * else, and where the pipeline begins with data in memory, it is written as one. The default is 1.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /// From 0, none, to 9, the slowest and smallest. The default is 1.
  vtkSetClampMacro(CompressionLevel, int, 0, 9);
  vtkGetMacro(CompressionLevel, int);
  ///@}

  ///@{
  /**
   * Whether pieces are added to those that the file has; where there is no file it is written anew.
   * Off by default: what was there is replaced.
   */
  vtkSetMacro(AppendToFile, bool);
  vtkGetMacro(AppendToFile, bool);
  vtkBooleanMacro(AppendToFile, bool);
  ///@}

  /// Writes the input. 1, or 0 and an error.
  int Write() override;

  ///@{
  /**
   * Writes points from wherever they come: Open() once, Append() for each piece, Close(). True, or
   * false and an error; then what was there before is as it was. An Append() of no points does nothing.
   */
  bool Open();
  bool Append(vtkPointSet* points);
  bool Close();
  ///@}

  ///@{
  /// Of the file that was written last, or is being written: of a file that was there the points and
  /// pieces that it had, too.
  vtkGetMacro(NumberOfPointsWritten, vtkIdType);
  vtkGetMacro(NumberOfPiecesWritten, int);
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  ///@}

protected:
  vtkPointSplatOctreeWriter();
  ~vtkPointSplatOctreeWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override {}

private:
  vtkPointSplatOctreeWriter(const vtkPointSplatOctreeWriter&) = delete;
  void operator=(const vtkPointSplatOctreeWriter&) = delete;

  class File;

  bool WritePiece(vtkPolyData* points, vtkPolyData* levels, int numberOfLevels);
  void CarryProgress(vtkObject* octree, unsigned long event, void* data);
  /// Takes over what the file has that is there. Empty, or why this cannot be.
  std::string TakeOver();
  /// Gives the file up, and says why; false.
  bool GiveUp(const char* why);

  std::unique_ptr<File> Output;
  char* FileName = nullptr;
  int NumberOfPieces = 1;
  int CompressionLevel = 1;
  bool AppendToFile = false;
  vtkIdType NumberOfPointsWritten = 0;
  int NumberOfPiecesWritten = 0;
  int NumberOfPiecesBefore = 0;
  vtkIdType NumberOfSkippedPoints = 0;
  // Of what the progress is told: the piece and how many there are.
  int Piece = 0;
  int Pieces = 1;
};

VTK_ABI_NAMESPACE_END
#endif
