# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what was measured: CSV, JSON, charts, and a report in Markdown that is also printed."""
import csv
import datetime
import json
import os
import platform
import re
import subprocess

from vtkmodules.vtkCommonCore import vtkVersion

from . import analysis, charts
from .cells import COLUMNS

def first_line(path, key):
    try:
        with open(path, encoding="utf-8") as file:
            for line in file:
                if line.startswith(key):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return ""


def commit():
    here = os.path.dirname(os.path.abspath(__file__))
    try:
        done = subprocess.run(["git", "-C", here, "describe", "--always", "--dirty"], check=True,
                              capture_output=True, text=True)
        return done.stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def machine(window):
    """Of the machine, the driver and the build; window: one that has drawn."""
    capabilities = {}
    for line in window.ReportCapabilities().splitlines():
        for key in ("vendor", "renderer", "version"):
            if line.startswith(f"OpenGL {key} string:"):
                capabilities[key] = line.split(":", 1)[1].strip()
    return {"date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
            "cpu": first_line("/proc/cpuinfo", "model name") or platform.processor(),
            "cores": os.cpu_count(), "memory": first_line("/proc/meminfo", "MemTotal"),
            "system": platform.platform(), "opengl": capabilities,
            "vtk": vtkVersion.GetVTKVersion(), "commit": commit()}


