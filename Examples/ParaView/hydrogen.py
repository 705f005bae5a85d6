# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three nested isosurfaces of a hydrogen orbital as point splats, in ParaView.

bash run.sh --paraview opens ParaView's window with it. In a batch, with a file's name, it writes a
picture: bash run.sh --paraview [--ranks N] Examples/ParaView/hydrogen.py hydrogen.png
"""
import sys

from paraview.simple import (
    Calculator, FastUniformGrid, GetActiveViewOrCreate, IsosurfacePoints, Render, ResetCamera,
    SaveScreenshot, Show,
)  # fmt: skip

SIZE = 127  # of the grid, in cells along each axis, which are 40 Bohr radii


def density():
    """The probability density of the 3d orbital along z: 0 to 100."""
    grid = FastUniformGrid()
    grid.WholeExtent = [-SIZE // 2, SIZE // 2] * 3
    orbital = Calculator(Input=grid)
    orbital.ResultArrayName = "density"
    x, y, z = (f"(coords{axis}*{40 / SIZE})" for axis in "XYZ")
    r2 = f"({x}^2+{y}^2+{z}^2)"
    orbital.Function = f"((3*{z}^2-{r2})*exp(-sqrt({r2})/3))^2*1.05"
    return orbital


def surfaces():
    points = IsosurfacePoints(Input=density())
    points.ContourBy = ["POINTS", "density"]
    points.Isosurfaces = [4.0, 18.0, 50.0]
    points.BlockPerIsosurface = 1
    return points


def show():
    view = GetActiveViewOrCreate("RenderView")
    splats = Show(surfaces(), view)
    splats.Representation = "Point Splats"
    outer, middle, inner = ("/Root/Isovalue" + level for level in ("4", "18", "50"))
    splats.BlockOpacities = [outer, "0.3", middle, "0.5"]
    splats.BlockColors = [
        outer, "0.4", "0.65", "1.0", middle, "1.0", "0.8", "0.35", inner, "0.9", "0.35", "0.25",
    ]  # fmt: skip
    view.CameraPosition = [260, -180, 150]
    ResetCamera(view)
    return view


if __name__ == "__main__":
    shown = show()
    Render(shown)
    if len(sys.argv) > 1:
        SaveScreenshot(sys.argv[1], shown, ImageResolution=[800, 600])
