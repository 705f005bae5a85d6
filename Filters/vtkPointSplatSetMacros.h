// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's set macros keep NaN, which compares as neither less nor greater than a bound.
// Include it after a header of VTK.
#ifndef vtkPointSplatSetMacros_h
#define vtkPointSplatSetMacros_h

#include <algorithm> // For std::min
#include <cmath>     // For std::isnan

/**
 * As vtkSetClampMacro of a double; NaN is refused with an error, and the value stays.
 */
#define vtkPointSplatSetClampMacro(name, least, greatest)                                          \
  virtual void Set##name(double _arg)                                                              \
  {                                                                                                \
    if (std::isnan(_arg))                                                                          \
    {                                                                                              \
      vtkErrorMacro("Set" #name "(): NaN is no value. It stays " << this->name << ".");            \
      return;                                                                                      \
    }                                                                                              \
    const double _clamped = std::min<double>(std::max<double>(_arg, least), greatest);             \
    if (this->name != _clamped)                                                                    \
    {                                                                                              \
      this->name = _clamped;                                                                       \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual double Get##name##MinValue() { return least; }                                           \
  virtual double Get##name##MaxValue() { return greatest; }

#endif