class Report:
    def __init__(self, folder, plan, name):
        self.folder, self.plan, self.name = folder, plan, name
        self.rows, self.machine = [], {}
        self.text = []
        os.makedirs(folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def say(self, line=""):
        print(line, flush=True)
        self.text.append(line)

    def add(self, rows):
        """Rows of another cell; the CSV has all that there are, should the rest not be waited for."""
        for row in rows:
            row["pixels"] = row["size"] ** 2
        self.rows += rows
        with open(self.path("splatbench.csv"), "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, [name for name, _ in COLUMNS], extrasaction="ignore")
            writer.writeheader()
            writer.writerows(self.rows)

    def write(self, seconds, left_out=()):
        """left_out: what there was no time for, in words."""
        self.colours = charts.Colours(
            dict.fromkeys((row["family"], row["peer"], row["kind"]) for row in self.rows))
        self.say(f"# splatbench --{self.name}: {seconds / 60:.0f} minutes")
        self.say()
        for key, value in self.machine.items():
            self.say(f"- {key}: {value}")
        for words in left_out:
            self.say(f"- left out, for want of time: {words}")
        found = {"growth": self.growths(), "scenes": self.scenes()}
        self.gaps()
        with open(self.path("splatbench.json"), "w", encoding="utf-8") as file:
            json.dump({"machine": self.machine, "plan": self.name, "seconds": seconds, "left_out": list(left_out),
                       "columns": dict(COLUMNS), **found, "rows": self.rows}, file, indent=1)
        with open(self.path("splatbench.md"), "w", encoding="utf-8") as file:
            file.write("\n".join(self.text) + "\n")

    def cut(self, scene, **fixed):
        return [row for row in self.rows if row["scene"] == scene and
                all(row[key] == value for key, value in fixed.items())]

    def growths(self):
        """Charts of cost, and exponents."""
        found = []
        self.say()
        self.say("## How cost grows")
        self.say()
        self.say("ms = a x^exponent over all x, and between the two largest; the same of the time of")
        self.say("all processors together, which other work on the machine disturbs less (and which")
        self.say("says nothing of a GPU); and the line ms = fixed + each x.")
        for scene in dict.fromkeys(row["scene"] for row in self.rows):
            points, size = self.at(scene)
            at_points, at_size = f"{points} points", f"{size} x {size} pixels"
            both = f"{at_points}, {at_size}"
            here = self.near(scene, points, size)
            for rows, column, name, title, where in (
                    (self.cut(scene, size=size), "points", "points", "points", at_size),
                    (self.near(scene, points), "pixels", "pixels", "pixels of the window", at_points),
                    (here, "asked_layers", "layers", "layers asked for", both),
                    (here, "asked_samples", "samples", "shadow samples", both)):
                series = analysis.series(rows, column, "family" if rows is here else "setting")
                if series:
                    charts.cost_over(self.path(f"{slug(scene)}-cost-over-{name}"),
                                     f"{scene}: cost over {name}, {where}", title, column, series,
                                     self.colours)
                    found += self.growth(series, column, name, f"{scene}, {where}")
        return found

    def growth(self, series, column, name, where):
        """The exponents of one chart."""
        scale, each = (1e6, "each million") if name in ("points", "pixels") else (1, "each")
        self.say()
        self.say(f"| {where} | exponent over {name} | upper end | of processors | upper end | fixed ms "
                 f"| ms {each} | off the line |")
        self.say("|---|---|---|---|---|---|---|---|")
        found = []
        for setting, rows in series.items():
            x = [row[column] for row in rows]
            grown = analysis.growth(x, [row["ms"] for row in rows])
            busy = analysis.growth(x, [row["processor_ms"] for row in rows])
            self.say(f"| {setting} | {grown['exponent']:.2f} | {grown['exponent_upper']:.2f} | "
                     f"{busy['exponent']:.2f} | {busy['exponent_upper']:.2f} | "
                     f"{grown['fixed_ms']:.0f} | {scale * grown['each_ms']:.1f} | "
                     f"{100 * grown['off_line']:.0f} % |")
            found.append(dict(over=name, where=where, setting=setting, peer=rows[0]["peer"], **grown,
                              processors=busy))
        ours = [one for one in found if not one["peer"]]
        if ours:
            most = max(ours, key=lambda one: one["processors"]["exponent"])
            self.say()
            self.say(f"Largest exponent of ours over {name}, of processors: "
                     f"{most['processors']['exponent']:.2f} ({most['setting']}).")
        return found

    def at(self, scene):
        """The number of points and the size at which a scene is charted: the plan's, or what comes
        nearest to it."""
        places = {(row["points"], row["size"]) for row in analysis.measured(self.rows)
                  if row["scene"] == scene}
        return min(places, key=lambda place: (abs(place[1] - self.plan.size),
                                              abs(place[0] - self.plan.points)))

    def near(self, scene, points, size=None):
        return [row for row in self.cut(scene, points=points) if size in (None, row["size"])]

    def scenes(self):
        """Charts of error over time, what to choose when, and peers that nothing beats."""
        found, choices = [], {}
        for scene in dict.fromkeys(row["scene"] for row in self.rows):
            points, size = self.at(scene)
            rows = self.near(scene, points, size)
            front = analysis.front(rows)
            title = f"{scene}: {points} points, {size} x {size} pixels"
            charts.error_over_time(self.path(f"{slug(scene)}-error-over-time"), title, rows, front,
                                   self.colours)
            self.say()
            self.say(f"## {title}")
            self.say()
            self.table(rows, {row["setting"] for row in front})
            choices[f"{scene}, {charts.spelled(points)} points"] = analysis.choices(rows)
            free, better = analysis.not_dominated(rows)
            for words, peers in (("that no setting of ours equals in both time and error", free),
                                 ("that equal or beat every setting of ours in both", better)):
                self.say()
                self.say(f"Peers {words}: {', '.join(row['setting'] for row in peers) or 'none'}.")
            found.append(dict(scene=scene, points=points, size=size,
                              front=[row["setting"] for row in front],
                              peers_not_dominated=[row["setting"] for row in free],
                              peers_better_than_all=[row["setting"] for row in better]))
        self.choose(choices)
        return found

    def table(self, rows, front):
        self.say("| setting | ms (quartiles) | cold ms | psnr | inside | ssim | depth, diagonals | "
                 "normal | silhouette | holes | layers | wrong layers | |")
        self.say("|---|---|---|---|---|---|---|---|---|---|---|---|---|")
        for row in sorted(analysis.measured(rows), key=lambda row: row["ms"]):
            cells = [row["setting"], f"{row['ms']:.0f} ({row['ms_q1']:.0f}-{row['ms_q3']:.0f})",
                     f"{row['cold_ms']:.0f}"]
            for key, form in (("psnr", ".1f"), ("psnr_inside", ".1f"), ("ssim", ".3f"),
                              ("depth", ".1e"), ("normal", ".2f"), ("silhouette", ".2f"),
                              ("holes", "d"), ("layers", "d"), ("layer_error", ".3f")):
                value = row.get(key)
                cells.append("" if value is None else format(value, form))
            cells.append("front" if row["setting"] in front else "")
            self.say("| " + " | ".join(cells) + " |")

    def choose(self, choices):
        """choices: of each scene."""
        def told(row):
            return (f"{row['setting']}: {row['ms']:.0f} ms, {row['psnr_inside']:.1f} dB" if row
                    else "none")

        self.say()
        self.say("## What to choose when")
        self.say()
        self.say("The fastest that is as near to the truth as this within the outline, without a hole:")
        self.say()
        self.say("| scene | psnr at least | ours | peer |")
        self.say("|---|---|---|---|")
        for scene, entries in choices.items():
            for entry in entries:
                level = f"{entry['level']:.0f} dB" if entry["level"] else "the most accurate"
                self.say(f"| {scene} | {level} | {told(entry['ours'])} | {told(entry['peer'])} |")

    def gaps(self):
        missing = dict.fromkeys((row["setting"], row["status"]) for row in self.rows
                                if row["status"].startswith("not"))
        skipped = [row for row in self.rows if row["status"].startswith("skipped")]
        if missing or skipped:
            self.say()
            self.say("## Not measured")
            self.say()
        for setting, status in missing:
            self.say(f"- {setting}: {status}")
        for row in skipped:
            self.say(f"- {row['scene']}, {row['points']} points, {row['size']} pixels, "
                     f"{row['setting']}: {row['status']}")


def slug(name):
    """For file names."""
    return re.sub(r"[^A-Za-z0-9.]+", "-", name).strip("-")
