// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Reflection and refraction of an environment whose colours tell directions, against closed forms.
#include "SplatScene.h"

#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPlaneSource.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace
{
using namespace SplatScene;
using Colours = std::function<glm::dvec3(const glm::dvec3&)>; // of a direction, 0 to 1

// The environments: a direction as a colour, its x in all channels, all white, and white behind
// the camera (which looks along -z).
glm::dvec3 Directions(const glm::dvec3& d)
{
  return 0.5 + 0.5 * d;
}
glm::dvec3 OnlyX(const glm::dvec3& d)
{
  return glm::dvec3(0.5 + 0.5 * d.x);
}
glm::dvec3 White(const glm::dvec3&)
{
  return glm::dvec3(1.0);
}
glm::dvec3 WhiteBehind(const glm::dvec3& d)
{
  return glm::dvec3(d.z > 0.0 ? 1.0 : 0.0);
}

vtkSmartPointer<vtkImageData> Image(int width, int height, const Colours& colours,
  const std::function<glm::dvec3(double, double)>& direction)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const glm::dvec3 c = colours(direction((x + 0.5) / width, (y + 0.5) / height));
      for (int k = 0; k < 3; ++k)
      {
        *pixel++ = static_cast<unsigned char>(std::lround(255.0 * c[k]));
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkTexture> Equirectangular(const Colours& colours)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->InterpolateOn();
  texture->SetInputData(Image(1024, 512, colours, [](double u, double v) {
    const double a = 2.0 * M_PI * (u - 0.5);
    const double b = M_PI * (v - 0.5);
    return glm::dvec3(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
  }));
  return texture;
}

vtkSmartPointer<vtkTexture> Cube(const Colours& colours)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->CubeMapOn();
  texture->InterpolateOn();
  for (int face = 0; face < 6; ++face)
  {
    // The faces as OpenGL has them: +x, -x, +y, -y, +z, -z, each with its first row at the top.
    texture->SetInputDataObject(
      face, Image(256, 256, colours, [face](double u, double v) {
        const double s = 2.0 * u - 1.0;
        const double t = 2.0 * v - 1.0;
        const glm::dvec3 d[6] = { { 1, -t, -s }, { -1, -t, s }, { s, 1, t }, { s, -1, -t },
          { s, -t, 1 }, { -s, -t, -1 } };
        return glm::normalize(d[face]);
      }));
  }
  return texture;
}

double Fresnel(double n1, double n2, double cosine)
{
  const double sine2 = n1 / n2 * (n1 / n2) * (1.0 - cosine * cosine);
  if (sine2 >= 1.0)
  {
    return 1.0;
  }
  const double other = std::sqrt(1.0 - sine2);
  const double s = (n1 * cosine - n2 * other) / (n1 * cosine + n2 * other);
  const double p = (n2 * cosine - n1 * other) / (n2 * cosine + n1 * other);
  return 0.5 * (s * s + p * p);
}

/**
 * An eye's ray through a pixel's middle, world coordinates.
 */
struct Ray
{
  glm::dvec3 From;
  glm::dvec3 Along;
};
Ray RayOf(vtkRenderer* renderer, int x, int y)
{
  glm::dvec4 p[2];
  for (int i = 0; i < 2; ++i)
  {
    renderer->SetDisplayPoint(x + 0.5, y + 0.5, i);
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(&p[i].x);
    p[i] /= p[i].w;
  }
  return { glm::dvec3(p[0]), glm::normalize(glm::dvec3(p[1] - p[0])) };
}

/**
 * What a clear unit sphere at the origin shows; less than none where the ray's distance from the
 * centre is larger than reach. layers: bent once, by equation 12, with so many layers; 0: traced.
 */
glm::dvec3 OfSphere(const Ray& ray, double n, const Colours& colours, const glm::dvec3& absorption,
  int layers = 0, double reach = 0.9)
{
  const double b = glm::dot(ray.From, ray.Along);
  const double c = glm::dot(ray.From, ray.From) - 1.0;
  if (c + 1.0 - b * b > reach * reach)
  {
    return glm::dvec3(-1.0);
  }
  const glm::dvec3 in = ray.From + (-b - std::sqrt(b * b - c)) * ray.Along;
  const double share = Fresnel(1.0, n, -glm::dot(ray.Along, in));
  const glm::dvec3 reflected = share * colours(glm::reflect(ray.Along, in));
  if (layers > 0)
  {
    return reflected +
      (1.0 - share) * colours(glm::refract(ray.Along, in, std::pow(1.0 / n, layers)));
  }
  const glm::dvec3 inside = glm::refract(ray.Along, in, 1.0 / n);
  const double way = -2.0 * glm::dot(in, inside);
  const glm::dvec3 out = in + way * inside;
  const double back = Fresnel(n, 1.0, glm::dot(inside, out));
  return reflected +
    (1.0 - share) * glm::exp(-absorption * way) *
    (back * colours(glm::reflect(inside, -out)) +
      (1.0 - back) * colours(glm::refract(inside, -out, n)));
}

/**
 * Points on a square of side 2 about a point, its normal along z.
 */
vtkSmartPointer<vtkPolyData> Square(double z, double normal)
{
  return RandomCloud(20000, [z, normal](double u, double v, double* p, double* n) {
    p[0] = 2.0 * u - 1.0;
    p[1] = 2.0 * v - 1.0;
    p[2] = z;
    n[0] = n[1] = 0.0;
    n[2] = normal;
  });
}

vtkSmartPointer<vtkPolyData> Slab(double thickness)
{
  vtkSmartPointer<vtkPolyData> front = Square(0.5 * thickness, 1.0);
  vtkSmartPointer<vtkPolyData> back = Square(-0.5 * thickness, -1.0);
  for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i)
  {
    front->GetPoints()->InsertNextPoint(back->GetPoint(i));
    front->GetPointData()->GetNormals()->InsertNextTuple(
      back->GetPointData()->GetNormals()->GetTuple(i));
  }
  return front;
}

