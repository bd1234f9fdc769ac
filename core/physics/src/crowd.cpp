#include "crowd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/world/engine_facts.h"

namespace elsie::physics {
namespace {

// Twenty to and twenty fro carry a push through a row of as many robots.
constexpr int kSweeps = 40;

/// The inverse of an inertia that is diagonal in the frame of these axes.
std::array<Vector3, 3> inverse_inertia(const std::array<Vector3, 3>& axes, const Vector3& inertia) {
  const Vector3 weights{1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z};
  const auto row = [&](double x, double y, double z) {
    return (weights.x * x) * axes[0] + (weights.y * y) * axes[1] + (weights.z * z) * axes[2];
  };
  return {row(axes[0].x, axes[1].x, axes[2].x), row(axes[0].y, axes[1].y, axes[2].y),
          row(axes[0].z, axes[1].z, axes[2].z)};
}

std::array<Vector3, 3> axes_of(dBodyID body) {
  const dReal* r = dBodyGetRotation(body);
  return {{{r[0], r[4], r[8]}, {r[1], r[5], r[9]}, {r[2], r[6], r[10]}}};
}

/// As ODE integrates a body with finite rotation.
void move(dBodyID body, const Vector3& velocity, const Vector3& turning, double step) {
  const Vector3 at = to_vector(dBodyGetPosition(body)) + step * velocity;
  dBodySetPosition(body, at.x, at.y, at.z);
  dBodySetLinearVel(body, velocity.x, velocity.y, velocity.z);
  dBodySetAngularVel(body, turning.x, turning.y, turning.z);
  const double rate = std::sqrt(dot(turning, turning));
  if (rate == 0.0) return;
  const double half = 0.5 * rate * step;
  const Vector3 axis = (std::sin(half) / rate) * turning;
  const dQuaternion by{std::cos(half), axis.x, axis.y, axis.z};
  dQuaternion turned;
  dQMultiply0(turned, by, dBodyGetQuaternion(body));
  dBodySetQuaternion(body, turned);
}

}  // namespace

void Crowd::clear() {
  solver_.clear();
  places_.clear();
  moved_.clear();
  wheels_.clear();
}

int Crowd::add_rigid(dBodyID body) {
  ImpulseSolver::Body rigid;
  rigid.center = to_vector(dBodyGetPosition(body));
  rigid.velocity = to_vector(dBodyGetLinearVel(body));
  rigid.turning = to_vector(dBodyGetAngularVel(body));
  const bool gives_way = dBodyIsKinematic(body) == 0;
  if (gives_way) {
    dMass mass;
    dBodyGetMass(body, &mass);
    rigid.inverse_mass = 1.0 / mass.mass;
    rigid.inverse_inertia = inverse_inertia(axes_of(body), {mass.I[0], mass.I[5], mass.I[10]});
    rigid.velocity.z += physics_.step * physics_.gravity;
  }
  const int index = solver_.add(rigid);
  places_[body].body = index;
  if (gives_way) moved_.push_back({body, index, {}});
  return index;
}

void Crowd::add_box(dBodyID box) { add_rigid(box); }

void Crowd::add_robot(const OdeRobot& robot) {
  const OdeRobot::Parts parts = robot.parts();
  const Frame& frame = robot.state().frame;
  const Vector3 middle = to_vector(dBodyGetPosition(parts.chassis));
  const auto mass_of = [](dBodyID body) {
    dMass mass;
    dBodyGetMass(body, &mass);
    return mass;
  };
  // In the frame of the chassis. All is symmetrical, so that the center of mass is above or below
  // the middle, and the axes of inertia are those of the chassis. What a wheel weighs when it turns
  // about its axle is left to the wheel.
  const dMass chassis = mass_of(parts.chassis);
  Vector3 inertia{chassis.I[0], chassis.I[5], chassis.I[10]};
  struct Attached {
    dMass mass;
    Vector3 place;
  };
  std::array<Attached, 4> attached;
  double mass = chassis.mass, moment = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const dBodyID body = i < 2 ? parts.wheels[i] : parts.casters[i - 2];
    const Vector3 away = to_vector(dBodyGetPosition(body)) - middle;
    attached[i] = {mass_of(body),
                   {dot(away, frame.forward), dot(away, frame.left), dot(away, frame.up)}};
    mass += attached[i].mass.mass;
    moment += attached[i].mass.mass * attached[i].place.z;
  }
  const double up = moment / mass;
  inertia.x += chassis.mass * up * up;
  inertia.y += chassis.mass * up * up;
  for (std::size_t i = 0; i < 4; ++i) {
    const double m = attached[i].mass.mass;
    const Vector3& at = attached[i].place;
    const double z = at.z - up;
    inertia.x += m * (at.y * at.y + z * z);
    inertia.y += m * (at.x * at.x + z * z);
    inertia.z += m * (at.x * at.x + at.y * at.y);
    if (i < 2) {
      inertia.x += attached[i].mass.I[0];
      inertia.z += attached[i].mass.I[0];
    }
  }
  ImpulseSolver::Body rigid;
  const Vector3 from_middle = up * frame.up;
  rigid.turning = to_vector(dBodyGetAngularVel(parts.chassis));
  rigid.center = middle + from_middle;
  rigid.velocity = to_vector(dBodyGetLinearVel(parts.chassis)) + cross(rigid.turning, from_middle);
  rigid.velocity.z += physics_.step * physics_.gravity;
  rigid.inverse_mass = 1.0 / mass;
  rigid.inverse_inertia = inverse_inertia({frame.forward, frame.left, frame.up}, inertia);
  const int index = solver_.add(rigid);
  places_[parts.chassis].body = index;
  moved_.push_back({parts.chassis, index, -1.0 * from_middle});
  for (std::size_t i = 0; i < 2; ++i) {
    const double about_axle = attached[i].mass.I[10];
    const double rate = dot(frame.left, to_vector(dBodyGetAngularVel(parts.wheels[i])));
    const int spin = solver_.add(ImpulseSolver::Spin{rate, 1.0 / about_axle});
    places_[parts.wheels[i]] = {index, spin, to_vector(dBodyGetPosition(parts.wheels[i])),
                                frame.left, false};
    wheels_.push_back({parts.wheels[i], index, spin, frame.left});
    add_motor(parts, i, index, spin, frame.left);
    places_[parts.casters[i]].body = index;
    places_[parts.casters[i]].glides = true;
  }
  int front = index;
  const Frame* front_frame = &frame;
  for (const OdeSegment& segment : robot.segments()) {
    const int behind = add_rigid(segment.body());
    add_joint(segment, front, *front_frame, behind);
    front = behind;
    front_frame = &segment.state().frame;
  }
}

