// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Texture units for the programs that do not go through VTK's shader cache: taken from the
// window's manager, since render passes hold units of their own while mappers draw, and
// given back at the end of a scope. The unit that was active becomes active again.
#ifndef vtkPointSplatUnits_h
#define vtkPointSplatUnits_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatProgram.h"
#include "vtkTextureUnitManager.h"

#include <string>
#include <vector>

class vtkPointSplatUnits
{
public:
  explicit vtkPointSplatUnits(vtkOpenGLRenderWindow* window)
    : Window(window)
    , Active(window->GetState())
  {
  }
  ~vtkPointSplatUnits()
  {
    for (const Use& use : this->Uses)
    {
      this->Activate(use.Unit);
      glBindTexture(use.Target, 0);
      this->Window->GetTextureUnitManager()->Free(use.Unit);
    }
    if (this->HasSamplers)
    {
      vtkPointSplatProgram::ForgetSamplers();
    }
  }
  vtkPointSplatUnits(const vtkPointSplatUnits&) = delete;
  void operator=(const vtkPointSplatUnits&) = delete;

  /**
   * Binds a texture, or none (0), for a sampler of the program in use; the sampler keeps its
   * unit when it is bound again. Samplers of different kinds never share a unit.
   */
  void Bind(vtkPointSplatProgram& program, const char* sampler, GLenum target, GLuint texture)
  {
    const Use* found = nullptr;
    for (const Use& use : this->Uses)
    {
      found = use.Sampler == sampler && use.Target == target ? &use : found;
    }
    if (!found)
    {
      this->Uses.push_back({ sampler, target, this->Window->GetTextureUnitManager()->Allocate() });
      found = &this->Uses.back();
    }
    this->Activate(found->Unit);
    glBindTexture(target, texture);
    program.Set(sampler, found->Unit);
    this->HasSamplers = this->HasSamplers || target != GL_TEXTURE_BUFFER;
  }

private:
  struct Use
  {
    std::string Sampler;
    GLenum Target;
    int Unit;
  };
  void Activate(int unit)
  {
    this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  }

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState::ScopedglActiveTexture Active;
  std::vector<Use> Uses;
  bool HasSamplers = false;
};

#endif
