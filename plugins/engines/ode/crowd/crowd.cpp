#include "crowd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/world/engine_facts.h"

namespace elsie::physics {
namespace {

// Twenty sweeps in each direction carry a push through a row of twenty robots.
constexpr int kSweeps = 40;

/// An inverse inertia given in the frame of these axes, in the world's frame.
std::array<Vector3, 3> in_the_world(const std::array<Vector3, 3>& axes,
                                    const std::array<Vector3, 3>& inverse_inertia) {
  const auto row = [&](double x, double y, double z) {
    const Vector3 weights =
        x * inverse_inertia[0] + y * inverse_inertia[1] + z * inverse_inertia[2];
    return weights.x * axes[0] + weights.y * axes[1] + weights.z * axes[2];
  };
  return {row(axes[0].x, axes[1].x, axes[2].x), row(axes[0].y, axes[1].y, axes[2].y),
          row(axes[0].z, axes[1].z, axes[2].z)};
}

std::array<Vector3, 3> axes_of(dBodyID body) {
  const dReal* r = dBodyGetRotation(body);
  return {{{r[0], r[4], r[8]}, {r[1], r[5], r[9]}, {r[2], r[6], r[10]}}};
}

/// Moves a body as ODE does with finite rotation.
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

/// Of an upright body, whose own z axis is a principal one.
std::array<Vector3, 3> inverse_inertia(const dMass& mass) {
  const double xx = mass.I[0], xy = mass.I[1], yy = mass.I[5], zz = mass.I[10];
  if (xy == 0.0) return {{{1.0 / xx, 0, 0}, {0, 1.0 / yy, 0}, {0, 0, 1.0 / zz}}};
  const double det = xx * yy - xy * xy;
  return {{{yy / det, -xy / det, 0}, {-xy / det, xx / det, 0}, {0, 0, 1.0 / zz}}};
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
  const bool is_dynamic = dBodyIsKinematic(body) == 0;
  if (is_dynamic) {
    dMass mass;
    dBodyGetMass(body, &mass);
    rigid.inverse_mass = 1.0 / mass.mass;
    rigid.inverse_inertia = in_the_world(axes_of(body), inverse_inertia(mass));
    if (dBodyGetGravityMode(body) != 0) rigid.velocity.z += physics_.step * physics_.gravity;
  }
  const int index = solver_.add(rigid);
  places_[body].body = index;
  if (is_dynamic) moved_.push_back({body, index, {}});
  return index;
}

void Crowd::add_obstacle(dBodyID box) { add_rigid(box); }

void Crowd::add_robot(const OdeRobot& robot) {
  int front = ImpulseSolver::kNone;
  const Frame* front_frame = nullptr;
  for (const OdeVehicle& vehicle : robot.vehicles()) {
    const int body = add_vehicle(vehicle);
    if (vehicle.hitch()) add_hitch(vehicle, front, *front_frame, body);
    front = body;
    front_frame = &vehicle.frame();
  }
}

int Crowd::add_vehicle(const OdeVehicle& vehicle) {
  const Frame& frame = vehicle.frame();
  const Composite& composite = vehicle.composite();
  const Vector3 from_middle = frame.direction(composite.center);
  ImpulseSolver::Body rigid;
  rigid.turning = vehicle.turning();
  rigid.center = vehicle.solids().chassis.shape.center + from_middle;
  rigid.velocity = vehicle.velocity() + cross(rigid.turning, from_middle);
  rigid.velocity.z += physics_.step * physics_.gravity;
  rigid.inverse_mass = 1.0 / composite.mass;
  rigid.inverse_inertia =
      in_the_world({frame.forward, frame.left, frame.up}, composite.inverse_inertia);
  const int index = solver_.add(rigid);
  places_[vehicle.chassis()].body = index;
  moved_.push_back({vehicle.chassis(), index, -1.0 * from_middle});
  for (std::size_t i = 0; i < vehicle.wheels().size(); ++i) {
    const OdeVehicle::Wheel& wheel = vehicle.wheels()[i];
    if (!wheel.motor) continue;
    const Cylinder& shape = vehicle.wheel_shapes()[i];
    const double rate = dot(shape.axis, to_vector(dBodyGetAngularVel(wheel.motor->body)));
    const int spin = solver_.add(ImpulseSolver::Spin{index, rate, 1.0 / wheel.about_axle});
    places_[wheel.motor->body] = {index, spin, shape.center, shape.axis, false};
    wheels_.push_back({wheel.motor->body, index, spin, shape.axis});
    add_motor(*wheel.motor, index, spin, shape.axis);
  }
  for (const dBodyID caster : vehicle.casters()) {
    places_[caster].body = index;
    places_[caster].glides = true;
  }
  return index;
}

void Crowd::add_motor(const OdeVehicle::Motor& motor, int carrier, int spin, const Vector3& axle) {
  Row row;
  row.a = carrier;
  row.turn_a = -1.0 * axle;
  row.spin_a = spin;
  row.roll_a = 1.0;
  row.target = dJointGetHingeParam(motor.hinge, dParamVel);
  row.softness = softness_.cfm / physics_.step;
  row.upper = physics_.step * dJointGetHingeParam(motor.hinge, dParamFMax);
  row.lower = -row.upper;
  solver_.add(row);
}

void Crowd::add_hitch(const OdeVehicle& vehicle, int front, const Frame& front_frame, int body) {
  const double softness = softness_.cfm / physics_.step;
  const Frame& frame = vehicle.frame();
  const HitchJoint& hitch = *vehicle.hitch();
  const Vector3 at = vehicle.hitch_place();
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
  // The stop at the nearer of the joint's two limits.
  const auto stop = [&](const Vector3& about, double angle, double limit) {
    Row row = turn((angle > 0.0 ? -1.0 : 1.0) * about);
    row.target = -(limit - std::abs(angle)) / physics_.step;
    row.lower = 0.0;
    solver_.add(row);
  };
  if (hitch.torque > 0.0) {
    Row motor = turn(front_frame.up);
    motor.target = vehicle.hitch_rate();
    motor.upper = physics_.step * hitch.torque;
    motor.lower = -motor.upper;
    solver_.add(motor);
  } else {
    stop(front_frame.up, vehicle.yaw_rad(), hitch.max_yaw_rad);
  }
  stop(-1.0 * frame.left, vehicle.pitch_rad(), hitch.max_pitch_rad);
}

void Crowd::add_grip(const Grip& grip) {
  const int robot = places_.at(grip.chassis).body, box = places_.at(grip.body).body;
  const Vector3 place = grip.place();
  const Vector3 from_box = place - solver_.body(box).center;
  const Vector3 from_robot = place - solver_.body(robot).center;
  const Grip::Error error = grip.error();
  const auto add = [&](const Vector3& linear, const Vector3& turn_a, const Vector3& turn_b,
                       double off) {
    Row row;
    row.a = box;
    row.b = robot;
    row.linear = linear;
    row.turn_a = turn_a;
    row.turn_b = turn_b;
    row.target = softness_.erp / physics_.step * off;
    row.softness = softness_.cfm / physics_.step;
    solver_.add(row);
  };
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    add(axis, cross(from_box, axis), -1.0 * cross(from_robot, axis), dot(axis, error.way));
    if (!grip.turns || axis.z == 0.0) add({}, axis, -1.0 * axis, dot(axis, error.turn));
  }
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
      // Only impulses through the middle of a ball act on its body.
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
  // The velocities of movable bodies already contain gravity's part of the step.
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
  row.target = std::min(softness_.erp / step * contact.contact.geom.depth, kMaxCorrectingSpeed);
  if (surface.mode & dContactMotionN) row.target += surface.motionN;
  if (surface.mode & dContactBounce) {
    const double coming = -normal_speed(row);
    if (coming > surface.bounce_vel) row.target = std::max(row.target, surface.bounce * coming);
  }
  const int normal_row = solver_.add(row);
  int last_row = normal_row;
  const auto note_rows = [&] {
    if (!contact.impulse) return;
    contact.impulse->crowd = this;
    contact.impulse->first_row = normal_row;
    contact.impulse->last_row = last_row;
  };

