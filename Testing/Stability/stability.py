#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where splats break: one sweep for each way to fail, against fine meshes of closed forms.

  stability.py [--quick | --full] [--output FOLDER] [--size PIXELS] [SWEEP ...]
  stability.py --scans POINTS.vtp MESH [--output FOLDER]
  stability.py --pictures FILE.png

Each sweep changes one thing, all else at its default, and measures the picture against the mesh
of the same surface, supersampled 3 x 3:
- psnr: of the whole picture, dB;
- mesh: the psnr of that mesh itself, not supersampled;
- holes: the pixels well inside the mesh's image where nothing is drawn, as a share of these;
- leaks: the pixels drawn farther than two pixels outside, as a share of those covered.
Sweeps of shadows compare with the same splats under exact shadows, and tell of the points that
are dark and should not be as holes, of those that are lit and should not be as leaks.

Writes stability.csv, a chart of each sweep (NAME.png) and one of the most telling ones
(stability.png). Exit code 1 if a value that defaults must bear misses its bound, or if the default
of a setting is more than 2 dB worse than the best one of its sweep.
--quick: only the values that defaults must bear, no charts.
--scans: the points of real range scans, against a mesh of the same body in the same coordinates.
--pictures: what stays broken, beside what it should look like, and no sweeps.
"""
import argparse
import csv
import os
import sys
import time

try:
    import pointsplatting  # noqa: F401
except ImportError:  # where run.sh and test.sh build it
    sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build",
                                 "lib", "python3", "dist-packages"))

from sweeps import layers, lines, noise, samplings, settings, shadows, sizes, views  # noqa: F401, E402
from sweeps.registry import SWEEPS  # noqa: E402

COLUMNS = ["sweep", "series", "value", "at", "psnr", "mesh", "holes", "leaks", "stable"]


def told(row):
    return "%-27s %-20s %10.4g  %5.1f dB (mesh %5.1f)  holes %.4f  leaks %.4f%s" % (
        row["sweep"], row["series"], row["at"], row["psnr"], row["mesh"], row["holes"], row["leaks"],
        {None: "", True: "  stable", False: "  MISSED"}[row["stable"]])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    extent = parser.add_mutually_exclusive_group()
    extent.add_argument("--quick", action="store_true")
    extent.add_argument("--full", action="store_true", help="all of it, as without it")
    parser.add_argument("--output", default=".")
    parser.add_argument("--size", type=int, default=300)
    parser.add_argument("--scans", nargs=2, metavar=("POINTS", "MESH"))
    parser.add_argument("--pictures", metavar="FILE")
    parser.add_argument("sweeps", nargs="*", metavar="SWEEP", help=", ".join(SWEEPS))
    options = parser.parse_args()
    unknown = set(options.sweeps) - set(SWEEPS)
    if unknown:
        parser.error("there is no sweep " + ", ".join(sorted(unknown)))
    if options.pictures:
        from sweeps.failures import write
        write(options.pictures)
        return 0
    os.makedirs(options.output, exist_ok=True)
    names = options.sweeps or SWEEPS
    if options.scans:
        for name in options.scans:
            if not os.path.isfile(name):
                print("Left out: there is no file", name)
                return 0
        from sweeps.real import real_scans
        SWEEPS["real_scans"] = real_scans(*options.scans)
        names = ["real_scans"]

    missed, found = 0, {}
    for name in names:
        start = time.perf_counter()
        own = found[name] = []
        for row in SWEEPS[name].rows(options.size, options.quick):
            own.append(row)
            missed += row["stable"] is False
            print(told(row), flush=True)
        print("%-27s %.1f s" % (name, time.perf_counter() - start))
        for series in [] if options.quick else SWEEPS[name].off_the_best(own):
            missed += 1
            print("%-27s %-20s MISSED: the default is worse than the best by more than %g dB" % (
                name, series, SWEEPS[name].margin))
    if not options.quick:
        from sweeps.charts import write_charts
        write_charts(found, options.output)
    with open(os.path.join(options.output, "stability.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for own in found.values():
            writer.writerows(own)
    if missed:
        print("%d values miss their bounds: psnr below the mesh's by more than allowed, or holes "
              "or leaks." % missed)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
