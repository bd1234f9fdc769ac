#include "composite.h"

#include <Eigen/Dense>

#include "elsie/physics/engine.h"

#include "eigen_vectors.h"

namespace elsie::physics {
namespace {

/// The inertia of a part about its middle, along the axes of its frame, kg m2.
Eigen::Matrix3d own_inertia(const Part& part) {
  Eigen::Vector3d moments = to_eigen(inertia_of(part.shape, part.mass));
  if (std::holds_alternative<WheelJoint>(part.joint)) {
    moments(static_cast<int>(part.shape.axis)) = 0.0;
  }
  return moments.asDiagonal();
}

}  // namespace

Composite composite_of(std::span<const Part> parts) {
  const Vector3& middle = parts.front().frame.origin;
  double mass = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Part& part : parts) {
    mass += part.mass;
    moment += part.mass * to_eigen(part.frame.origin - middle);
  }
  const Eigen::Vector3d center = moment / mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const Part& part : parts) {
    Eigen::Matrix3d turned;
    turned << to_eigen(part.frame.forward), to_eigen(part.frame.left), to_eigen(part.frame.up);
    const Eigen::Vector3d away = to_eigen(part.frame.origin - middle) - center;
    inertia +=
        turned * own_inertia(part) * turned.transpose() +
        part.mass * (away.squaredNorm() * Eigen::Matrix3d::Identity() - away * away.transpose());
  }
  const Eigen::Matrix3d inverse = inertia.inverse();
  return {mass,
          from_eigen(center),
          {from_eigen(inverse.row(0)), from_eigen(inverse.row(1)), from_eigen(inverse.row(2))}};
}

}  // namespace elsie::physics
