# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Zhang and Pajarola 2006, Single-Pass Point Rendering and Transparent Shading."""
import os
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture
import pointsplatting

from papers import clouds
from papers.frames import (
    MODEL, closed, crop, difference, likeness, medians, mesh_drawing, mesh_truth, picture_of,
    scene, splat_drawing)
from papers.page import Number, Quoted
from scenes import ORBITAL_RADIUS, orbital_meshes, polydata

FACTORS = (1.0, 0.8, 0.6, 0.4)
TABLE_1 = (("David head", "2,000 k", "18/37/17.2", "14/31/11.6", "11/24/9.4", "7/8/3.9"),
           ("Dragon", "1,100 k", "14/34/8.8", "12/29/6.3", "8/15/3.0", "5/7/0.8"),
           ("Female", "303 k", "19/49/18.9", "15/32/13.2", "10/18/6.9", "8/9/2.3"),
           ("BallJoint", "137 k", "17/31/18.6", "12/23/13.6", "9/14/7.1", "5/7/2.3"))
TABLE_2 = (("D-Head", "2,000 k", 0.96, 1.2, 1.4), ("Dragon", "1,100 k", 15.04, 19.70, 22.62),
           ("Female", "303 k", 32.65, 32.11, 37.76), ("Balljoint", "137 k", 65.68, 52.96, 70.37))
QUADS = (("SetMethodToTwoPass",), ("SetProjectionToQuads",))
NESTED = ([-0.7 * ORBITAL_RADIUS] * 3, [0.7 * ORBITAL_RADIUS] * 3)


def deferred(factor):
    return (("SetMethodToDeferred",), ("SetOverlapFactor", factor))


def models(plan):
    """Names and clouds: bodies of as many points as two of the paper's, and files."""
    made = [(f"body, {count // 1000} k", clouds.vertices(clouds.body_mesh(plan.points(count))))
            for count in (137000, 303000)]
    return made + [(os.path.basename(name), clouds.read(name)) for name in plan.files]


def bounds_of(data):
    b = data.GetBounds()
    return b[::2], b[1::2]


def grouped(data, *calls):
    """With groups; the filter knows what it found."""
    grouping = pointsplatting.vtkPointSplatGrouping()
    grouping.SetInputData(data)
    for method, *arguments in calls:
        getattr(grouping, method)(*arguments)
    grouping.Update()
    return grouping


