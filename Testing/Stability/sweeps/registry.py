# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a sweep is, and what its defaults must bear."""
import math

from sweeps.measures import COUNTS, IMAGE_SPACE, QUADS, TWO_PASSES, by_method

# Differences that nobody sees, where the mesh itself is nearer still.
ENOUGH = 45
SWEEPS = {}


class Stable:
    """What users meet: values at which all that is not swept is at its default. gap: how many dB
    below the mesh's own psnr the picture may be there, if it has less than enough; holes, leaks: the
    most of them. gap None: nothing is asked but of a setting's default to be near the best one."""

    def __init__(self, values=(), gap=8, holes=0.0, leaks=0.0, enough=ENOUGH):
        self.values, self.gap, self.holes, self.leaks, self.enough = values, gap, holes, leaks, enough

    def asks(self, value):
        return self.gap is not None and value in self.values

    def bears(self, row):
        return (row["psnr"] >= min(self.enough, row["mesh"] - self.gap) and
                row["holes"] <= self.holes and row["leaks"] <= self.leaks)


def coarse(values=(), gap=14, enough=30, **more):
    """What is asked of image space, which loses pixels at borders and silhouettes by nature."""
    return Stable(values, gap, **{"holes": 0.001, "leaks": 0.001, "enough": enough, **more})


def unasked():
    return Stable(gap=None)


class Sweep:
    """series: a Stable for each curve. measure(series, value, size): a row's figures; `at`, where
    on the axis the value lies, is there where that is found by drawing, as of automatic ones.
    default: where what is swept is a setting, its default value. margin: how many dB it may be worse
    than the sweep's best one."""

    def __init__(self, name, title, values, series, measure, default=None, margin=None):
        self.name, self.title, self.values, self.series = name, title, values, series
        self.measure, self.default, self.margin = measure, default, margin

    def rows(self, size, quick):
        """Each row as it is measured; with `stable`, None where nothing is asked of it."""
        for value in sorted({*([] if quick else self.values),
                             *(v for stable in self.series.values() for v in stable.values)}):
            for name, stable in self.series.items():
                if quick and not stable.asks(value):
                    continue
                row = {"sweep": self.name, "series": name, "value": value, "at": value}
                row.update(self.measure(name, value, size))
                row["stable"] = stable.bears(row) if stable.asks(value) else None
                yield row

    def off_the_best(self, rows):
        """Series whose default is more than the margin below the best of its sweep."""
        if self.default is None:
            return []
        found = []
        for name in self.series:
            own = {row["value"]: row["psnr"] for row in rows if row["series"] == name}
            # What nobody could see is no difference.
            if min(ENOUGH, max(own.values())) - own.get(self.default, math.inf) > self.margin:
                found.append(name)
        return found


def sweep(values, two_passes=None, image_space=None, quads=None):
    """Decorates a function of a value and of a method's usual number of points that makes the Scene:
    the same but for the points. Its documentation names the value."""
    series = {name: stable for name, stable in (
        (TWO_PASSES, two_passes), (IMAGE_SPACE, image_space), (QUADS, quads)) if stable}

    def register(function):
        truths = {}

        def measure(method, value, size):
            scene = function(value, COUNTS[method])
            if value not in truths:
                truths.clear()
                truths[value] = scene.truths
            scene.truths = truths[value]
            return scene.measure(size, by_method(method))[0]
        SWEEPS[function.__name__] = Sweep(
            function.__name__, function.__doc__.strip(), values, series, measure)
        return function
    return register


def decades(first, last, count):
    return [first * (last / first) ** (i / (count - 1)) for i in range(count)]
