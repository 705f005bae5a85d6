# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of which the truth is known, at any number of points.

Each has the surfaces for the reference renderer, and for VTK the meshes whose vertices lie on
them, with exact normals: the mesh is a peer, its vertices are the point cloud.
"""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkLight, vtkProperty

from reference import Isosurfaces, Part, Spheres, Torus
from reference.mesh import Mesh

COLOURS = ((0.35, 0.55, 0.95), (0.35, 0.8, 0.4), (0.85, 0.55, 0.3), (0.8, 0.8, 0.8))
BACKGROUND = (0.1, 0.2, 0.4)
ORBITAL_RADIUS = 18.0
ORBITAL_VALUES = (4.0, 18.0, 50.0)
ORBITAL_SAMPLES = 256             # a side at most: more points come by subdivision
ORBITAL_POINTS = 5.1              # of the three isosurfaces together, over steps squared


def polydata(points, normals, triangles=None):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=1))
    data.SetPoints(vtk_points)
    if normals is not None:
        data.GetPointData().SetNormals(
            numpy_to_vtk(np.ascontiguousarray(normals, np.float32), deep=1))
    if triangles is not None:
        cells = vtkCellArray()
        corners = numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=1)
        starts = numpy_to_vtkIdTypeArray(3 * np.arange(len(triangles) + 1, dtype=np.int64), deep=1)
        cells.SetData(starts, corners)
        data.SetPolys(cells)
    return data


def grid_triangles(columns, rows, numbers):
    """Two triangles for each square between numbers[row, column]."""
    a, b = numbers[:rows, :columns], numbers[:rows, 1:columns + 1]
    c, d = numbers[1:rows + 1, 1:columns + 1], numbers[1:rows + 1, :columns]
    return np.stack([a, b, c, a, c, d], -1).reshape(-1, 3)


def sphere_mesh(count, radius, centre=(0, 0, 0)):
    """A cube's grid on the sphere, at even angles."""
    n = max(2, round(np.sqrt(count / 6)))
    angle = np.tan(np.linspace(-np.pi / 4, np.pi / 4, n + 1))
    u, v = np.meshgrid(angle, angle)
    one = np.ones_like(u)
    points, triangles = [], []
    for axis in range(3):
        for side in (1, -1):
            face = np.roll(np.stack([side * one, side * u, v], -1), axis, 2)
            triangles.append(grid_triangles(n, n, np.arange((n + 1) ** 2).reshape(n + 1, n + 1)) +
                             len(points) * (n + 1) ** 2)
            points.append(face.reshape(-1, 3))
    points = np.concatenate(points)
    normals = points / np.linalg.norm(points, axis=1)[:, None]
    # The faces' rims are there twice and more: one point each.
    _, first, numbers = np.unique(np.round(normals, 9) + 0.0, axis=0, return_index=True,
                                  return_inverse=True)
    normals = normals[first]
    return polydata(centre + radius * normals, normals, numbers.ravel()[np.concatenate(triangles)])


def stacked(*coordinates):
    """Points of coordinates that are arrays of one shape when they are broadcast."""
    return np.stack(np.broadcast_arrays(*coordinates), -1).reshape(-1, 3)


def torus_mesh(count, major, minor):
    rows = max(8, round(np.sqrt(count * minor / (major + minor))))
    columns = max(8, round(count / rows))
    # Of each row and column once: of a hundred million points cosines would take a minute.
    u = 2 * np.pi * np.arange(columns) / columns
    v = (2 * np.pi * np.arange(rows) / rows)[:, np.newaxis]
    normals = stacked(np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v))
    ring = stacked(np.cos(u), np.sin(u), 0 * v)
    numbers = np.arange(rows * columns).reshape(rows, columns)
    numbers = np.pad(numbers, ((0, 1), (0, 1)), mode="wrap")
    return polydata(major * ring + minor * normals, normals, grid_triangles(columns, rows, numbers))


