// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What tests of scalars' colours share: the ways in which layers are made, and a table that blended
// colours are not in.
#ifndef SplatTables_h
#define SplatTables_h

#include "SplatScene.h"

#include "vtkLookupTable.h"

#include <array>
#include <set>

namespace SplatScene
{
using Mapper = vtkPointSplatMapper;

struct Way
{
  const char* Name;
  int Method;
  int Projection;
};
inline const Way Ways[] = { { "tiles", Mapper::AUTOMATIC_METHOD, Mapper::AUTOMATIC_PROJECTION },
  { "quads", Mapper::TWO_PASS, Mapper::QUADS },
  { "deferred", Mapper::DEFERRED, Mapper::AUTOMATIC_PROJECTION },
  { "image space", Mapper::IMAGE_SPACE, Mapper::COMPUTE },
  { "image space by quads", Mapper::IMAGE_SPACE, Mapper::QUADS } };

inline vtkSmartPointer<vtkLookupTable> Saturated()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(5);
  table->SetTableValue(0, 1, 0, 0);
  table->SetTableValue(1, 0, 1, 0);
  table->SetTableValue(2, 0, 0, 1);
  table->SetTableValue(3, 1, 1, 0);
  table->SetTableValue(4, 0, 1, 1);
  table->SetNanColor(1, 1, 1, 1);
  return table;
}

inline void Unlit(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  actor->GetProperty()->SetSpecular(0.0);
  actor->GetProperty()->LightingOff();
}

/// Pixels whose colour is neither black nor one of saturated channels that the table has.
inline int CountOffTable(const Picture& picture, vtkLookupTable* table)
{
  std::set<std::array<int, 3>> known{ { 0, 0, 0 }, { 255, 255, 255 } };
  for (int i = 0; i < table->GetNumberOfTableValues(); ++i)
  {
    const double* c = table->GetTableValue(i);
    known.insert({ int(255 * c[0]), int(255 * c[1]), int(255 * c[2]) });
  }
  int count = 0;
  for (size_t i = 0; i < picture.Pixels.size(); i += 3)
  {
    count += known.count({ picture.Pixels[i], picture.Pixels[i + 1], picture.Pixels[i + 2] }) == 0;
  }
  return count;
}
}

#endif
