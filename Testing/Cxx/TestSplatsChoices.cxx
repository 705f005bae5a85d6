// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The automatic choices: a table of facts and what follows from them; a budget of time, with times
// that are made up; and that the mapper asks them.
#include "SplatScene.h"

#include "vtkPointSplatBudget.h"
#include "vtkPointSplatChoices.h"

#include <functional>
#include <set>
#include <sstream>

namespace
{
using namespace SplatScene;
using Facts = vtkPointSplatFacts;
using Settings = vtkPointSplatSettings;
using Mapper = vtkPointSplatMapper;

constexpr double Good = 1.0 / 256.0, Fair = 1.0 / 64.0, Rough = 1.0 / 16.0;

/// Two opaque clouds at rest, of points half a pixel and four pixels apart.
Facts Opaque(double error)
{
  Facts facts;
  facts.Clouds = { { 640000, 0.5 }, { 40000, 4.0 } };
  facts.TargetError = error;
  return facts;
}

Facts Translucent(double error, int transparency = Settings::AutomaticTransparency)
{
  Facts facts = Opaque(error);
  facts.Translucent = true;
  facts.Transparency = transparency;
  return facts;
}

Facts Points(double spacing)
{
  Facts facts = Opaque(Good);
  facts.AsksPoints = true;
  facts.Clouds = { { 640000, spacing } };
  return facts;
}

/**
 * What must be chosen for some facts.
 */
struct Row
{
  std::string What;
  Facts Given;
  bool Compute;
  bool Deferred;
  int Transparency;
  int Layers;
  int FillSteps;
  std::vector<int> Strides;
  std::string Why; // in one of the reasons
};

Facts With(Facts facts, const std::function<void(Facts&)>& change)
{
  change(facts);
  return facts;
}

std::vector<Row> Table()
{
  const int peel = Settings::Peeling, sort = Settings::Sorted, exact = Settings::NearestExact;
  auto deferred = [](Facts& f) {
    f.AsksDeferred = true;
    f.Groups = 5;
  };
  return {
    { "full quality", Opaque(Good), true, false, peel, 1, 0, { 0, 0 }, "by tiles" },
    // Every 2^n-th splat has an error of 0.012 a pixel of the distance that they then have.
    { "1/64", Opaque(Fair), true, false, peel, 1, 0, { 0, 0 }, "fewer ones might" },
    { "1/16", Opaque(Rough), true, false, peel, 1, 0, { 5, 0 }, "fewer, larger" },
    { "spacing not known", With(Opaque(Rough), [](Facts& f) { f.Clouds[0].SpacingPixels = 0.0; }),
      true, false, peel, 1, 0, { 0, 0 }, "fewer ones might" },
    { "coloured points", With(Opaque(Rough), [](Facts& f) { f.Clouds[0].Painted = true; }), true,
      false, peel, 1, 0, { 0, 0 }, "fewer ones might" },
    { "a drag", With(Opaque(Good), [](Facts& f) { f.Tolerance = 1.0 / 32.0; }), true, false, peel, 1,
      0, { 4, 0 }, "fewer, larger" },
    { "a drag in a rough scene", With(Opaque(Rough), [](Facts& f) { f.Tolerance = Fair; }), true,
      false, peel, 1, 0, { 5, 0 }, "1/16" },
    { "quads by hand", With(Opaque(Good), [](Facts& f) { f.AsksQuads = true; }), false, false, peel,
      1, 0, { 0, 0 }, "quads were asked for" },
    { "no compute shaders", With(Opaque(Good), [](Facts& f) { f.Compute = false; }), false, false,
      peel, 1, 0, { 0, 0 }, "OpenGL 4.3" },
    { "deferred by hand: all splats, since they are grouped", With(Opaque(Rough), deferred), true,
      true, peel, 1, 0, { 0, 0 }, "it was asked for" },
    { "translucent, full quality", Translucent(Good), true, false, peel, 32, 0, { 0, 0 },
      "no other takes less time" },
    { "translucent, 1/16", Translucent(Rough), true, false, peel, 32, 0, { 5, 0 }, "1/16" },
    { "peeling by hand", Translucent(Good, Settings::Peeling), true, false, peel, 32, 0, { 0, 0 },
      "peeling was asked for" },
    { "few layers by hand", With(Translucent(Good), [](Facts& f) { f.MaximumLayers = 3; }), true,
      false, peel, 3, 0, { 0, 0 }, "no other takes less time" },
    { "sorting by hand", Translucent(Rough, Settings::Sorted), true, false, sort, 0, 0, { 0, 0 },
      "it was asked for" },
    { "nearest exact by hand", Translucent(Good, Settings::NearestExact), true, false, exact, 1, 0,
      { 0, 0 }, "the others are sorted" },
    { "sorting by hand, refracting: the nearest layer is needed",
      With(Translucent(Good, Settings::Sorted), [](Facts& f) { f.Refracts = true; }), true, false,
      sort, 1, 0, { 0, 0 }, "it was asked for" },
    { "sorting by hand among other translucent props",
      With(Translucent(Good, Settings::Sorted), [](Facts& f) { f.Sortable = false; }), true, false,
      peel, 32, 0, { 0, 0 }, "other translucent props" },
    { "sorting and image space by hand",
      With(Translucent(Good, Settings::Sorted), [](Facts& f) { f.AsksPoints = true; }), true, false,
      peel, 32, 2, { 0, 0 }, "cannot be sorted" },
    { "image space, points as dense as pixels", Points(0.9), true, false, peel, 1, 1, { 0 },
      "one step does" },
    { "image space, sparser", Points(1.3), true, false, peel, 1, 2, { 0 }, "1.3 pixels apart" },
    { "image space, spacing not known", Points(0.0), true, false, peel, 1, 2, { 0 }, "one step" },
    { "image space, 1/16: all points, since holes show",
      With(Points(0.5), [](Facts& f) { f.TargetError = Rough; }), true, false, peel, 1, 1, { 0 },
      "it was asked for" },
  };
}

std::string AllReasons(const vtkPointSplatChoice& choice)
{
  return choice.ProjectionReason + "; " + choice.MethodReason + "; " + choice.TransparencyReason +
    "; " + choice.LayersReason + "; " + choice.FillReason + "; " + choice.SplatsReason;
}

void TestTable(Checks& checks)
{
  for (const Row& row : Table())
  {
    const vtkPointSplatChoice choice = vtkPointSplatChoices::Make(row.Given);
    std::ostringstream text;
    text << row.What << ": compute " << choice.Compute << ", deferred " << choice.Deferred
         << ", transparency " << choice.Transparency << ", layers " << choice.MaximumLayers
         << ", fill steps " << choice.FillSteps << ", strides";
    for (const int shift : choice.StrideShifts)
    {
      text << " 2^" << shift;
    }
    text << "; " << AllReasons(choice);
    checks.Expect(choice.Compute == row.Compute && choice.Deferred == row.Deferred &&
        choice.Transparency == row.Transparency && choice.MaximumLayers == row.Layers &&
        choice.FillSteps == row.FillSteps && choice.StrideShifts == row.Strides,
      text.str());
    checks.Expect(AllReasons(choice).find(row.Why) != std::string::npos,
      text.str() + " does not say: " + row.Why);
    checks.Expect(!choice.MethodReason.empty() && !choice.ProjectionReason.empty() &&
        !choice.TransparencyReason.empty() && !choice.LayersReason.empty() &&
        !choice.FillReason.empty() && !choice.SplatsReason.empty() && !choice.Refused,
      row.What + ": a reason is missing, or it was refused");
    checks.Expect(choice.IsLike(vtkPointSplatChoices::Make(row.Given)),
      row.What + ": chosen otherwise the second time");
  }
}

/// Deferred blending where it cannot be had, and why.
void TestRefused(Checks& checks)
{
  auto deferred = [](Facts facts, int groups, bool fit) {
    facts.AsksDeferred = true;
    facts.Groups = groups;
    facts.GroupsFit = fit;
    return vtkPointSplatChoices::Make(facts);
  };
  const std::pair<vtkPointSplatChoice, const char*> refused[] = {
    { deferred(Opaque(Good), 12, false), "MaximumImageMemory" },
    { deferred(Opaque(Good), 0, true), "cannot be grouped" },
    { deferred(Translucent(Good), 4, true), "opaque layers only" },
  };
  for (const auto& [choice, why] : refused)
  {
    checks.Expect(choice.Refused && !choice.Deferred &&
        choice.MethodReason.find(why) != std::string::npos,
      std::string("deferred blending, ") + why + ": " + choice.MethodReason);
  }
}

void TestTolerances(Checks& checks)
{
  // Before it was measured, what is behind might differ by all of the light that is left.
  const auto least = [](const Facts& facts) {
    return vtkPointSplatChoices::Make(facts).LeastContribution;
  };
  Facts drag = Translucent(Good);
  drag.Tolerance = 1.0 / 32.0;
  checks.Expect(least(Translucent(Good)) == Good, "in full quality peeling draws all that can be seen");
  checks.Expect(least(Translucent(Rough)) == Rough && least(drag) == 1.0 / 32.0,
    "peeling ends by the target error, and in a drag by its tolerance");
  checks.Expect(vtkPointSplatChoices::StrideShift(0.5, 0.6) == 0 &&
      vtkPointSplatChoices::StrideShift(1.5, 3.01) == 2 &&
      vtkPointSplatChoices::StrideShift(1.5, 2.99) == 1 &&
      vtkPointSplatChoices::StrideShift(1e-3, 100.0) == 5 &&
      vtkPointSplatChoices::StrideShift(0.0, 100.0) == 0,
    "strides");
  const auto outlines = [](double error) { return vtkPointSplatChoices::Make(Opaque(error)).Outlines; };
  checks.Expect(outlines(Good) && outlines(Fair) && !outlines(1.0 / 32.0) && !outlines(Rough),
    "outlines are smoothed below their error");
  checks.Expect(vtkPointSplatChoices::Text(1.0 / 64.0) == "1/64" &&
      vtkPointSplatChoices::Text(0.3) == "0.3",
    "errors in words");
}

/// What frames were measured to lose decides before constants do.
void TestMeasured(Checks& checks)
{
  const auto with = [](Facts facts, size_t apart, size_t ends, double error) {
    // All up to some have that error, the others the greatest.
    facts.ApartErrors.assign(vtkPointSplatChoices::ApartPixels(Rough).size(), 1.0);
    std::fill_n(facts.ApartErrors.begin(), apart, error);
    facts.EndErrors.assign(vtkPointSplatChoices::EndLights().size(), error);
    std::fill_n(facts.EndErrors.begin(), ends, 1.0);
    return vtkPointSplatChoices::Make(facts);
  };
  const std::vector<double> lights = vtkPointSplatChoices::EndLights();
  const auto shift = [](const vtkPointSplatChoice& choice) { return choice.StrideShifts[0]; };
  // Of splats half a pixel apart: up to 0.63, 0.88, 1.25, 1.8 pixels.
  checks.Expect(shift(with(Opaque(Fair), 4, 0, 0.0104)) == 3 &&
      shift(with(Opaque(Fair), 4, 0, 0.0105)) == 0 && shift(with(Opaque(Fair), 0, 0, 0.0)) == 0 &&
      shift(with(Opaque(Rough), 0, 0, 0.0)) == 0,
    "fewer splats may have four ninths of the squared error");
  checks.Expect(shift(with(Opaque(Fair), 8, 0, 0.0)) == 4 && shift(with(Opaque(Rough), 8, 0, 0.0)) == 5 &&
      shift(with(Opaque(Good), 8, 0, 0.0)) == 0,
    "twice as far apart as where it was not measured");
  checks.Expect(shift(with(Translucent(Fair), 4, 0, 0.0073)) == 3 &&
      shift(with(Translucent(Fair), 4, 0, 0.0075)) == 0,
    "beside layers two ninths of it");
  const auto least = [&](size_t apart, size_t ends, double error) {
    return with(Translucent(Fair), apart, ends, error).LeastContribution;
  };
  checks.Expect(least(0, 2, 0.0104) == lights[2] && least(0, 2, 0.0105) == Fair &&
      least(4, 2, 0.0073) == lights[2],
    "layers may have what fewer splats leave of four ninths");
  Facts facts = Translucent(Fair);
  facts.Clouds[0].Painted = true;
  checks.Expect(shift(with(facts, 4, 2, 0.0)) == 3, "of colours it was measured, too");
  for (const double apart : { 0.0, 1.5 })
  {
    facts.Apart = apart;
    const vtkPointSplatChoice choice = with(facts, 4, 2, 0.0);
    checks.Expect(choice.LeastContribution == Good && shift(choice) == (apart > 0.0 ? 3 : 0) &&
        choice.LayersReason.find("to measure") != std::string::npos,
      "a frame that is measured has all layers, and as many splats as it is to have");
  }
}

void TestShadowSamples(Checks& checks)
{
  auto samples = [](int wanted, bool interacting, double target, double error = 0.0267) {
    Settings settings;
    settings.NumberOfShadowSamples = wanted;
    settings.NumberOfInteractiveShadowSamples = 2;
    settings.TargetError = target;
    std::string reason;
    const int count = vtkPointSplatChoices::ShadowSamples(settings, interacting, error, reason);
    return reason.empty() ? -1 : count;
  };
  checks.Expect(samples(1000, false, 0.0) == 1000 && samples(1000, false, 0.0, 0.0) == 1000,
    "a target of 0 takes all samples");
  checks.Expect(samples(1000, false, Good) == 47, "samples for full quality");
  checks.Expect(samples(16, false, 1.0 / 64.0) == 3, "samples for 1/64");
  checks.Expect(samples(16, false, 1.0 / 128.0) == 12, "samples for 1/128");
  checks.Expect(samples(1000, false, 1.0 / 64.0, 0.08) == 27, "samples for 1/64 on white");
  checks.Expect(samples(16, false, 1.0 / 64.0, 0.16) == 16, "samples for 1/64 in glaring light");
  checks.Expect(samples(16, false, 1.0 / 64.0, 0.0) == 1, "samples for 1/64 on black");
  checks.Expect(samples(4, false, 1.0 / 128.0) == 4, "no more than were asked for");
  checks.Expect(samples(16, false, 1.0 / 16.0) == 1, "samples for 1/16");
  checks.Expect(samples(16, true, Good) == 2, "samples while dragging");
  checks.Expect(samples(1, true, Good) == 1, "no more while dragging than at rest");
  const auto error = vtkPointSplatChoices::OneSampleError;
  checks.Expect(error(0.0) == 0.0 && error(0.1) > 1.5 * error(0.05) && error(0.1) < 2.0 * error(0.05),
    "wider lamps have a greater error");
}

/// A drag on a machine on which a choice takes so many seconds.
struct Machine
{
  using Times = std::function<double(const vtkPointSplatChoice&, int)>;
  explicit Machine(Times seconds)
    : Seconds(std::move(seconds))
  {
  }
  Times Seconds;
  vtkPointSplatBudget Budget;
  unsigned long Frame = 1;
  int Changes = 0;
  size_t Rung = 0;

