// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// CheckPicture file.png: succeeds when the picture shows a lit surface before a
// plain background. A blank picture fails, and so does a flat silhouette.
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <iostream>
#include <set>

int main(int argc, char* argv[])
{
  vtkNew<vtkPNGReader> reader;
  if (argc != 2 || !reader->CanReadFile(argv[1]))
  {
    std::cerr << "CheckPicture: give a PNG file\n";
    return 2;
  }
  reader->SetFileName(argv[1]);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int components = image->GetNumberOfScalarComponents();
  const vtkIdType pixels = image->GetNumberOfPoints();
  const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer());
  if (!pixel || image->GetScalarType() != VTK_UNSIGNED_CHAR || components < 3)
  {
    std::cerr << "CheckPicture: " << argv[1] << " is not an 8 bit colour picture\n";
    return 2;
  }

  const unsigned char background[3] = { pixel[0], pixel[1], pixel[2] };
  std::set<int> shades;
  vtkIdType covered = 0;
  for (vtkIdType i = 0; i < pixels; ++i, pixel += components)
  {
    if (pixel[0] != background[0] || pixel[1] != background[1] || pixel[2] != background[2])
    {
      ++covered;
      shades.insert(pixel[1]);
    }
  }
  const double part = static_cast<double>(covered) / static_cast<double>(pixels);
  std::cout << argv[1] << ": " << 100. * part << " % covered, " << shades.size() << " shades\n";
  return part > 0.05 && part < 0.98 && shades.size() >= 32 ? 0 : 1;
}
