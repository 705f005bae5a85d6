// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLHeadlessRenderWindow.h"

#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSplatCurrentGLX.h"
#include "vtkPointSplattingConfigure.h"
#include "vtkPointSplattingOpenGL.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <vector>

#if PointSplatting_HAVE_EGL && !PointSplatting_VTK_HAS_EGL_WINDOW
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkEGLHeadlessRenderWindow);

namespace
{
const char* const NoContext =
  "No OpenGL context of version 3.2 or newer can be made by EGL (devices, surfaceless and "
  "pbuffer were tried). Install an EGL driver (Debian: libegl1 and libgl1-mesa-dri), or use "
  "vtkRenderWindow with an X server.";
}

#if PointSplatting_VTK_HAS_EGL_WINDOW

struct vtkEGLHeadlessRenderWindow::vtkInternals
{
  bool Failed = false;
};

vtkEGLHeadlessRenderWindow::vtkEGLHeadlessRenderWindow()
  : Internals(new vtkInternals)
{
  this->SetOffScreenRendering(1);
}

vtkEGLHeadlessRenderWindow::~vtkEGLHeadlessRenderWindow() = default;

const char* vtkEGLHeadlessRenderWindow::GetPlatform()
{
  return this->Initialized ? "vtkEGLRenderWindow" : "";
}

void vtkEGLHeadlessRenderWindow::Render()
{
  // VTK's window goes on without OpenGL's functions, and crashes.
  if (!this->Initialized && !this->Internals->Failed)
  {
    this->Initialize();
    this->Internals->Failed = !this->Initialized;
    if (this->Internals->Failed)
    {
      vtkErrorMacro(<< NoContext);
    }
  }
  if (!this->Internals->Failed)
  {
    this->Superclass::Render();
  }
}

#else

struct vtkEGLHeadlessRenderWindow::vtkInternals
{
  std::string Platform;
  std::string Capabilities;
  bool Failed = false;
  int Visits = 0;
  vtkPointSplatCurrentGLX Before;                 // the outermost visit
  vtkWeakPointer<vtkHardwareSelector> Selection; // that Leave() waits for
  std::vector<bool> Pushed; // whether the context was current before

#if PointSplatting_HAVE_EGL
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
  EGLSurface Surface = EGL_NO_SURFACE;

  /**
   * Makes a context on a display; without a surface where EGL allows that,
   * else on a pbuffer of one pixel (VTK draws into its own framebuffers).
   */
  bool Open(EGLDisplay display, const std::string& platform)
  {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
      !eglBindAPI(EGL_OPENGL_API))
    {
      return false;
    }
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    const bool surfaceless = extensions &&
      std::string(extensions).find("EGL_KHR_surfaceless_context") != std::string::npos;
    const EGLint wanted[] = { EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT,
      EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8,
      EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
    {
      return false;
    }
    const int versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 3 }, { 4, 1 }, { 3, 3 }, { 3, 2 } };
    EGLContext context = EGL_NO_CONTEXT;
    for (const auto& version : versions)
    {
      const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0],
        EGL_CONTEXT_MINOR_VERSION, version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
      context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
      if (context != EGL_NO_CONTEXT)
      {
        break;
      }
    }
    if (context == EGL_NO_CONTEXT)
    {
      return false;
    }
    EGLSurface surface = EGL_NO_SURFACE;
    if (!surfaceless)
    {
      const EGLint size[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
      surface = eglCreatePbufferSurface(display, config, size);
    }
    if (!eglMakeCurrent(display, surface, surface, context))
    {
      if (surface != EGL_NO_SURFACE)
      {
        eglDestroySurface(display, surface);
      }
      eglDestroyContext(display, context);
      return false;
    }
    this->Display = display;
    this->Context = context;
    this->Surface = surface;
    this->Platform = platform;
    return true;
  }

  /// In EGL's order, which has graphics cards before what draws on the processor.
  static std::vector<EGLDeviceEXT> Devices()
  {
    auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (!queryDevices || !queryDevices(0, nullptr, &count) || count < 1)
    {
      return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
    queryDevices(count, devices.data(), &count);
    devices.resize(static_cast<size_t>(std::max(count, 0)));
    return devices;
  }

  static bool IsCard(EGLDeviceEXT device)
  {
    auto queryString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
      eglGetProcAddress("eglQueryDeviceStringEXT"));
    const char* extensions = queryString ? queryString(device, EGL_EXTENSIONS) : nullptr;
    return extensions &&
      std::string(extensions).find("EGL_MESA_device_software") == std::string::npos;
  }

  bool OpenAny(int wanted)
  {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const std::string extensions = client ? client : "";
    auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getDisplay && extensions.find("EGL_EXT_platform_device") != std::string::npos)
    {
      const std::vector<EGLDeviceEXT> devices = Devices();
      const auto open = [&](size_t i) {
        return this->Open(getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
          "device " + std::to_string(i));
      };
      // The first one is nobody's wish: where it is no card, the surfaceless platform draws as well.
      const size_t own = static_cast<size_t>(std::max(wanted, 0));
      if (own < devices.size() && (own > 0 || IsCard(devices[own])) && open(own))
      {
        return true;
      }
      for (size_t i = 0; i < devices.size(); ++i)
      {
        if (i != own && IsCard(devices[i]) && open(i))
        {
          return true;
        }
      }
    }
    return (getDisplay && extensions.find("EGL_MESA_platform_surfaceless") != std::string::npos &&
             this->Open(getDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                          reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr),
               "surfaceless")) ||
      this->Open(eglGetDisplay(EGL_DEFAULT_DISPLAY), "pbuffer");
  }

  // The display is not terminated: EGL hands the same one to every window of
  // the process, VTK's own and the application's included.
  void Close()
  {
    if (this->Context == EGL_NO_CONTEXT)
    {
      return;
    }
    this->ReleaseCurrent();
    if (this->Surface != EGL_NO_SURFACE)
    {
      eglDestroySurface(this->Display, this->Surface);
    }
    eglDestroyContext(this->Display, this->Context);
    this->Context = EGL_NO_CONTEXT;
    this->Surface = EGL_NO_SURFACE;
    this->Platform.clear();
  }

  bool IsOpen() const { return this->Context != EGL_NO_CONTEXT; }
  bool IsCurrent() const { return this->IsOpen() && eglGetCurrentContext() == this->Context; }
  void ReleaseCurrent()
  {
    if (this->IsCurrent())
    {
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
  }
  bool MakeCurrent()
  {
    return eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context);
  }
  void* GetContext() const { return this->Context; }
  static int GetNumberOfDevices() { return static_cast<int>(Devices().size()); }
