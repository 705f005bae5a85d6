// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEGLHeadlessRenderWindow
 * @brief   an off-screen OpenGL window that needs no X server
 *
 * Many packaged builds of VTK have GLX windows only and abort where there is
 * no DISPLAY. This window makes a core-profile context by EGL alone and lets
 * VTK draw into its own framebuffer objects, so it serves batch jobs,
 * containers and tests. Everything that works with an off-screen
 * vtkRenderWindow works with it: GetPixelData, vtkWindowToImageFilter,
 * selection, render passes, several windows side by side.
 *
 * How the context is found, the first that works being used:
 * 1. of the device platform (EGL_EXT_platform_device) the device that SetDeviceIndex() names, of
 *    GetNumberOfDevices() ones in EGL's order, which has graphics cards first; that is 0 unless told,
 *    which is taken if it is a graphics card,
 * 2. each other of its devices that is a graphics card, in that order,
 * 3. the surfaceless platform (EGL_MESA_platform_surfaceless),
 * 4. the default display with a pbuffer of one pixel.
 * Cards come first, since the surfaceless platform is Mesa's: beside another driver it would draw
 * on the processor. In each, core profiles from 4.6 down to 3.2 are tried. GetPlatform() tells
 * what was found. Where there is no EGL, or no context, one error is given and
 * the window stays uninitialised: Render() then draws nothing, and pictures that
 * are read are black.
 *
 * Beside windows of an X server, in any order: a thread has one current context,
 * and the dispatch libraries refuse an EGL context while one of GLX is current and
 * the other way round, the latter by an X error that ends the process. So
 * 1. to become current, this window first releases a context of GLX,
 * 2. where DISPLAY is set, or GLX had the thread, it releases its own context after
 *    Render(), a selection, reading or writing pixels, and in PopContext(); GLX then
 *    has back what it had.
 * A program that calls MakeCurrent() or GetState() itself there calls ReleaseCurrent()
 * when it is done. Where DISPLAY is not set the context stays current, as any window's does.
 *
 * Where VTK has an EGL window of its own (vtkEGLRenderWindow, every build from
 * VTK 9.4 on), this class is nothing but that window, made off-screen, and shares a
 * thread with other windows as VTK's does. Render() draws nothing where there is no context,
 * with one error; other calls are VTK's, which needs one.
 */

#ifndef vtkEGLHeadlessRenderWindow_h
#define vtkEGLHeadlessRenderWindow_h

#include "vtkPointSplattingFeatures.h"        // whether VTK has an EGL window
#include "vtkRenderingPointSplattingModule.h" // For export macro

#if PointSplatting_VTK_HAS_EGL_WINDOW
#include "vtkEGLRenderWindow.h"
using vtkEGLHeadlessRenderWindowBase = vtkEGLRenderWindow;
#else
#include "vtkOpenGLRenderWindow.h"
using vtkEGLHeadlessRenderWindowBase = vtkOpenGLRenderWindow;
#endif

#include "vtkPointSplattingABI.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkEGLHeadlessRenderWindow
  : public vtkEGLHeadlessRenderWindowBase
{
public:
  static vtkEGLHeadlessRenderWindow* New();
  vtkTypeMacro(vtkEGLHeadlessRenderWindow, vtkEGLHeadlessRenderWindowBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the context was made: "device 0", "surfaceless", "pbuffer", or an
   * empty string before the first Render() and where no context was to be had.
   */
  const char* GetPlatform();

#if PointSplatting_VTK_HAS_EGL_WINDOW
  /// Nothing, with one error, where there is no context.
  void Render() override;
#else
  ///@{
  /**
   * What vtkRenderWindow asks of a window of its own kind. There is no screen,
   * so positions, window ids and full-screen modes are remembered or ignored.
   */
  void Initialize() override;
  void Finalize() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  void SetSize(int width, int height) override;
  void SetSize(int size[2]) override { this->SetSize(size[0], size[1]); }
  int* GetScreenSize() VTK_SIZEHINT(2) override;
  void SetFullScreen(vtkTypeBool) override {}
  void WindowRemap() override {}
  void HideCursor() override {}
  void ShowCursor() override {}
  void* GetGenericDisplayId() override { return nullptr; }
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericContext() override;
  void* GetGenericDrawable() override { return nullptr; }
  void SetDisplayId(void*) override {}
  void SetWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  int GetColorBufferSizes(int* rgba) override;
  const char* ReportCapabilities() override;
  void WaitForCompletion() override;
  int IsDirect() override { return 1; }
  int GetNumberOfDevices() override;
  vtkOpenGLState* GetState() override;
  vtkTypeBool GetEventPending() override { return 0; }
  ///@}

  ///@{
  /**
   * As every window's, and nothing where there is no context.
   */
  void Render() override;
  unsigned char* GetPixelData(int x, int y, int x2, int y2, int front, int right) override;
  int GetPixelData(
    int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data, int right) override;
  int SetPixelData(
    int x, int y, int x2, int y2, unsigned char* data, int front, int right) override;
  int SetPixelData(
    int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int right) override;
  float* GetRGBAPixelData(int x, int y, int x2, int y2, int front, int right = 0) override;
  int GetRGBAPixelData(
    int x, int y, int x2, int y2, int front, vtkFloatArray* data, int right = 0) override;
  int SetRGBAPixelData(int x, int y, int x2, int y2, float* data, int front, int blend = 0,
    int right = 0) override;
  int SetRGBAPixelData(int x, int y, int x2, int y2, vtkFloatArray* data, int front,
    int blend = 0, int right = 0) override;
  unsigned char* GetRGBACharPixelData(
    int x, int y, int x2, int y2, int front, int right = 0) override;
  int GetRGBACharPixelData(int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data,
    int right = 0) override;
  int SetRGBACharPixelData(int x, int y, int x2, int y2, unsigned char* data, int front,
    int blend = 0, int right = 0) override;
  int SetRGBACharPixelData(int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front,
    int blend = 0, int right = 0) override;
  float* GetZbufferData(int x, int y, int x2, int y2) override;
  int GetZbufferData(int x, int y, int x2, int y2, float* z) override;
  int GetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z) override;
  int SetZbufferData(int x, int y, int x2, int y2, float* z) override;
  int SetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z) override;
  ///@}
#endif

protected:
  vtkEGLHeadlessRenderWindow();
  ~vtkEGLHeadlessRenderWindow() override;

#if !PointSplatting_VTK_HAS_EGL_WINDOW
  void CreateAWindow() override;
  void DestroyWindow() override;
  void OpenGLInitContext() override;
#endif

private:
  vtkEGLHeadlessRenderWindow(const vtkEGLHeadlessRenderWindow&) = delete;
  void operator=(const vtkEGLHeadlessRenderWindow&) = delete;

#if !PointSplatting_VTK_HAS_EGL_WINDOW
  /**
   * While one lives, the context is current, if there is one; what follows the outermost one is
   * Leave(), after a selection that is under way.
   */
  class Visit
  {
  public:
    explicit Visit(vtkEGLHeadlessRenderWindow* window);
    ~Visit();
    Visit(const Visit&) = delete;
    void operator=(const Visit&) = delete;
    /// Whether there is a context.
    explicit operator bool() const { return this->Open; }

  private:
    vtkEGLHeadlessRenderWindow* Window;
    bool Open;
  };

  /**
   * Gives the thread back to who had it; see the class.
   */
  void Leave();
#endif

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
