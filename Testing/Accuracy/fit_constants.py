#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Why the estimation's constants that were fitted by hand are what they are.

  fit_constants.py --scratch FOLDER [--size PIXELS] [--values V,V,...] [CONSTANT ...]

For each constant, or those named, each of some values around its own is written into a copy of
the sources in the folder, the copy's filters are built (the first build takes minutes), and the
stand-ins that the constant matters for are estimated and drawn with them, by the Python package
that runs this script. A line is printed for each value and stand-in: the number of points with
clip lines (lines), psnr in dB of the views, the last one close up, pixels with holes and the
largest spill, as in likeness.py. A star marks the value that the sources have. Hours for all constants.

What to look for: a value is right where a step to either side costs one stand-in more than the
other gains; holes and spill come before decibels.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
FOLDS = ("drapery", "drapery_vertices")
PARTS = ("part_random", "part_vertices")
PLATES = ("ribbed_plate", "ribbed_plate_2")
MESHED = ("ribbed_block",)
SHALLOW = ("block_beside_ball", "tetrahedra_clipped", "drapery")
DISCS = ("rimmed_disc", "thin_disc")
BENT = ("tubes_edges", "drapery_vertices")
ROWS = ("grid_lines_bare", "grid_lines_20_bare", "grid_lines_noisy")
SHADED = ("shaded_facets", "thick_slices")
ISOSURFACES = ("tubes_points", "cut_points", "gear_points")
LONG = ("can", "shaft", "arrow", "cog")
FILLETS = ("plate", "wire", "dome", "meshes:drapery_vertices")
WOUND = ("crossing_wound", "drapery_wound", "part_wound", "drapery_vertices")
SPARSE = ("graded_bar", "belted", "graded_disc", "graded_dish", "thin_disc")
ROUGH = ("tubes_noisy", "tubes_edges", "cut_noisy")
STREAMS = ("streamtubes", "streamtubes_8")
BESIDE = ("ring_beside_ball", "block_beside_ball", "belted_6", "tubes_points")
# The file in Filters, the values to try, and the stand-ins that tell.
CONSTANTS = {
    "AnglePerDeviation": ("vtkPointSplatCrease.cxx", (2, 3, 4, 6, 8), FOLDS + PARTS),
    "LeastAngle": ("vtkPointSplatCrease.cxx", (0.26, 0.342, 0.5, 0.64), FOLDS + PARTS),
    "Agreement": ("vtkPointSplatCrease.cxx", (0.8, 0.85, 0.9, 0.95), FOLDS + PARTS),
    "LeastCompany": ("vtkPointSplatCreases.cxx", (6, 8, 10, 12, 16), FOLDS + PARTS),
    "LeastSureCompany": ("vtkPointSplatCreases.cxx", (10, 13, 16, 20), FOLDS + PARTS),
    "MostSpread": ("vtkPointSplatCreases.cxx", (1, 4, 8, 16), MESHED + FOLDS + PARTS),
    "FewestInRow": ("vtkPointSplatFace.cxx", (1, 2, 3, 4), PLATES + PARTS),
    "ManyMembers": ("vtkPointSplatFace.cxx", (8, 12, 16, 32), MESHED + FOLDS),
    "FewestAlike": ("vtkPointSplatCrease.cxx", (2, 3, 4), MESHED + PARTS),
    "AlikeTurned": ("vtkPointSplatCrease.cxx", (0.8, 0.9, 0.974), MESHED + FOLDS),
    "NextSlope": ("vtkPointSplatMirrored.h", (0.0, 0.3, 0.6, 1.0), SHALLOW),
    "NextWay": ("vtkPointSplatMirrored.h", (1.0, 1.2, 1.4, 1.6), SHALLOW),
    "SparserSide": ("vtkPointSplatFoldSides.cxx", (1.3, 2.0, 3.0, 6.0), MESHED + PARTS),
    "FlatDeviation": ("vtkPointSplatFace.h", (0.015, 0.03, 0.06), MESHED + FOLDS),
    "FewestWithoutRow": ("vtkPointSplatCreasesFaces.cxx", (3, 5, 7, 33), MESHED + PARTS),
    "StripCosine": ("vtkPointSplatCreaseMeeting.cxx", (0.3, 0.5, 0.7, 2.0), MESHED + PARTS),
    "BetweenCosine": ("vtkPointSplatCreaseMeeting.cxx", (0.7, 0.8, 0.9), PLATES + PARTS),
    "VoidReach": ("vtkPointSplatBorders.cxx", (1.5, 2.0, 2.5), ("holed_ball",) + FOLDS),
    "SureReach": ("vtkPointSplatBorders.cxx", (1.5, 2.0, 2.5), FOLDS + PARTS),
    "RegularReach": ("vtkPointSplatBorders.cxx", (1.25, 1.5, 1.75, 2.0),
                     ("holed_ball", "drapery_vertices", "cut_edges")),
    "SpacingQuantile": ("vtkPointSplatBorders.cxx", (0.25, 0.5, 0.75), ("holed_ball",) + FOLDS),
    "LargestAlpha": ("vtkPointSplatBorders.cxx", (3.5, 4.2, 5.0, 6.0), ("graded_dish", "rounded_ring")),
    "RandomMargin": ("vtkPointSplatBordersAtRandom.cxx", (0.1, 0.2, 0.3, 0.4),
                     ("shell_03", "shell_1", "graded_dish")),
    "PerScatter": ("vtkPointSplatBordersAtRandom.cxx", (1.0, 2.0, 3.0), ("shell_03", "shell_1", "graded_dish")),
    "LeastAgreed": ("vtkPointSplatBordersAtRandom.cxx", (0.7, 0.8, 0.9), ("shell_03", "drapery")),
    "LeastSure": ("vtkPointSplatBorders.cxx", (4, 8, 12, 16), ("holed_ball",) + FOLDS),
    "WholeReach": ("vtkPointSplatDisk.cxx", (1.0, 1.1, 1.2, 1.4), FOLDS + ("tubes_edges",)),
    "BorderPerDistance": ("vtkPointSplatDisk.cxx", (0.5, 0.6, 0.7, 0.8), FOLDS + PARTS),
    "InsideShare": ("vtkPointSplatDisks.cxx", (0.8, 0.9, 1.0, 1.1), ("holed_ball", "cut_edges") + FOLDS),
    "LargestRatio": ("vtkPointSplatDisks.cxx", (1.8, 2.5, 3.5), ("tubes_edges", "part_random")),
    "LargestBend": ("vtkPointSplatDisks.cxx", (0.4, 0.6, 0.8), ("tubes_edges", "drapery")),
    "LeastShare": ("vtkPointSplatDisks.cxx", (0.6, 0.75, 0.9), ("tubes_edges", "drapery")),
    "NearReach": ("vtkPointSplatSheet.cxx", (1.6, 2.0, 2.5), ("tubes_edges", "shell_03")),
    "NearOffset": ("vtkPointSplatSheet.cxx", (0.4, 0.6, 0.8), ("tubes_edges", "shell_03", "scans")),
    "FarTurn": ("vtkPointSplatSheet.cxx", (0.3, 0.4, 0.5, 0.65), ("thick_slices", "shell_03")),
    "EdgeTurn": ("vtkPointSplatSheet.cxx", (0.2, 0.3, 0.5), ("thick_slices", "shell_03")),
    "FarOffset": ("vtkPointSplatSheet.cxx", (0.05, 0.1, 0.2), ("tubes_edges", "grid_lines")),
    "AlikeOffset": ("vtkPointSplatSheet.cxx", (0.01, 0.02, 0.03, 0.06), STREAMS + BESIDE),
    "LargestShadingResidual": ("vtkPointSplatDisk.cxx", (0.015, 0.03, 0.06, 0.25), SHADED),
    "FlatPerResidual": ("vtkPointSplatDisk.cxx", (0.005, 0.02, 0.06), SHADED),
    "PlaneReach": ("vtkPointSplatRows.cxx", (1.5, 2.1, 3.0), ROWS),
    "LargestVariance": ("vtkPointSplatRows.cxx", (0.03, 0.05, 0.1, 0.2), ROWS),
    "BesideCosine": ("vtkPointSplatRows.cxx", (0.7, 0.8, 0.9), ROWS),
    "LongVariance": ("vtkPointSplatRows.cxx", (0.1, 0.15, 0.2, 0.3), ROWS + ("part_vertices_bare",)),
    "FlatVariance": ("vtkPointSplatRows.cxx", (0.01, 0.03, 0.06, 0.08), ROWS + ("part_vertices_bare",)),
    "LargestTurn": ("vtkIsosurfaceSplat.cxx", (0.4, 0.6, 0.8), ("tubes_points", "cut_points")),
    "LeastOfReach": ("vtkIsosurfaceSplat.cxx", (0.65, 0.75, 0.85), ("tubes_points", "cut_points")),
    "BentCosine": ("vtkIsosurfaceFill.cxx", (0.95, 0.97, 0.98), ISOSURFACES),
    "FillShare": ("vtkIsosurfaceEdges.h", (0.66, 0.72, 0.8, 0.9), ISOSURFACES),
    "BentShare": ("vtkIsosurfaceEdges.h", (0.55, 0.6, 0.7), ISOSURFACES),
    "PlainShare": ("vtkIsosurfaceEdges.h", (0.8, 0.87, 1.0), ISOSURFACES),
    "SparseRatio": ("vtkPointSplatSparsePart.cxx", (0.6, 0.8, 1.0, 1.2),
                    ("belted", "belted_6", "thin_disc")),
    "LeaningCosine": ("vtkPointSplatNormalSeams.cxx", (0.5, 0.7, 0.87), WOUND),
    "LeastAcrossPlane": ("vtkPointSplatNormalSeams.cxx", (4, 5, 6), WOUND),
    "AcrossCosine": ("vtkPointSplatNormalSeams.cxx", (0.7, 0.8, 0.9), WOUND),
    "MostAngle": ("vtkPointSplatNormalSeams.cxx", (1.8, 2.2, 2.6), WOUND),
    "SparserThanUsual": ("vtkPointSplatDisks.cxx", (1.5, 2, 3, 4), SPARSE),
    "MostAlone": ("vtkPointSplatDisks.cxx", (0, 1, 2, 3), SPARSE),
    "AsSparse": ("vtkPointSplatDisks.cxx", (1.3, 2, 3), SPARSE),
    "AsDense": ("vtkPointSplatSamplings.cxx", (1.5, 2, 3, 4), BESIDE),
    "OtherSpacing": ("vtkPointSplatSamplings.cxx", (1.2, 1.5, 2, 3), BESIDE),
    "LeastOfPart": ("vtkPointSplatSamplings.cxx", (300, 1000, 3000), BESIDE),
    "MostLikeOwn": ("vtkPointSplatNormalSeams.cxx", (1, 2, 8), WOUND),
    "MostOffSurface": ("vtkPointSplatNormalSeams.cxx", (0.05, 0.1, 0.2, 0.3), WOUND + PLATES),
    "AnotherCosine": ("vtkPointSplatNormalSeams.cxx", (0.966, 0.985, 0.996), WOUND),
    "RadiusPerSize": ("vtkPointSplatStars.h", (0.6, 0.65, 0.7), DISCS + FOLDS),
    "Slope": ("vtkPointSplatStars.h", (0.2, 0.3, 0.4), DISCS + FOLDS),
    "MostTurn": ("vtkPointSplatStars.cxx", (0.4, 0.6, 0.8), BENT),
    "LeastBent": ("vtkPointSplatStars.cxx", (0.2, 0.3, 0.5), BENT),
    "FarNeighbor": ("vtkPointSplatStars.cxx", (2.0, 2.4, 2.8), DISCS + FOLDS),
    "FlatTurn": ("vtkPointSplatStars.cxx", (0.1, 0.2, 0.4), DISCS + BENT),
    "LargeDisk": ("vtkPointSplatStars.cxx", (1.2, 1.4, 1.6, 2.0), FOLDS + ("shell_03", "thin_disc")),
    "EndsCosine": ("vtkPointSplatStars.cxx", (0.3, 0.5, 0.7), PARTS + FOLDS),
    "Sparser": ("vtkPointSplatStars.cxx", (1.5, 2, 3), DISCS + ("holed_ball",)),
    "LongEdge": ("vtkPointSplatRefinement.cxx", (1.5, 1.7, 2.0), DISCS + FOLDS),
    "ShareOfEdge": ("vtkPointSplatRefinement.cxx", (0.5, 0.55, 0.6), DISCS + FOLDS),
    "ShareOfSize": ("vtkPointSplatRefinementNear.cxx", (0.2, 0.4, 0.6), DISCS + FOLDS),
    "MostGraded": ("vtkPointSplatRefinement.cxx", (1.2, 1.5, 2, 1000), ("ledge", "wire", "thick_slices") + ROUGH),
    "LengthPerEdge": ("vtkPointSplatFansDisk.cxx", (0.56, 0.62, 0.68),
                      ("meshes:drapery_vertices", "meshes:part_vertices", "meshes:tubes_edges")),
    "LengthPerReach": ("vtkPointSplatFansDisk.cxx", (0.8, 0.9, 1.0),
                       ("meshes:drapery_vertices", "meshes:part_vertices", "meshes:tubes_edges")),
    "ThirdsPerSpacing": ("vtkPointSplatFansDisk.cxx", (2, 4, 8, 16), LONG + ("meshes:drapery_vertices",)),
    "SteepSine": ("vtkPointSplatFansDisk.cxx", (0.6, 0.75, 0.9), ("arrow", "meshes:drapery_vertices")),
    "NearShare": ("vtkPointSplatFansDisk.cxx", (0.3, 0.5, 0.8), FILLETS),
    "LeastTurn": ("vtkPointSplatFansDisk.cxx", (0.02, 0.04, 0.1), FILLETS),
    "SharpTurn": ("vtkPointSplatFansDisk.cxx", (0.3, 0.52, 1.0), FILLETS),
    "LatticeGrain": ("vtkPointSplatEstimatesFill.cxx", (0.004, 0.1, 0.2, 0.4), ("tubes_labels",) + ROUGH),
    "TurnShare": ("vtkPointSplatEstimatesFill.cxx", (0.0, 0.3, 0.6, 1.0), ROUGH + ("cog_means",)),
    "RoundAngle": ("vtkPointSplatMeshFaces.h", (30, 45, 60), ROUGH + ("meshes:drapery_vertices",)),
    "SliverShare": ("vtkPointSplatMeshFaces.cxx", (0.0, 0.02, 0.1, 0.2), ROUGH + ("meshes:cut_edges",)),
    "AlikeCosine": ("vtkPointSplatMeshNormals.h", (0.8, 0.94, 0.985, 1.0), ROUGH + ("meshes:cut_edges",)),
    "LeastFlat": ("vtkPointSplatMeshFaces.cxx", (0.2, 0.45, 0.7), ("dome", "cog_shared_points", "part_vertices_bare")),
    "MostBends": ("vtkPointSplatMeshFaces.cxx", (0.0, 0.1, 0.3), ("lens",) + ROUGH),
    "MostBend": ("vtkPointSplatStars.cxx", (0.3, 0.4, 0.5, 0.6), LONG + ("meshes:tubes_contour",)),
    "WidthShare": ("vtkPointSplatStars.cxx", (0.0, 0.5, 0.8, 1.2), LONG + ("meshes:tubes_contour",)),
    "TipShare": ("vtkPointSplatStars.cxx", (0.02, 0.05, 0.2), ("arrow",)),
    "MostPast": ("vtkPointSplatMeshBorders.cxx", (0.02, 0.03, 0.05, 0.1), LONG),
    "NarrowShare": ("vtkPointSplatMeshBorders.cxx", (0.01, 0.05, 1.0), ("slab", "ledge", "meshes:cut_noisy")),
    "LeastEdge": ("vtkPointSplatMeshBorders.cxx", (0.002, 0.01, 0.1), ("slab", "meshes:cut_edges", "meshes:cut_noisy")),
    "LeastOff": ("vtkPointSplatMeshBorders.cxx", (0.0005, 0.002, 0.01, 0.03), ("slab", "cog")),
}


