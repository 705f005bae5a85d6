// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The curvature of splats: its estimation against surfaces whose second fundamental
// form is known, and that splats which bend by it do not stand out over silhouettes.
#include "SplatScene.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"

#include <algorithm>
#include <limits>

namespace
{
using namespace SplatScene;

vtkSmartPointer<vtkPolyData> Estimated(vtkPolyData* cloud)
{
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(cloud);
  estimation->Update();
  return estimation->GetOutput();
}

/**
 * The mean over all points of the form along a direction that a point gives, times the
 * sign of the point's normal against the outward one.
 */
double MeanForm(vtkPolyData* cloud,
  const std::function<void(const double* p, double* outward, double* direction)>& frame)
{
  vtkDataArray* curvature = cloud->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
  double sum = 0.0;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double c[6], n[3], p[3], outward[3], t[3];
    curvature->GetTuple(i, c);
    cloud->GetPointData()->GetNormals()->GetTuple(i, n);
    cloud->GetPoint(i, p);
    frame(p, outward, t);
    const double form = c[0] * t[0] * t[0] + c[1] * t[1] * t[1] + c[2] * t[2] * t[2] +
      2.0 * (c[3] * t[0] * t[1] + c[4] * t[1] * t[2] + c[5] * t[0] * t[2]);
    sum += vtkMath::Dot(n, outward) < 0.0 ? -form : form;
  }
  return sum / cloud->GetNumberOfPoints();
}

void Estimation(Checks& checks)
{
  // A cylinder of radius 0.5, every other normal turned inward.
  bool inward = false;
  auto cylinder = Estimated(RandomCloud(5000, [&inward](double u, double v, double* p, double* n) {
    inward = !inward;
    const double sign = inward ? -1.0 : 1.0;
    p[0] = 0.5 * std::cos(2.0 * M_PI * u);
    p[1] = 0.5 * std::sin(2.0 * M_PI * u);
    p[2] = 3.0 * v;
    n[0] = 2.0 * sign * p[0];
    n[1] = 2.0 * sign * p[1];
    n[2] = 0.0;
  }));
  const double around = MeanForm(cylinder, [](const double* p, double* outward, double* t) {
    outward[0] = 2.0 * p[0];
    outward[1] = 2.0 * p[1];
    t[0] = -outward[1];
    t[1] = outward[0];
    t[2] = outward[2] = 0.0;
  });
  const double along = MeanForm(cylinder, [](const double* p, double* outward, double* t) {
    outward[0] = 2.0 * p[0];
    outward[1] = 2.0 * p[1];
    outward[2] = t[0] = t[1] = 0.0;
    t[2] = 1.0;
  });
  std::cout << "cylinder: curvature around " << around << ", along " << along << "\n";
  // A tenth is left out on purpose.
  checks.AtLeast(around, 1.7, "cylinder: curvature around");
  checks.AtMost(around, 2.0, "cylinder: curvature around");
  checks.AtMost(std::abs(along), 0.05, "cylinder: curvature along");

  auto plane = Estimated(RandomCloud(1000, [](double u, double v, double* p, double* n) {
    p[0] = u;
    p[1] = v;
    p[2] = n[0] = n[1] = 0.0;
    n[2] = 1.0;
  }));
  double range[2];
  double greatest = 0.0;
  for (int k = 0; k < 6; ++k)
  {
    plane->GetPointData()->GetArray(vtkPointSplatArrays::Curvature)->GetRange(range, k);
    greatest = std::max({ greatest, std::abs(range[0]), std::abs(range[1]) });
  }
  checks.AtMost(greatest, 1e-3, "plane: curvature");

  // A filter that is given curvature gives its own.
  checks.Expect(!Estimated(cylinder)->GetPointData()->GetArray("SplatAxis1") &&
      Estimated(cylinder)->GetPointData()->GetArray(vtkPointSplatArrays::Curvature),
    "estimation of what is estimated");
}

