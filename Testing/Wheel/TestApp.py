# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The application in a real browser: what its page shows, what it sends, and what it refuses."""
import http.client
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
import unittest

import browser
import numpy as np
import pyvista as pv

VIEW = {"x": 320, "y": 80, "width": 660, "height": 600}


class TestApp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        folder = pathlib.Path(cls.folder.name)
        ball = pv.Sphere(theta_resolution=200, phi_resolution=200)
        ball["height"] = ball.points[:, 2]
        ball.save(folder / "ball.vtp")
        pv.Wavelet().save(folder / "wavelet.vti")
        folder.joinpath("broken.vtp").write_text("none")
        folder.joinpath("secret.vtp").write_text("not named")
        cls.output = open(folder / "output.txt", "w+")
        cls.addClassCleanup(cls.output.close)
        cls.program = subprocess.Popen(
            [sys.executable, "-m", "pointsplatting.app", "ball.vtp", "wavelet.vti", "broken.vtp",
             "--port", "0", "--no-browser", "--iso", "100,150"],
            cwd=folder, stdout=cls.output, stderr=subprocess.STDOUT)
        cls.addClassCleanup(cls.program.wait)
        cls.addClassCleanup(cls.program.kill)
        until = time.monotonic() + 60
        address = None
        while address is None and time.monotonic() < until:
            said = folder.joinpath("output.txt").read_text()
            address = re.search(r"http://127\.0\.0\.1:(\d+)", said)
            time.sleep(0.1)
        if address is None:
            raise AssertionError(folder.joinpath("output.txt").read_text())
        cls.port = int(address.group(1))
        cls.browser = browser.start(cls.addClassCleanup)

    def setUp(self):
        self.page = self.browser.new_page(viewport={"width": 1000, "height": 700})
        self.addCleanup(self.page.close)
        self.troubles, self.frames = [], []
        self.page.on("console", lambda said: self.troubles.append(said.text)
                     if said.type in ("error", "warning") else None)
        self.page.on("pageerror", lambda error: self.troubles.append(str(error)))
        # A picture that the next one takes the place of is not loaded to its end.
        self.page.on("requestfailed", lambda request: self.troubles.append(request.url)
                     if not request.url.startswith("blob:") else None)
        self.page.on("request", lambda request: self.troubles.append(f"foreign: {request.url}")
                     if f"127.0.0.1:{self.port}" not in request.url else None)
        self.page.on("websocket", lambda socket: socket.on("framereceived", self.on_frame))
        self.page.goto(f"http://127.0.0.1:{self.port}/")
        self.wait_for(lambda: self.frames)
        # What a test sets stays with the application.
        self.page.evaluate("trame.state.update({file: '1: ball.vtp', array: 'one colour', "
                           "shadows: false, target_error: 256, local: false})")
        self.page.wait_for_timeout(1000)
        self.wait_for_picture()

    def tearDown(self):
        self.assertEqual(self.troubles, [])

    def on_frame(self, payload):
        """Pictures are what is sent in large pieces."""
        if isinstance(payload, bytes) and len(payload) > 2000:
            self.frames.append((time.monotonic(), len(payload)))

    def wait_for(self, condition, seconds=30):
        until = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), until, "waited in vain")
            self.page.wait_for_timeout(20)

    def picture(self):
        self.page.mouse.move(5, 5)
        self.page.wait_for_timeout(800)
        file = pathlib.Path(self.folder.name, "screen.png")
        return browser.screenshot(self.page, file, clip=VIEW).reshape(-1, 3)

    def wait_for_picture(self):
        """Where others use the machine, too, the page is there before anything is drawn."""
        self.wait_for(lambda: (self.picture() < 240).any())

    def assert_changes(self, before, least):
        """At least this part of the picture becomes another one."""
        for _ in range(20):
            changed = (np.abs(self.picture() - before).max(axis=1) > 10).mean()
            if changed > least:
                break
        self.assertGreater(changed, least)

    def choose(self, label, option):
        self.page.locator(".v-select", has_text=label).first.click()
        self.page.locator(".v-overlay .v-list-item", has_text=option).first.click()
        self.page.wait_for_timeout(800)

    def test_settings_change_the_picture(self):
        before = self.picture()
        covered = (before < 240).any(axis=1).mean()
        self.assertGreater(covered, 0.1)
        self.choose("Colour", "height")
        self.assert_changes(before, 0.1)
        before = self.picture()
        slider = self.page.locator(".opacity .v-slider-track").first.bounding_box()
        x, y = slider["x"] + slider["width"] * 0.3, slider["y"] + slider["height"] / 2
        self.page.mouse.click(x, y)
        self.assert_changes(before, 0.05)
        self.assertRegex(self.page.content(), r"opacity 0\.[23]")
        before = self.picture()
        self.page.locator("#shadows").click(force=True)
        self.assert_changes(before, 0.05)
        self.choose("Target error", "1/16")
        self.wait_for(lambda: "1/16" in " ".join(self.page.locator(".choice").all_inner_texts()))
        self.assertIn("method:", self.page.locator(".choice").first.inner_text())
        self.assertRegex(self.page.locator("#frame").inner_text(), r"\d+ ms, \d+ frames a second")

    def test_drag(self):
        """A drag is seen as it goes on; how soon, and what it costs, is told."""
        self.choose("Colour", "height")
        before = self.picture()
        x, y = VIEW["x"] + 330, VIEW["y"] + 300
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        delays, first = [], len(self.frames)
        for step in range(1, 31, 2):
            # Of moves a while apart the page passes on the second alone.
            self.page.mouse.move(x + step, y + 4 * step)
            self.page.wait_for_timeout(60)
            seen, moved = len(self.frames), time.monotonic()
            self.page.mouse.move(x + step + 1, y + 4 * step + 4)
            nudged = moved
            while len(self.frames) == seen:
                self.assertLess(time.monotonic() - moved, 30, "waited in vain")
                self.page.wait_for_timeout(20)
                # While a picture is on its way the page passes no move on, be it the last: a hand
                # that sees nothing happen goes on.
                if time.monotonic() - nudged > 1:
                    nudged = time.monotonic()
                    self.page.mouse.move(x + step + 2, y + 4 * step + 6)
                    self.page.mouse.move(x + step + 1, y + 4 * step + 4)
            delays.append(self.frames[seen][0] - moved)
            self.page.wait_for_timeout(400)
        self.page.mouse.up()
        sizes = [size for _, size in self.frames[first:]]
        self.assert_changes(before, 0.05)
        print(f"drag: latency {1000 * statistics.median(delays):.0f} ms (median of "
              f"{len(delays)}), {statistics.median(sizes) / 1024:.0f} kB a frame")
        self.assertLess(statistics.median(delays), 1.0)
        self.assertLess(statistics.median(sizes), 200 * 1024)

    def test_files(self):
        before = self.picture()
        self.choose("File", "wavelet")
        self.wait_for(lambda: "RTData = 150" in self.page.content())
        self.assert_changes(before, 0.05)
        self.choose("File", "broken")
        self.wait_for(lambda: "cannot be read" in self.page.content())
        self.choose("File", "ball")
        self.wait_for(lambda: "cannot be read" not in self.page.content())

    def test_points_drawn_by_the_browser(self):
        before = self.picture()
        self.page.locator("#local").click(force=True)
        self.page.wait_for_timeout(1500)
        self.wait_for_picture()
        after = self.picture()
        self.page.locator("#local").click(force=True)
        drawn = (after < 240).any(axis=1).mean()
        self.assertGreater(drawn, 0.01)
        self.assertLess(drawn, (before < 240).any(axis=1).mean())

    def request(self, path, headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port)
        connection.putrequest("GET", path, skip_host=bool(headers and "Host" in headers))
        for name, value in (headers or {}).items():
            connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, text

    def test_serves_no_file(self):
        folder = self.folder.name
        for path in ("/ball.vtp", "/secret.vtp", f"/{folder}/secret.vtp", "/../secret.vtp",
                     "/%2e%2e/%2e%2e/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd",
                     "/../../../../../../../../etc/passwd", f"/..{folder}/secret.vtp"):
            with self.subTest(path):
                status, text = self.request(path)
                self.assertIn(status, (400, 403, 404))
                self.assertNotIn(b"not named", text)
                self.assertNotIn(b"root:", text)
        # Nor does the page get the application to open one.
        self.page.evaluate("trame.state.set('file', '/etc/passwd')")
        self.wait_for(lambda: "There is no such file here" in self.page.content())
        self.page.evaluate("trame.state.set('file', '1: ball.vtp')")
        self.page.wait_for_timeout(500)

    def test_other_pages_are_refused(self):
        upgrade = {"Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                   "Sec-WebSocket-Key": "MTIzNDU2Nzg5MDEyMzQ1Ng=="}
        for headers in ({"Origin": "http://example.org"}, {"Origin": "null"},
                        {"Origin": f"http://127.0.0.1:{self.port + 1}"},
                        {"Host": f"example.org:{self.port}",
                         "Origin": f"http://example.org:{self.port}"}):
            with self.subTest(**headers):
                self.assertEqual(self.request("/ws", {**upgrade, **headers})[0], 403)

    def test_listens_on_the_loopback_address(self):
        wanted = f"{self.port:04X}"
        found = []
        for table in ("/proc/net/tcp", "/proc/net/tcp6"):
            for line in pathlib.Path(table).read_text().splitlines()[1:]:
                address, state = line.split()[1], line.split()[3]
                if address.endswith(":" + wanted) and state == "0A": # listens
                    found.append(address)
        self.assertEqual(found, [f"0100007F:{wanted}"])


class TestJupyter(unittest.TestCase):
    def test_what_pyvista_sends_to_a_browser(self):
        """PyVista's views that Jupyter shows: the splats' points, and the splats' picture."""
        from trame.app import get_server
        from trame.ui.vuetify3 import VAppLayout
        from trame_pyvista.widgets import PyVistaLocalView, PyVistaRemoteView
        from trame_vtk.modules.vtk.serializers import SynchronizationContext, serialize
        from trame_vtk.modules.vtk.serializers import initialize_serializers

        ball = pv.Sphere(theta_resolution=100, phi_resolution=100)
        plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
        actor = plotter.splats.add(ball, color="red")
        with VAppLayout(get_server("jupyter", client_type="vue3")):
            for view in (PyVistaRemoteView, PyVistaLocalView):
                view(plotter)
        plotter.show(auto_close=False)
        self.assertGreater(plotter.screenshot(return_img=True)[100, 100, 0], 100)
        initialize_serializers()
        context = SynchronizationContext()
        context.ignore_last_dependencies = True
        sent = serialize(actor, actor.mapper, "mapper", context, 0)
        self.assertEqual(sent["type"], "vtkMapper")
        vertices = sent["dependencies"][0]["properties"]["verts"]
        self.assertEqual(vertices["size"], ball.n_points + 1)
        self.assertNotIn("polys", sent["dependencies"][0]["properties"])
        plotter.close()


if __name__ == "__main__":
    unittest.main()
