# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the rows say: how cost grows, which settings no other one beats, and what to choose when."""
import numpy as np

LEVELS = (30.0, 35.0, 40.0)  # dB, within the outline


def growth(x, ms):
    """How cost grows with x (points, pixels, layers, samples).

    exponent: of ms = a x^e, least squares of the logarithms, over all; exponent_upper: between the
    two largest x, where fixed cost tells least; fixed_ms and each_ms: of ms = fixed + each * x, least
    squares of relative errors; off_line: the largest relative distance from that line.
    """
    order = np.argsort(x)
    x, ms = np.asarray(x, float)[order], np.asarray(ms, float)[order]
    if len(x) < 2:
        return None
    exponent = np.polyfit(np.log(x), np.log(ms), 1)[0]
    upper = np.log(ms[-1] / ms[-2]) / np.log(x[-1] / x[-2])
    each, fixed = np.polyfit(x, ms, 1, w=1 / ms)
    off = np.abs((fixed + each * x - ms) / ms).max()
    return dict(exponent=float(exponent), exponent_upper=float(upper), fixed_ms=float(fixed),
                each_ms=float(each), off_line=float(off), values=len(x))


def measured(rows):
    return [row for row in rows if row["status"] == "measured"]


def series(rows, column, name="setting"):
    """For each setting, or family, its rows, ordered by a column with two values at least."""
    found = {}
    for row in measured(rows):
        if row.get(column) is not None:
            found.setdefault(row[name], []).append(row)
    return {setting: sorted(own, key=lambda row: row[column]) for setting, own in found.items()
            if len({row[column] for row in own}) > 1}


def front(rows, cost="ms", error="rms_inside"):
    """Rows that no other one beats in one of both and equals in the other, by cost."""
    best, kept = np.inf, []
    for row in sorted((row for row in measured(rows) if row.get(error) is not None),
                      key=lambda row: (row[cost], row[error])):
        if row[error] < best:
            best = row[error]
            kept.append(row)
    return kept


def not_dominated(rows, cost="ms", error="rms_inside"):
    """Peers that none of the module's settings equals in both time and error; and those of them
    that equal each of the module's settings in both."""
    ours = [row for row in measured(rows) if not row["peer"] and row.get(error) is not None]
    free = [row for row in measured(rows) if row["peer"] and row.get(error) is not None and
            not any(own[cost] <= row[cost] and own[error] <= row[error] for own in ours)]
    return free, [row for row in free if ours and
                  all(row[cost] <= own[cost] and row[error] <= own[error] for own in ours)]


def choices(rows, levels=LEVELS):
    """For each level of psnr the fastest of the module's settings and of the peers that meet it
    without a hole; and the most accurate of each."""
    table = []
    for level in (*levels, None):
        entry = {"level": level}
        for who, peer in (("ours", False), ("peer", True)):
            own = [row for row in measured(rows) if row["peer"] == peer and
                   row.get("psnr_inside") is not None]
            if level is None:
                own.sort(key=lambda row: (-row["psnr_inside"], row["ms"]))
            else:
                own = sorted((row for row in own if row["psnr_inside"] >= level and
                              not row["holes"]), key=lambda row: row["ms"])
            entry[who] = own[0] if own else None
        table.append(entry)
    return table
