// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatRepresentation.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVPointSplatBorders.h"
#include "vtkPVPointSplatGeometry.h"
#include "vtkPVPointSplatMapper.h"
#include "vtkPVPointSplatRegion.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
vtkMultiProcessController* Processes()
{
  return vtkMultiProcessController::GetGlobalController();
}

vtkIdType CountPoints(vtkDataObject* data)
{
  return data ? data->GetNumberOfElements(vtkDataObject::POINT) : 0;
}

/// Calls visit with each leaf that is a vtkPolyData, or with null, and its flat index.
template <typename Visit>
void VisitLeaves(vtkDataObject* data, bool emptyOnes, const Visit& visit)
{
  auto tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  it->SetSkipEmptyNodes(!emptyOnes);
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    visit(it, vtkPolyData::SafeDownCast(it->GetCurrentDataObject()));
  }
}

vtkBoundingBox BoundsOf(vtkDataObject* data)
{
  vtkBoundingBox box;
  VisitLeaves(data, false, [&box](vtkDataObjectTreeIterator*, vtkPolyData* leaf) {
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      box.AddBounds(leaf->GetBounds());
    }
  });
  return box;
}

/// How far the splat of a point may be seen: kernels end at 1.5 radii, and factors are at most 8.
vtkPVPointSplatBorders::Reach ReachOf(vtkPolyData* points, double radiusScale)
{
  vtkPointData* data = points->GetPointData();
  vtkDataArray* sizes = data->GetArray(vtkPointSplatArrays::Radius);
  vtkDataArray* axes = sizes ? nullptr : data->GetArray(vtkPointSplatArrays::Axis1);
  // Of the splats in reach the sheets are told apart by a layer distance of one more radius.
  const double radii = 2.5 * radiusScale;
  return [sizes, axes, radii](vtkIdType point) {
    double axis[3] = { 0.0, 0.0, 0.0 };
    if (axes)
    {
      axes->GetTuple(point, axis);
    }
    return radii *
      (sizes ? sizes->GetComponent(point, 0) : std::hypot(axis[0], axis[1], axis[2]));
  };
}

/// Every n-th point, with the size of what it stands for.
vtkSmartPointer<vtkPolyData> Thin(vtkPolyData* points, vtkIdType stride)
{
  vtkNew<vtkPolyData> all;
  all->SetPoints(points->GetPoints());
  all->GetPointData()->ShallowCopy(points->GetPointData());
  all->GetFieldData()->ShallowCopy(points->GetFieldData());
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i += stride)
  {
    vertices->InsertNextCell(1, &i);
  }
  all->SetVerts(vertices);
  vtkSmartPointer<vtkPolyData> thin = vtkPVPointSplatBorders::Within(
    all, vtkBoundingBox(points->GetBounds()), [](vtkIdType) { return VTK_DOUBLE_MAX; });
  vtkPointData* data = thin->GetPointData();
  for (const char* name : { vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    data->RemoveArray(name);
  }
  for (const char* name :
    { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1, vtkPointSplatArrays::Axis2 })
  {
    vtkDataArray* sizes = data->GetArray(name);
    for (vtkIdType i = 0; sizes && i < sizes->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < sizes->GetNumberOfComponents(); ++c)
      {
        sizes->SetComponent(
          i, c, sizes->GetComponent(i, c) * std::sqrt(static_cast<double>(stride)));
      }
    }
  }
  return thin;
}
}

vtkStandardNewMacro(vtkPVPointSplatRepresentation);

//------------------------------------------------------------------------------
vtkPVPointSplatRepresentation::vtkPVPointSplatRepresentation()
{
  this->GeometryFilter->Delete();
  this->GeometryFilter = vtkPVPointSplatGeometry::New();
  this->GeometryFilter->AddObserver(vtkCommand::ProgressEvent,
    static_cast<vtkGeometryRepresentation*>(this),
    &vtkPVPointSplatRepresentation::HandleGeometryRepresentationProgress);
  this->SetupDefaults();
  // The mappers of the superclass keep what is set; the actor draws by another one.
  this->Actor->SetMapper(this->SplatMapper);
  this->Actor->SetLODMapper(nullptr);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  this->SplatMapper->SetCompositeDataDisplayAttributes(attributes);
}

