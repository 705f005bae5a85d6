// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Random properties of what is in a scene: usual ones, and values that programs trip over.
#ifndef FuzzProperties_h
#define FuzzProperties_h

class FuzzRandom;
class vtkActor;
class vtkPointSplatMapper;
class vtkRenderer;

namespace FuzzProperties
{
/// What one mapper of a renderer wants may decide for all; see the mapper's header.
void SetShared(FuzzRandom& random, vtkPointSplatMapper* mapper);
void SetOwn(FuzzRandom& random, vtkPointSplatMapper* mapper);
void SetColouring(FuzzRandom& random, vtkPointSplatMapper* mapper);
void SetActor(FuzzRandom& random, vtkActor* actor);
void SetCamera(FuzzRandom& random, vtkRenderer* renderer);

/// Lights beside those that the renderer makes itself, and an environment texture, now and then;
/// wild: with numbers that are not finite too.
void SetLights(FuzzRandom& random, vtkRenderer* renderer, bool wild);
void SetEnvironment(FuzzRandom& random, vtkRenderer* renderer, bool wild);
}

#endif
