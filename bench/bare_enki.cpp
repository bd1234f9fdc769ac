#include "bare_enki.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <enki/PhysicalEngine.h>
#include <enki/robots/DifferentialWheeled.h>

namespace elsie::bench {
namespace {

constexpr double kCm = 100.0;  // Enki's unit of length

/// A ray from the front edge of a robot, as the beams of Elsie's robots.
class Beam final : public Enki::LocalInteraction {
 public:
  Beam(Enki::Robot* carrier, double ahead, double azimuth_rad)
      : LocalInteraction(kCm * kBeamRange_m + ahead, carrier),
        ahead_(ahead),
        azimuth_rad_(azimuth_rad) {}

  double range_m() const { return nearest_ / kCm; }

  void init(double, Enki::World*) override {
    const double heading = owner->angle;
    from_ = owner->pos + Enki::Vector(ahead_ * std::cos(heading), ahead_ * std::sin(heading));
    along_ = Enki::Vector(std::cos(heading + azimuth_rad_), std::sin(heading + azimuth_rad_));
    nearest_ = kCm * kBeamRange_m;
  }

  void objectStep(double, Enki::World*, Enki::PhysicalObject* object) override {
    const Enki::Vector to = object->pos - from_;
    const double past = to * along_, off = to.norm2() - past * past;
    const double radius = object->getRadius();
    if (off > radius * radius || past < -radius || past - radius > nearest_) return;
    if (object->isCylindric()) {
      const double distance = past - std::sqrt(radius * radius - off);
      if (past > 0.0 && distance < nearest_) nearest_ = std::max(0.0, distance);
      return;
    }
    for (const auto& part : object->getHull()) {
      const Enki::Polygon& corners = part.getTransformedShape();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        meet_edge(corners[i], corners[(i + 1) % corners.size()]);
      }
    }
  }

  void wallsStep(double, Enki::World* world) override {
    const auto meet = [&](double from, double along, double size) {
      if (along == 0.0) return;
      const double distance = ((along > 0.0 ? size : 0.0) - from) / along;
      nearest_ = std::min(nearest_, std::max(0.0, distance));
    };
    meet(from_.x, along_.x, world->w);
    meet(from_.y, along_.y, world->h);
  }

 private:
  void meet_edge(const Enki::Point& a, const Enki::Point& b) {
    const Enki::Vector edge = b - a, to = a - from_;
    const double crossing = along_.x * edge.y - along_.y * edge.x;
    if (crossing == 0.0) return;
    const double distance = (to.x * edge.y - to.y * edge.x) / crossing;
    const double place = (to.x * along_.y - to.y * along_.x) / crossing;
    if (place >= 0.0 && place <= 1.0 && distance >= 0.0) nearest_ = std::min(nearest_, distance);
  }

  double ahead_;
  double azimuth_rad_;
  Enki::Point from_;
  Enki::Vector along_;
  double nearest_ = 0.0;
};

class Robot final : public Enki::DifferentialWheeled {
 public:
  Robot(const world::RobotBody& body, double max_speed, const Rule& rule)
      : DifferentialWheeled(2.0 * kCm * body.half_axle(), kCm * max_speed, 0.0),
        wheel_radius_(body.wheel_radius),
        rule_(rule) {
    beams_.reserve(kBeamAzimuths_deg.size());
    for (const double azimuth : kBeamAzimuths_deg) {
      beams_.emplace_back(this, 0.5 * kCm * body.length, radians(azimuth));
    }
    for (Beam& beam : beams_) addLocalInteraction(&beam);
    setCylindric(kCm * std::sqrt(body.length * body.width / M_PI), kCm * body.height, body.mass);
  }

  void controlStep(double dt) override {
    std::array<double, kBeamAzimuths_deg.size()> ranges;
    for (std::size_t i = 0; i < beams_.size(); ++i) ranges[i] = beams_[i].range_m();
    const WheelRates rates = rule_(ranges.data());
    leftSpeed = kCm * wheel_radius_ * rates.left;
    rightSpeed = kCm * wheel_radius_ * rates.right;
    DifferentialWheeled::controlStep(dt);
  }

 private:
  double wheel_radius_;
  const Rule& rule_;
  std::vector<Beam> beams_;
};

}  // namespace

class BareEnki::Impl {
 public:
  Impl(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
       const world::Physics& physics, const world::Arena& arena, Rule rule)
      : world_(kCm * arena.length, kCm * arena.width), rule_(std::move(rule)), step_(physics.step) {
    const Enki::Point middle(0.5 * world_.w, 0.5 * world_.h);
    for (const world::Obstacle& box : boxes) {
      auto* made = new Enki::PhysicalObject;
      made->setRectangular(kCm * box.length, kCm * box.width, kCm * box.height, -1.0);
      made->pos = middle + Enki::Vector(kCm * box.x, kCm * box.y);
      made->angle = radians(box.heading_deg);
      world_.addObject(made);
    }
    const world::Robot described;
    for (const Pose& pose : poses) {
      auto* made = new Robot(described.body, described.max_speed, rule_);
      made->pos = middle + Enki::Vector(kCm * pose.x, kCm * pose.y);
      made->angle = pose.heading_rad;
      world_.addObject(made);
      robots_.push_back(made);
    }
  }

  void step() { world_.step(step_); }
  Pose pose(std::size_t robot) const {
    const Robot& asked = *robots_[robot];
    return {(asked.pos.x - 0.5 * world_.w) / kCm, (asked.pos.y - 0.5 * world_.h) / kCm,
            asked.angle};
  }

 private:
  Enki::World world_;  // owns its objects
  Rule rule_;
  double step_;
  std::vector<Robot*> robots_;
};

BareEnki::BareEnki(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
                   const world::Physics& physics, const world::Arena& arena, Rule rule)
    : impl_(std::make_unique<Impl>(poses, boxes, physics, arena, std::move(rule))) {}
BareEnki::~BareEnki() = default;

void BareEnki::step() { impl_->step(); }
Pose BareEnki::pose(std::size_t robot) const { return impl_->pose(robot); }

}  // namespace elsie::bench
