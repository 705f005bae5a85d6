// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfacePoints.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIsosurfaceBorders.h"
#include "vtkIsosurfaceEdges.h"
#include "vtkIsosurfaceOutput.h"
#include "vtkIsosurfaceSamples.h"
#include "vtkIsosurfaceScatter.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatInput.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkIsosurfacePoints);

namespace
{
const unsigned char* GetGhosts(vtkDataSetAttributes* data, vtkIdType size)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && ghosts->GetNumberOfTuples() == size && ghosts->GetNumberOfComponents() == 1
    ? ghosts->GetPointer(0)
    : nullptr;
}

vtkIsosurfaceGrid DescribeGrid(vtkImageData* image, int numberOfComponents)
{
  vtkIsosurfaceGrid grid;
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  vtkMatrix4x4* toWorld = image->GetIndexToPhysicalMatrix();
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  // vtkFlyingEdges3D mirrors the normals of an image that is mirrored, and so do we.
  grid.Side = direction->Determinant() < 0 ? 1 : -1;
  vtkIdType stride = numberOfComponents;
  for (int c = 0; c < 3; ++c)
  {
    grid.Dimensions[c] = extent[2 * c + 1] - extent[2 * c] + 1;
    grid.Strides[c] = stride;
    stride *= grid.Dimensions[c];
    grid.Spacing[c] = std::abs(spacing[c]);
    grid.ToWorld[c][3] = toWorld->GetElement(c, 3);
    for (int r = 0; r < 3; ++r)
    {
      grid.ToWorld[c][r] = toWorld->GetElement(c, r);
      grid.ToWorld[c][3] += toWorld->GetElement(c, r) * extent[2 * r];
      grid.ToNormal[c][r] = grid.Side * direction->GetElement(c, r) / spacing[r];
    }
  }
  grid.PointGhosts = GetGhosts(image->GetPointData(), image->GetNumberOfPoints());
  grid.CellGhosts = GetGhosts(image->GetCellData(), image->GetNumberOfCells());
  return grid;
}

/// Whether the grid has a place for each sample, and voxels of some volume.
bool IsUsable(const vtkIsosurfaceGrid& grid)
{
  double determinant = vtkMath::Determinant3x3(grid.ToNormal);
  for (int c = 0; c < 3; ++c)
  {
    const double* m = grid.ToWorld[c];
    determinant *= grid.Spacing[c];
    if (!std::isfinite(std::abs(m[0]) * grid.Dimensions[0] + std::abs(m[1]) * grid.Dimensions[1] +
          std::abs(m[2]) * grid.Dimensions[2] + std::abs(m[3])))
    {
      return false;
    }
  }
  return determinant != 0 && std::isfinite(determinant);
}

/// At which faces the volume ends that the image is all, or a piece, of: low and high of each axis.
std::array<bool, 6> FindEnds(vtkInformationVector** inputs, vtkImageData* image)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  const int* extent = image->GetExtent();
  const int* whole = info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    ? info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
    : extent;
  std::array<bool, 6> ends;
  std::transform(extent, extent + 6, whole, ends.begin(), std::equal_to<int>());
  return ends;
}

/// The least point spacing for which voxels are divided far enough.
double GetFinestSpacing(const vtkIsosurfaceGrid& grid)
{
  return *std::max_element(grid.Spacing, grid.Spacing + 3) *
    vtkIsosurfaceSamples<float>::FinestSpacing;
}

/// Whether floats are too coarse for the volume's place.
bool NeedsDouble(vtkImageData* image)
{
  double bounds[6], least = VTK_DOUBLE_MAX, largest = 0;
  image->GetBounds(bounds);
  for (int c = 0; c < 6; ++c)
  {
    largest = std::max(largest, std::abs(bounds[c]));
    least = std::min(least, std::abs(image->GetSpacing()[c / 2]));
  }
  return largest * std::numeric_limits<float>::epsilon() > 2 * vtkPointSplatInput::Resolution * least ||
    largest > vtkPointSplatInput::LargestCoordinate;
}

/// The same for scattered samples, with the spacing they would have if they filled their bounds.
bool NeedsDouble(vtkPointSet* samples)
{
  double bounds[6], largest = 0, diagonal = 0;
  samples->GetBounds(bounds);
  for (int c = 0; c < 3; ++c)
  {
    largest = std::max({ largest, std::abs(bounds[2 * c]), std::abs(bounds[2 * c + 1]) });
    diagonal = std::max(diagonal, bounds[2 * c + 1] - bounds[2 * c]);
  }
  const double spacing = diagonal / std::cbrt(static_cast<double>(samples->GetNumberOfPoints()));
  return largest * std::numeric_limits<float>::epsilon() > 2 * vtkPointSplatInput::Resolution * spacing ||
    largest > vtkPointSplatInput::LargestCoordinate;
}

