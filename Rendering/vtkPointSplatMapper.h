// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMapper
 * @brief   draws oriented points as the surface that they sample
 */
#ifndef vtkPointSplatMapper_h
#define vtkPointSplatMapper_h

#include "vtkRenderingPointSplattingModule.h" // For export macro
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"
class vtkDataSet;
class vtkUnsignedCharArray;
#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatMapper : public vtkPolyDataMapper
{
public:
  static vtkPointSplatMapper* New();
  vtkTypeMacro(vtkPointSplatMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void RenderPiece(vtkRenderer*, vtkActor*) override;
  vtkSmartPointer<vtkUnsignedCharArray> MapPointColours(vtkDataSet*, int&);
protected:
  vtkPointSplatMapper();
  ~vtkPointSplatMapper() override;

private:
  vtkPointSplatMapper(const vtkPointSplatMapper&) = delete;
  void operator=(const vtkPointSplatMapper&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
