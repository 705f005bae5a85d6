// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVPointSplatMapper
 * @brief   vtkPointSplatMapper, whose picks are told in ParaView's ids
 *
 * ParaView moves points from process to process, and merges pieces: a hardware selection is to
 * answer with the ids that points have in the data that the user sees. After each of its passes
 * ids are replaced by the values that the picked point, or cell, has in the arrays
 * `vtkOriginalPointIds` and `vtkOriginalCellIds` (vtkIdType) and, of points, `vtkProcessId` and
 * `vtkCompositeIndex` (unsigned int), as vtkPVPointSplatGeometry makes them, where they are there.
 */
#ifndef vtkPVPointSplatMapper_h
#define vtkPVPointSplatMapper_h

#include "vtkPVPointSplattingModule.h" // For export macro
#include "vtkPointSplatMapper.h"

#include "vtkPointSplattingABI.h"

#include <string> // For std::string

class VTKPVPOINTSPLATTING_EXPORT vtkPVPointSplatMapper : public vtkPointSplatMapper
{
public:
  static vtkPVPointSplatMapper* New();
  vtkTypeMacro(vtkPVPointSplatMapper, vtkPointSplatMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The names of the arrays of points' and of cells' ids. Defaults: vtkOriginalPointIds and
   * vtkOriginalCellIds.
   */
  void SetIdArrays(const std::string& ofPoints, const std::string& ofCells);
  const std::string& GetPointIdArray() const { return this->PointIdArray; }
  const std::string& GetCellIdArray() const { return this->CellIdArray; }
  ///@}

  void ProcessSelectorPixelBuffers(vtkHardwareSelector* selector,
    std::vector<unsigned int>& pixelOffsets, vtkProp* prop) override;

protected:
  // All processes must draw the same points, and ParaView asks for frames itself.
  vtkPVPointSplatMapper() { this->SetProgressive(false); }
  ~vtkPVPointSplatMapper() override = default;

private:
  vtkPVPointSplatMapper(const vtkPVPointSplatMapper&) = delete;
  void operator=(const vtkPVPointSplatMapper&) = delete;

  std::string PointIdArray = "vtkOriginalPointIds";
  std::string CellIdArray = "vtkOriginalCellIds";
};

#endif
