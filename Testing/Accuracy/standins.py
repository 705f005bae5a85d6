# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stand-ins for what users bring: each kind of data that is hard on sizes, made here, of a truth in
closed form.

A StandIn has a cloud, and where a picture can be held against one, the mesh of the surface that
the cloud samples. distance(p) is how far a point is from the true surface. Whoever looks at a
single kind of failure makes one with the parameter that matters changed.
"""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkClipPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource

import cad
from cad import extruded
import elements
from meshes import triangles_of, wound_both_ways
from parametric import nearest, normals_of, parametric, random_of, to_parametric, to_points
from piercing import belted, crossing
from reference.surfaces import unit
from scenes import polydata, sphere_mesh
from standin import StandIn, vertices
from streamtubes import streamtubes
import tetrahedra
from volumes import (
    cut_by_volume, gear, holed_ball, noisy_vessels, segmented_vessels, thick_slices, tubes_and_specks)


# Gaps ----------------------------------------------------------------------------------------

def gappy_ball(gaps=40, missing=1.5, jitter=0.2, seed=7):
    """A scanned ball that was closed: about eight of a mesh's vertices are missing in so many places."""
    rng = np.random.default_rng(seed)
    mesh = sphere_mesh(6 * 60 * 60, 1.0)
    places, spacing = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), math.pi / 2 / 60
    centres = unit(rng.normal(size=(gaps, 3)))
    moved = unit(places + rng.uniform(-jitter, jitter, places.shape) * spacing)
    near = np.linalg.norm(places[:, None] - centres, axis=2).min(1) < missing * spacing
    return StandIn("ball with gaps", polydata(moved[~near], moved[~near]),
                   lambda p: np.abs(np.linalg.norm(p, axis=1) - 1), spacing, mesh)


# Machined part -------------------------------------------------------------------------------

# Corners of the part's outline with interior angles from 30 to 150 degrees (and reflex ones), and
# the radii of their fillets.
OUTLINE = (((0, 0), 0), ((4, 0), 0.0), ((4, 1.5), 0.3), ((2.5, 1.5), 0.25), ((2.5, 2.2), 0),
           ((3.712, 2.9), 0), ((1.2, 2.9), 0.0), ((0.6, 2.554), 0), ((0.6, 1.6), 0.15),
           ((0, 1.6), 0))


def outline(steps=16):
    """The outline as a polygon, fillets as arcs."""
    corners = [np.array(c, float) for c, _ in OUTLINE]
    found = []
    for k, corner in enumerate(corners):
        radius = OUTLINE[k][1]
        if radius == 0:
            found.append(corner)
            continue
        a = unit(corners[k - 1] - corner)
        b = unit(corners[(k + 1) % len(corners)] - corner)
        half = 0.5 * math.acos(np.clip(a @ b, -1, 1))
        centre = corner + unit(a + b) * radius / math.sin(half)
        start = corner + a * radius / math.tan(half) - centre
        turn = math.pi - 2 * half
        sign = 1 if a[0] * b[1] - a[1] * b[0] < 0 else -1
        for i in range(steps + 1):
            w = sign * turn * i / steps
            found.append(centre + (start[0] * math.cos(w) - start[1] * math.sin(w),
                                   start[0] * math.sin(w) + start[1] * math.cos(w)))
    return np.array(found)


PART_HEIGHT = 1.2


def with_normals(source, splitting):
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    normals.SetSplitting(splitting)
    normals.SetFeatureAngle(20)
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.Update()
    return normals.GetOutput()


