#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against accuracy: every method and quality setting of the module, and VTK's own peers, over
scenes whose truth is known, numbers of points and sizes of window.

  splatbench.py [--quick | --full | --smoke] [--output FOLDER] [--mesh FILE ...] [--only WORD]
                [--pictures] [--minutes N]
  splatbench.py --choices [--output FOLDER] [--only WORD]

--quick (the default) takes a quarter of an hour on two cores, --full an hour, --smoke seconds.
--minutes: after so many no further scene, number of points and size is begun; 60 by default with
--full. First comes what the charts of error over time show, then cheap ones before dear ones, and the
report lists what was left out.
--mesh FILE.ply or .vtp adds a scanned mesh, whose truth Embree tells (Debian's libembree3-3 or libembree4-4).
--pictures keeps a picture of each setting beside the truth.
FOLDER (default: splatbench) gets splatbench.csv, splatbench.json, the report splatbench.md, and
charts as PNG and SVG: error over frame time with the Pareto front for each scene, and cost over
points, pixels, layers and shadow samples.

--choices holds what the mapper chooses by itself for target errors of 1/256, 1/64 and 1/16 against every
setting that it could have chosen: choices.md and choices.json list the fastest that keeps to the
target, what was chosen instead, and where that takes more than 15 % longer. The scenes are not those
that fit_choices.py fits the choices' constants to (bench/unseen.py).

Frames of all settings are taken in turn; times are medians with quartiles, with read-back. Errors
are against Testing/Accuracy/reference, supersampled 3 x 3.
"""
import argparse
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Accuracy"))
try:
    import pointsplatting  # noqa: F401
except ImportError:  # where run.sh and test.sh build it
    sys.path.append(os.path.join(HERE, "..", "..", "build", "lib", "python3", "dist-packages"))

from bench import choosing  # noqa: E402
from bench.cells import Predictor, Truths, measure  # noqa: E402
from bench.cloud import Cloud  # noqa: E402
from bench.plans import PLANS  # noqa: E402
from bench.report import Report, machine, slug  # noqa: E402
from bench.settings import OPAQUE  # noqa: E402
from drawing import save, window  # noqa: E402
from reference.mesh import library  # noqa: E402
from scenes import scanned_scene  # noqa: E402


def parsed():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    plan = parser.add_mutually_exclusive_group()
    for name in PLANS:
        plan.add_argument(f"--{name}", dest="plan", action="store_const", const=name)
    plan.add_argument("--choices", action="store_true")
    parser.set_defaults(plan="quick")
    parser.add_argument("--output", default="splatbench")
    parser.add_argument("--mesh", action="append", default=[])
    parser.add_argument("--only", help="scenes with this in their names, and no others")
    parser.add_argument("--pictures", action="store_true")
    parser.add_argument("--minutes", type=float)
    options = parser.parse_args()
    for name in options.mesh:
        if not os.path.isfile(name):
            parser.error(f"there is no file {name}")
    if options.mesh and not library():
        print("Left out, for want of Embree (Debian's libembree3-3 or libembree4-4):", *options.mesh, file=sys.stderr)
        options.mesh = []
    return options


def main():
    options = parsed()
    if options.choices:
        choosing.main(options.output, options.only)
        return
    plan = PLANS[options.plan]
    report = Report(options.output, plan, options.plan)
    plan.pictures = options.pictures
    plan.save = lambda name, picture: save(report.path(slug(name) + ".png"), picture)
    truths = Truths(plan.supersampling, plan.shadow_samples)
    predictor = Predictor()
    start = time.perf_counter()

    any_window = window(16, 16)
    any_window.Render()
    report.machine = machine(any_window)

    cells = list(plan.cells())
    for name in options.mesh:
        scene = scanned_scene(name)
        cells += [(scene, scene.count, size, OPAQUE) for size in sorted({plan.size, *plan.sizes})]
    cells = [cell for cell in cells if not options.only or options.only in cell[0].name]
    # Of one scene and number of points one after the other, since a cloud is made for them.
    cells.sort(key=lambda cell: (cell[1:3] != (plan.points, plan.size), cell[1]))
    minutes = plan.minutes if options.minutes is None else options.minutes
    cloud, made = None, None
    left = []
    for number, (scene, count, size, settings) in enumerate(cells, 1):
        if number > 1 and minutes and time.perf_counter() - start > 60 * minutes:
            left = cells[number - 1:]
            break
        if made != (scene.name, count):
            cloud, made = None, (scene.name, count)
            cloud = Cloud(scene, count)
        print(f"[{time.perf_counter() - start:5.0f} s] {number}/{len(cells)}: {scene.name}, "
              f"{cloud.points} points, {size} x {size}", file=sys.stderr, flush=True)
        report.add(measure(scene, cloud, size, settings, truths, predictor, plan))
    report.write(time.perf_counter() - start, [
        f"{scene.name}, {count} points, {size} x {size}" for scene, count, size, _ in left])


if __name__ == "__main__":
    main()
