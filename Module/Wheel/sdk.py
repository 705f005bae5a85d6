# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's headers, CMake files and wrapping tools for a wheel of `vtk` that has none of them.

Wheels of `vtk` hold libraries only. Kitware's `vtk-sdk` wheels hold the rest, but the package index
has them for few systems. Debian packages the same releases: the headers of one release are the
same text whoever packages it, and what a build's options change in them is set here to what the
wheel was built with.

1. The suite of Debian whose VTK has the wanted version is found (Module/Versions/suites.py), and
   its packages are unpacked, without what they depend on: headers, CMake files, the wrapping tools
   and the C library that these need.
2. CMake's imported targets are pointed to the libraries inside `vtkmodules`.
3. What options change is read off the libraries: threading back ends (vtkSMP.h, where another
   choice changes vtkSMPToolsAPI's layout) and the C++ library's ABI of strings.
4. A vtk-config.cmake is written that needs nothing of what Debian's VTK depends on.
5. The virtual tables of Debian's libraries and of the wheel's are compared: where an option, or a
   patch, had changed a class's methods, the build ends here and not in a crash.
"""
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "Versions"))
import suites  # noqa: E402

HERE = pathlib.Path(__file__).parent
# Modules whose classes ours derive from, or call.
COMPARED = ("CommonCore", "CommonDataModel", "CommonExecutionModel", "RenderingCore",
            "RenderingOpenGL2")
KEPT_TARGETS = r"\b(VTK|Threads|Python3)::"
TOOLS = ("WrapHierarchy", "WrapPython", "WrapPythonInit")
PACKAGES = ("libvtk9-dev", "vtk9", "libc6", "libstdc++6", "libgcc-s1")
# Headers that VTK's and ours need; what they belong to is loaded when a program runs.
OTHER_PACKAGES = ("libglm-dev", "libgl-dev", "libegl-dev", "libx11-dev", "x11proto-dev",
                  "libkhronos-api-dev")


def unpack(version, folder):
    """Have the suite's packages unpacked in a folder; done once.

    Returns
    -------
    pathlib.Path
        What stands for /usr there.
    """
    folder = pathlib.Path(folder).resolve()
    done = folder / f"vtk-{version}.unpacked"
    root = folder / f"vtk-{version}"
    if not done.exists():
        suite = suites.find(folder / "suites", version)
        print(f"VTK {version}: headers and tools of Debian {suite.name}", flush=True)
        shutil.rmtree(root, ignore_errors=True)
        suite.unpack(PACKAGES, root)
        suite.unpack(["python3-vtk9"], root, "./usr/bin/vtkWrap*")
        suite.unpack([f"libvtk{version.rpartition('.')[0]}"], root,
                     "*/libvtkWrappingTools*", "*/hierarchy/*",
                     *(f"*/libvtk{name}-*" for name in COMPARED))
        headers = [name for name in OTHER_PACKAGES if suite.version(name)]
        suite.unpack(headers, root)
        done.touch()
    return root / "usr"


def _only(paths, what):
    found = sorted(paths)
    if not found:
        raise FileNotFoundError(f"{what} is missing")
    return found[0]


def _rewrite(file, text):
    """Another text under the same time, so that what was built of the same text stays built."""
    times = file.stat()
    file.write_text(text)
    os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))


def _libraries(modules):
    """The wheel's libraries by the names of VTK's modules: {"CommonCore": path}."""
    return {_module(path.name): path for path in sorted(modules.glob("libvtk*.so*"))}


def _module(file):
    """libvtkWrappingPythonCore3.11-9.6.so.1 -> WrappingPythonCore"""
    return re.match(r"libvtk(\w+?)(\d+\.\d+)?(-[0-9.]+)?\.so", file).group(1)


def _point_targets(cmake, libraries):
    """Locations of imported libraries; those that the wheel lacks are never linked."""
    file = cmake / "VTK-targets-none.cmake"
    text = file.read_text()
    # CMake would ask for each file, also of modules that are not in the wheel.
    text = re.sub(r"list\(APPEND _cmake_import_check_\w+(::\w+)? .*\)\n", "", text)

    def place(match):
        path = libraries.get(_module(match.group(1)))
        return f'"{path}"\n  IMPORTED_SONAME_NONE "{path.name}"' if path else match.group(0)

    text = re.sub(r'"\$\{_IMPORT_PREFIX\}/lib/[^"]*/(libvtk[^/"]*)"\n'
                  r'  IMPORTED_SONAME_NONE "[^"]*"', place, text)
    _rewrite(file, text)
    file = cmake / "VTK-targets.cmake"
    text = file.read_text()
    # What Debian's VTK was linked with, other than itself, is inside the wheel's libraries.
    def keep(match):
        kept = [one for one in match.group(2).split(";") if re.search(KEPT_TARGETS, one)]
        return f'{match.group(1)}"{";".join(kept)}"'

    text = re.sub(r'(INTERFACE_LINK_LIBRARIES )"([^"]*)"', keep, text)
    _rewrite(file, text)


def _set_options(include, core):
    """vtkSMP.h as the wheel's own library says; the ABI of strings is returned, 0 or 1."""
    held = core.read_bytes()
    file = include / "vtkSMP.h"
    text = file.read_text()
    for backend, sign in (("TBB", b"libtbb"), ("OPENMP", b"libgomp")):
        text = re.sub(rf"(VTK_SMP_ENABLE_{backend}) \d", rf"\1 {int(sign in held)}", text)
    text = re.sub(r"(VTK_SMP_DEFAULT_IMPLEMENTATION_\w+) \d", r"\1 0", text)
    text = text.replace("VTK_SMP_DEFAULT_IMPLEMENTATION_STDTHREAD 0",
                        "VTK_SMP_DEFAULT_IMPLEMENTATION_STDTHREAD 1")
    text = re.sub(r"#define VTK_SMP_(TBB|OpenMP|Sequential)\n", "#define VTK_SMP_STDThread\n", text)
    text = re.sub(r'(VTK_SMP_BACKEND) "\w+"', r'\1 "STDThread"', text)
    _rewrite(file, text)
    return int(b"__cxx11" in held)


def _wrap_tools(usr):
    """The tools are of a newer system than this one may be: run them by its own C library."""
    loader = _only(usr.rglob("ld-linux*.so.*"), "the C library's loader")
    libraries = _only(usr.rglob("libvtkWrappingTools*.so.*"), "libvtkWrappingTools").parent
    for tool in TOOLS:
        for path in (usr / "bin").glob(f"vtk{tool}-*"):
            program = path.with_name(path.name + ".program")
            path.rename(program)
            path.write_text(f'#!/bin/sh\nexec "{loader}" --library-path "{libraries}" '
                            f'"{program}" "$@"\n')
            path.chmod(path.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)


def _virtual_tables(library):
    """{class: size of its virtual table}, as the library exports them."""
    listed = subprocess.run(["nm", "--dynamic", "--print-size", "--defined-only", library],
                            text=True, capture_output=True, check=True).stdout
    return {name: int(size, 16) for size, name in
            re.findall(r"^[0-9a-f]+ ([0-9a-f]+) [VD] _ZTV\d+(vtk\w+)$", listed, re.MULTILINE)}


def _compare_tables(usr, libraries):
    """Raise an error where a class of the wheel has another number of virtual methods."""
    different = set()
    for name in COMPARED:
        packaged = _virtual_tables(_only(usr.rglob(f"libvtk{name}-*.so.*"), f"libvtk{name}"))
        of_wheel = _virtual_tables(libraries[name])
        both = packaged.keys() & of_wheel.keys()
        if not both:
            raise RuntimeError(f"No virtual tables were found in {libraries[name]}.")
        different |= {one for one in both if packaged[one] != of_wheel[one]}
    if different:
        raise RuntimeError("The headers are not those of the wheel of vtk. These classes have "
                           f"other virtual methods: {', '.join(sorted(different))}.")


def make(version, modules, cache, folder):
    """Make the SDK of a release for the wheel that is installed.

    Parameters
    ----------
    version : str
        The release, such as "9.6.2".
    modules : path
        The folder `vtkmodules` of the installed wheel.
    cache : path
        Where packages are kept from one build to the next.
    folder : path
        Where the SDK is made anew.

    Returns
    -------
    pathlib.Path
        The folder with vtk-config.cmake, for VTK_DIR.
    """
    unpacked = unpack(version, cache)
    usr = pathlib.Path(folder).resolve() / "usr"
    shutil.rmtree(usr.parent, ignore_errors=True)
    shutil.copytree(unpacked, usr, symlinks=True, ignore=shutil.ignore_patterns(
        "share", "gconv", *(f"libvtk{name}-*" for name in COMPARED)))
    cmake = _only(usr.rglob("VTK-targets.cmake"), "VTK's CMake package").parent
    include = _only(usr.glob("include/vtk-*"), "VTK's headers")
    libraries = _libraries(pathlib.Path(modules))
    _compare_tables(unpacked, libraries)
    _point_targets(cmake, libraries)
    string_abi = _set_options(include, libraries["CommonCore"])
    _wrap_tools(usr)
    config = (HERE / "vtk-config.cmake.in").read_text()
    for name, value in (("VERSION", version), ("STRING_ABI", str(string_abi))):
        config = config.replace(f"@{name}@", value)
    (cmake / "vtk-config.cmake").write_text(config)
    return cmake