/**
 * A clear body in an environment.
 */
struct Scene : Window
{
  vtkNew<vtkPointSplatMapper> Mapper;
  vtkActor* Actor;
  Scene(vtkPolyData* points, vtkTexture* environment, double index)
  {
    this->Mapper->SetInputData(points);
    this->Mapper->RefractionOn();
    this->Mapper->SetRefractiveIndex(index);
    this->Actor = this->Add(this->Mapper);
    this->Actor->GetProperty()->SetOpacity(0.0);
    this->Renderer->SetEnvironmentTexture(environment);
    this->Renderer->ResetCamera();
  }
  void Turn(double azimuth, double elevation)
  {
    this->Renderer->GetActiveCamera()->Azimuth(azimuth);
    this->Renderer->GetActiveCamera()->Elevation(elevation);
    this->Renderer->ResetCameraClippingRange();
  }
  /**
   * Compares with the closed form where that is not negative: of the pixels, the share that
   * differs by more than some levels of 255 in a channel.
   */
  void Compare(Checks& checks, const std::string& what,
    const std::function<glm::dvec3(const Ray&)>& expected, double levels, double share)
  {
    const Picture picture = this->Draw();
    int compared = 0;
    int wrong = 0;
    double worst = 0.0;
    for (int y = 2; y < Size; y += 3)
    {
      for (int x = 2; x < Size; x += 3)
      {
        const glm::dvec3 e = expected(RayOf(this->Renderer, x, y));
        if (e.x >= 0.0)
        {
          const unsigned char* p = picture.At(x, y);
          const glm::dvec3 off = glm::abs(255.0 * e - glm::dvec3(p[0], p[1], p[2]));
          const double most = std::max({ off.x, off.y, off.z });
          worst = std::max(worst, most);
          wrong += most > levels;
          ++compared;
        }
      }
    }
    std::cout << what << ": " << wrong << " of " << compared << " off by more than " << levels
              << ", at worst " << worst << "\n";
    checks.AtLeast(compared, 500, what + ": pixels compared");
    checks.AtMost(static_cast<double>(wrong) / std::max(compared, 1), share,
      what + ": share of wrong pixels");
  }
};