  const auto glides = [this](dBodyID body) { return body && places_.at(body).glides; };
  if (glides(contact.a) || glides(contact.b)) return note_rows();
  Vector3 first = to_vector(contact.contact.fdir1);
  if (!(surface.mode & dContactFDir1)) {
    dVector3 p, q;
    dPlaneSpace(contact.contact.geom.normal, p, q);
    first = to_vector(p);
  }
  const auto add_friction = [&](const Vector3& along, double mu, double softness) {
    if (mu <= 0.0) return;
    Row friction = row_along(contact, along);
    friction.normal = normal_row;
    friction.mu = mu;
    friction.softness = softness / step;
    last_row = solver_.add(friction);
  };
  const double cfm = softness_.cfm;
  add_friction(first, surface.mu, (surface.mode & dContactSlip1) ? surface.slip1 : cfm);
  add_friction(cross(normal, first), (surface.mode & dContactMu2) ? surface.mu2 : surface.mu,
               (surface.mode & dContactSlip2) ? surface.slip2 : cfm);
  note_rows();
}

Vector3 Crowd::impulse(const ContactImpulse& of) const {
  Vector3 sum;
  for (int i = of.first_row; i <= of.last_row; ++i) {
    const Row& row = solver_.rows()[static_cast<std::size_t>(i)];
    sum = sum + row.impulse * row.linear;
  }
  return sum;
}

void Crowd::step(Method method) {
  if (method == Method::newton) {
    newton_.solve(solver_);
  } else {
    solver_.solve(kSweeps);
  }
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
