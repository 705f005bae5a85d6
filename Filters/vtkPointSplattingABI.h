// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's ABI namespace, which VTK has from 9.3 on, for the versions before it.
// Include it after a header of VTK.
#ifndef vtkPointSplattingABI_h
#define vtkPointSplattingABI_h

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