def tables(section, plan):
    section.text("Table 1: groups K, largest and mean degree of the overlap graph at overlap "
                 "factors c, and the seconds that vtkPointSplatGrouping takes at c = 1.")
    rows, found = [], models(plan)
    for name, data in found:
        row = [name, Number(data.GetNumberOfPoints(), ",.0f")]
        for factor in FACTORS:
            start = time.perf_counter()
            one = grouped(data, ("SetOverlapFactor", factor))
            seconds = time.perf_counter() - start
            if factor == 1:
                first, degree = seconds, one.GetMeanDegree()
            cell = Number(one.GetNumberOfGroups(), ".0f")
            cell.text += f"/{one.GetMaximumDegree()}/{one.GetMeanDegree():.1f}"
            row.append(cell)
        rows.append(row + [Number(first, ".2f", " s")])
    for row in TABLE_1:
        rows.append([Quoted(f"paper: {row[0]}"), *map(Quoted, row[1:]), ""])
    section.table(["model", "points", *(f"c = {c:g}" for c in FACTORS), "time"], rows)
    section.differs("Degrees follow from how far splats overlap. Of even samplings those of d at c "
                    "= 1 mean disks of the square root of (d + 1) / 4 pi spacings: 1.2 for the "
                    "paper's Female and BallJoint, whose radii it does not tell, and "
                    f"{np.sqrt((degree + 1) / 4 / np.pi):.2f} here. The paper colours by the same "
                    "heuristic, vertices of large degree first; its scans are sampled less evenly "
                    "than these bodies.")
    sizes = [plan.size(pixels) for pixels in (1024, 256)]
    section.text("Table 2: frames a second, in brackets over those of two passes by the same "
                 "rasteriser. \"One group\" has all splats in one: no grouping could be faster.")
    rows, gains = [], {size: [] for size in sizes}
    for name, data in found:
        for size in sizes:
            ms, counts = times_of_methods(data, size, plan.runs(3))
            row = [f"{name}, {size} px", Number(data.GetNumberOfPoints(), ",.0f"),
                   Number(1e3 / ms["tiles"]), Number(1e3 / ms["quads"])]
            for key in (0.8, 0.4, "one"):
                row.append(Number(1e3 / ms[key], unit=f" ({ms['quads'] / ms[key]:.2f})"))
            gains[size].append(ms["quads"] / ms[0.4])
            rows.append(row + [", ".join(map(str, counts))])
    for name, points, two, *others in TABLE_2:
        rows.append([Quoted(f"paper: {name}"), Quoted(points), "", Quoted(two),
                     *(Quoted(f"{fps} ({fps / two:.2f})") for fps in others), "", ""])
    section.table(["model", "points", "two passes, tiles", "two passes, quads", "c = 0.8",
                   "c = 0.4", "one group", "K"], rows)
    told = "; ".join(f"{min(gain):.2f} to {max(gain):.2f} times at {size} pixels"
                     for size, gain in gains.items())
    section.differs("At c = 0.4 the frame rate of deferred blending over that of two passes of "
                    f"quads is {told}; in the paper 1.07 to 1.50 times. It spares the second pass "
                    "over the splats and composites K images instead: the more pixels there are "
                    "for each splat, the less that saves, and where the rasteriser is software a "
                    "composited pixel is not as cheap as on the paper's GeForce 7800 GTX. Tiles "
                    "project splats once as well, and need no groups.")


def times_of_methods(data, size, runs):
    """Milliseconds by method, and the groups at c = 0.8 and 0.4."""
    one = vtkPolyData()
    one.ShallowCopy(data)
    group = numpy_to_vtk(np.zeros(data.GetNumberOfPoints(), np.int32), deep=1)
    group.SetName("SplatGroup")
    one.GetPointData().AddArray(group)
    view = scene([1.0], bounds_of(data))
    drawings = {"tiles": splat_drawing(view, [data], size, ("SetMethodToTwoPass",)),
                "quads": splat_drawing(view, [data], size, *QUADS),
                0.8: splat_drawing(view, [data], size, *deferred(0.8)),
                0.4: splat_drawing(view, [data], size, *deferred(0.4)),
                "one": splat_drawing(view, [one], size, *deferred(1.0))}
    ms = medians(drawings, runs)
    counts = [drawings[c].mappers[0].GetNumberOfGroups() for c in (0.8, 0.4)]
    closed(drawings)
    return ms, counts