const glm::dvec3 Clear(0.0);

void TestSphere(Checks& checks)
{
  const vtkSmartPointer<vtkPolyData> sphere = RandomSphere(30000);
  for (const bool parallel : { false, true })
  {
    for (const bool quads : { false, true })
    {
      for (const double n : { 1.0, 1.33, 1.5 })
      {
        Scene scene(sphere, Equirectangular(Directions), n);
        scene.Mapper->SetProjection(quads ? vtkPointSplatMapper::QUADS : 0);
        scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
        scene.Turn(25, 15);
        // With index 1, nothing but the lookup's rounding.
        scene.Compare(checks,
          "sphere of index " + std::to_string(n) + (parallel ? ", parallel" : ", perspective") +
            (quads ? ", quads" : ""),
          [n](const Ray& ray) { return OfSphere(ray, n, Directions, Clear); },
          n == 1.0 ? 1.0 : 3.0, n == 1.0 ? 0.0 : 0.001);
      }
    }
  }
  for (const int way : { vtkPointSplatMapper::SORTED, vtkPointSplatMapper::NEAREST_EXACT })
  {
    Scene scene(sphere, Equirectangular(Directions), 1.2);
    scene.Mapper->SetTransparency(way);
    scene.Turn(25, 15);
    scene.Compare(checks, way == vtkPointSplatMapper::SORTED ? "sorted" : "nearest exact",
      [](const Ray& ray) { return OfSphere(ray, 1.2, Directions, Clear, 2); }, 5.0, 0.01);
  }
  {
    Scene scene(sphere, Cube(Directions), 1.5);
    scene.Turn(25, 15);
    scene.Compare(checks, "cube map",
      [](const Ray& ray) { return OfSphere(ray, 1.5, Directions, Clear); }, 3.0, 0.001);
  }
  {
    // The picture's middle, which is to the right, is turned to -z; up stays.
    Scene scene(sphere, Equirectangular(Directions), 1.5);
    scene.Renderer->SetEnvironmentRight(0, 0, -1);
    scene.Turn(25, 15);
    const Colours turned = [](const glm::dvec3& d) {
      return Directions(glm::dvec3(-d.z, d.y, d.x));
    };
    scene.Compare(checks, "turned environment",
      [&](const Ray& ray) { return OfSphere(ray, 1.5, turned, Clear); }, 3.0, 0.001);
  }
  {
    // All light that comes in goes out, wherever it comes from, up to the outline.
    Scene scene(sphere, Equirectangular(White), 1.5);
    scene.Compare(checks, "white",
      [](const Ray& ray) { return OfSphere(ray, 1.5, White, Clear, 0, 0.98); }, 1.0, 0.0);
  }
  {
    const glm::dvec3 absorption(0.1, 0.5, 1.0);
    Scene scene(sphere, Equirectangular(White), 1.5);
    scene.Mapper->SetAbsorption(&absorption.x);
    scene.Compare(checks, "absorption",
      [&](const Ray& ray) { return OfSphere(ray, 1.5, White, absorption); }, 2.0, 0.001);
    scene.Mapper->SetRefractiveIndex(1.0);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    const Picture picture = scene.Draw();
    for (int c = 0; c < 3; ++c)
    {
      checks.AtMost(
        std::abs(picture.At(Size / 2, Size / 2)[c] - 255.0 * std::exp(-2.0 * absorption[c])), 1.5,
        "absorption through the centre");
    }
    scene.Mapper->SetAbsorption(-1.0, std::nan(""), 0.5);
    const double* a = scene.Mapper->GetAbsorption();
    checks.Expect(a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.5, "absorption that is no number");
  }
  {
    Scene scene(sphere, Equirectangular(OnlyX), 1.5);
    scene.Mapper->SetDispersion(0.1);
    auto closed = [](const Ray& ray) {
      const glm::dvec3 red = OfSphere(ray, 1.425, OnlyX, Clear);
      // What is reflected outside is so by the middle index.
      glm::dvec3 result = OfSphere(ray, 1.5, OnlyX, Clear);
      const glm::dvec3 blue = OfSphere(ray, 1.575, OnlyX, Clear);
      result.r = red.r;
      result.b = blue.b;
      return result;
    };
    scene.Compare(checks, "dispersion", closed, 4.0, 0.001);
    const Picture picture = scene.Draw();
    for (const int x : { Size / 2 - 60, Size / 2 + 60 })
    {
      const unsigned char* p = picture.At(x, Size / 2);
      checks.Expect((p[0] - p[1]) * (p[2] - p[1]) < 0, "red and blue go to opposite sides");
    }
  }
}

