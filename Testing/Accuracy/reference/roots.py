# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real roots of many functions at once, each in an interval of its own."""
import numpy as np

ITERATIONS = 80  # of bisection alone these leave nothing of a double's 52 bits


def bracketed(evaluate, low, high, value_low, tolerance=1e-13):
    """One root of each function in [low, high], at whose ends it has opposite signs.

    evaluate(t, rows) gives the values and derivatives of functions `rows` at t. Newton's steps,
    and bisection wherever such a step would leave the bracket, and every fourth time.
    """
    low, high = low.copy(), high.copy()
    negative_low = value_low < 0
    root = 0.5 * (low + high)
    rows = np.arange(len(root))
    for iteration in range(ITERATIONS):
        t = root[rows]
        value, slope = evaluate(t, rows)
        on_low_side = (value < 0) == negative_low[rows]
        low[rows] = np.where(on_low_side, t, low[rows])
        high[rows] = np.where(on_low_side, high[rows], t)
        a, b = low[rows], high[rows]
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where(value == 0, t, t - value / slope)
        inside = (step >= a) & (step <= b) & (iteration % 4 != 3)
        root[rows] = np.where(inside | (value == 0), step, 0.5 * (a + b))
        scale = tolerance * np.maximum(1.0, np.abs(t))
        moved = np.abs(root[rows] - t)
        rows = rows[(moved > scale) & (b - a > scale) & (value != 0)]
        if not len(rows):
            break
    return root


def polynomial_values(coefficients, t):
    """Values and derivatives; coefficients [n, degree + 1], lowest order first."""
    value = coefficients[:, -1].copy()
    slope = np.zeros_like(value)
    for k in range(coefficients.shape[1] - 2, -1, -1):
        slope = slope * t + value
        value = value * t + coefficients[:, k]
    return value, slope


def polynomial_roots(coefficients, low, high):
    """All simple real roots in [low, high]: [n, degree], ascending, infinite where there are fewer.

    Between the roots of its derivative, found the same way, a polynomial is monotone: so there is one
    root where its ends differ in sign and none elsewhere, and none can be missed.
    """
    n, degree = len(coefficients), coefficients.shape[1] - 1
    if degree == 1:
        with np.errstate(divide="ignore", invalid="ignore"):
            root = -coefficients[:, 0] / coefficients[:, 1]
        return np.where((root >= low) & (root <= high), root, np.inf)[:, None]
    derivative = coefficients[:, 1:] * np.arange(1, degree + 1)
    turns = np.minimum(polynomial_roots(derivative, low, high), high[:, None])
    knots = np.concatenate([low[:, None], turns, high[:, None]], 1)
    roots = np.full((n, degree), np.inf)
    before, _ = polynomial_values(coefficients, knots[:, 0])
    for k in range(degree):
        after, _ = polynomial_values(coefficients, knots[:, k + 1])
        at = np.flatnonzero((before < 0) != (after < 0))
        if len(at):
            own = coefficients[at]
            roots[at, k] = bracketed(lambda t, rows: polynomial_values(own[rows], t),
                                     knots[at, k], knots[at, k + 1], before[at])
        before = after
    return np.sort(roots, 1)
