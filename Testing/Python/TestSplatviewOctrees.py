# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""splatview's files of points with levels of detail: written, added to, and drawn as the camera needs."""
import os
import shutil

from TestSplatviewPicture import globe
from splatview_tools import SplatviewTest, main


class TestOctrees(SplatviewTest):
    def convert(self, *arguments):
        done = self.run_splatview("--convert", *arguments)
        if "without HDF5" in done.stderr:
            self.skipTest("this VTK has no HDF5")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_octree_files(self):
        """Written of two files of other formats, drawn as they are, whole and by few splats."""
        lines = globe().splitlines()
        self.write("one.xyz", "\n".join(lines[::2]) + "\n")
        self.write("two.csv", "x,y,z,nx,ny,nz\n" + "\n".join(
            ",".join(line.split()[:6]) for line in lines[1::2]) + "\n")
        done = self.run_splatview("--convert", "one.xyz", "two.csv", "--output", "both.h5")
        if "without HDF5" in done.stderr:
            self.skipTest("this VTK has no HDF5")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"{len(lines)} points in 2 pieces, written to both.h5\n")
        self.assertFalse(os.path.exists(self.path("both.h5.part")))
        self.write("whole.xyz", globe())
        _, expected = self.draw("whole.xyz", "--color", "white")
        report, picture = self.draw("both.h5", "--color", "white")
        self.assertEqual(report["surfaces"][0]["points"], len(lines))
        self.assertLess(picture.difference(expected), 1)
        few = len(lines) // 3
        report, picture = self.draw("both.h5", "--color", "white", "--points", few)
        self.assertLessEqual(report["surfaces"][0]["points"], few)
        self.assertLess(picture.difference(expected), 4)

    def test_what_is_not_converted(self):
        self.write("one.xyz", globe())
        self.write("no.h5", "1 2 3\n")
        for arguments, what in (
                (("--convert", "one.xyz"), "--convert: needs files, and --output"),
                (("--convert", "--output", "a.h5"), "--convert: needs files, and --output"),
                (("one.xyz", "--output", "a.h5"), "does not end in .png"),
                (("--convert", "one.xyz", "no.xyz", "--output", "a.h5"), "no.xyz: cannot be opened"),
                (("--convert", "one.xyz", "--output", "no/a.h5"), "no/a.h5: cannot be written"),
                (("--convert", "one.xyz", "--append", "--output", "no.h5"), "no HDF5"),
                (("one.xyz", "--append"), "--append: goes with --convert"),
                (("no.h5",), "no HDF5"), (("one.xyz", "--points", "0"), "--points")):
            with self.subTest(arguments):
                done = self.run_splatview(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(what, done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), ["no.h5", "one.xyz"])

    def test_files_are_added(self):
        self.write("one.xyz", globe())
        count = len(globe().splitlines())
        self.convert("one.xyz", "--output", "scans.h5")
        shutil.copy(self.path("scans.h5"), self.path("first.h5"))
        said = self.convert("one.xyz", "one.xyz", "--append", "--output", "scans.h5")
        self.assertEqual(said, f"{3 * count} points in 3 pieces, written to scans.h5\n")
        self.assertEqual(sorted(os.listdir(self.folder)), ["first.h5", "one.xyz", "scans.h5"])
        report, picture = self.draw("scans.h5")
        self.assertEqual(report["surfaces"][0]["points"], 3 * count)
        self.assertIsNone(report["surfaces"][0]["points_in_file"])  # all are read
        self.assertLess(picture.difference(self.draw("first.h5")[1]), 1)
        # A file that is not read to its end changes nothing.
        before = os.path.getsize(self.path("scans.h5"))
        done = self.run_splatview(
            "--convert", "one.xyz", "no.xyz", "--append", "--output", "scans.h5")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(os.path.getsize(self.path("scans.h5")), before)

    def test_the_camera_chooses(self):
        """Few splats, and more of them where it looks: near by the picture is that of all points."""
        lines = []
        for i in range(120000):
            x, y = (i % 400) / 200 - 1, (i // 400) / 150 - 1
            bump = 0.3 * x * x * y
            lines.append(f"{x:.6f} {y:.6f} {bump:.6f} {-0.6 * x * y:.6f} {-0.3 * x * x:.6f} 1\n")
        self.write("sheet.xyz", "".join(lines))
        self.convert("sheet.xyz", "--output", "sheet.h5")
        for camera, most in (((0, 0, 4, 0, 0, 0, 0, 1, 0), 3), ((0.3, 0.2, 0.4, 0.3, 0.2, 0, 0, 1, 0), 1)):
            arguments = ("--camera", ",".join(map(str, camera)))
            _, best = self.draw("sheet.h5", *arguments)
            report, picture = self.draw("sheet.h5", "--points", 12000, *arguments)
            surface = report["surfaces"][0]
            self.assertLessEqual(surface["points"], 12000)
            self.assertEqual(surface["points_in_file"], 120000)
            self.assertEqual(surface["normals"], "file")
            self.assertLess(picture.difference(best), most)
        # By default all of the file is in sight, not only what is read.
        report, picture = self.draw("sheet.h5", "--points", 2000)
        self.assertLess(picture.difference(self.draw("sheet.h5")[1]), 4)
        done = self.run_splatview("sheet.h5", "--points", 2000, "--size", "64x64", "--output", "a.png")
        self.assertRegex(done.stdout, "^[0-9]+ splats for 120000 points in 1 surface, ")
        done = self.run_splatview("sheet.h5", "--points", 2000, "--array", "none")
        self.assertEqual(done.returncode, 2)
        self.assertIn("sheet.h5: has no point array 'none'", done.stderr)


if __name__ == "__main__":
    main()
