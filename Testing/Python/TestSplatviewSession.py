# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""splatview as a user drives it: a window, mouse and keys, and an end without a crash."""
import contextlib
import math
import re
import shutil
import subprocess
import time
import unittest

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from splatview_tools import PROGRAM, SplatviewTest, main
from virtual_display import VirtualDisplay, is_available

GROUND = (102, 51, 26)  # blue, green, red: of splatview's background


def globe(turns=60, points=40):
    """A ball with a dent, so that it looks different when it is turned."""
    lines = []
    for i in range(turns):
        for j in range(2 * points):
            b, a = math.pi * (i + 0.5) / turns, math.pi * j / points
            r = 1.0 - 0.5 * math.exp(-8.0 * ((b - 1.2) ** 2 + (a - 1.0) ** 2))
            lines.append(
                f"{r * math.sin(b) * math.cos(a)} {r * math.sin(b) * math.sin(a)} {r * math.cos(b)}\n"
            )
    return "".join(lines)


def large_ball():
    """More points than are drawn at once."""
    source = vtkSphereSource()
    source.SetThetaResolution(1300)
    source.SetPhiResolution(900)
    source.Update()
    ball = vtkPolyData()
    ball.SetPoints(source.GetOutput().GetPoints())
    ball.GetPointData().SetNormals(source.GetOutput().GetPointData().GetNormals())
    return ball