#else
  bool OpenAny(int) { return false; }
  void Close() {}
  bool IsOpen() const { return false; }
  bool IsCurrent() const { return false; }
  void ReleaseCurrent() {}
  bool MakeCurrent() { return false; }
  void* GetContext() const { return nullptr; }
  static int GetNumberOfDevices() { return 0; }
#endif
};

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::vtkEGLHeadlessRenderWindow()
  : Internals(new vtkInternals)
{
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  this->SetStencilCapable(1);
  // There is no framebuffer 0 to blit to.
  this->FrameBlitMode = NoBlit;
  this->SetOffScreenRendering(1);
}

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::~vtkEGLHeadlessRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
const char* vtkEGLHeadlessRenderWindow::GetPlatform()
{
  return this->Internals->Platform.c_str();
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetNumberOfDevices()
{
  return this->Internals->GetNumberOfDevices();
}

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::Visit::Visit(vtkEGLHeadlessRenderWindow* window)
  : Window(window)
  , Open(window->Internals->IsOpen())
{
  const vtkPointSplatCurrentGLX current = vtkPointSplatCurrentGLX::Get();
  if (window->Internals->Visits++ == 0 && current)
  {
    window->Internals->Before = current;
  }
  window->MakeCurrent();
}

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::Visit::~Visit()
{
  vtkInternals& internals = *this->Window->Internals;
  if (--internals.Visits > 0)
  {
    return;
  }
  // A selection is many frames, and sets state of OpenGL's between them.
  vtkHardwareSelector* selection = nullptr;
  vtkCollectionSimpleIterator it;
  this->Window->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Window->Renderers->GetNextRenderer(it))
  {
    selection = renderer->GetSelector() ? renderer->GetSelector() : selection;
  }
  if (!selection)
  {
    this->Window->Leave();
  }
  else if (internals.Selection != selection)
  {
    internals.Selection = selection;
    selection->AddObserver(
      vtkCommand::EndEvent, this->Window, &vtkEGLHeadlessRenderWindow::Leave);
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Leave()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Before || vtkPointSplatCurrentGLX::MayCome())
  {
    internals.ReleaseCurrent();
    internals.Before.MakeCurrent();
  }
  internals.Before = vtkPointSplatCurrentGLX();
}

