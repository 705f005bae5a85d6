// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The layer that is made where layers are peeled one after the other (vtkPointSplatPeel.glsl).
#ifndef vtkPointSplatPeel_h
#define vtkPointSplatPeel_h

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

#include <string>
#include <vector>

struct vtkPointSplatPeel
{
  bool Peels = false;  // there are more layers, or an opaque scene
  int Layer = 0;       // counted from 0
  bool Gather = false; // it takes all that is left
  GLuint SceneDepth = 0;
  std::vector<GLuint> Previous; // coded depths (R32UI) of up to three layers before, the last first

  std::string GetDefines() const
  {
    return std::string(this->Peels ? "#define PEELING\n" : "") +
      (this->Gather ? "#define GATHER\n" : "");
  }
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program, const glm::vec4& pixelZ) const
  {
    static const char* const names[] = { "Previous0", "Previous1", "Previous2" };
    if (this->Peels)
    {
      for (size_t k = 0; k < 3; ++k)
      {
        units.Bind(program, names[k], GL_TEXTURE_2D,
          k < this->Previous.size() ? this->Previous[k] : 0);
      }
      units.Bind(program, "SceneDepth", GL_TEXTURE_2D, this->SceneDepth);
      program.Set("PreviousCount", static_cast<int>(this->Previous.size()));
      program.Set("HasSceneDepth", this->SceneDepth != 0);
      program.Set("PixelZ", pixelZ);
    }
  }
};

#endif
