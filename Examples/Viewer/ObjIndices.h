// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ObjIndices_h
#define ObjIndices_h

#include <string>

/**
 * Throws UserError, which names the line, where a face, line or point of a Wavefront .obj file
 * names a vertex, texture coordinate or normal that is not there. Indices count from 1, and
 * negative ones back from the last that was given before.
 */
void CheckObjIndices(const std::string& file);

#endif
