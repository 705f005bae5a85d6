// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a window can be asked for more frames than its user wants: it shows on a screen, and has an
// interactor that was initialized and whose timers work. Off the screen, and where there is no event
// loop, nothing would come of it, or too late for whoever reads the picture.
#ifndef vtkPointSplatTimers_h
#define vtkPointSplatTimers_h

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace vtkPointSplatTimers
{
constexpr unsigned long Period = 100; // ms

bool AreOf(vtkRenderWindow* window);
}

#endif
