# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The project's build backend: scikit-build-core's, with VTK's headers beside the wheel of vtk.

    pip install .                                        # with headers as Debian packages them
    pip install . -C sdk=vtk-sdk                         # with the package index's, if it has them
    pip install . -C cmake.define.VTK_DIR=FOLDER         # with an SDK that is there

1. `get_requires_for_build_wheel` asks for the wheel of vtk of the release that pyproject.toml names
   (it holds the libraries to link with), or for `vtk-sdk` of that release.
2. `build_wheel` makes the SDK (sdk.py), hands it to CMake as VTK_DIR, and lets scikit-build-core
   build, install and pack.

Packages that are unpacked for the SDK, and the SDK, are kept in build/wheel, or where
POINTSPLATTING_CACHE says.
"""
import importlib.util
import os
import pathlib
import shutil
import sys

import scikit_build_core.build as _core
from scikit_build_core.build import (  # noqa: F401
    build_sdist,
    get_requires_for_build_sdist,
)

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TOP = pathlib.Path(__file__).resolve().parents[2]
with open(TOP / "pyproject.toml", "rb") as _file:
    RELEASE = tomllib.load(_file)["tool"]["pointsplatting"]["vtk"]


def _take(settings):
    """Settings for scikit-build-core, and where the SDK comes from: debian, vtk-sdk or given."""
    settings = dict(settings or {})
    sdk = settings.pop("sdk", "debian")
    if sdk not in ("debian", "vtk-sdk"):
        raise ValueError(f"There is no SDK of the kind {sdk}: take debian or vtk-sdk.")
    return settings, "given" if "cmake.define.VTK_DIR" in settings else sdk


def get_requires_for_build_wheel(config_settings=None):
    """PEP 517's hook."""
    settings, sdk = _take(config_settings)
    vtk = {"debian": [f"vtk=={RELEASE}"], "vtk-sdk": [f"vtk-sdk=={RELEASE}"], "given": []}
    return [*_core.get_requires_for_build_wheel(settings), *vtk[sdk]]


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """PEP 517's hook."""
    return _core.prepare_metadata_for_build_wheel(metadata_directory, _take(config_settings)[0])


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517's hook."""
    settings, sdk = _take(config_settings)
    if not shutil.which(os.environ.get("CXX", "c++").split()[0]):
        raise RuntimeError("The wheel's build needs a C++ compiler (Debian: apt install g++).")
    if sdk != "debian":
        return _core.build_wheel(wheel_directory, settings, metadata_directory)
    if not shutil.which("apt-get"):
        raise RuntimeError("VTK's headers come from Debian's packages, by apt, which is not here. "
                           "Give an SDK: -C cmake.define.VTK_DIR=FOLDER or -C sdk=vtk-sdk.")
    from sdk import make # beside this file, which only a build frontend puts on the path

    modules = pathlib.Path(importlib.util.find_spec("vtkmodules").origin).parent
    cache = os.environ.get("POINTSPLATTING_CACHE") or TOP / "build" / "wheel"
    cache = pathlib.Path(cache).resolve()
    # A place that stays, so that a second build compiles only what has changed.
    settings["cmake.define.VTK_DIR"] = str(
        make(RELEASE, modules, cache, cache / f"sdk-{sys.implementation.cache_tag}"))
    return _core.build_wheel(wheel_directory, settings, metadata_directory)
