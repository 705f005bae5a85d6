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
 * 3. a legend where there is more than one surface.
 */
class Session : public vtkInteractorStyleTrackballCamera
{
public:
  static Session* New();
  vtkTypeMacro(Session, vtkInteractorStyleTrackballCamera);

  /// Of which the texts tell. It outlives the session.
  void SetScene(const Scene& scene, bool quiet);
  void OnChar() override;

private:
  void AddLegend();
  void UpdateHelp();
  void Pick();
  /// What there is to tell of a point: a line each.
  static std::vector<std::string> Describe(const Surface& surface, vtkIdType point);

  const Scene* Shown = nullptr;
  bool Quiet = false;
  vtkSmartPointer<vtkTextActor> Help;
  vtkSmartPointer<vtkTextActor> Note;
};

#endif
