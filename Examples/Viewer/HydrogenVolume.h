// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume that splatview draws when it is given none.
#ifndef HydrogenVolume_h
#define HydrogenVolume_h

#include "vtkSmartPointer.h"

class vtkImageData;

/**
 * The probability density of hydrogen's 3d orbital along z (n = 3, l = 2, m = 0),
 * two lobes and a ring, scaled to a greatest value of 100; size samples along each
 * axis, over 40 Bohr radii.
 */
vtkSmartPointer<vtkImageData> MakeHydrogenVolume(int size);

#endif
