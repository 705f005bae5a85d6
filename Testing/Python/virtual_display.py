# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""For tests that need an X server: one of their own, a user's hands, and a look at the screen."""
import ctypes
import ctypes.util
import os
import shutil
import struct
import subprocess
import tempfile
import time


def is_available():
    return bool(shutil.which("Xvfb"))


class VirtualDisplay:
    """A screen that nobody sees, while in its context."""

    def __init__(self, width=800, height=600):
        self.width, self.height = width, height

    def __enter__(self):
        self.folder = tempfile.mkdtemp(prefix="screen-")
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-fbdir", self.folder, "-noreset", "-nolisten", "tcp",
             "-screen", "0", f"{self.width}x{self.height}x24"],
            pass_fds=[write], stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(write)
        with os.fdopen(read) as pipe:
            self.name = ":" + pipe.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
        shutil.rmtree(self.folder)

    def environment(self):
        return {**os.environ, "DISPLAY": self.name}

    def screen(self):
        """The pixels' bytes, row by row from the top, four a pixel: blue, green, red, nothing."""
        with open(os.path.join(self.folder, "Xvfb_screen0"), "rb") as file:
            dump = file.read()
        # An X window dump: numbers of 32 bits, the colours that its header counts, pixels.
        header = struct.unpack(">25I", dump[:100])
        width, height, stride, colours = header[4], header[5], header[12], header[19]
        assert (width, height, stride) == (self.width, self.height, 4 * self.width)
        start = header[0] + 12 * colours
        return dump[start : start + stride * height]

    def hands(self, *words):
        """What xdotool does; its output."""
        return subprocess.run(
            ["xdotool", *map(str, words)], env=self.environment(), capture_output=True, text=True,
            timeout=30, check=True,
        ).stdout  # fmt: skip

    def find_window(self, name):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            found = subprocess.run(
                ["xdotool", "search", "--onlyvisible", "--name", f"^{name}$"],
                env=self.environment(), capture_output=True, text=True, timeout=30, check=False,
            )  # fmt: skip
            if found.stdout.split():
                return int(found.stdout.split()[0])
            time.sleep(0.1)
        raise AssertionError(f"no window {name}")

    def close_window(self, window):
        """As a window manager does when its button is pressed, which xdotool cannot."""
        x = ctypes.CDLL(ctypes.util.find_library("X11"))
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XInternAtom.restype = ctypes.c_ulong
        display = ctypes.c_void_p(x.XOpenDisplay(self.name.encode()))

        class ClientMessage(ctypes.Structure):
            _fields_ = [
                ("type", ctypes.c_int),
                ("serial", ctypes.c_ulong),
                ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p),
                ("window", ctypes.c_ulong),
                ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int),
                ("data", ctypes.c_long * 5),
                ("rest", ctypes.c_long * 24),  # of the union of all events
            ]

        message = ClientMessage(type=33, display=display, window=window, format=32)
        message.message_type = x.XInternAtom(display, b"WM_PROTOCOLS", 0)
        message.data[0] = x.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        x.XSendEvent(display, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(message))
        x.XCloseDisplay(display)
