# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx: the guides of this folder, and the Python API from docstrings of the installed package.

    pip install '.[pyvista,app]' sphinx myst-parser
    sphinx-build -W Documentation build/documentation
"""
import inspect

import pointsplatting

project = "PointSplatting"
copyright = "the PointSplatting authors"  # noqa: A001
version = release = pointsplatting.__version__

extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "myst_parser"]
html_theme = "alabaster"
html_theme_options = {"description": "Oriented point clouds drawn as smooth surfaces"}
myst_heading_anchors = 3
napoleon_google_docstring = False
napoleon_use_rtype = False
autodoc_member_order = "bysource"

_CLASSES = sorted(
    name for name, value in vars(pointsplatting).items()
    if name.startswith("vtk") and isinstance(value, type))
# What each class has, and what says nothing of it.
_EVERYWHERE = ("GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType", "IsA",
               "IsTypeOf", "NewInstance", "SafeDownCast")


def _as_said(text, indent):
    """A wrapped class's text is a C++ header's: shown as it is, and not parsed as markup."""
    lines = inspect.cleandoc(text or "").splitlines()
    return ["", f"{indent}.. code-block:: text", "",
            *(f"{indent}   {line}".rstrip() for line in lines), ""] if lines else [""]


def _list_classes(app, name, source):
    """All classes that VTK wraps and their own methods, since nobody is to keep a list.

    autodoc takes methods of VTK's descriptors for attributes.
    """
    if name != "classes":
        return
    page = []
    for one in _CLASSES:
        kind = getattr(pointsplatting, one)
        page += [one, "-" * len(one), "", f".. py:class:: pointsplatting.{one}"]
        page += _as_said(kind.__doc__, "   ")
        for method, value in sorted(vars(kind).items()):
            if callable(value) and not method.startswith("_") and method not in _EVERYWHERE:
                page += [f"   .. py:method:: {method}"] + _as_said(value.__doc__, "      ")
    source[0] += "\n".join(page)


def setup(app):
    """Sphinx calls this."""
    app.connect("source-read", _list_classes)
