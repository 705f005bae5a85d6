// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One OpenGL program of this module's own: compute, or vertex and fragment.
// vtkShaderProgram of VTK 9.1 knows no compute shaders and sets no unsigned or
// integer-vector uniforms; what VTK's render passes must be able to change (the
// resolve stage) goes through VTK's shader cache instead.
#ifndef vtkPointSplatProgram_h
#define vtkPointSplatProgram_h

#include "vtkPointSplattingOpenGL.h"

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <vector>

class vtkPointSplatProgram
{
public:
  vtkPointSplatProgram() = default;
  ~vtkPointSplatProgram() = default;
  vtkPointSplatProgram(const vtkPointSplatProgram&) = delete;
  void operator=(const vtkPointSplatProgram&) = delete;

  /**
   * The text of an embedded shader file, by its name without ".glsl", with its
   * #include lines expanded, each file once; empty where there is no such file.
   */
  static std::string Source(const std::string& name);

  /**
   * Compiles and links. Each stage is a kind (GL_COMPUTE_SHADER, ...) and an
   * embedded file. defines: lines that follow the version; feedback: what the vertex shader
   * writes by transform feedback, or null. False, and what the driver said in GetLog(), on
   * failure.
   */
  bool Build(const std::vector<std::pair<GLenum, std::string>>& stages,
    const std::string& defines = std::string(), const char* feedback = nullptr);

  /**
   * Sets uniforms of a program that belongs to somebody else, who also has it in use.
   */
  void Borrow(GLuint handle) { this->Handle = handle; }

  bool IsBuilt() const { return this->Handle != 0; }
  const std::string& GetLog() const { return this->Log; }
  void Use() const { glUseProgram(this->Handle); }
  void Release();

  ///@{
  /**
   * Sets a uniform of the program in use; names that it lacks are ignored.
   */
  void Set(const char* name, bool value);
  void Set(const char* name, int value);
  void Set(const char* name, unsigned int value);
  void Set(const char* name, float value);
  void Set(const char* name, const glm::vec2& value);
  void Set(const char* name, const glm::vec4& value);
  void Set(const char* name, const glm::ivec2& value);
  void Set(const char* name, const glm::ivec4& value);
  void Set(const char* name, const glm::uvec2& value);
  void Set(const char* name, const glm::mat3& value);
  void Set(const char* name, const glm::mat4& value);
  void Set(const char* name, const std::vector<glm::vec4>& value);
  void Set(const char* name, const std::vector<float>& value);
  ///@}

private:
  GLint Location(const char* name);

  GLuint Handle = 0;
  std::string Log;
  std::map<std::string, GLint> Locations;
};

#endif
