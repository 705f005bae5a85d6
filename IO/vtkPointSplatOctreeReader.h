// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatOctreeReader
 * @brief   reads the points of a vtkPointSplatOctreeWriter's file: all, as many as there is room for, or
 *          those that a camera sees
 *
 * 1. *Tree.* The blocks of all pieces are read: some 100 bytes for 80 points. The file stays open and
 *    the tree in memory; both are read anew when FileName, the file's size or its time changes.
 * 2. *Cut.* From the coarsest blocks down, the one with the largest splats gives way to those below
 *    it, as long as there are at most MaximumNumberOfPoints splats in all (Pajarola, Sainz, Guidotti
 *    2004, Confetti: Object-Space Point Blending and Splatting, section 6). So the size of splats is
 *    even over the cloud, but where points themselves are larger. Blocks off Bounds are left out.
 *    With a Camera a block gives way only if it reaches between the sides of the view and its
 *    largest splat has a radius of more than SplatPixels, in pixels, where the block is nearest to the
 *    eye; that with the most pixels comes first. What is off the view stays as coarse as the file has
 *    it, so that something is there when the camera turns.
 * 3. *Splats.* Of each level those chunks are read, of 8192 splats, that hold some of the cut's.
 *    They are kept in a cache of CacheSize: what a later cut has in common with earlier ones is not
 *    read again.
 *
 * Who draws calls FollowCamera() when the camera has come to rest, and Prefetch() while nothing else is
 * to be done: there is no thread, since HDF5 need not be safe for threads.
 * @code
 * reader->SetCamera(renderer->GetActiveCamera());
 * reader->SetViewSize(window->GetSize());
 * reader->SetMaximumNumberOfPoints(4000000); // 128 MB of the graphics card
 * // from a timer:
 * if (reader->FollowCamera()) { window->Render(); } else { reader->Prefetch(0.02); }
 * @endcode
 *
 * Output: a vtkPolyData of points (the written type), with normals, `SplatRadius`, or `SplatAxis1`
 * and `SplatAxis2`, so that vtkPointSplatMapper draws it as it is, a coarse version as smoothly as
 * the whole. Of other point data those arrays that all levels have which were read: the names of
 * points, for instance, are there if all splats are points. Field data is the first piece's.
 *
 * Bad input: a file that is not there, is no such file, is truncated or damaged, is an error, and the
 * output is empty; so is one that was spoilt since it was opened. Numbers in the tree that lead out of
 * the file are noticed. A camera without a place or with numbers that are none is a warning, and the
 * coarsest blocks are read.
 *
 * @sa vtkPointSplatOctreeWriter vtkPointSplatMapper
 */
#ifndef vtkPointSplatOctreeReader_h
#define vtkPointSplatOctreeReader_h

#include "vtkIOPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the camera

#include <memory> // For what is kept of the file

VTK_ABI_NAMESPACE_BEGIN

class vtkCamera;

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
   * piece: the budget of the graphics card, where the mapper needs 32 bytes for each. 0, the default:
   * all points, or with a camera all that SplatPixels asks for.
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
  /**
   * Who looks; none, as by default: the cut is the same from everywhere. Its coordinates are the
   * points': the actor has no transform. The reader does not run again when the camera moves, but when
   * FollowCamera() says so.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /// The picture's width and height in pixels, each at least 1. The default is 1024 x 768.
  void SetViewSize(int width, int height);
  void SetViewSize(const int size[2]) { this->SetViewSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewSize, int);
  ///@}

  ///@{
  /**
   * How large splats may be that a camera sees and that stand for others: their radius in pixels. 0:
   * what is seen is all points. With the default, 2, the picture cannot be told from that of all
   * points by eye.
   */
  vtkPointSplatSetClampMacro(SplatPixels, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SplatPixels, double);
  ///@}

  /**
   * Compares the cut that the camera wants now with the one that was read last. If more than 2 % of
   * their splats are not common to both, or if the file was written anew, this calls Modified(), so
   * that the next Update() reads, and returns true. False where there is no camera, and before the
   * first Update(). The file is not read here.
   */
  bool FollowCamera();

  /**
   * Reads ahead into the cache: what the camera will want where it comes to if it moves on as it has
   * between the last two views that an Update() or a FollowCamera() has found, which differed. About so
   * many seconds at once, and a chunk at least. False when there is nothing more to read, or no room
   * for it beside what the last cut uses.
   */
  bool Prefetch(double seconds);

  ///@{
  /**
   * The most memory for what was read, of all arrays together, unpacked, in KiB; what was used least
   * recently goes first. A cut that does not fit in is read anew each time. The default is 524288:
   * 512 MiB. 0: nothing is kept, for who reads once. The output is memory of its own.
   */
  void SetCacheSize(vtkIdType size);
  vtkIdType GetCacheSize();
  ///@}
  /// What the cache holds now, in KiB.
  vtkIdType GetCacheSizeUsed();
  /// Of arrays, unpacked, from the file: since this reader was made. The tree is not counted.
  vtkTypeInt64 GetNumberOfBytesRead();

  /**
   * Closes the file and forgets its tree and what was read; the next Update() opens it again. Where a
   * file that is open cannot be replaced, as on Windows, this goes before it is written.
   */
  void CloseFile();

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

  class Stream;
  /// Opens the file, unless it is. False, and an error: it cannot be.
  bool OpenFile();
  /// Closes the file, and says that it is damaged. 0.
  int GiveUp();

  char* FileName = nullptr;
  vtkIdType MaximumNumberOfPoints = 0;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkSmartPointer<vtkCamera> Camera;
  int ViewSize[2] = { 1024, 768 };
  double SplatPixels = 2.0;
  std::unique_ptr<Stream> Input;
  vtkIdType NumberOfPointsInFile = 0;
  double BoundsInFile[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int CoarsestLevelRead = 0;
};

VTK_ABI_NAMESPACE_END
#endif
