// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatEstimates
 * @brief   what is estimated of one cloud, stage by stage
 *
 * An internal helper of vtkPointSplatEstimation, whose header tells the stages, inputs and outputs: it is
 * made for one update, and Run() once. Arrays have a tuple a point of the input.
 */
#ifndef vtkPointSplatEstimates_h
#define vtkPointSplatEstimates_h

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointSplatBodies.h"
#include "vtkPointSplatBorders.h"
#include "vtkPointSplatCreases.h"
#include "vtkPointSplatDisks.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatLargeArray.h"
#include "vtkPointSplatMesh.h"
#include "vtkPointSplatMeshBorders.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatRefinement.h"
#include "vtkPointSplatStars.h"

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPointSet;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatNormalSeams;

class vtkPointSplatEstimates
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  vtkPointSplatEstimates(vtkPointSplatEstimation* self, vtkPointSet* input);

  /// Takes over the input's triangles, if they were read before.
  void SetMesh(vtkPointSplatMesh mesh)
  {
    this->Fans = std::move(mesh.Fans);
    this->OfLattice = mesh.OfLattice;
    if (!mesh.Sources.empty())
    {
      this->NumberOfMendedNormals = mesh.NumberOfMended;
      this->Split = std::move(mesh);
    }
  }

  /// Returns false if self was aborted.
  bool Run();

  /// Makes fill points of the copies of a mesh that was split, and of second splats at its border, and gives all the normals to
  /// shade with.
  void MakeFill();

  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> Sizes[2]; // radii, or both axes
  vtkNew<vtkFloatArray> Planes;
  vtkNew<vtkFloatArray> Curvatures;
  vtkNew<vtkFloatArray> Clips, Folds; // without tuples where there are none
  vtkIdType NumberOfPointsAlone = 0;
  vtkIdType NumberOfMendedNormals = 0;
  double Noise = 0;
  double Contradiction = 0;

  /// Fill points; Ends are points of the input, the nearest one first, and none is another process'.
  std::vector<vtkPointSplatRefinement::Point> Fill;

private:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  using Twins = std::vector<vtkPointSplatCreases::Twin>;

  vtkDataArray* MakeArrays();
  void ReadPoints(vtkDataArray* given);
  void ReadMesh();
  bool FindNormals();
  float GetUsualSpacing() const;
  void FindSearched();
  bool MendSeams(vtkPointSplatNormalSeams& seams);
  bool FindDisks();
  bool FindOtherDisks();
  bool IsHemmed(Slot s) const;
  bool Measure(const Neighborhood& around, int round);
  void SetDisk(const Neighborhood& around, const vtkPointSplatDisk& disk);
  bool FindSparseDisks(std::vector<unsigned char>& taken);
  void FindStar(const Neighborhood& around, const vtkPointSplatDisk& disk);
  Twins FindTwins() const;
  bool FindBorders(const Twins& twins);
  bool FindCreases(Twins twins);
  void SetCreases();
  std::vector<unsigned char> GetSlotsAtCreases() const;
  /// Whether a point is in a slot of those that are marked.
  bool IsAt(const std::vector<unsigned char>& slots, vtkIdType id) const
  {
    const Slot s = this->Neighbors.GetSlots()[id];
    return s != vtkPointSplatNeighbors::None && slots[s];
  }
  /// Whether there may be fill points, and where the points are a mesh.
  bool Fills() const { return this->Self->GetFillGaps() && !this->Elliptical; }
  bool FillsMesh() const { return this->MeshAlone && this->Fills() && this->Self->GetFillMeshGaps(); }
  /// And where they are no mesh, if they are noise.
  bool FillsNoise() const { return this->Self->GetFillNoise() || !this->IsNoisy(); }
  bool FindStars();
  void FindFill();
  void BoundMesh();
  void FindMeshFill();
  std::vector<float> Refine(vtkPointSplatStars& stars, const float* normals, const float* curvatures);
  vtkPointSplatMeshBorders::End FindEnd(const vtkPointSplatRefinement::Point& point, float radius);
  float GetTurn(vtkIdType id) const;
  float GetRoom(const vtkPointSplatStars& stars, const vtkPointSplatRefinement::Point& point);
  float GetBeside(const double x[3], vtkIdType id) const;
  void TakeFill(const vtkPointSplatRefinement& fill);
  void AddFoldSides();
  vtkPointSplatRefinement::Point MakeFillAt(vtkIdType id) const;
  void TakeShadingNormals();
  void TurnPlanes();
  void Write();
  void WriteMesh();
  void WriteCreases();
  void WriteTubeLines();
  void ClipFill();

  bool IsRough() const { return vtkPointSplatEstimation::IsRough(this->Noise); }
  bool IsNoisy() const { return this->Self->IsNoisy(this->Noise, this->Contradiction); }
  /// Whether normals tell where the surface bends. What is rough at regular points, as of an isosurface of a noisy
  /// volume, is the surface's own.
  bool MayBend(Slot s) const
  {
    return (!this->Guessed || this->Clean) && (!this->IsNoisy() || this->Disks->GetSampling(s).Regular);
  }
  bool IsDrawn(vtkIdType id) const;
  float GetScaled(float length) const;
  const vtkPointSplatFans::Disk& GetCorner(vtkIdType id) const { return this->Corners[this->Fans.GetSame(id)]; }
  float* GetNormal(vtkIdType id) { return this->Normals->GetPointer(3 * id); }
  const float* GetSlotNormal(Slot s) const { return this->SlotNormals.data() + std::size_t(3) * s; }

  vtkPointSplatEstimation* Self;
  vtkPointSet* Input;
  const vtkIdType NumberOfPoints;
  const bool Elliptical;
  bool Given = false;   // whether there are normals
  bool Guessed = false; // whether most of them are estimated, and do not tell of the surface's noise
  bool Clean = true;    // whether there is so little of it that they tell of the surface's bends
  const unsigned char* Ghosts = nullptr;
  std::vector<unsigned char> Used;

  vtkPointSplatFans Fans;
  bool OfLattice = false; // whether its triangles are those of an isosurface's vertices
  vtkPointSplatMesh Split; // its copies and normals, if it was split
  bool MeshAlone = false; // all points are triangles' corners
  std::vector<vtkPointSplatFans::Disk> Corners; // if so, of those that take part
  std::vector<vtkPointSplatMeshBorders::End> Ends; // at borders
  vtkPointSplatMeshBorders::Near Near; // to these
  std::vector<vtkIdType> Bounded; // of these, those whose disks the border bounds
  std::unique_ptr<vtkPointSplatMeshOutline> Outline; // if there is a border

  vtkPointSplatNeighbors Neighbors;
  vtkPointSplatLargeArray<float> SlotNormals;
  std::vector<unsigned char> Known; // slots with given normals
  std::vector<unsigned char> Trusted; // the same, or with those of a surface in rows: whose sheet they tell
  std::vector<unsigned char> OnSurface; // if normals are missing: slots whose neighbours are (vtkPointSplatNormals.h)
  std::vector<std::atomic<bool>> Searched; // slots with a point that is no triangle's corner
  float Median = 0; // spacing
  std::unique_ptr<vtkPointSplatDisks> Disks;
  std::unique_ptr<vtkPointSplatBodies> Bodies;
  std::unique_ptr<vtkPointSplatBorders> Borders;
  std::unique_ptr<vtkPointSplatCreases> Creases;
  std::unique_ptr<vtkPointSplatStars> Stars; // of slots, where gaps are filled
  std::vector<unsigned char> Creased; // slots that are likely to be at one
  std::vector<std::atomic<bool>> Misled; // slots with a neighbour whose normal is not the surface's
  vtkPointSplatLargeArray<float> SheetNormals; // of the disks' planes
  const float* Directions = nullptr; // which of both are looked at
};

VTK_ABI_NAMESPACE_END
#endif
