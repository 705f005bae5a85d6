  // SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
  // SPDX-License-Identifier: BSD-3-Clause
  // What vtkSSAOPass reads beside the colour: position and normal, view coordinates.
  gl_FragData[1] = vec4(positionVC.xyz, 1.0);
  gl_FragData[2] = vec4(normalVC, 1.0);
