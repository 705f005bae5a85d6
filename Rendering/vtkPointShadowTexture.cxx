// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointShadowTexture.h"

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCloud.h"
#include "vtkPointSplatShadows.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPointShadowTexture);

struct vtkPointShadowTexture::vtkInternals
{
  vtkSmartPointer<vtkRenderWindow> Given;
  vtkSmartPointer<vtkRenderWindow> Own;
};

//------------------------------------------------------------------------------
vtkPointShadowTexture::vtkPointShadowTexture()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkPointShadowTexture::~vtkPointShadowTexture() = default;

//------------------------------------------------------------------------------
void vtkPointShadowTexture::AddLight(vtkLight* light)
{
  if (light)
  {
    this->Lights.emplace_back(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPointShadowTexture::RemoveAllLights()
{
  if (!this->Lights.empty())
  {
    this->Lights.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkPointShadowTexture::GetNumberOfLights()
{
  return static_cast<int>(this->Lights.size());
}

//------------------------------------------------------------------------------
vtkLight* vtkPointShadowTexture::GetLight(int index)
{
  return index >= 0 && index < this->GetNumberOfLights() ? this->Lights[static_cast<size_t>(index)]
                                                         : nullptr;
}

//------------------------------------------------------------------------------
void vtkPointShadowTexture::AddOccluderData(vtkPolyData* mesh)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->AddInputConnection(1, producer->GetOutputPort());
}

//------------------------------------------------------------------------------
void vtkPointShadowTexture::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->Internals->Given != window)
  {
    this->Internals->Given = window;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkPointShadowTexture::GetRenderWindow()
{
  return this->Internals->Given;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointShadowTexture::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkLight* light : this->Lights)
  {
    time = std::max(time, light->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkPointShadowTexture::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointShadowTexture::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (vtkPolyData::SafeDownCast(input))
  {
    output->ShallowCopy(input);
  }
  else
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    output->GetFieldData()->PassData(input->GetFieldData());
  }
  output->GetPointData()->RemoveArray(vtkPointSplatArrays::Shadow);
  this->LayerDistanceUsed = this->PixelSizeUsed = 0.0;
  this->ResolutionUsed = 0;
  if (this->Lights.empty())
  {
    vtkErrorMacro("There are no lights: call AddLight().");
    return 1;
  }
  for (vtkLight* light : this->Lights)
  {
    if (!vtkPointSplatShadowLight::From(light, 0.0).IsFinite())
    {
      vtkErrorMacro("A light's position or focal point is not finite: set both.");
      return 1;
    }
  }
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  if (normals &&
    (normals->GetNumberOfTuples() != input->GetNumberOfPoints() ||
      normals->GetNumberOfComponents() != 3))
  {
    vtkErrorMacro("The point normals " << (normals->GetName() ? normals->GetName() : "")
                                       << " have " << normals->GetNumberOfTuples()
                                       << " tuples for " << input->GetNumberOfPoints()
                                       << " points: remove them, or give one for each point.");
    return 1;
  }
  if (input->GetNumberOfPoints() > 0)
  {
    this->Compute(input, inputs[1], output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPointShadowTexture::Compute(
  vtkPointSet* input, vtkInformationVector* meshes, vtkPolyData* output)
{
  if (!this->Internals->Given && !this->Internals->Own)
  {
    this->Internals->Own = vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();
    this->Internals->Own->SetSize(16, 16);
  }
  vtkRenderWindow* any = this->Internals->Given ? this->Internals->Given : this->Internals->Own;
  auto window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (window && window->GetNeverRendered())
  {
    window->Render(); // which makes the context
  }
  if (window)
  {
    window->MakeCurrent();
  }
  if (!window || !window->IsCurrent())
  {
    vtkErrorMacro("There is no OpenGL context: give SetRenderWindow() a window that has one.");
    return false;
  }
  const vtkPointSplatContextScope scope(window);

  vtkPointSplatCloud cloud;
  vtkPointSplatCloudInput points;
  points.Data = input;
  points.Owner = this;
  cloud.Update(points);
  this->UpdateProgress(0.3);
  vtkPointSplatShadowScene scene;
  scene.Clouds.resize(1);
  scene.Clouds[0].Cloud = &cloud;
  for (int i = 0; i < meshes->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkPolyData* mesh = vtkPolyData::GetData(meshes, i))
    {
      scene.Meshes.push_back({ mesh, glm::dmat4(1.0), {} });
    }
  }
  vtkPointSplatShadowSettings settings;
  settings.Samples = this->NumberOfSamples;
  settings.LayerDistance = this->LayerDistance;
  settings.Resolution = this->Resolution;
  settings.Compute = this->UseComputeShaders;

  const int lights = this->GetNumberOfLights();
  vtkNew<vtkFloatArray> factors;
  factors->SetName(vtkPointSplatArrays::Shadow);
  factors->SetNumberOfComponents(lights);
  factors->SetNumberOfTuples(input->GetNumberOfPoints());
  factors->FillValue(1.0f);
  const std::vector<vtkPointSplatCopies::Copy> copies = cloud.GetCopies();
  vtkPointSplatShadows shadows;
  bool good = true;
  for (int i = 0; i < lights && good; ++i)
  {
    settings.Seed = static_cast<unsigned int>(this->Seed + i);
    std::vector<std::vector<float>> result;
    good = shadows.Cast(vtkPointSplatShadowLight::From(this->GetLight(i), this->LightRadius),
      scene, settings, result);
    for (size_t k = 0; k < result[0].size(); ++k)
    {
      factors->SetTypedComponent(cloud.GetPointId(static_cast<vtkIdType>(k)), i, result[0][k]);
    }
    for (const vtkPointSplatCopies::Copy& copy : copies)
    {
      factors->SetTypedComponent(copy.Point, i, factors->GetTypedComponent(copy.Of, i));
    }
    this->UpdateProgress(0.3 + 0.7 * (i + 1) / lights);
    if (this->GetAbortExecute())
    {
      break;
    }
  }
  this->LayerDistanceUsed = shadows.GetLayerDistanceUsed();
  this->PixelSizeUsed = shadows.GetPixelSizeUsed();
  this->ResolutionUsed = shadows.GetResolutionUsed();
  if (good)
  {
    output->GetPointData()->AddArray(factors);
  }
  else
  {
    vtkErrorMacro("OpenGL cannot compute the shadows: " << shadows.GetError());
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkPointShadowTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLights: " << this->GetNumberOfLights() << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "LightRadius: " << this->LightRadius << "\n";
  os << indent << "LayerDistance: " << this->LayerDistance << " (used: " << this->LayerDistanceUsed
     << ")\n";
  os << indent << "Resolution: " << this->Resolution << " (used: " << this->ResolutionUsed << ")\n";
  os << indent << "PixelSizeUsed: " << this->PixelSizeUsed << "\n";
  os << indent << "UseComputeShaders: " << (this->UseComputeShaders ? "On" : "Off") << "\n";
  os << indent << "RenderWindow: " << this->Internals->Given << "\n";
}
VTK_ABI_NAMESPACE_END
