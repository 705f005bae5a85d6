# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""`pointsplatting.read()`: points and volumes of files, as VTK's data objects.

What reads a format is imported when a file of that format is first read.
"""
import importlib
import pathlib

# By the end of a file's name: the module of VTK and the reader's class.
_VTK_READERS = {
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
    ".vts": ("vtkIOXML", "vtkXMLStructuredGridReader"),
    ".vtr": ("vtkIOXML", "vtkXMLRectilinearGridReader"),
    ".vti": ("vtkIOXML", "vtkXMLImageDataReader"),
    ".vtm": ("vtkIOXML", "vtkXMLMultiBlockDataReader"),
    ".vtk": ("vtkIOLegacy", "vtkGenericDataObjectReader"),
    ".ply": ("vtkIOPLY", "vtkPLYReader"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader"),
    ".stl": ("vtkIOGeometry", "vtkSTLReader"),
    ".pts": ("vtkIOGeometry", "vtkPTSReader"),
    ".mhd": ("vtkIOImage", "vtkMetaImageReader"),
    ".mha": ("vtkIOImage", "vtkMetaImageReader"),
    ".nrrd": ("vtkIOImage", "vtkNrrdReader"),
    ".nhdr": ("vtkIOImage", "vtkNrrdReader"),
}
# Read by this package's own modules, which have a function read(path, box, spacing).
_OWN_READERS = {
    ".las": "reading_las",
    ".laz": "reading_las",
    ".e57": "reading_e57",
    ".h5": "reading_octree",
    ".xyz": "reading_text",
    ".txt": "reading_text",
    ".csv": "reading_text",
    ".asc": "reading_text",
}


def formats():
    """List the formats that :func:`read` knows.

    Returns
    -------
    list of str
        The ends of files' names.

    Examples
    --------
    >>> import pointsplatting
    >>> ".laz" in pointsplatting.formats()
    True
    """
    return sorted({*_VTK_READERS, *_OWN_READERS, ".copc.laz"})


def read(path, box=None, spacing=None):
    """Read points or a volume from a file.

    Parameters
    ----------
    path : str or path-like
        The file. What its name ends with tells the format: what VTK reads (``.vtp .vtu .vts .vtr
        .vti .vtm .vtk .ply .obj .stl .pts .mhd .mha .nrrd .nhdr``), text (``.xyz .txt .csv
        .asc``), ``.h5`` of vtkPointSplatOctreeWriter, and scans: ``.las .laz .copc.laz`` by the
        package laspy with lazrs (``pip install pointsplatting[las]``), ``.e57`` by pye57 (``pip
        install pointsplatting[e57]``).
    box : sequence of 6 float, optional
        Of scans, the points inside alone: xmin, xmax, ymin, ymax, zmin, zmax, in the file's
        coordinates. Of a ``.copc.laz`` nothing else is read. Of an ``.h5`` whole blocks of points
        are read, which reach into it.
    spacing : float, optional
        Of a ``.copc.laz``, points about so far apart alone (the file's unit): its octree is read
        to that level, and no further.

    Returns
    -------
    vtkmodules.vtkCommonDataModel.vtkDataObject
        Scans and text are a vtkPolyData whose coordinates are doubles, as exact as the file
        has them, with the arrays that the file has of `RGB` (n, 3), 0 to 255, `Intensity` (n,),
        `Classification` (n,) and `Normals` (n, 3), besides those of names of the file's own. An
        .e57 of several scans has `ScanId` (n,) and a field array `SensorPosition` (scans, 3),
        by which normals are oriented.

    Raises
    ------
    ValueError
        For a format that is not known, naming those that are, and for a box or a spacing of a
        format that has no such choice.
    ImportError
        Where the package is missing that reads the format, saying how to install it.
    OSError
        For a file that is not there, or cannot be read as what it says it is.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import pointsplatting
    >>> folder = tempfile.TemporaryDirectory()
    >>> file = pathlib.Path(folder.name, "points.xyz")
    >>> _ = file.write_text("500000.25 0 0\\n500000.5 1 0\\n")
    >>> cloud = pointsplatting.read(file)
    >>> cloud.GetPoint(0)
    (500000.25, 0.0, 0.0)
    """
    path = pathlib.Path(path)
    end = path.suffix.lower()
    if end not in _VTK_READERS and end not in _OWN_READERS:
        raise ValueError(f"{path} ends with {end!r}, which is none of: {' '.join(formats())}.")
    if not path.is_file():
        raise FileNotFoundError(f"There is no file {path}.")
    if box is not None:
        box = [float(bound) for bound in box]
        if len(box) != 6 or any(box[i] > box[i + 1] for i in (0, 2, 4)):
            raise ValueError(f"A box is xmin, xmax, ymin, ymax, zmin, zmax, not {box}.")
    if spacing is not None and not spacing > 0:
        raise ValueError(f"A spacing is greater than 0, not {spacing}.")
    if spacing is not None and not path.name.lower().endswith(".copc.laz"):
        raise ValueError(f"A spacing is for .copc.laz, whose points are sorted by it, not {path}.")
    if end in _OWN_READERS:
        return importlib.import_module(f".{_OWN_READERS[end]}", __package__).read(
            path, box, spacing)
    if box is not None:
        raise ValueError(f"A box is for scans ({' '.join(sorted(_OWN_READERS))}), not {path}.")
    return _read_by_vtk(path, *_VTK_READERS[end])


def _read_by_vtk(path, module, name):
    """What VTK's reader makes of a file."""
    return run_reader(getattr(importlib.import_module(f"vtkmodules.{module}"), name)(), path)


def run_reader(reader, path):
    """What a reader of VTK's kind makes of a file; its complaints become an error.

    Parameters
    ----------
    reader : vtkmodules.vtkCommonExecutionModel.vtkAlgorithm
        Which has a file name.
    path : pathlib.Path
        The file.

    Returns
    -------
    vtkmodules.vtkCommonDataModel.vtkDataObject
        The reader's first output.

    Raises
    ------
    OSError
        Where the reader complains, or makes nothing.
    """
    complaints = []

    def complain(caller, event, text="an error"):
        complaints.append(text.strip())

    complain.CallDataType = "string0"
    reader.AddObserver("ErrorEvent", complain)
    if hasattr(reader, "GetExecutive"):
        reader.GetExecutive().AddObserver("ErrorEvent", complain)
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutputDataObject(0)
    if complaints or data is None:
        said = complaints[0].splitlines()[-1] if complaints else "nothing is in it"
        raise OSError(f"{path} cannot be read: {said}")
    return data


def make_cloud(points, arrays):
    """A vtkPolyData of points alone.

    Parameters
    ----------
    points : numpy.ndarray of shape (n, 3)
        Coordinates, kept in their type.
    arrays : dict
        Point arrays of shape (n,) or (n, k) by their names. `Normals` become the normals, and
        `RGB` the scalars.

    Returns
    -------
    vtkmodules.vtkCommonDataModel.vtkPolyData
        The cloud.
    """
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    cloud = vtkPolyData()
    held = vtkPoints()
    held.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cloud.SetPoints(held)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    if "Normals" in arrays:
        cloud.GetPointData().SetActiveNormals("Normals")
    if "RGB" in arrays:
        cloud.GetPointData().SetActiveScalars("RGB")
    return cloud


def need(package, extra, path):
    """A package that reads a format.

    Parameters
    ----------
    package : str
        Its name.
    extra : str
        This package's extra that brings it.
    path : path
        The file to be read.

    Returns
    -------
    module
        The package.

    Raises
    ------
    ImportError
        Which says how to install it.
    """
    try:
        return importlib.import_module(package)
    except ImportError as error:
        raise ImportError(
            f"To read {path} the package {package} is needed, which is not here: "
            f"pip install 'pointsplatting[{extra}]'.") from error


def bytes_of_colours(colours):
    """Colours of 8 or 16 bits as bytes.

    Parameters
    ----------
    colours : numpy.ndarray of shape (n, 3)
        Integers; where any is past 255, all have 16 bits.

    Returns
    -------
    numpy.ndarray of shape (n, 3)
        0 to 255.
    """
    if len(colours) and colours.max() > 255:
        colours = colours // 257 # 65535 becomes 255
    return colours.astype("uint8")


def inside(points, box):
    """Which points lie in a box.

    Parameters
    ----------
    points : numpy.ndarray of shape (n, 3)
        Coordinates.
    box : sequence of 6 float
        Bounds, as VTK orders them.

    Returns
    -------
    numpy.ndarray of shape (n,)
        True where a point is in the box or on its border.
    """
    return ((points >= box[0::2]) & (points <= box[1::2])).all(axis=1)
