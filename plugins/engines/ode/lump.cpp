#include "lump.h"

#include <Eigen/Dense>

#include "elsie/physics/engine.h"

#include "eigen_vectors.h"

namespace elsie::physics {
namespace {

/// The inertia of a part about its middle, along the axes of its frame, kg m2.
Eigen::Matrix3d own_inertia(const Part& part) {
  const Vector3& size = part.shape.size;
  const double m = part.mass;
  if (part.shape.kind == Shape::Kind::sphere) {
    return 0.4 * m * part.shape.radius() * part.shape.radius() * Eigen::Matrix3d::Identity();
  }
  if (part.shape.kind == Shape::Kind::box) {
    const Eigen::Array3d squares = to_eigen(size).array().square();
    return (m / 12.0 * (squares.sum() - squares)).matrix().asDiagonal();
  }
  const double r = part.shape.radius(), l = part.shape.length();
  if (part.shape.kind == Shape::Kind::capsule) {
    // A cylinder between two half balls, whose centers of mass are 3/8 r away from it.
    const double h = l - 2.0 * r;
    const double balls = m * 4.0 * r / (3.0 * h + 4.0 * r), between = m - balls;
    Eigen::Vector3d capsule =
        Eigen::Vector3d::Constant(between * (3.0 * r * r + h * h) / 12.0 +
                                  balls * (0.4 * r * r + 0.25 * h * h + 0.375 * h * r));
    capsule(static_cast<int>(part.shape.axis)) = (0.5 * between + 0.4 * balls) * r * r;
    return capsule.asDiagonal();
  }
  Eigen::Vector3d moments = Eigen::Vector3d::Constant(m * (3.0 * r * r + l * l) / 12.0);
  // Spinning wheels keep this part of the inertia for themselves.
  const bool spins = std::holds_alternative<WheelJoint>(part.joint);
  moments(static_cast<int>(part.shape.axis)) = spins ? 0.0 : 0.5 * m * r * r;
  return moments.asDiagonal();
}

}  // namespace

Lump lump_of(std::span<const Part> parts) {
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
