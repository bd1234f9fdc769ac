// A vehicle as one rigid body.
#pragma once

#include <array>
#include <span>

#include "elsie/api/body.h"

namespace elsie::physics {

/// The rigid composite of a vehicle's parts. With the masses m_i of the parts, their middles c_i,
/// orientations R_i and moments of inertia I_i along their own axes, and d_i = c_i - c,
///
///   m = sum of m_i,   c = (sum of m_i c_i) / m,
///   I = sum of R_i I_i R_i' + m_i (|d_i|^2 E - d_i d_i')   (Huygens and Steiner).
///
/// The I_i of wheels lack the part about the axle: wheels spin on their own, and a row of the
/// solver has their rates as further unknowns.
struct Composite {
  double mass = 0.0;                         // kg
  Vector3 center;                            // m, from the middle of the chassis, in its frame
  std::array<Vector3, 3> inverse_inertia{};  // 1/(kg m2), rows, about the center
};

/// `parts` are those of one vehicle, the chassis first, its steering straight ahead.
Composite composite_of(std::span<const Part> parts);

}  // namespace elsie::physics