def pattern(constant):
    return re.compile(r"(constexpr (?:float|double|int|Slot) %s = )([^;]+);" % constant)


def number(text):
    return float(text.rstrip("f"))


class Scratch:
    """A copy of the sources, of whose filters constants change."""

    def __init__(self, folder):
        self.sources = os.path.join(folder, "sources")
        self.build = os.path.join(folder, "build")
        shutil.rmtree(self.sources, ignore_errors=True)
        shutil.copytree(TOP, self.sources, symlinks=True,
                        ignore=shutil.ignore_patterns("build*", ".git", "Testing"),
                        copy_function=shutil.copy)  # newer than what another run has built
        subprocess.run(["cmake", "-S", self.sources, "-B", self.build, "-DBUILD_TESTING=OFF",
                        "-DCMAKE_BUILD_TYPE=Release"], check=True, stdout=subprocess.DEVNULL)

    def set(self, constant, value):
        """value: the text of a number."""
        name = CONSTANTS[constant][0]
        with open(os.path.join(TOP, "Filters", name)) as file:
            original = file.read()
        is_float = pattern(constant).search(original).group(2).endswith("f")
        text = "%sf" % float(value) if is_float else value
        changed, count = pattern(constant).subn(lambda m: m.group(1) + text + ";", original)
        assert count == 1, "%s is not in %s once" % (constant, name)
        with open(os.path.join(self.sources, "Filters", name), "w") as file:
            file.write(changed)
        subprocess.run(["cmake", "--build", self.build, "--target", "FiltersPointSplatting"],
                       check=True, stdout=subprocess.DEVNULL)

    def restore(self, constant):
        name = CONSTANTS[constant][0]
        shutil.copy(os.path.join(TOP, "Filters", name), os.path.join(self.sources, "Filters", name))

    def measure(self, standin, size):
        """Judges in a process of its own, which loads this build's filters."""
        libraries = [os.path.join(self.build, "lib"), os.environ.get("LD_LIBRARY_PATH", "")]
        environment = dict(os.environ, LD_LIBRARY_PATH=":".join(filter(None, libraries)))
        done = subprocess.run(
            [sys.executable, os.path.abspath(__file__), "--judge", standin, "--size", str(size)],
            env=environment, check=True, stdout=subprocess.PIPE, universal_newlines=True)
        return done.stdout.strip()