def quality_over_c(section, plan):
    size = plan.size(512)
    mesh = clouds.body_mesh(plan.points(137000))
    data = clouds.vertices(mesh)
    view = scene([1.0], MODEL, zoom=3.0)
    section.text(f"A body of {data.GetNumberOfPoints()} points at {size} x {size} pixels. Likeness "
                 "to two passes by the same rasteriser (the paper's standard blending), and to the "
                 "mesh of the same vertices, 3 x 3 samples a pixel. Parts of the pictures are "
                 "magnified, and differences eight-fold.")
    truth = mesh_truth(view, [mesh], size)
    standard = picture_of(view, [data], size, *QUADS)
    rows = [["two passes", "", "", Number(likeness(standard, truth), ".1f", " dB")]]
    pictures = [("two passes", crop(standard))]
    like = {}
    for factor in FACTORS:
        for voronoi in (True, False):
            drawing = splat_drawing(view, [data], size, *deferred(factor),
                                    ("SetVoronoiDepth", voronoi))
            picture = drawing.draw()
            like[factor, voronoi] = likeness(picture, standard)
            name = f"c = {factor:g}" + ("" if voronoi else ", nearest fragments")
            rows.append([name, Number(drawing.mappers[0].GetNumberOfGroups(), ".0f"),
                         Number(like[factor, voronoi], ".1f", " dB"),
                         Number(likeness(picture, truth), ".1f", " dB")])
            drawing.close()
            if voronoi:
                pictures.append((f"{name}, {like[factor, voronoi]:.1f} dB", crop(picture)))
    pictures.append((f"c = {FACTORS[-1]:g} less two passes",
                     crop(difference(picture_of(view, [data], size, *deferred(FACTORS[-1])),
                                     standard))))
    section.table(["", "K", "like two passes", "like the mesh"], rows)
    section.pictures(pictures)
    section.chart("c", "psnr against two passes, dB", [
        (label, FACTORS, [like[c, voronoi] for c in FACTORS])
        for voronoi, label in ((True, "Voronoi depth"), (False, "nearest fragment"))], log=False)
    section.differs("The paper (section 6.1) has pictures and the words \"hardly any visible "
                    "artifacts\" down to c = 0.4, no numbers; ours lose "
                    f"{like[1.0, True] - like[0.4, True]:.1f} dB from c = 1 to 0.4, and "
                    f"{like[1.0, False] - like[0.4, False]:.1f} dB without Voronoi depth.")


def group_of(grouping, k):
    """The points of one group, as a cloud of its own."""
    data = grouping.GetOutput()
    own = vtk_to_numpy(data.GetPointData().GetArray("SplatGroup")) == k
    part = polydata(vtk_to_numpy(data.GetPoints().GetData())[own],
                    vtk_to_numpy(data.GetPointData().GetNormals())[own])
    for name in ("SplatRadius", "SplatCurvature"):
        values = data.GetPointData().GetArray(name)
        if values:
            array = numpy_to_vtk(vtk_to_numpy(values)[own], deep=1)
            array.SetName(name)
            part.GetPointData().AddArray(array)
    return part


def groups(section, plan):
    count, size = plan.points(30000), plan.size(512)
    data = clouds.vertices(clouds.body_mesh(count))
    section.text(f"A body of {data.GetNumberOfPoints()} points in four and in eight groups: what "
                 "the disks within groups overlap, as a share of all disks' area, and what share "
                 "of the surface they cover (the mean over groups), as they are and extended by "
                 "copies or by larger radii (section 4.2.2). The pictures show the first group "
                 "alone.")
    view, rows, pictures = scene([1.0], MODEL, zoom=2.6), [], []
    overlap, before, copies = {}, {}, {}
    for wanted in (4, 8):
        for way in ("AsIs", "Duplicate", "Enlarge"):
            one = grouped(data, ("SetColoringToWeighted",), ("SetWantedNumberOfGroups", wanted),
                          (f"SetCoverageTo{way}",))
            cells, figures = ["", ""], range(wanted)
            overlap[wanted] = 100 * one.GetOverlapWithinGroups()
            share = 100 * one.GetNumberOfDuplicates() / data.GetNumberOfPoints()
            if way != "AsIs":
                before[wanted] = 100 * np.mean([one.GetGroupCoverageBefore(k) for k in figures])
                after = 100 * np.mean([one.GetGroupCoverage(k) for k in figures])
                cells = [Number(before[wanted], ".1f", " %"), Number(after, ".1f", " %")]
            if way == "Duplicate":
                copies[wanted] = share
            rows.append([f"K = {wanted}, {way}", Number(overlap[wanted], ".1f", " %"), *cells,
                         Number(share, ".0f", " %"),
                         Number(np.mean([one.GetGroupRadiusScale(k) for k in figures]), ".2f")])
            part = group_of(one, 0)
            pictures.append((f"K = {wanted}, {way}: {part.GetNumberOfPoints()} splats", picture_of(
                view, [part], size, ("SetRadiusScale", 1.5), ("SetKernelSupport", 1.0),
                ("AntiAliasingOff",))))
    section.table(["", "overlap within groups", "cover before", "cover after", "copies", "radii"],
                  rows)
    section.pictures(pictures)
    section.differs("The paper's figure 11 is pictures: smaller overlaps and less cover at K = 8 "
                    f"than at K = 4. Here overlaps are {overlap[8]:.1f} % against "
                    f"{overlap[4]:.1f} %, and groups cover {before[8]:.0f} % against "
                    f"{before[4]:.0f} % of the surface "
                    "as they are. The paper's dragon took 45 % copies at K = 4 (section 6.2), ours "
                    f"{copies[4]:.0f} % and, at K = 8, {copies[8]:.0f} %: a copy may lose 30 % of "
                    "its disk to others of its group, and where groups overlap and cover much "
                    "already none loses less. The paper does not tell its bound.")


