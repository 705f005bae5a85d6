# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""`pyvista.Plotter.splats`: point clouds in PyVista's plotters, drawn as surfaces.

PyVista finds this module by its entry point `pyvista.plotter_components` when `plotter.splats` is
first asked for.
"""
import difflib

import pyvista as pv

from . import splat_mapper, web_geometry
from .pyvista_input import as_cloud, check_backend

check_backend()
web_geometry.register() # for Jupyter

# Keywords of add_mesh and add_points that mean for splats what they mean for meshes.
MESH_KEYWORDS = (
    "above_color", "ambient", "annotations", "below_color", "categories", "clim", "cmap", "color",
    "component", "copy_mesh", "culling", "diffuse", "edge_color", "flip_scalars", "force_opaque",
    "interpolate_before_map", "label", "lighting", "log_scale", "metallic", "n_colors", "name",
    "nan_color", "nan_opacity", "opacity", "pbr", "pickable", "preference", "remove_existing_actor",
    "render", "reset_camera", "rgb", "roughness", "scalar_bar_args", "scalars", "show_edges",
    "show_scalar_bar", "smooth_shading", "specular", "specular_power", "texture",
    "use_transparency", "user_matrix",
)
# Those of which splats show nothing, and why.
MEANINGLESS_KEYWORDS = {
    "backface_params": "splats of back faces have the property of front faces",
    "edge_opacity": "splats' edges are opaque",
    "emissive": "splats are lit surfaces: see lighting=False",
    "line_width": "splats have no lines",
    "multi_colors": "add the blocks one by one, each with its color",
    "point_shape": "splats are disks in the surface",
    "point_size": "splats have the size that covers the surface: see radius_scale",
    "render_lines_as_tubes": "splats have no lines",
    "render_points_as_spheres": "splats are disks in the surface",
    "show_vertices": "see Plotter.add_points",
    "silhouette": "it is made from edges, which splats do not have",
    "split_sharp_edges": "dataset.splats.estimate() finds creases",
    "static": "a mapper of splats looks at its input when it changes",
    "style": "see Plotter.add_points for points as VTK draws them",
}


# Arrays that say how a splat lies are no colours, unless they are asked for.
OWN_ARRAYS = ("Splat", "Normals", "ProjectionDistance", "ShadowFactor")


@pv.register_plotter_component("splats")
class PlotterSplats:
    """Point clouds drawn as the surfaces that they sample: `plotter.splats`.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter that it belongs to.

    Examples
    --------
    >>> import pyvista as pv
    >>> pl = pv.Plotter(off_screen=True)
    >>> actor = pl.splats.add(pv.Sphere().points)
    >>> pl.show()
    """

    def __init__(self, plotter):
        self._plotter = plotter

    def add(self, cloud, scalars=None, **keywords):
        """Add a point cloud as a surface.

        Parameters
        ----------
        cloud : pyvista.DataSet, vtkDataSet or numpy.ndarray of shape (n, 3)
            Points, with normals or without (world units). Cells, where a mesh has some, tell the
            splats' sizes, and normals where there are none; triangles are drawn where ``hybrid="automatic"`` says so. Normals, sizes
            and curvature that are missing are estimated when the cloud is first drawn;
            `cloud.splats.estimate()` keeps them.
        scalars : str or numpy.ndarray, optional
            The point or cell array to colour by: a name, or values of shape (n,), or (n, 3) or
            (n, 4) with ``rgb=True``. By default the active scalars, unless `color` is given.
        **keywords
            Of :meth:`pyvista.Plotter.add_mesh` those in `MESH_KEYWORDS` (``color``, ``clim``,
            ``cmap``, ``opacity``, ``scalar_bar_args``, ``name``, ``culling``, ...); and the
            settings of vtkPointSplatMapper, each with the name of its method in small letters:
            ``shadows=True`` for SetShadows(True), ``method="image_space"`` for
            SetMethodToImageSpace(), ``absorption=(1, 2, 3)``. :meth:`settings` lists them.

        Returns
        -------
        pyvista.Actor
            The actor, whose mapper is a vtkPointSplatMapper.

        Raises
        ------
        TypeError
            For a keyword that there is not, naming the ones nearest to it.
        KeyError
            For an array that the cloud has not, naming the ones that it has.

        Examples
        --------
        Colour by height, translucent.

        >>> import pyvista as pv
        >>> cloud = pv.Sphere(theta_resolution=90, phi_resolution=90)
        >>> cloud["height"] = cloud.points[:, 2]
        >>> pl = pv.Plotter(off_screen=True)
        >>> actor = pl.splats.add(cloud, scalars="height", cmap="viridis", opacity=0.6)
        >>> actor.mapper.GetClassName()
        'vtkPointSplatMapper'
        >>> pl.show()
        """
        settings, mesh_keywords = self._sort_keywords(keywords)
        data = as_cloud(cloud)
        if isinstance(scalars, str) and scalars not in data.array_names:
            raise KeyError(
                f"The cloud has no array {scalars!r}. "
                f"It has: {', '.join(data.array_names) or '-'}.")
        if scalars is None and (data.active_scalars_name or "").startswith(OWN_ARRAYS):
            mesh_keywords.setdefault("color", True) # the next of the theme's
        smooth = mesh_keywords.pop("smooth_shading", True)
        render = mesh_keywords.pop("render", True)
        show_bar = mesh_keywords.pop("show_scalar_bar", None)
        bar_keywords = dict(mesh_keywords.pop("scalar_bar_args", None) or {})

        # PyVista's own way from keywords to lookup table and property; then another mapper.
        actor = self._plotter.add_mesh(
            data, scalars=scalars, smooth_shading=False, show_scalar_bar=False, render=False,
            **mesh_keywords)
        mapper = splat_mapper.take_over(actor.mapper, theme=self._plotter.theme)
        splat_mapper.set_settings(mapper, settings)
        actor.mapper = mapper
        self._plotter.mapper = mapper
        if not mesh_keywords.get("pbr"):
            actor.prop.interpolation = "Gouraud" if smooth else "Flat"
        if show_bar is None:
            show_bar = self._plotter.theme.show_scalar_bar
        if show_bar and mapper.scalar_visibility and mapper.color_mode == "map":
            bar_keywords.setdefault("title", mapper.array_name)
            self._plotter.add_scalar_bar(mapper=mapper, render=False, **bar_keywords)
        if render:
            self._plotter.render()
        return actor

    @staticmethod
    def settings():
        """List the mapper's settings that :meth:`add` takes as keywords.

        Returns
        -------
        dict
            Of each setting its default, or the names that may be chosen from, the default first.

        Examples
        --------
        >>> import pyvista as pv
        >>> pl = pv.Plotter(off_screen=True)
        >>> pl.splats.settings()["shadows"]
        False
        >>> pl.splats.settings()["kernel"]
        ('gaussian', 'plateau')
        """
        return splat_mapper.settings()

    def choices(self, actor):
        """Tell what was chosen for the last frame, and why.

        Parameters
        ----------
        actor : pyvista.Actor
            One that :meth:`add` returned, drawn at least once.

        Returns
        -------
        dict
            Of each choice, such as ``"method"``, what was chosen and why.

        Examples
        --------
        >>> import pyvista as pv
        >>> pl = pv.Plotter(off_screen=True)
        >>> actor = pl.splats.add(pv.Sphere())
        >>> pl.show(auto_close=False)
        >>> "method" in pl.splats.choices(actor)
        True
        >>> pl.close()
        """
        lines = (actor.mapper.GetChoices() or "").splitlines()
        return dict(line.split(": ", 1) for line in lines if ": " in line)

    @staticmethod
    def _sort_keywords(keywords):
        """The mapper's settings, and what add_mesh is given; an error for what is neither."""
        there = splat_mapper.settings()
        settings, mesh_keywords = {}, {}
        for key, value in keywords.items():
            if key in there:
                settings[key] = value
            elif key in MESH_KEYWORDS:
                mesh_keywords[key] = value
            elif key in MEANINGLESS_KEYWORDS:
                raise TypeError(f"{key} means nothing for splats: {MEANINGLESS_KEYWORDS[key]}.")
            else:
                names = [*there, *MESH_KEYWORDS]
                near = difflib.get_close_matches(key, names, n=3)
                raise TypeError(
                    f"There is no keyword {key!r}."
                    + (f" Did you mean {' or '.join(near)}?" if near else "")
                    + f" There are: {', '.join(sorted(names))}.")
        return settings, mesh_keywords
