#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Charts of error over frame time, of the mapper as it is set and of VTK's own ways to draw the same.

  fronts.py [--points MILLIONS ...] [--size PIXELS] [--frames N] [--scenes NAME ...] [--output FOLDER]

Scenes: torus (opaque), spheres (four translucent ones, nested) and shadows (a ball over a torus, in the light of
a lamp without size). Each is drawn as splats with nothing set, with other target errors, without smooth
outlines and in image space, as a hybrid of splats and triangles, as its mesh with one sample a pixel
and with several, and as dots and disks. Frames are taken in turn, one of each, the
camera turning; of two the second counts, since settings are changed in between. Times are those that the processors
take with read-back (medians); errors are rms differences of colour from the reference
renderer's picture, 3 x 3 samples a pixel, over all pixels that either covers.

FOLDER (default: fronts) gets fronts.md, a table, fronts.json and fronts.png, a chart for each scene and number of points,
with the front of what nothing else beats in both. 1 and 16 million points, the default, take half an
hour on two cores, and 16 GiB of memory.
"""
import argparse
import gc
import json
import os
import statistics
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Accuracy"))
try:
    import pointsplatting  # noqa: F401
except ImportError:  # where run.sh and test.sh build it
    sys.path.append(os.path.join(HERE, "..", "..", "build", "lib", "python3", "dist-packages"))

from vtkmodules.vtkFiltersCore import vtkImageAppend  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter  # noqa: E402

from bench import analysis, charts  # noqa: E402
from bench.cells import Truths  # noqa: E402
from bench.cloud import Cloud  # noqa: E402
from bench.report import commit  # noqa: E402
from bench.settings import ALL_PEELS, IMAGE, Setting, splats  # noqa: E402
import measures  # noqa: E402
from scenes import shadow_scene, spheres_scene, torus_scene  # noqa: E402

SUPERSAMPLING = 3
MULTISAMPLES = 8  # VTK's own default; drivers may have fewer
LONGEST_WAIT = 600.0  # seconds
DEFAULTS = (("SetTargetError", 1 / 256), ("SetAntiAliasing", True), ("SetMethodToTwoPass",))


def lamp():
    scene = shadow_scene()
    scene.light_radius = 0.0
    return scene


SCENES = {"torus": torus_scene, "spheres": lambda: spheres_scene(4, 0.4, "spheres"), "shadows": lamp}


class Way:
    """One way to draw: a setting, what is called on its mappers and its samples a pixel."""

    def __init__(self, name, calls=(), samples=0, width=1):
        self.name, self.calls, self.samples, self.width = name, calls, samples, width

    def take(self, drawing):
        drawing.window.SetMultiSamples(self.samples)
        for mapper in drawing.mappers:
            for method, *arguments in self.calls:
                getattr(mapper, method)(*arguments)
        for actor in drawing.actors:
            actor.GetProperty().SetPointSize(self.width)


def ours(name, *calls):
    return Way(name, (*DEFAULTS, *calls))


def families(scene):
    """Pairs of a setting, which has a cloud and a window of its own, and the ways to draw that."""
    kind = "translucent" if scene.translucent else "shadows" if scene.shadows else "opaque"
    peels = ALL_PEELS if scene.translucent else None
    shadows = ((("SetShadows", True), ("SetNumberOfShadowSamples", 1), ("SetShadowLightRadius", 0.0))
               if scene.shadows else ())
    found = [(splats("splats", kind, *shadows),
              [ours("splats"), ours("splats, no smooth outlines", ("SetAntiAliasing", False)),
               ours("splats, target 1/64", ("SetTargetError", 1 / 64)),
               ours("splats, target 1/16", ("SetTargetError", 1 / 16)), ours("image space", (IMAGE,))])]
    found.append((Setting("hybrid", kind, "hybrid", (*shadows, ("SetHybridToAutomatic",))),
                  [ours("hybrid")]))
    meshes = [Way("mesh")]
    if kind == "opaque":  # VTK neither peels nor shadows into framebuffers of several samples.
        meshes.append(Way(f"mesh, {MULTISAMPLES} samples", samples=MULTISAMPLES))
    found.append((Setting("mesh", kind, "mesh", peels=peels, shadow_map=scene.shadows), meshes))
    dots = [Way("dots")]
    if kind != "translucent":  # Peeled wide dots take minutes.
        dots.append(Way("dots, 3 pixels", width=3))
    found.append((Setting("dots", kind, "points", peels=peels), dots))
    if kind == "opaque":
        found.append((Setting("disks", kind, "disks"), [Way("point Gaussian disks")]))
    return found


def wait_for_levels(drawing):
    start = time.perf_counter()
    while time.perf_counter() - start < LONGEST_WAIT:
        drawing.turn(1e-6)
        drawing.window.Render()
        if all("being made" not in mapper.GetChoices() for mapper in drawing.mappers):
            return
        time.sleep(0.1)


def measure(scene, cloud, size, frames, truths):
    """Rows, one a way to draw."""
    shown = []
    for setting, ways in families(scene):
        drawing = setting.drawing(scene, cloud, size)
        if not setting.peer:
            for mapper in drawing.mappers:
                mapper.SetTargetError(DEFAULTS[0][1])
            wait_for_levels(drawing)
        shown += [(setting, way, drawing, []) for way in ways]
    rows = []
    for setting, way, drawing, times in shown:
        way.take(drawing)
        scene.set_view(drawing.renderer)
        picture = drawing.draw()
        truth = truths.of(scene, drawing)
        covered = (drawing.layers() > 0) if scene.translucent else (drawing.depth() < float("inf"))
        error = measures.rms(picture, truth.colour, covered | truth.covered) / 2.55
        rows.append(dict(scene=scene.name, points=cloud.points, setting=way.name, family=way.name,
                         peer=setting.peer, status="measured",
                         rms=error, psnr=measures.psnr(picture, truth.colour, covered | truth.covered)))
    for _ in range(frames + 1):
        for setting, way, drawing, times in shown:
            way.take(drawing)
            drawing.turn(2)
            drawing.draw()
            drawing.turn(1)
            drawing.draw()
            times.append(drawing.processor_milliseconds)
    for row, (_, _, drawing, times) in zip(rows, shown):
        del times[0]  # shaders are compiled in it
        row["ms"] = statistics.median(times)
        row["ms_q1"], _, row["ms_q3"] = (statistics.quantiles(times, method="inclusive")
                                         if len(times) > 1 else 3 * times)
    for drawing in {id(drawing): drawing for _, _, drawing, _ in shown}.values():
        drawing.close()
    del shown, drawing
    gc.collect()
    return rows


def millions(points):
    return f"{points / 1e6:.2g} M points"


def append(paths, columns, path):
    rows = []
    for first in range(0, len(paths), columns):
        row = vtkImageAppend()
        for one in paths[first:first + columns]:
            reader = vtkPNGReader()
            reader.SetFileName(one)
            row.AddInputConnection(reader.GetOutputPort())
        row.SetAppendAxis(0)
        rows.append(row)
    whole = vtkImageAppend()
    whole.SetAppendAxis(1)
    for row in reversed(rows):
        whole.AddInputConnection(row.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetInputConnection(whole.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def write(folder, size, cells):
    """cells: lists of rows, by scene and then by points."""
    with open(os.path.join(folder, "fronts.json"), "w", encoding="utf-8") as file:
        json.dump(dict(size=size, commit=commit(), rows=sum(cells, [])), file, indent=1)
    lines = ["| scene | points | drawn as | ms | psnr | on the front |", "|---|---|---|---|---|---|"]
    colours = charts.Colours({(row["family"], row["peer"], ""): None for rows in cells for row in rows})
    paths = []
    for rows in cells:
        front = analysis.front(rows, error="rms")
        for row in rows:
            lines.append(f"| {row['scene']} | {row['points']:,} | {row['setting']} | {row['ms']:.0f} | "
                         f"{row['psnr']:.1f} dB | {'yes' if row in front else ''} |")
        title = f"{rows[0]['scene']}, {millions(rows[0]['points'])}, {size} x {size}"
        paths.append(os.path.join(folder, f"{rows[0]['scene']}-{rows[0]['points']}"))
        charts.error_over_time(paths[-1], title, rows, front, colours, "rms",
                               ("frame time, ms of the processors", "colour error, rms, % of white"))
    counts = sum(rows[0]["scene"] == cells[0][0]["scene"] for rows in cells)
    append([path + ".png" for path in paths], counts, os.path.join(folder, "fronts.png"))
    text = "\n".join(lines) + "\n"
    with open(os.path.join(folder, "fronts.md"), "w", encoding="utf-8") as file:
        file.write(text)
    print(text)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=float, nargs="+", default=[1.0, 16.0])
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=list(SCENES))
    parser.add_argument("--output", default="fronts")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    truths = Truths(SUPERSAMPLING, 1)
    cells = []
    for name in options.scenes:
        scene = SCENES[name]()
        for count in sorted(options.points):
            print(f"{name}, {count:g} M points", file=sys.stderr, flush=True)
            cells.append(measure(scene, Cloud(scene, int(1e6 * count)), options.size, options.frames,
                                 truths))
    write(options.output, options.size, cells)


if __name__ == "__main__":
    main()
