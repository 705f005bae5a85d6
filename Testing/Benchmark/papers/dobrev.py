# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Dobrev, Rosenthal and Linsen 2010, An Image-space Approach to Interactive Point Cloud Rendering
Including Shadows and Transparency."""
import os

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight, vtkPolyDataMapper
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter

import measures
import reference
from papers import clouds
from papers.frames import (
    Frame, closed, crop, likeness, medians, mesh_drawing, mesh_truth, scene, splat_drawing,
    splat_mapper)
from papers.page import Number, Quoted
from papers.zhang import NESTED, bounds_of
from scenes import orbital_meshes, shadow_scene

# Table 3: points, and rates by row, at 512 and 1024 pixels.
TABLE_3 = {
    "Blade": ("883 k", (52, 52), (17.6, 17.5), (8.8, 8.8), (26, 25), (9, 9), (5, 5)),
    "Happy Buddha": ("543 k", (83, 64), (28, 22), (14, 11), (40, 39), (14, 14), (7, 7)),
    "Dragon": ("437 k", (103, 68), (35, 23), (18, 12), (50, 49), (18, 17), (9.6, 9)),
    "3 nested tori": ("3 x 2 M", (8, 8), (2.7, 2.7), (1.4, 1.4), (4, 3.7), (1.3, 1.1), (0.6, 0.6)),
    "Neghip": ("128 k", (235, 82), (83, 27), (43, 14), (145, 64), (62, 35), (35, 22)),
    "Hydrogen": ("535 k", (72, 48), (24, 15), (12, 8), (40, 31), (14, 14), (8, 7.5)),
}
LOCAL = "local illumination"
# Which are drawn, how many translucent layers, how many samples of the light.
ROWS = {LOCAL: ("image space", 0, 0), "transparency, 3 layers": ("image space", 3, 0),
        "transparency, 6 layers": ("image space", 6, 0), "shadows, 1 sample": ("image space", 0, 1),
        "shadows, 5 samples": ("image space", 0, 5), "shadows, 10 samples": ("image space", 0, 10),
        "stock VTK, dots of a pixel": ("dots", 0, 0), "splats, two passes": ("splats", 0, 0)}
IMAGE_SPACE = ("SetMethodToImageSpace",)
TORI = 500000   # points each: a quarter of the paper's
OPACITY = 0.4   # light is left behind six layers, so that all of them are made
RAYS = 48      # to the lamp, of the truth of shadows
UNIT = ([-1.0] * 3, [1.0] * 3)


def dots(data):
    glyphs = vtkVertexGlyphFilter()
    glyphs.SetInputData(data)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(glyphs.GetOutputPort())
    return mapper


class Sweep:
    """A scene by all rows of table 3. The light moves from frame to frame, as the camera does, so
    that shadows are made anew in each."""

    def __init__(self, parts, bounds, size):
        self.centre = np.mean(bounds, 0)
        self.length = float(np.linalg.norm(np.subtract(bounds[1], bounds[0])))
        self.drawings, self.frames = {}, 0
        for name, (kind, layers, samples) in ROWS.items():
            view = scene(len(parts) * [OPACITY if layers else 1.0], bounds, zoom=1.6)
            if kind == "dots":
                mappers = [dots(part) for part in parts]
            else:
                mappers = [splat_mapper(part) for part in parts]
            for mapper in mappers if kind == "image space" else ():
                mapper.SetMethodToImageSpace()
                mapper.SetMaximumNumberOfLayers(max(1, layers))
                mapper.SetShadows(samples > 0)
                mapper.SetNumberOfShadowSamples(max(1, samples))
                mapper.SetShadowLightRadius(0.03 * self.length if samples > 1 else 0.0)
            drawing = Frame(view, mappers, size)
            drawing.renderer.AutomaticLightCreationOff()
            drawing.renderer.RemoveAllLights()
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            drawing.renderer.AddLight(light)
            self.drawings[name] = drawing
        self.fewer = {}

    def move_light(self, drawing):
        self.frames += 1
        angle = 0.6 + 0.01 * self.frames
        light = drawing.renderer.GetLights().GetItemAsObject(0)
        light.SetFocalPoint(self.centre)
        light.SetPosition(self.centre + self.length * np.array([np.cos(angle), np.sin(angle), 1]))

    def rates(self, runs):
        ms = medians(self.drawings, runs, before=self.move_light)
        for name, (_, layers, samples) in ROWS.items():
            mapper = self.drawings[name].mappers[0]
            if samples and mapper.GetNumberOfShadowUpdates() < runs + 1:
                raise RuntimeError(f"{name}: shadows were not computed again")
            if layers and mapper.GetNumberOfLayersDrawn() < layers:
                self.fewer[name] = mapper.GetNumberOfLayersDrawn()
        closed(self.drawings)
        return {name: 1e3 / value for name, value in ms.items()}


def rates(section, plan):
    sizes = [plan.size(pixels) for pixels in (512, 1024)]
    section.text("Table 3: frames a second of points projected as single pixels, with translucent "
                 "layers and with shadows that are made anew in each frame, and in brackets the "
                 "ratio to local illumination. Beside them dots by stock VTK and splats, lit only.")
    tori = [clouds.torus(plan.points(TORI), minor) for minor in (0.4, 0.28, 0.16)]
    found = [("3 nested tori", tori),
             ("Neghip", [clouds.vertices(clouds.charges_mesh(plan.points(128000)))]),
             ("Hydrogen", [clouds.vertices(mesh) for mesh in orbital_meshes(plan.points(535000))])]
    found += [(os.path.basename(name), [clouds.read(name)]) for name in plan.files]
    quotients = []
    for name, parts in found:
        ends = np.array([bounds_of(part) for part in parts])
        bounds = ends[:, 0].min(0), ends[:, 1].max(0)
        sweeps = [Sweep(parts, bounds, size) for size in sizes]
        got = [sweep.rates(plan.runs(2)) for sweep in sweeps]
        paper = next((row for key, row in TABLE_3.items()
                      if key.lower().split()[-1] in name.lower()), None)
        rows = []
        for i, method in enumerate(ROWS):
            fewer = sweeps[0].fewer.get(method)
            row = [method + (f" ({fewer} there)" if fewer else "")]
            row += [Number(rate[method], unit=f" ({rate[method] / rate[LOCAL]:.2f})")
                    for rate in got]
            for k in range(2):
                quoted = paper and i + 1 < len(paper)
                row.append(Quoted(f"{paper[i + 1][k]} ({paper[i + 1][k] / paper[1][k]:.2f})")
                           if quoted else "")
            rows.append(row)
        count = sum(part.GetNumberOfPoints() for part in parts)
        like = "" if name in plan.files or not paper else f" (paper: {paper[0]})"
        section.text(f"{name}, {count:,} points{like}")
        section.table(["", *(f"{size} px" for size in sizes), "paper, 512 px", "paper, 1024 px"],
                      rows)
        if paper:
            quotients.append((got[1]["transparency, 6 layers"] / got[1][LOCAL],
                              got[1]["shadows, 10 samples"] / got[1][LOCAL]))
    shares = [[row[i][1] / row[1][1] for row in TABLE_3.values()] for i in (3, 6)]
    told = [f"{min(q[i] for q in quotients):.2f} to {max(q[i] for q in quotients):.2f} "
            f"({min(shares[i]):.2f} to {max(shares[i]):.2f} in the paper)" for i in (0, 1)]
    section.differs(f"At the larger size six layers leave {told[0]} of the rate of local "
                    f"illumination, ten samples of a lamp {told[1]}. Frames here include the "
                    "read-back, and pixels are dear where the rasteriser is software: that "
                    "makes the first layer dearer beside what others add. The tori have a quarter "
                    "of the paper's points; Neghip and Hydrogen are fields made of formulas.")


def samples(section, plan):
    size = plan.size(320)
    view = shadow_scene()
    data = [clouds.vertices(mesh) for mesh in view.meshes(plan.points(400000))]
    section.text(f"A ball over a torus, {sum(d.GetNumberOfPoints() for d in data)} points, {size} "
                 f"x {size} pixels, lit by a disk: samples of it, the time of a frame in which "
                 "shadows are made anew, and the error of colour (rms) against ray casting with "
                 f"{RAYS} rays to the lamp from each pixel.")
    drawings, pictures = {}, {}
    counts = (1, 5, 10, 30) if plan.quick else (1, 5, 10, 30, 100)
    probe = Frame(view, [splat_mapper(part) for part in data], size)
    truth = reference.render(view.parts(), probe.renderer, size, size, 1,
                             reference.Shadows(view.light_radius, RAYS))
    probe.close()
    for count in counts:
        drawings[f"{count} sample{'s' if count > 1 else ''}"] = splat_drawing(
            view, data, size, ("ShadowsOn",), ("SetNumberOfShadowSamples", count),
            ("SetTargetError", 0.0), ("AntiAliasingOff",),
            ("SetShadowLightRadius", view.light_radius if count > 1 else 0.0))
    for name, drawing in drawings.items():
        pictures[name] = drawing.draw()
    inside = measures.inner(truth.covered, 2)
    errors = [measures.rms(picture, truth.colour, inside) for picture in pictures.values()]
    ms = medians(drawings, plan.runs(3))
    closed(drawings)
    section.table(["", "ms a frame", "rms error of colour (of 255)"], [
        [name, Number(value), Number(error, ".2f")]
        for (name, value), error in zip(ms.items(), errors)])
    section.pictures([*((name, pictures[name]) for name in ("1 sample", "30 samples")),
                      ("ray casting", truth.colour),
                      *((f"{name}, magnified", crop(pictures[name], 0.3, (0.38, 0.72)))
                        for name in ("1 sample", "30 samples"))])
    section.chart("samples", "rms error, of 255", [("point shadow texture", counts, errors)])
    section.differs("The paper has figure 16's pictures with 1 and 30 samples and no errors. A "
                    "sample here is one shadow map, of disks instead of points, against which all "
                    "points are tested, where the paper peels until nothing new is lit (section "
                    "6); samples are jittered in parts of equal area of the lamp where the paper's "
                    "are chosen at random.")


def table_of_layers(section, plan, view, mesh_parts, layers, paper):
    """Rates, and likeness to the mesh with all layers, by method and number of layers."""
    size = plan.size(1024)
    data = [clouds.vertices(mesh) for mesh in mesh_parts]
    truth = mesh_truth(view, mesh_parts, size)
    rows, pictures, series = [], [], []
    for method, call in (("image space", IMAGE_SPACE), ("splats", ("SetMethodToTwoPass",))):
        likes = []
        for count in layers:
            drawing = splat_drawing(view, data, size, call, ("SetMaximumNumberOfLayers", count))
            picture = drawing.draw()
            drawn = drawing.mappers[0].GetNumberOfLayersDrawn()
            ms = medians({method: drawing}, plan.runs(2))[method]
            drawing.close()
            likes.append(likeness(picture, truth))
            quoted = Quoted(paper[1]) if method == "image space" and count == paper[0] else ""
            rows.append([f"{method}, {count} layers", Number(drawn, ".0f"), Number(1e3 / ms),
                         quoted, Number(likes[-1], ".1f", " dB")])
            if count == paper[0]:
                pictures.append((f"{method}, {count} layers", picture))
        series.append((method, layers, likes))
    drawing = mesh_drawing(view, mesh_parts, size)
    picture = drawing.draw()
    ms = medians({"mesh": drawing}, plan.runs(2))["mesh"]
    drawing.close()
    rows.append(["stock mesh, depth-peeled", "", Number(1e3 / ms), "",
                 Number(likeness(picture, truth), ".1f", " dB")])
    section.table(["", "layers drawn", "frames a second", "paper", "like the mesh"], rows)
    section.pictures([*pictures, ("stock mesh, supersampled", truth)])
    section.chart("layers", "psnr, dB", series, log=False)
    return series


def layers_of_neghip(section, plan):
    mesh = clouds.charges_mesh(plan.points(128000))
    section.text(f"An isosurface of many components, {mesh.GetNumberOfPoints()} points, opacity "
                 "0.7, 1024 x 1024 pixels; likeness to the mesh with all its layers.")
    series = table_of_layers(section, plan, scene([0.7], UNIT), [mesh], (1, 2, 3, 4, 6), (4, 25))
    last = series[1][2]
    section.differs("The paper (figure 18) takes four layers at 25 frames a second on a GeForce "
                    "GTX 260 and gives no errors. At this opacity splats gain "
                    f"{last[3] - last[0]:.1f} dB from one layer to four and "
                    f"{last[4] - last[3]:.1f} dB from four to six, since four layers leave 0.8 % "
                    "of the light. The field is made of formulas, so that surfaces hide others "
                    "elsewhere than in Neghip.")


def opacities_of_hydrogen(section, plan):
    meshes = orbital_meshes(plan.points(535000))
    count = sum(mesh.GetNumberOfPoints() for mesh in meshes)
    section.text(f"Three nested isosurfaces of hydrogen's 3d orbital, {count} points, opacities "
                 "from the outermost 0.5, 0.3 and 1.0, 1024 x 1024 pixels.")
    view = scene([0.5, 0.3, 1.0], NESTED)
    series = table_of_layers(section, plan, view, meshes, (1, 3, 6), (6, 9.8))
    section.differs("The paper (figure 19) has six layers at 9.8 frames a second; ours gain "
                    f"{series[0][2][2] - series[0][2][1]:.1f} dB by the last three of them in "
                    f"image space, {series[1][2][2] - series[1][2][1]:.1f} dB with splats. Image "
                    "space is behind at outlines, where a point marks all of the pixel that it "
                    "falls in.")


SECTIONS = {
    "dobrev-table-3": ("Dobrev, Rosenthal and Linsen, table 3: frame rates", rates),
    "dobrev-figure-16": ("Dobrev, Rosenthal and Linsen, figure 16: samples of a light", samples),
    "dobrev-figure-18": ("Dobrev, Rosenthal and Linsen, figure 18: layers", layers_of_neghip),
    "dobrev-figure-19": ("Dobrev, Rosenthal and Linsen, figure 19: opacities",
                         opacities_of_hydrogen),
}
