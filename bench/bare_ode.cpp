#include "bare_ode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <ode/ode.h>

namespace elsie::bench {
namespace {

constexpr int kMostContacts = 8;
constexpr double kTyreGrip = 3.0;
constexpr double kSensorDeck = 0.02;  // m: beams on top of a chassis see other chassis

/// The kind of a geometry, which selects its contacts; stored in the geometry's data pointer.
enum class Part : std::uintptr_t { box, chassis, wheel, caster, deck };

Part part_of(dGeomID geom) {
  return static_cast<Part>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)));
}
void set_part(dGeomID geom, Part part) {
  dGeomSetData(geom, reinterpret_cast<void*>(static_cast<std::uintptr_t>(part)));
}

struct Robot {
  dSpaceID space = nullptr;
  dBodyID chassis = nullptr;
  std::array<dJointID, 2> hinges{};
  std::array<dGeomID, BareOde::kBeams> beams{};
};

}  // namespace

class BareOde::Impl {
 public:
  Impl(std::span<const double> azimuths, const world::Physics& physics, Rule rule)
      : azimuths_(azimuths.begin(), azimuths.end()), physics_(physics), rule_(std::move(rule)) {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, physics.gravity);
    // Softness as in Elsie without parameters of the engine.
    dWorldSetERP(world_, 0.2);
    dWorldSetCFM(world_, 1e-5);
    space_ = dHashSpaceCreate(nullptr);
    floor_ = dCreatePlane(nullptr, 0, 0, 1, 0);
    contacts_ = dJointGroupCreate(0);
  }

  ~Impl() {
    for (const Robot& robot : robots_) {
      for (const dGeomID beam : robot.beams) dGeomDestroy(beam);
    }
    dJointGroupDestroy(contacts_);
    dGeomDestroy(floor_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void add_obstacle(double x, double y, double z, double heading, double length, double width,
                    double height) {
    const dGeomID geom = dCreateBox(space_, length, width, height);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, 0, 1, heading);
    dGeomSetPosition(geom, x, y, z + 0.5 * height);
    dGeomSetRotation(geom, rotation);
    set_part(geom, Part::box);
  }

  void add_robot(const Pose& pose) {
    const world::RobotBody body;
    Robot robot;
    robot.space = dSimpleSpaceCreate(space_);
    const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
    dMatrix3 facing;
    dRFromAxisAndAngle(facing, 0, 0, 1, pose.heading_rad);
    const auto make = [&](Part part, dGeomID geom, const dMass& mass, double x, double y,
                          double z) {
      const dBodyID made = dBodyCreate(world_);
      dBodySetMass(made, &mass);
      dBodySetPosition(made, pose.x + c * x - s * y, pose.y + s * x + c * y, z);
      dBodySetRotation(made, facing);
      dGeomSetBody(geom, made);
      set_part(geom, part);
      return made;
    };

    dMass mass;
    dMassSetBoxTotal(&mass, body.mass, body.length, body.width, body.height);
    robot.chassis =
        make(Part::chassis, dCreateBox(robot.space, body.length, body.width, body.height), mass, 0,
             0, body.clearance + 0.5 * body.height);
    const dGeomID deck = dCreateBox(robot.space, body.length, body.width, kSensorDeck);
    dGeomSetBody(deck, robot.chassis);
    dGeomSetOffsetPosition(deck, 0, 0, 0.5 * (body.height + kSensorDeck));
    set_part(deck, Part::deck);

    for (std::size_t i = 0; i < 2; ++i) {
      const double y = i == 0 ? body.half_axle() : -body.half_axle();
      dMassSetCylinderTotal(&mass, body.wheel_mass, 3, body.wheel_radius, body.wheel_width);
      const dBodyID wheel =
          make(Part::wheel, dCreateCylinder(robot.space, body.wheel_radius, body.wheel_width), mass,
               0, y, body.wheel_radius);
      dMatrix3 turned;
      dRFromZAxis(turned, -s, c, 0);
      dBodySetRotation(wheel, turned);
      const dReal* at = dBodyGetPosition(wheel);
      const dJointID hinge = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge, wheel, robot.chassis);
      dJointSetHingeAnchor(hinge, at[0], at[1], at[2]);
      dJointSetHingeAxis(hinge, -s, c, 0);
      dJointSetHingeParam(hinge, dParamFMax, body.wheel_torque);
      robot.hinges[i] = hinge;
    }

    const double radius = 0.5 * body.clearance, place = 0.5 * body.length - 1.2 * radius;
    for (const double x : {place, -place}) {
      dMassSetSphereTotal(&mass, 0.02 * body.mass, radius);
      const dBodyID caster =
          make(Part::caster, dCreateSphere(robot.space, radius), mass, x, 0, radius);
      const dReal* at = dBodyGetPosition(caster);
      const dJointID ball = dJointCreateBall(world_, nullptr);
      dJointAttach(ball, caster, robot.chassis);
      dJointSetBallAnchor(ball, at[0], at[1], at[2]);
    }
    for (dGeomID& beam : robot.beams) beam = dCreateRay(nullptr, kBeamRange_m);
    robots_.push_back(robot);
  }

  void step() {
    for (const Robot& robot : robots_) {
      std::array<double, kBeams> ranges;
      for (std::size_t i = 0; i < kBeams; ++i) ranges[i] = measure(robot, i);
      const WheelRates command = rule_(ranges.data());
      dJointSetHingeParam(robot.hinges[0], dParamVel, command.left);
      dJointSetHingeParam(robot.hinges[1], dParamVel, command.right);
    }
    dSpaceCollide(space_, this, &on_near);
    for (const Robot& robot : robots_) {
      dSpaceCollide2(static_cast<dGeomID>(static_cast<void*>(robot.space)), floor_, this, &on_near);
    }
    dWorldStep(world_, physics_.step);
    dJointGroupEmpty(contacts_);
  }

  Pose pose(std::size_t i) const {
    const dReal* p = dBodyGetPosition(robots_[i].chassis);
    const dReal* r = dBodyGetRotation(robots_[i].chassis);
    return {p[0], p[1], std::atan2(r[4], r[0])};
  }

 private:
  struct Beam {
    dGeomID ray;
    dSpaceID own;
    double nearest;
  };

  double measure(const Robot& robot, std::size_t i) {
    const world::RobotBody body;
    const dReal* r = dBodyGetRotation(robot.chassis);
    dVector3 from;
    dBodyGetRelPointPos(robot.chassis, 0.5 * body.length, 0, 0.5 * body.height, from);
    const double c = std::cos(azimuths_[i]), s = std::sin(azimuths_[i]);
    dGeomRaySet(robot.beams[i], from[0], from[1], from[2], c * r[0] + s * r[1], c * r[4] + s * r[5],
                c * r[8] + s * r[9]);
    Beam beam{robot.beams[i], robot.space, kBeamRange_m};
    const auto space = static_cast<dGeomID>(static_cast<void*>(space_));
    dSpaceCollide2(robot.beams[i], space, &beam, &on_beam);
    on_beam(&beam, robot.beams[i], floor_);
    return beam.nearest;
  }

  static void on_beam(void* data, dGeomID a, dGeomID b) {
    Beam& beam = *static_cast<Beam*>(data);
    const dGeomID other = a == beam.ray ? b : a;
    if (dGeomIsSpace(other)) {
      // A robot's beam ignores its own parts.
      if (static_cast<dSpaceID>(static_cast<void*>(other)) != beam.own) {
        dSpaceCollide2(a, b, data, &on_beam);
      }
      return;
    }
    dContactGeom contact;
    if (dCollide(beam.ray, other, 1, &contact, sizeof contact) > 0) {
      beam.nearest = std::min(beam.nearest, contact.depth);
    }
  }

  static void on_near(void* data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
      dSpaceCollide2(a, b, data, &on_near);  // parts of one robot are never tested
      return;
    }
    static_cast<Impl*>(data)->meet(a, b);
  }

  void meet(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (!body_a && !body_b) return;
    if (a == floor_) std::swap(a, b);
    const bool on_floor = b == floor_;
    const Part part = part_of(a);
    if (part == Part::deck || (!on_floor && part_of(b) == Part::deck)) return;

    std::array<dContact, kMostContacts> found;
    int count = dCollide(a, b, kMostContacts, &found[0].geom, sizeof(dContact));
    if (on_floor && part == Part::wheel && count > 1) {
      // ODE finds both ends of the line of contact under a wheel. One contact in the middle is less
      // work, and is what Elsie does.
      dContactGeom& middle = found[0].geom;
      for (int i = 1; i < count; ++i) {
        const dContactGeom& other = found[static_cast<std::size_t>(i)].geom;
        for (int axis = 0; axis < 3; ++axis) middle.pos[axis] += other.pos[axis];
        middle.depth = std::max(middle.depth, other.depth);
      }
      for (int axis = 0; axis < 3; ++axis) middle.pos[axis] /= count;
      count = 1;
    }
    for (int i = 0; i < count; ++i) {
      dContact& contact = found[static_cast<std::size_t>(i)];
      dSurfaceParameters& surface = contact.surface;
      surface = {};
      surface.mode = dContactApprox1;
      surface.mu = physics_.friction;
      if (on_floor && part == Part::caster) {
        surface.mu = 0;
      } else if (on_floor && part == Part::wheel) {
        surface.mode |= dContactFDir1 | dContactSlip1 | dContactSlip2;
        surface.mu = kTyreGrip * physics_.friction;
        surface.slip1 = surface.slip2 = physics_.wheel_slip;
        const dReal* r = dBodyGetRotation(dGeomGetBody(a));  // the axle is the third axis
        const double level = std::hypot(r[2], r[6]);
        contact.fdir1[0] = level > 0 ? r[6] / level : 1;
        contact.fdir1[1] = level > 0 ? -r[2] / level : 0;
        contact.fdir1[2] = 0;
      }
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  std::vector<double> azimuths_;
  world::Physics physics_;
  Rule rule_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dGeomID floor_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<Robot> robots_;
};

BareOde::BareOde(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
                 std::span<const double> azimuths, const world::Physics& physics,
                 const world::Arena& arena, Rule rule)
    : impl_(std::make_unique<Impl>(azimuths.first(kBeams), physics, std::move(rule))) {
  const double t = arena.wall_thickness, h = arena.wall_height;
  const double x = 0.5 * (arena.length + t), y = 0.5 * (arena.width + t);
  for (const double side : {1.0, -1.0}) {
    impl_->add_obstacle(side * x, 0, 0, 0, t, arena.width, h);
    impl_->add_obstacle(0, side * y, 0, 0, arena.length + 2 * t, t, h);
  }
  for (const world::Obstacle& box : boxes) {
    impl_->add_obstacle(box.x, box.y, box.z, radians(box.heading_deg), box.length, box.width,
                        box.height);
  }
  for (const Pose& pose : poses) impl_->add_robot(pose);
}

BareOde::~BareOde() = default;

void BareOde::step() { impl_->step(); }

Pose BareOde::pose(std::size_t robot) const { return impl_->pose(robot); }

}  // namespace elsie::bench