void TestPlanes(Checks& checks)
{
  const glm::dvec3 z(0.0, 0.0, 1.0);
  auto onSquare = [](const Ray& ray, double half) {
    const glm::dvec3 p = ray.From - ray.From.z / ray.Along.z * ray.Along;
    return std::abs(p.x) < half && std::abs(p.y) < half;
  };
  {
    // A surface with nothing behind it bends rays once.
    Scene scene(Square(0.0, 1.0), Equirectangular(Directions), 1.5);
    scene.Turn(30, 20);
    scene.Compare(checks, "one layer",
      [&](const Ray& ray) {
        const double share = Fresnel(1.0, 1.5, -glm::dot(ray.Along, z));
        return onSquare(ray, 0.9)
          ? share * Directions(glm::reflect(ray.Along, z)) +
            (1.0 - share) * Directions(glm::refract(ray.Along, z, 1.0 / 1.5))
          : glm::dvec3(-1.0);
      },
      2.0, 0.0);
  }
  {
    // A slab shifts rays, and does not turn them.
    Scene scene(Slab(0.3), Equirectangular(Directions), 1.5);
    scene.Turn(30, 20);
    scene.Compare(checks, "slab",
      [&](const Ray& ray) {
        const double share = Fresnel(1.0, 1.5, -glm::dot(ray.Along, z));
        const glm::dvec3 inside = glm::refract(ray.Along, z, 1.0 / 1.5);
        return onSquare(ray, 0.6) ? share * Directions(glm::reflect(ray.Along, z)) +
            (1.0 - share) *
              (share * Directions(glm::reflect(inside, z)) + (1.0 - share) * Directions(ray.Along))
                                  : glm::dvec3(-1.0);
      },
      2.0, 0.0);
  }
  // Fresnel's share at normal incidence; opaque surfaces reflect too.
  for (const double n : { 1.0, 1.5, 2.5, 4.0 })
  {
    const double share = (n - 1.0) / (n + 1.0) * ((n - 1.0) / (n + 1.0));
    for (const bool opaque : { true, false })
    {
      Scene scene(Slab(0.3), Equirectangular(WhiteBehind), n);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Actor->GetProperty()->SetOpacity(opaque ? 1.0 : 0.0);
      scene.Actor->GetProperty()->SetColor(0, 0, 0);
      scene.Actor->GetProperty()->SetSpecular(0.0);
      const double expected = opaque ? share : share + (1.0 - share) * share;
      scene.Compare(checks,
        "normal incidence on " + std::string(opaque ? "an opaque" : "a clear") + " slab",
        [&](const Ray& ray) {
          return onSquare(ray, 0.8) ? glm::dvec3(expected) : glm::dvec3(-1.0);
        },
        1.0, 0.0);
    }
  }
}

/**
 * Among other things: translucent meshes, an opaque one, other viewports, opacity, picking.
 */
