# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPointSplatMapper as one of PyVista's mappers, and its settings as keywords."""
import functools
import re

import pyvista as pv

from . import vtkPointSplatMapper

# What PyVista's mappers of data sets have beside VTK's part, whatever it calls that class.
_PyVistaMapper = next(
    base for base in pv.DataSetMapper.__bases__ if base.__module__.startswith("pyvista"))

# Set methods of this class are settings, but for what is no quality of the picture.
_NO_SETTINGS = ("InputDataObject", "MaximumImageMemory")


class SplatMapper(_PyVistaMapper, vtkPointSplatMapper):
    """vtkPointSplatMapper with the attributes that PyVista's mappers have."""

    def __init__(self, theme=None):
        super().__init__(theme=theme)


def take_over(mapper, theme=None):
    """A mapper of splats with another mapper's input, lookup table and use of scalars.

    Parameters
    ----------
    mapper : pyvista.DataSetMapper
        What PyVista made for a mesh.
    theme : pyvista.plotting.themes.Theme, optional
        The plotter's.

    Returns
    -------
    SplatMapper
        The same for splats.
    """
    taken = SplatMapper(theme=theme)
    taken.SetInputConnection(mapper.GetInputConnection(0, 0))
    taken.lookup_table = mapper.lookup_table
    taken.SetScalarMode(mapper.GetScalarMode())
    taken.SetColorMode(mapper.GetColorMode())
    if mapper.GetArrayName():
        taken.SelectColorArray(mapper.GetArrayName())
    taken.SetArrayComponent(mapper.GetArrayComponent())
    taken.SetInterpolateScalarsBeforeMapping(mapper.GetInterpolateScalarsBeforeMapping())
    taken.SetScalarRange(mapper.GetScalarRange())
    taken.SetScalarVisibility(mapper.GetScalarVisibility())
    return taken


def _small(name):
    """RefractiveIndex -> refractive_index."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


@functools.lru_cache(maxsize=1)
def _methods():
    """{keyword: the setting's name}, and {keyword: {choice: name of its method}}."""
    # Methods of the class alone, and not of those that it derives from.
    own = [name for name in vars(vtkPointSplatMapper) if name.startswith("Set")]
    names = {name[3:] for name in own}
    plain, choices = {}, {}
    for name in sorted(names):
        setting, to, choice = name.partition("To")
        if to and choice[:1].isupper() and setting in names:
            choices.setdefault(_small(setting), {})[_small(choice)] = f"Set{name}"
        elif name not in _NO_SETTINGS and hasattr(vtkPointSplatMapper, f"Get{name}"):
            plain[_small(name)] = name
    return plain, choices


def settings():
    """{keyword: default}, or the names to choose from, the default first."""
    plain, choices = _methods()
    mapper = vtkPointSplatMapper()
    listed = {}
    for key, name in plain.items():
        default = getattr(mapper, f"Get{name}")()
        if key in choices:
            def value(choice, key=key, name=name):
                other = vtkPointSplatMapper()
                getattr(other, choices[key][choice])()
                return getattr(other, f"Get{name}")()

            listed[key] = tuple(sorted(choices[key], key=lambda one: (value(one) != default, one)))
        else:
            listed[key] = default
    return listed


def set_settings(mapper, wanted):
    """Set a mapper's settings by keyword.

    Parameters
    ----------
    mapper : vtkPointSplatMapper
        Whose settings are set.
    wanted : dict
        Values by the keywords of :func:`settings`.

    Raises
    ------
    ValueError
        For a name that may not be chosen, or a value that the mapper does not take.
    """
    plain, choices = _methods()
    for key, value in wanted.items():
        name = plain[key]
        if key in choices and isinstance(value, str):
            if value not in choices[key]:
                raise ValueError(
                    f"{key} is one of {', '.join(sorted(choices[key]))}, not {value!r}.")
            getattr(mapper, choices[key][value])()
            continue
        try:
            getattr(mapper, f"Set{name}")(value)
        except TypeError as error:
            raise ValueError(f"{key} cannot be {value!r}: {error}") from None
        # VTK clamps without a word; who asked for something else shall know.
        taken = getattr(mapper, f"Get{name}")()
        if not isinstance(taken, tuple) and taken != value:
            raise ValueError(f"{key} cannot be {value!r}: the nearest is {taken!r}.")