def judge(name, size):
    """Prints the figures of a stand-in; meshes: with its triangles."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    import likeness
    import standins
    standin = standins.ALL[name.split(":")[-1]]()
    if name.startswith("meshes:"):
        standin.cloud = standin.mesh
    clips = likeness.estimated(standin.cloud).GetOutput().GetPointData().GetArray("SplatClip")
    lines = 0 if clips is None else int(np.any(vtk_to_numpy(clips) != 0, axis=1).sum())
    print("lines {:6d}, psnr {psnr}, holes {holes}, spill {spill:.4f}".format(
        lines, **likeness.compare(standin, size)))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", help="where the copy is built")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--values", help="instead of those that are listed here")
    parser.add_argument("--judge", help=argparse.SUPPRESS)
    parser.add_argument("constants", nargs="*", metavar="CONSTANT", help=", ".join(CONSTANTS))
    options = parser.parse_args()
    if options.judge:
        judge(options.judge, options.size)
        return
    unknown = [c for c in options.constants if c not in CONSTANTS]
    if unknown or not options.scratch:
        parser.error("no such constant: %s" % unknown if unknown else "--scratch is needed")
    scratch = Scratch(options.scratch)
    for constant in options.constants or CONSTANTS:
        name, values, names = CONSTANTS[constant]
        values = options.values.split(",") if options.values else [str(v) for v in values]
        with open(os.path.join(TOP, "Filters", name)) as file:
            own = number(pattern(constant).search(file.read()).group(2))
        for value in values:
            scratch.set(constant, value)
            for standin in names:
                print("%s %s%s %-24s %s" % (constant, value, "*" if float(value) == own else " ",
                                            standin, scratch.measure(standin, options.size)),
                      flush=True)
        scratch.restore(constant)


if __name__ == "__main__":
    main()
