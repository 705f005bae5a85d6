# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""What splatview's options do to the picture and the report."""
import json
import math
import os

from splatview_tools import Picture, SplatviewTest, main

BACKGROUND = (26, 51, 102)  # 0.1, 0.2, 0.4


def globe(count=4000):
    """Points of the unit sphere: red where z > 0, else blue."""
    rows = []
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        angle = i * math.pi * (3 - math.sqrt(5))
        x, y = r * math.cos(angle), r * math.sin(angle)
        colour = "255 0 0" if z > 0 else "0 0 255"
        rows.append(f"{x} {y} {z} {x} {y} {z} {colour}\n")
    return "".join(rows)


def is_red(pixel):
    return pixel[0] > pixel[2] + 60


def is_blue(pixel):
    return pixel[2] > pixel[0] + 60


class TestSplatviewPicture(SplatviewTest):
    def setUp(self):
        super().setUp()
        self.write("globe.xyz", globe())

    def test_camera(self):
        def middle(*camera):
            return self.draw("globe.xyz", *camera)[1].centre()

        self.assertTrue(is_red(middle()))
        self.assertTrue(is_blue(middle("--camera", "180,0")))
        self.assertTrue(is_red(middle("--camera", "0,80")))
        self.assertTrue(is_blue(middle("--camera", "0,100")))
        self.assertTrue(is_blue(middle("--camera", "0,-100")))
        self.assertTrue(is_red(middle("--camera", "0,0,5,0,0,0,0,1,0")))
        self.assertTrue(is_blue(middle("--camera", "0,0,-5,0,0,0,0,1,0,20")))

    def test_view_from_the_pole_and_the_view_up(self):
        # From above, what looked to the viewer, z > 0, is below.
        picture = self.draw("globe.xyz", "--camera", "0,90")[1]
        self.assertTrue(is_red(picture.pixel(48, 35)))
        self.assertTrue(is_blue(picture.pixel(48, 60)))
        picture = self.draw("globe.xyz", "--camera", "0,5,0,0,0,0,1,0,0")[1]
        self.assertTrue(is_blue(picture.pixel(35, 48)))
        self.assertTrue(is_red(picture.pixel(60, 48)))

    def test_zoom_and_angle(self):
        def covered(*camera):
            pixels = self.draw("globe.xyz", "--camera", *camera)[1].pixels()
            return sum(p != BACKGROUND for p in pixels)

        self.assertAlmostEqual(covered("0,0,1.2") / covered("0,0"), 1.2**2, delta=0.15)
        wide = covered("0,0,9,0,0,0,0,1,0,40")
        narrow = covered("0,0,9,0,0,0,0,1,0,20")
        ratio = (math.tan(math.radians(20)) / math.tan(math.radians(10))) ** 2
        self.assertAlmostEqual(narrow / wide, ratio, delta=0.25)

    def test_background_size_and_radius(self):
        report, picture = self.draw("globe.xyz", "--size", "120x80")
        self.assertEqual((picture.width, picture.height), (120, 80))
        self.assertEqual(report["size"], [120, 80])
        self.assertEqual(picture.pixel(0, 0), BACKGROUND)
        for colour, wanted in (("#10f0a0", (16, 240, 160)), ("white", (255, 255, 255)),
                               ("0,.2,1", (0, 51, 255))):  # fmt: skip
            picture = self.draw("globe.xyz", "--background", colour)[1]
            self.assertEqual(picture.pixel(0, 0), wanted)
        small = self.draw("globe.xyz", "--radius-scale", "0.3")[0]["surfaces"][0]
        large = self.draw("globe.xyz")[0]["surfaces"][0]
        self.assertAlmostEqual(small["layer_distance"] / large["layer_distance"], 0.3, places=3)

    def test_opacity(self):
        black = ("--background", "black", "--color", "white")
        opaque = self.draw("globe.xyz", *black)[1].centre()[0]
        report, picture = self.draw("globe.xyz", *black, "--opacity", ".5")
        self.assertEqual(report["surfaces"][0]["opacity"], 0.5)
        self.assertGreater(opaque, 150)
        # Half of what is before, and at most a quarter of what is behind.
        self.assertGreaterEqual(picture.centre()[0], 0.5 * opaque - 3)
        self.assertLessEqual(picture.centre()[0], 0.75 * opaque + 3)

    def test_target_error_and_choices(self):
        best = self.draw("globe.xyz")[0]["surfaces"][0]["choices"]
        self.assertEqual(
            list(best),
            ["method", "projection", "transparency", "layers", "layer distance", "splats",
             "levels", "triangles", "outlines", "fill steps", "shadow samples", "points", "error allowed"],
        )  # fmt: skip
        self.assertRegex(best["method"], "^two-pass, no other takes less time")
        self.assertRegex(best["error allowed"], "^1/256, at rest")
        # What fewer lose is measured, and of coloured points that is more.
        fair = self.draw("globe.xyz", "--target-error", "0.02")[0]["surfaces"][0]
        self.assertRegex(fair["choices"]["splats"], "^one of 1, ")
        rough = self.draw("globe.xyz", "--target-error", "1")[0]["surfaces"][0]
        self.assertRegex(rough["choices"]["splats"], "^one of [2-9][0-9]*, fewer, larger ones")
        plain = [" ".join(line.split()[:6]) for line in globe().splitlines()]
        self.write("plain.xyz", "\n".join(plain) + "\n")
        rough = self.draw("plain.xyz", "--target-error", "1")[0]["surfaces"][0]
        self.assertRegex(best["splats"], "^one of 1, ")
        self.assertRegex(rough["choices"]["splats"], "^one of [2-9][0-9]*, fewer, larger ones")

    def test_lists_go_on_with_the_next_surface(self):
        files = ["globe.xyz"] * 3
        report, _ = self.draw(
            *files, "--color", "red", "--color=0,1,0;blue", "--opacity", "1", "--opacity", ".5,.25"
        )
        self.assertEqual(
            [s["color"] for s in report["surfaces"]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        )
        self.assertEqual([s["opacity"] for s in report["surfaces"]], [1, 0.5, 0.25])

    def test_method_and_projection(self):
        reference = self.draw("globe.xyz")[1]
        for projection in ("compute", "quads"):
            report, picture = self.draw("globe.xyz", "--projection", projection)
            self.assertEqual(report["surfaces"][0]["projection"], projection)
            self.assertLess(picture.difference(reference), 1.0)
        report, _ = self.draw("globe.xyz", "--method", "two-pass")
        self.assertEqual(report["surfaces"][0]["method"], "two-pass")
        report, picture = self.draw("globe.xyz", "--method", "deferred")
        self.assertEqual(report["surfaces"][0]["method"], "deferred")
        self.assertGreater(report["surfaces"][0]["groups"], 2)
        self.assertLess(picture.difference(reference), 2.0)
        report, picture = self.draw("globe.xyz", "--method", "image-space")
        self.assertEqual(report["surfaces"][0]["method"], "image-space")
        self.assertLess(picture.difference(reference), 8.0)

    def test_transparency(self):
        pictures = {}
        for kind in ("peeling", "sorted", "nearest-exact"):
            report, pictures[kind] = self.draw(
                "globe.xyz", "--opacity", "0.5", "--transparency", kind
            )
            self.assertEqual(report["surfaces"][0]["transparency"], kind)
        self.assertLess(pictures["sorted"].difference(pictures["peeling"]), 3.0)
        self.assertLess(pictures["nearest-exact"].difference(pictures["peeling"]), 3.0)
        report, one = self.draw("globe.xyz", "--opacity", "0.5", "--layers", "1")
        self.assertEqual(report["surfaces"][0]["layers"], 1)
        self.assertGreater(one.difference(pictures["peeling"]), 1.0)

    def test_shadows(self):
        report, plain = self.draw("globe.xyz")
        self.assertEqual(report["surfaces"][0]["shadow_samples"], 0)
        report, hard = self.draw("globe.xyz", "--shadows", "1")
        self.assertEqual(report["surfaces"][0]["shadow_samples"], 1)
        self.assertGreater(hard.difference(plain), 1.0)
        report, _ = self.draw("globe.xyz", "--shadows", "4")
        self.assertEqual(report["surfaces"][0]["shadow_samples"], 4)

    def test_array_and_scalar_bar(self):
        self.write(
            "heights.xyz",
            "".join(f"{x} {y} 0 {y}\n" for x in range(40) for y in range(40)),
        )
        plain = self.draw("heights.xyz")[1]
        picture = self.draw("heights.xyz", "--array", "Intensity")[1]
        low, high = picture.pixel(48, 20), picture.pixel(48, 75)
        self.assertGreater(low[0], low[2])  # VTK's own table: red is low, blue is high
        self.assertGreater(high[2], high[0])
        self.assertEqual(plain.pixel(48, 20), plain.pixel(48, 75))
        bar = self.draw("heights.xyz", "--array", "Intensity", "--scalar-bar")[1]
        changed = [
            i % 96 for i, (a, b) in enumerate(zip(picture.pixels(), bar.pixels())) if a != b
        ]
        self.assertGreater(len(changed), 50)
        self.assertGreater(min(changed), 60)  # it stands at the right

    def test_particles(self):
        """A ball of fluid is closed and smooth; a drop beside it is small, whatever is estimated."""
        rows = ["16 0 0\n"]
        for i in range(-8, 9):
            for j in range(-8, 9):
                rows += [f"{i} {j} {k}\n" for k in range(-8, 9) if i * i + j * j + k * k < 64]
        self.write("drop.xyz", "".join(rows))
        report, picture = self.draw("drop.xyz", "--particles", "--color", "1,1,1")
        (surface,) = report["surfaces"]
        self.assertEqual(surface["normals"], "density")
        self.assert_bounds(surface, (-8.0, 16.62, -8.0, 8.0, -8.0, 8.0), 0.7)
        covered = sum(p != BACKGROUND for p in picture.pixels())
        # Of the picture, as of a circle of radius 8 and one of 0.62.
        again = self.draw("drop.xyz", "--particles", "--color", "1,1,1", "--spacing", "0.15")[1]
        fine = sum(p != BACKGROUND for p in again.pixels())
        self.assertAlmostEqual(covered / fine, 1.0, delta=0.03)
        self.assertLess(picture.difference(again), 2.0)
        self.assertGreater(min(picture.centre()), 200)

    def test_unlit(self):
        # A red sphere, seen from the side: what is lit is darker at its rim.
        rows = [line.split()[:3] for line in globe().splitlines()]
        self.write("photo.xyz", "".join(" ".join(r) + " 200 100 50\n" for r in rows))
        unlit = [(200, 100, 50)] * 2

        def colours(*arguments):
            report, picture = self.draw(*arguments)
            half = picture.width // 2
            rim = max(x for x in range(half, picture.width) if picture.pixel(x, half)[0] > 40)
            return report["surfaces"][0]["lit"], [picture.centre(), picture.pixel(rim - 4, half)]

        self.assertEqual(colours("photo.xyz"), (False, unlit))
        self.assertEqual(colours("photo.xyz", "--unlit"), (False, unlit))
        for options in (("--lit",), ("--shadows", "1"), ("--normals", "estimate")):
            lit, (centre, rim) = colours("photo.xyz", *options)
            self.assertTrue(lit, options)
            self.assertLess(rim[0], centre[0] - 20, options)
        # Where there are normals, or no colours, light shows the surface.
        self.assertTrue(colours("globe.xyz")[0])
        self.assertFalse(colours("globe.xyz", "--unlit")[0])
        self.write("plain.xyz", "".join(" ".join(r) + "\n" for r in rows))
        self.assertTrue(colours("plain.xyz")[0])
        done = self.run_splatview("photo.xyz", "--frames", 1, "--output", "said.png")
        self.assertRegex(done.stdout, r"photo\.xyz: has colours and no normals, and is not lit")
        for picture in ("said.png", "o.png"):
            os.remove(self.path(picture))
        for other in (("--lit",), ("--shadows", "2")):
            refusal = self.assert_refused("photo.xyz", "--unlit", *other)
            self.assertIn("--unlit: goes without", refusal)

    def test_report(self):
        report, _ = self.draw("globe.xyz")
        self.assertEqual(report["points"], 4000)
        self.assertEqual(len(report["frames_ms"]), 1)
        self.assertEqual(report["median_frame_ms"], report["frames_ms"][0])
        self.assertGreater(report["median_frame_ms"], 0)
        self.assertRegex(report["vtk"], r"\A\d+\.\d+\.\d+\Z")
        self.assertTrue(report["opengl_renderer"])
        self.assertRegex(report["opengl_version"], r"\A\d\.\d")
        self.assertGreater(report["image_bytes"], 0)
        done = self.run_splatview("globe.xyz", "--frames", "4", "--json", "f.json", "--quiet")
        self.assertEqual(done.returncode, 0)
        with open(self.path("f.json"), encoding="utf-8") as file:
            times = json.load(file)
        self.assertEqual(len(times["frames_ms"]), 4)
        ordered = sorted(times["frames_ms"])
        self.assertAlmostEqual(times["median_frame_ms"], (ordered[1] + ordered[2]) / 2)

    def test_hydrogen(self):
        done = self.run_splatview("--size", "200x150", "--json", "r.json", "--frames", "1")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("in 3 surfaces", done.stdout)
        self.assertIn("written to hydrogen.png", done.stdout)
        with open(self.path("r.json"), encoding="utf-8") as file:
            report = json.load(file)
        outer, middle, inner = report["surfaces"]
        self.assertTrue(350000 < report["points"] < 550000, report["points"])
        self.assertTrue(outer["points"] > middle["points"] > inner["points"] > 10000)
        picture = Picture(self.path("hydrogen.png"))
        self.assertEqual((picture.width, picture.height), (200, 150))
        # The outer shells are cut open: all three colours are to be seen, the inner in the middle.
        pixels = [p for p in picture.pixels() if p != BACKGROUND]
        blue = sum(p[2] > p[1] > p[0] for p in pixels)
        green = sum(p[1] > p[2] and p[1] > p[0] for p in pixels)
        orange = sum(p[0] > p[1] > p[2] for p in pixels)
        self.assertGreater(min(blue, green, orange), 200)


if __name__ == "__main__":
    main()
