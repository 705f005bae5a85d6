# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud-optimised point cloud of three levels, for tests: laspy reads such files and writes none.

LAS 1.4 of point format 6 whose first record is `copc` 1 (info), whose points are a LAZ chunk of
its own for each voxel, and whose extended record `copc` 1000 lists them (COPC specification 1.0).
"""
import io
import struct

import laspy
import lazrs
import numpy as np

LEVELS = 3
HEADER = 375 # bytes of LAS 1.4's header
SPACING = 2.0 # of the root's points, as the file says


def _voxels(whole, side):
    """{(level, x, y, z): indices of points}: a tenth in the root, a third of the rest below."""
    rest = np.arange(len(whole))
    found = {}
    for level in range(LEVELS):
        last = level == LEVELS - 1
        taken = np.zeros(len(rest), bool)
        taken[::1 if last else 10 if level == 0 else 3] = True
        keys = whole[rest[taken]] * 2**level // side
        for key in np.unique(keys, axis=0):
            found[(level, *(int(k) for k in key))] = rest[taken][(keys == key).all(axis=1)]
        rest = rest[~taken]
    return found


def write_copc(path, whole, offset, scale):
    """Write points of format 6 to a file.

    Parameters
    ----------
    path : path
        The file.
    whole : numpy.ndarray of shape (n, 3)
        Coordinates as integers from 0 on.
    offset : numpy.ndarray of shape (3,)
        What is added after scaling.
    scale : float
        What an integer counts.

    Returns
    -------
    dict
        Of each voxel (level, x, y, z) its chunk's first byte, bytes, and points.
    """
    side = int(whole.max()) + 1
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.offsets, header.scales = offset, np.full(3, scale)
    las = laspy.LasData(header)
    las.X, las.Y, las.Z = whole.T
    las.intensity = np.arange(len(whole))
    las.update_header()

    vlr = lazrs.LazVlr.new_for_compression(6, 0, True)
    laz = bytes(vlr.record_data())
    info = 160
    start = HEADER + 54 + info + 54 + len(laz)
    records = las.points.array
    body = io.BytesIO()
    body.write(bytes(start))
    compressor = lazrs.LasZipCompressor(body, vlr)
    compressor.reserve_offset_to_chunk_table()
    chunks = {}
    for key, indices in _voxels(whole, side).items():
        begin = body.tell()
        compressor.compress_many(records[indices].tobytes())
        compressor.finish_current_chunk()
        chunks[key] = (begin, body.tell() - begin, len(indices))
    compressor.done()
    body.seek(0, io.SEEK_END)
    extended = body.tell()
    entries = b"".join(struct.pack("<iiiiQii", *key, *chunk) for key, chunk in chunks.items())
    body.write(struct.pack("<H16sHQ32s", 0, b"copc", 1000, len(entries), b"") + entries)

    centre = offset + side * scale / 2
    parts = io.BytesIO()
    las.header.write_to(parts)
    fixed = bytearray(parts.getvalue()[:HEADER])
    struct.pack_into("<I", fixed, 96, start)          # where the points begin
    struct.pack_into("<I", fixed, 100, 2)             # records before them
    fixed[104] = 6 | 0x80                             # the point format, compressed
    struct.pack_into("<QI", fixed, 235, extended, 1)  # extended records
    struct.pack_into("<Q", fixed, 247, len(whole))
    content = bytearray(body.getvalue())
    content[:start] = (
        bytes(fixed)
        + struct.pack("<H16sHH32s", 0, b"copc", 1, info, b"")
        + struct.pack("<5dQQ2d11Q", *centre, side * scale / 2, SPACING, extended + 60, len(entries),
                      0, 0, *[0] * 11)
        + struct.pack("<H16sHH32s", 0, b"laszip encoded", 22204, len(laz), b"") + laz)
    path.write_bytes(content)
    return chunks
