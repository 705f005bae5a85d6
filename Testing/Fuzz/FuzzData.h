// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Random data: good, odd and wrong.
#ifndef FuzzData_h
#define FuzzData_h

#include "FuzzRandom.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace FuzzData
{
/// Poly data, an unstructured or a structured grid, of 0 to some thousand points.
vtkSmartPointer<vtkPointSet> MakePoints(FuzzRandom& random);
vtkSmartPointer<vtkImageData> MakeImage(FuzzRandom& random);
/// Any of these, or a tree of them.
vtkSmartPointer<vtkDataObject> MakeAny(FuzzRandom& random);
/// Nothing is wrong with it: a sphere of the given centre and radius.
vtkSmartPointer<vtkPolyData> MakeSphere(const double centre[3], double radius);
/// Adds to the arrays, or changes them, as a user does between two frames.
void Change(FuzzRandom& random, vtkDataObject* data);
/// A number that differs where any array, cell or block of the data does.
std::uint64_t Digest(vtkDataObject* data);
}

#endif
