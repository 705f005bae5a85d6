// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a reader makes of random data.
#ifndef FuzzRoundTrip_h
#define FuzzRoundTrip_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class FuzzRandom;

/// The same through a file in memory, of VTK's XML or legacy format.
vtkSmartPointer<vtkPolyData> FuzzRoundTrip(FuzzRandom& random, vtkPolyData* data);

#endif
