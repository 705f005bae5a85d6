// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection of splats returns the ids that the input's points have.
#include "SplatScene.h"

#include "vtkCellArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace SplatScene;

constexpr int Side = 12; // points in a row
constexpr int Lost = 5;  // points with NaN before the others

/**
 * A square of points in the plane z = 0, after some that cannot be drawn.
 */
vtkSmartPointer<vtkPolyData> Square(double offset)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < Lost; ++i)
  {
    points->InsertNextPoint(NAN, 0.0, 0.0);
    normals->InsertNextTuple3(0, 0, 1);
  }
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      points->InsertNextPoint(x + offset, y, 0.0);
      normals->InsertNextTuple3(0, 0, 1);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkCellArray> verts;
  // The other way about, so that cell ids are not point ids.
  for (vtkIdType i = data->GetNumberOfPoints() - 1; i >= 0; --i)
  {
    verts->InsertNextCell(1, &i);
  }
  data->SetVerts(verts);
  return data;
}

struct Hit
{
  vtkProp* Prop = nullptr;
  unsigned int Composite = 0;
  std::set<vtkIdType> Ids;
};

Hit Pick(Window& window, int association, double wx, double wy)
{
  window.Renderer->SetWorldPoint(wx, wy, 0.0, 1.0);
  window.Renderer->WorldToDisplay();
  const double* d = window.Renderer->GetDisplayPoint();
  const int x = static_cast<int>(d[0]);
  const int y = static_cast<int>(d[1]);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(x, y, x, y);
  selector->SetFieldAssociation(association);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  Hit hit;
  if (selection && selection->GetNumberOfNodes() > 0)
  {
    vtkSelectionNode* node = selection->GetNode(0);
    hit.Prop = vtkProp::SafeDownCast(
      node->GetProperties()->Get(vtkSelectionNode::PROP()));
    hit.Composite = static_cast<unsigned int>(
      node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()));
    auto ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      hit.Ids.insert(ids->GetValue(i));
    }
  }
  return hit;
}

void PickOne(Checks& checks, bool quads)
{
  const std::string kind = quads ? "quads: " : "automatic: ";
  Window window;
  vtkNew<vtkPointSplatMapper> mappers[2];
  vtkActor* actors[2];
  for (int a = 0; a < 2; ++a)
  {
    mappers[a]->SetInputData(Square(a * (Side + 2.0)));
    if (quads)
    {
      mappers[a]->SetProjectionToQuads();
    }
    actors[a] = window.Add(mappers[a]);
  }
  window.Renderer->ResetCamera();
  window.Draw();
  for (int y = 1; y < Side; y += 5)
  {
    for (int x = 0; x < Side; x += 4)
    {
      for (int a = 0; a < 2; ++a)
      {
        const double wx = x + a * (Side + 2.0) + 0.2;
        const vtkIdType id = Lost + y * Side + x;
        const std::string where = kind + "point " + std::to_string(id);
        Hit hit = Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, wx, y - 0.2);
        checks.Expect(hit.Prop == actors[a], where + ": wrong actor");
        checks.Expect(hit.Ids == std::set<vtkIdType>{ id },
          where + ": got " +
            (hit.Ids.empty() ? std::string("none") : std::to_string(*hit.Ids.begin())));
        hit = Pick(window, vtkDataObject::FIELD_ASSOCIATION_CELLS, wx, y - 0.2);
        const vtkIdType cell = Lost + Side * Side - 1 - id;
        checks.Expect(hit.Ids == std::set<vtkIdType>{ cell },
          where + ": cell is " + std::to_string(cell) + ", got " +
            (hit.Ids.empty() ? std::string("none") : std::to_string(*hit.Ids.begin())));
      }
    }
  }
  const Hit miss = Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, 6.0, 14.0);
  checks.Expect(miss.Ids.empty(), kind + "a pick of the background found something");
}

