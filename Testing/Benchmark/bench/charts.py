# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Charts by VTK's own classes, as PNG and as SVG."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY, vtkPlotPoints
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkRectf, vtkTable
from vtkmodules.vtkIOExport import vtkSVGExporter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401

from drawing import window

SIZE = (900, 600)
TIME_TITLE = "frame time, ms (bars: quartiles)"
ERROR_TITLES = TIME_TITLE, "colour error within the outline, rms, % of white"
# The module's settings are cool and round, peers warm, dark and pointed.
OURS = ((30, 120, 220), (0, 165, 120), (120, 60, 200), (90, 190, 240), (20, 40, 150), (130, 200, 60),
        (0, 110, 60), (190, 110, 230), (70, 90, 110), (0, 190, 190))
PEERS = ((0, 0, 0), (230, 130, 20), (200, 30, 40), (150, 90, 30), (240, 190, 0), (230, 100, 140),
         (110, 20, 20))
OUR_MARKER, PEER_MARKER = vtkPlotPoints.CIRCLE, vtkPlotPoints.DIAMOND


class Colours:
    """One for each family of settings, the same in all charts of a kind of scene."""

    def __init__(self, families):
        self.of, counts = {}, {}
        for name, peer, kind in families:
            colours = PEERS if peer else OURS
            number = counts[peer, kind] = counts.get((peer, kind), -1) + 1
            self.of[name] = colours[number % len(colours)]


class Chart:
    """One chart: log axes both ways, its legend beside it.

    Plots and axes count in pixels, not in the values' logarithms: vtkSVGExporter clips before it
    transforms and stretches markers, which shows nothing or ellipses otherwise.
    """

    def __init__(self, title, x_title, y_title):
        self.view = vtkContextView()
        self.window = window(*SIZE)
        self.view.SetRenderWindow(self.window)
        self.view.GetRenderer().SetBackground(1, 1, 1)
        self.view.GetRenderer().SetBackgroundAlpha(1)  # of the SVG, too
        self.chart = vtkChartXY()
        self.view.GetScene().AddItem(self.chart)
        self.chart.SetTitle(title)
        self.chart.GetTitleProperties().SetFontSize(17)
        self.chart.SetShowLegend(True)
        legend = self.chart.GetLegend()
        legend.SetInline(False)
        legend.SetHorizontalAlignment(vtkChartLegend.RIGHT)
        legend.SetVerticalAlignment(vtkChartLegend.TOP)
        legend.SetLabelSize(13)
        legend.GetPen().SetColor(200, 200, 200)
        self.titles = x_title, y_title
        self.tables = []  # x, y and the vtkTable that has them in pixels

    def add(self, kind, x, y, colour, width, label=None):
        data = vtkTable()
        for name in ("x", "y"):
            array = numpy_to_vtk(np.zeros(len(x)), deep=1)
            array.SetName(name)
            data.AddColumn(array)
        self.tables.append((np.asarray(x, float), np.asarray(y, float), data))
        plot = self.chart.AddPlot(kind)
        plot.SetInputData(data, 0, 1)
        plot.SetColor(*colour, 255)
        plot.SetWidth(width)
        if label:
            plot.SetLabel(label)
        else:
            plot.SetLegendVisibility(False)
        return plot

    def line(self, x, y, colour, width=1.5, label=None):
        return self.add(vtkChart.LINE, x, y, colour, width, label)

    def points(self, x, y, colour, label, peer, size=10):
        plot = self.add(vtkChart.POINTS, x, y, colour, 1.5, label)
        plot.SetMarkerStyle(PEER_MARKER if peer else OUR_MARKER)
        plot.SetMarkerSize(size)
        return plot

    def place(self, i, first, last):
        """Puts the values of one axis to pixels from first to last."""
        values = np.concatenate([entry[i] for entry in self.tables])
        low, high = np.log10(values.min() / 1.25), np.log10(values.max() * 1.25)

        def pixels(value):
            return first + (np.log10(value) - low) / (high - low) * (last - first)

        for entry in self.tables:
            vtk_to_numpy(entry[2].GetColumn(i))[:] = pixels(entry[i])
            entry[2].GetColumn(i).Modified()
            entry[2].Modified()
        positions, labels = vtkDoubleArray(), vtkStringArray()
        for value in ticks(10 ** low, 10 ** high):
            positions.InsertNextValue(pixels(value))
            labels.InsertNextValue(spelled(value))
        axis = self.chart.GetAxis((vtkAxis.BOTTOM, vtkAxis.LEFT)[i])
        axis.SetTitle(self.titles[i])
        axis.GetTitleProperties().SetFontSize(14)
        axis.GetLabelProperties().SetFontSize(12)
        axis.GetGridPen().SetColor(225, 225, 225)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(first, last)
        axis.SetCustomTickPositions(positions, labels)

    def finish(self):
        if not self.tables:
            self.line([1, 10], [1, 10], (255, 255, 255))
        self.place(0, 60, 690)
        self.place(1, 45, 560)
        self.window.Render()
        # Where the exporter clips counts from the wrong end: as much room above as below.
        below, above = self.chart.GetPoint1()[1], SIZE[1] - self.chart.GetPoint2()[1]
        self.chart.SetAutoSize(False)
        self.chart.SetSize(vtkRectf(0, 0, SIZE[0], SIZE[1] - (below - above)))
        for _ in range(3):
            self.window.Render()
            ends = self.chart.GetPoint1(), self.chart.GetPoint2()
            for i in range(2):
                self.place(i, ends[0][i], ends[1][i])
        self.window.Render()

    def write(self, path):
        """path.png and path.svg."""
        self.finish()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(path + ".png")
        writer.Write()
        svg = vtkSVGExporter()
        svg.SetRenderWindow(self.window)
        svg.SetFileName(path + ".svg")
        svg.Write()
        self.window.Finalize()


