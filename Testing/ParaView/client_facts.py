# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For client.xml.in, in the Python shell of ParaView's window: what the client knows at each step."""
import json
import os

from paraview import smtrace
from paraview.simple import (
    ClearSelection, GetActiveSource, GetActiveView, GetDisplayProperties, SaveScreenshot,
)  # fmt: skip

facts = {"frames": 0}
where = {}


def file(name):
    return os.path.join(where["folder"], name)


def begin(folder):
    where["folder"] = folder
    GetActiveView().GetRenderWindow().AddObserver("EndEvent", count)
    smtrace.start_trace()


def count(caller, event):
    facts["frames"] += 1


def note(step):
    source, view = GetActiveSource(), GetActiveView()
    shown = GetDisplayProperties(source, view)
    property = shown.GetProperty("SplatChoices")
    known = property.GetElement(0)
    shown.UpdatePropertyInformation()
    selection = source.GetSelectionInput(source.Port)
    inputs = getattr(selection, "Input", None) or []
    facts[step] = {
        "frames": facts["frames"],
        "representation": str(shown.Representation).strip("'"),
        "opacity": shown.Opacity,
        "known": known,
        "choices": property.GetElement(0),
        "picked": sum(len(list(ids.IDs)) // 2 for ids in inputs),
    }


def end_trace():
    with open(file("trace.py"), "w") as out:
        out.write(smtrace.stop_trace())
    ClearSelection()
    view = GetActiveView()
    view.OrientationAxesVisibility = 0  # their size is that of the window
    SaveScreenshot(file("traced.png"), view, ImageResolution=[400, 300])


def end():
    with open(file("facts.json"), "w") as out:
        json.dump(facts, out)