@unittest.skipUnless(is_available() and shutil.which("xdotool"), "no Xvfb or no xdotool here")
class TestSession(SplatviewTest):
    @contextlib.contextmanager
    def session(self, *options, files=("globe.xyz",)):
        self.write("globe.xyz", globe())
        with VirtualDisplay() as display:
            viewer = subprocess.Popen(
                [PROGRAM, *files, "--size", "200x200", *options], cwd=self.folder,
                env=display.environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            )  # fmt: skip
            try:
                self.display = display
                self.first_line = viewer.stdout.readline()
                self.window = display.find_window(", ".join(files) + " - splatview")
                display.hands("windowfocus", self.window)
                yield viewer
            finally:
                if viewer.poll() is None:
                    viewer.kill()
                viewer.communicate()

    def assert_ends_well(self, viewer, told=""):
        out, err = viewer.communicate(timeout=60)
        self.assertEqual((viewer.returncode, err), (0, ""))
        self.assertRegex(out, "^" + told + "$")

    def covered(self, screen):
        """How many pixels of the window, at most 400 x 400, are the ball's."""
        count = 0
        for y in range(400):
            row = screen[4 * y * self.display.width :][: 4 * 400]
            for x in range(0, len(row), 4):
                b, g, r = row[x : x + 3]
                count += (b, g, r) != (0, 0, 0) and max(
                    abs(c - d) for c, d in zip((b, g, r), GROUND)
                ) > 8
        return count

    def wait_for(self, condition, what):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            screen = self.display.screen()
            if condition(screen):
                return screen
            time.sleep(0.1)
        raise AssertionError("in vain: " + what)

    def settled(self):
        """The screen when it has stood still."""
        last, since = self.display.screen(), time.monotonic()
        while time.monotonic() - since < 1.0:
            time.sleep(0.1)
            now = self.display.screen()
            if now != last:
                last, since = now, time.monotonic()
        return last

    def test_it_ends_by_key_and_by_its_button(self):
        for how in ("q", "e", "button"):
            with self.session() as viewer:
                self.assertIn("4800 points", self.first_line)
                if how == "button":
                    self.display.close_window(self.window)
                else:
                    self.display.hands("key", how)
                self.assert_ends_well(viewer)

    def test_an_hour_of_it(self):
        with self.session() as viewer:
            hands = self.display.hands
            before = self.wait_for(lambda s: 5000 < self.covered(s) < 39000, "a ball in the window")
            before = self.settled()

            hands("mousemove", "--window", self.window, 100, 100, "mousedown", 1)
            for step in range(1, 6):
                hands("mousemove", "--window", self.window, 100 + 12 * step, 100 + 4 * step)
            hands("mouseup", 1)
            turned = self.wait_for(lambda s: s != before, "another picture after a drag")
            turned = self.settled()
            self.assertLess(abs(self.covered(turned) / self.covered(before) - 1.0), 0.3)

            for _ in range(3):
                hands("click", 5)  # the wheel, away
            self.wait_for(lambda s: self.covered(s) < 0.8 * self.covered(turned), "smaller by wheel")
            hands("key", "r")
            self.wait_for(lambda s: self.covered(s) > 0.9 * self.covered(turned), "seen whole by r")

            hands("mousemove", "--window", self.window, 100, 100)
            for key in ("w", "s", "p", "3", "3", "j", "t", "h", "h", "F1", "Escape"):
                hands("key", key)
                self.settled()
                self.assertIsNone(viewer.poll(), key)
            # Where there is no point, so that few words are left on the screen.
            hands("mousemove", "--window", self.window, 2, 2)
            hands("key", "p")

            small = self.covered(self.settled())
            hands("windowsize", "--sync", self.window, 400, 400)
            self.wait_for(lambda s: self.covered(s) > 3 * small, "larger with its window")
            hands("windowsize", "--sync", self.window, 60, 40)
            self.settled()
            hands("windowsize", "--sync", self.window, 200, 200)
            self.settled()
            hands("key", "q")
            self.assert_ends_well(viewer, "globe.xyz: point [0-9]+, at .*\nno point here\n")

    def test_a_large_cloud_shows_at_once_and_is_there_later(self):
        ball = large_ball()
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(self.path("many.vtp"))
        writer.SetInputData(ball)
        writer.Write()
        for done in (False, True):
            with self.session(files=("many.vtp",)) as viewer:
                self.assertIn(f"{ball.GetNumberOfPoints()} points", self.first_line)
                first = self.wait_for(lambda s: self.covered(s) > 5000, "a ball in the window")
                if done:
                    # Outlines of all points are not quite those of some.
                    self.wait_for(lambda s: s != first, "another picture, though nobody moves")
                    self.display.hands("mousemove", "--window", self.window, 100, 100)
                    self.display.hands("mousedown", 1, "mousemove_relative", 20, 10, "mouseup", 1)
                    self.assertGreater(self.covered(self.settled()), 5000)
                self.display.hands("key", "q")
                self.assert_ends_well(viewer)

    def test_keys_are_listed_and_reach_the_property(self):
        with self.session("--size", "700x400") as viewer:
            hands = self.display.hands
            hands("mousemove", "--window", self.window, 690, 390)
            plain = self.settled()
            hands("key", "h")
            self.wait_for(lambda s: s != plain, "a list of keys")
            listed = self.settled()
            # The list tells the representation: its words change, whatever the surface does.
            def corner(screen):
                return b"".join(screen[4 * self.display.width * y :][: 4 * 420] for y in range(190))

            hands("key", "w")
            self.wait_for(lambda s: corner(s) != corner(listed), "wireframe in the list")
            hands("key", "s")
            self.wait_for(lambda s: s == listed, "the surface, and its name in the list")
            hands("key", "h")
            self.wait_for(lambda s: s == plain, "the list away")
            hands("key", "q")
            self.assert_ends_well(viewer)

    def test_a_point_is_told(self):
        self.write("colours.xyz", "".join(
            f"{x} {y} 0 {100 + x} {50 + y} 7\n" for y in range(21) for x in range(21)
        ))  # fmt: skip
        with self.session(files=["colours.xyz"]) as viewer:
            hands = self.display.hands
            hands("mousemove", "--window", self.window, 101, 99)
            before = self.settled()
            hands("key", "p")
            self.wait_for(lambda s: s != before, "the point on the screen")
            hands("mousemove", "--window", self.window, 2, 2)
            hands("key", "p")
            self.settled()
            hands("key", "q")
            self.assert_ends_well(
                viewer, "colours.xyz: point 220, at 10 10 0, (.*, )?RGB 110 60 7(, .*)?\nno point here\n"
            )

    def test_a_large_file_follows_the_camera(self):
        """Without a move of the user's there are smaller splats after the wheel has turned."""
        self.write("large.xyz", "".join(
            f"{0.01 * (i % 300)} {0.01 * (i // 300)} 0 0 0 1\n" for i in range(80000)
        ))  # fmt: skip
        done = self.run_splatview("--convert", "large.xyz", "--output", "large.h5")
        if "without HDF5" in done.stderr:
            self.skipTest("this VTK has no HDF5")
        with self.session("--points", "5000", files=["large.h5"]) as viewer:
            hands = self.display.hands
            self.assertRegex(self.first_line, "^[0-9]+ splats for 80000 points in ")
            hands("mousemove", "--window", self.window, 100, 60)  # above what is told
            self.settled()
            hands("key", "p")
            self.settled()
            for _ in range(12):
                hands("click", 4)  # the wheel, nearer
            self.settled()
            hands("key", "p")
            self.settled()
            hands("key", "q")
            out, err = viewer.communicate(timeout=60)
            self.assertEqual((viewer.returncode, err), (0, ""))
            radii = [float(r) for r in re.findall("SplatRadius ([-+.0-9e]+)", out)]
            self.assertEqual(len(radii), 2, out)
            self.assertLess(radii[1], 0.7 * radii[0])

    def test_a_legend_for_several_files(self):
        self.write("other.xyz", globe().replace("\n", " \n"))
        pictures = {}
        for files in (["globe.xyz"], ["globe.xyz", "other.xyz"]):
            with self.session("--size", "500x300", "--color", "#ff00ff;#00ffff", files=files):
                screen = self.settled()
                pictures[len(files)] = [
                    screen[4 * (y * self.display.width + x) :][:3]
                    for y in range(40) for x in range(320, 500)
                ]  # fmt: skip
        # Each file's colour, blue first, and no light on it.
        for colour in (b"\xff\x00\xff", b"\xff\xff\x00"):
            self.assertNotIn(colour, pictures[1])
            self.assertGreater(pictures[2].count(colour), 10)

    def test_frames_are_timed_for_a_report_only(self):
        with self.session():
            self.assertNotIn("ms a frame", self.first_line)
        with self.session("--json", "r.json", "--frames", "2"):
            self.assertRegex(self.first_line, re.compile(r"\d ms a frame$", re.MULTILINE))


if __name__ == "__main__":
    main()