void TestScenes(Checks& checks)
{
  const vtkSmartPointer<vtkPolyData> sphere = RandomSphere(30000);
  auto glass = [](const Ray& ray) { return OfSphere(ray, 1.5, Directions, Clear); };
  for (const bool peeling : { false, true })
  {
    // A translucent mesh beside the body, for which layers are not flattened.
    Scene scene(sphere, Equirectangular(Directions), 1.5);
    vtkNew<vtkPolyDataMapper> mesh;
    mesh->SetInputData(MakeSphereMesh());
    vtkActor* beside = scene.Add(mesh);
    beside->SetPosition(3.0, 0.0, 0.0);
    beside->GetProperty()->SetOpacity(0.5);
    scene.Renderer->SetUseDepthPeeling(peeling);
    scene.Compare(checks, peeling ? "interleaved, peeled" : "interleaved", glass,
      // Without depth peeling, layers are weighted and not sorted.
      peeling ? 3.0 : 5.0, 0.001);
  }
  {
    // Opaque things behind are seen straight.
    Scene scene(sphere, Equirectangular(Directions), 1.5);
    vtkNew<vtkPlaneSource> plane;
    vtkNew<vtkPolyDataMapper> mesh;
    mesh->SetInputConnection(plane->GetOutputPort());
    vtkActor* behind = scene.Add(mesh);
    behind->SetScale(8.0);
    behind->SetPosition(0.0, 0.0, -2.0);
    behind->GetProperty()->SetColor(0, 1, 0);
    behind->GetProperty()->LightingOff();
    behind->GetProperty()->SetAmbient(1.0);
    behind->GetProperty()->SetDiffuse(0.0);
    scene.Renderer->ResetCameraClippingRange();
    scene.Compare(checks, "opaque behind",
      [](const Ray& ray) {
        const glm::dvec3 reflections = OfSphere(
          ray, 1.5, [](const glm::dvec3& d) { return d.z > 0.0 ? Directions(d) : Clear; }, Clear);
        if (reflections.x < 0.0)
        {
          return reflections;
        }
        const double b = glm::dot(ray.From, ray.Along);
        const double c = glm::dot(ray.From, ray.From) - 1.0;
        const glm::dvec3 in = ray.From + (-b - std::sqrt(b * b - c)) * ray.Along;
        const double share = Fresnel(1.0, 1.5, -glm::dot(ray.Along, in));
        return share * Directions(glm::reflect(ray.Along, in)) +
          (1.0 - share) * glm::dvec3(0.0, 1.0, 0.0);
      },
      2.0, 0.0);
  }
  {
    // Equation 11: (1 - alpha)^2 of what comes through two layers.
    Scene scene(sphere, Equirectangular(White), 1.0);
    vtkProperty* property = scene.Actor->GetProperty();
    property->SetOpacity(0.3);
    property->SetColor(0, 0, 0);
    property->SetSpecular(0.0);
    scene.Compare(checks, "opacity",
      [](const Ray& ray) {
        const glm::dvec3 white = OfSphere(ray, 1.0, White, Clear);
        return white.x < 0.0 ? white : glm::dvec3(0.7 * 0.7);
      },
      1.0, 0.0);
  }
  {
    // Another renderer's environment is its own.
    Scene scene(sphere, Equirectangular(Directions), 1.5);
    vtkNew<vtkRenderer> other;
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(sphere);
    mapper->RefractionOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(0.0);
    other->AddActor(actor);
    other->SetEnvironmentTexture(Equirectangular(White));
    other->SetViewport(0.8, 0.8, 1.0, 1.0);
    scene.Win->AddRenderer(other);
    other->ResetCamera();
    const Picture picture = scene.Draw();
    const unsigned char* p = picture.At(9 * Size / 10, 9 * Size / 10);
    checks.Expect(p[0] == 255 && p[1] == 255 && p[2] == 255, "the other renderer's environment");
    scene.Compare(
      checks, "two renderers",
      [&](const Ray& ray) {
        // But where the other one is.
        scene.Renderer->SetWorldPoint(ray.From.x, ray.From.y, ray.From.z, 1.0);
        scene.Renderer->WorldToDisplay();
        const double* d = scene.Renderer->GetDisplayPoint();
        return d[0] > 0.8 * Size && d[1] > 0.8 * Size ? glm::dvec3(-1.0) : glass(ray);
      },
      3.0, 0.001);

    // VTK picks nothing whose opacity is 0.
    scene.Actor->GetProperty()->SetOpacity(0.01);
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetArea(Size / 2, Size / 2, Size / 2, Size / 2);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    checks.Expect(selection && selection->GetNumberOfNodes() == 1 &&
        selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == scene.Actor,
      "the body is picked");
  }
}