  void Draw(const Facts& facts, double allowed)
  {
    std::vector<vtkPointSplatChoice> ladder = vtkPointSplatChoices::Ladder(facts);
    const size_t rung = this->Budget.Choose(ladder, allowed, this->Frame);
    this->Changes += rung != this->Rung;
    this->Rung = rung;
    this->Budget.Measured(
      allowed > 0.0 ? this->Seconds(ladder[rung], static_cast<int>(this->Frame)) : 0.0,
      this->Frame);
    ++this->Frame;
  }
};

void TestBudget(Checks& checks)
{
  const Facts facts = Opaque(Good);
  const std::vector<vtkPointSplatChoice> ladder = vtkPointSplatChoices::Ladder(facts);
  checks.Expect(ladder.size() == 2 && ladder.front().StrideShifts == std::vector<int>{ 0, 0 } &&
      ladder.back().StrideShifts == std::vector<int>{ 4, 0 },
    "a ladder from all splats to a sixteenth of them");
  for (const Facts& scene : { facts, Translucent(Good) })
  {
    const std::vector<vtkPointSplatChoice> rungs = vtkPointSplatChoices::Ladder(scene);
    checks.AtLeast<size_t>(rungs.size(), 2, "rungs");
    for (size_t i = 1; i < rungs.size(); ++i)
    {
      checks.Expect(!rungs[i].IsLike(rungs[i - 1]) && rungs[i].Tolerance > rungs[i - 1].Tolerance,
        "each rung does other work, for a greater error");
    }
  }
  checks.AtMost<size_t>(
    vtkPointSplatChoices::Ladder(Opaque(Rough)).size(), 1, "rungs below the target error");

  // All splats, every fourth, and every sixteenth in half the time of these.
  const auto by = [](double all, double fewer) {
    return [=](const vtkPointSplatChoice& choice, int) {
      const int shift = choice.StrideShifts[0];
      return shift == 0 ? all : shift == 2 ? fewer : 0.5 * fewer;
    };
  };

  Machine fast{ by(0.05, 0.01) };
  Machine slow{ by(0.3, 0.05) };
  Machine slower{ by(3.0, 1.0) };
  // Fewer splats just fit; all just do not.
  Machine noisy{ [](const vtkPointSplatChoice& choice, int frame) {
    const double noise = 1.0 + 0.25 * std::sin(12.9898 * frame);
    return noise * (choice.StrideShifts[0] == 0 ? 0.065 : 0.03);
  } };
  for (Machine* machine : { &fast, &slow, &slower, &noisy })
  {
    for (int i = 0; i < 3; ++i)
    {
      machine->Draw(facts, 0.0);
      checks.Expect(machine->Rung == 0, "at rest all is drawn in full quality");
    }
    for (int i = 0; i < 200; ++i)
    {
      machine->Draw(facts, 1.0 / 15.0);
    }
  }
  checks.Expect(fast.Rung == 0 && fast.Changes == 0, "a fast machine keeps full quality");
  checks.Expect(slow.Rung >= 1 && slow.Changes == 1, "a slow one goes down once");
  checks.Expect(slower.Rung + 1 == vtkPointSplatChoices::Ladder(facts).size(),
    "one that is too slow for all goes all the way down");
  checks.AtMost(noisy.Changes, 2, "changes where times are noisy");
  slow.Draw(facts, 0.0);
  checks.Expect(slow.Rung == 0, "full quality after the drag");
  slow.Draw(facts, 1.0 / 15.0);
  checks.Expect(slow.Rung >= 1, "the next drag begins where the last one ended");
  // The scene becomes cheap: a tenth of the time.
  slow.Seconds = by(0.03, 0.005);
  for (int i = 0; i < 3 * vtkPointSplatBudget::Patience; ++i)
  {
    slow.Draw(facts, 1.0 / 15.0);
  }
  checks.Expect(slow.Rung == 0, "full quality again when it fits");
  // One slow frame is no reason.
  Machine hiccup{ [](const vtkPointSplatChoice&, int frame) { return frame == 20 ? 0.15 : 0.05; } };
  for (int i = 0; i < 40; ++i)
  {
    hiccup.Draw(facts, 1.0 / 15.0);
  }
  checks.Expect(hiccup.Changes == 0, "one slow frame");
  // Asked twice in a frame, as by two actors, it is not two steps.
  std::vector<vtkPointSplatChoice> again = vtkPointSplatChoices::Ladder(facts);
  vtkPointSplatBudget twice;
  twice.Choose(again, 0.01, 1);
  twice.Measured(0.0, 1);
  twice.Choose(again, 0.01, 2);
  twice.Measured(9.0, 2);
  const size_t once = twice.Choose(again, 0.01, 3);
  checks.Expect(once == 1 && twice.Choose(again, 0.01, 3) == once, "two questions in a frame");
  // What does not pay in one ladder is the best of the next: no rung above it pays, nor it itself.
  std::vector<vtkPointSplatChoice> first = vtkPointSplatChoices::Ladder(facts);
  std::vector<vtkPointSplatChoice> next = { first[1],
    vtkPointSplatChoices::Ladder(Translucent(Good)).back() };
  vtkPointSplatBudget changed;
  for (unsigned long frame = 1; frame < 30; ++frame)
  {
    std::vector<vtkPointSplatChoice>& rungs = frame < 6 ? first : next;
    checks.Expect(changed.Choose(rungs, 0.01, frame) < rungs.size(), "a rung of the ladder");
    changed.Measured(0.05, frame);
  }
}

/// Translucent shells: layers that are measured to show less than the target error are left out.
void TestMeasuredLayers(Checks& checks)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(RandomTorus(20000));
  Window window(150);
  window.Add(mapper)->GetProperty()->SetOpacity(0.6);
  window.Renderer->GetActiveCamera()->Elevation(80.0);
  window.Renderer->ResetCamera();
  window.Draw();
  const int all = mapper->GetNumberOfLayersDrawn();
  mapper->SetTargetError(Rough);
  window.Draw();
  checks.Expect(mapper->GetNumberOfLayersDrawn() == all, "a frame to measure has all layers");
  window.Draw();
  checks.AtMost(mapper->GetNumberOfLayersDrawn(), all - 1, "layers after it");
  const auto measures = [&]() {
    window.Draw();
    return std::string(mapper->GetChoices()).find("to measure") != std::string::npos;
  };
  checks.Expect(!measures(), "it is measured once");
  window.Renderer->GetActiveCamera()->Elevation(-20.0);
  checks.Expect(!measures(), "and holds when the camera turns a little");
  window.Renderer->GetActiveCamera()->Elevation(-50.0);
  checks.Expect(measures() && !measures(), "but not when it turns much");
  window.Renderer->GetActiveCamera()->Zoom(3.0);
  checks.Expect(measures() && !measures(), "nor when things are seen larger");
  window.Renderer->SetBackground(1.0, 1.0, 1.0);
  checks.Expect(measures() && !measures(), "nor on another background");
  int measured = 0;
  for (int i = 0; i < 12; ++i)
  {
    window.Renderer->SetBackground(0.05 * i, 0.5, 0.5);
    measured += measures();
  }
  checks.AtMost(measured, 4, "frames of an animation that are measured");
}

