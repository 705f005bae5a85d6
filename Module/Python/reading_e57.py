# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of .e57, by the package pye57: all scans in one coordinate system."""
import numpy as np

from .reading import bytes_of_colours, inside, make_cloud, need

# Fields of points, the types they are read as, and the arrays that are made of them.
CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
INVALID = ("cartesianInvalidState", "sphericalInvalidState")
COLOURS = ("colorRed", "colorGreen", "colorBlue")
NORMALS = ("nor:normalX", "nor:normalY", "nor:normalZ")
TYPES = {**dict.fromkeys(CARTESIAN + SPHERICAL, "d"), **dict.fromkeys(INVALID, "b"),
         **dict.fromkeys(COLOURS, "H"), **dict.fromkeys(NORMALS, "f"), "intensity": "f"}


def read(path, box, spacing):
    """See :func:`pointsplatting.read`."""
    pye57 = need("pye57", "e57", path)
    try:
        file = pye57.E57(str(path))
    except Exception as error: # the library's own class is not public
        raise OSError(f"{path} cannot be read: {error}") from error
    with file:
        scans = [_read_scan(pye57, file, i, box) for i in range(file.scan_count)]
    if not scans:
        raise OSError(f"{path} has no scan of points.")
    # What some scans have and others do not is left out.
    names = set.intersection(*(set(arrays) for _, arrays, _ in scans))
    arrays = {name: np.concatenate([scan[1][name] for scan in scans]) for name in sorted(names)}
    if "RGB" in arrays:
        arrays["RGB"] = bytes_of_colours(arrays["RGB"])
    arrays["ScanId"] = np.repeat(np.arange(len(scans), dtype="int32"),
                                 [len(scan[0]) for scan in scans])
    cloud = make_cloud(np.concatenate([scan[0] for scan in scans]), arrays)
    positions = make_cloud(np.array([scan[2] for scan in scans]), {}).GetPoints().GetData()
    positions.SetName("SensorPosition")
    cloud.GetFieldData().AddArray(positions)
    return cloud


def _read_scan(pye57, file, index, box):
    """Coordinates, arrays and the scanner's position, in the file's coordinates."""
    header = file.get_header(index)
    count = header.point_count
    data = {name: np.zeros(count, TYPES[name]) for name in header.point_fields if name in TYPES}
    buffers = pye57.libe57.VectorSourceDestBuffer()
    for name, values in data.items():
        buffers.append(pye57.libe57.SourceDestBuffer(
            file.image_file, name, values, count, True, True))
    header.points.reader(buffers).read()

    if all(name in data for name in CARTESIAN):
        points = np.column_stack([data[name] for name in CARTESIAN])
    else:
        distance, azimuth, elevation = (data[name] for name in SPHERICAL)
        points = distance[:, None] * np.column_stack(
            (np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth),
             np.sin(elevation)))
    position = np.full(3, np.nan) # which nobody knows
    normals = (np.column_stack([data[name] for name in NORMALS])
               if all(name in data for name in NORMALS) else None)
    if header.has_pose():
        position = np.asarray(header.translation, dtype=float)
        points = file.to_global(points, header.rotation, position)
        if normals is not None:
            normals = file.to_global(normals, header.rotation, np.zeros(3)).astype("f")

    keep = np.ones(count, bool)
    for name in INVALID:
        keep &= data.get(name, np.zeros(count)) == 0
    if box is not None:
        keep &= inside(points, box)
    arrays = {}
    if all(name in data for name in COLOURS):
        arrays["RGB"] = np.column_stack([data[name] for name in COLOURS])[keep]
    if "intensity" in data:
        arrays["Intensity"] = data["intensity"][keep]
    if normals is not None:
        arrays["Normals"] = normals[keep]
    return points[keep], arrays, position
