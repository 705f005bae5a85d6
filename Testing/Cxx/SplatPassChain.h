// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The shortest chain of render passes that draws splats.
#ifndef SplatPassChain_h
#define SplatPassChain_h

#include "SplatScene.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkPointSplatPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"

namespace SplatScene
{
inline void DrawByPass(Window& window)
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkPointSplatPass> splats;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(splats);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  window.Renderer->SetPass(camera);
}
}

#endif
