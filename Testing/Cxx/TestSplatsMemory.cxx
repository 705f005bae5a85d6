// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand frames in which everything changes: the process has no more memory, and the
// context no more OpenGL objects, than after the first hundreds.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkPointSplatShadowPass.h"
#include "vtkPointSplattingOpenGL.h"
#include "vtkSelection.h"
#include "vtkTexture.h"

#include <fstream>
#include <memory>
#include <set>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace
{
using namespace SplatScene;

// The address sanitizer keeps what was freed, and is for other faults.
#if defined(__SANITIZE_ADDRESS__)
constexpr int Frames = 400;
constexpr bool MeasureMemory = false;
#else
constexpr int Frames = 10000;
constexpr bool MeasureMemory = true;
#endif
// After these every program is built and every image has had its largest size.
constexpr int FirstFrames = 200;
// Frames after which everything is as it was this many frames before.
constexpr int Cycle = 40;
// KiB. One lost image of 16 x 16 pixels and 20 bytes a pixel in a hundred frames would be 450, one
// lost 96 bytes a frame 850; what allocators keep moves by tens.
constexpr long MostGrowth = 400;
constexpr GLuint MostNames = 3000;

/**
 * KiB that are resident, without what the allocator keeps for later. -1 where that is not told.
 */
long Resident()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
  {
    if (line.compare(0, 6, "VmRSS:") == 0)
    {
      return std::stol(line.substr(6));
    }
  }
  return -1;
}

/**
 * Bytes in use by allocations, which does not depend on what pages they lie on; -1 where
 * that is not told.
 */
long Allocated()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 info = mallinfo2();
  return static_cast<long>((info.uordblks + info.hblkhd) / 1024);
#else
  return -1;
#endif
}

/**
 * The context's objects.
 */
struct Objects
{
  int Buffers = 0;
  int Textures = 0;
  int Programs = 0;
  int Framebuffers = 0;
  int Arrays = 0;

  explicit Objects(vtkRenderWindow* window)
  {
    window->MakeCurrent();
    for (GLuint name = 1; name < MostNames; ++name)
    {
      this->Buffers += glIsBuffer(name);
      this->Textures += glIsTexture(name);
      this->Programs += glIsProgram(name);
      this->Framebuffers += glIsFramebuffer(name);
      this->Arrays += glIsVertexArray(name);
    }
  }
  bool NoMoreThan(const Objects& other) const
  {
    return this->Buffers <= other.Buffers && this->Textures <= other.Textures &&
      this->Programs <= other.Programs && this->Framebuffers <= other.Framebuffers &&
      this->Arrays <= other.Arrays;
  }
  std::string Text() const
  {
    return std::to_string(this->Buffers) + " buffers, " + std::to_string(this->Textures) +
      " textures, " + std::to_string(this->Programs) + " programs, " +
      std::to_string(this->Framebuffers) + " framebuffers, " + std::to_string(this->Arrays) +
      " vertex arrays";
  }
};

/**
 * What takes turns in the window.
 */
struct Cast
{
  vtkActor* Steady;
  vtkActor* Guest;
  vtkPolyData* Small;
  vtkPolyData* Large;
  vtkLight* Lamp;
  vtkTexture* Environment;
};

vtkSmartPointer<vtkTexture> MakeEnvironment()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(150.0);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

/**
 * What one frame in a cycle changes.
 */
