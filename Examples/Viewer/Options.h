// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// splatview's command line.
#ifndef Options_h
#define Options_h

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * What a user did wrong, in one line: exit code 2.
 */
struct UserError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Options
{
  std::vector<std::string> Files;
  std::vector<double> Isovalues;
  std::vector<double> Opacities;
  std::vector<std::array<double, 3>> Colours;
  double Spacing = 0.0;
  int Magnify = 1;
  std::array<int, 2> Size{ { 1024, 768 } };
  std::vector<double> Camera;
  std::array<double, 3> Background{ { 0.1, 0.2, 0.4 } };
  std::string Array;
  double TargetError = 1.0 / 256.0;
  std::string Method = "automatic";
  std::string Transparency = "automatic";
  int Layers = 32;
  int Shadows = 0; // samples of a lamp; 0: no lamp
  std::string Projection = "automatic";
  std::string Normals = "keep";
  double RadiusScale = 1.0;
  int Frames = 5;
  long MostPoints = 0; // of .h5 files; 0: as many as are usual
  bool Convert = false;
  bool AppendToFile = false; // to the file that is converted to
  bool Particles = false;
  bool Project = false;
  bool ScalarBar = false;
  bool Unlit = false;
  bool Lit = false;
  bool Quiet = false;
  bool InWindow = false; // the picture is shown, and not written
  bool Help = false;
  bool Version = false;
  std::string Output;
  std::string Json;

  /**
   * Throws UserError.
   */
  static Options Parse(int argc, char* argv[]);
  static std::string HelpText();
};

#endif
