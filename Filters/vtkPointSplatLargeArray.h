// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLargeArray
 * @brief   values of a fixed number, whose memory threads touch first together
 *
 * An internal helper of the filters. Memory that is new is cleared by the system when it is first touched, a page at a
 * time, which for gigabytes takes seconds. A std::vector does that in one thread.
 */
#ifndef vtkPointSplatLargeArray_h
#define vtkPointSplatLargeArray_h

#include "vtkPointSplatThreads.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

VTK_ABI_NAMESPACE_BEGIN

template <typename Value>
class vtkPointSplatLargeArray
{
  static_assert(std::is_trivially_copyable<Value>::value, "values are not constructed");

public:
  vtkPointSplatLargeArray() = default;
  /// So many copies of a value.
  vtkPointSplatLargeArray(std::size_t count, Value value)
    : vtkPointSplatLargeArray(count)
  {
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
      std::fill(this->data() + begin, this->data() + end, value);
    });
  }
  /// So many values, whatever they are.
  explicit vtkPointSplatLargeArray(std::size_t count)
    : Values(new Value[count])
    , Count(count)
  {
  }

  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  Value* data() { return this->Values.get(); }
  const Value* data() const { return this->Values.get(); }
  Value& operator[](std::size_t i) { return this->Values[i]; }
  const Value& operator[](std::size_t i) const { return this->Values[i]; }
  Value* begin() { return this->data(); }
  const Value* begin() const { return this->data(); }
  Value* end() { return this->data() + this->Count; }
  const Value* end() const { return this->data() + this->Count; }

private:
  std::unique_ptr<Value[]> Values;
  std::size_t Count = 0;
};

VTK_ABI_NAMESPACE_END
#endif
