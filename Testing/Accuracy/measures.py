# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far a picture is from the truth. Arrays are [height, width, ...], colours 0 to 255."""
import numpy as np


def grown(values, by=1):
    """The greatest value at most so many steps, diagonal ones too, from each pixel: of a mask, it and
    all pixels so near to it."""
    for _ in range(by):
        wider = values.copy()
        np.maximum(wider[1:], values[:-1], out=wider[1:])
        np.maximum(wider[:-1], values[1:], out=wider[:-1])
        values = wider.copy()
        np.maximum(values[:, 1:], wider[:, :-1], out=values[:, 1:])
        np.maximum(values[:, :-1], wider[:, 1:], out=values[:, :-1])
    return values


def inner(mask, by=2):
    return ~grown(~mask, by)


def rms(picture, truth, where):
    """Root of the mean squared difference, 0 to 255; None where nothing is compared."""
    if not where.any():
        return None
    return float(np.sqrt(((picture - truth)[where] ** 2).mean()))


def psnr(picture, truth, where):
    """In dB; 100 at most, where nothing differs."""
    error = rms(picture, truth, where)
    return None if error is None else float(min(100.0, 20 * np.log10(255 / max(error, 1e-9))))


def blurred(values, sigma=1.5, reach=5):
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        padding = [(reach, reach) if a == axis else (0, 0) for a in range(2)]
        padded = np.pad(values, padding, mode="edge")
        size = values.shape[axis]
        values = sum(weight * np.take(padded, np.arange(i, i + size), axis)
                     for i, weight in enumerate(kernel))
    return values


def ssim(picture, truth, where):
    """Mean structural similarity of the luma (Wang, Bovik, Sheikh, Simoncelli 2004: Gaussian
    windows of sigma 1.5, K1 = 0.01, K2 = 0.03) over `where`."""
    if not where.any():
        return None
    luma = (0.299, 0.587, 0.114)
    x, y = picture @ luma, truth @ luma
    mean_x, mean_y = blurred(x), blurred(y)
    var_x, var_y = blurred(x * x) - mean_x ** 2, blurred(y * y) - mean_y ** 2
    covariance = blurred(x * y) - mean_x * mean_y
    c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
    value = ((2 * mean_x * mean_y + c1) * (2 * covariance + c2) /
             ((mean_x ** 2 + mean_y ** 2 + c1) * (var_x + var_y + c2)))
    return float(value[where].mean())


def percentile(values, share):
    return float(np.percentile(values, share)) if len(values) else None


def depth_error(depth, truth, where, diagonal, share=95):
    """A percentile of the difference of depths before the eye, in units of the diagonal."""
    return percentile(np.abs(depth[where] - truth[where]) / diagonal, share)


def normal_angle(normal, truth, where, share=50):
    """A percentile of the angle between normals, in degrees."""
    cosine = np.einsum("ij,ij->i", normal[where], truth[where])
    length = np.linalg.norm(normal[where], axis=1) * np.linalg.norm(truth[where], axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        angle = np.degrees(np.arccos(np.clip(cosine / length, -1, 1)))
    return percentile(np.nan_to_num(angle, nan=180.0), share)


def outline(covered):
    """Covered pixels with a neighbour (of eight) that is not."""
    return covered & grown(~covered)


def silhouette(covered, truth):
    """Pixels covered in one and not in the other, within two pixels of the true outline, a pixel
    of it: 0 is exact; half a pixel off everywhere gives about 0.5."""
    line = outline(truth)
    if not line.any():
        return None
    return float(((covered != truth) & grown(line, 2)).sum() / line.sum())


def holes(covered, truth):
    """Pixels not covered whose 3 x 3 neighbourhood truly is."""
    return int((inner(truth, 1) & ~covered).sum())


def openings(depth, truth, least):
    """Pixels where one sees what is behind the surface, be it another one: farther from the eye, by the
    least difference, than all that truly is within two pixels. The background's depth is infinite."""
    return int((depth > grown(truth, 2) + least).sum())


def spill(covered, truth):
    """Pixels covered more than two pixels outside what truly is."""
    return int((covered & ~grown(truth, 2)).sum())


def layer_error(layers, truth):
    """The share of the pixels covered in either whose number of layers is not the true one."""
    either = (layers > 0) | (truth > 0)
    return float((layers != truth)[either].mean()) if either.any() else None
