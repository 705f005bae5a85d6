# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times and errors of many settings on one scene, number of points and size of window.

Frames are taken in turn, one of each setting, so that what else the machine does meets all alike;
medians and quartiles are kept. Each frame turns the camera; where there are shadows, the light too,
since shadows of a light that stands still are kept.
"""
import gc
import statistics

import numpy as np

import measures
from reference import Shadows, render

COLUMNS = (
    ("scene", ""), ("points", ""), ("size", "pixels a side"), ("setting", ""), ("peer", ""),
    ("status", "measured, or why not"), ("used", "what the mapper says it did"),
    ("ms", "median of a warm frame with read-back"), ("ms_q1", "first quartile"),
    ("ms_q3", "third quartile"),
    ("processor_ms", "median, of all of the machine's processors together"),
    ("frames", "warm ones timed"),
    ("cold_ms", "the first frame, radii given"),
    ("estimation_ms", "of radii and curvatures, once for all frames"),
    ("psnr", "dB, where either is covered"), ("psnr_inside", "dB, 2 pixels within the outline"),
    ("rms_inside", "per cent of white, 2 pixels within the outline"),
    ("ssim", "of the luma"), ("depth", "95th percentile, diagonals"),
    ("normal", "median, degrees; as read from 8 bits, 0.1 is none"),
    ("silhouette", "wrong pixels a pixel of the outline"),
    ("holes", "pixels"), ("spill", "pixels"), ("layers", "most at a pixel, counted in the picture"),
    ("layer_error", "share of pixels with another number of layers"))


class Truths:
    """Reference pictures, each made once."""

    def __init__(self, supersampling, shadow_samples):
        self.supersampling, self.shadow_samples = supersampling, shadow_samples
        self.pictures = {}

    def of(self, scene, drawing):
        key = scene.name, drawing.size
        if key not in self.pictures:
            shadows = (Shadows(scene.light_radius, self.shadow_samples, scene.diagonal)
                       if scene.shadows else None)
            self.pictures[key] = render(scene.parts(), drawing.renderer, drawing.size, drawing.size,
                                        self.supersampling, shadows)
        return self.pictures[key]


def errors(setting, drawing, picture, truth):
    scene = drawing.scene
    opaque = not scene.translucent
    row = {}
    if opaque:
        depth = drawing.depth()
        covered = np.isfinite(depth)
        row["layers"] = 1
    else:
        layers = drawing.layers()
        covered = layers > 0
        row["layers"] = int(layers.max())
        row["layer_error"] = measures.layer_error(layers, truth.layers)
    inside = measures.inner(truth.covered)
    row["psnr"] = measures.psnr(picture, truth.colour, covered | truth.covered)
    row["psnr_inside"] = measures.psnr(picture, truth.colour, inside)
    rms = measures.rms(picture, truth.colour, inside)
    row["rms_inside"] = None if rms is None else rms / 2.55
    row["ssim"] = measures.ssim(picture, truth.colour, covered | truth.covered)
    row["silhouette"] = measures.silhouette(covered, truth.covered)
    row["holes"] = measures.holes(covered, truth.covered)
    row["spill"] = measures.spill(covered, truth.covered)
    both = covered & truth.covered
    if opaque and both.any():
        row["depth"] = measures.depth_error(depth, truth.depth, both, scene.diagonal)
        # Shadows darken the lights by which normals are read; disks are not lit at all.
        if setting.draws != "disks" and not scene.shadows:
            row["normal"] = measures.normal_angle(drawing.normals(), truth.normal, both)
    return row


def used(setting, drawing):
    if setting.peer:
        return ""
    mapper = drawing.mappers[0]
    if setting.kind == "translucent":
        return f"{mapper.GetTransparencyUsed()}, {mapper.GetNumberOfLayersDrawn()} layers"
    return f"{mapper.GetMethodUsed()}, {mapper.GetProjectionUsed()}"


class Predictor:
    """What a frame will take at least, from smaller ones: small clouds take wide splats, so that
    cost grows with the square roots of points and pixels only."""

    def __init__(self):
        self.known = {}

    def learn(self, scene, setting, points, size, ms):
        self.known.setdefault((scene, setting), []).append((points, size * size, ms))

    def predict(self, scene, setting, points, size):
        return max((ms * np.sqrt(points / p * size * size / s)
                    for p, s, ms in self.known.get((scene, setting), ())
                    if p <= points and s <= size * size), default=0.0)


def measure(scene, cloud, size, settings, truths, predictor, options):
    """Rows, one a setting."""
    rows, alive = [], []
    for setting in settings:
        row = dict(scene=scene.name, points=cloud.points, size=size, setting=setting.name,
                   kind=setting.kind, family=setting.family, peer=setting.peer, status="measured",
                   asked_layers=setting.layers, asked_samples=setting.samples)
        rows.append(row)
        guess = predictor.predict(scene.name, setting.name, cloud.points, size)
        if setting.missing():
            row["status"] = setting.missing()
        elif guess > options.limit_ms:
            row["status"] = f"skipped: about {guess / 1e3:.0f} s a frame expected"
        else:
            alive.append((setting, row))
    drawings = []
    for setting, row in alive:
        if setting.draws != "mesh":
            cloud.splats()
            row["estimation_ms"] = cloud.estimation_ms
        drawing = setting.drawing(scene, cloud, size)
        picture = drawing.draw()
        row["cold_ms"] = drawing.milliseconds
        row["used"] = used(setting, drawing)
        if options.all_errors or size == options.size:
            truth = truths.of(scene, drawing)
            row.update(errors(setting, drawing, picture, truth))
            if options.pictures:
                options.save(f"{scene.name}-{cloud.points}-{size}-{setting.name}",
                             np.concatenate([truth.colour, picture], 1))
        scene.set_view(drawing.renderer)
        drawing.turn(3)
        drawing.draw()
        drawings.append((setting, row, drawing, [], []))
    spent = 0.0
    for _ in range(options.runs):
        if spent > options.cell_ms and all(len(times) >= 3 for *_, times, _ in drawings):
            break
        for _, _, drawing, times, processor_times in drawings:
            drawing.turn(3)
            drawing.draw()
            times.append(drawing.milliseconds)
            processor_times.append(drawing.processor_milliseconds)
            spent += drawing.milliseconds
    for setting, row, drawing, times, processor_times in drawings:
        quartiles = statistics.quantiles(times, method="inclusive") if len(times) > 1 else 3 * times
        row["ms_q1"], row["ms"], row["ms_q3"] = quartiles
        row["processor_ms"] = statistics.median(processor_times)
        row["frames"] = len(times)
        predictor.learn(scene.name, setting.name, cloud.points, size, row["ms"])
        drawing.close()
    del drawings
    gc.collect()
    return rows
