// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A window with one actor, and what tests measure of its picture.
#ifndef SplatScene_h
#define SplatScene_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkFloatArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace SplatScene
{
constexpr int Size = 300;

struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; // RGB
  const unsigned char* At(int x, int y) const { return &this->Pixels[3 * (y * this->Width + x)]; }
  bool IsBackground(int x, int y) const
  {
    const unsigned char* p = this->At(x, y);
    return p[0] == 0 && p[1] == 0 && p[2] == 0;
  }
  int CountDrawn() const
  {
    int count = 0;
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        count += !this->IsBackground(x, y);
      }
    }
    return count;
  }
};

inline Picture Read(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetSize()[0];
  picture.Height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, picture.Width - 1, picture.Height - 1, 0, pixels);
  picture.Pixels.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return picture;
}

/**
 * A window on a black background.
 */
struct Window
{
  vtkNew<vtkEGLHeadlessRenderWindow> Win;
  vtkNew<vtkRenderer> Renderer;
  // Pictures are held pixel by pixel against such as have no smooth outlines: those of meshes in
  // framebuffers with one sample, and of splats that are drawn by quads.
  bool SmoothOutlines = false;

  explicit Window(int size = Size)
  {
    this->Win->SetSize(size, size);
    this->Win->SetMultiSamples(0);
    this->Win->AddRenderer(this->Renderer);
  }
  vtkActor* Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9, 0.6, 0.4);
    actor->GetProperty()->SetSpecular(0.4);
    actor->GetProperty()->SetSpecularPower(20);
    actor->GetProperty()->SetAmbient(0.1);
    if (auto splats = vtkPointSplatMapper::SafeDownCast(mapper))
    {
      splats->SetAntiAliasing(splats->GetAntiAliasing() &&
        (this->SmoothOutlines || splats->GetMethod() == vtkPointSplatMapper::IMAGE_SPACE));
    }
    this->Renderer->AddActor(actor);
    return actor;
  }
  Picture Draw()
  {
    this->Win->Render();
    return Read(this->Win);
  }
  /**
   * Distance along the view axis at a pixel; 0 where nothing is drawn.
   */
  std::vector<double> Depth()
  {
    const int* size = this->Win->GetSize();
    vtkNew<vtkFloatArray> z;
    this->Win->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, z);
    double n, f;
    this->Renderer->GetActiveCamera()->GetClippingRange(n, f);
    const bool parallel = this->Renderer->GetActiveCamera()->GetParallelProjection() != 0;
    std::vector<double> depth;
    for (vtkIdType i = 0; i < z->GetNumberOfValues(); ++i)
    {
      const double d = z->GetValue(i);
      depth.push_back(d >= 1.0 ? 0.0 : parallel ? n + d * (f - n) : n * f / (f - d * (f - n)));
    }
    return depth;
  }
};

/**
 * Peak signal to noise ratio in dB over the pixels that either picture draws, outlines and all.
 */
inline double Psnr(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  long count = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      if (a.IsBackground(x, y) && b.IsBackground(x, y))
      {
        continue;
      }
      for (int c = 0; c < 3; ++c)
      {
        const double d = double(a.At(x, y)[c]) - b.At(x, y)[c];
        sum += d * d;
        ++count;
      }
    }
  }
  return count == 0 ? 0.0 : 10.0 * std::log10(255.0 * 255.0 / std::max(sum / count, 1e-9));
}

/**
 * Pixels that one draws and the other does not.
 */
inline int CountDifferentCoverage(const Picture& a, const Picture& b)
{
  int count = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      count += a.IsBackground(x, y) != b.IsBackground(x, y);
    }
  }
  return count;
}

inline vtkSmartPointer<vtkPolyData> MakeSphereMesh(int resolution = 200)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution / 2);
  source->Update();
  return source->GetOutput();
}

/**
 * Points and normals of a data set, nothing else.
 */
inline vtkSmartPointer<vtkPolyData> Cloud(vtkPolyData* mesh)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(mesh->GetPoints());
  cloud->GetPointData()->SetNormals(mesh->GetPointData()->GetNormals());
  return cloud;
}

/**
 * A cloud with sizes and fill points, which each mapper else makes anew.
 */
