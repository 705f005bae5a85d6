// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleSurfacePoints.h"

#include "vtkArrayListTemplate.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkParticleSurface.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatInput.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkParticleSurfacePoints);

namespace
{
const char* const sizeNames[3] = { "smoothing length", "mass", "density" };

std::string GetLower(const char* name)
{
  std::string lower = name ? name : "";
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// The first array with one number a particle and one of the names that an index has.
vtkDataArray* FindByName(vtkPointData* data, int index, vtkIdType number)
{
  static const std::vector<std::string> names[3] = {
    { "smoothinglength", "smoothing_length", "hsml", "h" }, { "mass", "m" }, { "density", "rho" }
  };
  for (const std::string& name : names[index])
  {
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = data->GetArray(a);
      if (array && GetLower(array->GetName()) == name && array->GetNumberOfComponents() == 1 &&
        array->GetNumberOfTuples() == number)
      {
        return array;
      }
    }
  }
  return nullptr;
}

/// An array that can be read through a pointer to its type.
vtkSmartPointer<vtkDataArray> GetContiguous(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> contiguous = array;
  if (!array->HasStandardMemoryLayout())
  {
    contiguous = vtkSmartPointer<vtkDoubleArray>::New();
    contiguous->DeepCopy(array);
  }
  return contiguous;
}

/// What is not to be carried from particles to points.
bool IsOwnArray(vtkPointData* data, vtkDataArray* array)
{
  using namespace vtkPointSplatArrays;
  const std::string name = array->GetName() ? array->GetName() : "";
  const char* const own[] = { "", "Normals", vtkDataSetAttributes::GhostArrayName(), Radius, Axis1,
    Axis2, PlaneNormal, Curvature, Group, Shadow, Isovalue };
  return std::find(std::begin(own), std::end(own), name) != std::end(own) ||
    array == data->GetNormals() || array == data->GetGlobalIds() ||
    array == data->GetPedigreeIds() || array->GetDataType() == VTK_BIT;
}

/// The arrays of the output and how a point is written into them.
class Output
{
public:
  Output(vtkPointSet* input, vtkIdType count, double spacing)
  {
    double largest = 0;
    for (int c = 0; c < 6; ++c)
    {
      largest = std::max(largest, std::abs(input->GetBounds()[c]));
    }
    // NaN and infinity are not less.
    const bool single = largest < vtkPointSplatInput::LargestCoordinate &&
      largest * std::numeric_limits<float>::epsilon() < 2 * vtkPointSplatInput::Resolution * spacing;
    this->Points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
    this->Points->SetNumberOfPoints(count);
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(count);
    this->Radii->SetName(vtkPointSplatArrays::Radius);
    this->Radii->SetNumberOfTuples(count);
    this->Curvatures->SetName(vtkPointSplatArrays::Curvature);
    this->Curvatures->SetNumberOfComponents(6);
    this->Curvatures->SetNumberOfTuples(count);

    vtkPointData* from = input->GetPointData();
    for (int a = 0; a < from->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = from->GetArray(a);
      if (!array || array->GetNumberOfTuples() != input->GetNumberOfPoints() ||
        IsOwnArray(from, array))
      {
        continue;
      }
      const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
      vtkStdString name = array->GetName();
      // From VTK 9.5 on it is returned as a vtkAbstractArray.
      this->Carried.push_back(vtkDataArray::SafeDownCast(
        (real ? this->Means : this->Copies).AddArrayPair(count, array, name, 0.0, false)));
    }
  }

  struct Scratch
  {
    std::vector<vtkIdType> Ids;
    std::vector<double> Weights;
  };

  void Write(vtkIdType id, const vtkParticleSurface::Point& point, Scratch& scratch)
  {
    if (auto* single = vtkFloatArray::FastDownCast(this->Points->GetData()))
    {
      Put(point.Position, 3, single->GetPointer(3 * id));
    }
    else
    {
      Put(point.Position, 3,
        vtkDoubleArray::FastDownCast(this->Points->GetData())->GetPointer(3 * id));
    }
    Put(point.Normal, 3, this->Normals->GetPointer(3 * id));
    Put(point.Curvature, 6, this->Curvatures->GetPointer(6 * id));
    this->Radii->SetValue(id, static_cast<float>(point.Radius));

    scratch.Ids.clear();
    scratch.Weights.clear();
    std::size_t largest = 0;
    for (const vtkParticleSurface::Share& share : *point.Shares)
    {
      scratch.Ids.push_back(share.Id);
      scratch.Weights.push_back(share.Weight);
      largest = share.Weight > scratch.Weights[largest] ? scratch.Ids.size() - 1 : largest;
    }
    if (!scratch.Ids.empty())
    {
      this->Means.Interpolate(static_cast<int>(scratch.Ids.size()), scratch.Ids.data(),
        scratch.Weights.data(), id);
      this->Copies.Copy(scratch.Ids[largest], id);
    }
  }

