// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the mapper: what it says of the frame that was drawn last.
#include "vtkPointSplatMapperInternals.h"

#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetMethodUsed()
{
  return this->Internals->Report.Method;
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetMethodReason()
{
  return this->Internals->Report.Choice.MethodReason.c_str();
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetProjectionUsed()
{
  return this->Internals->Report.Projection;
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetTransparencyUsed()
{
  return this->Internals->Report.Transparency;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfLayersDrawn()
{
  return this->Internals->Report.Layers;
}

//------------------------------------------------------------------------------
const char* vtkPointSplatMapper::GetChoices()
{
  const vtkPointSplatReport& r = this->Internals->Report;
  std::ostringstream text;
  text << "method: " << r.Method << ", " << r.Choice.MethodReason
       << "\nprojection: " << r.Projection << ", " << r.Choice.ProjectionReason
       << "\ntransparency: " << r.Transparency << ", " << r.Choice.TransparencyReason
       << "\nlayers: " << r.Layers << ", " << r.Choice.LayersReason
       << "\nlayer distance: " << this->GetLayerDistanceUsed() << ", "
       << (r.Settings.LayerDistance > 0.0         ? "it was asked for"
              : r.Settings.Method == IMAGE_SPACE ? "the spacing of points, and at least three pixels"
                                               : "the radius of each splat; this is the median")
       << "\nsplats: one of " << this->GetStride() << ", " << r.Choice.SplatsReason
       << "\nlevels: " << r.Choice.LevelsReason
       << "\ntriangles: " << r.Projected.Triangles << ", "
       << (this->Hybrid == HYBRID_OFF      ? "hybrids are off"
              : r.Projected.Triangles > 0 ? "where their edges are longer than four pixels"
                                           : "none is magnified, or splats alone can show it")
       << "\noutlines: " << (this->AntiAliasing && r.Choice.Outlines ? "smoothed, " : "as pixels have them, ")
       << (this->AntiAliasing ? r.Choice.OutlinesReason : "smoothing is off")
       << "\nfill steps: " << r.FillSteps << ", " << r.Choice.FillReason
       << "\nshadow samples: " << r.ShadowSamples << ", "
       << (this->Shadows ? r.ShadowReason : "shadows are off")
       << "\npoints: "
       << (this->Internals->GetCloud().IsProjected()
              ? "projected, their normals contradict their neighbours"
              : "as given")
       << (this->Internals->GetCloud().IsFollowing() ? ", with sizes of an earlier frame" : "");
  if (const vtkIdType unused = this->Internals->GetCloud().GetNumberOfUnusedPoints())
  {
    text << ", without " << unused << " that no cell uses";
  }
  if (const vtkIdType copies = this->GetNumberOfCopies())
  {
    text << ", " << copies << " drawn by the splats of others at their places";
  }
  text << "\nerror allowed: " << vtkPointSplatChoices::Text(r.Choice.Tolerance) << ", "
       << r.Choice.BudgetReason;
  const vtkPointSplatDrafts& drafts = this->Internals->GetDrafts();
  if (drafts.AreDrawn())
  {
    const double share = drafts.GetCloud().GetShare();
    text << "\nprogress: one point of " << std::lround(1.0 / share) << " is drawn, "
         << (drafts.IsUnderWay() ? "while more are prepared" : "since that was aborted");
  }
  this->Internals->Choices = text.str();
  return this->Internals->Choices.c_str();
}

//------------------------------------------------------------------------------
bool vtkPointSplatMapper::IsProgressing()
{
  return this->Internals->GetDrafts().IsUnderWay();
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfFillSteps()
{
  return this->Internals->Report.FillSteps;
}

//------------------------------------------------------------------------------
double vtkPointSplatMapper::GetProjectedSpacing()
{
  return this->Internals->Report.ProjectedSpacing;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfPointsProjected()
{
  return this->Internals->Report.Projected.Splats;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfTrianglesProjected()
{
  return this->Internals->Report.Projected.Triangles;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfShadowSamplesUsed()
{
  return this->Shadows ? this->Internals->Report.ShadowSamples : 0;
}

//------------------------------------------------------------------------------
unsigned long vtkPointSplatMapper::GetNumberOfShadowUpdates()
{
  return this->Internals->Report.ShadowUpdates;
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetNumberOfGroups()
{
  return this->Internals->GetCloud().GetGroups().GetNumberOfGroups();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatMapper::GetGroupMTime()
{
  return this->Internals->GetCloud().GetGroups().GetMTime();
}

//------------------------------------------------------------------------------
double vtkPointSplatMapper::GetLayerDistanceUsed()
{
  const vtkPointSplatReport& r = this->Internals->Report;
  return vtkPointSplatCollection::LayerDistanceOf(
    r.Settings, r.Choice, this->Internals->GetCloud());
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfSplats()
{
  return this->Internals->GetCloud().GetNumberOfSplats();
}

//------------------------------------------------------------------------------
int vtkPointSplatMapper::GetStride()
{
  return 1 << this->Internals->Report.StrideShift;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfSkippedPoints()
{
  return this->Internals->GetCloud().GetNumberOfSkippedPoints();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetNumberOfCopies()
{
  return this->Internals->GetCloud().GetNumberOfCopies();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatMapper::GetImageMemorySize()
{
  return this->Internals->Report.ImageMemory;
}

VTK_ABI_NAMESPACE_END