void PickBlocks(Checks& checks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Square(0.0));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, Square(Side + 2.0));
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputDataObject(blocks);
  Window window;
  window.Add(mapper);
  window.Renderer->ResetCamera();
  window.Draw();
  const vtkIdType id = Lost + 3 * Side + 4;
  for (int b = 0; b < 2; ++b)
  {
    const Hit hit =
      Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, 4.0 + b * (Side + 2.0), 3.0);
    checks.Expect(hit.Ids == std::set<vtkIdType>{ id }, "blocks: the id counts within its block");
    // The root is 0, its blocks 1, 2, 3.
    checks.Expect(hit.Composite == (b == 0 ? 1u : 3u),
      "blocks: composite index is " + std::to_string(hit.Composite));
  }

  // Blocks that share all of their points, as those of a mesh cut up share some: the id is that of
  // the point in the block that was picked, not in the other one.
  vtkSmartPointer<vtkPolyData> turned = Square(0.0);
  const vtkIdType last = turned->GetNumberOfPoints() - 1;
  for (vtkIdType i = Lost; i <= last; ++i)
  {
    turned->GetPoints()->SetPoint(i, Square(0.0)->GetPoint(last + Lost - i));
  }
  for (int first = 0; first < 2; ++first)
  {
    blocks->SetBlock(0, first == 0 ? turned.Get() : Square(0.0).Get());
    blocks->SetBlock(2, first == 0 ? Square(0.0).Get() : turned.Get());
    window.Draw();
    const Hit hit = Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, 4.0, 3.0);
    const bool isTurned = hit.Composite == (first == 0 ? 1u : 3u);
    checks.Expect(hit.Ids == std::set<vtkIdType>{ isTurned ? last + Lost - id : id },
      "shared points: block " + std::to_string(hit.Composite) + ", id " +
        (hit.Ids.empty() ? std::string("none") : std::to_string(*hit.Ids.begin())));
  }
}

/// At how many pixels points or cells are found.
int CountFound(Window& window, int association)
{
  const int* size = window.Renderer->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
  selector->SetFieldAssociation(association);
  selector->CaptureBuffers();
  int found = 0;
  for (unsigned int i = 0; i < static_cast<unsigned int>(size[0] * size[1]); ++i)
  {
    const unsigned int pixel[2] = { i % size[0], i / size[0] };
    found += selector->GetPixelInformation(pixel).Valid ? 1 : 0;
  }
  return found;
}

/// Before points are selected VTK draws a frame and keeps its depth: what it has at outlines is not
/// to hide what is selected there. Cells are selected without one.
void PickOutline(Checks& checks, int balls)
{
  Window window;
  window.SmoothOutlines = true;
  std::vector<vtkSmartPointer<vtkPointSplatMapper>> mappers;
  for (int ball = 0; ball < balls; ++ball)
  {
    mappers.emplace_back(vtkSmartPointer<vtkPointSplatMapper>::New());
    mappers[ball]->SetInputData(RandomSphere(20000));
    vtkActor* actor = window.Add(mappers[ball]);
    actor->SetScale(1.0 - 0.3 * ball);
    actor->SetPosition(0.4 * ball, 0.1 * ball, 1.5 * ball);
  }
  window.Renderer->ResetCamera();
  window.Draw();
  const int points = CountFound(window, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  const int cells = CountFound(window, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  checks.Expect(points > 1000 && points == cells,
    "of " + std::to_string(balls) + " balls points are found at " + std::to_string(points) +
      " pixels, cells at " + std::to_string(cells));
}
}

int TestSplatsPicking(int, char*[])
{
  // The lost points are reported, as they should be.
  vtkObject::GlobalWarningDisplayOff();
  Checks checks;
  PickOne(checks, false);
  PickOne(checks, true);
  PickBlocks(checks);
  PickOutline(checks, 1);
  PickOutline(checks, 2);
  return checks.Result();
}
