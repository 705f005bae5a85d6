// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatPlainScene
 * @brief   a scene's splats as plain vertices, while something reads it that draws no splats
 *
 * Exporters that write geometry (vtkOBJExporter, vtkGLTFExporter, vtkX3DExporter, vtkPOVExporter,
 * vtkRIBExporter, vtkVRMLExporter ...) take the input of each actor's mapper: of points without cells
 * they write nothing, and of composite data nothing, or three of them crash (also
 * with vtkCompositePolyDataMapper2, VTK 9.1). No mapper can help that by itself: an exporter asks it for
 * nothing but the input, which is the user's own data object, and says nothing of being an exporter.
 * (Points that come with a vertex each are written as they are. vtkGL2PSExporter has VTK draw the
 * window, and gets the splats' picture.) Between Begin() and End() actors have other mappers:
 *
 * @code
 *   plain->SetRenderWindow(window);
 *   plain->Begin();
 *   exporter->Write();
 *   plain->End();
 * @endcode
 *
 * 1. Begin() finds the actors with a vtkPointSplatMapper, alone and in assemblies, in all renderers of
 *    the window, and gives each a vtkPolyDataMapper of the points as they are drawn: one vertex a
 *    point in one vtkPolyData, without points that splats leave out and without hidden blocks,
 *    with normals where given, and with colours (RGBA point scalars) where scalars or blocks have
 *    some. One warning says how many actors lose their surface. Those whose input has polygons or
 *    strips and is no composite keep it: their mesh is written.
 * 2. End() gives them back what they had; so does the destructor. An actor whose mapper was changed in
 *    between keeps the new one.
 *
 * Bad input: without a window there is an error; a second Begin() ends the first. Points of mappers
 * that were not drawn yet are prepared, which may estimate their sizes; no OpenGL is needed.
 *
 * @sa vtkPointSplatMapper
 */

#ifndef vtkPointSplatPlainScene_h
#define vtkPointSplatPlainScene_h

#include "vtkObject.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro

#include "vtkPointSplattingABI.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatPlainScene : public vtkObject
{
public:
  static vtkPointSplatPlainScene* New();
  vtkTypeMacro(vtkPointSplatPlainScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whose splats are replaced.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /**
   * Replaces mappers, and puts them back.
   */
  void Begin();
  void End();
  ///@}

  /**
   * How many actors have vertices now.
   */
  int GetNumberOfActors();

protected:
  vtkPointSplatPlainScene();
  ~vtkPointSplatPlainScene() override;

private:
  vtkPointSplatPlainScene(const vtkPointSplatPlainScene&) = delete;
  void operator=(const vtkPointSplatPlainScene&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
