#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether levels of detail are seen to change.

  popping.py [--points MILLIONS] [--size PIXELS] [--frames N] [--step FACTOR] [--scenes NAME ...]
             [--bound CHANGE]

A slow zoom, frame after frame, with levels and with all points. Of each pixel the change from one frame
to the next with levels, minus the same with all points, is what popping adds: printed are the
largest of all pixels and frames, the share of those of more than 16, and the rms, beside the largest
change and its rms with all points; of 255. Pixels within three of the background are told apart: an
outline's are covered by quarters, and each frame has them elsewhere. With --bound the program fails
where the rms that popping adds to the others is greater.
"""
import argparse
import sys

import numpy as np

import levels


def frames(drawing, options, with_levels):
    camera = drawing.renderer.GetActiveCamera()
    angle = camera.GetViewAngle()
    drawing.mapper.SetLevelOfDetail(with_levels)
    pictures = []
    for _ in range(options.frames):
        pictures.append(drawing.picture())
        camera.Zoom(options.step)
    camera.SetViewAngle(angle)
    return pictures


def rms(x):
    return np.sqrt(np.mean(x ** 2))


def masks(picture, size):
    """The pixels near where surface and background meet, and the others of the surface."""
    pixels = picture.reshape(size, size, 3)
    ground = (pixels == pixels[0, 0]).all(axis=2)
    outline = np.zeros_like(ground)
    for y in range(-3, 4):
        for x in range(-3, 4):
            outline |= np.roll(ground, (y, x), axis=(0, 1)) != ground
    return outline.ravel(), (~outline & ~ground).ravel()


def measure(name, options):
    drawing = levels.Drawing(levels.cloud(name, int(1e6 * options.points)), options.size)
    if drawing.wait() is None:
        print(f"{name:14s} has no levels", flush=True)
        return 0.0
    by_levels = frames(drawing, options, True)
    by_all = frames(drawing, options, False)
    drawing.window.Finalize()
    parts = {"outlines": ([], []), "inside": ([], [])}
    for i in range(options.frames - 1):
        own = by_all[i + 1] - by_all[i]
        added = by_levels[i + 1] - by_levels[i] - own
        outline, inside = masks(by_all[i], options.size)
        for part, mask in (("outlines", outline), ("inside", inside)):
            parts[part][0].append(added.reshape(-1, 3)[mask])
            parts[part][1].append(own.reshape(-1, 3)[mask])
    worst = 0.0
    for part, lists in parts.items():
        added, own = (np.concatenate(values) for values in lists)
        worst = rms(added)
        print(f"{name:14s} {part:9s} {np.abs(added).max():8.0f} {1e6 * np.mean(np.abs(added) > 16):9.1f} "
              f"{worst:7.2f} {np.abs(own).max():10.0f} {rms(own):7.2f}", flush=True)
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, default=2.0)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--step", type=float, default=1.01)
    parser.add_argument("--scenes", nargs="+", default=["torus", "bumpy ball", "noisy ball"],
                        choices=list(levels.SCENES))
    parser.add_argument("--bound", type=float, default=np.inf)
    options = parser.parse_args()
    print("                         popping                     all points\n"
          "scene          pixels     largest  > 16,ppm     rms    largest     rms")
    worst = max(measure(name, options) for name in options.scenes)
    sys.exit(int(worst > options.bound))


if __name__ == "__main__":
    main()
