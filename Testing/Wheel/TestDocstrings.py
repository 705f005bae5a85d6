# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each public function of the package's Python has an example, and all examples run as they say."""
import doctest
import importlib
import inspect
import sys

import pointsplatting
import pyvista

MODULES = ("dataset_splats", "plotter_splats", "reading")

pyvista.OFF_SCREEN = True
failures = tried = 0


def lacks(name, function):
    """Print which sections a docstring lacks; their number."""
    missing = [section for section in ("Returns\n", "Examples\n")
               if section not in (function.__doc__ or "")]
    for section in missing:
        print(f"{name} says nothing of {section.strip()}")
    return len(missing)


for name, value in vars(pointsplatting).items():
    if inspect.isfunction(value):
        failures += lacks(name, value)
for name in MODULES:
    module = importlib.import_module(f"pointsplatting.{name}")
    for kind in (value for value in vars(module).values() if inspect.isclass(value)):
        if kind.__module__ != module.__name__:
            continue
        for method, value in vars(kind).items():
            value = getattr(value, "__func__", value)
            if not method.startswith("_") and callable(value):
                failures += lacks(f"{kind.__name__}.{method}", value)
    done = doctest.testmod(module)
    failures += done.failed
    tried += done.attempted
print(f"{tried} lines of examples, {failures} failures")
sys.exit(failures > 0 or tried < 20)
