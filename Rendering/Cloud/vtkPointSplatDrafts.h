// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Drafts of a large cloud, that are drawn until the cloud itself is there.
//
// Sizes are estimated at some 300,000 points a second and core. Where a window can be asked for
// another frame, nobody has to wait for that:
// 1. The first draft, at once: splats of FirstPoints points, one at random of each as many that
//    follow one another, with sizes estimated from these alone.
// 2. A thread makes the splats of Growth times as many, and again, and, where that would be more
//    than half, of all; with levels (vtkPointSplatLevels.h), if the drafts' frames asked for
//    them. It works on a copy of the arrays, so that whoever owns these may change them meanwhile.
//    It begins when points stayed as they are for a while: those that change with every frame are
//    drafts each time, and cost no copies.
// 3. What is ready is taken over between frames, by Advance(), which says that a new one is worth it.
// Drafts have the colours, shadows' factors and coordinates of their points, and those points' ids.
//
// Where the cloud's own points, normals or sizes change, all begins anew.
#ifndef vtkPointSplatDrafts_h
#define vtkPointSplatDrafts_h

#include "vtkPointSplatCloud.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <future>
#include <memory>
#include <string>
#include <vector>

class vtkPointSplatDrafts
{
public:
  using CloudPointer = std::unique_ptr<vtkPointSplatCloud>;

  vtkPointSplatDrafts();
  ~vtkPointSplatDrafts();
  vtkPointSplatDrafts(const vtkPointSplatDrafts&) = delete;
  void operator=(const vtkPointSplatDrafts&) = delete;

  /**
   * Whether splats of the input take seconds to make, and drafts of it can be drawn: of one large
   * data set, whose colours are not of cells.
   */
  static bool AreOfUse(const vtkPointSplatCloudInput& input);

  /**
   * Brings the draft up to date, unless the cloud is, or drafts are of no use. True: the draft is
   * to be drawn.
   */
  bool Update(const vtkPointSplatCloudInput& input, const vtkPointSplatCloud& cloud);

  /**
   * Between frames: takes over what is ready, the cloud itself at last, and begins with what is
   * next. True where another frame will show more.
   */
  bool Advance(CloudPointer& cloud);

  /// Ends drafts, and takes all that the thread makes, if that is the cloud itself.
  void Finish(CloudPointer& cloud);
  /// Ends drafts, and what is under way.
  void Stop();

  /// Whether a draft is drawn, and which.
  bool AreDrawn() const { return this->Draft != nullptr; }
  vtkPointSplatCloud& GetCloud() { return *this->Draft; }
  const vtkPointSplatCloud& GetCloud() const { return *this->Draft; }
  /// Whether there will be more than what is drawn.
  bool IsUnderWay() const { return this->Draft && !this->GivenUp; }
  /// Of what the thread makes, how much is done, 0 to 1.
  double GetProgress() const;

private:
  class Task;
  /// As many of the points, with all that they have.
  struct Part
  {
    vtkSmartPointer<vtkPointSet> Data;
    std::vector<vtkIdType> Ids;
  };
  static Part Choose(vtkPointSet* data, vtkIdType count);
  static void CopyArrays(vtkPointSet* from, Part& part);
  vtkPointSplatCloudInput InputOf(const Part& part) const;
  void Begin();
  bool IsWhole(const Task& task) const;
  void TakeOver(CloudPointer& cloud);

  vtkPointSplatCloudInput Input; // as it was last
  vtkWeakPointer<vtkPointSet> Data;
  vtkPointSplatCloud::Key MadeFrom;
  vtkPointSplatCloud::Key StaysFrom;
  vtkMTimeType DataTime = 0; // when the part's arrays were copied
  Part Drawn;
  CloudPointer Draft;
  std::unique_ptr<Task> Work;
  bool Rested = false; // points stayed as they are from one Advance() to the next
  bool GivenUp = false;
};

#endif
