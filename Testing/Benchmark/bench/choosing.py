# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the mapper chooses by itself, held against every setting that it could have chosen.

Errors are the rms difference of colour, of 1, from the best picture (two passes, all layers, all
shadow samples) over the pixels that either covers, over all views; times are medians of frames
that are taken in turn, of the processors where these draw, else of the clock. Where the mapper did what the
fastest setting does, the difference of their times is noise, and no miss.
"""
import collections
import gc
import json
import math
import os
import statistics
import sys
import time

import numpy as np

from scenes import BACKGROUND

from . import unseen
from .cloud import Cloud
from .report import machine
from .settings import COMPUTE, DEFERRED, IMAGE, QUADS, TWO_PASS, UNBOUNDED, splats

TARGETS = (1 / 256, 1 / 64, 1 / 16)
MISS = 1.15
HOPELESS = 4.0  # settings that take so many times as long as the best picture: one frame does
DEGREES = 17
SAMPLES = 16
PEEL = "SetTransparencyToPeeling"
ALL_SAMPLES = ("SetTargetError", 0.0)
ONE_STEP = ("SetMaximumNumberOfFillSteps", 1)

# The first is the best picture.
OPAQUE = [
    splats("two passes", "opaque", (TWO_PASS,), (COMPUTE,)),
    splats("two passes, quads", "opaque", (TWO_PASS,), (QUADS,)),
    *(splats(f"deferred, c = {c:g}", "opaque", (DEFERRED,), ("SetOverlapFactor", c), UNBOUNDED)
      for c in (0.8, 0.4)),
    splats("image space", "opaque", (IMAGE,)),
    splats("image space, 1 step", "opaque", (IMAGE,), ONE_STEP),
]
TRANSLUCENT = [
    splats("peeling", "translucent", (TWO_PASS,), (PEEL,), ("SetMaximumNumberOfLayers", 256)),
    *(splats(f"peeling, {n} layers", "translucent", (TWO_PASS,), (PEEL,),
             ("SetMaximumNumberOfLayers", n)) for n in (2, 4)),
    splats("image space", "translucent", (IMAGE,), (PEEL,)),
    splats("image space, 1 step", "translucent", (IMAGE,), (PEEL,), ONE_STEP),
    splats("nearest exact", "translucent", ("SetTransparencyToNearestExact",)),
    splats("sorted", "translucent", ("SetTransparencyToSorted",)),
]


def shadows(samples, *calls):
    return (("SetShadows", True), ("SetNumberOfShadowSamples", samples),
            ("SetShadowLightRadius", 0.3), *calls)


SHADED = [
    *(splats(f"{n} samples", "shadows", *shadows(n, (TWO_PASS,), ALL_SAMPLES))
      for n in (SAMPLES, 9, 4, 2, 1)),
    *(splats(f"image space, {n} samples", "shadows", *shadows(n, (IMAGE,), ALL_SAMPLES))
      for n in (SAMPLES, 9, 1)),
]
QUADS_ONLY = [splats(setting.name, "opaque", *setting.calls, (QUADS,)) for setting in OPAQUE[1:]]


def automatic(target, kind, extra=()):
    return splats(f"automatic, 1/{round(1 / target)}", kind, ("SetTargetError", target), *extra)


def cases():
    """(scene, points, pixels a side, settings, what else is set on the automatic ones)"""
    tried = {"opaque": (OPAQUE, ()), "quads": (QUADS_ONLY, ((QUADS,),)),
             "translucent": (TRANSLUCENT, ()), "shadows": (SHADED, shadows(SAMPLES))}
    for scene, points, size, what in unseen.scenes():
        yield scene, points, size, *tried[what]


def did(drawing):
    """What the mapper says it did."""
    mapper = drawing.mappers[0]
    return (mapper.GetMethodUsed(), mapper.GetProjectionUsed(), mapper.GetTransparencyUsed(),
            mapper.GetNumberOfFillSteps(), mapper.GetNumberOfShadowSamplesUsed(),
            mapper.GetStride(), mapper.GetNumberOfLayersDrawn())


def make_ready(drawing):
    """Draws until there is nothing more to make: shaders, buffers, groups, levels of detail."""
    for _ in range(3):
        drawing.draw()
    while "they are being made" in drawing.mappers[0].GetChoices():
        time.sleep(0.1)
        drawing.draw()


def measured(scene, cloud, size, settings, runs, on_processor=True):
    """Of each setting: error, milliseconds, and what was done most often."""
    drawings = [setting.drawing(scene, cloud, size) for setting in settings]
    background = np.round(255 * np.array(BACKGROUND))
    squares, times = [[] for _ in settings], [[] for _ in settings]
    done = [collections.Counter() for _ in settings]
    for drawing in drawings:
        make_ready(drawing)
    for run in range(runs):
        best = None
        for i, drawing in enumerate(drawings):
            if run > 0 and times[i][0] > HOPELESS * times[0][0]:
                continue
            drawing.turn(DEGREES)
            picture = drawing.draw()
            best = picture if best is None else best
            covered = ((np.abs(picture - background) > 1) | (np.abs(best - background) > 1)).any(2)
            squares[i].append((((picture - best)[covered] / 255) ** 2).mean())
            times[i].append(drawing.processor_milliseconds if on_processor else
                            drawing.milliseconds)
            done[i][did(drawing)] += 1
    rows = [dict(setting=setting.name, error=float(np.sqrt(np.mean(square))),
                 ms=statistics.median(taken), did=what.most_common(1)[0][0],
                 choices=drawing.mappers[0].GetChoices())
            for setting, square, taken, what, drawing in
            zip(settings, squares, times, done, drawings)]
    for drawing in drawings:
        drawing.close()
    gc.collect()
    return rows


def judged(rows, targets=TARGETS):
    """For each target the fastest row by hand that keeps to it, and the automatic one."""
    by_hand, chosen = rows[:-len(targets)], rows[-len(targets):]
    for target, row in zip(targets, chosen):
        fastest = min((other for other in by_hand if other["error"] <= target),
                      key=lambda other: other["ms"])
        same = fastest["did"] == row["did"]
        ratio = row["ms"] / fastest["ms"]
        yield dict(target=target, fastest=fastest, chosen=row, ratio=ratio,
                   kept=row["error"] <= target, miss=not same and ratio > MISS)


def summary(verdicts):
    """How many targets are kept, and how much longer than the fastest the choices take."""
    ratios = sorted(verdict["ratio"] for verdict in verdicts)
    kept = sum(verdict["kept"] for verdict in verdicts)
    ninth = ratios[math.ceil(0.9 * len(ratios)) - 1]
    return (f"{kept} of {len(verdicts)} targets are kept; of the fastest setting's time the choices "
            f"take {statistics.median(ratios):.2f} (median), {ninth:.2f} in nine of ten, "
            f"{ratios[-1]:.2f} at most.")


def main(folder, only=None, runs=5):
    os.makedirs(folder, exist_ok=True)
    lines = ["| scene | points | size | target | fastest that keeps to it | ms | chosen | ms | error "
             "| ratio | |", "|" + 11 * "---|"]
    print(*lines, sep="\n")
    report, about = [], None
    for scene, count, size, settings, extra in cases():
        if only and only not in scene.name:
            continue
        cloud = Cloud(scene, count)
        cloud.splats()
        kind = settings[0].kind
        tried = settings + [automatic(target, kind, extra) for target in TARGETS]
        if about is None:
            drawing = tried[0].drawing(scene, cloud, 16)
            drawing.draw()
            about = machine(drawing.window)
            drawing.close()
        rows = measured(scene, cloud, size, tried, runs,
                        "llvmpipe" in about["opengl"].get("renderer", ""))
        verdicts = list(judged(rows))
        report.append(dict(scene=scene.name, points=cloud.points, size=size, rows=rows,
                           verdicts=verdicts))
        for verdict in verdicts:
            fastest, chosen = verdict["fastest"], verdict["chosen"]
            note = ("miss" if verdict["miss"] else "") + ("" if verdict["kept"] else " error")
            what = ", ".join(str(one) for one in chosen["did"][:-1] if one not in (0, "none"))
            lines.append(
                f"| {scene.name} | {cloud.points} | {size} | 1/{round(1 / verdict['target'])} "
                f"| {fastest['setting']} | {fastest['ms']:.0f} | {what} | {chosen['ms']:.0f} "
                f"| {chosen['error']:.4f} | {verdict['ratio']:.2f} | {note} |")
            print(lines[-1], flush=True)
        for row in rows:
            print(f"    {row['setting']}: {row['ms']:.0f} ms, error {row['error']:.4f}",
                  file=sys.stderr, flush=True)
    verdicts = [verdict for case in report for verdict in case["verdicts"]]
    if verdicts:
        lines += ["", summary(verdicts)]
        print(*lines[-2:], sep="\n", flush=True)
    with open(os.path.join(folder, "choices.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    with open(os.path.join(folder, "choices.json"), "w", encoding="utf-8") as file:
        json.dump(dict(machine=about, cases=report), file, indent=1)
