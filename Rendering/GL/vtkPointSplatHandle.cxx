// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatHandle.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <mutex>
#include <utility>
#include <vector>

namespace
{
// How drivers tell what memory is free, in kilobytes. The loaders of some VTK do not know these names.
struct MemoryQuery
{
  const char* Extension;
  GLenum Parameter;
};
constexpr MemoryQuery MemoryQueries[] = {
  { "GL_NVX_gpu_memory_info", 0x9049 }, // GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX
  { "GL_ATI_meminfo", 0x87FB },         // VBO_FREE_MEMORY_ATI: the first of four numbers
};

struct Orphan
{
  vtkPointSplatContext Context;
  vtkPointSplatHandle::KindType Kind;
  GLuint Name;
};

std::mutex& OrphanMutex()
{
  static std::mutex mutex;
  return mutex;
}

std::vector<Orphan>& Orphans()
{
  static std::vector<Orphan> orphans;
  return orphans;
}

vtkPointSplatContext& EnteredContext()
{
  static thread_local vtkPointSplatContext context;
  return context;
}

void Delete(vtkPointSplatHandle::KindType kind, GLuint name)
{
  switch (kind)
  {
    case vtkPointSplatHandle::Buffer:
      glDeleteBuffers(1, &name);
      break;
    case vtkPointSplatHandle::Texture:
      glDeleteTextures(1, &name);
      break;
    case vtkPointSplatHandle::Framebuffer:
      glDeleteFramebuffers(1, &name);
      break;
    case vtkPointSplatHandle::VertexArray:
      glDeleteVertexArrays(1, &name);
      break;
    case vtkPointSplatHandle::Sampler:
      glDeleteSamplers(1, &name);
      break;
    case vtkPointSplatHandle::Query:
      glDeleteQueries(1, &name);
      break;
  }
}
}

//------------------------------------------------------------------------------
vtkPointSplatContext::vtkPointSplatContext(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Time(window->GetContextCreationTime())
{
  // Windows release resources while they are being destroyed, when none may point to them any more.
  if (window->GetReferenceCount() > 0)
  {
    this->Living = window;
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatContext::IsAlive() const
{
  return this->Window &&
    (*this == EnteredContext() ||
      (this->Living && this->Time == this->Living->GetContextCreationTime()));
}

//------------------------------------------------------------------------------
bool vtkPointSplatContext::IsSoftware()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const char* const names[] = { "llvmpipe", "softpipe", "swr", "SWR", "Software" };
  return renderer && std::any_of(std::begin(names), std::end(names), [renderer](const char* name) {
    return std::strstr(renderer, name) != nullptr;
  });
}

//------------------------------------------------------------------------------
size_t vtkPointSplatContext::GetFreeMemory()
{
  if (vtkPointSplatContext::IsSoftware())
  {
    return 0;
  }
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const auto* name =
      reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    for (const MemoryQuery& query : MemoryQueries)
    {
      if (name && std::strcmp(name, query.Extension) == 0)
      {
        GLint kilobytes[4] = {};
        glGetIntegerv(query.Parameter, kilobytes);
        return size_t(1024) * static_cast<size_t>(std::max(kilobytes[0], 0));
      }
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
const vtkPointSplatContext& vtkPointSplatContext::Entered()
{
  return EnteredContext();
}

//------------------------------------------------------------------------------
vtkPointSplatContextScope::vtkPointSplatContextScope(vtkOpenGLRenderWindow* window)
  : Before(EnteredContext())
{
  EnteredContext() = vtkPointSplatContext(window);
  const std::lock_guard<std::mutex> lock(OrphanMutex());
  std::vector<Orphan>& orphans = Orphans();
  orphans.erase(std::remove_if(orphans.begin(), orphans.end(),
                  [](const Orphan& orphan) {
                    const bool mine = orphan.Context == vtkPointSplatContext::Entered();
                    if (mine)
                    {
                      Delete(orphan.Kind, orphan.Name);
                    }
                    return mine || !orphan.Context.IsAlive();
                  }),
    orphans.end());
}

//------------------------------------------------------------------------------
vtkPointSplatContextScope::~vtkPointSplatContextScope()
{
  EnteredContext() = this->Before;
}

//------------------------------------------------------------------------------
vtkPointSplatHandle::vtkPointSplatHandle(vtkPointSplatHandle&& other) noexcept
  : Kind(other.Kind)
  , Name(std::exchange(other.Name, 0))
  , Context(other.Context)
{
}

//------------------------------------------------------------------------------
vtkPointSplatHandle& vtkPointSplatHandle::operator=(vtkPointSplatHandle&& other) noexcept
{
  std::swap(this->Kind, other.Kind);
  std::swap(this->Name, other.Name);
  std::swap(this->Context, other.Context);
  return *this;
}

//------------------------------------------------------------------------------
bool vtkPointSplatHandle::Make()
{
  if (this->IsMade())
  {
    return false;
  }
  this->Release();
  switch (this->Kind)
  {
    case Buffer:
      glGenBuffers(1, &this->Name);
      break;
    case Texture:
      glGenTextures(1, &this->Name);
      break;
    case Framebuffer:
      glGenFramebuffers(1, &this->Name);
      break;
    case VertexArray:
      glGenVertexArrays(1, &this->Name);
      break;
    case Sampler:
      glGenSamplers(1, &this->Name);
      break;
    case Query:
      glGenQueries(1, &this->Name);
      break;
  }
  this->Context = vtkPointSplatContext::Entered();
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatHandle::Release()
{
  if (this->Name == 0)
  {
    return;
  }
  if (this->Context.IsCurrent())
  {
    Delete(this->Kind, this->Name);
  }
  else if (this->Context.IsAlive())
  {
    const std::lock_guard<std::mutex> lock(OrphanMutex());
    Orphans().push_back({ this->Context, this->Kind, this->Name });
  }
  this->Name = 0;
}
