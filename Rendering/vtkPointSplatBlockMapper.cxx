// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBlockMapper.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/**
 * Calls visit(flat index, node, what the node above has) of a node and all below it; what visit
 * returns is handed on to those below.
 */
template <typename Handed, typename Visit>
void Walk(vtkDataObject* node, const Handed& above, unsigned int& index, Visit&& visit)
{
  const Handed own = visit(index++, node, above);
  vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(node);
  if (!tree)
  {
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  it->TraverseSubTreeOff();
  it->VisitOnlyLeavesOff();
  it->SkipEmptyNodesOff();
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    Walk(it->GetCurrentDataObject(), own, index, visit);
  }
}
}

class vtkPointSplatBlockMapper::vtkInternals
{
public:
  /**
   * What was set by index, and the data object that has it now. That is compared only: it may be
   * gone.
   */
  struct Wish
  {
    std::optional<bool> Visible;
    std::optional<double> Opacity;
    std::optional<std::array<double, 3>> Color;
    vtkDataObject* GivenTo = nullptr;
  };

  vtkDataObject* FindNode(vtkDataObject* root, unsigned int wanted) const
  {
    vtkDataObject* found = nullptr;
    unsigned int index = 0;
    Walk(root, 0, index, [&](unsigned int at, vtkDataObject* node, int) {
      found = at == wanted ? node : found;
      return 0;
    });
    return found;
  }
  void Give(vtkDataObject* root);
  /// Sets something by index.
  template <typename Change>
  void Set(vtkPointSplatBlockMapper* self, unsigned int index, Change&& change)
  {
    if (!this->Attributes)
    {
      this->Attributes = vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New();
    }
    Wish& wish = this->Wishes[index];
    change(wish);
    wish.GivenTo = nullptr; // it has something to be given
    this->Give(vtkInternals::InputOf(self));
    self->Modified();
  }
  /// Forgets something of an index: forget(wish), of the data object: remove(attributes, object).
  template <typename Forget, typename Remove>
  void Unset(
    vtkPointSplatBlockMapper* self, unsigned int index, Forget&& forget, Remove&& remove)
  {
    const auto wish = this->Wishes.find(index);
    if (wish != this->Wishes.end())
    {
      forget(wish->second);
    }
    vtkDataObject* node = this->FindNode(vtkInternals::InputOf(self), index);
    if (this->Attributes && node)
    {
      remove(this->Attributes.Get(), node);
    }
    self->Modified();
  }
  /// Forgets something of all.
  template <typename Forget, typename Remove>
  void UnsetAll(vtkPointSplatBlockMapper* self, Forget&& forget, Remove&& remove)
  {
    for (auto& wish : this->Wishes)
    {
      forget(wish.second);
    }
    if (this->Attributes)
    {
      remove(this->Attributes.Get());
    }
    self->Modified();
  }
  static vtkDataObject* InputOf(vtkPointSplatBlockMapper* self)
  {
    return self->GetNumberOfInputConnections(0) > 0 ? self->GetExecutive()->GetInputData(0, 0)
                                                    : nullptr;
  }
  const Wish* Find(unsigned int index) const
  {
    const auto found = this->Wishes.find(index);
    return found == this->Wishes.end() ? nullptr : &found->second;
  }

