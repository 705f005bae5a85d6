# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""splatview's command line: what it says, and how it refuses what is wrong."""
import os
import pty
import re
import shlex
import shutil
import struct
import subprocess
import sys
import time

from splatview_tools import PROGRAM, Picture, SplatviewTest, main

OPTIONS = (
    "--iso --particles --spacing --magnify --array --normals --project --radius-scale --color --opacity"
    " --background --camera --size --scalar-bar --unlit --lit --shadows --target-error --method"
    " --transparency --layers --projection --output --json --frames --quiet --help --version"
    " --append --convert --points"
).split()
FLAGS = {
    "--particles", "--project", "--scalar-bar", "--unlit", "--lit", "--quiet", "--help", "--version",
    "--append", "--convert"
}  # fmt: skip

# A tetrahedron's corners, with its outward normals.
CLOUD = "".join(
    f"{x} {y} {z} {x * 3 ** -0.5} {y * 3 ** -0.5} {z * 3 ** -0.5}\n"
    for x, y, z in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
)
VOLUME = (
    b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 12 12 12\nencoding: raw\n\n"
    + bytes(20 * x for x in range(12)) * 144
)

BAD_OPTIONS = (
    "--nonsense", "-x", "--iso", "--iso abc", "--iso 1,,2", "--iso 1,", "--iso inf", "--iso=",
    "--spacing 0", "--spacing -1", "--magnify 0", "--magnify 1.5", "--normals both",
    "--radius-scale 0", "--radius-scale 30", "--color nosuch", "--color 1,2,3", "--color 1,1", "--color #12345g",
    "--color red;", "--opacity 1.1", "--opacity -1", "--background x", "--camera 1",
    "--camera 0,0,0", "--camera 0,0,0,0,0,0,0,0,1", "--camera 0,0,0,0,0,1,0,0,2",
    "--camera 0,0,0,0,0,1,0,1,0,180", "--size 10", "--size 0x10", "--size 10x10x10",
    "--size 99999x1", "--target-error 2", "--target-error -1", "--method best", "--transparency x", "--layers 0", "--shadows 0",
    "--points 0", "--append", "--convert",
    "--projection x", "--output o.jpg", "--output .png",
    "--output no/such/folder/o.png", "--json no/such/folder/r.json", "--frames 0",
    "--quiet=yes", "--scalar-bar", "--array nosuch", "--iso 5", "--particles=yes", "--unlit=yes",
)  # fmt: skip

TEXT_MHD = """ObjectType = Image
NDims = 3
DimSize = 4 4 4
ElementType = MET_UCHAR
ElementDataFile = nosuch.raw
"""
BROKEN_FILES = {
    "short.xyz": "1 2 3\n4 5\n",
    "words.xyz": "1 2 3\n4 five 6\n",
    "two.xyz": "1 2\n3 4\n",
    "counts.pts": "2\n2\n",
    "text.h5": "1 2 3\n",
    "short.ply": "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\n"
    "property float y\nproperty float z\nend_header\n1 2 3\n",
    "type.ply": "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n1\n",
    "flat.ply": "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
    "count.ply": "ply\nformat ascii 1.0\nelement vertex -1\nproperty float x\nend_header\n",
    "format.ply": "ply\nformat text 1.0\nelement vertex 0\nend_header\n",
    "header.ply": "ply\nformat ascii 1.0\nelement vertex 1\n",
    "none.ply": "ply\nformat ascii 1.0\nend_header\n",
    "binary.ply": b"ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
    b"property float y\nproperty float z\nend_header\n" + bytes(20),
    "short.nrrd": VOLUME[:-1],
    "raw.mhd": TEXT_MHD,
    "short.vtk": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 9 float\n1 2 3\n",
    "table.vtk": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET RECTILINEAR_GRID\n"
    "DIMENSIONS 2 2 2\nX_COORDINATES 2 float\n0 1\nY_COORDINATES 2 float\n0 1\nZ_COORDINATES 2 float\n0 1\n",
    "empty.vtm": '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet/>'
    "</VTKFile>",
    "sizes.nrrd": b"NRRD0004\ntype: uchar\ndimension: 3\nencoding: raw\n\n0123",
    "flat.nrrd": b"NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 2\nencoding: raw\n\n0123",
    "unknown.kind": "1 2 3\n",
    "plain": "1 2 3\n",
}
KINDS = "csv mha mhd nhdr nrrd obj ply pts stl txt vti vtk vtm vtp vts vtu xyz".split()


