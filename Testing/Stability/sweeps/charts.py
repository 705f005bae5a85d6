# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Charts of sweeps, by VTK's own classes."""
import math
import os

from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY, vtkPlotPoints
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkRectf, vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter
import pointsplatting
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401

from sweeps.measures import IMAGE_SPACE, QUADS, TWO_PASSES
from sweeps.registry import SWEEPS

# What the README shows of all sweeps.
TELLING = ("density", "non_uniform", "position_noise", "normal_noise", "outliers", "flipped_normals",
           "close_up", "sheets_in_one", "layer_distance", "radius_scale", "overlap_factor",
           "shadow_layer_distance")
PANEL = (500, 235)
METHOD_COLOURS = {TWO_PASSES: (200, 80, 30), IMAGE_SPACE: (30, 120, 220), QUADS: (0, 150, 90)}
COLOURS = ((200, 80, 30), (30, 120, 220), (0, 150, 90), (140, 60, 190), (220, 160, 0),
           (110, 110, 110), (230, 90, 150))
GREY = (165, 165, 165)
MOST = 65  # dB: what is more is not shown, since it cannot be seen


def table(columns):
    made = vtkTable()
    for name, values in zip("xy", columns):
        array = vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        made.AddColumn(array)
    return made


def ticks(values, log):
    """Positions and labels."""
    if not log:
        wanted = (max(values) - min(values)) / 5
        step = next(s * 10.0 ** e for e in range(-6, 12) for s in (1, 2, 5) if s * 10.0 ** e >= wanted)
        first, last = math.ceil(min(values) / step - 1e-9), math.floor(max(values) / step + 1e-9)
        return [(k * step, "%g" % (k * step)) for k in range(first, last + 1)]
    low, high = math.log10(min(values)), math.log10(max(values))
    every = max(1, round((high - low) / 6))
    steps = (1, 2, 5) if high - low < 2 else (1,)
    return [(e + math.log10(s), "%g" % (s * 10.0 ** e))
            for e in range(math.floor(low), math.ceil(high) + 1, every) for s in steps
            if low - 1e-9 <= e + math.log10(s) <= high + 1e-9]


def fonts(axis, title):
    axis.SetTitle(title)
    axis.GetTitleProperties().SetFontSize(11)
    axis.GetTitleProperties().SetBold(False)
    axis.GetLabelProperties().SetFontSize(11)
    axis.GetGridPen().SetColor(232, 232, 232)
    axis.SetBehavior(vtkAxis.FIXED)


def place(axis, marks):
    positions, labels = vtkDoubleArray(), vtkStringArray()
    for position, label in marks:
        positions.InsertNextValue(position)
        labels.InsertNextValue(label)
    axis.SetCustomTickPositions(positions, labels)


def chart(name, rows):
    """psnr of each series; larger marks where defaults are asked to be stable."""
    plot = vtkChartXY()
    plot.SetAutoSize(False)
    plot.SetShowLegend(True)
    legend = plot.GetLegend()
    legend.SetInline(False)
    legend.SetHorizontalAlignment(vtkChartLegend.RIGHT)
    legend.SetVerticalAlignment(vtkChartLegend.TOP)
    legend.SetLabelSize(11)
    legend.GetPen().SetOpacity(0)
    legend.GetBrush().SetOpacity(0)
    shown = [row["at"] for row in rows if row["at"] > 0]
    log = len(shown) > 2 and max(shown) / min(shown) > 20 and min(row["at"] for row in rows) >= 0
    if log:
        rows = [row for row in rows if row["at"] > 0]

    def add(kind, own, column, colour, width, label=None):
        x = [math.log10(row["at"]) if log else row["at"] for row in own]
        line = plot.AddPlot(kind)
        line.SetInputData(table((x, [min(MOST, row[column]) for row in own])), 0, 1)
        line.SetColor(*colour, 255)
        line.SetWidth(width)
        if label:
            line.SetLabel(label)
        else:
            line.SetLegendVisibility(False)
        return line

    series = SWEEPS[name].series
    if SWEEPS[name].default is None:
        first = [row for row in rows if row["series"] == rows[0]["series"]]
        if first[0]["mesh"] <= MOST:
            add(vtkChart.LINE, first, "mesh", GREY, 1.5, "the mesh")
    for i, method in enumerate(series):
        own = [row for row in rows if row["series"] == method]
        colour = METHOD_COLOURS.get(method, COLOURS[i % len(COLOURS)])
        asked = [row for row in own if row["stable"] is not None or
                 row["value"] == SWEEPS[name].default]
        swept = sorted((row for row in own if not (row["value"] == 0 and row["at"] != 0)),
                       key=lambda row: row["at"])
        if swept:
            add(vtkChart.LINE, swept, "psnr", colour, 2, method)
        if asked:
            marks = add(vtkChart.POINTS, asked, "psnr", colour, 1.5)
            marks.SetMarkerStyle(vtkPlotPoints.CIRCLE)
            marks.SetMarkerSize(9)
    plot.SetTitle(name.replace("_", " "))
    plot.GetTitleProperties().SetFontSize(14)
    bottom, left = plot.GetAxis(vtkAxis.BOTTOM), plot.GetAxis(vtkAxis.LEFT)
    values = [row["at"] for row in rows]
    fonts(bottom, SWEEPS[name].title)
    place(bottom, ticks(values, log))
    ends = [math.log10(value) if log else value for value in (min(values), max(values))]
    margin = 0.02 * (ends[1] - ends[0]) or 1
    bottom.SetRange(ends[0] - margin, ends[1] + margin)
    fonts(left, "psnr, dB")
    least = 10 * math.floor(min(row["psnr"] for row in rows) / 10)
    place(left, [(y, str(y)) for y in range(least, MOST + 1, 10)])
    left.SetRange(least, MOST)
    return plot


def write(path, charts, columns, size):
    """The charts in rows, each of that size."""
    rows = -(-len(charts) // columns)
    actor = vtkContextActor()
    for i, plot in enumerate(charts):
        plot.SetSize(vtkRectf(i % columns * size[0], (rows - 1 - i // columns) * size[1], *size))
        actor.GetScene().AddItem(plot)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    actor.GetScene().SetRenderer(renderer)
    window = pointsplatting.vtkEGLHeadlessRenderWindow()
    window.SetSize(columns * size[0], rows * size[1])
    window.SetMultiSamples(4)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetCompressionLevel(9)
    writer.SetFileName(path)
    writer.Write()
    window.Finalize()


def write_charts(found, folder):
    """found: the rows of each sweep."""
    for name, rows in found.items():
        if len({row["at"] for row in rows}) > 1:
            write(os.path.join(folder, name + ".png"), [chart(name, rows)], 1, (700, 400))
    telling = [name for name in TELLING if name in found]
    if len(telling) > 1:
        write(os.path.join(folder, "stability.png"), [chart(name, found[name]) for name in telling],
              2, PANEL)