inline vtkSmartPointer<vtkPolyData> Estimated(vtkPolyData* cloud)
{
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(cloud);
  estimation->FillGapsOn();
  estimation->Update();
  return estimation->GetOutput();
}

/**
 * Points drawn at random from a surface: place(u, v, position, normal).
 */
inline vtkSmartPointer<vtkPolyData> RandomCloud(
  int count, const std::function<void(double, double, double*, double*)>& place)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const double u = random->GetNextValue();
    const double v = random->GetNextValue();
    double p[3], n[3];
    place(u, v, p, n);
    points->InsertNextPoint(p);
    normals->InsertNextTuple(n);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  return cloud;
}

inline vtkSmartPointer<vtkPolyData> RandomSphere(int count)
{
  return RandomCloud(count, [](double u, double v, double* p, double* n) {
    const double z = 2.0 * u - 1.0;
    const double r = std::sqrt(1.0 - z * z);
    n[0] = r * std::cos(2.0 * M_PI * v);
    n[1] = r * std::sin(2.0 * M_PI * v);
    n[2] = z;
    std::copy(n, n + 3, p);
  });
}

/// The same data set, its points scaled about the origin and moved along x.
inline vtkSmartPointer<vtkPolyData> Moved(vtkSmartPointer<vtkPolyData> data, double scale, double x)
{
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    points->InsertNextPoint(scale * p[0] + x, scale * p[1], scale * p[2]);
  }
  data->SetPoints(points);
  return data;
}

/// Counts an algorithm's progress that is not its end.
struct ProgressCounter : vtkCommand
{
  static ProgressCounter* New() { return new ProgressCounter; }
  void Execute(vtkObject*, unsigned long, void* amount) override
  {
    this->Partial += *static_cast<double*>(amount) < 1.0;
  }
  int Partial = 0;
};

/**
 * About z, of major radius 1.
 */
inline vtkSmartPointer<vtkPolyData> RandomTorus(int count, double minor = 0.4)
{
  return RandomCloud(count, [minor](double u, double v, double* p, double* n) {
    const double a = 2.0 * M_PI * u;
    const double b = 2.0 * M_PI * v;
    n[0] = std::cos(b) * std::cos(a);
    n[1] = std::cos(b) * std::sin(a);
    n[2] = std::sin(b);
    p[0] = std::cos(a) + minor * n[0];
    p[1] = std::sin(a) + minor * n[1];
    p[2] = minor * n[2];
  });
}

/**
 * A square of side 4 in z = 0.
 */
inline vtkSmartPointer<vtkPolyData> RandomSquare(int count)
{
  return RandomCloud(count, [](double u, double v, double* p, double* n) {
    p[0] = 4.0 * u - 2.0;
    p[1] = 4.0 * v - 2.0;
    p[2] = n[0] = n[1] = 0.0;
    n[2] = 1.0;
  });
}

/**
 * Collects what is not as it should be, and tells all figures.
 */
struct Checks
{
  int Failures = 0;
  void Expect(bool good, const std::string& what)
  {
    if (!good)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Failures;
    }
  }
  template <typename T>
  void AtLeast(T value, T bound, const std::string& what)
  {
    std::cout << what << ": " << value << ", at least " << bound << "\n";
    this->Expect(value >= bound,
      what + ": " + std::to_string(value) + " is less than " + std::to_string(bound));
  }
  template <typename T>
  void AtMost(T value, T bound, const std::string& what)
  {
    std::cout << what << ": " << value << ", at most " << bound << "\n";
    this->Expect(value <= bound,
      what + ": " + std::to_string(value) + " is more than " + std::to_string(bound));
  }
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }
};

/// Of the channels of all pixels.
inline int LargestDifference(const Picture& a, const Picture& b)
{
  int largest = 0;
  for (size_t i = 0; i < a.Pixels.size(); ++i)
  {
    largest = std::max(largest, std::abs(int(a.Pixels[i]) - int(b.Pixels[i])));
  }
  return largest;
}

/// Of all pixels, whatever they show.
inline double PsnrOfAll(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.Pixels.size(); ++i)
  {
    const double d = double(a.Pixels[i]) - b.Pixels[i];
    sum += d * d;
  }
  return 10.0 * std::log10(255.0 * 255.0 * a.Pixels.size() / std::max(sum, 1e-9));
}
}

#endif
