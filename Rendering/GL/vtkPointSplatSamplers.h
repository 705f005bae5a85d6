// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The samplers at the places of compute programs' textures. Mesa compiles a program for processors once for each
// combination of them, which takes it a second or two; and a texture that is a buffer, which has none, leaves at its
// place that of whatever program was there before. So that programs are compiled once, all places have the same one
// before a program runs.
#ifndef vtkPointSplatSamplers_h
#define vtkPointSplatSamplers_h

namespace vtkPointSplatSamplers
{
/// Gives all places of the entered context the same sampler, if it draws on the processor and they have it no longer.
/// The program in use stays so.
void Prepare();

/// Says that programs have run with a texture that is no buffer, whose sampler is there still.
void Forget();
}

#endif
