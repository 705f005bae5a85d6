# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats in a notebook that is executed: PyVista's backends, and what a browser shows of them."""
import base64
import os
import pathlib
import re
import tempfile
import time
import unittest

import browser
import nbformat
import numpy as np
import pyvista as pv
from nbclient import NotebookClient

SIZE = 300
SCENE = f"""
import pyvista as pv

cloud = pv.Sphere(theta_resolution=100, phi_resolution=100)
cloud["height"] = cloud.points[:, 2]


def plotter():
    pl = pv.Plotter(window_size=({SIZE}, {SIZE}))
    pl.background_color = "white"
    pl.splats.add(cloud, scalars="height", cmap="autumn", show_scalar_bar=False)
    return pl
"""
# A view of trame's that PyVista looks for and these backends do not use: when it is loaded it fetches
# a program from its makers' site, which a test is not to depend on.
SETUP = 'import sys; sys.modules["trame.widgets.vtklocal"] = None'
BACKENDS = ("static", "server", "trame", "client", "html")

# Draws a widget as notebooks do: by the module that comes with it (anywidget's front-end), of which models are asked.
RENDER = """
async ([shown, states]) => {
  const models = new Map();
  const manager = { get_model: async id => find(id) };
  const find = id => {
    if (!models.has(id)) {
      const nothing = () => {};
      models.set(id, { get: name => states[id][name], set: nothing, save_changes: nothing, on: nothing, off: nothing,
                       once: nothing, widget_manager: manager });
    }
    return models.get(id);
  };
  const code = new Blob([states[shown]._esm], { type: "text/javascript" });
  const module = await import(URL.createObjectURL(code));
  await module.default.render({ model: find(shown), el: document.body });
}
"""


def autumn(picture):
    """Which pixels have a colour of the map from red to yellow, lit."""
    red, green, blue = (picture[..., i] for i in range(3))
    return (red > 60) & (red >= green) & (blue < red // 3 + 10)


class TestNotebook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        os.environ.update(IPYTHONDIR=cls.folder.name, JUPYTER_CONFIG_DIR=cls.folder.name,
                          JUPYTER_RUNTIME_DIR=cls.folder.name)
        cells = [SETUP, SCENE, *(f'plotter().show(jupyter_backend="{one}")' for one in BACKENDS)]
        cls.notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell(source) for source in cells])
        client = NotebookClient(cls.notebook, timeout=120, kernel_name="python3",
                                resources={"metadata": {"path": cls.folder.name}})
        # The kernel stays, since it is what serves the views.
        kernel = client.setup_kernel()
        kernel.__enter__()
        cls.addClassCleanup(kernel.__exit__, None, None, None)
        for i, cell in enumerate(cls.notebook.cells):
            client.execute_cell(cell, i) # raises the cell's error
        cls.widgets = client.widget_state
        cls.browser = browser.start(cls.addClassCleanup)

    def outputs(self, backend):
        return self.notebook.cells[2 + BACKENDS.index(backend)].outputs

    def widget(self, backend):
        """What a cell displayed: the id of the widget's model, and the states of this and of those that it refers to."""
        shown = [output.data for output in self.outputs(backend) if "data" in output]
        self.assertEqual(len(shown), 1, self.outputs(backend))
        model = shown[0]["application/vnd.jupyter.widget-view+json"]["model_id"]
        ids = [model] + [value.removeprefix("IPY_MODEL_") for value in self.widgets[model].values()
                         if isinstance(value, str) and value.startswith("IPY_MODEL_")]
        return model, {one: self.widgets[one] for one in ids}

    def page_of(self, backend):
        """A page that holds the frame, as a notebook's does; troubles end the test."""
        page = self.browser.new_page(viewport={"width": SIZE + 20, "height": SIZE + 20})
        self.addCleanup(page.close)
        troubles = []
        # The page asks for a launcher first, which a kernel is not: trame's own server refuses.
        page.on("console", lambda said: troubles.append(said.text)
                if said.type == "error" and "/paraview" not in said.location["url"] else None)
        page.on("pageerror", lambda error: troubles.append(str(error)))
        self.addCleanup(lambda: self.assertEqual(troubles, []))
        page.set_content("<html><body></body></html>")
        page.evaluate(RENDER, self.widget(backend))
        self.assertEqual(page.locator("iframe").count(), 1)
        return page

    def picture(self, page, condition):
        """The page's picture, once it is as is wanted."""
        until = time.monotonic() + 60
        while True:
            picture = browser.screenshot(page, pathlib.Path(self.folder.name, "screen.png"))
            if condition(picture):
                return picture
            self.assertLess(time.monotonic(), until, "waited in vain")
            page.wait_for_timeout(500)

    def test_static(self):
        pictures = [output.data["image/png"] for output in self.outputs("static")
                    if "image/png" in output.get("data", {})]
        self.assertEqual(len(pictures), 1)
        file = pathlib.Path(self.folder.name, "static.png")
        file.write_bytes(base64.b64decode(pictures[0]))
        shown = pv.read(file).point_data.active_scalars[:, :3].astype(float)
        space = {}
        exec(SCENE, space)
        plotter = space["plotter"]()
        plotter.show(auto_close=False)
        wanted = plotter.screenshot(return_img=True)[::-1].reshape(-1, 3).astype(float)
        plotter.close()
        self.assertGreater(autumn(wanted.astype(int)).mean(), 0.2)
        self.assertEqual(shown.shape, wanted.shape)
        self.assertLess(np.mean((shown - wanted) ** 2), 255**2 / 1e4) # 40 dB

    def test_pictures_drawn_by_the_kernel(self):
        """The picture comes, and another one when it is dragged."""
        for backend in ("server", "trame"):
            with self.subTest(backend):
                page = self.page_of(backend)
                before = self.picture(page, lambda seen: autumn(seen).mean() > 0.1)
                # A disk: what splats cover has no holes.
                rows = autumn(before).nonzero()
                centre = [int(axis.mean()) for axis in rows]
                self.assertTrue(autumn(before[centre[0] - 20:centre[0] + 20,
                                              centre[1] - 20:centre[1] + 20]).all())
                page.mouse.move(centre[1], centre[0])
                page.mouse.down()
                page.mouse.move(centre[1] + 40, centre[0] + 120, steps=5)
                page.mouse.up()
                self.picture(page, lambda seen, before=before: (
                    np.abs(seen - before).max(axis=2) > 20).mean() > 0.02)

    def test_points_drawn_by_the_browser(self):
        for backend in ("client", "html"):
            with self.subTest(backend):
                page = self.page_of(backend)
                drawn = self.picture(page, lambda seen: autumn(seen).mean() > 0.005)
                self.assertLess(autumn(drawn).mean(), 0.5)

    def test_nothing_is_complained_of(self):
        for backend in BACKENDS:
            said = [output.text for output in self.outputs(backend)
                    if output.output_type == "stream"]
            self.assertFalse(re.search(r"(?i)error|warning", "".join(said)), said)


if __name__ == "__main__":
    unittest.main()
