// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSelection.h"

#include "vtkPointSplatHalfSpaces.h"
#include "vtkPointSplatLevelSelection.h"
#include "vtkPointSplatPatches.h"

#include "vtkPointSplatThreads.h"

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
      count += own.GetNumberOfInvocations() + own.GetNumberOfTriangles();
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
  if (item.IsSelectedByLevels())
  {
    return vtkPointSplatLevelSelection(view, item).Choose();
  }
  const vtkPointSplatHalfSpaces halves(view, item);
  const std::vector<vtkPointSplatBlocks::Box>& boxes = item.Cloud->GetBlocks().GetBoxes();
  std::vector<unsigned char> seen(boxes.size());
  const vtkPointSplatTriangles& triangles = item.Cloud->GetTriangles();
  auto sizeOf = [&triangles](size_t block) -> const vtkPointSplatTriangles::Extent& {
    return triangles.GetPatches()[block].Size;
  };
  auto isPatch = [&](size_t block) {
    return item.TrianglePixels > 0.0 && sizeOf(block).Edge > 0.0f;
  };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(boxes.size()), 256, [&](vtkIdType begin, vtkIdType end) {
    for (size_t block = static_cast<size_t>(begin); block < static_cast<size_t>(end); ++block)
    {
      vtkPointSplatBlocks::Box box = boxes[block];
      if (isPatch(block))
      {
        for (size_t k = 0; k < 3; ++k)
        {
          box.Low[k] = std::min(box.Low[k], sizeOf(block).Low[k]);
          box.High[k] = std::max(box.High[k], sizeOf(block).High[k]);
        }
      }
      seen[block] = !halves.IsOutside(box);
    }
  });
  auto list = std::make_shared<vtkPointSplatRuns>();
  vtkPointSplatPatches patches(view, item);
  for (size_t block = 0; block < boxes.size(); ++block)
  {
    if (seen[block] && isPatch(block) && patches.IsMagnified(sizeOf(block)))
    {
      patches.Take(static_cast<uint32_t>(block));
    }
    else if (seen[block])
    {
      list->Runs.push_back({ static_cast<uint32_t>(block * vtkPointSplatBlocks::Size),
        static_cast<uint32_t>(item.Cloud->GetBlocks().GetCount(block)) });
    }
  }
  patches.AddTo(*list);
  const bool all = list->Runs.size() == boxes.size() && list->Triangles.empty();
  return all && !item.IsStreamed ? nullptr : list;
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
