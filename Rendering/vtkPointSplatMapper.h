// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMapper
 * @brief   draws an oriented point cloud as the smooth surface that it samples
 *
 * Put this mapper where a vtkPolyDataMapper stood and give it points with normals: the picture is
 * the one that a fine mesh of the same surface gives, with the same actor property, lights, lookup
 * table, camera and picking. There is no meshing, and nothing has to be set.
 *
 * The algorithm, each frame, for all splat actors of a renderer together:
 * 1. Select. Blocks of splats out of view are left out; others may be coarser (LevelOfDetail).
 * 2. Project. Each splat is the cap of a paraboloid over its tangent plane, which bends as the
 *    surface does. It is projected once, perspectively correct, and listed in the tiles of the image
 *    that it touches (vtkPointSplatProjection.glsl; after Guennebaud, Barthe, Paulin 2006, section 3).
 * 3. Reconstruct. In each tile the depth of the nearest cap at each pixel is found, and then the
 *    mean of the normals, depths and colours of all splats within the least layer distance of it
 *    (Zhang, Pajarola 2006, equation 1), weighted by a kernel (Pajarola, Sainz, Guidotti 2004,
 *    equations 9 and 10), and the less the farther off, so that surfaces that cross don't blend.
 *    Splats narrower than a pixel are widened (after Guennebaud, section 4). Where
 *    surfaces are translucent the next layer is made of what is left (Guennebaud, section 6).
 * 4. Shade, by VTK's own lighting formulas, once a pixel and layer.
 * 5. Present. Colour, opacity and depth go to the framebuffer as ordinary geometry does, so that
 *    meshes, volumes, SSAO, EDL, FXAA and depth peeling compose with it.
 *
 * Without compute shaders (OpenGL 3.2 to 4.2) stage 3 is two passes of quads, with the same
 * picture. Other methods may be asked for: deferred blending (SetMethodToDeferred()), points of one
 * pixel with holes filled in image space (SetMethodToImageSpace()), sorted layers
 * (SetTransparencyToSorted(), SetTransparencyToNearestExact()).
 *
 * Input: vtkPolyData (or any vtkPointSet), or a composite data set of them. Points become splats, but
 * for those that no cell uses where there are cells, which VTK does not draw either. Cells serve cell
 * selection and cell scalars; splats end at a mesh's borders; triangles are drawn where Hybrid says
 * so. Blocks may be hidden, and have colours and opacities of their own: vtkPointSplatBlockMapper.
 * - Point normals, 3 components. Missing ones are those of triangles, or are estimated.
 * - `SplatRadius`, 1 component, world units; or `SplatAxis1` and `SplatAxis2`, 3 components, world
 *   units, in the tangent plane. Missing ones are estimated.
 * - `SplatCurvature`, 6 components XX, YY, ZZ, XY, YZ, XZ, 1 / world units, beside `SplatRadius`:
 *   the second fundamental form, whose eigenvalues are 1 / R on a sphere with outward normals. It
 *   is estimated with the radius; where only that is given, and for ellipses, splats are flat.
 * - `SplatClip`, 6 components, two vectors, 1 / world units: lines at which splats end, at creases and
 *   borders, so that edges are straight and sharp (vtkPointSplatArrays.h). Method ImageSpace does without.
 * - `SplatFold`, 6 components, two unit vectors or 0, beside `SplatRadius`, `SplatPlaneNormal` and
 *   `SplatClip`: the splat goes on behind its lines in the planes with these normals, as one more
 *   each, of the same point (GetNumberOfSplats() counts them).
 * - `SplatGroup`, 1 component, for deferred blending; for sorted transparency where each group
 *   covers the surface (vtkPointSplatGrouping with a Coverage and a Reach of 1). Missing ones are
 *   made.
 * - `ShadowFactor`, 1 to 4 components, 0 in a light's shadow, 1 lit: see Shadows.
 * - Scalars, as vtkMapper takes them: through the lookup table, or direct. Colours of points are
 *   blended; with InterpolateScalarsBeforeMappingOn() values are, and each pixel's is mapped, where
 *   vtkMapper can do that (not direct colours, indexed tables, a block without scalars). A splat
 *   whose value is NaN has the table's colour of NaN, and leaves the values about it as they are.
 * - Scalars of cells, where there are none of points or ScalarMode asks for them: a splat has the
 *   colour of its point's cell, of several the one with the least id; a pixel has the colour of one
 *   splat. Of field data each cell has a tuple, or all have the one of FieldDataTupleId.
 * - Cell normals are not used; a warning says so where there are no others.
 *
 * The property's representation as points or wireframe is VTK's own: its mapper draws the input's
 * cells, or, where there are none that it can draw, each point as a vertex, lit and picked as by
 * vtkPolyDataMapper. Flat interpolation gives a splat one tone: a pixel has the normal of the splat
 * with the greatest weight (not by quads where scalars are of cells). Physically based interpolation,
 * textures, tangents and edges are those of VTK's meshes. What of the actor's looks splats do not
 * show is named in a warning, once: VertexVisibility, shader code of its own, and, by quads, sorted
 * layers or another Method than two passes, textures, Anisotropy and EdgeVisibility.
 *
 * Points at one place whose splats are the same, as corners of triangles that share no points have them, are drawn
 * by one with the mean of their normals and colours (GetNumberOfCopies()), unless texture coordinates differ.
 *
 * Bad input: points that are ghosts, or whose coordinates, normal or size are not finite or not
 * positive, or that lie farther off than a million times what the middle half of all points spans,
 * are left out; their number is reported once, and by GetNumberOfSkippedPoints(). So are points of ghost
 * or blanked cells alone. Arrays of a wrong shape are refused with an error that names them. Cells may
 * name points that are not there. Clip lines that are not finite cut nothing; a line counts as at least a millionth of a radius away.
 * Given radii of less than a quarter of the points' spacing or more than four times that, in the
 * median, are drawn with a warning: no filter of VTK's scales `SplatRadius` and `SplatCurvature`, which
 * after a vtkTransformFilter must be estimated anew. An actor's scale acts on all alike. NaN is
 * refused by all setters. In a window without an OpenGL context nothing is drawn; in one that is not
 * OpenGL's (WebGPU) VTK's own mapper draws as for wireframe, with one warning.
 *
 * Progress: while sizes and normals are estimated, ProgressEvent tells how much is done, and
 * AbortExecuteOn() ends it; nothing is drawn then, and the next Render() begins anew.
 *
 * @sa vtkPointSplatPass vtkPointSplatEstimation vtkIsosurfacePoints
 */