//------------------------------------------------------------------------------
vtkOpenGLState* vtkEGLHeadlessRenderWindow::GetState()
{
  // Who asks for it changes it, and OpenGL's with it.
  this->MakeCurrent();
  return this->Superclass::GetState();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Initialize()
{
  const Visit visit(this);
  if (!this->Internals->IsOpen() && !this->Internals->Failed)
  {
    this->CreateAWindow();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::CreateAWindow()
{
  vtkPointSplatCurrentGLX::Release();
  if (!this->Internals->OpenAny(this->DeviceIndex))
  {
    this->Internals->Failed = true;
    vtkErrorMacro(<< NoContext);
    return;
  }
  if (this->Size[0] <= 0 || this->Size[1] <= 0)
  {
    this->Size[0] = 300;
    this->Size[1] = 300;
  }
  this->Mapped = 1;
  this->OwnContext = 1;

  // Renderers may have been made for another context: let them start afresh.
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    renderer->SetRenderWindow(nullptr);
    renderer->SetRenderWindow(this);
  }
  this->OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::OpenGLInitContext()
{
  if (!this->Initialized && this->Internals->IsOpen())
  {
    // A glew that was built for GLX loads every entry point and then complains
    // that there is no GLX display (error 4): that is expected here.
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    constexpr GLenum noGLXDisplay = 4;
    if (result != GLEW_OK && result != noGLXDisplay)
    {
      vtkErrorMacro("OpenGL's entry points cannot be loaded: "
        << reinterpret_cast<const char*>(glewGetErrorString(result)));
      return;
    }
    while (glGetError() != GL_NO_ERROR)
    {
      // glewInit leaves errors behind in core profiles
    }
    this->GlewInitValid = true;
    this->Initialized = true;
    GLfloat range[2] = { 1.0f, 1.0f };
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    this->MaximumHardwareLineWidth = range[1];
    this->ContextCreationTime.Modified();
    return;
  }
  this->Superclass::OpenGLInitContext();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::DestroyWindow()
{
  if (!this->Internals->IsOpen())
  {
    return;
  }
  const Visit visit(this);
  this->ReleaseGraphicsResources(this);
  this->Internals->Close();
  this->Initialized = false;
  this->Mapped = 0;
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Finalize()
{
  this->DestroyWindow();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::MakeCurrent()
{
  if (!this->Internals->IsOpen() || this->Internals->IsCurrent())
  {
    return;
  }
  vtkPointSplatCurrentGLX::Release();
  if (!this->Internals->MakeCurrent())
  {
    vtkErrorMacro("The EGL context cannot be made current; is it current in another thread?");
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::ReleaseCurrent()
{
  this->Internals->ReleaseCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PushContext()
{
  this->Internals->Pushed.push_back(this->Internals->IsCurrent());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PopContext()
{
  std::vector<bool>& pushed = this->Internals->Pushed;
  if (!pushed.empty() && !pushed.back() && vtkPointSplatCurrentGLX::MayCome())
  {
    this->ReleaseCurrent();
  }
  if (!pushed.empty())
  {
    pushed.pop_back();
  }
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::IsCurrent()
{
  return this->Internals->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::SetSize(int width, int height)
{
  // VTK's framebuffers follow the size at the next Render(); no surface does.
  this->Superclass::SetSize(width, height);
}

//------------------------------------------------------------------------------
int* vtkEGLHeadlessRenderWindow::GetScreenSize()
{
  return this->ScreenSize;
}

//------------------------------------------------------------------------------
void* vtkEGLHeadlessRenderWindow::GetGenericContext()
{
  return this->Internals->GetContext();
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetColorBufferSizes(int* rgba)
{
  // The superclass asks the window's own buffers, which are none; VTK's
  // framebuffers have 8 bits a channel.
  std::fill_n(rgba, 4, this->Initialized ? 8 : 0);
  return this->Initialized ? 32 : 0;
}

//------------------------------------------------------------------------------
const char* vtkEGLHeadlessRenderWindow::ReportCapabilities()
{
  this->Initialize();
  std::string& text = this->Internals->Capabilities;
  text = "EGL platform:  " + this->Internals->Platform + "\n";
  const Visit visit(this);
  if (this->Initialized)
  {
    const GLenum names[] = { GL_VENDOR, GL_RENDERER, GL_VERSION };
    const char* labels[] = { "OpenGL vendor string:  ", "OpenGL renderer string:  ",
      "OpenGL version string:  " };
    for (int i = 0; i < 3; ++i)
    {
      const GLubyte* value = glGetString(names[i]);
      text += labels[i] + std::string(value ? reinterpret_cast<const char*>(value) : "") + "\n";
    }
  }
  return text.c_str();
}

#endif

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Platform: " << this->GetPlatform() << "\n";
}
VTK_ABI_NAMESPACE_END
