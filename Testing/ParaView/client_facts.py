# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For client.xml.in, in the Python shell of ParaView's window: what the client knows at each step."""
import json
import os

from paraview.simple import GetActiveSource, GetActiveView, GetDisplayProperties

facts = {"frames": 0}
where = {}


def begin(folder):
    where["folder"] = folder
    GetActiveView().GetRenderWindow().AddObserver("EndEvent", count)


def count(caller, event):
    facts["frames"] += 1


def note(step):
    source, view = GetActiveSource(), GetActiveView()
    shown = GetDisplayProperties(source, view)
    shown.UpdatePropertyInformation()
    selection = source.GetSelectionInput(source.Port)
    inputs = getattr(selection, "Input", None) or []
    facts[step] = {
        "frames": facts["frames"],
        "representation": str(shown.Representation).strip("'"),
        "opacity": shown.Opacity,
        "choices": shown.GetProperty("SplatChoices").GetElement(0),
        "picked": sum(len(list(ids.IDs)) // 2 for ids in inputs),
    }


def end():
    with open(os.path.join(where["folder"], "facts.json"), "w") as file:
        json.dump(facts, file)
