# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds in a browser: `python -m pointsplatting.app FILE...`.

Frames are drawn here and sent as pictures. The browser gets the page and the pictures alone: of
the files that were named one is open at a time, and none is served.
"""
import argparse
import asyncio
import pathlib
import secrets
import sys
from urllib.parse import urlsplit

from .app_scene import Scene
from .reading import formats

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")


def parse(arguments=None):
    """Read the command line.

    Parameters
    ----------
    arguments : list of str, optional
        By default the program's.

    Returns
    -------
    argparse.Namespace
        With `files`, `host`, `port`, `iso` and `browser`.
    """
    parser = argparse.ArgumentParser(
        prog="python -m pointsplatting.app", description="Point clouds as surfaces, in a browser.")
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE",
                        help=f"what may be opened: {' '.join(formats())}")
    parser.add_argument("--host", default="127.0.0.1",
                        help="the address to listen on (default: %(default)s, this machine alone)")
    parser.add_argument("--port", type=int, default=8080,
                        help="the port to listen on; 0 for any that is free (default: %(default)s)")
    parser.add_argument("--iso", default="", metavar="A,B,...", help="isovalues of volumes")
    parser.add_argument("--no-browser", dest="browser", action="store_false",
                        help="do not open the page in this machine's browser")
    options = parser.parse_args(arguments)
    for file in options.files:
        if not file.is_file():
            parser.error(f"there is no file {file}")
    try:
        options.iso = [float(value) for value in options.iso.split(",") if value]
    except ValueError:
        parser.error(f"--iso takes numbers, not {options.iso!r}")
    return options


def is_own(headers, hosts):
    """Whether a request comes from this application's own page.

    Other pages in the same browser can reach this machine's ports. Such a request names another
    origin; or, where its address was made to lead here, another host.

    Parameters
    ----------
    headers : mapping
        The request's.
    hosts : sequence of str
        Names of this machine that are listened on; empty for any.

    Returns
    -------
    bool
        False for a request to be refused.
    """
    host = headers.get("Host", "")
    origin = headers.get("Origin")
    name = host.rpartition(":")[0] if not host.endswith("]") and ":" in host else host
    return (not hosts or name in hosts) and (origin is None or urlsplit(origin).netloc == host)


class App:
    """The application: a scene, and the page that shows it.

    Parameters
    ----------
    files : sequence of pathlib.Path
        What may be opened.
    isovalues : sequence of float, optional
        Of volumes.
    """

    def __init__(self, files, isovalues=()):
        try:
            from trame.app import get_server

            from .app_page import build
        except ImportError as error:
            raise ImportError(f"The application needs {error.name}, which is not here: "
                              "pip install 'pointsplatting[app]'.") from error
        self.scene = Scene()
        self.isovalues = isovalues
        self.files = {f"{i + 1}: {file.name}": file for i, file in enumerate(files)}
        self.server = get_server("pointsplatting", client_type="vue3")
        self.state, self.controller = self.server.state, self.server.controller
        self.state.update({"files": list(self.files), "file": next(iter(self.files)),
                           "error": "", "target_error": 256, "shadows": False, "local": False,
                           "choices": [], "frame": "", "surfaces": [], "arrays": []})
        self._again = False
        self._open(self.state.file)
        self.state.change("file")(self.on_file)
        self.state.change("array")(self.on_array)
        self.state.change("shadows")(self.on_shadows)
        self.state.change("target_error")(self.on_target_error)
        self.state.change("local")(lambda **_: self._draw())
        self.controller.set_opacity = self.set_opacity
        self.controller.reset = self.reset
        build(self.server, self.scene.window)

    def start(self, host, port, browser):
        """Listen, until the user ends the program.

        Parameters
        ----------
        host : str
            The address.
        port : int
            0 for any.
        browser : bool
            Whether the page is opened.
        """
        hosts = LOOPBACK if host in LOOPBACK else ()
        key = secrets.token_urlsafe()
        self.server.cli.set_defaults(authKey=key)

        def guard(server):
            from aiohttp import web

            # What the page asks first, as it would ask a launcher: where to connect, and the key.
            async def launch(request):
                scheme = "wss" if request.scheme == "https" else "ws"
                return web.json_response(
                    {"sessionURL": f"{scheme}://{request.host}/ws", "secret": key, "id": "1"})

            @web.middleware
            async def refuse_others(request, handler):
                if not is_own(request.headers, hosts):
                    raise web.HTTPForbidden(text="This page may not talk to the application.")
                return await handler(request)

            server.app.middlewares.append(refuse_others)
            server.app.router.add_post("/paraview/", launch)

        self.controller.on_server_bind.add(guard)
        self.controller.on_server_ready.add(self._watch)
        self.server.start(host=host, port=port, open_browser=browser, timeout=0,
                          show_connection_info=True)

    def reset(self):
        """Look at all of it."""
        self.scene.renderer.ResetCamera()
        self._draw()

    def set_opacity(self, index, opacity):
        """The page's slider of a surface was moved."""
        self.scene.set_opacity(index, opacity)
        self.state.surfaces[index]["opacity"] = opacity
        self.state.dirty("surfaces")
        self._draw()

    def on_file(self, file, **_):
        """Another file was chosen."""
        if file != self._opened:
            self._open(file)
            self._draw()

    def on_array(self, array, **_):
        """Another array was chosen."""
        self.scene.colour_by(array)
        self._draw()

    def on_shadows(self, shadows, **_):
        """Shadows were switched."""
        self.scene.set_shadows(shadows)
        self._draw()

    def on_target_error(self, target_error, **_):
        """Another quality was chosen."""
        self.scene.set_target_error(1 / target_error)
        self._draw()

    def _open(self, name):
        """A file that was named on the command line; what the browser asks for else is none."""
        self._opened = name
        try:
            if name not in self.files:
                raise ValueError("There is no such file here.")
            names = self.scene.open(self.files[name], self.isovalues)
            self.state.error = ""
        except (OSError, ValueError, ImportError) as error:
            self.state.error = str(error)
            return
        self.state.surfaces = [{"name": one, "opacity": 1.0} for one in names]
        self.state.arrays = self.scene.arrays()
        self.state.array = "RGB" if "RGB" in self.state.arrays else self.state.arrays[0]
        self.scene.colour_by(self.state.array)
        self.scene.set_shadows(self.state.shadows)
        self.scene.set_target_error(1 / self.state.target_error)

    def _draw(self):
        self._again = True
        if self.controller.view_update.exists():
            self.controller.view_update()

    def _watch(self, **_):
        """Tell the page of frames, but not so often that it costs frames."""

        async def watch():
            told = 0
            while True:
                await asyncio.sleep(0.5)
                # A picture whose compression took too long is not sent: it is there by now.
                if self._again:
                    self._again = False
                    self.controller.view_update()
                if self.scene.frames == told:
                    continue
                told = self.scene.frames
                seconds = max(self.scene.frame_time(), 1e-6)
                with self.state:
                    self.state.frame = f"{1000 * seconds:.0f} ms, {1 / seconds:.0f} frames a second"
                    self.state.choices = self.scene.choices()

        self._watching = asyncio.get_event_loop().create_task(watch())


def main(arguments=None):
    """Run the application.

    Parameters
    ----------
    arguments : list of str, optional
        By default the program's.
    """
    options = parse(arguments)
    try:
        app = App(options.files, options.iso)
    except ImportError as error:
        sys.exit(str(error))
    if app.state.error:
        print(app.state.error, file=sys.stderr)
    sys.argv = sys.argv[:1] # trame has a command line of its own
    app.start(options.host, options.port, options.browser)


if __name__ == "__main__":
    main()