/**
 * Pixels drawn outside the unit sphere's outline, holes, and the mean depth error inside, in
 * parallel projection along z, stretched and mirrored by the actor.
 */
void Outline(vtkPolyData* cloud, bool quads, const double scale[3], long& outside, long& holes,
  double& error)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cloud);
  if (quads)
  {
    mapper->SetProjectionToQuads();
  }
  window.Add(mapper)->SetScale(scale[0], scale[1], scale[2]);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 5);
  camera->SetFocalPoint(0, 0, 0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.2);
  camera->SetClippingRange(1, 9);
  window.Draw();
  const std::vector<double> depth = window.Depth();
  outside = holes = 0;
  error = 0.0;
  long inside = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double p = 1.2 * (2.0 * (x + 0.5) / Size - 1.0) / scale[0];
      const double q = 1.2 * (2.0 * (y + 0.5) / Size - 1.0) / scale[1];
      const double drawn = depth[static_cast<size_t>(y) * Size + x];
      const double squared = p * p + q * q;
      outside += squared > 1.0 && drawn > 0.0;
      holes += squared < 0.97 * 0.97 && drawn == 0.0;
      if (squared < 0.9 * 0.9 && drawn > 0.0)
      {
        error += std::abs(drawn - (5.0 - std::abs(scale[2]) * std::sqrt(1.0 - squared)));
        ++inside;
      }
    }
  }
  error /= inside;
}

void Silhouettes(Checks& checks)
{
  auto bent = Estimated(RandomSphere(2000));
  vtkNew<vtkPolyData> flat;
  flat->ShallowCopy(bent);
  flat->GetPointData()->RemoveArray(vtkPointSplatArrays::Curvature);
  const double scales[3][3] = { { 1, 1, 1 }, { 1, 0.6, 1.3 }, { -1, 1, 1 } };
  for (const auto& scale : scales)
  {
    for (const bool quads : { false, true })
    {
      long outside[2], holes[2];
      double error[2];
      Outline(flat, quads, scale, outside[0], holes[0], error[0]);
      Outline(bent, quads, scale, outside[1], holes[1], error[1]);
      const std::string name = std::string(quads ? "quads" : "compute") + ", scale " +
        std::to_string(scale[0]) + " " + std::to_string(scale[1]);
      std::cout << name << ": outside " << outside[0] << " flat, " << outside[1]
                << " bent; depth error " << error[0] << ", " << error[1] << "\n";
      checks.AtLeast(outside[0], 100L, name + ": drawn outside by flat splats");
      checks.AtMost(4 * outside[1], outside[0], name + ": drawn outside");
      checks.AtMost(holes[1], 0L, name + ": holes");
      checks.AtMost(3.0 * error[1], error[0], name + ": depth error");
    }
  }
}

/**
 * Splats whose curvature is not finite are flat, the others as ever.
 */
void BadCurvature(Checks& checks)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double bad[3] = { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity };
  const double scale[3] = { 1, 1, 1 };
  long outside[2], holes[2];
  double error[2];
  for (const bool spoilt : { false, true })
  {
    auto cloud = Estimated(RandomSphere(2000));
    vtkDataArray* curvature = cloud->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
    for (vtkIdType i = 0; i < 300; ++i)
    {
      for (int k = 0; k < 6; ++k)
      {
        curvature->SetComponent(i, k, spoilt && k == i % 6 ? bad[i % 3] : 0.0);
      }
    }
    Outline(cloud, false, scale, outside[spoilt], holes[spoilt], error[spoilt]);
  }
  checks.AtMost(std::abs(outside[1] - outside[0]), 0L, "bad curvature: drawn outside");
  checks.AtMost(holes[1], 0L, "bad curvature: holes");
  checks.AtMost(std::abs(error[1] - error[0]), 1e-9, "bad curvature: depth error");
}
}

int TestSplatsCurvature(int, char*[])
{
  Checks checks;
  Estimation(checks);
  Silhouettes(checks);
  BadCurvature(checks);
  return checks.Result();
}
