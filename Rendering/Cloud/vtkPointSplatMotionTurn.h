// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Of vtkPointSplatMotion: how a splat turns with its surroundings, in single precision, since this is done for each splat of
// each frame.
#ifndef vtkPointSplatMotionTurn_h
#define vtkPointSplatMotionTurn_h

#include "vtkPointSplatCodes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace vtkPointSplatMotionTurn
{
inline glm::vec3 PositionOf(const uint32_t* splat)
{
  glm::vec3 p;
  std::memcpy(&p, splat, sizeof(p));
  return p;
}

inline float FloatOf(uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

inline uint32_t BitsOf(float value)
{
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// The nearest whole number; std::lrint() is a call.
inline int Round(float v)
{
  return static_cast<int>(v + std::copysign(0.5f, v));
}

///@{
/// As in vtkPointSplatOctahedron.glsl.
inline glm::vec3 Decode(uint32_t code)
{
  glm::vec3 n(static_cast<float>(static_cast<int16_t>(code & 0xffffu)),
    static_cast<float>(static_cast<int16_t>(code >> 16)), 0.0f);
  n *= 1.0f / 32767.0f;
  n.z = 1.0f - std::abs(n.x) - std::abs(n.y);
  const float fold = std::max(-n.z, 0.0f);
  n.x -= std::copysign(fold, n.x);
  n.y -= std::copysign(fold, n.y);
  return n * (1.0f / std::sqrt(glm::dot(n, n)));
}

inline uint32_t Code(glm::vec3 n)
{
  n *= 1.0f / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  glm::vec2 f(n.x, n.y);
  if (n.z < 0.0f)
  {
    f = { std::copysign(1.0f - std::abs(n.y), n.x), std::copysign(1.0f - std::abs(n.x), n.y) };
  }
  const auto quantise = [](float v) {
    return static_cast<uint32_t>(Round(v * 32767.0f)) & 0xffffu;
  };
  return quantise(f.x) | (quantise(f.y) << 16);
}
///@}

/**
 * Some basis with a normal as its third vector (Duff et al. 2017, Building an orthonormal basis, revisited).
 */
struct Basis
{
  explicit Basis(const glm::vec3& n)
    : N(n)
  {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    this->S = glm::vec3(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
    this->T = glm::vec3(b, sign + n.y * n.y * a, -n.y);
  }
  glm::vec3 In(const glm::vec3& v) const
  {
    return { glm::dot(v, this->S), glm::dot(v, this->T), glm::dot(v, this->N) };
  }

  glm::vec3 S, T, N;
};

/// The first of the tangents by which bend and lines are coded: across z, or x.
inline glm::vec3 TangentOf(const glm::vec3& n)
{
  const glm::vec3 s = std::abs(n.z) < 0.7f ? glm::vec3(n.y, -n.x, 0.0f) : glm::vec3(0.0f, n.z, -n.y);
  return s * (1.0f / std::sqrt(glm::dot(s, s)));
}

/**
 * How a point's surroundings moved: from one basis to another, turned about the normal, and stretched.
 */
struct Turn
{
  Turn(const Basis& from, const Basis& to, const glm::vec2& turn)
    : From(from)
    , To(to)
    , Stretch(std::sqrt(glm::dot(turn, turn)))
    , Cosine(turn.x / this->Stretch)
    , Sine(turn.y / this->Stretch)
  {
  }
  /// Turned, not stretched.
  glm::vec3 operator()(const glm::vec3& v) const
  {
    const glm::vec3 c = this->From.In(v);
    return (this->Cosine * c.x - this->Sine * c.y) * this->To.S +
      (this->Sine * c.x + this->Cosine * c.y) * this->To.T + c.z * this->To.N;
  }

  const Basis& From;
  const Basis& To;
  float Stretch, Cosine, Sine;
};

/// The bend, turned from some tangents to others, and enlarged with the radius.
inline uint32_t MoveBend(uint32_t code, const glm::vec2& angle, float enlarged)
{
  const auto element = [code](int shift) {
    return static_cast<float>(static_cast<int32_t>(code << (22 - shift)) >> 22);
  };
  const float a = element(0), b = element(10), d = element(20);
  const float c = angle.x, s = angle.y;
  const auto quantise = [enlarged](float v) {
    constexpr float steps = vtkPointSplatCodes::BendSteps;
    return static_cast<uint32_t>(Round(std::clamp(v * enlarged, -steps, steps))) & 1023u;
  };
  return quantise(c * c * a - 2.0f * c * s * b + s * s * d) |
    quantise(c * s * (a - d) + (c * c - s * s) * b) << 10 |
    quantise(s * s * a + 2.0f * c * s * b + c * c * d) << 20;
}

/// Words 4, 6 and 7 of a splat, whose normal is there, and its lines if it can have some. enlarged: by what its radius
/// is, beside the stretch.
inline void MoveShape(const uint32_t* rest, const uint32_t* restLines, const Turn& turn, float enlarged,
  uint32_t* to, uint32_t* lines)
{
  to[6] = rest[6];
  to[7] = rest[7];
  const bool flat = (rest[6] & vtkPointSplatCodes::BendMask) == 0u;
  const bool clipped = restLines && (restLines[0] | restLines[1] | restLines[2] | restLines[3]) != 0u;
  if (lines && !clipped)
  {
    std::fill_n(lines, 4, 0u);
  }
  if (rest[4] == rest[5] && flat && !clipped)
  {
    to[4] = to[5];
    return;
  }
  const glm::vec3 plane = Decode(rest[4]);
  // Tangents go by the coded plane.
  to[4] = rest[4] == rest[5] ? to[5] : Code(turn(plane));
  const glm::vec3 now = Decode(to[4]);
  const glm::vec3 tangent = TangentOf(now);
  const glm::vec3 turned = turn(TangentOf(plane));
  glm::vec2 angle(glm::dot(turned, tangent), glm::dot(turned, glm::cross(now, tangent)));
  angle /= std::max(std::sqrt(glm::dot(angle, angle)), 1e-6f);
  if (!flat)
  {
    to[6] = (rest[6] & ~vtkPointSplatCodes::BendMask) | MoveBend(rest[6], angle, enlarged);
  }
  for (int k = 0; k < 4 && clipped; k += 2)
  {
    const float u = FloatOf(restLines[k]) * enlarged, v = FloatOf(restLines[k + 1]) * enlarged;
    lines[k] = BitsOf(angle.x * u - angle.y * v);
    lines[k + 1] = BitsOf(angle.y * u + angle.x * v);
  }
}
}

#endif
