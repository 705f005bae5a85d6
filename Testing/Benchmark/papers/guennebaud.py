# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Guennebaud, Barthe and Paulin 2006, Splat/Mesh Blending, Perspective Rasterization and
Transparency for Point-Based Rendering."""
import itertools

import numpy as np

import measures
import reference
from papers import clouds
from papers.filters import Splats, board_truth
from papers.frames import (
    MODEL, Frame, closed, difference, likeness, medians, mesh_drawing, mesh_truth, scene,
    splat_drawing, splat_mapper)
from papers.page import Number, Quoted
from scenes import sphere_mesh

# Table 1: points; frames a second by perspective splatting and by casting rays.
TABLE_1 = ((154000, 50, 33), (460000, 40, 26), (1400000, 22, 13), (2500000, 15, 9.2),
           (5000000, 6.5, 5))
ZOOMS = (0.35, 0.7, 1.4, 2.8, 5.6)
WAYS = {"tiles": (("SetMethodToTwoPass",), ("SetTargetError", 0.0)),
        "quads": (("SetMethodToTwoPass",), ("SetProjectionToQuads",), ("SetTargetError", 0.0))}
SPACING = 2 / 600   # of the board's points
RADIUS = 0.75 * SPACING


def rasteriser(section, plan):
    size = plan.size(1024)
    section.text(f"Bodies of as many points as Igea has in table 1, {size} x {size} pixels: frames "
                 "a second, and in brackets millions of splats a second, by this module's tiles "
                 "(rays at paraboloids) and by quads through the rasteriser, at full quality.")
    rows, rates = [], {}
    for count, perspective, rays in TABLE_1:
        data = clouds.vertices(clouds.body_mesh(plan.points(count)))
        points = data.GetNumberOfPoints()
        view = scene([1.0], MODEL)
        drawings = {name: splat_drawing(view, [data], size, *calls, ("ScalarVisibilityOff",))
                    for name, calls in WAYS.items()}
        ms = medians(drawings, plan.runs(3 if count < 1e6 else 1))
        closed(drawings)
        rates[count] = ms
        rows.append([f"{count / 1e6:g} M", Number(points, ",.0f"),
                     *(Number(1e3 / ms[name], unit=f" ({points / ms[name] / 1e3:.2f})")
                       for name in WAYS),
                     *(Quoted(f"{fps} ({fps * count / 1e6:.3g})") for fps in (perspective, rays))])
    section.table(["", "points", "tiles", "quads", "paper: perspective splatting",
                   "paper: ray casting"], rows)
    first, last = TABLE_1[0][0], TABLE_1[-1][0]
    section.differs("From 154 k to 5 M points our tiles take "
                    f"{rates[last]['tiles'] / rates[first]['tiles']:.1f} times as long and quads "
                    f"{rates[last]['quads'] / rates[first]['quads']:.1f} times, the paper 7.7 "
                    "times: a GeForce 7800 with vertex programs, here a processor's cores, for "
                    "which each splat's set-up counts. The bodies are made of formulas; the "
                    "instructions that the paper counts have no counterpart in tiles.")
    data = clouds.vertices(clouds.body_mesh(plan.points(460000)))
    section.text(f"The same over zoom, {data.GetNumberOfPoints()} points: how large splats are "
                 "decides what the rasteriser costs (not in the paper).")
    found = {name: [] for name in WAYS}
    rows = []
    for zoom in ZOOMS:
        view = scene([1.0], MODEL, zoom=zoom)
        drawings = {name: splat_drawing(view, [data], size, *calls, ("ScalarVisibilityOff",))
                    for name, calls in WAYS.items()}
        ms = medians(drawings, plan.runs(3))
        projected = drawings["tiles"].mappers[0].GetNumberOfPointsProjected()
        closed(drawings)
        for name in WAYS:
            found[name].append(ms[name])
        rows.append([f"zoom {zoom:g}", Number(projected, ",.0f"),
                     *(Number(ms[name]) for name in WAYS)])
    section.table(["", "splats in view", "tiles, ms", "quads, ms"], rows)
    section.chart("zoom", "ms a frame", [(name, ZOOMS, ms) for name, ms in found.items()])


def board_view(size, position, focus):
    """A frame of the chequered plane without light, and its camera for the reference."""
    count = max(60, round(2 / SPACING * min(1, size / 512)))
    field = 2 / 60
    view = scene([1.0], ([-1.0] * 3, [1.0] * 3))
    mapper = splat_mapper(clouds.vertices(clouds.board(count, field)))
    drawing = Frame(view, [mapper], size)
    look = drawing.actors[0].GetProperty()
    look.LightingOff()
    look.SetDiffuse(1)
    look.SetSpecular(0)
    camera = drawing.renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focus)
    camera.SetViewAngle(50)
    camera.SetClippingRange(1e-3, 10)
    return drawing, count, field


def prefilters(section, plan):
    size = plan.size(512)
    section.text("A chequered plane of 600 x 600 points, unlit, without a prefilter, with EWA "
                 "filtering, with its approximation by Botsch et al. and with the paper's by "
                 "longer tangents: each written down from the equations in NumPy "
                 "(papers/filters.py), since the module has one prefilter only, whose own picture "
                 "is the last. Likeness to the plane with 9 x 9 rays a pixel where all of them "
                 "meet it.")
    for title, position, focus in (
            ("Figure 3: to the horizon", (0, -1.02, 0.12), (0, 0.2, 0)),
            ("Figure 4: a close view at a flat angle", (0, -0.86, 0.012), (0, -0.6, 0))):
        drawing, count, field = board_view(size, position, focus)
        ours = drawing.draw()
        camera = reference.Camera(drawing.renderer.GetActiveCamera(), size, size)
        drawing.close()
        truth, met = board_truth(camera, field, 1 - 2 / count)
        board = clouds.board(count, field)
        xy = np.array([board.GetPoint(i)[:2] for i in range(board.GetNumberOfPoints())])
        grey = clouds.board_colour(xy[:, 0], xy[:, 1], field)
        one = Splats(camera, np.column_stack([xy, 0 * xy[:, 0]]), np.array([0.0, 0.0, 1.0]),
                     RADIUS * 600 / count, grey)
        small = met & (one.spacing_below(2 / count) < 1)
        rows, pictures, like = [], [], {}
        drawn = {name: one.draw(weight) for name, weight in (
            ("none", one.filter_none()), ("EWA", one.filter_ewa()),
            ("Botsch et al.", one.filter_maximum()), ("the paper's", one.filter_tangents()))}
        for name, picture in {**drawn, "this module": ours}.items():
            like[name] = measures.psnr(picture, truth, small)
            rows.append([name, Number(measures.psnr(picture, truth, met), ".1f", " dB"),
                         Number(like[name], ".1f", " dB")])
            pictures.append((f"{name}, {like[name]:.1f} dB", picture))
        section.text(title)
        section.table(["prefilter", "like the plane", "where points are closer than pixels"], rows)
        section.pictures([*pictures, ("truth", truth)])
        gains = "; ".join(f"{name} {like[name] - like['none']:+.1f} dB" for name in list(like)[1:])
        section.differs("The paper shows pictures and no numbers. Where points are closer than "
                        f"pixels, against no prefilter: {gains}. The module widens splats as the "
                        "paper does, but to a radius of 0.8 pixels and not the square root of two, "
                        "whose Gaussian blurs more than the truth's pixels do.")


def hybrids(section, plan):
    size = plan.size(768)
    mesh = clouds.body_mesh(plan.points(150000))
    view = scene([1.0], MODEL, zoom=1.9)
    truth = mesh_truth(view, [mesh], size)
    drawings = {"mesh": mesh_drawing(view, [mesh], size),
                "splats": splat_drawing(view, [mesh], size),
                "hybrid": splat_drawing(view, [mesh], size, ("SetHybridToAutomatic",))}
    pictures = {name: drawing.draw() for name, drawing in drawings.items()}
    mapper = drawings["hybrid"].mappers[0]
    section.text(f"A body of {mesh.GetNumberOfPoints()} points and {mesh.GetNumberOfCells()} "
                 f"triangles, {size} x {size} pixels, so that edges are some four pixels long: of the hybrid "
                 f"{mapper.GetNumberOfTrianglesProjected()} triangles and "
                 f"{mapper.GetNumberOfPointsProjected()} splats meet in a frame. Likeness to the "
                 "mesh with 3 x 3 samples a pixel.")
    ms = medians(drawings, plan.runs(5))
    closed(drawings)
    likes = {name: likeness(picture, truth) for name, picture in pictures.items()}
    section.table(["", "ms", "like the mesh"], [
        [name, Number(ms[name]), Number(likes[name], ".1f", " dB")] for name in drawings])
    section.pictures([(f"{name}, {likes[name]:.1f} dB", picture)
                      for name, picture in pictures.items()])
    section.pictures([(f"{name}: differences, times 8", difference(picture, truth))
                      for name, picture in pictures.items()])
    section.differs("The paper shows pictures and no numbers, of a transition without blending, with "
                    "it, and without samples on the edges between both. Ours blends normals and "
                    "colours before they are shaded, which the paper says should be a little better. "
                    "It needs no samples on edges: triangles that reach into what is drawn as splats "
                    "are drawn as well, so that both overlap everywhere.")


def gathered(section, plan):
    size = plan.size(768)
    ball = sphere_mesh(plan.points(5000), 0.5)
    places = list(itertools.product((-1.2, 0, 1.2), repeat=3))
    data = clouds.vertices(ball)
    view = scene(27 * [0.4], ([-1.7] * 3, [1.7] * 3))

    def drawing_of(*calls):
        drawing = Frame(view, [splat_mapper(data, *calls) for _ in places], size)
        for i, (actor, place) in enumerate(zip(drawing.actors, places)):
            actor.SetPosition(place)
            actor.GetProperty().SetColor([(p + 1.5) / 3 for p in place])
        return drawing
    everything = drawing_of()
    truth = everything.draw()
    all_layers = everything.mappers[0].GetNumberOfLayersDrawn()
    everything.close()
    section.text(f"27 translucent spheres (opacity 0.4) of {data.GetNumberOfPoints()} points, "
                 f"{size} x {size} pixels, {all_layers} layers deep: six layers, three, and three "
                 "of which the last gathers the rest; likeness to all layers.")
    drawings = {
        "6 layers": drawing_of(("SetMaximumNumberOfLayers", 6)),
        "3 layers": drawing_of(("SetMaximumNumberOfLayers", 3)),
        "3 layers, the last gathers": drawing_of(("SetMaximumNumberOfLayers", 3),
                                                 ("GatherRemainingOn",))}
    pictures = {name: drawing.draw() for name, drawing in drawings.items()}
    ms = medians(drawings, plan.runs(5))
    closed(drawings)
    likes = {name: likeness(picture, truth) for name, picture in pictures.items()}
    section.table(["", "frames a second", "paper", "like all layers"], [
        [name, Number(1e3 / ms[name]), Quoted(paper), Number(likes[name], ".1f", " dB")]
        for name, paper in zip(drawings, (21, 45, 49))])
    section.pictures(list(pictures.items()))
    six, three, gather = (ms[name] for name in drawings)
    gain = likes["3 layers, the last gathers"] - likes["3 layers"]
    section.differs(f"Three layers are {six / three:.2f} times as fast as six here, 2.14 times in "
                    "the paper, since tiles peel all layers from one projection of the splats. "
                    f"Gathering takes {gather / three:.2f} times as long as leaving the rest out, "
                    "where in the paper it saves a visibility pass (0.92 times), and changes the "
                    f"likeness by {gain:+.1f} dB: it keeps the colours of what lies behind, and "
                    "loses which of them is nearer. The paper judges by eye, in a scene of at most "
                    f"six layers; ours has {all_layers}.")


SECTIONS = {
    "guennebaud-table-1": ("Guennebaud, Barthe and Paulin, table 1: the rasteriser's cost",
                           rasteriser),
    "guennebaud-figures-3-4": ("Guennebaud, Barthe and Paulin, figures 3 and 4: prefilters",
                               prefilters),
    "guennebaud-figure-5": ("Guennebaud, Barthe and Paulin, figure 5: hybrids", hybrids),
    "guennebaud-figure-6": ("Guennebaud, Barthe and Paulin, figure 6: layers gathered", gathered),
}