  void MoveTo(vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->GetPointData()->SetNormals(this->Normals);
    output->GetPointData()->AddArray(this->Radii);
    output->GetPointData()->AddArray(this->Curvatures);
    for (vtkDataArray* array : this->Carried)
    {
      output->GetPointData()->AddArray(array);
    }
  }

private:
  template <typename T>
  static void Put(const double* values, int count, T* to)
  {
    for (int c = 0; c < count; ++c)
    {
      to[c] = static_cast<T>(values[c]);
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals, Radii, Curvatures;
  ArrayList Means, Copies;
  std::vector<vtkSmartPointer<vtkDataArray>> Carried;
};
}

vtkParticleSurfacePoints::vtkParticleSurfacePoints() = default;

vtkParticleSurfacePoints::~vtkParticleSurfacePoints() = default;

int vtkParticleSurfacePoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

bool vtkParticleSurfacePoints::FindSizes(
  ArrayIndex index, vtkPointSet* input, vtkDataArray*& array)
{
  vtkPointData* data = input->GetPointData();
  const vtkIdType number = input->GetNumberOfPoints();
  vtkInformationVector* chosen =
    this->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* info = chosen ? chosen->GetInformationObject(index) : nullptr;
  if (!info || !(info->Has(vtkDataObject::FIELD_NAME()) ||
    info->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE())))
  {
    array = FindByName(data, index, number);
    return true;
  }
  const char* name = info->Get(vtkDataObject::FIELD_NAME());
  array = name ? data->GetArray(name)
               : data->GetAttribute(info->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
  const std::string what = std::string(name ? name : "of an attribute") + "\" for the particles' " +
    sizeNames[index];
  if (!array)
  {
    vtkErrorMacro("There is no numeric point array \""
      << what << " in the input; choose one by SetInputArrayToProcess.");
    return false;
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != number)
  {
    vtkErrorMacro("The array \"" << what << " has " << array->GetNumberOfTuples() << " tuples of "
                                 << array->GetNumberOfComponents() << " components for " << number
                                 << " points; an array with one number a point is needed.");
    return false;
  }
  return true;
}

int vtkParticleSurfacePoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  this->MeasuredSpacing = 0;
  const vtkIdType number = input->GetNumberOfPoints();
  if (number == 0)
  {
    return 1;
  }
  vtkParticleSurfaceKernels::Particles particles;
  if (!this->FindSizes(SmoothingLengths, input, particles.SmoothingLengths) ||
    !this->FindSizes(Masses, input, particles.Masses) ||
    !this->FindSizes(Densities, input, particles.Densities))
  {
    return 1;
  }
  vtkSmartPointer<vtkDataArray> points = GetContiguous(input->GetPoints()->GetData());
  particles.Points = points;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts && ghosts->GetNumberOfTuples() == number && ghosts->GetNumberOfComponents() == 1)
  {
    particles.Ghosts = ghosts->GetPointer(0);
  }

  vtkParticleSurfaceKernels kernels;
  const vtkParticleSurfaceKernels::Settings settings{ this->ParticleSpacing, this->KernelReach,
    this->Smoothing, this->LargestStretch };
  if (!kernels.Build(this, 0.0, 0.4, particles, settings))
  {
    return 1;
  }
  const vtkParticleSurfaceKernels::Skipped& skipped = kernels.GetSkipped();
  if (skipped.Points + skipped.Hidden + skipped.Duplicates + skipped.Sizes + skipped.Clamped > 0)
  {
    vtkWarningMacro("Of " << number << " particles " << skipped.Points
                          << " have coordinates that are not finite or too large for their size, "
                          << skipped.Hidden << " are hidden ("
                          << vtkDataSetAttributes::GhostArrayName() << "), and "
                          << skipped.Duplicates
                          << " lie where another one lies; they take no part. " << skipped.Sizes
                          << " have a smoothing length, mass or density that is not positive and "
                             "finite, and get the usual size; "
                          << skipped.Clamped
                          << " are more than a thousand times larger or smaller than that.");
  }
  this->MeasuredSpacing = kernels.GetSpacing();

  vtkParticleSurfaceTree tree;
  if (!tree.Build(this, 0.4, 0.5, kernels.Get(), this->MeasuredSpacing))
  {
    return 1;
  }
  vtkParticleSurface surface(kernels.Get(), tree, this->PointSpacing, particles.Ghosts);
  vtkIdType count = 0;
  if (!surface.Find(this, 0.5, 0.8, count))
  {
    return 1;
  }
  Output written(input, count, this->MeasuredSpacing);
  vtkSMPThreadLocal<Output::Scratch> scratches;
  auto write = [&](vtkIdType id, const vtkParticleSurface::Point& point) {
    written.Write(id, point, scratches.Local());
  };
  if (surface.Write(this, 0.8, 1.0, write))
  {
    written.MoveTo(output);
  }
  return 1;
}

void vtkParticleSurfacePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointSpacing: " << this->PointSpacing << "\n";
  os << indent << "ParticleSpacing: " << this->ParticleSpacing << "\n";
  os << indent << "KernelReach: " << this->KernelReach << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "LargestStretch: " << this->LargestStretch << "\n";
  os << indent << "MeasuredSpacing: " << this->MeasuredSpacing << "\n";
}

VTK_ABI_NAMESPACE_END