void Crowd::add_motor(const OdeRobot::Parts& parts, std::size_t wheel, int carrier, int spin,
                      const Vector3& axle) {
  Row motor;
  motor.a = carrier;
  motor.turn_a = -1.0 * axle;
  motor.spin_a = spin;
  motor.roll_a = 1.0;
  motor.target = dJointGetHingeParam(parts.motors[wheel], dParamVel);
  motor.softness = physics_.effective_cfm() / physics_.step;
  motor.upper = physics_.step * dJointGetHingeParam(parts.motors[wheel], dParamFMax);
  motor.lower = -motor.upper;
  solver_.add(motor);
}

void Crowd::add_joint(const OdeSegment& segment, int front, const Frame& front_frame, int body) {
  const double softness = physics_.effective_cfm() / physics_.step;
  const Frame& frame = segment.state().frame;
  const Vector3 at = segment.joint_place();
  const Vector3 from_front = at - solver_.body(front).center;
  const Vector3 from_body = at - solver_.body(body).center;
  const auto turn = [&](const Vector3& about) {
    Row row;
    row.a = body;
    row.b = front;
    row.turn_a = about;
    row.turn_b = -1.0 * about;
    row.softness = softness;
    return row;
  };
  for (const Vector3& direction : {frame.forward, frame.left, frame.up}) {
    Row row;
    row.a = body;
    row.b = front;
    row.linear = direction;
    row.turn_a = cross(from_body, direction);
    row.turn_b = -1.0 * cross(from_front, direction);
    row.softness = softness;
    solver_.add(row);
  }
  solver_.add(turn(cross(front_frame.up, frame.left)));  // no roll
  // The nearer end of what the joint can turn.
  const auto stop = [&](const Vector3& about, double angle, double limit) {
    Row row = turn((angle > 0.0 ? -1.0 : 1.0) * about);
    row.target = -(limit - std::abs(angle)) / physics_.step;
    row.lower = 0.0;
    solver_.add(row);
  };
  const SegmentState& state = segment.state();
  stop(front_frame.up, state.yaw_rad, segment.coupling().max_yaw_rad);
  stop(-1.0 * frame.left, state.pitch_rad, segment.coupling().max_pitch_rad);
}

