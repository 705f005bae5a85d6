// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatBlockMapper
 * @brief   what vtkPointSplatMapper knows of the blocks of a composite input
 *
 * Each block of a composite data set may be hidden, and may have an opacity and a colour of its own,
 * as vtkCompositePolyDataMapper has it, by the same methods. Block: a node of the tree, by its flat
 * index (the root is 0, nodes count on in depth-first order, empty ones too), or the data object
 * itself (vtkCompositeDataDisplayAttributes). What is set of a node holds for all below it, unless a
 * node below says otherwise.
 *
 * 1. A hidden block is not drawn, casts no shadow, cannot be picked and does not count for the
 *    bounds. From the first change of visibility on what was estimated for blocks is kept, so that
 *    they come and go at once.
 * 2. A block's opacity takes the place of the actor's, and is multiplied with its scalars' opacity. If
 *    any block's is less than 1 the actor is translucent: opaque blocks are then opaque layers.
 * 3. A block's colour takes the place of ambient and diffuse colour and of scalars.
 *    InterpolateScalarsBeforeMapping has no effect then. Blocks without a colour or scalars have the
 *    diffuse colour of the actor. (Where actors with different properties share a mapper, that is the
 *    one of whichever was prepared last.)
 *
 * What is set by index stays with the index: where a filter makes blocks anew, or there is no input
 * yet, it is given to whatever data object comes to be there. vtkCompositePolyDataMapper forgets it.
 * SetCompositeDataDisplayAttributes() drops what was set by index; without attributes the first
 * setter makes some. They hold no references to data objects: what is set of an object that
 * vanishes has no effect.
 *
 * Bad input: NaN and infinity are refused with an error, others are clamped to 0 to 1; an index that
 * is not there has no effect. Block pickability and materials are not used.
 *
 * @sa vtkPointSplatMapper vtkCompositePolyDataMapper vtkCompositeDataDisplayAttributes
 */

#ifndef vtkPointSplatBlockMapper_h
#define vtkPointSplatBlockMapper_h

#include "vtkPolyDataMapper.h"
#include "vtkRenderingPointSplattingModule.h" // For export macro

#include "vtkPointSplattingABI.h"

#include <functional> // For std::function
#include <memory>     // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkCompositeDataDisplayAttributes;

class VTKRENDERINGPOINTSPLATTING_EXPORT vtkPointSplatBlockMapper : public vtkPolyDataMapper
{
public:
  vtkTypeMacro(vtkPointSplatBlockMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Visibility, opacity and colour of data objects. Default: none.
   */
  void SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes* attributes);
  vtkCompositeDataDisplayAttributes* GetCompositeDataDisplayAttributes();
  ///@}

  ///@{
  /**
   * Whether a block is drawn. Default: true.
   */
  void SetBlockVisibility(unsigned int index, bool visible);
  bool GetBlockVisibility(unsigned int index);
  void RemoveBlockVisibility(unsigned int index);
  void RemoveBlockVisibilities();
  ///@}

  ///@{
  /**
   * A block's opacity, 0 to 1. Default: the actor's; the getter returns 1 then.
   */
  void SetBlockOpacity(unsigned int index, double opacity);
  double GetBlockOpacity(unsigned int index);
  void RemoveBlockOpacity(unsigned int index);
  void RemoveBlockOpacities();
  ///@}

  ///@{
  /**
   * A block's colour, red, green and blue, 0 to 1. Default: the scalars' or the actor's; the getter
   * returns white then.
   */
  void SetBlockColor(unsigned int index, const double color[3]);
  void SetBlockColor(unsigned int index, double r, double g, double b)
  {
    const double color[3] = { r, g, b };
    this->SetBlockColor(index, color);
  }
  void GetBlockColor(unsigned int index, double color[3]);
  double* GetBlockColor(unsigned int index) VTK_SIZEHINT(3);
  void RemoveBlockColor(unsigned int index);
  void RemoveBlockColors();
  ///@}

  vtkMTimeType GetMTime() override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkPointSplatBlockMapper();
  ~vtkPointSplatBlockMapper() override;

  /**
   * What holds for a block, its own or of a node above.
   */
  struct BlockLook
  {
    bool Visible = true;
    bool HasColor = false;
    double Color[3] = { 1.0, 1.0, 1.0 };
    bool HasOpacity = false;
    double Opacity = 1.0;
  };

  /**
   * Calls visit with the flat index and the look of each leaf of the input, where any attributes are
   * set, else never. What was set by index is given to the data objects that are there now.
   */
  void VisitBlockLooks(const std::function<void(unsigned int, const BlockLook&)>& visit);

private:
  vtkPointSplatBlockMapper(const vtkPointSplatBlockMapper&) = delete;
  void operator=(const vtkPointSplatBlockMapper&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

VTK_ABI_NAMESPACE_END
#endif
