# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""splatview's readers: one cloud, and one volume, in every format give one picture."""
import math
import os
import struct

from TestSplatviewPicture import globe
from splatview_tools import SplatviewTest, main
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkMetaImageWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader,
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)

ROWS, COLUMNS = 40, 50


def make_cloud():
    """A square in z = 0, with normals that no estimation finds: as of waves."""
    points, normals = [], []
    for j in range(ROWS):
        for i in range(COLUMNS):
            points.append((0.25 * i - 6.0, 0.25 * j - 5.0, 0.0))
            n = (0.8 * math.sin(0.5 * i), 0.8 * math.sin(0.7 * j), 1.0)
            length = math.sqrt(sum(c * c for c in n))
            normals.append(tuple(c / length for c in n))
    return points, normals


POINTS, NORMALS = make_cloud()
# Red to the left, blue to the right.
COLOURS = [(255, 0, 0) if x < 0 else (0, 0, 255) for x, _, _ in POINTS]
BOUNDS = (-6.0, -6.0 + 0.25 * (COLUMNS - 1), -5.0, -5.0 + 0.25 * (ROWS - 1), 0.0, 0.0)


def fill(data):
    points = vtkPoints()
    for point in POINTS:
        points.InsertNextPoint(point)
    normals = vtkFloatArray()
    normals.SetName("Normals")
    normals.SetNumberOfComponents(3)
    for normal in NORMALS:
        normals.InsertNextTuple(normal)
    height = vtkFloatArray()
    height.SetName("height")
    for point in POINTS:
        height.InsertNextValue(point[1])
    data.SetPoints(points)
    data.GetPointData().SetNormals(normals)
    data.GetPointData().AddArray(height)
    return data


def save(writer, data, file):
    writer.SetInputData(data)
    writer.SetFileName(file)
    assert writer.Write() == 1


def make_ply(encoding, properties, rows, before=""):
    """properties: pairs of type and name."""
    letters = {"float": "f", "double": "d", "uchar": "B", "ushort": "H", "int": "i"}
    header = f"ply\nformat {encoding} 1.0\ncomment of no interest\n{before}"
    header += f"element vertex {len(rows)}\n"
    header += "".join(f"property {kind} {name}\n" for kind, name in properties)
    header += "end_header\n"
    if encoding == "ascii":
        return (header + "".join(" ".join(map(repr, row)) + "\n" for row in rows)).encode()
    order = "<" if encoding == "binary_little_endian" else ">"
    layout = order + "".join(letters[kind] for kind, _ in properties)
    return header.encode() + b"".join(struct.pack(layout, *row) for row in rows)


XYZ = [("float", name) for name in ("x", "y", "z")]
NXYZ = [("float", name) for name in ("nx", "ny", "nz")]
ENCODINGS = ("ascii", "binary_little_endian", "binary_big_endian")


