// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointShadowTexture
 * @brief   tells of each point how much of each light reaches it
 *
 * Point cloud shadow textures (Dobrev, Rosenthal, Linsen 2010, An Image-space Approach to
 * Interactive Point Cloud Rendering Including Shadows and Transparency, section 6), as a point
 * array: it can be saved with the cloud, and vtkPointSplatMapper draws with it as long as light
 * and cloud stand to each other as they did. With its property Shadows on, the mapper computes the
 * same for itself when light or points change.
 *
 * Input 0: any vtkPointSet with point normals (3 components), and `SplatRadius` or `SplatAxis1` and
 * `SplatAxis2` (world units), by which it is known how far points are apart. What is missing is
 * estimated, as vtkPointSplatEstimation does. Disks end at the lines of `SplatClip`
 * (vtkPointSplatMapper). Input 1, optional and repeatable: vtkPolyData meshes
 * in the same coordinates, whose faces cast shadows on the points too.
 *
 * Output: vtkPolyData with the input's points, cells if it is vtkPolyData, and arrays, and
 * - `ShadowFactor` (a float for each light, in the order in which they were added): 0 in the
 *   shadow, 1 lit; of an area light the share of it that is seen.
 *
 * Stages, for each light:
 * 1. *Samples.* A light with a radius is sampled by NumberOfSamples point lights (or directions)
 *    on its disk: one jittered in each of as many parts of equal area, by the seed. Their
 *    results are averaged (section 6, Monte Carlo).
 * 2. *Shadow map.* All points are projected to an image from the light, as disks of their radius,
 *    so that their distance is known between them; meshes by their triangles. The nearest stays.
 *    Directional lights see the points in parallel; others through one frustum where they stand
 *    aside, else through the six faces of a cube.
 * 3. *Filling.* Holes that the disks leave are filled, by masks of 3 x 3 pixels (sections 3.2 and
 *    3.3).
 * 4. *Test.* A point is lit where it is no farther than d~ / |n_z| behind the map, where d~ is the
 *    least distance of two surface layers and n_z the normal's component along the light's ray;
 *    the factor 1 / |n_z| is bounded by 20.
 *
 * What a light's cone leaves out counts as lit: the cone is shading's. Points that face away from a
 * light are in the shadow of what lies before them, if anything does; shading gives them none of its
 * light anyway.
 *
 * Bad input: points that are ghosts, or whose coordinates, normal or size are not finite, cast no
 * shadow and get 1; their number is reported. Without lights, or where there is no OpenGL, or with
 * normals of a wrong shape: an error, and no array.
 *
 * @sa vtkPointSplatMapper vtkPointSplatEstimation vtkEGLHeadlessRenderWindow
 */
#ifndef vtkPointShadowTexture_h
#define vtkPointShadowTexture_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro
#include "vtkSmartPointer.h"                  // For the lights

#include "vtkPointSplattingABI.h"

#include <memory> // For std::unique_ptr
#include <vector> // For the lights

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderWindow;

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointShadowTexture : public vtkPolyDataAlgorithm
{
public:
  static vtkPointShadowTexture* New();
  vtkTypeMacro(vtkPointShadowTexture, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The lights: where they stand, whether they are positional, and their cones count; whether they
   * are switched on, or follow a camera, does not.
   */
  void AddLight(vtkLight* light);
  void RemoveAllLights();
  int GetNumberOfLights();
  vtkLight* GetLight(int index);
  ///@}

  ///@{
  /**
   * Meshes that stand in the light, in the points' coordinates.
   */
  void AddOccluderConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }
  void AddOccluderData(vtkPolyData* mesh);
  ///@}

  ///@{
  /**
   * How many samples a light with a radius is taken by; 16 by default.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 65536);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Of the samples' random places; 1 by default. The same seed gives the same factors.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The radius of the lights, which are disks that face along the light's direction: world units
   * for positional lights; for directional ones the tangent of the angle at which the radius is
   * seen (0.0047 for the sun). 0, the default: hard shadows, by one sample.
   */
  vtkSetClampMacro(LightRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * The least distance d~ between two surface layers, in world units: what lies closer to a
   * surface casts no shadow on it. 0, the default, is automatic: a splat radius of median size, or
   * 1.5 pixels of the shadow map if these are larger.
   */
  vtkSetClampMacro(LayerDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LayerDistance, double);
  ///@}

  ///@{
  /**
   * Pixels along the shadow map's longer side, or along each side of a cube's faces. 0, the
   * default, is automatic: such that a splat radius of median size has two pixels, down to one where
   * an area light has so few samples that finer outlines cannot be told, and no more
   * than 4096.
   */
  vtkSetClampMacro(Resolution, int, 0, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Whether compute shaders are taken where they are to be had (OpenGL 4.3), or the rasteriser.
   * On by default.
   */
  vtkSetMacro(UseComputeShaders, bool);
  vtkGetMacro(UseComputeShaders, bool);
  vtkBooleanMacro(UseComputeShaders, bool);
  ///@}

  ///@{
  /**
   * The window whose OpenGL context is used. None, the default: a vtkEGLHeadlessRenderWindow of the
   * filter's own.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /**
   * What the last execution took for the last light: d~ (world units; where it grows with the
   * distance from a positional light, the least), the size of a pixel of the shadow map (world
   * units; of a positional light at a distance of 1), and the pixels along its longer side.
   */
  vtkGetMacro(LayerDistanceUsed, double);
  vtkGetMacro(PixelSizeUsed, double);
  vtkGetMacro(ResolutionUsed, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkPointShadowTexture();
  ~vtkPointShadowTexture() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointShadowTexture(const vtkPointShadowTexture&) = delete;
  void operator=(const vtkPointShadowTexture&) = delete;

  bool Compute(vtkPointSet* input, vtkInformationVector* meshes, vtkPolyData* output);

  std::vector<vtkSmartPointer<vtkLight>> Lights;
  int NumberOfSamples = 16;
  int Seed = 1;
  double LightRadius = 0.0;
  double LayerDistance = 0.0;
  int Resolution = 0;
  bool UseComputeShaders = true;
  double LayerDistanceUsed = 0.0;
  double PixelSizeUsed = 0.0;
  int ResolutionUsed = 0;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
