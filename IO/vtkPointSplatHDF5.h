// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the octree's writer and reader need of HDF5: handles that close themselves, attributes of
// numbers and text, and VTK's arrays as data sets.
//
// An array is a data set of two dimensions, tuples and components, of the array's own number type,
// in chunks of ChunkTuples tuples, their bytes shuffled and deflated, with a checksum. Bits are
// stored as unsigned chars. Of strings the data set has their ends, 64 bit integers, in another one
// by its side, "...Text", of their bytes one after the other: strings of variable length would be kept
// in HDF5's heap, of which it crashes where a file is damaged. Attributes of the data set:
// - Name: the array's name, which may hold what a data set's own name may not;
// - DataType: VTK's number for the array's type;
// - Role: what vtkDataSetAttributes has it for (AttributeTypes), or -1;
// - ComponentNames: a line each, if there are any.
#ifndef vtkPointSplatHDF5_h
#define vtkPointSplatHDF5_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "vtk_hdf5.h"

#include <string>
#include <vector>

class vtkAbstractArray;

namespace vtkPointSplatHDF5
{
/// Tuples of a chunk: what is read at least.
constexpr vtkIdType ChunkTuples = 8192;

/**
 * Closes what it names; Id is negative where nothing was opened.
 */
class Handle
{
public:
  Handle() = default;
  Handle(hid_t id, herr_t (*close)(hid_t))
    : Id(id)
    , CloseIt(close)
  {
  }
  Handle(Handle&& other) noexcept { this->Swap(other); }
  Handle& operator=(Handle&& other) noexcept
  {
    this->Swap(other);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { this->Close(); }
  /// False: closing failed, for instance because the disk is full.
  bool Close();
  explicit operator bool() const { return this->Id >= 0; }
  operator hid_t() const { return this->Id; }

private:
  void Swap(Handle& other);

  hid_t Id = -1;
  herr_t (*CloseIt)(hid_t) = nullptr;
};

/**
 * Keeps HDF5 from printing its errors, while it lives.
 */
class Silence
{
public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  H5E_auto2_t Function = nullptr;
  void* Data = nullptr;
};

/**
 * Tuples of an array, one after the other.
 */
struct Run
{
  vtkIdType First;
  vtkIdType Count;
};

Handle CreateGroup(hid_t where, const std::string& name);
Handle OpenGroup(hid_t where, const std::string& name);

bool WriteText(hid_t where, const char* name, const std::string& text);
bool ReadText(hid_t where, const char* name, std::string& text);
bool WriteNumbers(hid_t where, const char* name, const std::vector<double>& numbers);
bool WriteNumbers(hid_t where, const char* name, const std::vector<long long>& numbers);
/// False where there are not as many as numbers has.
bool ReadNumbers(hid_t where, const char* name, std::vector<double>& numbers);
bool ReadNumbers(hid_t where, const char* name, std::vector<long long>& numbers);

/// Whether arrays of this kind can be written.
bool IsKnown(vtkAbstractArray* array);
/**
 * What is written of an array, and how.
 */
struct ArrayWish
{
  Run Tuples;
  int Role = -1;   // of vtkDataSetAttributes
  int Deflate = 1; // 0 to 9
};
/// Writes an array that is known as a group's Array0, Array1, ...
bool WriteArray(hid_t group, int number, vtkAbstractArray* array, const ArrayWish& wish);

/**
 * What a file says of an array.
 */
struct ArrayHead
{
  std::string Name;
  int DataType = VTK_VOID;
  int Role = -1;
  vtkIdType Tuples = 0;
  int Components = 1;
  std::string ComponentNames; // a line each, or nothing
};
/// Those of a group's Array0, Array1, ..., up to the first that is not there.
std::vector<ArrayHead> ReadHeads(hid_t group);
/// An array without tuples; none where this VTK knows no such type.
vtkSmartPointer<vtkAbstractArray> NewArray(const ArrayHead& head);
/**
 * An array that is open to be read.
 */
struct OpenArray
{
  OpenArray() = default;
  OpenArray(hid_t group, int number);
  explicit operator bool() const { return static_cast<bool>(this->Data); }

  Handle Data;
  Handle Text; // of strings
  hsize_t Size[2] = { 0, 0 };
};
/// Puts a run's tuples into the array, which has room for them, from its first tuple on.
bool ReadTuples(const OpenArray& from, const Run& run, vtkAbstractArray* array);
/// All of an array; none where it cannot be read.
vtkSmartPointer<vtkAbstractArray> ReadArray(hid_t group, int number, const ArrayHead& head);
}

#endif
