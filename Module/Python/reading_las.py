# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of .las, .laz and .copc.laz, by the packages laspy and lazrs."""
import numpy as np

from .reading import bytes_of_colours, inside, make_cloud, need

# Names under which programs write normals, which LAS itself has no place for.
NORMALS = (("nx", "ny", "nz"), ("normalx", "normaly", "normalz"),
           ("normal_x", "normal_y", "normal_z"))
CHUNK = 1_000_000


def read(path, box, spacing):
    """See :func:`pointsplatting.read`."""
    laspy = need("laspy", "las", path)
    if path.suffix.lower() == ".laz":
        need("lazrs", "las", path)
    try:
        if path.name.lower().endswith(".copc.laz"):
            parts = [_query(laspy, path, box, spacing)]
        else:
            with laspy.open(str(path)) as file:
                parts = [_take(chunk, box) for chunk in file.chunk_iterator(CHUNK)]
                if not parts:
                    parts = [(np.empty((0, 3)), {})]
    except laspy.errors.LaspyException as error:
        raise OSError(f"{path} cannot be read: {error}") from error
    arrays = {name: np.concatenate([part[1][name] for part in parts]) for name in parts[0][1]}
    if "RGB" in arrays:
        arrays["RGB"] = bytes_of_colours(arrays["RGB"])
    return make_cloud(np.concatenate([part[0] for part in parts]), arrays)


def _query(laspy, path, box, spacing):
    """Of the file's octree what lies in the box, to the level that has the spacing."""
    with laspy.CopcReader.open(str(path)) as file:
        bounds = box and laspy.copc.Bounds(np.array(box[0::2]), np.array(box[1::2]))
        # laspy takes the level whose spacing is at most that.
        return _take(file.query(bounds=bounds, resolution=spacing), box)


def _take(record, box):
    """Coordinates and arrays of a piece, of those points alone that lie in the box."""
    # Integers times the scale, and the offset, in double: as exact as the file has them.
    points = np.column_stack([np.asarray(record[axis], dtype=float) for axis in "xyz"])
    keep = slice(None) if box is None else inside(points, box)
    own = list(record.point_format.extra_dimension_names)
    arrays = {}
    there = {name.lower(): name for name in own}
    for names in NORMALS:
        if all(name in there for name in names):
            columns = [there[name] for name in names]
            arrays["Normals"] = np.column_stack(
                [np.asarray(record[name], dtype="float32")[keep] for name in columns])
            own = [name for name in own if name not in columns]
    if "red" in record.point_format.dimension_names:
        arrays["RGB"] = np.column_stack(
            [np.asarray(record[name])[keep] for name in ("red", "green", "blue")])
    arrays["Intensity"] = np.asarray(record["intensity"])[keep]
    arrays["Classification"] = np.asarray(record["classification"])[keep]
    for name in own:
        arrays[name] = np.asarray(record[name])[keep]
    return points[keep], arrays
