# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""The application's page: the picture, and a drawer with what can be set."""
from trame.ui.vuetify3 import SinglePageWithDrawerLayout
from trame.widgets import html
from trame.widgets import vtk as vtk_widgets
from trame.widgets import vuetify3 as v3

from . import web_geometry

# Names of target errors, as what they are the reciprocal of.
QUALITIES = [{"title": f"1/{value}", "value": value} for value in (256, 64, 32, 16)]


def build(server, window):
    """Make the page.

    Parameters
    ----------
    server : trame_server.Server
        The application's.
    window : vtkRenderWindow
        What is shown.
    """
    web_geometry.register()
    controller = server.controller
    with SinglePageWithDrawerLayout(server) as layout:
        layout.title.set_text("PointSplatting")
        layout.footer.hide()
        with layout.toolbar:
            v3.VSpacer()
            html.Div("{{ frame }}", classes="text-body-2 mx-4", id="frame")
            v3.VBtn("Reset", click=controller.reset, id="reset")
        with layout.drawer, v3.VContainer():
            v3.VAlert("{{ error }}", v_if="error", type="error", density="compact", id="error")
            v3.VSelect(label="File", v_model=("file",), items=("files",), density="compact",
                       id="file")
            v3.VSelect(label="Colour", v_model=("array",), items=("arrays",), density="compact",
                       id="array")
            with html.Div(v_for="surface, i in surfaces", key="i"):
                html.Div("{{ surface.name }}: opacity {{ surface.opacity.toFixed(2) }}",
                         classes="text-caption")
                v3.VSlider(model_value=("surface.opacity",), min=0.05, max=1, step=0.05,
                           density="compact", hide_details=True, classes="opacity",
                           end=(controller.set_opacity, "[i, $event]"))
            v3.VSwitch(label="Shadows", v_model=("shadows",), density="compact",
                       hide_details=True, id="shadows", color="primary")
            v3.VSelect(label="Target error", v_model=("target_error",),
                       items=("qualities", QUALITIES), density="compact", id="target_error")
            v3.VSwitch(label="Points, drawn by the browser", v_model=("local",),
                       density="compact", hide_details=True, id="local", color="primary")
            html.Div("{{ line }}", v_for="line, i in choices", key="i",
                     classes="text-caption choice")
        with layout.content, v3.VContainer(fluid=True, classes="pa-0 fill-height"):
            view = vtk_widgets.VtkRemoteLocalView(
                window, namespace="view", mode=("local ? 'local' : 'remote'", "remote"),
                interactive_ratio=1, interactive_quality=60, still_ratio=1, still_quality=95)
            controller.view_update = view.update