  vtkSmartPointer<vtkCompositeDataDisplayAttributes> Attributes;
  std::map<unsigned int, Wish> Wishes;
  double Color[3] = { 1.0, 1.0, 1.0 };
};

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::vtkInternals::Give(vtkDataObject* root)
{
  std::map<unsigned int, vtkDataObject*> nodes;
  unsigned int index = 0;
  Walk(root, 0, index, [&](unsigned int at, vtkDataObject* node, int) {
    if (this->Wishes.count(at))
    {
      nodes[at] = node;
    }
    return 0;
  });
  // First from all that have gone: another one may be at the same address by now.
  for (auto& [at, wish] : this->Wishes)
  {
    if (wish.GivenTo && wish.GivenTo != nodes[at])
    {
      this->Attributes->RemoveBlockVisibility(wish.GivenTo);
      this->Attributes->RemoveBlockOpacity(wish.GivenTo);
      this->Attributes->RemoveBlockColor(wish.GivenTo);
      wish.GivenTo = nullptr;
    }
  }
  for (auto& [at, wish] : this->Wishes)
  {
    vtkDataObject* node = nodes[at];
    if (!node || wish.GivenTo == node)
    {
      continue;
    }
    wish.GivenTo = node;
    if (wish.Visible)
    {
      this->Attributes->SetBlockVisibility(node, *wish.Visible);
    }
    if (wish.Opacity)
    {
      this->Attributes->SetBlockOpacity(node, *wish.Opacity);
    }
    if (wish.Color)
    {
      this->Attributes->SetBlockColor(node, wish.Color->data());
    }
  }
}

