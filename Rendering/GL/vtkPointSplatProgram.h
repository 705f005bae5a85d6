// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One OpenGL program of this module's own: compute, or vertex and fragment.
// vtkShaderProgram of VTK 9.1 knows no compute shaders and sets no unsigned or
// integer-vector uniforms; what VTK's render passes must be able to change (the
// resolve stage) goes through VTK's shader cache instead.
//
// What is built stays as long as its context, as what is in that cache does, and is shared by all
// that ask for the same: building takes longer than many frames, and mappers come and go. So the
// uniforms of a program may have any values when it is used, and all are to be set.
#ifndef vtkPointSplatProgram_h
#define vtkPointSplatProgram_h

#include "vtkPointSplatContext.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

class vtkPointSplatProgram
{
public:
  /// An embedded shader file, and its kind: GL_COMPUTE_SHADER, ...
  using Stage = std::pair<GLenum, std::string>;

  /**
   * The text of an embedded shader file, by its name without ".glsl", with its
   * #include lines expanded, each file once; empty where there is no such file.
   */
  static std::string Source(const std::string& name);

  /// Whether the entered context has compute shaders.
  static bool IsComputeSupported();

  /**
   * Compiles and links, unless the entered context has such a program. defines: lines that follow the version; feedback:
   * what the vertex shader writes by transform feedback, or null. False, and what the driver said
   * in GetLog(), on failure.
   */
  bool Build(const std::vector<Stage>& stages, const std::string& defines = std::string(),
    const char* feedback = nullptr);
  /// Of a screen pass: vtkPointSplatScreenVS and a fragment shader.
  bool BuildScreen(const std::string& fragment, const std::string& defines = std::string())
  {
    return this->Build(
      { { GL_VERTEX_SHADER, "vtkPointSplatScreenVS" }, { GL_FRAGMENT_SHADER, fragment } },
      defines);
  }

  /**
   * Sets uniforms of a program that belongs to somebody else, who also has it in use.
   */
  void Borrow(GLuint handle) { this->Name = handle; }

  /// Invocations of a work group, where a shader has no reason for another number.
  static constexpr vtkIdType GroupSize = 64;

  /**
   * Of a compute program in use: as many work groups as so many invocations need, over two
   * dimensions where they are too many for one; then waits for what they wrote to be seen.
   *
   * Mesa compiles a program for processors once for each combination of its textures' samplers, which takes it a second
   * or two; and a texture that is a buffer, which has none, leaves at its place that of whatever program was there
   * before. So that programs are compiled once, all places have the same one before a program runs.
   */
  static void Dispatch(vtkIdType invocations, vtkIdType groupSize = GroupSize);

  /// Says that compute programs may have run with a texture that is no buffer, whose sampler is there still.
  static void ForgetSamplers();

  const std::string& GetLog() const { return this->Log; }
  void Use() const { glUseProgram(this->Name); }
  /// Forgets the program.
  void Release();

  ///@{
  /**
   * Sets a uniform of the program in use; names that it lacks are ignored. name: a literal, by
   * whose address its location is kept.
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
  void Set(const char* name, const glm::mat2& value);
  void Set(const char* name, const glm::mat3& value);
  void Set(const char* name, const glm::mat4& value);
  void Set(const char* name, const std::vector<glm::vec4>& value);
  void Set(const char* name, const std::vector<float>& value);
  ///@}

private:
  static void PrepareSamplers();
  GLint Location(const char* name);
  GLuint Make(const std::vector<Stage>& stages, const std::string& defines, const char* feedback);

  GLuint Name = 0;
  vtkPointSplatContext Context; // which has what was built
  std::string Log;
  std::vector<std::pair<const char*, GLint>> Locations;
};

#endif
