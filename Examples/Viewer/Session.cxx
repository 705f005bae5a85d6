// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "Messages.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkLegendBoxActor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace
{
// As many as a window of ordinary height holds.
constexpr size_t MostLegendEntries = 16;
// Of an array with more components the first ones are told.
constexpr int MostComponents = 9;
constexpr unsigned long TimerPeriod = 50; // milliseconds
// What a user does not notice who begins to move meanwhile.
constexpr double PrefetchSeconds = 0.02;

std::string NameOf(const std::string& file)
{
  return std::filesystem::path(file).filename().string();
}

vtkSmartPointer<vtkTextActor> MakeText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  vtkTextProperty* look = text->GetTextProperty();
  look->SetFontFamilyToCourier();
  look->SetFontSize(14);
  look->SetBackgroundColor(0.0, 0.0, 0.0);
  look->SetBackgroundOpacity(0.6);
  text->PickableOff();
  text->VisibilityOff();
  return text;
}
}

vtkStandardNewMacro(Session);

//------------------------------------------------------------------------------
std::string TitleOf(const std::vector<std::string>& files)
{
  std::string title;
  constexpr size_t most = 3;
  for (size_t i = 0; i < std::min(files.size(), most); ++i)
  {
    title += (i ? ", " : "") + NameOf(files[i]);
  }
  if (files.size() > most)
  {
    title += " and " + std::to_string(files.size() - most) + " more";
  }
  return title.empty() ? "splatview" : title + " - splatview";
}

//------------------------------------------------------------------------------
void Session::SetScene(const Scene& scene, bool quiet)
{
  this->Shown = &scene;
  this->Quiet = quiet;
  this->Help = MakeText();
  this->Help->GetTextProperty()->SetVerticalJustificationToTop();
  this->Help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Help->SetPosition(0.01, 0.99);
  this->Note = MakeText();
  this->Note->SetPosition(8, 8);
  scene.Renderer->AddViewProp(this->Help);
  scene.Renderer->AddViewProp(this->Note);
  if (scene.Surfaces.size() > 1)
  {
    this->AddLegend();
  }
}

//------------------------------------------------------------------------------
void Session::AddLegend()
{
  vtkNew<vtkPlaneSource> square;
  square->Update();
  const std::vector<Surface>& surfaces = this->Shown->Surfaces;
  const size_t entries = std::min(surfaces.size(), MostLegendEntries);
  vtkNew<vtkLegendBoxActor> legend;
  legend->SetNumberOfEntries(static_cast<int>(entries));
  for (size_t i = 0; i < entries; ++i)
  {
    const Surface& surface = surfaces[i];
    std::ostringstream text;
    text << NameOf(surface.Name);
    if (surface.Isovalue)
    {
      text << " at " << *surface.Isovalue;
    }
    if (surface.Colours != "actor")
    {
      text << " (" << surface.Colours << ")";
    }
    if (i + 1 == entries && surfaces.size() > entries)
    {
      text << " and " << surfaces.size() - entries << " more";
    }
    // Where an array colours the points no one colour stands for them.
    double white[3] = { 1.0, 1.0, 1.0 };
    legend->SetEntry(static_cast<int>(i), square->GetOutput(), text.str().c_str(),
      surface.Colours == "actor" ? surface.Actor->GetProperty()->GetColor() : white);
  }
  const double height = std::min(0.05 * static_cast<double>(entries), 0.8);
  legend->SetPosition(0.64, 0.99 - height);
  legend->SetPosition2(0.35, height);
  legend->UseBackgroundOn();
  legend->SetBackgroundColor(0.1, 0.1, 0.1);
  legend->PickableOff();
  this->Shown->Renderer->AddViewProp(legend);
}

//------------------------------------------------------------------------------
void Session::StartFollowing()
{
  const std::vector<Surface>& surfaces = this->Shown->Surfaces;
  this->IsFollowing = std::any_of(surfaces.begin(), surfaces.end(),
    [](const Surface& surface) { return static_cast<bool>(surface.Stream); });
  if (this->IsFollowing)
  {
    this->Interactor->CreateRepeatingTimer(TimerPeriod);
  }
}

//------------------------------------------------------------------------------
void Session::OnTimer()
{
  // Not the superclass's: it would go on turning at each of the timer's beats.
  if (this->IsFollowing && this->State == VTKIS_NONE)
  {
    this->FollowCamera();
  }
}

