# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each public function of the package's Python has an example, and all examples run as they say."""
import doctest
import importlib
import inspect
import sys

import pyvista

MODULES = ("dataset_splats", "plotter_splats", "reading")

pyvista.OFF_SCREEN = True
failures = tried = 0
for name in MODULES:
    module = importlib.import_module(f"pointsplatting.{name}")
    for kind in (value for value in vars(module).values() if inspect.isclass(value)):
        if kind.__module__ != module.__name__:
            continue
        for method, value in vars(kind).items():
            value = getattr(value, "__func__", value)
            if not method.startswith("_") and callable(value):
                for section in ("Returns\n", "Examples\n"):
                    if section not in (value.__doc__ or ""):
                        print(f"{kind.__name__}.{method} says nothing of {section.strip()}")
                        failures += 1
    done = doctest.testmod(module)
    failures += done.failed
    tried += done.attempted
print(f"{tried} lines of examples, {failures} failures")
sys.exit(failures > 0 or tried < 20)
