// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVPointSplatRepresentation
 * @brief   ParaView's representation Point Splats: any data set's points as a smooth surface
 *
 * What the representation Surface obeys is obeyed, since this is one: colouring, block attributes,
 * lighting, position and scale come from vtkGeometryRepresentation, whose own mappers stay, and are
 * never drawn: what was set of them is copied to a vtkPVPointSplatMapper before each frame.
 *
 * 1. *Update.* vtkPVPointSplatGeometry makes points of the input, where the data are.
 * 2. *Delivery* is ParaView's: points stay, or go to the client, or, for translucent scenes on many
 *    processes, to the process that draws their part of space.
 * 3. *Before a frame*, on many processes, if points came or changed on any of them: space is parted
 *    among the processes by their points' bounding boxes (vtkPVPointSplatBorders), and each
 *    gets from the others the points whose splats reach into its part. It then shows the pixels
 *    whose surface lies in its part (vtkPVPointSplatRegion). So surfaces are whole across borders,
 *    opaque and translucent, each pixel is shown by one process, and picks tell of each point once.
 * 4. *While dragging* splats are fewer as vtkPointSplatMapper::SetTargetError() has it.
 *    Where ParaView wants geometry of less detail because it draws in another place than at rest,
 *    every n-th point is delivered, n = 16^(1 - LOD resolution).
 *
 * What backs of surfaces look like is the front's, unless backs, or fronts, are culled.
 *
 * Bad input: as vtkPVPointSplatGeometry and vtkPointSplatMapper have it.
 */
#ifndef vtkPVPointSplatRepresentation_h
#define vtkPVPointSplatRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h"                    // For vtkNew
#include "vtkPVPointSplattingModule.h" // For export macro
#include "vtkSmartPointer.h"           // For vtkSmartPointer

#include "vtkPointSplattingABI.h"

#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObjectTree;
VTK_ABI_NAMESPACE_END
class vtkPVPointSplatGeometry;
class vtkPVPointSplatMapper;
class vtkPVPointSplatRegion;

class VTKPVPOINTSPLATTING_EXPORT vtkPVPointSplatRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPVPointSplatRepresentation* New();
  vtkTypeMacro(vtkPVPointSplatRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inputs,
    vtkInformation* outputs) override;
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

  ///@{
  /**
   * As vtkPVPointSplatGeometry has them; SizeArray counts only where SizeByArray is on.
   */
  void SetSizeByArray(bool by);
  void SetSizeArray(const char* name);
  void SetBlockColorsDistinctValues(int count);
  ///@}

  ///@{
  /**
   * As vtkPointSplatMapper has them.
   */
  void SetRadiusScale(double scale);
  void SetTargetError(double error);
  void SetMethod(int method);
  void SetTransparency(int transparency);
  void SetProjection(int projection);
  void SetKernel(int kernel);
  void SetLayerDistance(double distance);
  void SetAntiAliasing(bool smooth);
  void SetProjectNoise(bool project);
  void SetFillGaps(bool fill);
  void SetFollowMotion(bool follow);
  void SetShadows(bool shadows);
  void SetNumberOfShadowSamples(int samples);
  void SetShadowLightRadius(double radius);
  const char* GetChoices();
  int GetStride();
  int GetNumberOfLayersDrawn();
  ///@}

  /**
   * Lets the first of many processes tell what was chosen for the last frame by the one that has
   * the most points, and says which that is: the first itself may have none. Until the next frame,
   * and nothing where there is one process. All processes that draw must call.
   */
  void GatherChoices();

protected:
  vtkPVPointSplatRepresentation();
  ~vtkPVPointSplatRepresentation() override;

  void UpdateColoringParameters() override;

private:
  vtkPVPointSplatRepresentation(const vtkPVPointSplatRepresentation&) = delete;
  void operator=(const vtkPVPointSplatRepresentation&) = delete;

  void PassSizeArray();
  void ProvideLessDetail(vtkInformation* inputs);
  void PrepareToDraw(vtkInformation* inputs);
  vtkDataObject* WithNeighbours(vtkDataObject* own);
  bool IsDrawnByMany(vtkInformation* inputs);

  vtkNew<vtkPVPointSplatMapper> SplatMapper;
  vtkNew<vtkPVPointSplatRegion> Region;
  // What is delivered to this process, and what it draws of it with other processes' points.
  vtkSmartPointer<vtkDataObject> Delivered;
  vtkMTimeType DeliveredTime = 0;
  vtkSmartPointer<vtkDataObject> Drawn;
  vtkSmartPointer<vtkDataObject> AttributesOf;
  vtkMTimeType AttributesTime = 0;
  bool SizeByArray = false;
  std::string SizeArray;
  // What the first of many processes tells of the last frame; Stride is 0 where nothing is gathered.
  std::string GatheredChoices;
  int GatheredStride = 0;
  int GatheredLayers = 0;
};

#endif
