// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatProgram.h"

#include "vtkOpenGLState.h"
#include "vtkPointSplatShaders.h"
#include "vtkTextureUnitManager.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <mutex>
#include <set>
#include <sstream>

namespace
{
struct BuiltProgram
{
  vtkPointSplatContext Context;
  std::string From; // defines, and names of the stages and of what is fed back
  GLuint Name;
};

// Textures that a compute program may have; none has more.
constexpr int Places = 16;

/// The context whose places have all the same sampler.
vtkPointSplatContext& Prepared()
{
  static thread_local vtkPointSplatContext context;
  return context;
}

void Expand(const std::string& name, std::set<std::string>& done, std::ostream& out)
{
  if (!done.insert(name).second)
  {
    return;
  }
  const char* text = vtkPointSplatShaderText(name);
  if (!text)
  {
    out << "#error there is no embedded shader " << name << "\n";
    return;
  }
  std::istringstream lines(text);
  std::string line;
  const std::string directive = "#include \"";
  while (std::getline(lines, line))
  {
    if (line.compare(0, directive.size(), directive) == 0)
    {
      Expand(line.substr(directive.size(), line.rfind('"') - directive.size()), done, out);
    }
    else
    {
      out << line << "\n";
    }
  }
}
}

//------------------------------------------------------------------------------
std::string vtkPointSplatProgram::Source(const std::string& name)
{
  std::set<std::string> done;
  std::ostringstream out;
  Expand(name, done, out);
  return out.str();
}

//------------------------------------------------------------------------------
bool vtkPointSplatProgram::IsComputeSupported()
{
  int major = 0;
  int minor = 0;
  vtkPointSplatContext::Entered().GetWindow()->GetOpenGLVersion(major, minor);
  return major > 4 || (major == 4 && minor >= 3);
}

//------------------------------------------------------------------------------
/// 0, and a log, where it does not compile or link.
GLuint vtkPointSplatProgram::Make(
  const std::vector<Stage>& stages, const std::string& defines, const char* feedback)
{
  const GLuint program = glCreateProgram();
  bool good = true;
  for (const Stage& stage : stages)
  {
    std::string source = vtkPointSplatProgram::Source(stage.second);
    source.insert(source.find('\n') + 1, defines);
    const char* text = source.c_str();
    GLuint shader = glCreateShader(stage.first);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled)
    {
      char message[4096] = "";
      glGetShaderInfoLog(shader, sizeof(message), nullptr, message);
      this->Log += stage.second + ": " + message + "\n";
      good = false;
    }
    glAttachShader(program, shader);
    glDeleteShader(shader); // lives on until the program goes
  }
  if (good)
  {
    if (feedback)
    {
      glTransformFeedbackVaryings(program, 1, &feedback, GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
    {
      char message[4096] = "";
      glGetProgramInfoLog(program, sizeof(message), nullptr, message);
      this->Log += std::string("link: ") + message + "\n";
      good = false;
    }
  }
  if (!good)
  {
    glDeleteProgram(program);
  }
  return good ? program : 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatProgram::Build(
  const std::vector<Stage>& stages, const std::string& defines, const char* feedback)
{
  const vtkPointSplatContext& entered = vtkPointSplatContext::Entered();
  if (this->Name != 0 && this->Context == entered)
  {
    return true;
  }
  this->Release();
  std::string key = defines;
  for (const Stage& stage : stages)
  {
    key += stage.second + "\n";
  }
  key += feedback ? feedback : "";
  static std::mutex mutex;
  static std::vector<BuiltProgram> all;
  const std::lock_guard<std::mutex> lock(mutex);
  all.erase(std::remove_if(all.begin(), all.end(),
              [](const BuiltProgram& built) { return !built.Context.IsAlive(); }),
    all.end());
  const auto same = std::find_if(all.begin(), all.end(), [&](const BuiltProgram& built) {
    return built.Context == entered && built.From == key;
  });
  this->Name = same != all.end() ? same->Name : this->Make(stages, defines, feedback);
  this->Context = entered;
  if (same == all.end() && this->Name != 0)
  {
    all.push_back({ entered, std::move(key), this->Name });
  }
  return this->Name != 0;
}

//------------------------------------------------------------------------------
/// Gives all places of the entered context the same sampler, if it draws on the processor and they have it no longer.
/// The program in use stays so.
void vtkPointSplatProgram::PrepareSamplers()
{
  const vtkPointSplatContext& entered = vtkPointSplatContext::Entered();
  if (Prepared() == entered)
  {
    return;
  }
  Prepared() = entered;
  vtkPointSplatProgram program;
  if (!vtkPointSplatContext::IsSoftware() ||
    !program.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatSamplersCS" } },
      "#define PLACES " + std::to_string(Places) + "\n"))
  {
    return;
  }
  GLint before = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &before);
  program.Use();
  // No texture, at all places by the same unit, has the driver's own in its place.
  vtkOpenGLRenderWindow* window = entered.GetWindow();
  const vtkOpenGLState::ScopedglActiveTexture active(window->GetState());
  const int unit = window->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  glBindTexture(GL_TEXTURE_2D, 0);
  const std::vector<GLint> units(Places, unit);
  glUniform1iv(program.Location("Textures"), Places, units.data());
  glDispatchCompute(1, 1, 1);
  window->GetTextureUnitManager()->Free(unit);
  glUseProgram(static_cast<GLuint>(before));
}