class TestSplatviewCommand(SplatviewTest):
    def test_help_names_every_option(self):
        done = self.run_splatview("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        named = set(re.findall(r"(?<![\w-])--[a-z-]+", done.stdout))
        self.assertEqual(named, set(OPTIONS))
        for kind in KINDS:
            self.assertIn(f".{kind}", done.stdout)
        self.assertTrue(all(len(line) <= 100 for line in done.stdout.splitlines()))

    def test_every_option_of_the_help_is_known(self):
        for option in set(OPTIONS) - FLAGS:
            self.assertIn(f"{option}: needs a value", self.assert_refused(option))

    def test_version(self):
        done = self.run_splatview("--version")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\Asplatview \d+\.\d+\.\d+ with VTK \d+\.\d+\.\d+\n\Z")

    def test_bad_options(self):
        self.write("cloud.xyz", CLOUD)
        for case in BAD_OPTIONS:
            option, _, value = case.partition(" ")
            line = self.assert_refused(option, *([value] if value else []), "cloud.xyz")
            if case not in ("-x", "--iso 5", "--array nosuch") and "folder" not in case:
                self.assertIn(option.partition("=")[0], line)

    def test_isovalue_out_of_range_says_the_range(self):
        self.write("volume.nrrd", VOLUME)
        self.assertIn("from 0 to 220", self.assert_refused("volume.nrrd", "--iso", "230"))

    def test_unknown_array_says_which_there_are(self):
        self.write("cloud.xyz", CLOUD)
        self.assertIn("Normals", self.assert_refused("cloud.xyz", "--array", "x"))

    def test_particles_have_no_isovalue(self):
        self.write("cloud.xyz", CLOUD)
        self.assertIn("--iso", self.assert_refused("cloud.xyz", "--particles", "--iso", "1"))

    def test_missing_empty_garbled_and_folder(self):
        for kind in KINDS:
            self.assert_refused(f"missing.{kind}")
            self.assert_refused(self.write(f"empty.{kind}", ""))
            self.assert_refused(self.write(f"garbled.{kind}", b"garbage \x01\xff\x00\nmore\n"))
            os.mkdir(self.path(f"folder.{kind}"))
            self.assert_refused(f"folder.{kind}")

    def test_broken_files(self):
        for name, content in BROKEN_FILES.items():
            self.assertIn(name, self.assert_refused(self.write(name, content)))

    def test_scans_are_left_to_the_package(self):
        """The refusal names a command, which is one that the package has."""
        for name in ("scan.las", "two words.LAZ", "a.b.copc.laz", "scan.e57"):
            said = self.assert_refused(self.write(name, "no scan\n"))
            command = shlex.split(re.search(r"python3( -m pointsplatting\.convert .*) makes", said)[1])
            self.assertEqual(command[2:], [name, name.rpartition(".")[0] + ".vtp"])
            # laspy and pye57 may be here or not: such a file is none that they read.
            done = subprocess.run([sys.executable, *command], cwd=self.folder, text=True,
                                  capture_output=True, timeout=100, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, ""), name)
            self.assertRegex(done.stderr, rf"\A[^\n]*{re.escape(name)}[^\n]*\n\Z")
            self.assertFalse(os.path.exists(self.path(command[3])))
        self.write("cloud.xyz", CLOUD)
        subprocess.run([sys.executable, "-m", "pointsplatting.convert", "cloud.xyz", "cloud.vtp"],
                       cwd=self.folder, stdout=subprocess.DEVNULL, timeout=100, check=True)
        of_text, of_vtp = (self.draw(f"cloud.{kind}")[0]["surfaces"][0] for kind in ("xyz", "vtp"))
        self.assertEqual(of_vtp["points"], of_text["points"])

    def test_text_that_cannot_be_told(self):
        for name, content, why in (
            ("commas.csv", "1,05,2,50,3,25\n2,00,3,50,4,10\n", "semicolons"),
            ("thousands.csv", "1.234,5;2;3\n4;5;6\n", "'1.234,5'"),
            ("promise.pts", "1000000000000\n1 2 3\n4 5 6\n7 8 9\n", "1000000000000"),
            ("part.pts", "2\n1 2 3\n4 5 6\n2\n7 8 9\n", "promises 2"),
            ("wide.txt", "1 2 3\n".encode("utf-16"), "UTF-16"),
        ):
            line = self.assert_refused(self.write(name, content))
            self.assertIn(why, line)

    def test_faces_of_points_that_are_not_there(self):
        side = 6
        points = [(x, y, 0.1 * x * y) for x in range(side) for y in range(side)]
        cells = [
            (side * i + j, side * i + j + side, side * i + j + side + 1)
            for i in range(side - 1) for j in range(side - 1)
        ]  # fmt: skip
        xyz = "".join(f"{x} {y} {z}\n" for x, y, z in points)

        def ply(bad, count="uchar"):
            lists = "".join(f"{len(c)} {' '.join(map(str, c))}\n" for c in [*cells, *bad])
            return (
                f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\n"
                f"property float y\nproperty float z\nelement face {len(cells) + len(bad)}\n"
                f"property list {count} int vertex_indices\nend_header\n{xyz}{lists}"
            )

        def binary(count):
            head, _ = ply([], "uint").replace("ascii", "binary_little_endian").split("end_header")
            return (
                f"{head}end_header\n".encode()
                + b"".join(struct.pack("<3f", *p) for p in points)
                + struct.pack("<I3i", count, 0, 1, 2)
            )

        def obj(corners, before="vn 0 0 1\nvt 0 0\n"):
            given = "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in cells)
            return "v " + "\nv ".join(xyz.split("\n")[:-1]) + f"\n{before}{given}f {corners}\n"

        def legacy(kind):
            kinds = "CELL_TYPES 1\n5\n" if kind == "CELLS" else ""
            grid = "UNSTRUCTURED_GRID" if kind == "CELLS" else "POLYDATA"
            return (
                f"# vtk DataFile Version 3.0\nx\nASCII\nDATASET {grid}\nPOINTS {len(points)} float\n"
                f"{xyz}{kind} 1 4\n3 1 2 999999\n{kinds}"
            )

        for name, content in {
            "far.ply": ply([(1, 2, 99999999)]),
            "negative.ply": ply([(1, 2, -7), (0, 1)]),
            "all.ply": ply([(100, 200, 300)] * 9),
            "far.vtk": legacy("POLYGONS"),
            "grid.vtk": legacy("CELLS"),
        }.items():
            done = self.run_splatview(self.write(name, content), "--output", "o.png")
            self.assertEqual(done.returncode, 0, (name, done))
            self.assertIn(f"{len(points)} points", done.stdout)
            self.assertRegex(done.stderr, r"\Asplatview: warning: [^\n]* not there[^\n]*\n\Z", name)
            os.remove(self.path("o.png"))
        for name, content in {
            "count.ply": ply([], "uint").replace("\n3 0 6 7", "\n4000000000 0 6 7"),
            "binary.ply": binary(4294967295),
            "negative.ply": binary(3).replace(b"uint int", b"int int").replace(
                struct.pack("<I3i", 3, 0, 1, 2), struct.pack("<i3i", -3, 0, 1, 2)),
            "far.obj": obj("1 2 999"),
            "zero.obj": obj("0 1 2"),
            "negative.obj": obj("-1 -2 -99"),
            "normal.obj": obj("1//1 2//1 3//7"),
            "texture.obj": obj("1/1 2/1 3/5"),
            "overflow.obj": obj("1 2 99999999999999999999"),
            "slash.obj": obj("1/ 2/ 3/"),
            "word.obj": obj("1 2 x"),
            "continued.obj": obj("1 2 \\\n 999"),
        }.items():  # fmt: skip
            self.assertIn(name, self.assert_refused(self.write(name, content)))
        for corners in ("-1 -2 -3", "1 2 \\\n 3"):
            self.write("good.obj", obj(corners, ""))
            done = self.run_splatview("good.obj", "--output", "o.png")
            self.assertEqual((done.returncode, done.stderr), (0, ""), corners)
        # With a normal that no face names.
        done = self.run_splatview(self.write("more.obj", obj("1 2 3")), "--output", "o.png")
        self.assertEqual(done.returncode, 0)
        self.assertIn("point array Normals has 1 tuples", done.stderr)

    def test_good_file_does_not_hide_a_bad_one(self):
        self.write("cloud.xyz", CLOUD)
        self.assert_refused("cloud.xyz", "missing.ply")

    def test_refusal_keeps_what_was_there(self):
        self.write("r.json", "mine")
        self.assert_refused("missing.ply", "--json", "r.json")
        with open(self.path("r.json"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")

    def test_one_line_without_terminal_and_none_when_quiet(self):
        self.write("cloud.xyz", CLOUD)
        done = self.run_splatview("cloud.xyz", "--output", "o.png", "--size", "64x48")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\A4 points in 1 surface, two-pass by .* o\.png\n\Z")
        picture = Picture(self.path("o.png"))
        self.assertEqual((picture.width, picture.height), (64, 48))
        done = self.run_splatview("cloud.xyz", "--output", "o.png", "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_progress_on_a_terminal(self):
        self.write("volume.nrrd", VOLUME)
        for quiet, wanted in ((("--quiet",), False), ((), True)):
            ours, theirs = pty.openpty()
            subprocess.run(
                [PROGRAM, "volume.nrrd", "--iso", "100", "--output", "o.png", *quiet],
                cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL, stderr=theirs,
                timeout=100, check=True,
            )  # fmt: skip
            os.write(theirs, b".")  # so that there is something to read
            os.close(theirs)
            text = os.read(ours, 65536).decode()
            os.close(ours)
            self.assertEqual("isosurface" in text and "%" in text, wanted, text)

    def test_says_so_where_there_is_no_driver(self):
        self.write("cloud.xyz", CLOUD)
        self.environment["__EGL_VENDOR_LIBRARY_FILENAMES"] = "/nosuch.json"
        done = self.run_splatview("cloud.xyz", "--output", "o.png")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"\Asplatview: No OpenGL context [^\n]+\n\Z")
        self.assertFalse(os.path.exists(self.path("o.png")))

    def test_writes_a_picture_where_there_is_no_display(self):
        self.write("cloud.xyz", CLOUD)
        for display in (None, "", ":4711"):  # of which no server is
            if display is not None:
                self.environment["DISPLAY"] = display
            done = self.run_splatview("cloud.xyz")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("splatview.png", done.stdout)
            os.remove(self.path("splatview.png"))

    def test_opens_a_window_where_there_is_a_display(self):
        server = shutil.which("Xvfb")
        if not server:
            self.skipTest("no Xvfb here")
        read, write = os.pipe()
        x = subprocess.Popen(
            [server, "-displayfd", str(write), "-screen", "0", "640x480x24", "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(write)
        try:
            self.environment["DISPLAY"] = ":" + os.read(read, 16).decode().strip()
            self.write("cloud.xyz", CLOUD)
            viewer = subprocess.Popen(
                [PROGRAM, "cloud.xyz", "--size", "64x64"], cwd=self.folder, env=self.environment,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            )  # fmt: skip
            line = viewer.stdout.readline()
            time.sleep(0.5)
            self.assertIn("4 points", line)
            self.assertNotIn("written", line)
            self.assertIsNone(viewer.poll())  # it waits for its user
            viewer.kill()
            self.assertEqual(viewer.communicate()[1], "")
            self.assertEqual(os.listdir(self.folder), ["cloud.xyz"])
        finally:
            x.terminate()
            x.wait()
            os.close(read)


if __name__ == "__main__":
    main()