/// Rms difference of colour, of 1, over the pixels that either picture draws.
double Difference(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  long count = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      for (int c = 0; c < 3 && (!a.IsBackground(x, y) || !b.IsBackground(x, y)); ++c)
      {
        sum += std::pow((double(a.At(x, y)[c]) - b.At(x, y)[c]) / 255.0, 2);
        ++count;
      }
    }
  }
  return std::sqrt(sum / count);
}

/**
 * That the mapper draws what is chosen, says so, and is at its best at rest.
 */
void TestMapper(Checks& checks)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(RandomTorus(160000));
  Window window(150);
  window.Add(mapper);
  window.Renderer->ResetCamera();
  checks.Expect(mapper->GetTargetError() == Good, "default");
  const Picture best = window.Draw();
  checks.Expect(std::string(mapper->GetMethodUsed()) == "two-pass" && mapper->GetStride() == 1,
    "full quality draws all splats");
  for (const double error : { 1.0 / 32.0, Rough })
  {
    mapper->SetTargetError(error);
    checks.Expect(Difference(best, window.Draw()) < error && mapper->GetStride() == 1 &&
        std::string(mapper->GetChoices()).find("to measure what fewer would lose") != std::string::npos,
      "a frame to measure: " + std::string(mapper->GetChoices()));
    const double difference = Difference(best, window.Draw());
    std::cout << "every " << mapper->GetStride() << ". splat differs by " << difference
              << ", allowed: " << error << "\n";
    checks.AtLeast(mapper->GetStride(), 2, "stride");
    checks.AtMost(difference, error, "error of fewer splats");
    checks.AtLeast(difference, 1e-3, "difference that fewer splats make");
  }
  const std::string splats = "splats: one of " + std::to_string(mapper->GetStride()) + ", fewer";
  checks.Expect(std::string(mapper->GetChoices()).find("method: two-pass, ") == 0 &&
      std::string(mapper->GetChoices()).find(splats) != std::string::npos,
    "choices: " + std::string(mapper->GetChoices()));
  std::ostringstream text;
  mapper->Print(text);
  checks.Expect(text.str().find("TargetError: 0.0625") != std::string::npos &&
      text.str().find(splats) != std::string::npos,
    "PrintSelf tells");

  // While dragging with no time at all; then at rest.
  mapper->SetTargetError(Good);
  std::set<int> strides;
  auto drag = [&](double rate, int frames) {
    strides.clear();
    window.Win->SetDesiredUpdateRate(rate);
    for (int i = 0; i < frames; ++i)
    {
      window.Renderer->GetActiveCamera()->Azimuth(3);
      window.Win->Render();
      strides.insert(mapper->GetStride());
    }
  };
  // Where another process takes a processor's time for a moment, fewer splats do not seem to pay until the
  // next drag begins.
  drag(1e6, 6);
  for (int again = 0; again < 5 && mapper->GetStride() < 2; ++again)
  {
    drag(0.0001, 1);
    drag(1e6, 6);
  }
  checks.AtLeast(mapper->GetStride(), 2, "stride with no time");
  drag(0.0001, 3);
  checks.Expect(strides == std::set<int>{ 1 }, "at rest");
  drag(0.001, 6);
  checks.Expect(strides == std::set<int>{ 1 }, "dragging, with much time");
}
}

int TestSplatsChoices(int, char*[])
{
  Checks checks;
  TestTable(checks);
  TestRefused(checks);
  TestTolerances(checks);
  TestMeasured(checks);
  TestShadowSamples(checks);
  TestBudget(checks);
  TestMapper(checks);
  TestMeasuredLayers(checks);
  return checks.Result();
}
