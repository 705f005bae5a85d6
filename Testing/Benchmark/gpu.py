#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a torus of many points on a graphics card: this module's methods beside VTK's mesh, points
and point Gaussians, opaque and translucent. Writes a table in Markdown.

gpu.py [--points 1,10,100] [--size 1920x1080] [--frames 9] [--budget 60] [--only PARTS] [--output FILE]

Points are in millions, and have normals; sizes are estimated before, once for all methods, and that
time is in the table's own row. "first" is a method's first frame, with shaders and buffers; "levels" how
long after that coarser levels are there, where there are some, which the mapper makes by itself while
it draws all points; "frame" is the median of frames of which each turns the camera and waits until the
card is done, after half a second of such frames. "memory" is
what the card holds more than before the window was made, by nvidia-smi. A method whose first frame
took longer than the budget (seconds) is not drawn with more points.

Without a graphics card it runs on the processor, with small numbers, and says so.
"""
import argparse
import gc
import os
import statistics
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "Accuracy")]

from bench import settings  # noqa: E402
from bench.cloud import Cloud  # noqa: E402
from bench.report import machine  # noqa: E402
from scenes import torus_scene  # noqa: E402

OPACITY = {"opaque": 1.0, "translucent": 0.5}
AUTOMATIC = [settings.splats("splats, as they come", kind) for kind in OPACITY]
# Seconds of frames that are not counted: drivers still compile during the second one, and a card that did nothing,
# as while levels are made, takes a third of a second to raise its clock.
WARM_UP = 0.5
SETTINGS = AUTOMATIC + settings.OPAQUE + settings.TRANSLUCENT


def numbers(text):
    return [float(number) for number in text.split(",")]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=numbers, default=[1, 10, 100], help="millions")
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--budget", type=float, default=60.0, help="seconds of a first frame")
    parser.add_argument("--only", default="", help="parts of settings' names, with commas between them")
    parser.add_argument("--output")
    return parser.parse_args()


def card_megabytes():
    """What the card holds, or None where nothing tells."""
    try:
        done = subprocess.run(
            ["nvidia-smi", "--query-gpu=memory.used", "--format=csv,noheader,nounits"],
            capture_output=True, text=True, check=True)
        return float(done.stdout.split()[0])
    except (OSError, subprocess.CalledProcessError, ValueError, IndexError):
        return None


def draw(drawing):
    """Seconds, until the card is done; nothing is read back."""
    start = time.perf_counter()
    drawing.window.Render()
    drawing.window.WaitForCompletion()
    return time.perf_counter() - start


def wait_for_levels(drawing):
    """Draws until no levels of detail are being made; the seconds that this took, or 0."""
    mappers = [actor.GetMapper() for actor in drawing.actors]
    mappers = [mapper for mapper in mappers if hasattr(mapper, "GetChoices")]
    start = time.perf_counter()
    made = 0.0
    # They are asked for in one frame, and begun in another.
    frames = 3 if mappers else 0
    while frames > 0:
        drawing.turn(1e-3)
        draw(drawing)
        under_way = any("being made" in mapper.GetChoices() for mapper in mappers)
        made = time.perf_counter() - start if under_way else made
        frames = 1 if under_way else frames - 1
    return made


def measure(setting, scene, cloud, options):
    """First frame, levels, median frame (seconds), megabytes or None, and what the driver is."""
    before = card_megabytes()
    width, height = (int(side) for side in options.size.split("x"))
    scene.properties[0].SetOpacity(OPACITY[setting.kind])
    drawing = setting.drawing(scene, cloud, height)
    drawing.window.SetSize(width, height)
    first = draw(drawing)
    levels = wait_for_levels(drawing) if first < options.budget else 0.0
    times = []
    start = time.perf_counter()
    while first < options.budget and len(times) < options.frames:
        warm = time.perf_counter() - start > WARM_UP
        drawing.turn(7)
        seconds = draw(drawing)
        if warm:
            times.append(seconds)
    after = card_megabytes()
    about = machine(drawing.window)
    drawing.close()
    gc.collect()
    return (first, levels, statistics.median(times) if times else first,
            None if before is None else after - before, about)


def main():
    options = arguments()
    lines = ["| points | | first, ms | levels, ms | frame, ms | frames a second | memory, MB |",
             "|---|---|---|---|---|---|---|"]
    print(*lines, sep="\n", flush=True)
    scene = torus_scene()
    slow, about = set(), None
    for millions in options.points:
        cloud = Cloud(scene, round(1e6 * millions))
        cloud.splats()
        rows = [f"| {cloud.points:,} | *sizes estimated* | {cloud.estimation_ms:.0f} | | | | |"]
        print(rows[0], flush=True)
        for setting in SETTINGS:
            name = f"{setting.kind}: {setting.name}"
            if not any(part in name for part in options.only.split(",")) or name in slow or setting.missing():
                continue
            first, levels, frame, memory, about = measure(setting, scene, cloud, options)
            if first > options.budget:
                slow.add(name)
            rows.append(
                f"| {cloud.points:,} | {name} | {1e3 * first:.0f} | "
                f"{f'{1e3 * levels:.0f}' if levels > 0.0 else ''} | {1e3 * frame:.1f} | "
                f"{1 / frame:.1f} | {'-' if memory is None else f'{memory:.0f}'} |")
            print(rows[-1], flush=True)
        lines += rows
    if about is None:
        sys.exit(f"gpu.py: no setting has {options.only!r} in its name")
    driver = about["opengl"].get("renderer", "an unknown driver")
    notes = [f"\n{driver}, OpenGL {about['opengl'].get('version', 'unknown')}, VTK {about['vtk']}, "
             f"commit {about['commit']}, {options.size}, {about['cores']} cores {about['cpu']}."]
    if "llvmpipe" in driver:
        notes.append("\nThis is no graphics card: Mesa draws on the processor.")
    print(*notes, sep="\n")
    if options.output:
        with open(options.output, "w", encoding="utf-8") as file:
            file.write("\n".join(lines + notes) + "\n")


if __name__ == "__main__":
    main()
