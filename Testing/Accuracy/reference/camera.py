# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays of a vtkCamera."""
import numpy as np

from .surfaces import unit


class Camera:
    """What a vtkCamera says, with its window's width and height in pixels; neither sheared views
    nor windows off the centre.

    Directions have a length of one along the camera's axis: t is the depth before the eye.
    """

    def __init__(self, camera, width, height):
        self.width, self.height = width, height
        self.position = np.array(camera.GetPosition())
        forward = unit(np.array(camera.GetFocalPoint()) - self.position)
        right = unit(np.cross(forward, camera.GetViewUp()))
        self.axes = np.stack([right, np.cross(right, forward), -forward])  # of view coordinates
        self.near, self.far = camera.GetClippingRange()
        self.parallel = bool(camera.GetParallelProjection())
        if self.parallel:
            half_height = camera.GetParallelScale()
        else:
            half_height = np.tan(np.radians(camera.GetViewAngle()) / 2)
            if camera.GetUseHorizontalViewAngle():
                half_height *= height / width
        self.half = np.array([half_height * width / height, half_height])

    def rays(self, pixels, dx=0.0, dy=0.0):
        """Origins and directions through pixel numbers (row by row from the lower left), at an
        offset from their centres of less than half a pixel."""
        x = (pixels % self.width + 0.5 + dx) / self.width * 2 - 1
        y = (pixels // self.width + 0.5 + dy) / self.height * 2 - 1
        right, up, back = self.axes
        sideways = (x * self.half[0])[:, None] * right + (y * self.half[1])[:, None] * up
        if self.parallel:
            return self.position + sideways, np.broadcast_to(-back, sideways.shape)
        return np.broadcast_to(self.position, sideways.shape), sideways - back

    def to_view(self, vectors):
        return vectors @ self.axes.T

    def points_to_view(self, points):
        return (points - self.position) @ self.axes.T
