// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSelection.h"

#include "vtkPointSplatHalfSpaces.h"
#include "vtkPointSplatLevelSelection.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
// Parts of a window are not smaller than this.
constexpr int LeastPart = 32;

void Divide(const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  const glm::ivec4& window, vtkIdType capacity, std::vector<vtkPointSplatPart>& parts)
{
  vtkPointSplatPart part{ window, {} };
  vtkIdType count = 0;
  for (const vtkPointSplatItem& item : items)
  {
    part.Items.push_back(item);
    vtkPointSplatItem& own = part.Items.back();
    own.Window = glm::ivec4(glm::max(glm::ivec2(window), glm::ivec2(own.Window)),
      glm::min(glm::ivec2(window.z, window.w), glm::ivec2(own.Window.z, own.Window.w)));
    if (own.IsInView())
    {
      own.Runs = vtkPointSplatSelection::Runs(view, own);
      count += own.GetNumberOfInvocations();
    }
  }
  const glm::ivec2 size(window.z - window.x + 1, window.w - window.y + 1);
  if (count <= capacity || std::max(size.x, size.y) <= LeastPart)
  {
    parts.push_back(std::move(part));
    return;
  }
  // In the middle, at a multiple of all tiles' sizes.
  const int side = size.x >= size.y ? 0 : 1;
  const int middle = (window[side] + size[side] / 2) / LeastPart * LeastPart;
  const int cut = std::max(middle, window[side] + 1);
  glm::ivec4 first = window;
  glm::ivec4 second = window;
  first[side + 2] = cut - 1;
  second[side] = cut;
  Divide(view, items, first, capacity, parts);
  Divide(view, items, second, capacity, parts);
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkPointSplatRuns> vtkPointSplatSelection::Runs(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
{
  if (item.Levels.Pixels > 0.0)
  {
    return vtkPointSplatLevelSelection(view, item).Choose();
  }
  const vtkPointSplatHalfSpaces halves(view, item);
  const std::vector<vtkPointSplatBlocks::Box>& boxes = item.Cloud->GetBlocks().GetBoxes();
  std::vector<unsigned char> seen(boxes.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()), 256, [&](vtkIdType begin, vtkIdType end) {
    for (size_t block = static_cast<size_t>(begin); block < static_cast<size_t>(end); ++block)
    {
      seen[block] = !halves.IsOutside(boxes[block]);
    }
  });
  auto list = std::make_shared<vtkPointSplatRuns>();
  for (size_t block = 0; block < boxes.size(); ++block)
  {
    if (seen[block])
    {
      list->Runs.push_back({ static_cast<uint32_t>(block * vtkPointSplatBlocks::Size),
        static_cast<uint32_t>(item.Cloud->GetBlocks().GetCount(block)) });
    }
  }
  return list->Runs.size() == boxes.size() ? nullptr : list;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatPart> vtkPointSplatSelection::Divide(
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  const glm::ivec4& window, vtkIdType capacity)
{
  std::vector<vtkPointSplatPart> parts;
  ::Divide(view, items, window, capacity, parts);
  return parts;
}
