// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Display_h
#define Display_h

/**
 * Whether a window can be opened: on X11, whether the server that DISPLAY names
 * answers. VTK ends the program where it does not.
 */
bool HasDisplay();

#endif
