# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long frames take on 1, 2 and 4 processes, by ParaView's timer log: drawing, compositing, the
exchange of points when they are new; as a table in Markdown.

python3 Testing/ParaView/frame_times.py [millions of points], after a run of Module/ParaView/test.sh.
It runs itself by pvbatch, with "measure" as its first argument.
"""
import collections
import json
import os
import re
import subprocess
import sys
import tempfile

FRAMES = 5
SIZE = [800, 600]
SCENES = ("opaque", "translucent")
SHOWN = {"Surface": "mesh, Surface", "Point Splats": "points, Point Splats"}


def logs():
    """ParaView's timer log of each process, as lists of names and seconds."""
    from paraview import servermanager

    session = servermanager.ActiveConnection.Session
    information = servermanager.vtkPVTimerInformation()
    session.GatherInformation(session.RENDER_SERVER, information, 0)
    line = re.compile(r"^\s*(.+?),\s*([0-9.eE+-]+) seconds")
    return [
        [(m[1], float(m[2])) for m in map(line.match, information.GetLog(i).splitlines()) if m]
        for i in range(information.GetNumberOfLogs())
    ]


def clear():
    from paraview import servermanager

    proxy = servermanager.ProxyManager().NewProxy("misc", "TimerLog")
    proxy.UpdateVTKObjects()
    proxy.InvokeCommand("ResetLog")


def measure(millions, file):
    import time

    import numpy as np
    from paraview.simple import Delete, Render, Sphere

    import splat_scenes as scenes

    view = scenes.new_view()
    view.ViewSize = SIZE
    view.RemoteRenderThreshold = 0
    count = int(1e6 * millions)
    results = []
    for scene in SCENES:
        for representation in SHOWN:
            if representation == "Surface":
                side = int((count / 2) ** 0.5)
                source = Sphere(Radius=1, ThetaResolution=2 * side, PhiResolution=side)
            else:
                source = scenes.cloud(count=count)
            shown = scenes.show(source, view, representation)
            shown.Opacity = 1 if scene == "opaque" else 0.5
            source.UpdatePipeline()
            start = time.time()
            Render(view)
            first = time.time() - start
            Render(view)
            rows = collections.defaultdict(list)
            for frame in range(FRAMES):
                clear()
                view.GetActiveCamera().Azimuth(3)
                start = time.time()
                Render(view)
                rows["frame"].append(time.time() - start)
                timed = []
                for log in logs():
                    timed.append(collections.Counter())
                    for name, seconds in log:
                        timed[-1][name] += seconds
                rows["drawn"].append(np.max([sums["ICET_RENDER_TIME"] for sums in timed]))
                # Of the one that waits least for others; it has the time of collecting in it.
                rows["composited"].append(np.min([sums["ICET_COMPOSITE_TIME"] for sums in timed]))
            fastest = int(np.argmin(rows["frame"]))
            row = {name: float(values[fastest]) for name, values in rows.items()}
            results.append({"scene": scene, "shown": representation, "first": first, **row})
            Delete(source)
    with open(file, "w") as out:
        json.dump(results, out)


if __name__ == "__main__" and sys.argv[1:2] == ["measure"]:
    measure(float(sys.argv[2]), sys.argv[3])
elif __name__ == "__main__":
    millions = sys.argv[1] if len(sys.argv) > 1 else "0.1"
    batch = os.path.join(os.path.dirname(__file__), "..", "..", "Module", "ParaView", "batch.sh")
    tables = {}
    for ranks in (1, 2, 4):
        file = os.path.join(tempfile.mkdtemp(prefix="splats-times-"), "times.json")
        subprocess.run(
            ["bash", batch, "--ranks", str(ranks), __file__, "measure", millions, file], check=True
        )
        with open(file) as results:
            tables[ranks] = json.load(results)
    print(f"{millions} million points, {SIZE[0]} x {SIZE[1]}, {os.cpu_count()} cores,")
    print(f"the fastest of {FRAMES} frames, ms\n")
    print("| scene | shown as | processes | first | frame | drawing | compositing | the rest |")
    print("|---|---|---|---|---|---|---|---|")
    for at in range(len(tables[1])):
        for ranks, rows in tables.items():
            row = {name: v if isinstance(v, str) else 1000 * v for name, v in rows[at].items()}
            if ranks == 1:
                row["drawn"], row["composited"] = row["frame"], 0
            rest = row["frame"] - row["drawn"] - row["composited"]
            print(
                f"| {row['scene']} | {SHOWN[row['shown']]} | {ranks} | {row['first']:.0f} "
                f"| {row['frame']:.0f} | {row['drawn']:.0f} | {row['composited']:.0f} | {rest:.0f} |"
            )
