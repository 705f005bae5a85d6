# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""A headless browser for tests, of the system's."""
import shutil

import numpy as np
import pyvista as pv
from playwright.sync_api import sync_playwright

PROGRAM = shutil.which("chromium") or shutil.which("google-chrome")


def start(clean_up):
    """Start it.

    Parameters
    ----------
    clean_up : callable
        A test's addCleanup, or a class's addClassCleanup, which ends it.

    Returns
    -------
    playwright.sync_api.Browser
        With WebGL on the CPU.
    """
    playwright = sync_playwright().start()
    clean_up(playwright.stop)
    browser = playwright.chromium.launch(
        executable_path=PROGRAM,
        args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"])
    clean_up(browser.close)
    return browser


def screenshot(page, file, **choices):
    """What a page shows, as integers of shape (height, width, 3)."""
    page.screenshot(path=file, **choices)
    image = pv.read(file)
    width, height, _ = image.dimensions
    return image.point_data.active_scalars.reshape(height, width, -1)[::-1, :, :3].astype(int)
