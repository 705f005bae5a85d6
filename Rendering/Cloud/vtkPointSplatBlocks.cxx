// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBlocks.h"

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cstring>

//------------------------------------------------------------------------------
void vtkPointSplatBlocks::Make(
  const std::vector<uint32_t>& splats, size_t words, vtkIdType count)
{
  this->Count = count;
  const vtkIdType blocks = (count + Size - 1) / Size;
  this->Boxes.resize(static_cast<size_t>(blocks));
  vtkPointSplatThreads::For(0, blocks, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType block = begin; block < end; ++block)
    {
      Box box{ { { VTK_FLOAT_MAX, VTK_FLOAT_MAX, VTK_FLOAT_MAX } },
        { { -VTK_FLOAT_MAX, -VTK_FLOAT_MAX, -VTK_FLOAT_MAX } }, 0.0f };
      for (vtkIdType i = block * Size; i < std::min(count, (block + 1) * Size); ++i)
      {
        float p[4];
        std::memcpy(p, splats.data() + words * static_cast<size_t>(i), sizeof(p));
        for (size_t k = 0; k < 3; ++k)
        {
          box.Low[k] = std::min(box.Low[k], p[k]);
          box.High[k] = std::max(box.High[k], p[k]);
        }
        box.Radius = std::max(box.Radius, p[3]);
      }
      this->Boxes[static_cast<size_t>(block)] = box;
    }
  });
}