def transparency(section, plan):
    size = plan.size(1024)
    meshes = orbital_meshes(plan.points(334000))
    data = [clouds.vertices(mesh) for mesh in meshes]
    points = sum(one.GetNumberOfPoints() for one in data)
    view, solid = (scene(opacities, NESTED, zoom=1.15)
                   for opacities in ([0.3, 0.5, 1.0], [1.0, 1.0, 1.0]))
    section.text(f"Three nested isosurfaces of an orbital, {points} points, opacities 0.3, 0.5 and "
                 f"1, {size} x {size} pixels; likeness to the mesh, depth-peeled with 3 x 3 "
                 "samples a pixel (figure 12 compares the same three).")
    truth = mesh_truth(view, meshes, size)
    ways = {"1+1 passes: sorted (Algorithm 2)": (("SetTransparencyToSorted",),),
            "2+1 passes: nearest exact (Algorithm 3)": (("SetTransparencyToNearestExact",),),
            "depth peeling, 8 layers": (("SetTransparencyToPeeling",),
                                        ("SetMaximumNumberOfLayers", 8))}
    drawings = {name: splat_drawing(view, data, size, *calls) for name, calls in ways.items()}
    pictures = {name: drawing.draw() for name, drawing in drawings.items()}
    drawings["opaque splats"] = splat_drawing(solid, data, size)
    drawings["stock mesh, depth-peeled"] = mesh_drawing(view, meshes, size)
    pictures["stock mesh, depth-peeled"] = drawings["stock mesh, depth-peeled"].draw()
    ms = medians(drawings, plan.runs(3))
    closed(drawings)
    paper = dict(zip([*ways, "opaque splats"], ("9", "5", "less than 2", "14")))
    rows = []
    for name, time_taken in ms.items():
        psnr = Number(likeness(pictures[name], truth), ".1f", " dB") if name in pictures else ""
        quoted = Quoted(paper[name]) if name in paper else ""
        rows.append([name, Number(1e3 / time_taken), quoted, psnr])
    section.table(["", "frames a second", "paper, section 6.2", "like the mesh"], rows)
    section.pictures([(name, picture) for name, picture in pictures.items()])
    one, two, peeled = (ms[name] for name in ways)
    section.differs("In the paper sorting is more than 4.5 times as fast as peeling, here "
                    f"{peeled / one:.2f} times, and nearest exact more than 2.5 times, here "
                    f"{peeled / two:.2f} times: our tiles peel all layers from one projection of "
                    "the splats, while sorting needs rasterised quads. The paper does not name the "
                    "model.")


