// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMapper
 * @brief   draws an oriented point cloud as the smooth surface that it samples
 *
 * Put this mapper where a vtkPolyDataMapper stood and give it points with
 * normals: the picture is the one that a fine mesh of the same surface gives,
 * with the same actor property, lights, lookup table, camera and picking. There
 * is no meshing, and nothing has to be set.
 *
 * The algorithm, each frame:
 * 1. Select. Splats outside the view are left out.
 * 2. Visibility splatting. Each splat is a disk in its tangent plane that bends as
 *    the surface does: the cap of a paraboloid h = -K(q, q) / 2 over the plane,
 *    where K is the second fundamental form. The depth of the nearest cap at each
 *    pixel is kept. Caps are projected perspectively correct, with their depth, by
 *    the ray's intersection in the splat's own coordinates, as for flat disks
 *    Guennebaud, Barthe, Paulin 2006 do it (section 3, equations 3 to 7). So
 *    silhouettes lie where the surface's are, but for third order; flat disks stand
 *    out by r^2 / 2R. Splats thinner than the prefilter are widened (section 4),
 *    but those that have a silhouette on them.
 * 3. Attribute accumulation. Every splat within the least layer distance of that
 *    depth, measured along its normal, adds its normal, depth and colour, weighted
 *    by a kernel: Gaussian, or the plateau family psi_E (Pajarola, Sainz, Guidotti
 *    2004, section 5.2, equations 9 and 10). The normal changes over the splat by
 *    half of what K says, with which the mean is right to second order. Splats that
 *    show their other side belong to another layer: behind a silhouette lies the far
 *    side of the body.
 * 4. Normalisation and deferred shading (Zhang, Pajarola 2006, equation 1), once a
 *    pixel, by VTK's own lighting formulas.
 * 5. Presentation: colour, opacity and depth go to the framebuffer as ordinary
 *    geometry does, so that meshes, volumes, SSAO, EDL and FXAA compose with it.
 *
 * All opaque splat actors of a renderer share stages 2 and 3.
 *
 * Input: vtkPolyData (or any vtkPointSet), or a composite data set of them. Only
 * points count; cells serve cell selection and cell scalars.
 * - Point normals, 3 components. Missing ones are estimated.
 * - `SplatRadius`, 1 component, world units; or `SplatAxis1` and `SplatAxis2`, 3
 *   components, world units, in the tangent plane. Missing ones are estimated.
 * - `SplatCurvature`, 6 components XX, YY, ZZ, XY, YZ, XZ, 1 / world units, beside
 *   `SplatRadius` and the normals that it belongs to: the second fundamental form,
 *   whose eigenvalues are 1 / R on a sphere with outward normals. It is estimated
 *   with the radius; where only that is given, and for ellipses, splats are flat.
 * - Scalars, as vtkMapper takes them: through the lookup table, or direct.
 *   InterpolateScalarsBeforeMapping is not honoured: colours are interpolated.
 * Points that are ghosts, or whose coordinates, normal or size are not finite or
 * not positive, are left out; their number is reported once, and by
 * GetNumberOfSkippedPoints().
 *
 * Images (compute; w x h are the viewport's): coded depths, 1 uint a pixel; sums,
 * 8 ints a pixel. Images (quads): the same as R32UI and two RGBA32F textures.
 *
 * A translucent actor shows its nearest layer at its opacity.
 *
 * @sa vtkPointSplatPass vtkPointSplatEstimation vtkIsosurfacePoints
 */

#ifndef vtkPointSplatMapper_h
#define vtkPointSplatMapper_h

#include "vtkPolyDataMapper.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro
#include "vtkSmartPointer.h"                  // For a return value

#include "vtkPointSplattingABI.h"

#include <memory> // For std::unique_ptr

struct vtkPointSplatItem;
struct vtkPointSplatView;
class vtkPointSplatCompositor;

VTK_ABI_NAMESPACE_BEGIN
class vtkUnsignedCharArray;

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatMapper : public vtkPolyDataMapper
{
public:
  static vtkPointSplatMapper* New();
  vtkTypeMacro(vtkPointSplatMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    AUTOMATIC_METHOD = 0,
    TWO_PASS = 1
  };
  enum ProjectionType
  {
    AUTOMATIC_PROJECTION = 0,
    COMPUTE = 1,
    QUADS = 2
  };
  enum KernelKind
  {
    GAUSSIAN = 0,
    PLATEAU = 1
  };

  ///@{
  /**
   * How surfaces are reconstructed from splats. Automatic, the default, chooses;
   * GetMethodUsed() tells what.
   */
  vtkSetClampMacro(Method, int, AUTOMATIC_METHOD, TWO_PASS);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC_METHOD); }
  void SetMethodToTwoPass() { this->SetMethod(TWO_PASS); }
  const char* GetMethodUsed();
  ///@}

  ///@{
  /**
   * How splats become pixels: by compute shaders, which need OpenGL 4.3, or by
   * quads through the rasteriser. Automatic, the default, takes compute shaders
   * where they are to be had; GetProjectionUsed() tells what the last frame took.
   */
  vtkSetClampMacro(Projection, int, AUTOMATIC_PROJECTION, QUADS);
  vtkGetMacro(Projection, int);
  void SetProjectionToAutomatic() { this->SetProjection(AUTOMATIC_PROJECTION); }
  void SetProjectionToCompute() { this->SetProjection(COMPUTE); }
  void SetProjectionToQuads() { this->SetProjection(QUADS); }
  const char* GetProjectionUsed();
  ///@}

  ///@{
  /**
   * The kernel that weights splats where they overlap. Default: Gaussian.
   */
  vtkSetClampMacro(Kernel, int, GAUSSIAN, PLATEAU);
  vtkGetMacro(Kernel, int);
  void SetKernelToGaussian() { this->SetKernel(GAUSSIAN); }
  void SetKernelToPlateau() { this->SetKernel(PLATEAU); }
  ///@}

  ///@{
  /**
   * The Gaussian's sigma, as a fraction of the splat's radius. Default: 0.6.
   */
  vtkSetClampMacro(KernelSigma, double, 0.05, 10.0);
  vtkGetMacro(KernelSigma, double);
  ///@}

  ///@{
  /**
   * The plateau kernel's a and n: a larger a makes it narrower, a larger n
   * flatter in the middle and steeper at the rim. Defaults: 4 and 5.
   */
  vtkSetClampMacro(PlateauFalloff, double, 0.01, 1000.0);
  vtkGetMacro(PlateauFalloff, double);
  vtkSetClampMacro(PlateauExponent, double, 1.0, 100.0);
  vtkGetMacro(PlateauExponent, double);
  ///@}

  ///@{
  /**
   * Where kernels end, in radii: b of the plateau kernels. Default: 1.5.
   */
  vtkSetClampMacro(KernelSupport, double, 1.0, 4.0);
  vtkGetMacro(KernelSupport, double);
  ///@}

  ///@{
  /**
   * Multiplies all radii and axes. Default: 1.
   */
  vtkSetClampMacro(RadiusScale, double, 1e-6, 1e6);
  vtkGetMacro(RadiusScale, double);
  ///@}

  ///@{
  /**
   * The least distance between two surface layers, in world units, measured along
   * the normal: what is nearer than this belongs to one layer. 0, the default, is
   * automatic: a fraction of each splat's own radius. GetLayerDistanceUsed() gives
   * the distance for a splat of median size.
   */
  vtkSetClampMacro(LayerDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LayerDistance, double);
  double GetLayerDistanceUsed();
  ///@}

  ///@{
  /**
   * Of the input when last drawn: splats, and points that are not drawn.
   */
  vtkIdType GetNumberOfSplats();
  vtkIdType GetNumberOfSkippedPoints();
  ///@}

  /**
   * Bytes of the images that the last frame used, shared by all splat actors of
   * its renderer.
   */
  vtkIdType GetImageMemorySize();

  /**
   * The input, polygonal or composite or any other point set.
   */
  void SetInputDataObject(vtkDataObject* input) { this->SetInputDataObject(0, input); }
  using vtkPolyDataMapper::SetInputDataObject;
  bool HasCompositeInput();

  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  bool HasTranslucentPolygonalGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  bool GetSupportsSelection() override { return true; }

protected:
  vtkPointSplatMapper();
  ~vtkPointSplatMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkExecutive* CreateDefaultExecutive() override;
  void ComputeBounds() override;

private:
  vtkPointSplatMapper(const vtkPointSplatMapper&) = delete;
  void operator=(const vtkPointSplatMapper&) = delete;

  friend class vtkPointSplatCompositor;
  friend class vtkPointSplatCloud;

  /**
   * Brings the pipeline and the splats up to date; false where there is nothing
   * to draw.
   */
  bool UpdateCloud();
  void UpdateInput();
  void FillItem(vtkActor* actor, const vtkPointSplatView& view, vtkPointSplatItem& item);
  vtkSmartPointer<vtkUnsignedCharArray> MapPointColours(vtkDataSet* data, int& cellFlag);

  int Method = AUTOMATIC_METHOD;
  int Projection = AUTOMATIC_PROJECTION;
  int Kernel = GAUSSIAN;
  double KernelSigma = 0.6;
  double PlateauFalloff = 4.0;
  double PlateauExponent = 5.0;
  double KernelSupport = 1.5;
  double RadiusScale = 1.0;
  double LayerDistance = 0.0;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