//------------------------------------------------------------------------------
vtkPVPointSplatRepresentation::~vtkPVPointSplatRepresentation() = default;

//------------------------------------------------------------------------------
int vtkPVPointSplatRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inputs, vtkInformation* outputs)
{
  if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    if (!this->GetVisibility())
    {
      return 0;
    }
    this->ProvideLessDetail(inputs);
    return 1;
  }
  if (!this->Superclass::ProcessViewRequest(request, inputs, outputs))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    // Points cannot be split: those on a border would be lost.
    vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inputs, this);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareToDraw(inputs);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::ProvideLessDetail(vtkInformation* inputs)
{
  auto data = vtkDataObjectTree::SafeDownCast(vtkPVView::GetPiece(inputs, this));
  if (!data || this->SuppressLOD)
  {
    return;
  }
  const double resolution = inputs->Has(vtkPVRenderView::LOD_RESOLUTION())
    ? inputs->Get(vtkPVRenderView::LOD_RESOLUTION())
    : 0.5;
  const auto stride =
    static_cast<vtkIdType>(std::lround(std::pow(16.0, 1.0 - std::clamp(resolution, 0.0, 1.0))));
  vtkSmartPointer<vtkDataObjectTree> less;
  less.TakeReference(data->NewInstance());
  less->CopyStructure(data);
  less->GetFieldData()->ShallowCopy(data->GetFieldData());
  VisitLeaves(data, false, [&less, stride](vtkDataObjectTreeIterator* it, vtkPolyData* leaf) {
    if (leaf)
    {
      const vtkSmartPointer<vtkPolyData> thin = Thin(leaf, stride);
      less->SetDataSet(it, thin);
    }
  });
  vtkPVView::SetPieceLOD(inputs, this, less);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::PrepareToDraw(vtkInformation* inputs)
{
  this->GatheredStride = 0;
  vtkDataObject* full = vtkPVView::GetDeliveredPiece(inputs, this);
  vtkDataObject* less = vtkPVView::GetDeliveredPieceLOD(inputs, this);
  int points = CountPoints(full) > 0 ? 1 : 0;
  int any = points;
  const bool many = this->IsDrawnByMany(inputs);
  if (many)
  {
    Processes()->AllReduce(&points, &any, 1, vtkCommunicator::MAX_OP);
  }
  vtkDataObject* data = !any && inputs->Has(vtkPVRenderView::USE_LOD()) ? less : full;
  vtkDataObject* drawn = many ? this->WithNeighbours(data) : data;
  this->SplatMapper->SetInputDataObject(drawn);
  if (drawn &&
    (this->AttributesOf != drawn || this->AttributesTime < this->BlockAttributeTime.GetMTime()))
  {
    this->AttributesOf = drawn;
    this->AttributesTime = this->BlockAttributeTime.GetMTime();
    this->PopulateBlockAttributes(this->SplatMapper->GetCompositeDataDisplayAttributes(), drawn);
  }
  if (auto view = vtkPVRenderView::SafeDownCast(this->GetView()))
  {
    this->Region->SetCamera(view->GetActiveCamera());
  }
}

//------------------------------------------------------------------------------
bool vtkPVPointSplatRepresentation::IsDrawnByMany(vtkInformation* inputs)
{
  // Where the data come to one process to be drawn, the others are not asked to draw.
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  const bool distributed = view &&
    (inputs->Has(vtkPVRenderView::USE_LOD()) ? view->GetUseDistributedRenderingForLODRender()
                                             : view->GetUseDistributedRenderingForRender());
  return distributed && Processes() && Processes()->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkPVPointSplatRepresentation::WithNeighbours(vtkDataObject* own)
{
  vtkMultiProcessController* processes = Processes();
  const vtkMTimeType time = own ? own->GetMTime() : 0;
  int changed = this->Delivered != own || this->DeliveredTime != time ? 1 : 0;
  int any = 0;
  processes->AllReduce(&changed, &any, 1, vtkCommunicator::MAX_OP);
  if (!any)
  {
    return this->Drawn;
  }
  this->Delivered = own;
  this->DeliveredTime = time;
  const std::vector<vtkBoundingBox> regions = vtkPVPointSplatBorders::Partition(
    vtkPVPointSplatBorders::Gather(processes, BoundsOf(own)));
  const vtkBoundingBox& region = regions[static_cast<size_t>(processes->GetLocalProcessId())];
  this->Region->SetBox(region);
  vtkInformation* keys = this->Actor->GetPropertyKeys();
  keys->Remove(vtkOpenGLRenderPass::RenderPasses());
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), this->Region);

  // Leaves by flat index, which is the same on all processes, whether or not they have points.
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  VisitLeaves(own, true, [&leaves](vtkDataObjectTreeIterator* it, vtkPolyData* leaf) {
    leaves.resize(std::max<size_t>(leaves.size(), it->GetCurrentFlatIndex() + 1));
    leaves[it->GetCurrentFlatIndex()] = leaf;
  });
  int count = static_cast<int>(leaves.size());
  int most = 0;
  processes->AllReduce(&count, &most, 1, vtkCommunicator::MAX_OP);
  leaves.resize(static_cast<size_t>(most));
  std::vector<unsigned char> filled(leaves.size());
  for (size_t i = 0; i < leaves.size(); ++i)
  {
    filled[i] = leaves[i] && leaves[i]->GetNumberOfPoints() > 0 ? 1 : 0;
  }
  std::vector<unsigned char> anyFilled(filled.size());
  if (most > 0)
  {
    processes->AllReduce(filled.data(), anyFilled.data(), most, vtkCommunicator::MAX_OP);
  }
  for (size_t i = 0; i < leaves.size(); ++i)
  {
    if (anyFilled[i])
    {
      const vtkSmartPointer<vtkPolyData> leaf =
        leaves[i] ? leaves[i] : vtkSmartPointer<vtkPolyData>::New();
      leaves[i] = vtkPVPointSplatBorders::Exchange(
        processes, leaf, regions, ReachOf(leaf, this->SplatMapper->GetRadiusScale()));
    }
  }
  vtkSmartPointer<vtkDataObjectTree> drawn;
  if (auto tree = vtkDataObjectTree::SafeDownCast(own))
  {
    drawn.TakeReference(tree->NewInstance());
    drawn->CopyStructure(tree);
    drawn->GetFieldData()->ShallowCopy(tree->GetFieldData());
  }
  VisitLeaves(drawn, true, [&leaves, &drawn](vtkDataObjectTreeIterator* it, vtkPolyData*) {
    const vtkSmartPointer<vtkPolyData>& leaf = leaves[it->GetCurrentFlatIndex()];
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      drawn->SetDataSet(it, leaf);
    }
  });
  this->Drawn = drawn;
  return this->Drawn;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::UpdateColoringParameters()
{
  this->Superclass::UpdateColoringParameters();
  this->BackfaceActor->SetVisibility(0);
  if (this->BackfaceRepresentation < FOLLOW_FRONTFACE)
  {
    this->Property->SetBackfaceCulling(0);
  }
  vtkMapper* from = this->Mapper;
  this->SplatMapper->SetLookupTable(from->GetLookupTable());
  this->SplatMapper->SetColorMode(from->GetColorMode());
  this->SplatMapper->SetInterpolateScalarsBeforeMapping(from->GetInterpolateScalarsBeforeMapping());
  this->SplatMapper->SetScalarVisibility(from->GetScalarVisibility());
  this->SplatMapper->SetScalarMode(from->GetScalarMode());
  this->SplatMapper->SetFieldDataTupleId(from->GetFieldDataTupleId());
  this->SplatMapper->SelectColorArray(from->GetArrayName());
  this->SplatMapper->SetUseLookupTableScalarRange(from->GetUseLookupTableScalarRange());
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetArrayIdNames(const char* pointArray, const char* cellArray)
{
  this->Superclass::SetArrayIdNames(pointArray, cellArray);
  this->SplatMapper->SetIdArrays(pointArray ? pointArray : "vtkOriginalPointIds",
    cellArray ? cellArray : "vtkOriginalCellIds");
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetSizeByArray(bool by)
{
  this->SizeByArray = by;
  this->PassSizeArray();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetSizeArray(const char* name)
{
  this->SizeArray = name ? name : "";
  this->PassSizeArray();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::PassSizeArray()
{
  static_cast<vtkPVPointSplatGeometry*>(this->GeometryFilter)
    ->SetSizeArray(this->SizeByArray ? this->SizeArray : std::string());
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetBlockColorsDistinctValues(int count)
{
  static_cast<vtkPVPointSplatGeometry*>(this->GeometryFilter)->SetBlockColorsDistinctValues(count);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetRadiusScale(double scale)
{
  this->SplatMapper->SetRadiusScale(scale);
  this->DeliveredTime = 0; // larger splats reach farther into other processes' parts
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetTargetError(double error)
{
  this->SplatMapper->SetTargetError(error);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetMethod(int method)
{
  this->SplatMapper->SetMethod(method);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetTransparency(int transparency)
{
  this->SplatMapper->SetTransparency(transparency);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetProjection(int projection)
{
  this->SplatMapper->SetProjection(projection);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetKernel(int kernel)
{
  this->SplatMapper->SetKernel(kernel);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetLayerDistance(double distance)
{
  this->SplatMapper->SetLayerDistance(distance);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetAntiAliasing(bool smooth)
{
  this->SplatMapper->SetAntiAliasing(smooth);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetFollowMotion(bool follow)
{
  this->SplatMapper->SetFollowMotion(follow);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetFillGaps(bool fill)
{
  static_cast<vtkPVPointSplatGeometry*>(this->GeometryFilter)->SetFillGaps(fill);
  this->SplatMapper->SetFillGaps(fill);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetProjectNoise(bool project)
{
  this->SplatMapper->SetProjectNoise(project);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetShadows(bool shadows)
{
  this->SplatMapper->SetShadows(shadows);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetNumberOfShadowSamples(int samples)
{
  this->SplatMapper->SetNumberOfShadowSamples(samples);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::SetShadowLightRadius(double radius)
{
  this->SplatMapper->SetShadowLightRadius(radius);
}

//------------------------------------------------------------------------------
const char* vtkPVPointSplatRepresentation::GetChoices()
{
  return this->GatheredStride ? this->GatheredChoices.c_str() : this->SplatMapper->GetChoices();
}

//------------------------------------------------------------------------------
int vtkPVPointSplatRepresentation::GetStride()
{
  return this->GatheredStride ? this->GatheredStride : this->SplatMapper->GetStride();
}

//------------------------------------------------------------------------------
int vtkPVPointSplatRepresentation::GetNumberOfLayersDrawn()
{
  return this->GatheredStride ? this->GatheredLayers : this->SplatMapper->GetNumberOfLayersDrawn();
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::GatherChoices()
{
  vtkMultiProcessController* processes = Processes();
  if (!processes || processes->GetNumberOfProcesses() < 2)
  {
    return;
  }
  const int count = processes->GetNumberOfProcesses();
  const vtkIdType own = CountPoints(this->SplatMapper->GetInputDataObject(0, 0));
  std::vector<vtkIdType> points(static_cast<size_t>(count));
  processes->AllGather(&own, points.data(), 1);
  const auto teller =
    static_cast<int>(std::max_element(points.begin(), points.end()) - points.begin());
  vtkMultiProcessStream told;
  if (processes->GetLocalProcessId() == teller)
  {
    told << std::string(this->SplatMapper->GetChoices()) << this->SplatMapper->GetStride()
         << this->SplatMapper->GetNumberOfLayersDrawn();
  }
  processes->Broadcast(told, teller);
  told >> this->GatheredChoices >> this->GatheredStride >> this->GatheredLayers;
  this->GatheredChoices = "process: " + std::to_string(teller) + " of " + std::to_string(count) +
    ", it has the most points\n" + this->GatheredChoices;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplatMapper:\n";
  this->SplatMapper->PrintSelf(os, indent.GetNextIndent());
}
