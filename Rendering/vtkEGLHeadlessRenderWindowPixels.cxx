// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What draws, reads and writes pixels: as the superclass does it, in a visit.
#include "vtkEGLHeadlessRenderWindow.h"

#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>

VTK_ABI_NAMESPACE_BEGIN
#if !PointSplatting_VTK_HAS_EGL_WINDOW
namespace
{
/// Of a rectangle by two of its corners, both within.
vtkIdType CountPixels(int x, int y, int x2, int y2)
{
  return (std::abs(vtkIdType(x2) - x) + 1) * (std::abs(vtkIdType(y2) - y) + 1);
}

template <typename Array, typename Value>
int Fill(Array* array, int components, vtkIdType pixels, Value value)
{
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(pixels);
  array->FillValue(value);
  return VTK_ERROR;
}

/// For callers that delete[] it.
template <typename Value>
Value* Filled(vtkIdType values, Value value)
{
  auto filled = new Value[static_cast<size_t>(values)];
  std::fill_n(filled, values, value);
  return filled;
}
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Render()
{
  this->Initialize();
  const Visit visit(this);
  if (visit)
  {
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::WaitForCompletion()
{
  const Visit visit(this);
  if (visit)
  {
    this->Superclass::WaitForCompletion();
  }
}

//------------------------------------------------------------------------------
unsigned char* vtkEGLHeadlessRenderWindow::GetPixelData(
  int x, int y, int x2, int y2, int front, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetPixelData(x, y, x2, y2, front, right)
               : Filled(3 * CountPixels(x, y, x2, y2), static_cast<unsigned char>(0));
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetPixelData(
  int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetPixelData(x, y, x2, y2, front, data, right)
               : Fill(data, 3, CountPixels(x, y, x2, y2), static_cast<unsigned char>(0));
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetPixelData(
  int x, int y, int x2, int y2, unsigned char* data, int front, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetPixelData(x, y, x2, y2, data, front, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetPixelData(
  int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetPixelData(x, y, x2, y2, data, front, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
float* vtkEGLHeadlessRenderWindow::GetRGBAPixelData(
  int x, int y, int x2, int y2, int front, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetRGBAPixelData(x, y, x2, y2, front, right)
               : Filled(4 * CountPixels(x, y, x2, y2), 0.0f);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetRGBAPixelData(
  int x, int y, int x2, int y2, int front, vtkFloatArray* data, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetRGBAPixelData(x, y, x2, y2, front, data, right)
               : Fill(data, 4, CountPixels(x, y, x2, y2), 0.0f);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetRGBAPixelData(
  int x, int y, int x2, int y2, float* data, int front, int blend, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetRGBAPixelData(x, y, x2, y2, data, front, blend, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetRGBAPixelData(
  int x, int y, int x2, int y2, vtkFloatArray* data, int front, int blend, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetRGBAPixelData(x, y, x2, y2, data, front, blend, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
unsigned char* vtkEGLHeadlessRenderWindow::GetRGBACharPixelData(
  int x, int y, int x2, int y2, int front, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetRGBACharPixelData(x, y, x2, y2, front, right)
               : Filled(4 * CountPixels(x, y, x2, y2), static_cast<unsigned char>(0));
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetRGBACharPixelData(
  int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetRGBACharPixelData(x, y, x2, y2, front, data, right)
               : Fill(data, 4, CountPixels(x, y, x2, y2), static_cast<unsigned char>(0));
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetRGBACharPixelData(
  int x, int y, int x2, int y2, unsigned char* data, int front, int blend, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetRGBACharPixelData(x, y, x2, y2, data, front, blend, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetRGBACharPixelData(
  int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int blend, int right)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetRGBACharPixelData(x, y, x2, y2, data, front, blend, right)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
float* vtkEGLHeadlessRenderWindow::GetZbufferData(
  int x, int y, int x2, int y2)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetZbufferData(x, y, x2, y2)
               : Filled(CountPixels(x, y, x2, y2), 1.0f);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetZbufferData(
  int x, int y, int x2, int y2, float* z)
{
  const Visit visit(this);
  if (!visit)
  {
    std::fill_n(z, CountPixels(x, y, x2, y2), 1.0f);
    return VTK_ERROR;
  }
  return this->Superclass::GetZbufferData(x, y, x2, y2, z);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetZbufferData(
  int x, int y, int x2, int y2, vtkFloatArray* z)
{
  const Visit visit(this);
  return visit ? this->Superclass::GetZbufferData(x, y, x2, y2, z)
               : Fill(z, 1, CountPixels(x, y, x2, y2), 1.0f);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetZbufferData(
  int x, int y, int x2, int y2, float* z)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetZbufferData(x, y, x2, y2, z)
               : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SetZbufferData(
  int x, int y, int x2, int y2, vtkFloatArray* z)
{
  const Visit visit(this);
  return visit ? this->Superclass::SetZbufferData(x, y, x2, y2, z)
               : VTK_ERROR;
}
#endif
VTK_ABI_NAMESPACE_END