class TestPoints(SplatviewTest):
    def setUp(self):
        super().setUp()
        save(vtkXMLPolyDataWriter(), fill(vtkPolyData()), self.path("cloud.vtp"))
        self.reference = self.draw("cloud.vtp")

    def assert_same(self, name, normals="file", coloured_by="actor"):
        report, picture = self.draw(name)
        (surface,) = report["surfaces"]
        self.assertEqual((surface["points"], surface["skipped"]), (len(POINTS), 0), name)
        self.assertEqual(surface["normals"], normals, name)
        self.assertEqual(surface["coloured_by"], coloured_by, name)
        self.assert_bounds(surface, BOUNDS, 1e-6)
        self.assertLess(picture.difference(self.reference[1]), 0.2, name)

    def test_other_normals_would_be_seen(self):
        report, picture = self.draw("cloud.vtp", "--normals", "estimate")
        self.assertEqual(report["surfaces"][0]["normals"], "estimated")
        self.assertGreater(picture.difference(self.reference[1]), 3.0)
        self.assertEqual(self.reference[0]["surfaces"][0]["normals"], "file")

    def test_ply(self):
        rows = [p + n for p, n in zip(POINTS, NORMALS)]
        for encoding in ENCODINGS:
            self.write("cloud.ply", make_ply(encoding, XYZ + NXYZ, rows))
            self.assert_same("cloud.ply")

    def test_ply_in_another_order_with_other_properties(self):
        properties = [("uchar", "flags"), *NXYZ, ("double", "quality"), *XYZ, ("int", "id")]
        rows = [(7, *n, 0.5, *p, -3) for p, n in zip(POINTS, NORMALS)]
        for encoding in ENCODINGS:
            self.write("cloud.ply", make_ply(encoding, properties, rows))
            self.assert_same("cloud.ply")
        report, _ = self.draw("cloud.ply", "--array", "quality")
        self.assertEqual(report["surfaces"][0]["coloured_by"], "quality")

    def test_ply_after_another_element_and_with_lists(self):
        rows = [p + n for p, n in zip(POINTS, NORMALS)]
        content = make_ply(
            "ascii", XYZ + NXYZ, rows, "element camera 2\nproperty list uchar int views\n"
        )
        head, body = content.split(b"end_header\n")
        self.write("cloud.ply", head + b"end_header\n3 1 2 3\n0\n" + body)
        self.assert_same("cloud.ply")
        listed = b"property list uchar int near\nproperty float nx"
        head = head.replace(b"property float nx", listed)
        lines = body.decode().split("\n")
        body = "\n".join(
            " ".join(words[:3] + ["2", "8", "9"] + words[3:])
            for words in (line.split() for line in lines if line)
        )
        self.write("cloud.ply", head + b"end_header\n3 1 2 3\n0\n" + body.encode())
        self.assert_same("cloud.ply")

    def test_ply_colours(self):
        pictures = []
        for kind, white in (("uchar", 255), ("ushort", 65535), ("float", 1.0)):
            for names in ("red green blue", "diffuse_red diffuse_green diffuse_blue"):
                properties = XYZ + NXYZ + [(kind, name) for name in names.split()]
                rows = [
                    (*p, *n, *(type(white)(c // 255 * white) for c in rgb))
                    for p, n, rgb in zip(POINTS, NORMALS, COLOURS)
                ]
                self.write("cloud.ply", make_ply("binary_little_endian", properties, rows))
                report, picture = self.draw("cloud.ply")
                self.assertEqual(report["surfaces"][0]["coloured_by"], "RGB", kind)
                pictures.append(picture)
        self.assert_red_and_blue(pictures[0])
        for picture in pictures[1:]:
            self.assertEqual(picture.bytes, pictures[0].bytes)
        report, picture = self.draw("cloud.ply", "--color", "lime")
        self.assertEqual(report["surfaces"][0]["coloured_by"], "actor")
        self.assertGreater(picture.centre()[1], picture.centre()[0])

    def assert_red_and_blue(self, picture):
        for x, strong in ((picture.width // 3, 0), (2 * picture.width // 3, 2)):
            pixel = picture.pixel(x, picture.height // 2)
            self.assertGreater(pixel[strong], 50)
            self.assertLess(max(pixel[1], pixel[2 - strong]), 30)

    def test_ply_far_from_the_origin(self):
        properties = [("double", name) for name in ("x", "y", "z")]
        rows = [(5e5 + 1e-3 * x, 4e6 + 1e-3 * y, z) for x, y, z in POINTS]
        for encoding in ENCODINGS:
            self.write("cloud.ply", make_ply(encoding, properties, rows))
            report, _ = self.draw("cloud.ply")
            surface = report["surfaces"][0]
            self.assertEqual(surface["normals"], "estimated")
            far = [1e-3 * b + o for b, o in zip(BOUNDS, (5e5, 5e5, 4e6, 4e6, 0, 0))]
            self.assert_bounds(surface, far, 1e-6)

    def test_ply_with_unusable_vertices(self):
        rows = [list(p + n) for p, n in zip(POINTS, NORMALS)]
        rows[5][0] = math.nan
        rows[6][1] = math.inf
        for encoding in ENCODINGS:
            self.write("cloud.ply", make_ply(encoding, XYZ + NXYZ, rows))
            done = self.run_splatview("cloud.ply", "--output", "o.png")
            self.assertEqual(done.returncode, 0)
            self.assertIn(f"{len(POINTS) - 2} points", done.stdout)
            self.assertRegex(done.stderr, r"\A(splatview: warning: [^\n]+\n)+\Z")

    def text_rows(self, separator, decimal=".", quote=""):
        """The cloud with normals, a line each."""
        return [
            separator.join(quote + repr(v).replace(".", decimal) + quote for v in p + n)
            for p, n in zip(POINTS, NORMALS)
        ]

    def test_text_of_spreadsheets(self):
        names = "X;Y;Z;Nx;Ny;Nz"
        for name, (lines, start, end) in {
            "semicolons.csv": (self.text_rows(";", ","), names + "\n", "\n"),
            "excel.csv": (self.text_rows(";", ","), "\ufeff" + names + "\r\n", "\r\n"),
            "quoted.csv": (self.text_rows(",", ".", '"'), '"x","y","z","a","b","c"\n', "\n"),
            "quoted_commas.csv": (self.text_rows(",", ",", '"'), "", "\n"),
            "quoted_mark.csv": (self.text_rows(";", ",", '"'), "\ufeff", "\r\n"),
            "tabs.txt": (self.text_rows("\t", ","), "", "\n"),
            "blanks.xyz": (self.text_rows("  ", ","), "", "\n"),
            "commas_blanks.txt": (self.text_rows(", ", ","), "", "\n"),
            "points_commas_blanks.txt": (self.text_rows(", ", "."), "", "\n"),
            "loose.csv": (self.text_rows(" ; "), "", " ;\n"),
            "trailing.csv": (self.text_rows(","), "Scan 7\nLänge [m],,,,,\n", ",\n"),
            "macintosh.txt": (self.text_rows(" "), "# of old\r\r", "\r"),
            "comments.txt": (self.text_rows(" "), "% of a program\n", " # and more\n\n"),
            "parts.pts": (
                [f"{len(POINTS) - 9}"] + self.text_rows(" ")[9:] + ["9"] + self.text_rows(" ")[:9],
                "", "\n",
            ),
        }.items():  # fmt: skip
            self.write(name, (start + "".join(line + end for line in lines)).encode())
            self.assert_same(name)

    def test_text_with_names_in_any_order(self):
        columns = {
            **{name: [p[i] for p in POINTS] for i, name in enumerate(("x", "y", "z"))},
            **{name: [n[i] for n in NORMALS] for i, name in enumerate(("nx", "ny", "nz"))},
            **{name: [c[i] for c in COLOURS] for i, name in enumerate("rgb")},
            "radius": [0.01] * len(POINTS),
            "intensity": range(len(POINTS)),
        }

        def table(names, separator=",", quote="", **spelled):
            lines = [separator.join(quote + spelled.get(n, n) + quote for n in names)]
            for row in zip(*(columns[n] for n in names)):
                lines.append(separator.join(map(repr, row)))
            return "\n".join(lines) + "\n"

        plain = ("nz", "ny", "z", "nx", "x", "y")
        paraview = {"x": "Points:0", "y": "Points:1", "z": "Points:2"}
        paraview.update({"nx": "Normals:0", "ny": "Normals:1", "nz": "Normals:2"})
        for name, content in {
            "plain.csv": table(plain),
            "large.csv": table(plain).upper(),
            "quoted.csv": table(plain, ";", '"', x="X", nx="NX", ny="Ny", nz="n_z"),
            "units.csv": table(plain, x="X [m]", y="Y [m]", z="Z (m)"),
            "quoted_units.csv": table(plain, ",", '"', x="X [m, west]"),
            "tabs.txt": table(plain, "\t", x="X [m]"),
            "blanks.txt": table(plain, " "),
            "paraview.csv": table(plain, ",", '"', **paraview),
        }.items():
            self.write(name, content)
            self.assert_same(name)
        every = ("intensity", "b", "g", "radius", "r", "nz", "ny", "z", "nx", "x", "y")
        for spelled in ({}, {"r": "Red", "g": "Green", "b": "BLUE"}):
            report, picture = self.draw(self.write("all.csv", table(every, **spelled)))
            surface = report["surfaces"][0]
            self.assertEqual((surface["normals"], surface["coloured_by"]), ("file", "RGB"))
            self.assert_bounds(surface, BOUNDS, 1e-6)
        for array in ("intensity", "SplatRadius"):
            report, _ = self.draw("all.csv", "--array", array)
            self.assertEqual(report["surfaces"][0]["coloured_by"], array)
        # Names that are not known are arrays, and no colours.
        columns.update(vx=columns["r"], vy=columns["g"], vz=columns["b"])
        self.write("flow.csv", table(("x", "y", "z", "vx", "vy", "vz")))
        report, _ = self.draw("flow.csv")
        self.assertEqual(report["surfaces"][0]["coloured_by"], "actor")
        report, _ = self.draw("flow.csv", "--array", "vy")
        self.assertEqual(report["surfaces"][0]["coloured_by"], "vy")
        # Colours of 8 bits and of 16.
        coloured = ("b", "y", "g", "x", "r", "z", *plain[:2], "nx")
        _, picture = self.draw(self.write("coloured.csv", table(coloured)))
        self.assert_red_and_blue(picture)
        columns.update({c: [257 * value for value in columns[c]] for c in "rgb"})
        _, deep = self.draw(self.write("deep.csv", table(coloured)))
        self.assertEqual(deep.bytes, picture.bytes)

    def test_text_with_empty_cells(self):
        lines = self.text_rows(";", ",")
        lines[7] = ";;;0;0;1"
        self.write("cells.csv", "\n".join(lines))
        done = self.run_splatview("cells.csv", "--output", "o.png")
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"{len(POINTS) - 1} points", done.stdout)
        self.assertIn("1 of", done.stderr)

    def test_text(self):
        def lines(*columns, separator=" "):
            rows = (sum(map(tuple, row), ()) for row in zip(*columns))
            return "".join(separator.join(map(repr, row)) + "\n" for row in rows)

        n = len(POINTS)
        scalars = [(0.25 * (i % 7),) for i in range(n)]
        fractions = [tuple(c / 255 for c in rgb) for rgb in COLOURS]
        plain = lines(POINTS, NORMALS)
        for name, content in {
            "plain.xyz": plain,
            "count.pts": f"{n}\n{plain}",
            "comments.txt": f"# of\n// no interest\n\n{plain}\n# the end\n",
            "names.csv": "x,y,z,nx,ny,nz\n" + lines(POINTS, NORMALS, separator=","),
            "quoted.csv": '"x";"y";"z";"nx";"ny";"nz"\n' + lines(POINTS, NORMALS, separator=";"),
            "dos.xyz": plain.replace("\n", "\r\n"),
            "no_end.xyz": plain.rstrip("\n"),
            "scalar_last.xyz": lines(POINTS, NORMALS, scalars),
            "scalar_first.xyz": lines(POINTS, scalars, NORMALS),
        }.items():
            self.write(name, content)
            self.assert_same(name)
        _, coloured = self.draw(self.write("c.xyz", lines(POINTS, NORMALS, COLOURS)))
        self.assert_red_and_blue(coloured)
        for name, columns in {
            "nc": (POINTS, NORMALS, COLOURS),
            "cn": (POINTS, COLOURS, NORMALS),
            "nf": (POINTS, NORMALS, fractions),
            "snc": (POINTS, scalars, NORMALS, COLOURS),
            "scn": (POINTS, scalars, COLOURS, NORMALS),
            "ncs": (POINTS, NORMALS, COLOURS, scalars),
        }.items():
            report, picture = self.draw(self.write(f"{name}.xyz", lines(*columns)))
            surface = report["surfaces"][0]
            self.assertEqual((surface["normals"], surface["coloured_by"]), ("file", "RGB"), name)
            self.assertEqual(picture.bytes, coloured.bytes, name)
        for name, columns, wanted in (
            ("p", (POINTS,), "actor"),
            ("s", (POINTS, scalars), "actor"),
            ("c", (POINTS, COLOURS), "RGB"),
            ("sc", (POINTS, scalars, COLOURS), "RGB"),
        ):
            report, _ = self.draw(self.write(f"{name}.xyz", lines(*columns)))
            surface = report["surfaces"][0]
            self.assertEqual(
                (surface["normals"], surface["coloured_by"]), ("estimated", wanted), name
            )
            self.assert_bounds(surface, BOUNDS, 1e-6)
        report, _ = self.draw("s.xyz", "--array", "Intensity")
        self.assertEqual(report["surfaces"][0]["coloured_by"], "Intensity")

    def test_obj(self):
        self.write(
            "cloud.obj",
            "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS)
            + "".join(f"vn {x} {y} {z}\n" for x, y, z in NORMALS),
        )
        self.assert_same("cloud.obj")

    def test_vtk_formats(self):
        grid = vtkStructuredGrid()
        grid.SetDimensions(COLUMNS, ROWS, 1)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, fill(vtkPolyData()))
        blocks.SetBlock(1, None)
        for name, writer, data in (
            ("cloud.vtk", vtkDataSetWriter(), fill(vtkPolyData())),
            ("cells.vtk", vtkDataSetWriter(), fill(vtkUnstructuredGrid())),
            ("cloud.vtu", vtkXMLUnstructuredGridWriter(), fill(vtkUnstructuredGrid())),
            ("cloud.vts", vtkXMLStructuredGridWriter(), fill(grid)),
            ("cloud.vtm", vtkXMLMultiBlockDataWriter(), blocks),
        ):
            save(writer, data, self.path(name))
            self.assert_same(name)

    def test_extension_in_capitals_and_odd_names(self):
        with open(self.path("cloud.vtp"), "rb") as file:
            self.write('wölk "1".VTP', file.read())
        self.assert_same('wölk "1".VTP')

    def test_several_files(self):
        self.write("left.xyz", "".join(f"{x - 20} {y} {z}\n" for x, y, z in POINTS))
        report, _ = self.draw("cloud.vtp", "left.xyz", "--color", "red;#0000ff")
        self.assertEqual([s["name"] for s in report["surfaces"]], ["cloud.vtp", "left.xyz"])
        self.assertEqual([s["color"] for s in report["surfaces"]], [[1, 0, 0], [0, 0, 1]])
        self.assertEqual(report["points"], 2 * len(POINTS))
        self.assert_bounds(report["surfaces"][1], (-26, BOUNDS[1] - 20, *BOUNDS[2:]), 1e-6)


class TestMeshes(SplatviewTest):
    def test_normals_from_triangles(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(40)
        sphere.SetPhiResolution(30)
        sphere.GenerateNormalsOff()
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(sphere.GetOutputPort())
        triangles.Update()
        mesh = triangles.GetOutput()
        save(vtkXMLPolyDataWriter(), mesh, self.path("mesh.vtp"))
        report, reference = self.draw("mesh.vtp")
        count = report["points"]
        self.assertEqual(report["surfaces"][0]["normals"], "triangles")
        ascii_ply = vtkPLYWriter()
        ascii_ply.SetFileTypeToASCII()
        for name, writer in (
            ("mesh.ply", vtkPLYWriter()),
            ("ascii.ply", ascii_ply),
            ("mesh.stl", vtkSTLWriter()),
            ("mesh.obj", vtkOBJWriter()),
        ):
            save(writer, mesh, self.path(name))
            report, picture = self.draw(name)
            self.assertEqual(report["surfaces"][0]["normals"], "triangles", name)
            self.assertEqual(report["points"], count, name)
            self.assertLess(picture.difference(reference), 0.5, name)
        report, picture = self.draw("mesh.vtp", "--normals", "estimate")
        self.assertEqual(report["surfaces"][0]["normals"], "estimated")
        self.assertLess(picture.difference(reference), 2.0)  # a sphere all the same


class TestVolumes(SplatviewTest):
    N = 24

    def make_volume(self):
        """The distance from the middle, which is at the origin, in voxels of 0.5."""
        volume = vtkImageData()
        volume.SetDimensions(self.N, self.N, self.N)
        volume.SetSpacing(0.5, 0.5, 0.5)
        middle = -0.25 * (self.N - 1)
        volume.SetOrigin(middle, middle, middle)
        distance = vtkFloatArray()
        distance.SetName("distance")
        negative = vtkFloatArray()
        negative.SetName("negative")
        for i in range(volume.GetNumberOfPoints()):
            d = math.sqrt(sum(c * c for c in volume.GetPoint(i)))
            distance.InsertNextValue(d)
            negative.InsertNextValue(-d)
        volume.GetPointData().SetScalars(distance)
        volume.GetPointData().AddArray(negative)
        return volume

    def make_nrrd(self, volume, byte_order):
        half = 0.25 * (self.N - 1)
        scalars = volume.GetPointData().GetScalars()
        values = [scalars.GetValue(i) for i in range(volume.GetNumberOfPoints())]
        return (
            f"NRRD0004\ntype: float\ndimension: 3\nsizes: {self.N} {self.N} {self.N}\n"
            "space: right-anterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\n"
            f"space origin: (-{half},-{half},-{half})\nencoding: raw\n"
            f"endian: {'little' if byte_order == '<' else 'big'}\n\n"
        ).encode() + struct.pack(f"{byte_order}{len(values)}f", *values)

    def setUp(self):
        super().setUp()
        volume = self.make_volume()
        save(vtkXMLImageDataWriter(), volume, self.path("v.vti"))
        save(vtkDataSetWriter(), volume, self.path("v.vtk"))
        for name in ("v.mhd", "v.mha"):
            writer = vtkMetaImageWriter()
            writer.SetCompression(False)
            writer.SetInputData(volume)
            writer.SetFileName(self.path(name))
            if name == "v.mhd":
                writer.SetRAWFileName(self.path("v.raw"))
            writer.Write()
        self.write("v.nrrd", self.make_nrrd(volume, "<"))
        self.write("big.nrrd", self.make_nrrd(volume, ">"))

    def test_formats(self):
        report, reference = self.draw("v.vti", "--iso", "3,5")
        inner, outer = report["surfaces"]
        self.assertEqual((inner["isovalue"], outer["isovalue"]), (3, 5))
        self.assertEqual(inner["normals"], "gradient")
        self.assert_bounds(inner, (-3, 3) * 3, 0.05)
        self.assert_bounds(outer, (-5, 5) * 3, 0.05)
        for name in ("v.vtk", "v.mhd", "v.mha", "v.nrrd", "big.nrrd"):
            other, picture = self.draw(name, "--iso", "3,5")
            self.assertEqual(
                [s["points"] for s in other["surfaces"]],
                [s["points"] for s in report["surfaces"]],
                name,
            )
            self.assert_bounds(other["surfaces"][1], outer["bounds"], 1e-5)
            self.assertLess(picture.difference(reference), 0.2, name)

    def test_default_isovalues_are_quarters(self):
        report, _ = self.draw("v.vti")
        low, high = math.sqrt(3) * 0.25, math.sqrt(3) * 0.25 * (self.N - 1)
        for i, surface in enumerate(report["surfaces"], 1):
            self.assertAlmostEqual(surface["isovalue"], low + 0.25 * i * (high - low), places=4)
        self.assertEqual(len(report["surfaces"]), 3)

    def test_density(self):
        def count(*options):
            return self.draw("v.vti", "--iso", "4", *options)[0]["points"]

        area = 4 * math.pi * 16
        for spacing in (0.1, 0.2):
            self.assertAlmostEqual(
                count("--spacing", spacing) * spacing**2 / area, 1.0, delta=0.3
            )
        self.assertAlmostEqual(count("--magnify", 3) / count(), 9.0, delta=1.0)

    def test_array(self):
        report, _ = self.draw("v.vti", "--array", "negative", "--iso", "-4")
        self.assert_bounds(report["surfaces"][0], (-4, 4) * 3, 0.05)

    def test_points_are_samples(self):
        # The same volume without its grid.
        reader = vtkXMLImageDataReader()
        reader.SetFileName(self.path("v.vti"))
        reader.Update()
        volume = reader.GetOutput()
        points = vtkPoints()
        for i in range(volume.GetNumberOfPoints()):
            points.InsertNextPoint(volume.GetPoint(i))
        samples = vtkUnstructuredGrid()
        samples.SetPoints(points)
        samples.GetPointData().ShallowCopy(volume.GetPointData())
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(samples)
        writer.SetFileName(self.path("samples.vtu"))
        writer.Write()
        report, _ = self.draw("samples.vtu", "--array", "negative", "--iso", "-4,-3")
        outer, inner = report["surfaces"]
        self.assertEqual((outer["isovalue"], outer["normals"]), (-4, "gradient"))
        self.assert_bounds(outer, (-4, 4) * 3, 0.05)
        self.assert_bounds(inner, (-3, 3) * 3, 0.05)


if __name__ == "__main__":
    main()
