// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatQuads.h"

#include "vtkPointSplatProgram.h"

#include <utility>
#include <vector>

namespace
{
/// Runs of splats in view; those that follow each other make one.
std::vector<std::pair<vtkIdType, vtkIdType>> RunsOf(
  const vtkPointSplatItem& item, const vtkPointSplatCloud::Buffers& buffers)
{
  if (!item.Runs)
  {
    return { { 0, item.Cloud->GetNumberOfSplats() } };
  }
  std::vector<std::pair<vtkIdType, vtkIdType>> runs;
  for (const vtkPointSplatRuns::Run& run : item.GetRunsIn(buffers))
  {
    const vtkIdType first = run.First;
    const vtkIdType count = run.Count;
    if (!runs.empty() && runs.back().first + runs.back().second == first)
    {
      runs.back().second += count;
    }
    else
    {
      runs.emplace_back(first, count);
    }
  }
  return runs;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatQuads::SetUniforms(vtkPointSplatProgram& program, const vtkPointSplatItem& item,
  const vtkPointSplatView& view, unsigned int tagMask)
{
  item.SetUniforms(program, view);
  program.Set("TagMask", tagMask);
  program.Set("ImageSize", view.Size);
  program.Set("HasClipLines", item.Cloud->HasClipLines());
  program.Set("HasColours", item.Cloud->HasColours());
  program.Set("HasFactors", item.Factors != nullptr);
  program.Set("PointLayer", static_cast<float>(item.Points.Layer));
  program.Set("PointLayerPixels", static_cast<float>(item.Points.LayerPixels));
  program.Set("Kernel",
    glm::vec4(item.Kernel.Shape, static_cast<float>(item.Kernel.Support),
      item.Kernel.Plateau ? 1.0f : 0.0f));
}

//------------------------------------------------------------------------------
void vtkPointSplatQuads::Bind(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
  const vtkPointSplatBuffer* ids, vtkIdType first)
{
  const GLsizei stride = 4 * static_cast<GLsizei>(item.Cloud->GetWordsPerSplat());
  const GLsizei step = stride << item.StrideShift;
  const GLsizei step4 = 4 << item.StrideShift;
  // Without base instances, which OpenGL 3.2 has not: pointers to the first splat.
  auto at = [first](GLsizei bytes, GLsizei splat) {
    return reinterpret_cast<const void*>(
      static_cast<size_t>(bytes) + static_cast<size_t>(first) * static_cast<size_t>(splat));
  };
  buffers.VertexArray.Make();
  glBindVertexArray(buffers.VertexArray.Get());
  glBindBuffer(GL_ARRAY_BUFFER, buffers.Splats.Get());
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, step, at(0, stride));
  glVertexAttribIPointer(1, 3, GL_UNSIGNED_INT, step, at(16, stride));
  glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, step, at(28, stride));
  const bool axes = !item.Cloud->IsCircular();
  if (axes)
  {
    glVertexAttribPointer(4, 3, GL_FLOAT, GL_FALSE, step, at(32, stride));
    glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, step, at(48, stride));
  }
  if (ids)
  {
    glBindBuffer(GL_ARRAY_BUFFER, ids->Get());
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, step4, at(0, 4));
  }
  const bool colours = item.Cloud->HasColours();
  if (colours)
  {
    glBindBuffer(GL_ARRAY_BUFFER, buffers.Colours.Get());
    glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, step4, at(0, 4));
  }
  if (item.Factors)
  {
    glBindBuffer(GL_ARRAY_BUFFER, item.Factors->Get());
    glVertexAttribPointer(6, 4, GL_UNSIGNED_BYTE, GL_TRUE, step4, at(0, 4));
  }
  const bool lines = item.Cloud->HasClipLines();
  if (lines)
  {
    glBindBuffer(GL_ARRAY_BUFFER, buffers.ClipLines.Get());
    glVertexAttribPointer(7, 4, GL_FLOAT, GL_FALSE, 16 << item.StrideShift, at(0, 16));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const bool used[] = { true, true, true, colours, axes, axes, item.Factors != nullptr, lines };
  for (GLuint i = 0; i < 8; ++i)
  {
    if (used[i])
    {
      glEnableVertexAttribArray(i);
    }
    else
    {
      glDisableVertexAttribArray(i);
    }
    // Of OpenGL 3.2 loaders have the extension's name alone.
    (glVertexAttribDivisor ? glVertexAttribDivisor : glVertexAttribDivisorARB)(
      i, item.IsPoints ? 0 : 1);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatQuads::DrawRun(const vtkPointSplatItem& item,
  vtkPointSplatCloud::Buffers& buffers, vtkIdType first, vtkIdType count)
{
  vtkPointSplatQuads::Bind(item, buffers, nullptr, first);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkPointSplatQuads::Draw(
  const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
  const vtkPointSplatBuffer* ids)
{
  for (const std::pair<vtkIdType, vtkIdType>& run : RunsOf(item, buffers))
  {
    vtkPointSplatQuads::Bind(item, buffers, ids, run.first);
    const vtkIdType stride = vtkIdType(1) << item.StrideShift;
    const GLsizei count = static_cast<GLsizei>((run.second + stride - 1) / stride);
    if (item.IsPoints)
    {
      glDrawArrays(GL_POINTS, 0, count);
    }
    else
    {
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
  }
  glBindVertexArray(0);
}