//------------------------------------------------------------------------------
void Session::FollowCamera()
{
  vtkRenderer* renderer = this->Shown->Renderer;
  const vtkMTimeType moved = renderer->GetActiveCamera()->GetMTime();
  if (moved != this->Moved)
  {
    // A wheel that turns comes to rest between its clicks, but not for long.
    this->Moved = moved;
    return;
  }
  const int* size = renderer->GetRenderWindow()->GetSize();
  bool behind = false;
  for (const Surface& surface : this->Shown->Surfaces)
  {
    behind = (surface.Stream && surface.Stream->Follow(size)) || behind;
  }
  if (behind)
  {
    renderer->ResetCameraClippingRange();
    this->Interactor->Render();
    const std::string error = MessageKeeper::TakeError();
    if (!error.empty())
    {
      std::fprintf(stderr, "splatview: %s\n", error.c_str());
    }
    return;
  }
  for (const Surface& surface : this->Shown->Surfaces)
  {
    if (surface.Stream && surface.Stream->Prefetch(PrefetchSeconds))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void Session::OnChar()
{
  const char key = this->Interactor->GetKeyCode();
  if (this->Shown && (key == 'h' || key == 'H'))
  {
    this->Help->SetVisibility(!this->Help->GetVisibility());
    this->UpdateHelp();
    this->Interactor->Render();
  }
  else if (this->Shown && (key == 'p' || key == 'P'))
  {
    this->Pick();
    this->Interactor->Render();
  }
  else
  {
    this->Superclass::OnChar();
    if (this->Shown && this->Help->GetVisibility())
    {
      this->UpdateHelp();
      this->Interactor->Render();
    }
  }
}

//------------------------------------------------------------------------------
void Session::UpdateHelp()
{
  const int representation =
    this->Shown->Surfaces[0].Actor->GetProperty()->GetRepresentation();
  const std::string now = representation == VTK_WIREFRAME ? "wireframe" : "surface";
  this->Help->SetInput(("drag   turn; with shift: move, with control: roll\n"
                        "wheel  nearer, farther\n"
                        "r      all in view\n"
                        "w, s   wireframe, surface; now: " +
    now +
    "\n"
    "p      tell of the point under the pointer\n"
    "f      fly to it\n"
    "3      stereo\n"
    "h      these lines\n"
    "q, e   end")
                         .c_str());
}

//------------------------------------------------------------------------------
void Session::Pick()
{
  vtkRenderer* renderer = this->Shown->Renderer;
  const int* at = this->Interactor->GetEventPosition();
  const int* size = renderer->GetRenderWindow()->GetSize();
  const unsigned int pixel[2] = { static_cast<unsigned int>(std::clamp(at[0], 0, size[0] - 1)),
    static_cast<unsigned int>(std::clamp(at[1], 0, size[1] - 1)) };

  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(pixel[0], pixel[1], pixel[0], pixel[1]);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::vector<std::string> lines{ "no point here" };
  if (selector->CaptureBuffers())
  {
    const auto hit = selector->GetPixelInformation(pixel);
    for (const Surface& surface : this->Shown->Surfaces)
    {
      if (hit.Valid && hit.Prop == surface.Actor)
      {
        lines = Session::Describe(surface, hit.AttributeID);
      }
    }
  }
  std::string shown;
  std::string told;
  for (const std::string& line : lines)
  {
    shown += (shown.empty() ? "" : "\n") + line;
    told += (told.empty() ? "" : ", ") + line;
  }
  this->Note->SetInput(shown.c_str());
  this->Note->VisibilityOn();
  if (!this->Quiet)
  {
    std::printf("%s\n", told.c_str());
    std::fflush(stdout);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> Session::Describe(const Surface& surface, vtkIdType point)
{
  auto data = vtkDataSet::SafeDownCast(surface.Mapper->GetInputDataObject(0, 0));
  auto sources = data && point < data->GetNumberOfPoints()
    ? data->GetPointData()->GetArray(vtkPointSplatArrays::Source)
    : nullptr;
  if (sources && surface.NumberOfFillPoints > 0)
  {
    // A fill point stands for the point of the file that it is nearest to.
    point = static_cast<vtkIdType>(sources->GetTuple1(point));
  }
  std::vector<std::string> lines{ NameOf(surface.Name) + ": point " + std::to_string(point) };
  if (!data || point >= data->GetNumberOfPoints())
  {
    return lines;
  }
  double x[3];
  data->GetPoint(point, x);
  std::ostringstream place;
  place.precision(9);
  place << "at " << x[0] << ' ' << x[1] << ' ' << x[2];
  lines.push_back(place.str());
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "(without name)";
    const int components = std::min(array->GetNumberOfComponents(), MostComponents);
    std::string line = name;
    for (int c = 0; c < components; ++c)
    {
      line += ' ' + array->GetVariantValue(point * array->GetNumberOfComponents() + c).ToString();
    }
    lines.push_back(line + (components < array->GetNumberOfComponents() ? " ..." : ""));
  }
  return lines;
}
