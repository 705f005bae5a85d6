// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Group-sorted transparency: against peeled layers, and with groups that the input brings.
#include "SplatScene.h"

#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatGrouping.h"

namespace
{
using namespace SplatScene;

struct Shell
{
  double Radius;
  double Rgb[3];
  double Opacity;
};
const Shell Nested[] = { { 1.0, { 0.2, 0.4, 0.9 }, 0.3 }, { 0.7, { 0.2, 0.8, 0.3 }, 0.5 },
  { 0.4, { 0.9, 0.6, 0.2 }, 1.0 } };

/**
 * Group-sorted layers, all or all but the nearest, against peeled ones; lit, so that smoothing
 * within a layer counts.
 */
void TestSorted(Checks& checks)
{
  for (const bool quads : { false, true })
  {
    Window window;
    window.Renderer->SetBackground(0.1, 0.2, 0.4);
    std::vector<vtkSmartPointer<vtkPointSplatMapper>> mappers;
    for (const Shell& shell : Nested)
    {
      auto mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
      mapper->SetInputData(RandomTorus(30000, 0.5 * shell.Radius));
      mapper->SetProjection(quads ? vtkPointSplatMapper::QUADS : 0);
      vtkActor* actor = window.Add(mapper);
      actor->GetProperty()->SetColor(shell.Rgb[0], shell.Rgb[1], shell.Rgb[2]);
      actor->GetProperty()->SetOpacity(shell.Opacity);
      mappers.push_back(mapper);
    }
    window.Renderer->ResetCamera();
    window.Renderer->GetActiveCamera()->Elevation(50);
    window.Renderer->ResetCameraClippingRange();
    const Picture peeled = window.Draw();
    auto used = [&]() { return std::string(mappers[0]->GetTransparencyUsed()); };
    checks.Expect(used() == "peeling", "automatic transparency peels");
    mappers[0]->SetTransparencyToSorted();
    const Picture sorted = window.Draw();
    checks.Expect(used() == "sorted", "sorted transparency, not " + used());
    mappers[0]->SetTransparencyToNearestExact();
    const Picture nearest = window.Draw();
    checks.Expect(used() == "nearest-exact", "the nearest layer exact, not " + used());
    checks.AtLeast(PsnrOfAll(peeled, sorted), 30.0, "sorted, against peeled");
    checks.AtLeast(
      PsnrOfAll(peeled, nearest), PsnrOfAll(peeled, sorted) + 1.0, "nearest exact, against sorted");

    // Among other translucent props, layers are peeled whatever is asked for.
    vtkNew<vtkPolyDataMapper> mesh;
    mesh->SetInputData(MakeSphereMesh());
    vtkActor* actor = window.Add(mesh);
    actor->GetProperty()->SetOpacity(0.5);
    window.Draw();
    checks.Expect(used() == "peeling", "peeled among translucent meshes, not " + used());
  }
}

/**
 * Groups that the input brings are taken for sorted transparency where they cover the surface, and
 * not where they were made for deferred blending: splats that do not overlap leave it bare.
 */
void TestGivenGroups(Checks& checks)
{
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(RandomTorus(20000));
  vtkNew<vtkPointSplatGrouping> grouping;
  grouping->SetInputConnection(estimation->GetOutputPort());
  grouping->SetReach(1.0);
  int groups = 0;
  auto draw = [&](vtkAlgorithm* source, int transparency) {
    Window window;
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->ScalarVisibilityOff();
    mapper->SetTransparency(transparency);
    window.Add(mapper)->GetProperty()->SetOpacity(0.5);
    window.Renderer->ResetCamera();
    const Picture picture = window.Draw();
    groups = mapper->GetNumberOfGroups();
    return picture;
  };
  const Picture peeled = draw(estimation, vtkPointSplatMapper::PEELING);
  const Picture sorted = draw(estimation, vtkPointSplatMapper::SORTED);
  const int made = groups;
  checks.AtLeast(PsnrOfAll(peeled, sorted), 30.0, "groups that are made, against peeled");

  const Picture asIs = draw(grouping, vtkPointSplatMapper::SORTED);
  checks.Expect(groups == made && grouping->GetNumberOfGroups() != made,
    "groups without coverage are not taken");
  checks.AtMost(LargestDifference(asIs, sorted), 0, "groups without coverage change nothing");

  grouping->SetColoringToWeighted();
  grouping->SetWantedNumberOfGroups(made + 2);
  grouping->SetMaximumClipped(0.9);
  for (const int coverage : { vtkPointSplatGrouping::Duplicate, vtkPointSplatGrouping::Enlarge })
  {
    const std::string what =
      coverage == vtkPointSplatGrouping::Enlarge ? "enlarged groups" : "filled groups";
    grouping->SetCoverage(coverage);
    const Picture covering = draw(grouping, vtkPointSplatMapper::SORTED);
    checks.Expect(groups == grouping->GetNumberOfGroups() && groups == made + 2,
      what + " that cover the surface are taken");
    checks.AtLeast(PsnrOfAll(peeled, covering), 30.0, what + ", against peeled");
  }
  // What covers the surface with kernels of 1.5 radii does not with disks.
  grouping->SetReach(1.5);
  draw(grouping, vtkPointSplatMapper::SORTED);
  checks.Expect(groups == made, "groups that cover by their kernels alone are not taken");
}

/**
 * Groups that are made are enlarged by no more than it takes: splats that are twice as large as need
 * be grow less, so that they blur no more.
 */
void TestEnlarged(Checks& checks)
{
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(RandomTorus(20000));
  estimation->Update();
  vtkPolyData* cloud = estimation->GetOutput();
  vtkDataArray* radii = cloud->GetPointData()->GetArray("SplatRadius");
  for (vtkIdType i = 0; i < radii->GetNumberOfTuples(); ++i)
  {
    radii->SetComponent(i, 0, 2.0 * radii->GetComponent(i, 0));
  }
  radii->Modified();
  Picture pictures[3];
  for (int way = 0; way < 3; ++way)
  {
    vtkNew<vtkPointSplatGrouping> grouping;
    grouping->SetInputData(cloud);
    grouping->SetReach(1.0);
    grouping->SetColoringToWeighted();
    grouping->SetWantedNumberOfGroups(4);
    grouping->SetCoverageToEnlarge();
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(cloud);
    if (way == 2)
    {
      mapper->SetInputConnection(grouping->GetOutputPort());
    }
    mapper->ScalarVisibilityOff();
    mapper->SetTransparency(way == 0 ? vtkPointSplatMapper::PEELING : vtkPointSplatMapper::SORTED);
    Window window;
    window.Add(mapper)->GetProperty()->SetOpacity(0.5);
    window.Renderer->ResetCamera();
    pictures[way] = window.Draw();
    if (way == 2)
    {
      checks.AtMost(grouping->GetGroupRadiusScale(0), 1.5, "by how much large splats grow");
    }
  }
  const double made = PsnrOfAll(pictures[0], pictures[1]);
  const double given = PsnrOfAll(pictures[0], pictures[2]);
  checks.AtLeast(made, 30.0, "enlarged groups of large splats, against peeled");
  checks.AtMost(std::abs(made - given), 1.0, "groups that are made, against those of the filter");
}
}

int TestSplatsSorted(int, char*[])
{
  Checks checks;
  TestSorted(checks);
  TestGivenGroups(checks);
  TestEnlarged(checks);
  return checks.Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