def extruded_distance(polygon, height, p):
    """To the faces: the caps over the outline and the walls along it."""
    q, z = p[:, :2], p[:, 2]
    near, inside = np.full(len(p), np.inf), np.zeros(len(p), bool)
    for a, b in zip(polygon, np.roll(polygon, -1, 0)):
        along = b - a
        t = np.clip(((q - a) @ along) / (along @ along), 0, 1)
        near = np.minimum(near, np.linalg.norm(q - a - t[:, None] * along, axis=1))
        crosses = (a[1] > q[:, 1]) != (b[1] > q[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            x = a[0] + (q[:, 1] - a[1]) / along[1] * along[0]
        inside ^= crosses & (q[:, 0] < x)
    over = np.maximum(np.abs(z - height / 2) - height / 2, 0)
    walls = np.hypot(near, over)
    caps = np.hypot(np.minimum(np.abs(z), np.abs(z - height)), np.where(inside, 0, near))
    return np.minimum(walls, caps)


def part_distance(p):
    return extruded_distance(outline(), PART_HEIGHT, p)


def random_on(mesh, count, rng, smooth=False):
    """Points of a triangle mesh by equal areas, and the triangles' normals, or those between their
    corners'."""
    p = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    t = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = p[t[:, 0]], p[t[:, 1]], p[t[:, 2]]
    cross = np.cross(b - a, c - a)
    area = np.linalg.norm(cross, axis=1)
    pick = rng.choice(len(t), count, p=area / area.sum())
    u, v = np.sqrt(rng.uniform(size=(count, 1))), rng.uniform(size=(count, 1))
    shares = np.concatenate([1 - u, u * (1 - v), u * v], 1)[:, :, None]
    normals = cross[pick]
    if smooth:
        corners = vtk_to_numpy(mesh.GetPointData().GetNormals()).astype(float)
        normals = (shares * corners[t[pick]]).sum(1)
    return (shares * p[t[pick]]).sum(1), unit(normals)


def machined_part(at_random=False, count=100000):
    """at_random: points by equal areas with their faces' normals, else a mesh's vertices, whose
    normals are averaged across the edges."""
    area = 24.6  # of all faces
    spacing = math.sqrt(area / count)
    if at_random:
        mesh = with_normals(extruded(outline(), PART_HEIGHT), True)
        q, n = random_on(mesh, count, np.random.default_rng(4))
        return StandIn("part, at random", polydata(q, n), part_distance, spacing, mesh)
    mesh = with_normals(extruded(outline(), PART_HEIGHT, 3.0 * spacing), False)
    return StandIn("part, vertices", vertices(mesh), part_distance, spacing, mesh)


def shaded_facets(count=50000):
    """Points on the large facets of a coarse mesh, by the normals that shade it smoothly: these lean over."""
    def torus(u, v):
        r = 1 + 0.4 * np.cos(v)
        return np.stack([r * np.cos(u), r * np.sin(u), 0.4 * np.sin(v)], -1)
    mesh = parametric(torus, 16, 8, (0, 2 * np.pi), (0, 2 * np.pi))
    cloud = polydata(*random_on(mesh, count, np.random.default_rng(2), smooth=True))
    return StandIn("shaded facets", cloud, None, math.sqrt(14.5 / count), mesh)


def ribbed_plate(thickness=1.0, count=50000, ribs=4):
    """A plate and its ribs, so many spacings thick, by random points with their faces' normals: no point of their
    rims has neighbours on its face but in a row."""
    area = 2.0 + 0.32 * ribs  # of the faces that are not rims
    spacing = math.sqrt(area / count)
    thick, high = thickness * spacing, 0.15
    polygon = [(0, 0), (1, 0), (1, thick)]
    for x in np.linspace(1, 0, ribs + 2)[1:-1]:
        polygon += [(x + thick, thick), (x + thick, high), (x, high), (x, thick)]
    polygon = np.array(polygon + [(0, thick)])
    mesh = with_normals(extruded(polygon, 1.0), True)
    q, n = random_on(mesh, count, np.random.default_rng(5))
    return StandIn("ribbed plate, %g spacings" % thickness, polydata(q, n),
                   lambda p: extruded_distance(polygon, 1.0, p), spacing, mesh)


def ribbed_block(spacing=0.025):
    """The vertices of a part that was meshed to compute with: its narrow faces and small holes are of few of them."""
    mesh = with_normals(elements.ribbed_block(spacing), False)
    return StandIn("ribbed block", vertices(mesh), None, spacing, mesh)


def beside_ball(standin, place, radius, ratio=4):
    """The same with a ball beside it, whose vertices are ratio times as dense and most of all."""
    ball = sphere_mesh(4 * math.pi * (radius * ratio / standin.spacing) ** 2, radius, place)
    ball.GetPointData().Initialize()
    append = vtkAppendPolyData()
    append.AddInputData(standin.mesh)
    append.AddInputData(ball)
    mesh = with_normals(append, False)
    return StandIn(standin.name + " beside a fine ball", vertices(mesh), None, standin.spacing, mesh)


def graded_bar(ratio=4, spacing=0.02):
    """A bar that is meshed ratio times as finely at its ends, where most of its vertices are, as in its midst."""
    mesh = with_normals(elements.graded_bar(spacing, ratio), False)
    return StandIn("graded bar", vertices(mesh), None, spacing, mesh)


# Drapery -------------------------------------------------------------------------------------

FOLDS = ((0, 2 * math.pi), (0.0, 2.4))


def drapery_surface(u, v):
    """A robe: folds that are round outside and sharp inside, that split and lean."""
    phase = 9 * u + 1.1 * np.sin(2.1 * v) + 0.8 * np.sin(3 * u + 1.7 * v)
    fold = np.abs(np.cos(phase / 2)) ** 0.9
    small = np.abs(np.sin(1.5 * phase + 3 * v))
    r = 0.42 + 0.12 * (1.6 - 0.25 * v) * fold + 0.02 * small + 0.05 * np.cos(1.3 * v)
    return np.stack([r * np.cos(u), r * np.sin(u), v + 0.0 * u], -1)


def drapery(count=50000):
    rng = np.random.default_rng(6)
    u, v = random_of(drapery_surface, *FOLDS, count, rng)
    cloud = polydata(drapery_surface(u, v), normals_of(drapery_surface, u, v))
    mesh = parametric(drapery_surface, 1800, 700, *FOLDS)
    return StandIn("drapery", cloud, to_parametric(drapery_surface, *FOLDS),
                   math.sqrt(9.0 / count), mesh)


def drapery_vertices(count=50000):
    """As a statue's mesh has them: its own mesh is the truth."""
    rows = int(math.sqrt(count / 2.6))
    mesh = parametric(drapery_surface, int(count / rows), rows, *FOLDS)
    return StandIn("drapery, vertices", vertices(mesh), to_parametric(drapery_surface, *FOLDS),
                   math.sqrt(9.0 / count), mesh)


def disc_surface(rim, u, v):
    """A disc of radius 1 with a round rim: v is 0 to 1 on the lower face, to 2 on the rim, to 3 above."""
    turn = math.pi * (np.clip(v - 1, 0, 1) - 0.5)
    r = np.clip(v, 0, 1) - np.clip(v - 2, 0, 1) + rim * np.cos(turn)
    return np.stack([r * np.cos(u), r * np.sin(u), rim * np.sin(turn) + 0 * u], -1)


def disc_normals(u, v):
    turn = math.pi * (np.clip(v - 1, 0, 1) - 0.5)
    return np.stack([np.cos(turn) * np.cos(u), np.cos(turn) * np.sin(u), np.sin(turn)], -1)


def disc_mesh(rim):
    return parametric(lambda u, v: disc_surface(rim, u, v), 400, 120, (0, 2 * math.pi), (0.001, 2.999))


def to_disc(rim, p):
    r = np.hypot(p[:, 0], p[:, 1])
    return np.abs(np.hypot(np.maximum(r - 1, 0), p[:, 2]) - rim)


def rounded_ring(resolution=120):
    """VTK's own superquadric: on its flat faces a row of points is four times as far off as the ones before, that
    are dense all about."""
    source = vtkSuperquadricSource()
    source.ToroidalOn()
    source.SetPhiRoundness(0.3)
    source.SetThetaRoundness(0.5)
    source.SetPhiResolution(resolution)
    source.SetThetaResolution(resolution)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(source.GetOutputPort())
    mesh = with_normals(clean, False)
    distance = to_points(vtk_to_numpy(mesh.GetPoints().GetData()),
                         vtk_to_numpy(mesh.GetPointData().GetNormals()))
    return StandIn("rounded ring", vertices(mesh), distance, 0.01, mesh)


def rimmed_disc(rim=0.1):
    """What modelling programs make of flat things: ten thousand vertices on the rim, fifty on the faces."""
    around, across = np.meshgrid(np.arange(400) * 2 * math.pi / 400, np.linspace(1, 2, 25))
    u, v = [around.ravel()], [across.ravel()]
    for ring in (1, 2):
        for v0 in (ring / 3, 3 - ring / 3):
            u.append(np.arange(8 * ring) * 2 * math.pi / (8 * ring))
            v.append(np.full(8 * ring, v0))
    u, v = np.concatenate(u), np.concatenate(v)
    points = np.concatenate([disc_surface(rim, u, v), [[0, 0, -rim], [0, 0, rim]]])
    normals = np.concatenate([disc_normals(u, v), [[0, 0, -1], [0, 0, 1]]])
    return StandIn("disc with a dense rim", polydata(points, normals), lambda p: to_disc(rim, p), 0.015,
                   disc_mesh(rim))


def graded_disc(growth=1.7, spacing=0.04, rim=0.15, seed=1):
    """What remeshing by curvature makes of a body with flat faces: on those rows of points are growth times as far
    apart as the ones before, up to six times as far as on the round rim. A ball beside it, whose points
    are evenly spaced, has most of the points."""
    rng = np.random.default_rng(seed)
    steps = round(math.pi * rim / spacing)
    rings = [(1 + (k + 0.5) / steps, spacing) for k in range(steps)]
    step, inwards = spacing, 1.0
    while inwards > 0.5 * step:
        rings += [(inwards, step), (3 - inwards, step)]
        step = min(growth * step, 6 * spacing)
        inwards -= 0.87 * step
    u, v = [np.zeros(2)], [np.array([0.0, 3.0])]
    for place, apart in rings:
        radius = disc_surface(rim, np.zeros(1), np.array([place]))[0, 0]
        count = round(2 * math.pi * radius / apart)
        places = np.arange(count) + rng.uniform(-0.15, 0.15, count) + rng.uniform()
        u.append(2 * math.pi * places / count)
        on_face = abs(place - 1.5) > 0.5
        v.append(place + on_face * apart * rng.uniform(-0.15, 0.15, count))
    u, v = np.concatenate(u), np.clip(np.concatenate(v), 0, 3)
    at = np.array([0, 0, 1.2])
    ball = sphere_mesh(6 * 40 * 40, 0.6, at)
    places = vtk_to_numpy(ball.GetPoints().GetData())
    append = vtkAppendPolyData()
    append.AddInputData(ball)
    append.AddInputData(disc_mesh(rim))
    append.Update()

    def distance(p):
        return np.minimum(to_disc(rim, p), np.abs(np.linalg.norm(p - at, axis=1) - 0.6))
    cloud = polydata(np.concatenate([disc_surface(rim, u, v), places]),
                     np.concatenate([disc_normals(u, v), (places - at) / 0.6]))
    return StandIn("disc with graded faces", cloud, distance, spacing, append.GetOutput())


def along_grid_lines(ratio=8, count=60000, noise=0.0):
    """A solver's wall, or a scanner's: points along lines, ratio times as dense along them as from line to line; noise:
    of how far they are off the wall, in their distances along a line."""
    def wall(u, v):
        r = 0.5 + 0.12 * np.cos(2.5 * v) + 0.04 * np.cos(4 * u)
        return np.stack([r * np.cos(u), r * np.sin(u), v + 0.0 * u], -1)
    extent = ((0, 2 * math.pi), (0.0, 2.4))
    # 3.1 around, 2.6 along.
    rows = int(math.sqrt(count / ratio * 2.6 / 3.1))
    u = np.linspace(*extent[0], int(count / rows), endpoint=False)
    u, v = np.meshgrid(u, np.linspace(*extent[1], rows))
    p, n = wall(u, v).reshape(-1, 3), normals_of(wall, u, v).reshape(-1, 3)
    off = np.random.default_rng(5).normal(0, noise * 2.6 / rows / ratio, (len(p), 1))
    cloud = polydata(p + off * n, n)
    mesh = parametric(wall, 900, 700, *extent)
    return StandIn("along grid lines", cloud, to_parametric(wall, *extent), 2.6 / rows, mesh)


def graded_dish(spokes=76):
    """What a contour on a solver's grid about a body is: points on spokes, from a boundary layer in which they
    are forty times as dense as from spoke to spoke to the last ones, on the rim, on one side of the dish
    three times as far apart as on the other, and not quite in rows."""
    rng = np.random.default_rng(9)

    def dish(u, v):
        return np.stack([v * np.cos(u), v * np.sin(u), 0.2 * v * v], -1)
    u, v = [], []
    for k in range(spokes):
        steps = 0.0001 * np.cumsum((1.1 if 2 * k < spokes else 1.25) ** np.arange(99))
        last = np.searchsorted(steps, 0.95)
        places = 0.05 + 0.95 * steps[:last + 1] / steps[last]
        places[1:-1] += rng.uniform(-0.4, 0.4, len(places) - 2) * np.diff(places[:-1])
        u.append(np.full(len(places), 2 * math.pi * k / spokes))
        v.append(places)
    u, v = np.concatenate(u), np.concatenate(v)
    mesh = parametric(dish, 600, 200, (0, 2 * math.pi), (0.05, 1.0))

    def distance(p):
        r = np.hypot(p[:, 0], p[:, 1])
        near = np.clip(r, 0.05, 1.0)
        return np.hypot(r - near, p[:, 2] - 0.2 * near * near)
    return StandIn("graded dish", polydata(dish(u, v), normals_of(dish, u, v)), distance, 0.1, mesh)


def thin_shell(gap=0.3, count=40000):
    """A bowl: two sheets that face away from each other, gap spacings apart."""
    rng = np.random.default_rng(7)
    area = 2 * math.pi
    spacing = math.sqrt(area / (count / 2))
    radii = (1.0, 1.0 - gap * spacing)
    extent = ((0, 2 * math.pi), (0.0, 0.5 * math.pi - 1e-4))

    def sphere(radius):
        return lambda u, v: radius * np.stack(
            [np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), -np.sin(v)], -1)
    parts, meshes = [], []
    for radius, side in zip(radii, (1, -1)):
        z, u = rng.uniform(0, 1, count // 2), rng.uniform(0, 2 * math.pi, count // 2)
        q = sphere(radius)(u, np.arcsin(z))
        parts.append((q, side * q / radius))
        mesh = parametric(sphere(radius), 600, 200, *extent)
        p = vtk_to_numpy(mesh.GetPoints().GetData())
        meshes.append((p, side * p / radius,
                       vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)[:, ::-side]))
    first = len(meshes[0][0])
    both = polydata(np.concatenate([m[0] for m in meshes]), np.concatenate([m[1] for m in meshes]),
                    np.concatenate([meshes[0][2], meshes[1][2] + first]))

    def distance(p):
        r = np.linalg.norm(p, axis=1)
        to_sheets = np.minimum(np.abs(r - radii[0]), np.abs(r - radii[1]))
        return np.hypot(to_sheets, np.maximum(p[:, 2], 0))
    cloud = polydata(*(np.concatenate(part) for part in zip(*parts)))
    return StandIn("thin shell, %g spacings" % gap, cloud, distance, spacing, both)


# Particles -----------------------------------------------------------------------------------

def spray(spacing=0.02, droplets=300):
    """A dam break's particles: water at rest and a wave of it, jittered; droplets of one to twelve
    particles in the air. Positions only: the truth is balls of half the spacing about them."""
    rng = np.random.default_rng(8)
    axis = [np.arange(0, s, spacing) for s in (1.6, 0.5, 0.5)]
    p = np.stack(np.meshgrid(*axis, indexing="ij"), -1).reshape(-1, 3)
    p = p[p[:, 2] < 0.15 + 0.25 * np.exp(-((p[:, 0] - 0.4) / 0.2) ** 2)]
    p = p + rng.uniform(-0.2, 0.2, p.shape) * spacing
    drops = []
    for _ in range(droplets):
        centre = rng.uniform((0, 0, 0.55), (1.6, 0.5, 1.2))
        n = rng.integers(1, 13)
        ball = np.stack(np.meshgrid(*3 * [np.arange(-2, 3)], indexing="ij"), -1).reshape(-1, 3)
        ball = ball[np.argsort((ball ** 2).sum(1), kind="stable")][:n] * 0.9
        drops.append(centre + (ball + rng.uniform(-0.15, 0.15, ball.shape)) * spacing)
    p = np.concatenate([p] + drops)

    find = nearest(p, p)

    def distance(q):
        return np.maximum(np.linalg.norm(q - find(q)[0], axis=1) - spacing / 2, 0)
    return StandIn("spray", polydata(p, None), distance, spacing)


# Scans ---------------------------------------------------------------------------------------

SEMI_AXES = np.array([1.0, 0.7, 0.8])
LEAST_COSINE = 0.25  # between a normal and the way to the sensor


def overlapping_scans(noise=0.3, scans=6, step=0.012):
    """Range scans of an ellipsoid from sensors around it: rows and columns of rays, normal errors
    of `noise` spacings along them; normals by differences of each scan's ranges. Field data has the
    sensors, point data the scan that each point is of."""
    rng = np.random.default_rng(9)
    found, sensors = [], []
    for k in range(scans):
        a, z = 2 * math.pi * k / scans, 1.2 * math.cos(2.4 * k)
        sensor = np.array([3 * math.cos(a), 3 * math.sin(a), z])
        w = unit(-sensor)
        u = unit(np.cross(w, (0, 0, 1.0)))
        v = np.cross(u, w)
        n = int(2 * 1.1 / step)
        x, y = np.meshgrid((np.arange(n) - n / 2) * step / 3, (np.arange(n) - n / 2) * step / 3)
        rays = unit(w + x[..., None] * u + y[..., None] * v)
        o, d = sensor / SEMI_AXES, rays / SEMI_AXES
        A, B, C = (d * d).sum(-1), (d * o).sum(-1), (o * o).sum() - 1
        root = B * B - A * C
        t = np.where(root > 0, (-B - np.sqrt(np.maximum(root, 0))) / A, np.nan)
        p = sensor + (t + rng.normal(0, noise * step, t.shape))[..., None] * rays
        du, dv = p[1:-1, 2:] - p[1:-1, :-2], p[2:, 1:-1] - p[:-2, 1:-1]
        m = unit(np.cross(du, dv))
        m *= -np.sign((m * rays[1:-1, 1:-1]).sum(-1, keepdims=True))
        keep = np.isfinite(m).all(-1) & (-(m * rays[1:-1, 1:-1]).sum(-1) > LEAST_COSINE)
        found.append((p[1:-1, 1:-1][keep], m[keep], np.full(keep.sum(), k)))
        sensors.append(sensor)
    p, m, scan = (np.concatenate(part) for part in zip(*found))
    cloud = polydata(p, m)
    for array, name, data in ((scan.astype(np.int32), "ScanId", cloud.GetPointData()),
                              (np.array(sensors), "SensorPosition", cloud.GetFieldData())):
        made = numpy_to_vtk(np.ascontiguousarray(array), deep=1)
        made.SetName(name)
        data.AddArray(made)

    def body(u, v):
        return SEMI_AXES * np.stack(
            [np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], -1)
    extent = ((0, 2 * math.pi), (-0.5 * math.pi + 1e-4, 0.5 * math.pi - 1e-4))

    def distance(q):
        k0 = np.linalg.norm(q / SEMI_AXES, axis=1)
        return np.abs(k0 * (k0 - 1) / np.linalg.norm(q / SEMI_AXES ** 2, axis=1))
    mesh = parametric(body, 600, 300, *extent)
    # Of what no sensor sees, as the poles, there are no points that could be drawn.
    q, n = (vtk_to_numpy(array).astype(float)
            for array in (mesh.GetPoints().GetData(), mesh.GetPointData().GetNormals()))
    seen = np.max([(n * unit(sensor - q)).sum(1) for sensor in sensors], 0) > LEAST_COSINE
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    mesh = polydata(q, n, triangles[seen[triangles].all(1)])
    return StandIn("overlapping scans", cloud, distance, step, mesh)


def without_normals(standin):
    p = vtk_to_numpy(standin.cloud.GetPoints().GetData())
    return StandIn(standin.name + ", no normals", polydata(p, None), standin.distance, standin.spacing, standin.mesh)


def off_lattice(standin):
    """With vertices that were moved by up to a hundredth of a voxel, so that the volume's lattice tells nothing."""
    p, n = (vtk_to_numpy(array) for array in
            (standin.cloud.GetPoints().GetData(), standin.cloud.GetPointData().GetNormals()))
    return StandIn(standin.name + ", off its lattice", polydata(p + 0.01 * np.sin(p[:, [1, 2, 0]]), n), standin.distance,
                   standin.spacing, standin.mesh)


def turned(standin):
    """By 20 degrees about two axes, as volumes of oblique scans are."""
    c, s = math.cos(math.radians(20)), math.sin(math.radians(20))
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    mesh = standin.mesh
    q, n = (vtk_to_numpy(array).astype(float) @ turn.T
            for array in (mesh.GetPoints().GetData(), mesh.GetPointData().GetNormals()))
    mesh = polydata(q, n, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3))
    return StandIn(standin.name + ", turned", vertices(mesh), lambda p: standin.distance(p @ turn), standin.spacing, mesh)


