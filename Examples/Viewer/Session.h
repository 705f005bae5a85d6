// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What splatview's window tells its user, and what keys do there.
#ifndef Session_h
#define Session_h

#include "Scene.h"

#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkTextActor.h"

/**
 * The files that a window shows, for its title.
 */
std::string TitleOf(const std::vector<std::string>& files);

/**
 * The trackball, with its keys (r, w, s, f, 3, q, e) and
 * 1. h: lists the keys on the screen, or takes the list away,
 * 2. p: tells of the point under the pointer its surface, id, coordinates and arrays, on the screen
 *    and, unless the session is quiet, on standard output,
 * 3. a legend where there is more than one surface,
 * 4. of files with more points than are drawn, what the camera sees whenever it has come to rest; while it
 *    rests what may come next is read.
 */
class Session : public vtkInteractorStyleTrackballCamera
{
public:
  static Session* New();
  vtkTypeMacro(Session, vtkInteractorStyleTrackballCamera);

  /// Of which the texts tell. It outlives the session.
  void SetScene(const Scene& scene, bool quiet);
  /// Reads what the camera sees from now on, if there are such files; the interactor is initialized.
  void StartFollowing();
  void OnChar() override;
  void OnTimer() override;

private:
  void AddLegend();
  void UpdateHelp();
  void Pick();
  void FollowCamera();
  /// What there is to tell of a point: a line each.
  static std::vector<std::string> Describe(const Surface& surface, vtkIdType point);

  const Scene* Shown = nullptr;
  bool Quiet = false;
  bool IsFollowing = false;
  vtkMTimeType Moved = 0; // when the camera was seen to move
  vtkSmartPointer<vtkTextActor> Help;
  vtkSmartPointer<vtkTextActor> Note;
};

#endif
