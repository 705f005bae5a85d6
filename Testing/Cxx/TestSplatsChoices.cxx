// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The automatic choices: a table of facts and what follows from them; how much surfaces crowd; a
// budget of time, with times that are made up; and that the mapper asks them.
#include "SplatScene.h"

#include "vtkPointSplatBudget.h"
#include "vtkPointSplatChoices.h"
#include "vtkPointSplatCrowding.h"

#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <sstream>

namespace
{
using namespace SplatScene;
using Facts = vtkPointSplatSceneFacts;
using Mapper = vtkPointSplatMapper;

/// A torus of 640,000 points in 512 x 512 pixels, at rest.
Facts Dense()
{
  Facts facts;
  facts.Splats = 640000;
  facts.Pixels = 512 * 512;
  facts.Covered = 180000;
  facts.SpacingPixels = 1.0;
  facts.Contours = 0.01;
  facts.Contrast = 0.6;
  facts.Depth = 1.4;
  return facts;
}

Facts Translucent(double splats, double depth, double spacing, double error)
{
  Facts facts = Dense();
  facts.Translucent = true;
  facts.Opacity = 0.5;
  facts.Contrast = 0.6;
  facts.Crowding = 0.0;
  facts.Splats = splats;
  facts.Depth = depth;
  facts.SpacingPixels = spacing;
  facts.TargetError = error;
  return facts;
}

void TestTable(Checks& checks)
{
  constexpr double Good = 1.0 / 256.0, Fair = 1.0 / 64.0, Rough = 1.0 / 16.0;
  struct Row
  {
    const char* What;
    std::function<Facts()> Make;
    int Method;
    int Transparency;
    int Layers;
    int FillSteps;
    bool Compute;
  };
  auto with = [](Facts facts, const std::function<void(Facts&)>& change) {
    return [=] {
      Facts changed = facts;
      change(changed);
      return changed;
    };
  };
  const Facts dense = Dense();
  const int two = Mapper::TWO_PASS, deferred = Mapper::DEFERRED, image = Mapper::IMAGE_SPACE;
  const int peel = Mapper::PEELING, sort = Mapper::SORTED, exact = Mapper::NEAREST_EXACT;
  const Row table[] = {
    { "full quality", with(dense, [](Facts&) {}), two, peel, 1, 0, true },
    { "dense, 1/64", with(dense, [](Facts& f) { f.TargetError = Fair; }), image, peel, 1, 1, true },
    { "sparse, 1/64",
      with(dense,
        [](Facts& f) {
          f.TargetError = Fair;
          f.SpacingPixels = 4.0;
        }),
      two, peel, 1, 0, true },
    { "sparse, 1/16",
      with(dense,
        [](Facts& f) {
          f.TargetError = Rough;
          f.SpacingPixels = 5.0;
        }),
      image, peel, 1, 2, true },
    { "as many points of many small bodies, 1/64: outlines",
      with(dense,
        [](Facts& f) {
          f.TargetError = Fair;
          f.Contours = 0.05;
        }),
      two, peel, 1, 0, true },
    { "in black and white, 1/64",
      with(dense,
        [](Facts& f) {
          f.TargetError = Fair;
          f.Contrast = 1.0;
        }),
      two, peel, 1, 0, true },
    { "too sparse for image space",
      with(dense,
        [](Facts& f) {
          f.TargetError = 1.0;
          f.SpacingPixels = 8.5;
        }),
      two, peel, 1, 0, true },
    { "small in the window, 1/64: all silhouettes",
      with(dense,
        [](Facts& f) {
          f.TargetError = Fair;
          f.Covered = 5000;
        }),
      two, peel, 1, 0, true },
    { "spacing not known",
      with(dense,
        [](Facts& f) {
          f.TargetError = Rough;
          f.SpacingPixels = 0.0;
        }),
      two, peel, 1, 0, true },
    { "two passes by hand",
      with(dense,
        [](Facts& f) {
          f.TargetError = Rough;
          f.AllAutomatic = false;
        }),
      two, peel, 1, 0, true },
    { "image space by hand, in full quality",
      with(dense,
        [](Facts& f) {
          f.AllAutomatic = false;
          f.AsksPoints = true;
          f.SpacingPixels = 1.3;
        }),
      two, peel, 1, 2, true },
    { "image space by hand, denser than pixels",
      with(dense,
        [](Facts& f) {
          f.AllAutomatic = false;
          f.AsksPoints = true;
          f.SpacingPixels = 0.5;
        }),
      two, peel, 1, 1, true },
    { "quads by hand, many splats, full quality",
      with(dense,
        [](Facts& f) {
          f.AsksQuads = true;
          f.SpacingPixels = 1.7;
        }),
      two, peel, 1, 0, false },
    { "quads by hand, many splats, 1/64",
      with(dense,
        [](Facts& f) {
          f.AsksQuads = true;
          f.SpacingPixels = 1.7;
          f.TargetError = Fair;
        }),
      deferred, peel, 1, 0, false },
    { "quads, several splats in a pixel: groups lose some",
      with(dense,
        [](Facts& f) {
          f.AsksQuads = true;
          f.SpacingPixels = 0.8;
          f.Covered = 5000;
          f.TargetError = Fair;
        }),
      two, peel, 1, 0, false },
    { "no compute shaders, few splats",
      with(dense,
        [](Facts& f) {
          f.Compute = false;
          f.SpacingPixels = 4.0;
          f.Splats = 40000;
        }),
      two, peel, 1, 0, false },
    { "no compute shaders, image space",
      with(dense,
        [](Facts& f) {
          f.Compute = false;
          f.TargetError = Fair;
        }),
      image, peel, 1, 1, false },
    { "groups do not fit",
      with(dense,
        [](Facts& f) {
          f.AsksQuads = true;
          f.SpacingPixels = 1.7;
          f.TargetError = Fair;
          f.Groups = 12;
          f.GroupsFit = false;
        }),
      two, peel, 1, 0, false },
    { "deferred by hand",
      with(dense,
        [](Facts& f) {
          f.AllAutomatic = false;
          f.AsksDeferred = true;
        }),
      deferred, peel, 1, 0, false },
    { "translucent, full quality",
      with(Translucent(80000, 6, 4.5, Good), [](Facts&) {}), two, peel, 32, 0, true },
    { "translucent, dense, 1/16",
      with(Translucent(640000, 3, 1.2, Rough), [](Facts&) {}), image, peel, 32, 2, true },
    { "the same, black and white, 1/32: silhouettes",
      with(Translucent(640000, 3, 1.2, 1.0 / 32.0), [](Facts& f) { f.Contrast = 1.0; }), two, peel, 32,
      0, true },
    { "the same, but layers merge, 1/16",
      with(Translucent(640000, 3, 1.2, Rough), [](Facts& f) { f.Crowding = 1.0; }), two, peel, 32, 0,
      true },
    { "translucent, many layers of few splats, 1/16",
      with(Translucent(80000, 6, 4.5, Rough), [](Facts&) {}), two, sort, 0, 0, true },
    { "the same, refracting, which magnifies errors",
      with(Translucent(80000, 6, 1.0, Rough), [](Facts& f) { f.Refracts = true; }), two, peel, 32, 0,
      true },
    { "the same, refracting, sorted by hand: the nearest layer is needed",
      with(Translucent(80000, 6, 4.5, Rough),
        [](Facts& f) {
          f.Refracts = true;
          f.Transparency = Mapper::SORTED;
        }),
      two, sort, 1, 0, true },
    { "the same, 1/32", with(Translucent(80000, 6, 4.5, 1.0 / 32.0), [](Facts&) {}), two, sort, 0, 0,
      true },
    { "the same, 1/64: the nearest layer exact",
      with(Translucent(80000, 6, 4.5, Fair), [](Facts&) {}), two, exact, 1, 0, true },
    { "the same, but black and white",
      with(Translucent(80000, 6, 4.5, Fair), [](Facts& f) { f.Contrast = 1.0; }), two, peel, 32, 0,
      true },
    { "the same, several splats to a pixel",
      with(Translucent(80000, 6, 2.0, Fair), [](Facts&) {}), two, peel, 32, 0, true },
    { "the same, but some surfaces crowd",
      with(Translucent(80000, 6, 4.5, Fair), [](Facts& f) { f.Crowding = 0.1; }), two, peel, 32, 0,
      true },
    { "the same, few surfaces",
      with(Translucent(80000, 2.5, 4.5, Fair), [](Facts&) {}), two, peel, 32, 0, true },
    { "the same, hardly to be seen",
      with(Translucent(80000, 6, 4.5, Fair), [](Facts& f) { f.Opacity = 0.03; }), two, sort, 0, 0,
      true },
    { "surfaces that all but touch, 1/16",
      with(Translucent(80000, 6, 10.0, Rough),
        [](Facts& f) {
          f.Crowding = 0.5;
          f.Contrast = 0.8;
        }),
      two, peel, 32, 0, true },
    { "the same, 1/8",
      with(Translucent(80000, 6, 10.0, 1.0 / 8.0),
        [](Facts& f) {
          f.Crowding = 0.5;
          f.Contrast = 0.8;
        }),
      two, sort, 0, 0, true },
    { "the same, nothing known of it, 1/16",
      with(Translucent(80000, 6, 10.0, Rough),
        [](Facts& f) { f.Opacity = f.Contrast = f.Crowding = Facts().Crowding; }),
      two, peel, 32, 0, true },
    { "the same, 1/16, among other translucent props",
      with(Translucent(80000, 6, 10.0, Rough), [](Facts& f) { f.Sortable = false; }), two, peel, 32,
      0, true },
    { "the same, peeling by hand",
      with(Translucent(80000, 6, 10.0, Rough), [](Facts& f) { f.Transparency = Mapper::PEELING; }),
      two, peel, 32, 0, true },
    { "sorting by hand, in full quality",
      with(Translucent(80000, 2, 4.5, Good), [](Facts& f) { f.Transparency = Mapper::SORTED; }),
      two, sort, 0, 0, true },
    { "sorting by hand and image space by hand",
      with(Translucent(80000, 2, 4.5, Good),
        [](Facts& f) {
          f.Transparency = Mapper::SORTED;
          f.AllAutomatic = false;
          f.AsksPoints = true;
        }),
      two, peel, 32, 2, true },
    { "one sheet is not worth sorting",
      with(Translucent(80000, 1, 10.0, Rough), [](Facts&) {}), two, peel, 32, 0, true },
  };
  for (const Row& row : table)
  {
    const vtkPointSplatChoice choice = vtkPointSplatChoices::Make(row.Make());
    checks.Expect(choice.Method == row.Method && choice.Transparency == row.Transparency &&
        choice.MaximumLayers == row.Layers && choice.FillSteps == row.FillSteps &&
        choice.Compute == row.Compute,
      std::string(row.What) + ": method " + std::to_string(choice.Method) + ", transparency " +
        std::to_string(choice.Transparency) + ", layers " + std::to_string(choice.MaximumLayers) +
        ", fill steps " + std::to_string(choice.FillSteps) + ", compute " +
        std::to_string(choice.Compute));
    checks.Expect(!choice.MethodReason.empty() && !choice.ProjectionReason.empty() &&
        !choice.TransparencyReason.empty() && !choice.LayersReason.empty() &&
        !choice.FillReason.empty(),
      std::string(row.What) + ": a reason is missing");
    checks.Expect(choice.IsLike(vtkPointSplatChoices::Make(row.Make())),
      std::string(row.What) + ": chosen otherwise the second time");
  }
  const vtkPointSplatChoice refused = vtkPointSplatChoices::Make(with(dense, [](Facts& f) {
    f.AllAutomatic = false;
    f.AsksDeferred = true;
    f.Groups = 12;
    f.GroupsFit = false;
  })());
  checks.Expect(refused.Refused && refused.Method == two &&
      refused.MethodReason.find("MaximumImageMemory") != std::string::npos,
    "deferred blending that does not fit: " + refused.MethodReason);
  checks.Expect(vtkPointSplatChoices::Make(Translucent(1e5, 2, 3, Good)).LeastContribution == Good &&
      vtkPointSplatChoices::Make(Translucent(1e5, 2, 9, Rough)).LeastContribution == Rough,
    "peeling ends at the target error");
}

void TestShadowSamples(Checks& checks)
{
  auto samples = [](int wanted, bool interacting, double error, double light = 1.0 / 3.0) {
    std::string reason;
    return vtkPointSplatChoices::ShadowSamples(wanted, 1, interacting, error, light, reason);
  };
  checks.Expect(samples(1000, false, 1.0 / 256.0) == 1000, "full quality takes all samples");
  checks.Expect(samples(16, false, 1.0 / 64.0) == 2, "samples for 1/64");
  checks.Expect(samples(16, false, 1.0 / 128.0) == 7, "samples for 1/128");
  checks.Expect(samples(16, false, 1.0 / 64.0, 1.0) == 15, "samples for 1/64 on white");
  checks.Expect(samples(16, false, 1.0 / 64.0, 2.0) == 16, "samples for 1/64 in glaring light");
  checks.Expect(samples(16, false, 1.0 / 64.0, 0.0) == 1, "samples for 1/64 on black");
  checks.Expect(samples(4, false, 1.0 / 128.0) == 4, "no more than were asked for");
  checks.Expect(samples(16, false, 1.0 / 16.0) == 1, "samples for 1/16");
  checks.Expect(samples(16, true, 1.0 / 256.0) == 1, "samples while dragging");
}

/// A plane of points 1 apart at a height, its normals up or down, as vtkPointSplatCloud packs them.
std::vector<uint32_t> Sheet(float height, bool up, int side = 60)
{
  std::vector<uint32_t> words;
  for (int i = 0; i < side * side; ++i)
  {
    const float splat[4] = { static_cast<float>(i % side), static_cast<float>(i / side), height,
      1.0f };
    const size_t at = words.size();
    words.resize(at + 8, 0u);
    std::memcpy(&words[at], splat, sizeof(splat));
    words[at + 5] = up ? 0u : 0x7fff7fffu;
    words[at + 7] = static_cast<uint32_t>(i);
  }
  return words;
}

void TestCrowding(Checks& checks)
{
  const glm::dmat4 here(1.0);
  auto share = [&](const std::vector<std::vector<uint32_t>>& sheets, double spacing = 1.0) {
    std::vector<vtkPointSplatCrowding::Cloud> clouds;
    for (const std::vector<uint32_t>& sheet : sheets)
    {
      clouds.push_back({ &sheet, 8, here });
    }
    return vtkPointSplatCrowding::Share(clouds, spacing);
  };
  auto together = [](std::vector<uint32_t> a, const std::vector<uint32_t>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  checks.Expect(share({ Sheet(0.3f, true) }) == 0.0, "one sheet does not crowd");
  checks.Expect(share({ Sheet(0.3f, true), Sheet(3.0f, true) }) == 0.0, "two sheets far apart");
  checks.Expect(share({ Sheet(0.3f, true), Sheet(0.6f, true) }) == 1.0, "two close together");
  checks.Expect(share({ Sheet(0.3f, true), Sheet(0.6f, true), Sheet(9.0f, true) }) > 0.6 &&
      share({ Sheet(0.3f, true), Sheet(0.6f, true), Sheet(9.0f, true) }) < 0.7,
    "two of three close together");
  checks.Expect(share({ together(Sheet(0.3f, true), Sheet(0.35f, true)) }) == 0.0,
    "one rough sheet does not crowd");
  checks.Expect(share({ together(Sheet(0.1f, true), Sheet(1.0f, true)) }) == 1.0,
    "two sheets of one cloud");
  checks.Expect(share({ together(Sheet(0.3f, true), Sheet(0.35f, false)) }) == 1.0,
    "two sides of one cloud's wall");
  const std::vector<std::vector<uint32_t>> large = { Sheet(0.3f, true, 400),
    Sheet(0.6f, true, 400), Sheet(9.0f, true, 400) };
  checks.AtMost(std::abs(share(large) - 2.0 / 3.0), 0.03, "drawn by lot");
  checks.Expect(share(large) == share(large), "the same each time");
  // The sheets in other places: one turned over and pushed away, both far from the origin.
  const std::vector<uint32_t> a = Sheet(0.3f, true), b = Sheet(0.6f, true);
  const glm::dmat4 far = glm::translate(here, glm::dvec3(4e5, 5e6, 0.0));
  checks.Expect(vtkPointSplatCrowding::Share(
                  { { &a, 8, far }, { &b, 8, glm::translate(far, glm::dvec3(0, 0, 5)) } }, 1.0) == 0.0 &&
      vtkPointSplatCrowding::Share({ { &a, 8, far }, { &b, 8, far } }, 1.0) == 1.0,
    "matrices count");
  checks.Expect(share({}) == 0.0 && share({ {} }) == 0.0 && share({ a }, 0.0) == 1.0 &&
      share({ a }, std::nan("")) == 1.0,
    "nothing, and no spacing");
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
  Facts facts = Dense();
  facts.SpacingPixels = 3.0;
  const std::vector<vtkPointSplatChoice> ladder = vtkPointSplatChoices::Ladder(facts);
  checks.Expect(ladder.size() >= 2 && ladder.front().Method == Mapper::TWO_PASS &&
      ladder.back().Method == Mapper::IMAGE_SPACE,
    "a ladder from two passes to image space");
  for (size_t i = 1; i < ladder.size(); ++i)
  {
    checks.Expect(!ladder[i].IsLike(ladder[i - 1]) && ladder[i].Tolerance > ladder[i - 1].Tolerance,
      "each rung does other work, for a greater error");
  }
  const std::vector<vtkPointSplatChoice> peeled =
    vtkPointSplatChoices::Ladder(Translucent(80000, 6, 4.5, 1.0 / 256.0));
  for (size_t i = 1; i + 1 < peeled.size(); ++i)
  {
    checks.Expect(peeled[i].Method != peeled[i - 1].Method ||
        peeled[i].Transparency != peeled[i - 1].Transparency ||
        peeled[i].FillSteps != peeled[i - 1].FillSteps,
      "no rung but the last only for where peeling ends");
  }
  checks.Expect(peeled.size() >= 2, "a ladder from peeling");

  const auto by = [](double two, double image) {
    return [=](const vtkPointSplatChoice& choice, int) {
      return choice.Method == Mapper::TWO_PASS ? two : image;
    };
  };

  Machine fast{ by(0.05, 0.01) };
  Machine slow{ by(0.3, 0.05) };
  Machine slower{ by(3.0, 1.0) };
  // Image space just fits; two passes just do not.
  Machine noisy{ [](const vtkPointSplatChoice& choice, int frame) {
    const double noise = 1.0 + 0.25 * std::sin(12.9898 * frame);
    return noise * (choice.Method == Mapper::TWO_PASS ? 0.065 : 0.03);
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
}

/**
 * That the mapper draws what is chosen, says so, and is at its best at rest.
 */
void TestMapper(Checks& checks)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(RandomTorus(40000));
  Window window(150);
  window.Add(mapper);
  window.Renderer->ResetCamera();
  checks.Expect(mapper->GetTargetError() == 1.0 / 256.0, "default");
  const Picture best = window.Draw();
  checks.Expect(std::string(mapper->GetMethodUsed()) == "two-pass", "full quality");
  mapper->SetTargetError(1.0 / 16.0);
  const Picture rough = window.Draw();
  checks.Expect(std::string(mapper->GetMethodUsed()) == "image-space", "1/16");
  checks.Expect(std::string(mapper->GetChoices()).find("method: image-space, points") == 0,
    "choices: " + std::string(mapper->GetChoices()));
  double sum = 0.0;
  long count = 0;
  for (int y = 0; y < best.Height; ++y)
  {
    for (int x = 0; x < best.Width; ++x)
    {
      for (int c = 0; c < 3 && (!best.IsBackground(x, y) || !rough.IsBackground(x, y)); ++c)
      {
        sum += std::pow((double(best.At(x, y)[c]) - rough.At(x, y)[c]) / 255.0, 2);
        ++count;
      }
    }
  }
  std::cout << "image space differs by " << std::sqrt(sum / count) << "\n";
  checks.AtMost(std::sqrt(sum / count), 1.0 / 16.0, "error of image space");
  std::ostringstream text;
  mapper->Print(text);
  checks.Expect(text.str().find("TargetError: 0.0625") != std::string::npos &&
      text.str().find("method: image-space, points") != std::string::npos,
    "PrintSelf tells");

  // While dragging with no time at all; then at rest.
  mapper->SetTargetError(1.0 / 256.0);
  std::set<std::string> used;
  auto drag = [&](double rate, int frames) {
    used.clear();
    window.Win->SetDesiredUpdateRate(rate);
    for (int i = 0; i < frames; ++i)
    {
      window.Renderer->GetActiveCamera()->Azimuth(3);
      window.Win->Render();
      used.insert(mapper->GetMethodUsed());
    }
  };
  drag(1e6, 6);
  checks.Expect(std::string(mapper->GetMethodUsed()) == "image-space", "no time");
  drag(1e6, 6);
  checks.Expect(used == std::set<std::string>{ "image-space" }, "no time, going on");
  mapper->SetMethodToTwoPass();
  drag(1e6, 6);
  checks.Expect(used == std::set<std::string>{ "two-pass" }, "what was asked for by hand stays");
  mapper->SetMethodToAutomatic();
  drag(0.0001, 3);
  checks.Expect(used == std::set<std::string>{ "two-pass" }, "at rest");
  drag(0.001, 6);
  checks.Expect(used == std::set<std::string>{ "two-pass" }, "dragging, with much time");
}
}

int TestSplatsChoices(int, char*[])
{
  Checks checks;
  TestTable(checks);
  TestShadowSamples(checks);
  TestCrowding(checks);
  TestBudget(checks);
  TestMapper(checks);
  return checks.Result();
}
