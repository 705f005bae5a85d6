# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""`pyvista.DataSet.splats`: oriented points from volumes and clouds.

PyVista finds this module by its entry point `pyvista.accessors` when `dataset.splats` is first
asked for.
"""
import numpy as np
import pyvista as pv

from . import vtkIsosurfacePoints, vtkPointSplatEstimation, vtkPointSplatProjection
from .pyvista_input import as_cloud, check_backend

check_backend()


@pv.register_dataset_accessor("splats", pv.DataSet)
class DataSetSplats:
    """Oriented points with sizes, from volumes and clouds: `dataset.splats`.

    Parameters
    ----------
    dataset : pyvista.DataSet
        The data set that it belongs to.

    Examples
    --------
    >>> import pyvista as pv
    >>> pv.Sphere().splats.estimate().array_names[0]
    'Normals'
    """

    def __init__(self, dataset):
        self._dataset = dataset

    def estimate(self, neighbors=None, elliptical=False, viewpoint=None, fill=False):
        """Estimate normals where they are missing, splat sizes, curvature and creases.

        A mesh's triangles tell sizes and normals of its vertices.

        Parameters
        ----------
        neighbors : int, optional
            From how many neighbours each point's splat is estimated, 4 to 32.
        elliptical : bool, default: False
            Ellipses (`SplatAxis1`, `SplatAxis2`), as scan lines need them, in place of circles.
        viewpoint : sequence of 3 float, optional
            Where the scanner stood (world units): estimated normals face it. By default they
            are oriented consistently.
        fill : bool, default: False
            Fill points, behind the others, where points are too uneven, or the surface bends too
            much, for circles about them; a plotter that estimates sizes itself draws them. Arrays
            have values between those of the nearest points, and `SplatSource` (n,) has the
            number of the nearest one.

        Returns
        -------
        pyvista.PolyData
            The same points in the same order with all their arrays, and `Normals` (n, 3), unit
            length, `SplatRadius` (n,), world units, and `SplatCurvature` (n, 6), 1 / world units.

        Examples
        --------
        >>> import pyvista as pv
        >>> cloud = pv.PolyData(pv.Sphere().points).splats.estimate()
        >>> cloud["SplatRadius"].shape == (cloud.n_points,)
        True
        """
        estimation = vtkPointSplatEstimation()
        estimation.SetInputData(as_cloud(self._dataset))
        if neighbors is not None:
            estimation.SetNumberOfNeighbors(neighbors)
        if elliptical:
            estimation.SetShapeToElliptical()
        if viewpoint is not None:
            estimation.SetOrientationToViewpoint()
            estimation.SetViewpoint(viewpoint)
        estimation.SetFillGaps(fill)
        return _output(estimation)

    def project(self, outliers="keep"):
        """Move noisy points onto one smooth surface with sharp features.

        Parameters
        ----------
        outliers : {"keep", "mark", "remove"}
            What is done with points that belong to no surface; marked ones have an array
            `Outlier` (n,), 0 or 1.

        Returns
        -------
        pyvista.PolyData
            The points, moved, with `Normals` (n, 3) and `SplatCurvature` (n, 6).

        Examples
        --------
        >>> import pyvista as pv
        >>> pv.Sphere().splats.project().n_points
        842
        """
        projection = vtkPointSplatProjection()
        projection.SetInputData(as_cloud(self._dataset))
        if outliers not in ("keep", "mark", "remove"):
            raise ValueError(f"outliers is one of keep, mark, remove, not {outliers!r}.")
        getattr(projection, f"SetOutliersTo{outliers.capitalize()}")()
        return _output(projection)

    def contour(self, isosurfaces, scalars=None, spacing=0.0):
        """Take oriented points from isosurfaces of a volume, or of scattered samples.

        Parameters
        ----------
        isosurfaces : float or sequence of float
            The isovalues, in the scalars' unit.
        scalars : str, optional
            The point array; by default the active scalars.
        spacing : float, default: 0
            About how far the points are apart (world units); 0 for one on each edge of the grid
            that an isosurface crosses.

        Returns
        -------
        pyvista.PolyData
            Points, those of each isovalue before its fill points, which stand in the voxels in which
            the surface bends by much where spacing is 0; with `Normals` (n, 3), unit length,
            `Isovalue` (n,), `SplatRadius` (n,), world units, and `SplatCurvature` (n, 6),
            1 / world units, which are drawn as they are; `SplatClip` (n, 6), 1 / world units, where
            faces of an image cut the surface.

        Examples
        --------
        >>> import pyvista as pv
        >>> grid = pv.Wavelet()
        >>> surface = grid.splats.contour([100, 150], spacing=0.5)
        >>> surface.array_names
        ['Normals', 'Isovalue', 'SplatRadius', 'SplatCurvature', 'SplatClip']
        """
        data = self._dataset
        if isinstance(data, pv.RectilinearGrid):
            data = data.cast_to_structured_grid()
        name = scalars if scalars is not None else data.active_scalars_name
        if name not in data.point_data:
            raise KeyError(f"The data set has no point array {name!r} to take isosurfaces of. It "
                           f"has: {', '.join(data.point_data.keys()) or '-'}.")
        contour = vtkIsosurfacePoints()
        contour.SetInputData(data)
        contour.SetInputArrayToProcess(0, 0, 0, 0, name)
        values = np.atleast_1d(np.asarray(isosurfaces, dtype=float))
        contour.SetNumberOfContours(len(values))
        for i, value in enumerate(values):
            contour.SetValue(i, float(value))
        contour.SetPointSpacing(spacing)
        return _output(contour)


def _output(algorithm):
    algorithm.Update()
    return pv.wrap(algorithm.GetOutput())