/// Arrays of the types that volumes mostly have: extractions take minutes to compile for all types.
using Arrays = vtkTypeList::Create<vtkAOSDataArrayTemplate<unsigned char>,
  vtkAOSDataArrayTemplate<short>, vtkAOSDataArrayTemplate<unsigned short>,
  vtkAOSDataArrayTemplate<int>, vtkAOSDataArrayTemplate<float>, vtkAOSDataArrayTemplate<double>>;
using Dispatcher = vtkArrayDispatch::DispatchByArray<Arrays>;

/// The array, or its values in one of doubles where it is none of these.
vtkSmartPointer<vtkDataArray> GetReadable(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> readable = array;
  if (!Dispatcher::Execute(array, [](auto*) {}))
  {
    readable = vtkSmartPointer<vtkDoubleArray>::New();
    readable->DeepCopy(array);
    readable->SetName(array->GetName());
  }
  return readable;
}

template <typename T>
std::unique_ptr<vtkIsosurfaceExtraction> MakeExtraction(const vtkIsosurfaceGrid& grid,
  const T* values, const std::vector<double>& isovalues, double spacing, bool sizes,
  bool fillGaps)
{
  if (spacing > 0)
  {
    return std::make_unique<vtkIsosurfaceSamples<T>>(
      grid, values, isovalues, std::max(spacing, GetFinestSpacing(grid)));
  }
  return std::make_unique<vtkIsosurfaceEdges<T>>(grid, values, isovalues, sizes, fillGaps);
}
}

vtkIsosurfacePoints::vtkIsosurfacePoints()
  : ContourValues(vtkContourValues::New())
{
  this->ContourValues->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkIsosurfacePoints::~vtkIsosurfacePoints()
{
  this->ContourValues->Delete();
}

void vtkIsosurfacePoints::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkIsosurfacePoints::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

double* vtkIsosurfacePoints::GetValues()
{
  return this->ContourValues->GetValues();
}

void vtkIsosurfacePoints::GetValues(double* values)
{
  this->ContourValues->GetValues(values);
}

void vtkIsosurfacePoints::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkIsosurfacePoints::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkIsosurfacePoints::GenerateValues(int number, double range[2])
{
  this->ContourValues->GenerateValues(number, range);
}

void vtkIsosurfacePoints::GenerateValues(int number, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(number, rangeStart, rangeEnd);
}

vtkMTimeType vtkIsosurfacePoints::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkIsosurfacePoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkIsosurfacePoints::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

vtkTypeBool vtkIsosurfacePoints::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(request, inputs, outputs);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkIsosurfacePoints::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  const char* type = this->BlockPerIsovalue ? "vtkMultiBlockDataSet" : "vtkPolyData";
  if (!output || !output->IsA(type))
  {
    vtkSmartPointer<vtkDataObject> made;
    if (this->BlockPerIsovalue)
    {
      made = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    }
    else
    {
      made = vtkSmartPointer<vtkPolyData>::New();
    }
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

int vtkIsosurfacePoints::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // One more level of ghosts, for the gradients.
  const int levels = outputs->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  inputs[0]->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), levels + 1);
  return 1;
}

/// The array to contour, readable, or null after an error.
vtkSmartPointer<vtkDataArray> vtkIsosurfacePoints::GetScalars(
  vtkInformationVector** inputs, vtkDataSet* input)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs, association);
  if (!scalars)
  {
    const char* name =
      this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    vtkErrorMacro("There is no numeric point array "
      << (name ? std::string("\"") + name + "\"" : std::string("of active scalars"))
      << " in the input; choose one by SetInputArrayToProcess.");
    return nullptr;
  }
  const std::string name = scalars->GetName() ? scalars->GetName() : "(without name)";
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    scalars->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    vtkErrorMacro("The array \"" << name << "\" has " << scalars->GetNumberOfTuples()
                                 << " tuples for " << input->GetNumberOfPoints()
                                 << " points; an array with one value a point is needed.");
    return nullptr;
  }
  if (this->ArrayComponent >= scalars->GetNumberOfComponents())
  {
    vtkErrorMacro("The array \"" << name << "\" has no component " << this->ArrayComponent
                                 << "; set ArrayComponent below "
                                 << scalars->GetNumberOfComponents() << ".");
    return nullptr;
  }
  return GetReadable(scalars);
}

int vtkIsosurfacePoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  output->Initialize();
  if (this->GetNumberOfContours() == 0)
  {
    vtkWarningMacro("There is no isovalue; set one by SetValue.");
  }
  if (vtkImageData* image = vtkImageData::GetData(inputs[0]))
  {
    this->ExtractVolume(inputs, image, output);
  }
  else
  {
    this->ExtractScatter(inputs, vtkPointSet::GetData(inputs[0]), output);
  }
  return 1;
}

void vtkIsosurfacePoints::ExtractVolume(
  vtkInformationVector** inputs, vtkImageData* image, vtkDataObject* output)
{
  const int* dimensions = image->GetDimensions();
  if (dimensions[0] < 2 || dimensions[1] < 2 || dimensions[2] < 2)
  {
    vtkErrorMacro("The input has " << dimensions[0] << " x " << dimensions[1] << " x "
                                   << dimensions[2]
                                   << " samples; a volume with at least 2 along each axis is "
                                      "needed.");
    return;
  }
  vtkSmartPointer<vtkDataArray> scalars = this->GetScalars(inputs, image);
  if (!scalars)
  {
    return;
  }
  const vtkIsosurfaceGrid grid = DescribeGrid(image, scalars->GetNumberOfComponents());
  if (!IsUsable(grid))
  {
    vtkErrorMacro("The image's origin, spacing or direction is not finite, or leaves its voxels no "
                  "volume; set them by SetOrigin, SetSpacing and SetDirectionMatrix.");
    return;
  }
  const double finest = GetFinestSpacing(grid);
  if (this->PointSpacing > 0 && this->PointSpacing < finest)
  {
    vtkWarningMacro("PointSpacing " << this->PointSpacing
                                    << " is finer than a voxel can be divided; taking " << finest
                                    << ".");
  }
  auto make = [&](const std::vector<double>& isovalues) {
    std::unique_ptr<vtkIsosurfaceExtraction> extraction;
    Dispatcher::Execute(scalars, [&](auto* array) {
      extraction = MakeExtraction(grid, array->GetPointer(this->ArrayComponent), isovalues,
        this->PointSpacing, this->SplatSizes, this->FillGaps);
    });
    return extraction;
  };
  // As many isovalues in one sweep as a class can count.
  std::vector<vtkIsosurfaceOutput> surfaces = this->Extract(make, 254, NeedsDouble(image), image);
  const vtkIsosurfaceBorders borders(grid, FindEnds(inputs, image));
  for (vtkIsosurfaceOutput& surface : surfaces)
  {
    borders.Clip(surface);
  }
  this->MoveTo(surfaces, output);
}

void vtkIsosurfacePoints::ExtractScatter(
  vtkInformationVector** inputs, vtkPointSet* samples, vtkDataObject* output)
{
  const vtkIdType number = samples->GetNumberOfPoints();
  std::unique_ptr<vtkIsosurfaceScatterField> field =
    std::make_unique<vtkIsosurfaceScatterField>();
  if (number > 0)
  {
    vtkSmartPointer<vtkDataArray> scalars = this->GetScalars(inputs, samples);
    if (!scalars)
    {
      return;
    }
    const vtkIsosurfaceScatterField::Skipped skipped =
      field->SetSamples(GetReadable(samples->GetPoints()->GetData()), scalars,
        this->ArrayComponent, GetGhosts(samples->GetPointData(), number));
    if (skipped.Points + skipped.Values + skipped.Hidden + skipped.Duplicates > 0)
    {
      vtkWarningMacro("Of " << number << " samples " << skipped.Points
                            << " have coordinates that are not finite, " << skipped.Values
                            << " have values of the array \""
                            << (scalars->GetName() ? scalars->GetName() : "(without name)")
                            << "\" that are not finite, " << skipped.Hidden << " are hidden ("
                            << vtkDataSetAttributes::GhostArrayName() << "), and "
                            << skipped.Duplicates
                            << " lie where another one lies; they take no part.");
    }
  }
  if (field->GetNumberOfSamples() < 2)
  {
    vtkWarningMacro("The input has " << field->GetNumberOfSamples()
                                     << " usable samples; an isosurface lies between two at "
                                        "least.");
  }
  auto make = [&](const std::vector<double>& isovalues) {
    return std::make_unique<vtkIsosurfaceScatter>(std::move(field), isovalues,
      vtkIsosurfaceScatter::Settings{ this->PointSpacing, this->NumberOfNeighbors,
        this->NeighborRadius, this->Correction });
  };
  this->MoveTo(this->Extract(make, VTK_INT_MAX, NeedsDouble(samples), samples), output);
}