void Change(Window& window, int frame, const Cast& cast)
{
  vtkActor* steady = cast.Steady;
  vtkActor* guest = cast.Guest;
  vtkPolyData* small = cast.Small;
  vtkPolyData* large = cast.Large;
  vtkPointSplatMapper* mapper = vtkPointSplatMapper::SafeDownCast(steady->GetMapper());
  switch (frame % Cycle)
  {
    case 0:
      window.Win->SetSize(24, 20);
      break;
    case 2:
      mapper->SetMethodToImageSpace();
      break;
    case 4:
      window.Win->SetSize(20, 24);
      mapper->SetMethodToTwoPass();
      break;
    case 6:
      mapper->SetInputData(large);
      break;
    case 8:
    {
      // New arrays in the same data.
      vtkNew<vtkFloatArray> colours;
      colours->SetName("colours");
      colours->SetNumberOfTuples(large->GetNumberOfPoints());
      for (vtkIdType i = 0; i < large->GetNumberOfPoints(); ++i)
      {
        colours->SetValue(i, static_cast<float>(i + frame));
      }
      large->GetPointData()->SetScalars(colours);
      large->Modified();
      break;
    }
    case 10:
      mapper->SetProjectionToQuads();
      break;
    case 11:
      mapper->SetMethodToImageSpace();
      break;
    case 12:
      mapper->SetMethodToDeferred();
      break;
    case 14:
      mapper->SetMethodToTwoPass();
      mapper->SetProjectionToAutomatic();
      break;
    case 16:
      steady->GetProperty()->SetOpacity(0.5);
      break;
    case 18:
      mapper->SetTransparencyToSorted();
      break;
    case 20:
      mapper->SetTransparencyToNearestExact();
      break;
    case 22:
      mapper->SetTransparencyToPeeling();
      window.Renderer->AddActor(guest);
      break;
    case 23:
      // Glass, with what it reflects.
      mapper->RefractionOn();
      window.Renderer->SetEnvironmentTexture(cast.Environment);
      break;
    case 24:
      mapper->RefractionOff();
      window.Renderer->SetEnvironmentTexture(nullptr);
      steady->GetProperty()->SetOpacity(1.0);
      large->GetPointData()->SetScalars(nullptr);
      break;
    case 26:
    {
      // A mapper that goes while its actor stays.
      vtkNew<vtkPointSplatMapper> other;
      other->SetInputData(small);
      guest->SetMapper(other);
      break;
    }
    case 28:
      // A point light, and an area light.
      mapper->ShadowsOn();
      window.Renderer->AddLight(cast.Lamp);
      break;
    case 29:
      mapper->SetNumberOfShadowSamples(3);
      mapper->SetShadowLightRadius(0.2);
      // On meshes, too, and of translucent splats.
      window.Renderer->SetPass(vtkNew<vtkPointSplatShadowPass>());
      steady->GetProperty()->SetOpacity(0.5);
      break;
    case 30:
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(window.Renderer);
      selector->SetArea(5, 5, 10, 10);
      selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
      vtkSmartPointer<vtkSelection>::Take(selector->Select());
      break;
    }
    case 31:
      mapper->SetMethodToImageSpace();
      break;
    case 32:
      mapper->SetMethodToTwoPass();
      mapper->ShadowsOff();
      mapper->SetNumberOfShadowSamples(1);
      mapper->SetShadowLightRadius(0.0);
      window.Renderer->SetPass(nullptr);
      steady->GetProperty()->SetOpacity(1.0);
      window.Renderer->RemoveLight(cast.Lamp);
      window.Renderer->RemoveActor(guest);
      break;
    case 34:
      steady->ReleaseGraphicsResources(window.Win);
      break;
    case 36:
      mapper->SetInputData(small);
      break;
    default:
      window.Renderer->GetActiveCamera()->SetPosition(
        4 * std::sin(frame % Cycle), 0, 4 * std::cos(frame % Cycle));
      break;
  }
}
}

int TestSplatsMemory(int, char*[])
{
  Checks checks;
  Window window(20);
  vtkSmartPointer<vtkPolyData> small = RandomSphere(60);
  vtkSmartPointer<vtkPolyData> large = RandomSphere(100);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(small);
  vtkNew<vtkPointSplatMapper> guestMapper;
  guestMapper->SetInputData(small);
  vtkActor* steady = window.Add(mapper);
  vtkSmartPointer<vtkActor> guest = window.Add(guestMapper);
  window.Renderer->RemoveActor(guest);
  window.Renderer->ResetCamera();
  window.Renderer->CreateLight(); // of its own; there is none where others are
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(3, 2, 4);
  lamp->PositionalOn();
  const vtkSmartPointer<vtkTexture> environment = MakeEnvironment();
  const Cast cast{ steady, guest, small, large, lamp, environment };

  long resident = 0;
  long allocated = 0;
  std::unique_ptr<Objects> objects;
  std::set<std::string> done;
  for (int frame = 0; frame <= Frames; ++frame)
  {
    Change(window, frame, cast);
    window.Win->Render();
    if (frame < Cycle)
    {
      done.insert(std::string(mapper->GetMethodUsed()) + ", " + mapper->GetProjectionUsed());
      done.insert(mapper->GetTransparencyUsed());
    }
    if (frame != FirstFrames && frame != Frames)
    {
      continue;
    }
    std::unique_ptr<Objects> now(new Objects(window.Win));
    const long residentNow = Resident();
    const long allocatedNow = Allocated();
    std::cout << "frame " << frame << ": " << residentNow << " KiB resident, " << allocatedNow
              << " KiB allocated, " << now->Text() << "\n";
    if (frame == Frames)
    {
      checks.Expect(now->NoMoreThan(*objects),
        "OpenGL objects: " + now->Text() + ", more than " + objects->Text());
      if (MeasureMemory)
      {
        checks.AtMost(residentNow - resident, MostGrowth, "KiB resident more");
        checks.AtMost(allocatedNow - allocated, MostGrowth, "KiB allocated more");
      }
    }
    objects = std::move(now);
    resident = residentNow;
    allocated = allocatedNow;
  }
  for (const char* what : { "two-pass, compute", "two-pass, quads", "image-space, compute",
         "image-space, quads", "deferred, quads", "none", "peeling", "sorted", "nearest-exact" })
  {
    checks.Expect(done.count(what) == 1, std::string("never drawn: ") + what);
  }
  checks.AtLeast(mapper->GetNumberOfShadowUpdates(), 2ul, "updates of shadows");
  return checks.Result();
}
