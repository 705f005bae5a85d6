# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of any format that is read here as .vtp: `python -m pointsplatting.convert FILE FILE.vtp`.

For programs that read no scans, as `splatview` and ParaView.
"""
import argparse
import pathlib
import sys

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from .reading import read


def convert(source, target, box=None, spacing=None):
    """Read points, and write them with their arrays.

    Parameters
    ----------
    source : path
        What :func:`pointsplatting.read` reads points of.
    target : path
        A .vtp, whose coordinates are as exact as the source's.
    box, spacing : optional
        Those of :func:`pointsplatting.read`.

    Returns
    -------
    int
        The number of points.

    Raises
    ------
    ValueError
        Where the source has something else than points, or the target is no .vtp.
    OSError
        Where one cannot be read, or the other not be written.
    """
    if pathlib.Path(target).suffix.lower() != ".vtp":
        raise ValueError(f"{target} does not end with .vtp, which is what is written.")
    cloud = read(source, box, spacing)
    if not isinstance(cloud, vtkPolyData):
        raise ValueError(f"{source} holds a {cloud.GetClassName()}, and points are wanted.")
    # VTK's writer would complain on the standard error stream, and go on.
    with open(target, "wb"):
        pass
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(target))
    writer.SetInputData(cloud)
    if not writer.Write():
        raise OSError(f"{target} cannot be written.")
    return cloud.GetNumberOfPoints()


def main(arguments=None):
    """Run the program.

    Parameters
    ----------
    arguments : list of str, optional
        By default the program's.
    """
    parser = argparse.ArgumentParser(
        prog="python -m pointsplatting.convert",
        description="Points of scans, text and VTK's files, written as .vtp.")
    parser.add_argument("source", metavar="FILE", help="what is read, such as scan.laz")
    parser.add_argument("target", metavar="FILE.vtp", help="what is written")
    parser.add_argument("--box", type=float, nargs=6,
                        metavar=("XMIN", "XMAX", "YMIN", "YMAX", "ZMIN", "ZMAX"),
                        help="of scans and text, the points inside alone")
    parser.add_argument("--spacing", type=float, metavar="S",
                        help="of .copc.laz, points about so far apart alone")
    options = parser.parse_args(arguments)
    try:
        count = convert(options.source, options.target, options.box, options.spacing)
    except (OSError, ValueError, ImportError) as error:
        sys.exit(str(error))
    print(f"{options.target}: {count} points")


if __name__ == "__main__":
    main()
