// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What stages that draw to images of their own change of OpenGL's state, put back at the end of
// the scope. vtkOpenGLState::Pop() would bind buffers, too, that were bound when the state was
// last read from OpenGL; these may be gone, and it leaves an error then.
#ifndef vtkPointSplatSavedState_h
#define vtkPointSplatSavedState_h

#include "vtkPointSplattingOpenGL.h"

#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

#include <glm/glm.hpp>

class vtkPointSplatSavedState
{
public:
  explicit vtkPointSplatSavedState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunc(state)
    , BlendFunc(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , CullFace(state, GL_CULL_FACE)
  {
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->Equations[0]);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->Equations[1]);
    state->PushFramebufferBindings();
  }
  ~vtkPointSplatSavedState()
  {
    this->State->PopFramebufferBindings();
    this->State->vtkglBlendEquationSeparate(
      static_cast<GLenum>(this->Equations[0]), static_cast<GLenum>(this->Equations[1]));
    this->State->GetShaderCache()->ReleaseCurrentShader();
    glUseProgram(0);
  }
  /// For screen passes over images of this size: no tests, no blending.
  void SetForImages(const glm::ivec2& size) const
  {
    this->State->vtkglViewport(0, 0, size.x, size.y);
    this->State->vtkglDisable(GL_SCISSOR_TEST);
    this->State->vtkglDisable(GL_DEPTH_TEST);
    this->State->vtkglDisable(GL_CULL_FACE);
    this->State->vtkglDisable(GL_BLEND);
    this->State->vtkglDepthMask(GL_FALSE);
    this->State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  vtkPointSplatSavedState(const vtkPointSplatSavedState&) = delete;
  void operator=(const vtkPointSplatSavedState&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  GLint Equations[2] = { GL_FUNC_ADD, GL_FUNC_ADD };
};

#endif