//------------------------------------------------------------------------------
void vtkPointSplatProgram::ForgetSamplers()
{
  Prepared() = vtkPointSplatContext();
}

//------------------------------------------------------------------------------
void vtkPointSplatProgram::Dispatch(vtkIdType invocations, vtkIdType groupSize)
{
  constexpr GLuint mostGroups = 32768; // in one dimension; OpenGL promises 65535
  const GLuint groups = static_cast<GLuint>((invocations + groupSize - 1) / groupSize);
  if (groups > 0)
  {
    PrepareSamplers();
    glDispatchCompute(std::min(groups, mostGroups), (groups + mostGroups - 1) / mostGroups, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
      GL_BUFFER_UPDATE_BARRIER_BIT);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatProgram::Release()
{
  this->Name = 0;
  this->Log.clear();
  this->Locations.clear();
}

//------------------------------------------------------------------------------
GLint vtkPointSplatProgram::Location(const char* name)
{
  for (const auto& known : this->Locations)
  {
    if (known.first == name)
    {
      return known.second;
    }
  }
  this->Locations.emplace_back(name, glGetUniformLocation(this->Name, name));
  return this->Locations.back().second;
}

//------------------------------------------------------------------------------
void vtkPointSplatProgram::Set(const char* name, bool value)
{
  glUniform1i(this->Location(name), value ? 1 : 0);
}

void vtkPointSplatProgram::Set(const char* name, int value)
{
  glUniform1i(this->Location(name), value);
}

void vtkPointSplatProgram::Set(const char* name, unsigned int value)
{
  glUniform1ui(this->Location(name), value);
}

void vtkPointSplatProgram::Set(const char* name, float value)
{
  glUniform1f(this->Location(name), value);
}

void vtkPointSplatProgram::Set(const char* name, const glm::vec2& value)
{
  glUniform2fv(this->Location(name), 1, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::vec4& value)
{
  glUniform4fv(this->Location(name), 1, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::ivec2& value)
{
  glUniform2iv(this->Location(name), 1, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::ivec4& value)
{
  glUniform4iv(this->Location(name), 1, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::uvec2& value)
{
  glUniform2uiv(this->Location(name), 1, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::mat2& value)
{
  glUniformMatrix2fv(this->Location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::mat3& value)
{
  glUniformMatrix3fv(this->Location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const glm::mat4& value)
{
  glUniformMatrix4fv(this->Location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void vtkPointSplatProgram::Set(const char* name, const std::vector<float>& value)
{
  if (!value.empty())
  {
    glUniform1fv(this->Location(name), static_cast<GLsizei>(value.size()), value.data());
  }
}

void vtkPointSplatProgram::Set(const char* name, const std::vector<glm::vec4>& value)
{
  if (!value.empty())
  {
    glUniform4fv(
      this->Location(name), static_cast<GLsizei>(value.size()), glm::value_ptr(value.front()));
  }
}