def sky(width):
    """An equirectangular picture: a pale sky with a sun, over a chequered floor; y is up."""
    a, b = np.meshgrid(2 * np.pi * (np.arange(width) + 0.5) / width - np.pi,
                       np.pi * (np.arange(width // 2) + 0.5) / (width // 2) - np.pi / 2)
    up = np.sin(b)
    far = 5 * np.cos(b) / np.maximum(-up, 1e-2)
    tiles = (np.floor(far * np.cos(a)) + np.floor(far * np.sin(a))) % 2
    floor = np.where(tiles[..., None] > 0, (0.9, 0.85, 0.75), (0.25, 0.3, 0.4))
    t = np.clip(up, 0, 1)[..., None] ** 0.5
    sun = np.exp(-80 * ((a - 0.9) ** 2 + (b - 0.6) ** 2))[..., None]
    above = (1 - t) * (0.95, 0.9, 0.85) + t * (0.2, 0.4, 0.8) + sun
    colour = np.where(up[..., None] < 0, floor, above)
    image = vtkImageData()
    image.SetDimensions(width, width // 2, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(
        np.round(255 * np.clip(colour, 0, 1)).astype(np.uint8).reshape(-1, 3), deep=1))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


def refraction(section, plan):
    size, texture = plan.size(768), sky(plan.size(2048))
    data = clouds.vertices(clouds.body_mesh(plan.points(200000)))
    section.text(f"A glass body of {data.GetNumberOfPoints()} points, index 1.5, dispersion 0.04, "
                 f"that absorbs some red and blue, {size} x {size} pixels: its nearest layer "
                 "alone, and all layers.")
    view, drawings, pictures = scene([0.0], MODEL, zoom=1.3), {}, {}
    single, counted, followed = "a single layer", "layers counted, equation 12", "rays followed"
    for name, way, layers in ((single, "Peeling", 1), (counted, "NearestExact", 32),
                              (followed, "Peeling", 32)):
        drawing = drawings[name] = splat_drawing(
            view, [data], size, ("RefractionOn",), ("SetDispersion", 0.04),
            ("SetAbsorption", 0.25, 0.05, 0.2), ("ScalarVisibilityOff",),
            (f"SetTransparencyTo{way}",), ("SetMaximumNumberOfLayers", layers))
        renderer = drawing.renderer
        renderer.SetEnvironmentUp(0, 0, 1)
        renderer.SetEnvironmentRight(1, 0, 0)
        renderer.SetEnvironmentTexture(texture)
        box = vtkSkybox()
        box.SetTexture(texture)
        box.SetProjectionToSphere()
        box.SetFloorPlane(0, 0, 1, 0)
        box.SetFloorRight(1, 0, 0)
        renderer.AddActor(box)
        pictures[name] = drawing.draw()
    drawn = [drawing.mappers[0].GetNumberOfLayersDrawn() for drawing in drawings.values()]
    ms = medians(drawings, plan.runs(3))
    closed(drawings)
    section.table(["", "layers", "ms", "like a single layer"], [
        [name, Number(n, ".0f"), Number(ms[name]),
         "" if name == single else Number(likeness(pictures[name], pictures[single]), ".1f", " dB")]
        for name, n in zip(ms, drawn)])
    section.pictures([*pictures.items(), (f"{followed}, less {single}",
                                          difference(pictures[followed], pictures[single], 1))])
    section.differs("The paper has two pictures and the words \"subtle differences\" (section "
                    "6.2), no numbers. Its rays are bent once, by the number of layers behind the "
                    "first (equation 12), as ours are where layers are sorted. Peeled layers let "
                    "rays be followed from interface to interface, so that light is bent at each, "
                    "may be reflected totally, and is absorbed by the distance that it went: that "
                    "differs far more from a single layer.")


SECTIONS = {
    "zhang-tables": ("Zhang and Pajarola, tables 1 and 2: groups, and deferred blending", tables),
    "zhang-figure-8": ("Zhang and Pajarola, figure 8: quality over c", quality_over_c),
    "zhang-figure-11": ("Zhang and Pajarola, figure 11: four and eight groups", groups),
    "zhang-section-6.2": ("Zhang and Pajarola, section 6.2 and figure 12: transparency",
                          transparency),
    "zhang-figure-14": ("Zhang and Pajarola, figure 14: one refracting layer and all", refraction),
}
