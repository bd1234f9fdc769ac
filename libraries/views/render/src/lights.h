// The lights of pictures for people, another for each pass: a point of the sun's disc, and a part
// of the sky.
#pragma once

#include <array>

#include "elsie/api/geometry.h"

namespace elsie::render {

using Matrix = std::array<float, 16>;  // by columns

/// Numbers in [0, 1)^2 that fill the square evenly, however many are taken (Roberts 2018, R2).
Vector2 spread(int index, double shift = 0.5);

/// The middle of the sun.
extern const Vector3 kSunDirection;
/// A point of the sun's disc.
Vector3 sun_at(int pass);
/// A direction of the sky, as often as a level face gets light from there.
Vector3 dome_at(int pass);
/// Of anything upright in the light of all of them, in lengths of it.
inline constexpr double kLongestShadow = 2.4;

/// Where shadows are seen, from the camera's place.
struct Room {
  Vector3 low, high;

  double widest() const;
};
/// Maps the room to a cube, seen from a light.
Matrix light_matrix(const Room& room, const Vector3& direction);
/// The same for looking things up in what the light has drawn: from 0 to 1.
Matrix as_texture(Matrix matrix);

}  // namespace elsie::render