# The density of hydrogen's 3d orbital along z; its greatest value, at z = 6, is 100.
ORBITAL_SCALE = 100 / (72 * np.exp(-2)) ** 2


def orbital(points):
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    z2 = z * z
    r2 = x * x + y * y + z2
    return ORBITAL_SCALE * ((3 * z2 - r2) * np.exp(np.sqrt(r2) / -3)) ** 2


def orbital_gradient(points):
    r = np.maximum(np.linalg.norm(points, axis=-1, keepdims=True), 1e-12)
    shape = 3 * points[..., 2:] ** 2 - r * r
    slope = points * (-2.0, -2.0, 4.0) - shape * points / (3 * r)
    return 2 * ORBITAL_SCALE * shape * np.exp(-2 * r / 3) * slope


def orbital_meshes(count, values=ORBITAL_VALUES):
    """Marched on a grid, then its vertices moved onto the surface."""
    divisions = 0
    while count / 4 ** divisions > ORBITAL_POINTS * ORBITAL_SAMPLES ** 2:
        divisions += 1
    n = max(16, 1 + round(np.sqrt(count / 4 ** divisions / ORBITAL_POINTS)))
    axis = np.linspace(-ORBITAL_RADIUS, ORBITAL_RADIUS, n)
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(3 * [-ORBITAL_RADIUS])
    image.SetSpacing(3 * [axis[1] - axis[0]])
    density = [orbital(np.stack(np.meshgrid(axis, axis, [z]), -1)[..., 0, :]) for z in axis]
    image.GetPointData().SetScalars(numpy_to_vtk(np.array(density, np.float32).ravel(), deep=1))
    meshes = []
    for value in values:
        contour = vtkFlyingEdges3D()
        contour.SetInputData(image)
        contour.SetValue(0, value)
        contour.ComputeNormalsOff()
        contour.ComputeScalarsOff()
        last = contour
        if divisions:
            last = vtkLinearSubdivisionFilter()
            last.SetInputConnection(contour.GetOutputPort())
            last.SetNumberOfSubdivisions(divisions)
        last.Update()
        mesh = last.GetOutput()
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        for _ in range(6):
            slope = orbital_gradient(points)
            step = (orbital(points) - value) / np.maximum((slope ** 2).sum(1), 1e-12)
            points -= step[:, None] * slope
        normals = -orbital_gradient(points)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        meshes.append(polydata(points, normals, triangles))
    return meshes


def properties(count, opacities):
    """Coloured, with a highlight; diffuse and specular light sum up to less than one, since VTK's ways
    of blending differ in what they do with more."""
    made = []
    for i in range(count):
        prop = vtkProperty()
        prop.SetColor(COLOURS[i % len(COLOURS)])
        prop.SetOpacity(opacities[i])
        prop.SetDiffuse(0.7)
        prop.SetSpecular(0.3)
        prop.SetSpecularColor(1, 1, 1)
        prop.SetSpecularPower(20)
        made.append(prop)
    return made