/// One surface for all isovalues, or for each; none where it was aborted.
std::vector<vtkIsosurfaceOutput> vtkIsosurfacePoints::Extract(
  const Factory& make, std::size_t most, bool precise, vtkDataSet* input)
{
  const int number = static_cast<int>(this->GetNumberOfContours());
  std::vector<int> order;
  for (int i = 0; i < number; ++i)
  {
    if (std::isfinite(this->GetValue(i)))
    {
      order.push_back(i);
    }
  }
  if (order.size() < static_cast<std::size_t>(number))
  {
    vtkWarningMacro(
      << number - order.size() << " of " << number << " isovalues are not finite; left out.");
  }
  std::stable_sort(order.begin(), order.end(),
    [this](int a, int b) { return this->GetValue(a) < this->GetValue(b); });

  const std::size_t sweeps = (order.size() + most - 1) / most;
  std::vector<std::unique_ptr<vtkIsosurfaceExtraction>> extractions;
  std::vector<vtkIdType> counts(number, 0);
  for (std::size_t s = 0; s < sweeps; ++s)
  {
    std::vector<double> isovalues;
    for (std::size_t i = s * most; i < std::min((s + 1) * most, order.size()); ++i)
    {
      isovalues.push_back(this->GetValue(order[i]));
    }
    std::unique_ptr<vtkIsosurfaceExtraction> extraction = make(isovalues);
    std::vector<vtkIdType> found;
    if (!extraction->Find(this, 0.7 * s / sweeps, 0.7 * (s + 1) / sweeps, found))
    {
      return {};
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      counts[order[s * most + i]] = found[i];
    }
    extractions.push_back(std::move(extraction));
  }

  const bool sizes = this->SplatSizes &&
    std::all_of(extractions.begin(), extractions.end(),
      [](const std::unique_ptr<vtkIsosurfaceExtraction>& e) { return e->KnowsSizes(); });

  std::vector<vtkIsosurfaceOutput> surfaces;
  std::vector<vtkIsosurfaceExtraction::Target> targets(number);
  if (!this->BlockPerIsovalue)
  {
    const vtkIdType all = std::accumulate(counts.begin(), counts.end(), vtkIdType(0));
    surfaces.emplace_back(all, precise, sizes);
  }
  // Whatever PointSpacing is, no disk is larger than what it is cut from.
  const double largest =
    std::min(vtkIsosurfaceExtraction::Target::LargestNumber, 0.5 * input->GetLength());
  vtkIdType first = 0;
  for (int i = 0; i < number; ++i)
  {
    if (this->BlockPerIsovalue)
    {
      surfaces.emplace_back(counts[i], precise, sizes);
      first = 0;
    }
    targets[i] = surfaces.back().GetTarget(first);
    targets[i].LargestRadius = largest;
    double* isovalue = surfaces.back().Isovalues->GetPointer(0) + first;
    std::fill(isovalue, isovalue + counts[i], this->GetValue(i));
    first += counts[i];
  }
  for (std::size_t s = 0; s < sweeps; ++s)
  {
    std::vector<vtkIsosurfaceExtraction::Target> sorted;
    for (std::size_t i = s * most; i < std::min((s + 1) * most, order.size()); ++i)
    {
      sorted.push_back(targets[order[i]]);
    }
    if (!extractions[s]->Write(
          this, 0.7 + 0.3 * s / sweeps, 0.7 + 0.3 * (s + 1) / sweeps, sorted))
    {
      return {};
    }
  }

  return surfaces;
}

void vtkIsosurfacePoints::MoveTo(
  const std::vector<vtkIsosurfaceOutput>& surfaces, vtkDataObject* output)
{
  if (surfaces.empty())
  {
    return;
  }
  this->UpdateProgress(1.0);
  if (auto* polyData = vtkPolyData::SafeDownCast(output))
  {
    surfaces[0].MoveTo(polyData);
    return;
  }
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  const int number = static_cast<int>(surfaces.size());
  blocks->SetNumberOfBlocks(number);
  for (int i = 0; i < number; ++i)
  {
    vtkNew<vtkPolyData> block;
    surfaces[i].MoveTo(block);
    blocks->SetBlock(i, block);
    std::ostringstream name;
    name << "Isovalue " << this->GetValue(i);
    blocks->GetMetaData(static_cast<unsigned int>(i))
      ->Set(vtkCompositeDataSet::NAME(), name.str().c_str());
  }
}

void vtkIsosurfacePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
  os << indent << "PointSpacing: " << this->PointSpacing << "\n";
  os << indent << "BlockPerIsovalue: " << (this->BlockPerIsovalue ? "On" : "Off") << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NeighborRadius: " << this->NeighborRadius << "\n";
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "SplatSizes: " << (this->SplatSizes ? "On" : "Off") << "\n";
  os << indent << "FillGaps: " << (this->FillGaps ? "On" : "Off") << "\n";
}

VTK_ABI_NAMESPACE_END
