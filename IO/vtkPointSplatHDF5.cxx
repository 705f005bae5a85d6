// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatHDF5.h"

#include "vtkAbstractArray.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vtkPointSplatHDF5
{
namespace
{
// A data set's chunks that HDF5 keeps unpacked: runs come in order, so that some are enough.
constexpr size_t CacheBytes = size_t(1) << 21;
constexpr size_t CacheSlots = 521;
constexpr hsize_t TextChunk = hsize_t(1) << 18; // bytes
constexpr size_t MostText = size_t(1) << 16; // of an attribute

/// HDF5's name for VTK's number types; negative for what is no number.
hid_t TypeOf(int type)
{
  switch (type)
  {
    case VTK_CHAR:
      return H5T_NATIVE_CHAR;
    case VTK_SIGNED_CHAR:
      return H5T_NATIVE_SCHAR;
    case VTK_BIT:
    case VTK_UNSIGNED_CHAR:
      return H5T_NATIVE_UCHAR;
    case VTK_SHORT:
      return H5T_NATIVE_SHORT;
    case VTK_UNSIGNED_SHORT:
      return H5T_NATIVE_USHORT;
    case VTK_INT:
      return H5T_NATIVE_INT;
    case VTK_UNSIGNED_INT:
      return H5T_NATIVE_UINT;
    case VTK_LONG:
      return H5T_NATIVE_LONG;
    case VTK_UNSIGNED_LONG:
      return H5T_NATIVE_ULONG;
    case VTK_LONG_LONG:
      return H5T_NATIVE_LLONG;
    case VTK_UNSIGNED_LONG_LONG:
      return H5T_NATIVE_ULLONG;
    case VTK_ID_TYPE:
      return sizeof(vtkIdType) == 8 ? H5T_NATIVE_INT64 : H5T_NATIVE_INT32;
    case VTK_FLOAT:
      return H5T_NATIVE_FLOAT;
    case VTK_DOUBLE:
      return H5T_NATIVE_DOUBLE;
    default:
      return -1;
  }
}

/// Of a text of a length; of fixed size, since others lie in the file's heap.
Handle TextType(size_t length)
{
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, length + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// What is written takes the place of what was there.
void RemoveAttribute(hid_t where, const char* name)
{
  if (H5Aexists(where, name) > 0)
  {
    H5Adelete(where, name);
  }
}

template <typename T>
bool Write(hid_t where, const char* name, hid_t type, const std::vector<T>& numbers)
{
  const hsize_t size = numbers.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  RemoveAttribute(where, name);
  const Handle attribute(
    H5Acreate2(where, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute, type, numbers.data()) >= 0;
}

template <typename T>
bool Read(hid_t where, const char* name, hid_t type, std::vector<T>& numbers)
{
  const Handle attribute(H5Aopen(where, name, H5P_DEFAULT), H5Aclose);
  if (!attribute)
  {
    return false;
  }
  const Handle space(H5Aget_space(attribute), H5Sclose);
  return H5Sget_simple_extent_npoints(space) == static_cast<hssize_t>(numbers.size()) &&
    H5Aread(attribute, type, numbers.data()) >= 0;
}

std::string DataSetName(int number)
{
  return "Array" + std::to_string(number);
}

/// Of a data set: tuples and components, tuples of a chunk, 0 to 9.
struct Shape
{
  hsize_t Size[2];
  hsize_t Chunk;
  int Deflate;
};

/// The data set and its size.
Handle OpenDataSet(hid_t where, const std::string& dataset, hsize_t size[2])
{
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(access, CacheSlots, CacheBytes, 1.0);
  Handle data(H5Dopen2(where, dataset.c_str(), access), H5Dclose);
  if (!data)
  {
    return data;
  }
  const Handle space(H5Dget_space(data), H5Sclose);
  if (H5Sget_simple_extent_ndims(space) != 2 ||
    H5Sget_simple_extent_dims(space, size, nullptr) != 2)
  {
    return Handle();
  }
  return data;
}

bool ReadRun(hid_t data, hid_t type, const hsize_t start[2], const hsize_t count[2], void* to)
{
  const Handle file(H5Dget_space(data), H5Sclose);
  const Handle memory(H5Screate_simple(2, count, nullptr), H5Sclose);
  return H5Sselect_hyperslab(file, H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
    H5Dread(data, type, memory, file, H5P_DEFAULT, to) >= 0;
}

bool WriteValues(
  hid_t where, const std::string& name, hid_t type, const Shape& shape, const void* values)
{
  const Handle space(H5Screate_simple(2, shape.Size, nullptr), H5Sclose);
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const bool any = shape.Size[0] > 0 && shape.Size[1] > 0;
  if (any)
  {
    const hsize_t chunk[2] = { std::min<hsize_t>(shape.Size[0], shape.Chunk), shape.Size[1] };
    H5Pset_chunk(create, 2, chunk);
    if (shape.Deflate > 0)
    {
      H5Pset_shuffle(create);
      H5Pset_deflate(create, static_cast<unsigned int>(shape.Deflate));
    }
    H5Pset_fletcher32(create);
  }
  const Handle data(
    H5Dcreate2(where, name.c_str(), type, space, H5P_DEFAULT, create, H5P_DEFAULT), H5Dclose);
  return data &&
    (!any || H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
}

/// Strings: where each ends, and their bytes.
bool WriteStrings(
  hid_t where, const std::string& dataset, vtkStringArray* array, const ArrayWish& wish)
{
  const int components = array->GetNumberOfComponents();
  const vtkIdType first = wish.Tuples.First * components;
  std::string bytes;
  std::vector<long long> ends;
  for (vtkIdType i = first; i < first + wish.Tuples.Count * components; ++i)
  {
    bytes += array->GetValue(i);
    ends.push_back(static_cast<long long>(bytes.size()));
  }
  const Shape texts{ { bytes.size(), 1 }, TextChunk, wish.Deflate };
  const Shape tuples{ { static_cast<hsize_t>(wish.Tuples.Count), static_cast<hsize_t>(components) },
    ChunkTuples, wish.Deflate };
  return WriteValues(where, dataset + "Text", H5T_NATIVE_UCHAR, texts, bytes.data()) &&
    WriteValues(where, dataset, H5T_NATIVE_LLONG, tuples, ends.data());
}

bool WriteDataArray(
  hid_t where, const std::string& dataset, vtkDataArray* array, const ArrayWish& wish)
{
  const int components = array->GetNumberOfComponents();
  const vtkIdType first = wish.Tuples.First * components;
  const vtkIdType count = wish.Tuples.Count * components;
  const Shape shape{ { static_cast<hsize_t>(wish.Tuples.Count), static_cast<hsize_t>(components) },
    ChunkTuples, wish.Deflate };
  std::vector<unsigned char> bits;
  auto* flags = vtkBitArray::SafeDownCast(array);
  for (vtkIdType i = first; flags && i < first + count; ++i)
  {
    bits.push_back(static_cast<unsigned char>(flags->GetValue(i)));
  }
  const void* values = flags ? bits.data() : count > 0 ? array->GetVoidPointer(first) : nullptr;
  return WriteValues(where, dataset, TypeOf(array->GetDataType()), shape, values);
}

bool ReadBits(hid_t data, const hsize_t start[2], const hsize_t count[2], vtkBitArray* to)
{
  std::vector<unsigned char> bits(count[0] * count[1]);
  if (!ReadRun(data, H5T_NATIVE_UCHAR, start, count, bits.data()))
  {
    return false;
  }
  for (size_t i = 0; i < bits.size(); ++i)
  {
    to->SetValue(static_cast<vtkIdType>(i), bits[i]);
  }
  return true;
}

/// Of a tuple before those wanted the end is where their text begins.
bool ReadStrings(const OpenArray& from, const hsize_t start[2], const hsize_t count[2],
  vtkStringArray* to)
{
  const hsize_t before = start[0] > 0 ? 1 : 0;
  const hsize_t first[2] = { start[0] - before, 0 };
  const hsize_t size[2] = { count[0] + before, count[1] };
  std::vector<long long> ends(size[0] * size[1]);
  if (!ReadRun(from.Data, H5T_NATIVE_LLONG, first, size, ends.data()))
  {
    return false;
  }
  const size_t skipped = static_cast<size_t>(before * count[1]);
  const long long begin = skipped > 0 ? ends[skipped - 1] : 0;
  const Handle space(H5Dget_space(from.Text), H5Sclose);
  const long long all = H5Sget_simple_extent_npoints(space);
  if (begin < 0 || ends.back() < begin || ends.back() > all ||
    !std::is_sorted(ends.begin() + static_cast<std::ptrdiff_t>(skipped), ends.end()) ||
    ends[skipped] < begin)
  {
    return false;
  }
  std::vector<char> bytes(static_cast<size_t>(ends.back() - begin));
  const hsize_t textStart[2] = { static_cast<hsize_t>(begin), 0 };
  const hsize_t textCount[2] = { bytes.size(), 1 };
  if (!bytes.empty() && !ReadRun(from.Text, H5T_NATIVE_UCHAR, textStart, textCount, bytes.data()))
  {
    return false;
  }
  long long last = begin;
  for (size_t i = skipped; i < ends.size(); ++i)
  {
    to->SetValue(static_cast<vtkIdType>(i - skipped),
      std::string(bytes.data() + (last - begin), static_cast<size_t>(ends[i] - last)));
    last = ends[i];
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool Handle::Close()
{
  const bool good = this->Id < 0 || this->CloseIt(this->Id) >= 0;
  this->Id = -1;
  return good;
}

//------------------------------------------------------------------------------
void Handle::Swap(Handle& other)
{
  std::swap(this->Id, other.Id);
  std::swap(this->CloseIt, other.CloseIt);
}

//------------------------------------------------------------------------------
Silence::Silence()
{
  H5Eget_auto2(H5E_DEFAULT, &this->Function, &this->Data);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

//------------------------------------------------------------------------------
Silence::~Silence()
{
  H5Eset_auto2(H5E_DEFAULT, this->Function, this->Data);
}

//------------------------------------------------------------------------------
Handle CreateGroup(hid_t where, const std::string& name)
{
  return Handle(
    H5Gcreate2(where, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

//------------------------------------------------------------------------------
Handle OpenGroup(hid_t where, const std::string& name)
{
  return Handle(H5Gopen2(where, name.c_str(), H5P_DEFAULT), H5Gclose);
}

//------------------------------------------------------------------------------
bool WriteText(hid_t where, const char* name, const std::string& text)
{
  const Handle type = TextType(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  RemoveAttribute(where, name);
  const Handle attribute(
    H5Acreate2(where, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute, type, text.c_str()) >= 0;
}

//------------------------------------------------------------------------------
bool ReadText(hid_t where, const char* name, std::string& text)
{
  const Handle attribute(H5Aopen(where, name, H5P_DEFAULT), H5Aclose);
  if (!attribute)
  {
    return false;
  }
  const Handle found(H5Aget_type(attribute), H5Tclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  const size_t size = H5Tget_size(found);
  if (H5Tget_class(found) != H5T_STRING || H5Tis_variable_str(found) != 0 || size == 0 ||
    size > MostText || H5Sget_simple_extent_npoints(space) != 1)
  {
    return false;
  }
  std::vector<char> data(size + 1, '\0');
  if (H5Aread(attribute, found, data.data()) < 0)
  {
    return false;
  }
  text = data.data();
  return true;
}

//------------------------------------------------------------------------------
bool WriteNumbers(hid_t where, const char* name, const std::vector<double>& numbers)
{
  return Write(where, name, H5T_NATIVE_DOUBLE, numbers);
}

//------------------------------------------------------------------------------
bool WriteNumbers(hid_t where, const char* name, const std::vector<long long>& numbers)
{
  return Write(where, name, H5T_NATIVE_LLONG, numbers);
}

//------------------------------------------------------------------------------
bool ReadNumbers(hid_t where, const char* name, std::vector<double>& numbers)
{
  return Read(where, name, H5T_NATIVE_DOUBLE, numbers);
}

//------------------------------------------------------------------------------
bool ReadNumbers(hid_t where, const char* name, std::vector<long long>& numbers)
{
  return Read(where, name, H5T_NATIVE_LLONG, numbers);
}

//------------------------------------------------------------------------------
bool IsKnown(vtkAbstractArray* array)
{
  return vtkStringArray::SafeDownCast(array) ||
    (vtkDataArray::SafeDownCast(array) && TypeOf(array->GetDataType()) >= 0);
}

//------------------------------------------------------------------------------
bool WriteArray(hid_t group, int number, vtkAbstractArray* array, const ArrayWish& wish)
{
  const std::string dataset = DataSetName(number);
  auto* strings = vtkStringArray::SafeDownCast(array);
  bool good = strings
    ? WriteStrings(group, dataset, strings, wish)
    : WriteDataArray(group, dataset, vtkDataArray::SafeDownCast(array), wish);
  const Handle data(H5Dopen2(group, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  good = good && data && WriteText(data, "Name", array->GetName() ? array->GetName() : "") &&
    WriteNumbers(data, "DataType", std::vector<long long>{ array->GetDataType() }) &&
    WriteNumbers(data, "Role", std::vector<long long>{ wish.Role });
  if (array->HasAComponentName())
  {
    std::string names;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const char* name = array->GetComponentName(c);
      names += std::string(c ? "\n" : "") + (name ? name : "");
    }
    good = good && WriteText(data, "ComponentNames", names);
  }
  return good;
}

//------------------------------------------------------------------------------
std::vector<ArrayHead> ReadHeads(hid_t group)
{
  std::vector<ArrayHead> heads;
  for (;;)
  {
    hsize_t size[2];
    const Handle data = OpenDataSet(group, DataSetName(static_cast<int>(heads.size())), size);
    ArrayHead head;
    std::vector<long long> type(1);
    std::vector<long long> role(1);
    if (!data || !ReadText(data, "Name", head.Name) || !ReadNumbers(data, "DataType", type) ||
      !ReadNumbers(data, "Role", role) || (type[0] != VTK_STRING && TypeOf(static_cast<int>(type[0])) < 0))
    {
      return heads;
    }
    head.DataType = static_cast<int>(type[0]);
    head.Role = static_cast<int>(role[0]);
    head.Tuples = static_cast<vtkIdType>(size[0]);
    head.Components = static_cast<int>(size[1]);
    ReadText(data, "ComponentNames", head.ComponentNames);
    heads.push_back(head);
  }
}

//------------------------------------------------------------------------------
OpenArray::OpenArray(hid_t group, int number)
{
  const std::string dataset = DataSetName(number);
  this->Data = OpenDataSet(group, dataset, this->Size);
  if (this->Data && H5Lexists(group, (dataset + "Text").c_str(), H5P_DEFAULT) > 0)
  {
    hsize_t size[2];
    this->Text = OpenDataSet(group, dataset + "Text", size);
  }
}

//------------------------------------------------------------------------------
bool ReadTuples(const OpenArray& from, const Run& run, vtkAbstractArray* array)
{
  const hsize_t start[2] = { static_cast<hsize_t>(run.First), 0 };
  const hsize_t count[2] = { static_cast<hsize_t>(run.Count), from.Size[1] };
  if (!from || from.Size[1] != static_cast<hsize_t>(array->GetNumberOfComponents()) ||
    run.First < 0 || run.Count < 0 || start[0] + count[0] > from.Size[0])
  {
    return false;
  }
  if (count[0] * count[1] == 0)
  {
    return true;
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    return from.Text && ReadStrings(from, start, count, strings);
  }
  if (auto* flags = vtkBitArray::SafeDownCast(array))
  {
    return ReadBits(from.Data, start, count, flags);
  }
  return ReadRun(
    from.Data, TypeOf(array->GetDataType()), start, count, array->GetVoidPointer(0));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> NewArray(const ArrayHead& head)
{
  auto array =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(head.DataType));
  if (!array)
  {
    return nullptr;
  }
  array->SetName(head.Name.c_str());
  array->SetNumberOfComponents(head.Components);
  const std::string& names = head.ComponentNames;
  size_t begin = 0;
  for (int c = 0; c < head.Components && !names.empty(); ++c)
  {
    const size_t end = std::min(names.find('\n', begin), names.size());
    array->SetComponentName(c, names.substr(begin, end - begin).c_str());
    begin = std::min(end + 1, names.size());
  }
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> ReadArray(hid_t group, int number, const ArrayHead& head)
{
  vtkSmartPointer<vtkAbstractArray> array = NewArray(head);
  if (array)
  {
    array->SetNumberOfTuples(head.Tuples);
  }
  return array && ReadTuples(OpenArray(group, number), { 0, head.Tuples }, array) ? array : nullptr;
}
}
