# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same scene on 1, 2 and 4 processes, with even and uneven shares of the points: the same
pictures, and the same points picked; with one process that has no points and one that has a single
one; and by a server of 2, drawn there and drawn by the client. Argument: the script that runs
ParaView's programs."""
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

HERE = os.path.dirname(os.path.abspath(__file__))
LEAST = {"opaque": 45, "estimated": 45, "translucent": 38}  # dB against one process


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


def run(options, shares, *more):
    """A scene's pictures and facts, by a program as the options say."""
    folder = tempfile.mkdtemp(prefix="splats-ranks-")
    scene = os.path.join(HERE, "ranks_scene.py")
    done = subprocess.run(
        ["bash", sys.argv[1], *options, scene, folder, shares, *more],
        capture_output=True, text=True, timeout=200,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "ERR|" not in said and "WARN|" not in said, said
    with open(os.path.join(folder, "facts.json")) as file:
        facts = json.load(file)
    return {name: read(os.path.join(folder, name + ".png")) for name in LEAST}, facts


def run_by_server(ranks, shares, threshold):
    """The same by a client, of a server that draws what is larger than so many MB."""
    with socket.socket() as free:
        free.bind(("", 0))
        port = str(free.getsockname()[1])
    server = subprocess.Popen(
        ["bash", sys.argv[1], "--ranks", str(ranks), "--with", "pvserver", "--server-port=" + port],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
    )  # fmt: skip
    try:
        for line in server.stdout:
            if "Accepting connection" in line:
                break
        result = run(["--with", "pvpython"], shares, port, str(threshold))
        server.wait(30)  # it ends with its client
        return result
    finally:
        if server.poll() is None:
            os.killpg(server.pid, signal.SIGTERM)


def compare(name, shares, pictures, other):
    """Whether pictures and picked points are those of one process."""
    print(f"{name}: {other['seconds']:.3f} s a frame, one process {facts['seconds']:.3f} s")
    for scene, least in LEAST.items():
        error = np.mean((pictures[scene] - one[scene]) ** 2)
        value = 10 * np.log10(255**2 / max(error, 1e-9))
        print(f"{name}, {shares}, {scene}: {value:.1f} dB, at least {least}")
        assert value >= least
    missed = set(facts["ids"]) ^ set(other["ids"])
    print(f"{len(other['ids'])} points picked, {len(missed)} others than by one process")
    assert len(other["ids"]) == len(set(other["ids"])), "a point is picked twice"
    assert not missed, f"other points are picked: {sorted(missed)[:20]}"
    # With the outline, where a pixel at a border may see another point: of 7134 points one.
    missed = set(facts["whole"]) ^ set(other["whole"])
    print(f"{len(other['whole'])} points of the whole sphere, {len(missed)} others")
    assert len(missed) <= 0.001 * len(facts["whole"]), "other points are picked at the outline"
    told = other["choices"]
    print(told.splitlines()[0])
    assert "method: none" not in told and "method: " in told, told


one, facts = run([], "EVEN")
assert len(facts["ids"]) > 500
compare("2 processes", "EVEN", *run(["--ranks", "2"], "EVEN"))
compare("4 processes", "UNEVEN", *run(["--ranks", "4"], "UNEVEN"))
pictures, single = run(["--ranks", "3"], "SINGLE")
compare("3 processes", "SINGLE", pictures, single)
assert single["choices"].startswith("process: 2 of 3"), "the process without points tells"
pictures, remote = run_by_server(2, "EVEN", 0)
compare("a server of 2", "EVEN", pictures, remote)
pictures, local = run_by_server(2, "EVEN", 1000)
compare("a client of a server of 2", "EVEN", pictures, local)
assert remote["remote"] and not local["remote"], "the threshold does not say who draws"