Crowd::Row Crowd::row_along(const FoundContact& contact, const Vector3& direction) const {
  Row row;
  row.linear = direction;
  const Vector3 point = to_vector(contact.contact.geom.pos);
  const auto link = [&](dBodyID body, double side, int& index, int& spin, Vector3& turn,
                        double& roll) {
    if (!body) return;
    const Place& place = places_.at(body);
    index = place.body;
    const Vector3& center = solver_.body(index).center;
    const Vector3 along = side * direction;
    if (place.glides) {
      // A ball passes on what goes through its middle and nothing else.
      turn = cross(to_vector(dBodyGetPosition(body)) - center, along);
      return;
    }
    turn = cross(point - center, along);
    if (place.spin == ImpulseSolver::kNone) return;
    spin = place.spin;
    roll = dot(place.axle, cross(point - place.center, along));
    turn = turn - roll * place.axle;
  };
  link(contact.a, 1.0, row.a, row.spin_a, row.turn_a, row.roll_a);
  link(contact.b, -1.0, row.b, row.spin_b, row.turn_b, row.roll_b);
  return row;
}

double Crowd::normal_speed(const Row& row) const {
  // The velocities of bodies that give way have gravity's part of the step in them already.
  const auto velocity = [this](const ImpulseSolver::Body& body) {
    const double gained = body.inverse_mass > 0.0 ? physics_.step * physics_.gravity : 0.0;
    return body.velocity - Vector3{0.0, 0.0, gained};
  };
  double speed = 0.0;
  if (row.a != ImpulseSolver::kNone) {
    const ImpulseSolver::Body& a = solver_.body(row.a);
    speed += dot(row.linear, velocity(a)) + dot(row.turn_a, a.turning);
  }
  if (row.b != ImpulseSolver::kNone) {
    const ImpulseSolver::Body& b = solver_.body(row.b);
    speed += dot(row.turn_b, b.turning) - dot(row.linear, velocity(b));
  }
  return speed;
}

void Crowd::add_contact(const FoundContact& contact) {
  const dSurfaceParameters& surface = contact.contact.surface;
  const double step = physics_.step;
  const Vector3 normal = to_vector(contact.contact.geom.normal);
  Row row = row_along(contact, normal);
  row.lower = 0.0;
  row.softness = surface.soft_cfm / step;
  row.target = std::min(physics_.effective_erp() / step * contact.contact.geom.depth,
                        world::kMaxCorrectingSpeed);
  if (surface.mode & dContactMotionN) row.target += surface.motionN;
  if (surface.mode & dContactBounce) {
    const double coming = -normal_speed(row);
    if (coming > surface.bounce_vel) row.target = std::max(row.target, surface.bounce * coming);
  }
  const int normal_row = solver_.add(row);

  const auto glides = [this](dBodyID body) { return body && places_.at(body).glides; };
  if (glides(contact.a) || glides(contact.b)) return;
  Vector3 first = to_vector(contact.contact.fdir1);
  if (!(surface.mode & dContactFDir1)) {
    dVector3 p, q;
    dPlaneSpace(contact.contact.geom.normal, p, q);
    first = to_vector(p);
  }
  const auto rub = [&](const Vector3& along, double mu, double softness) {
    if (mu <= 0.0) return;
    Row friction = row_along(contact, along);
    friction.normal = normal_row;
    friction.mu = mu;
    friction.softness = softness / step;
    solver_.add(friction);
  };
  const double cfm = physics_.effective_cfm();
  rub(first, surface.mu, (surface.mode & dContactSlip1) ? surface.slip1 : cfm);
  rub(cross(normal, first), (surface.mode & dContactMu2) ? surface.mu2 : surface.mu,
      (surface.mode & dContactSlip2) ? surface.slip2 : cfm);
}

void Crowd::step() {
  solver_.solve(kSweeps);
  for (const Wheel& wheel : wheels_) {
    const Vector3& turning = solver_.body(wheel.carrier).turning;
    const double own = solver_.spin(wheel.spin).rate - dot(turning, wheel.axle);
    const Vector3 spin = turning + own * wheel.axle;
    dBodySetAngularVel(wheel.body, spin.x, spin.y, spin.z);
  }
  for (const Moved& moved : moved_) {
    const ImpulseSolver::Body& rigid = solver_.body(moved.index);
    move(moved.body, rigid.velocity + cross(rigid.turning, moved.middle), rigid.turning,
         physics_.step);
  }
}

}  // namespace elsie::physics
