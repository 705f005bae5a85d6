// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzRoundTrip.h"

#include "FuzzRandom.h"

#include "vtkNew.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

vtkSmartPointer<vtkPolyData> FuzzRoundTrip(FuzzRandom& random, vtkPolyData* data)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (random.Chance(0.5))
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->WriteToOutputStringOn();
    writer->SetDataMode(random.Below(3));
    writer->SetInputData(data);
    writer->Write();
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(writer->GetOutputString());
    reader->Update();
    result->ShallowCopy(reader->GetOutput());
  }
  else
  {
    vtkNew<vtkPolyDataWriter> writer;
    writer->WriteToOutputStringOn();
    writer->SetFileTypeToBinary();
    writer->SetInputData(data);
    writer->Write();
    vtkNew<vtkPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetBinaryInputString(
      writer->GetOutputString(), static_cast<int>(writer->GetOutputStringLength()));
    reader->Update();
    result->ShallowCopy(reader->GetOutput());
  }
  return result;
}