#ifndef vtkPointSplatMapper_h
#define vtkPointSplatMapper_h

#include "vtkPointSplatBlockMapper.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro

#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatMapper : public vtkPointSplatBlockMapper
{
public:
  static vtkPointSplatMapper* New();
  vtkTypeMacro(vtkPointSplatMapper, vtkPointSplatBlockMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    AUTOMATIC_METHOD = 0,
    TWO_PASS = 1,
    DEFERRED = 2,
    IMAGE_SPACE = 3
  };
  enum TransparencyType
  {
    AUTOMATIC_TRANSPARENCY = 0,
    PEELING = 1,
    SORTED = 2,
    NEAREST_EXACT = 3
  };
  enum ProjectionType
  {
    AUTOMATIC_PROJECTION = 0,
    COMPUTE = 1,
    QUADS = 2
  };
  enum TileListsType
  {
    AUTOMATIC_LISTS = 0,
    PROCESSOR = 1,
    DEVICE = 2
  };
  enum HybridType
  {
    HYBRID_OFF = 0,
    AUTOMATIC_HYBRID = 1
  };
  enum KernelKind
  {
    GAUSSIAN = 0,
    PLATEAU = 1
  };

  ///@{
  /**
   * The largest error, as rms difference of colour (of 1) over the covered pixels, that leaving
   * work out may make against this module's best picture of the scene; of all splat mappers of a
   * renderer the least holds. 1/256, the default, is full quality. A greater one lets splats that
   * are denser than pixels be fewer and larger, layers that hardly show be left out, and shadows
   * have fewer samples; from 1/32 on outlines are not smoothed. A first frame has all splats and
   * layers, and measures what fewer would lose; so has one after the camera has turned by half a
   * right angle or things look twice as large or half, and one of thirty that show others. While the user drags (the window's desired update rate is higher
   * than the interactor's still one) and frames take longer than the actors' AllocatedRenderTime,
   * errors up to 1/32 are allowed, where that saves a quarter of the frame at least; at rest all is
   * drawn in full quality. GetChoices() tells what the last frame chose and why, a line each.
   */
  vtkPointSplatSetClampMacro(TargetError, 0.0, 1.0);
  vtkGetMacro(TargetError, double);
  const char* GetChoices();
  ///@}

  ///@{
  /**
   * How surfaces are reconstructed. Automatic, the default, takes two passes over the splats of
   * each tile: the nearest surface, then the mean of what belongs to it. Deferred draws splats once,
   * in groups that overlap little, to an image each (Zhang, Pajarola 2006, section 3.2); one splat
   * mapper of a renderer that wants it decides for all, and where it cannot be had there is a
   * warning. ImageSpace projects points without a size as single pixels and fills the holes between
   * them in the image (Dobrev, Rosenthal, Linsen 2010, section 3): for points that are denser than
   * pixels. GetMethodUsed() tells what the last frame took, and GetMethodReason() why.
   */
  vtkSetClampMacro(Method, int, AUTOMATIC_METHOD, IMAGE_SPACE);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC_METHOD); }
  void SetMethodToTwoPass() { this->SetMethod(TWO_PASS); }
  void SetMethodToDeferred() { this->SetMethod(DEFERRED); }
  void SetMethodToImageSpace() { this->SetMethod(IMAGE_SPACE); }
  const char* GetMethodUsed();
  const char* GetMethodReason();
  ///@}

  ///@{
  /**
   * How translucent splat actors are drawn. Automatic, the default, peels layer after layer, each in
   * full quality. Sorted draws groups of splats once, from the back, and averages them (Zhang,
   * Pajarola 2006, Algorithm 2); NearestExact peels the nearest layer and sorts the others (Algorithm
   * 3). Sorted layers cannot be interleaved with other translucent props: where there are some,
   * layers are peeled. One mapper of a renderer that wants another way than automatic decides for
   * all. GetTransparencyUsed() tells what was done.
   */
  vtkSetClampMacro(Transparency, int, AUTOMATIC_TRANSPARENCY, NEAREST_EXACT);
  vtkGetMacro(Transparency, int);
  void SetTransparencyToAutomatic() { this->SetTransparency(AUTOMATIC_TRANSPARENCY); }
  void SetTransparencyToPeeling() { this->SetTransparency(PEELING); }
  void SetTransparencyToSorted() { this->SetTransparency(SORTED); }
  void SetTransparencyToNearestExact() { this->SetTransparency(NEAREST_EXACT); }
  const char* GetTransparencyUsed();
  ///@}

  ///@{
  /**
   * The most layers that are peeled, 32 by default; the largest of a renderer's splat actors holds.
   * Peeling ends sooner where what is left could not change the picture by TargetError.
   */
  vtkSetClampMacro(MaximumNumberOfLayers, int, 1, 256);
  vtkGetMacro(MaximumNumberOfLayers, int);
  int GetNumberOfLayersDrawn();
  ///@}

  ///@{
  /**
   * Whether the last of MaximumNumberOfLayers gathers all that lies behind the others, weighted by
   * opacity (Guennebaud 2006, section 6), or has its own surface alone. Off by default.
   */
  vtkSetMacro(GatherRemaining, bool);
  vtkGetMacro(GatherRemaining, bool);
  vtkBooleanMacro(GatherRemaining, bool);
  ///@}

  ///@{
  /**
   * Hardware selection looks through actors of less opacity than this. 0, the default: through none.
   */
  vtkPointSplatSetClampMacro(PickOpacityThreshold, 0.0, 1.0);
  vtkGetMacro(PickOpacityThreshold, double);
  ///@}

  ///@{
  /**
   * Whether the surface reflects and refracts the renderer's environment texture, as the boundary
   * of a dielectric does (vtkRenderer::SetEnvironmentTexture(), an equirectangular picture or a cube
   * map, turned by SetEnvironmentUp() and SetEnvironmentRight(); UseImageBasedLighting is not
   * needed). Off by default. Normals must point out of the body. Clear glass has opacity 0; VTK
   * picks no actor of opacity 0, 0.001 shows the same. The surface's own colours come over what is
   * refracted; where the opaque scene lies behind, that is seen straight through. Without an
   * environment texture, or with a cube map that VTK cannot load, it stays off, with a warning.
   */
  vtkSetMacro(Refraction, bool);
  vtkGetMacro(Refraction, bool);
  vtkBooleanMacro(Refraction, bool);
  ///@}

  ///@{
  /**
   * Of refraction: the index of refraction of the body against the air around, 1 to 4; with 1
   * nothing is bent or reflected. Default: 1.5, as glass has it. And how much larger it is for blue
   * light than for red, relative to RefractiveIndex, which is green's: n (1 - Dispersion / 2), n,
   * n (1 + Dispersion / 2), not less than 1. 0 to 1; glass has 0.01 to 0.04. Default: 0.
   */
  vtkPointSplatSetClampMacro(RefractiveIndex, 1.0, 4.0);
  vtkGetMacro(RefractiveIndex, double);
  vtkPointSplatSetClampMacro(Dispersion, 0.0, 1.0);
  vtkGetMacro(Dispersion, double);
  ///@}

  ///@{
  /**
   * Of refraction: how much red, green and blue light the body absorbs on its way from one
   * interface to the next, in 1 / world units: exp(-a d) of it remains after the distance d.
   * Not negative. Default: 0, 0, 0. It acts on the environment's light through peeled layers; the
   * layers' own opacity takes (1 - alpha)^l of it besides (Zhang, Pajarola 2006, equation 11).
   */
  void SetAbsorption(double red, double green, double blue);
  void SetAbsorption(const double absorption[3])
  {
    this->SetAbsorption(absorption[0], absorption[1], absorption[2]);
  }
  vtkGetVector3Macro(Absorption, double);
  ///@}

  ///@{
  /**
   * Of deferred blending, where the input has no `SplatGroup`: the factor c on the distance at which
   * splats count as overlapping when they are grouped; those that face opposite ways, or lie in one
   * plane and look the same, do not (Zhang, Pajarola 2006, section 4.1). 1 gives the picture of two
   * passes; less gives fewer groups and small faults. Default: 0.8. And whether splats of a group that
   * overlap meet halfway between their centres (the default), or the nearer one hides the other.
   */
  vtkPointSplatSetClampMacro(OverlapFactor, 0.01, 1.0);
  vtkGetMacro(OverlapFactor, double);
  vtkSetMacro(VoronoiDepth, bool);
  vtkGetMacro(VoronoiDepth, bool);
  vtkBooleanMacro(VoronoiDepth, bool);
  ///@}

  ///@{
  /**
   * Bytes that the groups' images may take, 20 a pixel and group: past it, two passes are taken,
   * with a warning. And bytes that translucent layers may take, 16 to 64 a pixel and layer: past
   * it, no further ones are peeled. 0: no bound. Default: 1 GiB. MaximumWindowMemory: bytes that
   * the images of a layer may take, 28 a pixel of the window by tiles (60 with textures), 76 else:
   * larger windows are drawn in parts of at least 256 x 256 pixels, with the same picture. Not with
   * depth peeling; rays of Refraction end at parts' rims. 0: no bound. Default: 4 GiB.
   */
  vtkSetClampMacro(MaximumImageMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumImageMemory, vtkIdType);
  vtkSetClampMacro(MaximumWindowMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumWindowMemory, vtkIdType);
  ///@}

  ///@{
  /**
   * Of Method ImageSpace: how often holes are filled in a frame at most, each time by a pixel from
   * their rims, and no oftener than something changes. Default: 2; more close wider holes, and fill
   * creases. Points as dense as pixels take one step. GetNumberOfFillSteps(): of the last frame.
   * GetProjectedSpacing() is how far apart, in pixels, points were at the nearest corner of their
   * bounding box: holes may stay where it is more than 8.
   */
  vtkSetClampMacro(MaximumNumberOfFillSteps, int, 1, 64);
  vtkGetMacro(MaximumNumberOfFillSteps, int);
  int GetNumberOfFillSteps();
  double GetProjectedSpacing();
  ///@}

  /**
   * How many splats of blocks in view the last frame projected; where there are so many that parts of
   * the window are drawn one after the other, a block counts for each part that shows it.
   */
  vtkIdType GetNumberOfPointsProjected();

  ///@{
  /**
   * Whether points whose normals, given or estimated, and positions contradict their neighbours', as in range
   * scans that overlap, are drawn where vtkPointSplatProjection moves them: onto one surface, by
   * less than their noise. On by default; then clouds are projected that are noisy as vtkPointSplatEstimation::IsNoisy()
   * says, and not IsCrumpled() once they are. Others, as layers upon one another, isosurfaces of noisy volumes,
   * and points with sizes of their own, are drawn where they are. The input is not changed.
   * FillGaps, on by default: where sizes are estimated, vtkPointSplatEstimation's fill points are drawn,
   * too, each as one more splat of the point that it is nearest to; not where Hybrid draws triangles.
   */
  vtkSetMacro(ProjectNoise, bool);
  vtkGetMacro(ProjectNoise, bool);
  vtkBooleanMacro(ProjectNoise, bool);
  vtkSetMacro(FillGaps, bool);
  vtkGetMacro(FillGaps, bool);
  vtkBooleanMacro(FillGaps, bool);
  ///@}

  ///@{
  /**
   * Whether points that move keep the sizes that were estimated for them: where nothing but positions and normals
   * changed, splats are moved along, turned and stretched as their neighbours are, unless more than one
   * point in a hundred is strained by more than some 40 % (a square to a rectangle of 3 to 2) since; then
   * sizes are estimated anew, which takes ten times as long as to draw them. On by default. Off: points that
   * changed are a cloud of their own. Points without normals, with sizes other than SplatRadius, that are
   * projected, or of which some cannot be drawn, are not followed.
   */
  vtkSetMacro(FollowMotion, bool);
  vtkGetMacro(FollowMotion, bool);
  vtkBooleanMacro(FollowMotion, bool);
  ///@}

  ///@{
  /**
   * Whether outlines are smooth: four samples tell what surfaces share a pixel that one runs
   * through, and its colour is their mean; in multisampled framebuffers each of their samples has
   * the nearest one's colour and depth. With other framebuffers, what outlines run before shows
   * through opaque surfaces there, and pixels are covered or not where an opaque prop that is no
   * splat's is drawn after them, since it could not. Not with Refraction, where splats are drawn by
   * quads or Method is Deferred, where TargetError is 1/32 or more, or beside a mapper that has it off. With Method ImageSpace pixels at
   * silhouettes, which the Laplacian of the depth finds, are blended with what lies beyond (Dobrev,
   * Rosenthal, Linsen 2010, section 3.5), half and half, since points mark all of the pixel that
   * they fall in. On by default.
   */
  vtkSetMacro(AntiAliasing, bool);
  vtkGetMacro(AntiAliasing, bool);
  vtkBooleanMacro(AntiAliasing, bool);
  ///@}

  ///@{
  /**
   * Whether splats stand for points much denser than pixels: vtkPointSplatOctree. On by default.
   * And whether a random part of large clouds is drawn first, then more: of a million points whose
   * sizes must be estimated, of eight million with sizes; not of composite data, nor where colours are
   * of cells. Only a window on a screen whose interactor was initialized before Render(), and has
   * timers, is asked for more frames so, and for one when levels are ready; in others Render() draws
   * all points, however long that takes. Picked ids and bounds are those of all. A thread holds a copy
   * of the arrays meanwhile, ProgressEvent comes between frames, and AbortExecuteOn() leaves it at what
   * is drawn. IsProgressing(): the last frame is one before others; who writes a picture of a window
   * on a screen waits for them, or has Progressive off. On by default.
   */
  vtkSetMacro(LevelOfDetail, bool);
  vtkGetMacro(LevelOfDetail, bool);
  vtkBooleanMacro(LevelOfDetail, bool);
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  bool IsProgressing();
  ///@}

  ///@{
  /**
   * Whether a mesh (polygons or strips of vtkPolyData) is drawn as triangles where these are
   * magnified, and as splats, and those of levels, elsewhere (Guennebaud, Barthe, Paulin 2006, section
   * 5). It is decided for patches of about a hundred points: where their edges are more than four
   * pixels long in the image, or a third of the longest one is, there are triangles. Both go into the
   * same layers; there triangles weigh what the sum of the splats' weights leaves of 1, which falls to
   * 0 where splats end, so that no seam shows. Edges and creases are the mesh's, and a cell is selected
   * as itself. Vertices without a triangle are splats, so that a mesh may patch a scan. All is drawn as
   * splats with scalars of cells, textures, tangents, visible edges, GatherRemaining and without
   * compute shaders, and by the other methods. Shadows are known at points, and cast by coarse triangles.
   * Off by default: the first frame takes 0.1 us a triangle longer, and memory is 40 bytes a triangle.
   * GetNumberOfTrianglesProjected(): of the last frame, as GetNumberOfPointsProjected().
   */
  vtkSetClampMacro(Hybrid, int, HYBRID_OFF, AUTOMATIC_HYBRID);
  vtkGetMacro(Hybrid, int);
  void SetHybridToOff() { this->SetHybrid(HYBRID_OFF); }
  void SetHybridToAutomatic() { this->SetHybrid(AUTOMATIC_HYBRID); }
  vtkIdType GetNumberOfTrianglesProjected();
  ///@}

  ///@{
  /**
   * The groups that the splats are divided into, 0 before deferred blending was first used; and when
   * that was done: once until points or OverlapFactor change, or whether they have colours.
   */
  int GetNumberOfGroups();
  vtkMTimeType GetGroupMTime();
  ///@}

  ///@{
  /**
   * Whether lights cast shadows on these points (Dobrev, Rosenthal, Linsen 2010, section 6): how
   * much of each light arrives at each point is computed as vtkPointShadowTexture does it, and
   * again only when lights, points, their actors or meshes change. All splat actors of the renderer
   * cast, translucent ones by taking away part of the light's colour, and all opaque meshes' faces,
   * but for what is clipped away; on meshes shadows fall by vtkPointSplatShadowPass. The first four
   * lights that are on and no headlights cast. Off by default: then the input's array
   * `ShadowFactor` is used, if there is one, of the same lights.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Of area lights: how many samples are taken of each, 16 by default, and how many while the
   * user drags, 1 by default; fewer if they keep to TargetError. Shadows that were computed with
   * more stay as long as they are right. The largest numbers of all mappers in the renderer hold.
   * GetNumberOfShadowSamplesUsed(): of the last frame; GetNumberOfShadowUpdates() counts them.
   */
  vtkSetClampMacro(NumberOfShadowSamples, int, 1, 65536);
  vtkGetMacro(NumberOfShadowSamples, int);
  vtkSetClampMacro(NumberOfInteractiveShadowSamples, int, 1, 65536);
  vtkGetMacro(NumberOfInteractiveShadowSamples, int);
  int GetNumberOfShadowSamplesUsed();
  unsigned long GetNumberOfShadowUpdates();
  ///@}

  ///@{
  /**
   * As vtkPointShadowTexture's LightRadius, Seed, LayerDistance and Resolution. The first mapper's
   * of a renderer that has Shadows on hold for all.
   */
  vtkPointSplatSetClampMacro(ShadowLightRadius, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ShadowLightRadius, double);
  vtkSetMacro(ShadowSeed, int);
  vtkGetMacro(ShadowSeed, int);
  vtkPointSplatSetClampMacro(ShadowLayerDistance, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ShadowLayerDistance, double);
  vtkSetClampMacro(ShadowResolution, int, 0, 16384);
  vtkGetMacro(ShadowResolution, int);
  ///@}

  ///@{
  /**
   * How splats become pixels: by compute shaders, tile after tile of the image, which need OpenGL
   * 4.3, or by quads through the rasteriser. Automatic, the default, takes compute shaders where they
   * are to be had; GetProjectionUsed() tells what the last frame took.
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
   * Of compute shaders: whether the processor or the device lists the splats of each tile. The
   * picture is the same. Automatic, the default, takes the processor where the driver runs on it
   * anyway, as Mesa's llvmpipe does, else the device.
   */
  vtkSetClampMacro(TileLists, int, AUTOMATIC_LISTS, DEVICE);
  vtkGetMacro(TileLists, int);
  void SetTileListsToAutomatic() { this->SetTileLists(AUTOMATIC_LISTS); }
  void SetTileListsToProcessor() { this->SetTileLists(PROCESSOR); }
  void SetTileListsToDevice() { this->SetTileLists(DEVICE); }
  ///@}

  ///@{
  /**
   * The kernel that weights splats where they overlap. Default: Gaussian. Its sigma, as a fraction
   * of the splat's radius. Default: 0.6. Of the plateau kernel a and n: a larger a makes it narrower,
   * a larger n flatter in the middle and steeper at the rim. Defaults: 4 and 5. And where kernels
   * end, in radii: b of the plateau kernels. Default: 1.5.
   */
  vtkSetClampMacro(Kernel, int, GAUSSIAN, PLATEAU);
  vtkGetMacro(Kernel, int);
  void SetKernelToGaussian() { this->SetKernel(GAUSSIAN); }
  void SetKernelToPlateau() { this->SetKernel(PLATEAU); }
  vtkPointSplatSetClampMacro(KernelSigma, 0.05, 10.0);
  vtkGetMacro(KernelSigma, double);
  vtkPointSplatSetClampMacro(PlateauFalloff, 0.01, 1000.0);
  vtkGetMacro(PlateauFalloff, double);
  vtkPointSplatSetClampMacro(PlateauExponent, 1.0, 100.0);
  vtkGetMacro(PlateauExponent, double);
  vtkPointSplatSetClampMacro(KernelSupport, 1.0, 4.0);
  vtkGetMacro(KernelSupport, double);
  ///@}

  ///@{
  /**
   * Multiplies all radii and axes. Default: 1. At most 8: some 2 RadiusScale^2 splats overlap at each
   * pixel, and frames take as many times longer, while the picture is but blurred.
   */
  vtkPointSplatSetClampMacro(RadiusScale, 1e-6, 8.0);
  vtkGetMacro(RadiusScale, double);
  ///@}

  ///@{
  /**
   * The least distance between two surface layers, in world units, measured along the normal: what is nearer than this
   * belongs to one layer, with a weight that falls to 0 there. 0, the default, is automatic: each splat's own radius, at
   * edges of flat faces a tenth of it. GetLayerDistanceUsed() gives the distance for a splat of median size.
   */
  vtkPointSplatSetClampMacro(LayerDistance, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LayerDistance, double);
  double GetLayerDistanceUsed();
  ///@}

  ///@{
  /**
   * Of the input when last drawn: splats, points that are not drawn, and copies, which others' splats are drawn for.
   * Where TargetError or a drag lets splats be fewer, only every GetStride()-th of them was drawn. And bytes
   * of the images that the last frame used, shared by all splat actors of its renderer.
   */
  vtkIdType GetNumberOfSplats();
  int GetStride();
  vtkIdType GetNumberOfSkippedPoints();
  vtkIdType GetNumberOfCopies();
  vtkIdType GetImageMemorySize();
  ///@}

  /// The input, polygonal or composite or any other point set.
  void SetInputDataObject(vtkDataObject* input) { this->SetInputDataObject(0, input); }
  using vtkPolyDataMapper::SetInputDataObject;
  bool HasCompositeInput();

  /// The points as an actor draws them, as plain vertices: see vtkPointSplatPlainScene.
  void GetVertices(vtkActor* actor, vtkPolyData* vertices);

  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  bool HasTranslucentPolygonalGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  bool GetSupportsSelection() override { return true; }
  void ProcessSelectorPixelBuffers(vtkHardwareSelector* selector,
    std::vector<unsigned int>& pixelOffsets, vtkProp* prop) override;