class Scene:
    """surfaces: of the reference; meshes(count): one for each of their parts, of about so many
    points together; opacities: one a part; light: None (VTK's headlight) or the
    position of one that throws shadows, and its radius."""

    def __init__(self, name, surfaces, meshes, opacities, bounds, light=None,
                 light_radius=0.0, zoom=1.4):
        self.name, self.surfaces, self.meshes = name, surfaces, meshes
        self.properties = properties(len(opacities), opacities)
        self.translucent = any(opacity < 1 for opacity in opacities)
        self.shadows = light is not None
        self.light, self.light_radius, self.zoom = light, light_radius, zoom
        low, high = (np.asarray(end, float) for end in bounds)
        self.bounds = np.stack([low, high], 1).ravel()
        self.diagonal = float(np.linalg.norm(high - low))
        if self.shadows:
            for prop in self.properties:
                prop.SetAmbient(0.2)
                prop.SetAmbientColor(prop.GetDiffuseColor())
                prop.SetDiffuse(0.5)

    def parts(self):
        """What the reference draws."""
        made, first = [], 0
        for surface in self.surfaces:
            count = len(getattr(surface, "radii", getattr(surface, "values", (0,))))
            made.append(Part(surface, self.properties[first:first + count]))
            first += count
        return made

    def set_view(self, renderer):
        """Background, lights and camera: the same for VTK and for the reference."""
        renderer.SetBackground(BACKGROUND)
        if self.light is not None:
            renderer.AutomaticLightCreationOff()
            renderer.RemoveAllLights()
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            light.PositionalOn()
            light.SetConeAngle(40)  # VTK's shadow map needs a spotlight
            light.SetExponent(0)
            light.SetPosition(self.light)
            light.SetFocalPoint(0, 0, 0)
            renderer.AddLight(light)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, -1, 0)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(30)
        renderer.ResetCamera(self.bounds)
        camera.Azimuth(25)
        camera.Elevation(35)
        camera.Zoom(self.zoom)
        renderer.ResetCameraClippingRange(self.bounds)


def spheres_scene(layers, opacity=0.4, name=None):
    """Nested spheres, the innermost opaque where there is more than one."""
    radii = [1.0 - 0.7 * k / max(1, layers) for k in range(layers)]
    share = np.array(radii) ** 2 / np.sum(np.square(radii))
    opacities = [opacity] * (layers - 1) + [1.0]
    return Scene(name or f"spheres {layers}", [Spheres(radii)],
                 lambda count: [sphere_mesh(count * s, r) for s, r in zip(share, radii)],
                 opacities, ([-1] * 3, [1] * 3))


def torus_scene(zoom=1.4, name="torus"):
    torus = Torus(1.0, 0.4)
    return Scene(name, [torus], lambda count: [torus_mesh(count, 1.0, 0.4)], [1.0], torus.bounds(),
                 zoom=zoom)


def orbital_scene(opacities, name):
    field = Isosurfaces(orbital, orbital_gradient, ORBITAL_VALUES, ORBITAL_RADIUS)
    half = 0.7 * ORBITAL_RADIUS
    return Scene(name, [field], orbital_meshes, opacities, ([-half] * 3, [half] * 3))


def shadow_scene(name="shadows"):
    """A ball hovering over a torus, lit from the side."""
    centre = (0.75, -0.35, 1.0)
    torus, ball = Torus(1.0, 0.4), Spheres([0.35], [centre])
    return Scene(name, [torus, ball],
                 lambda count: [torus_mesh(0.95 * count, 1.0, 0.4),
                                sphere_mesh(0.05 * count, 0.35, centre)],
                 [1.0, 1.0], ([-1.4, -1.4, -0.4], [1.4, 1.4, 1.35]), light=(2.0, -1.0, 5.0),
                 light_radius=0.3)


def scanned_scene(path):
    """A triangle mesh of a file as it is: of its vertices, of its triangles by Embree the truth."""
    reader = vtkPLYReader() if path.lower().endswith(".ply") else vtkXMLPolyDataReader()
    reader.SetFileName(path)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SplittingOff()
    normals.ConsistencyOn()
    normals.Update()
    data = normals.GetOutput()
    mesh = polydata(vtk_to_numpy(data.GetPoints().GetData()),
                    vtk_to_numpy(data.GetPointData().GetNormals()),
                    vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3))
    surface = mesh_surface(mesh)
    scene = Scene(os.path.basename(path), [surface], lambda count: [mesh], [1.0], surface.bounds())
    scene.count = mesh.GetNumberOfPoints()
    return scene


def mesh_surface(mesh):
    """A mesh for the reference; needs Embree."""
    return Mesh(vtk_to_numpy(mesh.GetPoints().GetData()),
                vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3),
                vtk_to_numpy(mesh.GetPointData().GetNormals()))