def clipped(standin):
    """What of it is on one side of a plane through its middle, with new vertices along that."""
    bounds = np.reshape(standin.mesh.GetBounds(), (3, 2))
    origin, normal = bounds.mean(1), unit(np.array([0.3, -0.5, 0.8]))
    clip = vtkClipPolyData()
    clip.SetInputData(standin.mesh)
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    clip.SetClipFunction(plane)
    clip.Update()
    mesh = clip.GetOutput()
    return StandIn(standin.name + ", clipped", vertices(mesh),
                   lambda p: np.maximum(standin.distance(p), (origin - p) @ normal), standin.spacing, mesh)


ALL = {
    "ribbed_block": ribbed_block,
    "block_beside_ball": lambda: beside_ball(ribbed_block(), (0.6, 0.25, 1.6), 0.3),
    "ring_beside_ball": lambda: beside_ball(rounded_ring(), (0, 0.45, 0), 0.12),
    "graded_bar": graded_bar,
    "tubes_edges": lambda: tubes_and_specks("edges"),
    "tubes_contour": lambda: tubes_and_specks("contour"),
    "tubes_points": lambda: tubes_and_specks("points"),
    "tubes_noisy": noisy_vessels,
    "tubes_mask": segmented_vessels,
    "tubes_labels": lambda: segmented_vessels(100),
    "cut_points": cut_by_volume,
    "cut_edges": lambda: cut_by_volume("edges"),
    "cut_noisy": lambda: cut_by_volume("edges", 48, 0.15),
    "cut_noisy_turned": lambda: turned(cut_by_volume("edges", 48, 0.25)),
    "cut_noisy_clipped": lambda: clipped(cut_by_volume("edges", 48, 0.15)),
    "cut_noisy_searched": lambda: off_lattice(turned(cut_by_volume("edges", 48, 0.25))),
    "tetrahedra": tetrahedra.contoured,
    "tetrahedra_clipped": tetrahedra.clipped,
    "tetrahedra_clipped_means": lambda: tetrahedra.clipped(splitting=False),
    "gear": gear,
    "gear_points": lambda: gear("points"),
    "crossing": crossing,
    "crossing_wound": lambda: wound_both_ways(crossing()),
    "streamtubes": streamtubes,
    "streamtube": lambda: streamtubes(lines=1),
    "streamtubes_8": lambda: streamtubes(8),
    "belted": belted,
    "belted_6": lambda: belted(6),
    "thick_slices": thick_slices,
    "part_vertices": machined_part,
    "part_vertices_bare": lambda: without_normals(machined_part()),
    "can": cad.can,
    "slab": cad.slab,
    "shaft": cad.shaft,
    "arrow": cad.arrow,
    "cog": cad.cog,
    "dome": cad.dome,
    "wire": cad.wire,
    "plate": cad.plate,
    "lens": cad.lens,
    "ledge": cad.ledge,
    "channel": cad.channel,
    "cog_shared_points": lambda: cad.with_shared_points(cad.cog()),
    "cog_means": lambda: cad.with_means(cad.cog()),
    "cog_triangles_apart": lambda: triangles_of(cad.cog(), shared=False),
    "part_wound": lambda: wound_both_ways(machined_part()),
    "part_triangles": lambda: triangles_of(machined_part()),
    "part_triangles_apart": lambda: triangles_of(machined_part(), shared=False),
    "part_random": lambda: machined_part(True),
    "shaded_facets": shaded_facets,
    "ribbed_plate": ribbed_plate,
    "ribbed_plate_2": lambda: ribbed_plate(2.0),
    "shell_01": lambda: thin_shell(0.1),
    "shell_03": lambda: thin_shell(0.3),
    "shell_1": lambda: thin_shell(1.0),
    "holed_isosurface": holed_ball,
    "holed_ball": lambda: off_lattice(holed_ball()),
    "gappy_ball": gappy_ball,
    "drapery": drapery,
    "drapery_vertices": drapery_vertices,
    "drapery_wound": lambda: wound_both_ways(drapery_vertices()),
    "rounded_ring": rounded_ring,
    "rimmed_disc": rimmed_disc,
    "thin_disc": lambda: rimmed_disc(0.02),
    "graded_disc": graded_disc,
    "grid_lines": along_grid_lines,
    "grid_lines_20": lambda: along_grid_lines(20),
    "grid_lines_bare": lambda: without_normals(along_grid_lines()),
    "grid_lines_20_bare": lambda: without_normals(along_grid_lines(20)),
    "grid_lines_noisy": lambda: without_normals(along_grid_lines(10, noise=1.0)),
    "graded_dish": graded_dish,
    "spray": spray,
    "scans": overlapping_scans,
    "scans_bare": lambda: without_normals(overlapping_scans()),
}