//------------------------------------------------------------------------------
vtkPointSplatBlockMapper::vtkPointSplatBlockMapper()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkPointSplatBlockMapper::~vtkPointSplatBlockMapper() = default;

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::VisitBlockLooks(
  const std::function<void(unsigned int, const BlockLook&)>& visit)
{
  vtkCompositeDataDisplayAttributes* attributes = this->Internals->Attributes;
  auto root = vtkDataObjectTree::SafeDownCast(vtkInternals::InputOf(this));
  if (!attributes || !root)
  {
    return;
  }
  if (!this->Internals->Wishes.empty())
  {
    this->Internals->Give(root);
  }
  if (!attributes->HasBlockVisibilities() && !attributes->HasBlockOpacities() &&
    !attributes->HasBlockColors())
  {
    return;
  }
  unsigned int index = 0;
  Walk(root, BlockLook(), index, [&](unsigned int at, vtkDataObject* node, BlockLook look) {
    if (node && attributes->HasBlockVisibility(node))
    {
      look.Visible = attributes->GetBlockVisibility(node);
    }
    if (node && attributes->HasBlockOpacity(node))
    {
      look.HasOpacity = true;
      look.Opacity = attributes->GetBlockOpacity(node);
    }
    if (node && attributes->HasBlockColor(node))
    {
      look.HasColor = true;
      attributes->GetBlockColor(node, look.Color);
    }
    if (node && !vtkDataObjectTree::SafeDownCast(node))
    {
      visit(at, look);
    }
    return look;
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::SetCompositeDataDisplayAttributes(
  vtkCompositeDataDisplayAttributes* attributes)
{
  if (this->Internals->Attributes != attributes)
  {
    this->Internals->Attributes = attributes;
    this->Internals->Wishes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCompositeDataDisplayAttributes* vtkPointSplatBlockMapper::GetCompositeDataDisplayAttributes()
{
  return this->Internals->Attributes;
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::SetBlockVisibility(unsigned int index, bool visible)
{
  this->Internals->Set(
    this, index, [visible](vtkInternals::Wish& wish) { wish.Visible = visible; });
}

//------------------------------------------------------------------------------
bool vtkPointSplatBlockMapper::GetBlockVisibility(unsigned int index)
{
  const vtkInternals::Wish* wish = this->Internals->Find(index);
  vtkDataObject* node = this->Internals->FindNode(vtkInternals::InputOf(this), index);
  return wish && wish->Visible ? *wish->Visible
    : this->Internals->Attributes && node ? this->Internals->Attributes->GetBlockVisibility(node)
                                          : true;
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockVisibility(unsigned int index)
{
  this->Internals->Unset(
    this, index, [](vtkInternals::Wish& wish) { wish.Visible.reset(); },
    [](vtkCompositeDataDisplayAttributes* all, vtkDataObject* node) {
      all->RemoveBlockVisibility(node);
    });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockVisibilities()
{
  this->Internals->UnsetAll(
    this, [](vtkInternals::Wish& wish) { wish.Visible.reset(); },
    [](vtkCompositeDataDisplayAttributes* all) { all->RemoveBlockVisibilities(); });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::SetBlockOpacity(unsigned int index, double opacity)
{
  if (!std::isfinite(opacity))
  {
    vtkErrorMacro("SetBlockOpacity(): " << opacity << " is no opacity of block " << index << ".");
    return;
  }
  const double clamped = std::clamp(opacity, 0.0, 1.0);
  this->Internals->Set(
    this, index, [clamped](vtkInternals::Wish& wish) { wish.Opacity = clamped; });
}

//------------------------------------------------------------------------------
double vtkPointSplatBlockMapper::GetBlockOpacity(unsigned int index)
{
  const vtkInternals::Wish* wish = this->Internals->Find(index);
  if (wish && wish->Opacity)
  {
    return *wish->Opacity;
  }
  vtkCompositeDataDisplayAttributes* attributes = this->Internals->Attributes;
  vtkDataObject* node = this->Internals->FindNode(vtkInternals::InputOf(this), index);
  return attributes && node && attributes->HasBlockOpacity(node)
    ? attributes->GetBlockOpacity(node)
    : 1.0;
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockOpacity(unsigned int index)
{
  this->Internals->Unset(
    this, index, [](vtkInternals::Wish& wish) { wish.Opacity.reset(); },
    [](vtkCompositeDataDisplayAttributes* all, vtkDataObject* node) {
      all->RemoveBlockOpacity(node);
    });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockOpacities()
{
  this->Internals->UnsetAll(
    this, [](vtkInternals::Wish& wish) { wish.Opacity.reset(); },
    [](vtkCompositeDataDisplayAttributes* all) { all->RemoveBlockOpacities(); });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::SetBlockColor(unsigned int index, const double color[3])
{
  std::array<double, 3> clamped;
  for (size_t c = 0; c < 3; ++c)
  {
    if (!std::isfinite(color[c]))
    {
      vtkErrorMacro("SetBlockColor(): " << color[c] << " is no colour of block " << index << ".");
      return;
    }
    clamped[c] = std::clamp(color[c], 0.0, 1.0);
  }
  this->Internals->Set(
    this, index, [&clamped](vtkInternals::Wish& wish) { wish.Color = clamped; });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::GetBlockColor(unsigned int index, double color[3])
{
  std::fill_n(color, 3, 1.0);
  const vtkInternals::Wish* wish = this->Internals->Find(index);
  if (wish && wish->Color)
  {
    std::copy_n(wish->Color->data(), 3, color);
    return;
  }
  vtkCompositeDataDisplayAttributes* attributes = this->Internals->Attributes;
  vtkDataObject* node = this->Internals->FindNode(vtkInternals::InputOf(this), index);
  if (attributes && node && attributes->HasBlockColor(node))
  {
    attributes->GetBlockColor(node, color);
  }
}

//------------------------------------------------------------------------------
double* vtkPointSplatBlockMapper::GetBlockColor(unsigned int index)
{
  this->GetBlockColor(index, this->Internals->Color);
  return this->Internals->Color;
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockColor(unsigned int index)
{
  this->Internals->Unset(
    this, index, [](vtkInternals::Wish& wish) { wish.Color.reset(); },
    [](vtkCompositeDataDisplayAttributes* all, vtkDataObject* node) {
      all->RemoveBlockColor(node);
    });
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::RemoveBlockColors()
{
  this->Internals->UnsetAll(
    this, [](vtkInternals::Wish& wish) { wish.Color.reset(); },
    [](vtkCompositeDataDisplayAttributes* all) { all->RemoveBlockColors(); });
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatBlockMapper::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  vtkCompositeDataDisplayAttributes* attributes = this->Internals->Attributes;
  return attributes ? std::max(own, attributes->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto other = vtkPointSplatBlockMapper::SafeDownCast(mapper))
  {
    this->SetCompositeDataDisplayAttributes(other->Internals->Attributes);
    this->Internals->Wishes = other->Internals->Wishes;
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkPointSplatBlockMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeDataDisplayAttributes: ";
  if (this->Internals->Attributes)
  {
    os << "\n";
    this->Internals->Attributes->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}

VTK_ABI_NAMESPACE_END
