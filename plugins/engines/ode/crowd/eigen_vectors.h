// Vectors of Eigen.
#pragma once

#include <Eigen/Core>

#include "elsie/api/geometry.h"

namespace elsie::physics {

inline Eigen::Vector3d to_eigen(const Vector3& v) { return {v.x, v.y, v.z}; }
inline Vector3 from_eigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace elsie::physics