def ticks(low, high):
    """1, 2 and 5 in each decade; fewer where there are many decades, more where there is not one."""
    decades = np.log10(high / low)
    steps = (1, 2, 5) if decades < 3 else (1,)
    if decades < 0.7:
        steps = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8)
    first, last = int(np.floor(np.log10(low))), int(np.ceil(np.log10(high)))
    values = [step * 10.0 ** decade for decade in range(first, last + 1) for step in steps]
    return [value for value in values if low <= value <= high]


def spelled(value):
    for unit, name in ((1e6, " M"), (1e3, " k")):
        if value >= unit:
            return f"{value / unit:.3g}{name}"
    return f"{value:.3g}"


def error_over_time(path, title, rows, front, colours, error="rms_inside", titles=ERROR_TITLES):
    chart = Chart(title, *titles)
    if len(front) > 1:
        # Staircase: at each time the least error to be had in it.
        x, y = [], []
        for row in front:
            if y:
                x.append(row["ms"])
                y.append(y[-1])
            x.append(row["ms"])
            y.append(row[error])
        chart.line(x, y, (150, 150, 150), 1.5, "Pareto front")
    families = {}
    for row in rows:
        if row["status"] == "measured" and row.get(error):
            families.setdefault(row["family"], []).append(row)
    for family, own in families.items():
        colour = colours.of[family]
        x, y = [row["ms"] for row in own], [row[error] for row in own]
        for row in own:
            chart.line([row["ms_q1"], row["ms_q3"]], 2 * [row[error]], colour, 1.5)
        if len(own) > 1:
            chart.line(x, y, colour, 1)
        chart.points(x, y, colour, family, own[0]["peer"])
    chart.write(path)


def cost_over(path, title, x_title, column, series, colours):
    chart = Chart(title, x_title, TIME_TITLE)
    for name, rows in series.items():
        colour = colours.of[rows[0]["family"]]
        x, ms = [row[column] for row in rows], [row["ms"] for row in rows]
        for row in rows:
            chart.line(2 * [row[column]], [row["ms_q1"], row["ms_q3"]], colour, 1.5)
        chart.line(x, ms, colour, 1.5)
        chart.points(x, ms, colour, name, rows[0]["peer"], 8)
    chart.write(path)