protected:
  vtkPointSplatMapper();
  ~vtkPointSplatMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkExecutive* CreateDefaultExecutive() override;
  void ComputeBounds() override;

private:
  vtkPointSplatMapper(const vtkPointSplatMapper&) = delete;
  void operator=(const vtkPointSplatMapper&) = delete;

  double TargetError = 1.0 / 256.0;
  int Method = AUTOMATIC_METHOD;
  int Transparency = AUTOMATIC_TRANSPARENCY;
  int MaximumNumberOfLayers = 32;
  bool GatherRemaining = false;
  double PickOpacityThreshold = 0.0;
  bool Refraction = false;
  double RefractiveIndex = 1.5;
  double Dispersion = 0.0;
  double Absorption[3] = { 0.0, 0.0, 0.0 };
  double OverlapFactor = 0.8;
  bool VoronoiDepth = true;
  vtkIdType MaximumImageMemory = vtkIdType(1) << 30;
  vtkIdType MaximumWindowMemory = vtkIdType(1) << 32;
  int MaximumNumberOfFillSteps = 2;
  bool AntiAliasing = true;
  bool LevelOfDetail = true;
  int Hybrid = HYBRID_OFF;
  bool Progressive = true;
  bool ProjectNoise = true;
  bool FillGaps = true;
  bool FollowMotion = true;
  bool Shadows = false;
  int NumberOfShadowSamples = 16;
  int NumberOfInteractiveShadowSamples = 1;
  double ShadowLightRadius = 0.0;
  int ShadowSeed = 1;
  double ShadowLayerDistance = 0.0;
  int ShadowResolution = 0;
  int Projection = AUTOMATIC_PROJECTION;
  int TileLists = AUTOMATIC_LISTS;
  int Kernel = GAUSSIAN;
  double KernelSigma = 0.6;
  double PlateauFalloff = 4.0;
  double PlateauExponent = 5.0;
  double KernelSupport = 1.5;
  double RadiusScale = 1.0;
  double LayerDistance = 0.0;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