struct Counter : vtkCommand
{
  static Counter* New() { return new Counter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

/**
 * Off is as if it did not exist; on without an environment is off, with one warning.
 */
void TestOff(Checks& checks)
{
  const vtkSmartPointer<vtkPolyData> sphere = RandomSphere(20000);
  for (const int way : { vtkPointSplatMapper::PEELING, vtkPointSplatMapper::SORTED })
  {
    for (const double opacity : { 0.4, 1.0 })
    {
      auto draw = [&](bool environment, bool pictureInIt, bool on, bool toggled, int& warnings) {
        vtkNew<vtkTexture> empty;
        Scene scene(sphere, nullptr, 1.5);
        if (environment)
        {
          scene.Renderer->SetEnvironmentTexture(
            pictureInIt ? Equirectangular(Directions) : empty);
        }
        vtkNew<Counter> counter;
        scene.Mapper->AddObserver(vtkCommand::WarningEvent, counter);
        scene.Mapper->SetTransparency(way);
        scene.Mapper->SetRefraction(on);
        scene.Actor->GetProperty()->SetOpacity(opacity);
        if (toggled)
        {
          scene.Draw();
          scene.Mapper->SetRefraction(!on);
        }
        scene.Draw();
        const Picture picture = scene.Draw();
        warnings = counter->Count;
        return picture.Pixels;
      };
      int warnings = 0;
      const std::vector<unsigned char> plain = draw(false, false, false, false, warnings);
      checks.Expect(warnings == 0, "nothing to warn of");
      checks.Expect(draw(true, true, false, false, warnings) == plain && warnings == 0,
        "off, an environment changes nothing");
      checks.Expect(draw(true, true, true, false, warnings) != plain && warnings == 0,
        "on, it does");
      checks.Expect(draw(true, true, true, true, warnings) == plain, "switched off again");
      checks.Expect(draw(false, false, true, false, warnings) == plain && warnings == 1,
        "no environment: off, with one warning");
      checks.Expect(draw(true, false, true, false, warnings) == plain && warnings == 1,
        "an environment without a picture: off, with one warning");
    }
  }
}

/**
 * A mapper in two renderers, of which one has no environment, warns of that once, not with
 * every frame again.
 */
void TestTwoRenderers(Checks& checks)
{
  Scene scene(RandomSphere(2000), Equirectangular(White), 1.5);
  vtkNew<vtkRenderer> other;
  other->AddActor(scene.Actor);
  other->SetViewport(0.8, 0.8, 1.0, 1.0);
  scene.Win->AddRenderer(other);
  other->ResetCamera();
  vtkNew<Counter> counter;
  scene.Mapper->AddObserver(vtkCommand::WarningEvent, counter);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Draw();
  }
  checks.Expect(counter->Count == 1, "one of two renderers without an environment: one warning");
}
}

int TestSplatsRefraction(int, char*[])
{
  Checks checks;
  TestSphere(checks);
  TestPlanes(checks);
  TestScenes(checks);
  TestOff(checks);
  TestTwoRenderers(checks);
  return checks.Result();
}
