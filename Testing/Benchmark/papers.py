#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The papers' tables and figures made anew, on a page with the papers' values beside ours.

  papers.py [SECTION ...] [--files FILE ...] [--output FOLDER] [--quick]

Writes FOLDER/papers.html (pictures are in it) and FOLDER/papers.json, all that was measured; in
less than half an hour on two cores that do nothing else. Data are made of formulas; files of
points or meshes (.ply .vtp .vtk .obj .stl) are measured beside them where a table lists models.
--quick makes all of it small, to see that it works: its numbers mean nothing. Sections:
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

from bench.report import machine  # noqa: E402
from drawing import window  # noqa: E402
from papers import confetti, dobrev, guennebaud, zhang  # noqa: E402
from papers.frames import Plan  # noqa: E402
from papers.page import Page, Section  # noqa: E402

SECTIONS = {**zhang.SECTIONS, **dobrev.SECTIONS, **guennebaud.SECTIONS, **confetti.SECTIONS}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__ + "".join(f"  {name}: {title}\n"
                                      for name, (title, _) in SECTIONS.items()),
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sections", nargs="*", metavar="SECTION")
    parser.add_argument("--files", nargs="+", default=[], metavar="FILE")
    parser.add_argument("--output", default="papers", metavar="FOLDER")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    unknown = set(options.sections) - set(SECTIONS)
    if unknown:
        parser.error("there is no section " + ", ".join(sorted(unknown)))
    plan, page = Plan(options.quick, options.files), Page(options.output)
    probe = window(16, 16)
    probe.Render()
    facts = machine(probe)
    probe.Finalize()
    begin = time.perf_counter()
    for name in options.sections or SECTIONS:
        start = time.perf_counter()
        title, make = SECTIONS[name]
        section = Section(name, title)
        make(section, plan)
        page.sections.append(section)
        facts["seconds"] = round(time.perf_counter() - begin)
        page.write(facts)  # what there is, should the rest not be waited for
        print(f"{name}: {time.perf_counter() - start:.1f} s", flush=True)
    print(os.path.join(options.output, "papers.html"))


if __name__ == "__main__":
    main()
