// The planar engine: bodies are added, meet, and move along their arcs.
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/base/fnv1a.h"
#include "elsie/physics/engine.h"
#include "elsie/physics/failure.h"
#include "elsie/world/parts.h"

#include "body_models.h"
#include "bounds.h"
#include "checks.h"
#include "encounters.h"
#include "mover.h"
#include "outlines.h"
#include "planar_robot.h"
#include "planar_scene.h"
#include "planar_vehicle.h"
#include "refusals.h"

namespace elsie::physics {
namespace {

// The additional distance that a body may move in a step because it is accelerated.
constexpr double kSlack = 1e-4;  // m

// In the share of a thread: fewer do not pay for waking it.
constexpr std::size_t kLeastMovers = 32;

void refuse_if(const std::optional<std::string>& fault) { require(!fault, fault.value_or("")); }

Frame frame_at(const Vector2& place, double z, const Direction& ahead) {
  return {{place.x, place.y, z}, {ahead.c, ahead.s, 0.0}, {-ahead.s, ahead.c, 0.0}, {0, 0, 1}};
}

Outline outline_of(const world::Fixture& fixture, double bottom) {
  const double height = fixture.shape.size.z;
  return fixture.outline.empty() ? Outline::of(fixture.shape, bottom + 0.5 * height)
                                 : Outline::polygon(fixture.outline, 0.0, bottom, bottom + height);
}

/// The moment of inertia about the vertical through its middle, by its mass, m2.
double second_moment(const world::Fixture& fixture) {
  const Vector3& size = fixture.shape.size;
  if (!fixture.outline.empty()) {
    const OutlineMoments moments = moments_of(fixture.outline);
    return moments.xx + moments.yy;
  }
  return fixture.shape.kind == Shape::Kind::cylinder
             ? 0.5 * fixture.shape.radius() * fixture.shape.radius()
             : (size.x * size.x + size.y * size.y) / 12.0;
}

class PlanarEngine final : public Engine {
 public:
  PlanarEngine(const world::Arena& arena, const world::Physics& physics);

  std::size_t add_robot(const BodyPlan& plan, const Pose& pose, double z) override;
  std::size_t add_box(const world::Box& box) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                           const Pose& pose) override;
  std::size_t add_box_of(const Engine& other, std::size_t box, const world::Box& added) override;
  void go_on_from(const Engine& other) override;
  void remove_box(std::size_t box) override;
  void place_robot(std::size_t robot, const Pose& pose, double z) override;
  std::optional<std::string> fault_of_height(double z) const override {
    return physics::fault_of_height(z, "the robot");
  }
  void set_joints(std::size_t robot, std::span<const JointSetting> settings) override;
  std::span<const JointSetting> joints(std::size_t robot) const override {
    return robots_.at(robot).joints();
  }
  void drive_box(std::size_t box, const Vector2& position, const Vector2& velocity) override;
  void work_with(base::Crew& crew) override { crew_ = &crew; }
  void step() override;

  RobotState robot(std::size_t robot) const override;
  std::size_t segments(std::size_t robot) const override {
    return robots_.at(robot).vehicles() - 1;
  }
  SegmentState segment(std::size_t robot, std::size_t segment) const override;
  Frame box(std::size_t box) const override;
  bool has_box(std::size_t box) const override { return boxes_.at(box).present; }
  std::span<const Touch> touches() const override { return encounters_.touches(); }
  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const override {
    return scene_.cast_ray(origin, direction, max_range, except);
  }
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::size_t except) const override {
    scene_.cast_rays(within, rays, except);
  }
  bool anything_in(const Pyramid& pyramid, std::size_t except) const override {
    return scene_.anything_in(pyramid, except);
  }
  std::uint64_t hash_state(std::uint64_t hash) const override;
  GiveUps give_ups() const override { return {}; }

 private:
  struct BoxBody {
    world::BoxKind kind = world::BoxKind::fixed;
    bool present = true;
    std::uint32_t thing = 0;
    double bottom = 0.0;
    bool stays_within = false;  // within the arena's walls
    // For a moving box: its place at the end of the next step.
    bool driven = false;
    Vector2 target;
  };
  struct RobotBody {
    std::uint32_t first_thing = 0;
    bool stays_within = false;
  };

  std::uint32_t add_thing(const Body& body, std::size_t vehicle,
                          std::shared_ptr<const std::vector<Solid>> solids,
                          std::shared_ptr<const Look> look, bool sensed, const Pose& pose,
                          std::optional<Mover> mover);
  std::uint32_t add_upright(const Body& body, const world::Fixture& fixture, double bottom,
                            const Pose& pose, bool sensed, std::optional<Mover> mover);
  Mover& mover_of_box(const BoxBody& box) { return movers_[things_[box.thing].mover]; }
  void enter_robot(std::size_t robot);
  void place_in_scene(std::size_t robot, PlanarScene::Moves& moves);
  void start_moving_boxes();
  double begin_movers();
  void settle();
  void settle_robot(std::size_t robot, double limit, PlanarScene::Moves& moves);
  void settle_boxes(double limit, PlanarScene::Moves& moves);
  void judge(const Mover& mover, double limit, bool stays_within, const Body& body,
             std::optional<std::size_t> segment = std::nullopt) const;

  world::Physics physics_;
  double time_ = 0.0;
  std::uint64_t next_number_ = 0;
  PlanarScene scene_;
  std::vector<Thing> things_;
  std::vector<Mover> movers_;
  std::vector<Encounters::Moving> moving_;
  BodyModels models_;
  std::vector<PlanarRobot> robots_;
  std::vector<RobotBody> robot_bodies_;
  std::vector<BoxBody> boxes_;
  std::vector<std::uint32_t> mobile_boxes_;
  Encounters encounters_;
  Bounds bounds_;
  std::vector<std::uint32_t> jointed_;  // robots with steering or segments
  std::vector<Hinge*> hinges_;          // of all robots, in each step
  base::Crew alone_;
  base::Crew* crew_ = &alone_;
  // Of each thread:
  std::vector<PlanarScene::Moves> moves_ = std::vector<PlanarScene::Moves>(1);
  std::vector<double> fastest_;  // m2/s2
};

PlanarEngine::PlanarEngine(const world::Arena& arena, const world::Physics& physics)
    : physics_((check(arena, physics), physics)),
      scene_(arena),
      models_(physics_),
      encounters_(physics_, things_, movers_, scene_),
      bounds_(arena, physics) {
  refuse_if(fault_of(physics));
  std::size_t index = 0;
  for (const world::Fixture& wall : world::walls_of(arena)) {
    const Vector3& at = wall.frame.origin;
    const double heading = std::atan2(wall.frame.forward.y, wall.frame.forward.x);
    add_upright({BodyKind::wall, index++}, wall, at.z - 0.5 * wall.shape.size.z,
                {at.x, at.y, heading}, true, std::nullopt);
  }
}

std::uint32_t PlanarEngine::add_thing(const Body& body, std::size_t vehicle,
                                      std::shared_ptr<const std::vector<Solid>> solids,
                                      std::shared_ptr<const Look> look, bool sensed,
                                      const Pose& pose, std::optional<Mover> mover) {
  Thing thing;
  thing.body = body;
  thing.vehicle = vehicle;
  thing.number = next_number_++;
  thing.solids = std::move(solids);
  thing.place = {pose.x, pose.y};
  thing.ahead = Direction::of(pose.heading_rad);
  const double reach = look->reach;
  const std::uint32_t id =
      scene_.add(body, sensed, mover.has_value(), std::move(look), thing.place, thing.ahead);
  if (mover) {
    mover->put(thing.place, pose.heading_rad);
    thing.mover = static_cast<std::uint32_t>(movers_.size());
    movers_.push_back(std::move(*mover));
    moving_.push_back({id, thing.mover, reach});
  }
  things_.push_back(std::move(thing));
  return id;
}

std::uint32_t PlanarEngine::add_upright(const Body& body, const world::Fixture& fixture,
                                        double bottom, const Pose& pose, bool sensed,
                                        std::optional<Mover> mover) {
  auto solids = std::make_shared<std::vector<Solid>>();
  solids->push_back({outline_of(fixture, bottom), {}, {}});
  return add_thing(body, 0, std::move(solids), std::make_shared<Look>(Look::of(fixture, bottom)),
                   sensed, pose, std::move(mover));
}

std::size_t PlanarEngine::add_robot(const BodyPlan& plan, const Pose& pose, double z) {
  world::check(plan);
  check(pose, z);
  refuse_if(physics::fault_of_height(z, "a robot"));
  refuse_if(fault_of(plan, "a robot"));
  const std::size_t index = robots_.size();
  const auto first = static_cast<std::uint32_t>(movers_.size());
  robot_bodies_.push_back({static_cast<std::uint32_t>(things_.size()), false});
  const std::shared_ptr<BodyModel> model = models_.model_of(plan);
  for (std::size_t vehicle = 0; vehicle < plan.vehicles(); ++vehicle) {
    add_thing({BodyKind::robot, index}, vehicle, model->solids[vehicle], model->looks[vehicle],
              true, pose, model->movers[vehicle]);
  }
  robots_.emplace_back(model, first, movers_);
  robots_.back().put(pose, movers_);
  if (robots_.back().has_joints()) jointed_.push_back(static_cast<std::uint32_t>(index));
  enter_robot(index);
  return index;
}

void PlanarEngine::enter_robot(std::size_t robot) {
  const Vector2& at = movers_[robots_[robot].first()].place();
  robot_bodies_[robot].stays_within = bounds_.within_walls({at.x, at.y, 0.0});
  place_in_scene(robot, moves_.front());
  scene_.settle(moves_);
}

std::size_t PlanarEngine::add_robot_of(const Engine& other, std::size_t robot) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const PlanarRobot& same = before.robots_.at(robot);
  const std::size_t index = add_robot(same.plan(), {}, 0.0);
  PlanarRobot& made = robots_[index];
  made.take(same);
  for (std::uint32_t i = 0; i < made.vehicles(); ++i) {
    movers_[made.first() + i].take(before.movers_[same.first() + i]);
    things_[robot_bodies_[index].first_thing + i].number =
        before.things_[before.robot_bodies_[robot].first_thing + i].number;
  }
  enter_robot(index);
  return index;
}

std::size_t PlanarEngine::add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                                       const Pose& pose) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const Mover& same = before.movers_[before.robots_.at(robot).first()];
  const std::size_t index = add_robot(plan, pose, 0.0);
  const PlanarRobot& made = robots_[index];
  const Twist velocity = same.ahead().turn(same.velocity_of_origin());
  for (std::uint32_t i = 0; i < made.vehicles(); ++i) {
    movers_[made.first() + i].push(velocity, same.place());
  }
  robots_[index].settle(movers_);
  return index;
}

std::size_t PlanarEngine::add_box(const world::Box& box) {
  check(box);
  const bool is_dynamic = box.kind == world::BoxKind::dynamic;
  refuse_if(fault_of(box, "a box"));
  const std::size_t index = boxes_.size();
  const world::Fixture fixture = world::fixture_of(box);
  std::optional<Mover> mover;
  if (is_dynamic) {
    const Inertia inertia{box.mass, {}, box.mass * second_moment(fixture)};
    const double lever = physics::lever_of(outline_of(fixture, 0.0));
    mover.emplace(inertia, FloorFriction(inertia, lever, physics_));
  } else if (box.kind == world::BoxKind::moving) {
    mover.emplace();
  }
  BoxBody& made = boxes_.emplace_back();
  made.kind = box.kind;
  made.bottom = box.z;
  made.thing =
      add_upright({BodyKind::box, index}, fixture, box.z, {box.x, box.y, radians(box.heading_deg)},
                  box.seen_by_range_sensors, std::move(mover));
  if (things_[made.thing].mover != Contact::kFixed) {
    mobile_boxes_.push_back(static_cast<std::uint32_t>(index));
  }
  made.stays_within = is_dynamic && bounds_.within_walls({box.x, box.y, 0.0});
  return index;
}

std::size_t PlanarEngine::add_box_of(const Engine& other, std::size_t box,
                                     const world::Box& added) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const BoxBody& same = before.boxes_.at(box);
  const std::size_t index = add_box(added);
  Thing& thing = things_[boxes_[index].thing];
  const Thing& known = before.things_[same.thing];
  thing.number = known.number;
  if (!same.present) {
    remove_box(index);
  } else if (thing.mover != Contact::kFixed) {
    Mover& mover = movers_[thing.mover];
    mover.take(before.movers_[known.mover]);
    scene_.move(boxes_[index].thing, mover.place(), mover.ahead(), moves_.front());
    scene_.settle(moves_);
    boxes_[index].stays_within = boxes_[index].kind == world::BoxKind::dynamic &&
                                 bounds_.within_walls({mover.place().x, mover.place().y, 0.0});
  }
  return index;
}

void PlanarEngine::go_on_from(const Engine& other) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  time_ = before.time_;
  next_number_ = std::max(next_number_, before.next_number_);
  bounds_.add(before.bounds_);
  encounters_.take(before.encounters_);
}

void PlanarEngine::remove_box(std::size_t box) {
  BoxBody& gone = boxes_.at(box);
  if (!gone.present) return;
  gone.present = false;
  scene_.remove(gone.thing);
  std::erase_if(moving_, [&](const auto& moving) { return moving.thing == gone.thing; });
  std::erase(mobile_boxes_, static_cast<std::uint32_t>(box));
}

void PlanarEngine::place_robot(std::size_t robot, const Pose& pose, double z) {
  check(pose, z);
  refuse_if(physics::fault_of_height(z, "a robot"));
  robots_.at(robot).put(pose, movers_);
  enter_robot(robot);
}

void PlanarEngine::place_in_scene(std::size_t robot, PlanarScene::Moves& moves) {
  const PlanarRobot& made = robots_[robot];
  const std::uint32_t first = robot_bodies_[robot].first_thing;
  made.point_shapes();
  for (std::uint32_t i = 0; i < made.vehicles(); ++i) {
    const Mover& mover = movers_[made.first() + i];
    scene_.move(first + i, mover.place(), mover.ahead(), moves);
  }
}

void PlanarEngine::set_joints(std::size_t robot, std::span<const JointSetting> settings) {
  PlanarRobot& set = robots_.at(robot);
  require(settings.size() == set.joints().size(),
          "A robot needs one setting for each joint with a motor or steering.");
  double sum = 0.0;
  for (const JointSetting& setting : settings) {
    sum += setting.rate_rad_s + setting.angle_rad + setting.turn_rad_s;
  }
  require(std::isfinite(sum),
          "The rates and angles that a robot's joints are to hold must be finite.");
  set.set_joints(settings, movers_);
  bounds_.add_robot_speed(set.lever() * set.rim_speed(settings));
}

void PlanarEngine::drive_box(std::size_t box, const Vector2& position, const Vector2& velocity) {
  BoxBody& driven = boxes_.at(box);
  require(driven.kind == world::BoxKind::moving, "Only a moving box can be driven.");
  require(std::isfinite(position.x + position.y + velocity.x + velocity.y),
          "The position and velocity of a moving box must be finite.");
  if (!driven.present) return;
  driven.driven = true;
  driven.target = position;
  bounds_.add_moving_speed(std::hypot(velocity.x, velocity.y));
  mover_of_box(driven).drive(velocity);
}

RobotState PlanarEngine::robot(std::size_t robot) const {
  const Mover& mover = movers_[robots_.at(robot).first()];
  const Twist velocity = mover.velocity_of_origin();
  const Vector2& at = mover.place();
  return {frame_at(at, 0.0, mover.ahead()),
          {at.x, at.y, mover.heading_rad()},
          velocity.x,
          velocity.y,
          velocity.turn};
}

SegmentState PlanarEngine::segment(std::size_t robot, std::size_t segment) const {
  const PlanarRobot& asked = robots_.at(robot);
  const Hinge& hinge = asked.hinges().at(segment);
  const Mover& mover = movers_[hinge.behind];
  const Vector2& at = mover.place();
  return {frame_at(at, 0.0, mover.ahead()), {at.x, at.y, mover.heading_rad()}, hinge.yaw_rad, 0.0};
}

Frame PlanarEngine::box(std::size_t box) const {
  const BoxBody& asked = boxes_.at(box);
  const Thing& thing = things_[asked.thing];
  if (thing.mover == Contact::kFixed) return frame_at(thing.place, asked.bottom, thing.ahead);
  const Mover& mover = movers_[thing.mover];
  return frame_at(mover.place(), asked.bottom, mover.ahead());
}

void PlanarEngine::start_moving_boxes() {
  for (const std::uint32_t index : mobile_boxes_) {
    BoxBody& box = boxes_[index];
    if (box.kind != world::BoxKind::moving) continue;
    Mover& mover = mover_of_box(box);
    if (!box.driven) {
      mover.drive({});
      continue;
    }
    // Moved back by the distance of this step, so that the box arrives with it.
    const Twist velocity = mover.ahead().turn(mover.velocity());
    const Vector2& at = mover.place();
    mover.shift({box.target.x - physics_.step * velocity.x - at.x,
                 box.target.y - physics_.step * velocity.y - at.y});
  }
}

/// Returns how far two bodies may come nearer in this step, m.
double PlanarEngine::begin_movers() {
  std::fill(fastest_.begin(), fastest_.end(), 0.0);
  crew_->divide(moving_.size(), kLeastMovers, [&](const base::Crew::Share& share) {
    double& fastest = fastest_[share.thread];
    for (std::size_t i = share.first; i < share.end; ++i) {
      Mover& mover = movers_[moving_[i].mover];
      mover.begin(physics_.step);
      const Twist& v = mover.velocity();
      const double square = v.x * v.x + v.y * v.y;
      const double edge = moving_[i].reach * std::abs(v.turn);
      fastest =
          std::max(fastest, 2.0 * (square + edge * edge));  // the square of their sum, or more
    }
  });
  const double fastest = *std::max_element(fastest_.begin(), fastest_.end());
  return 2.0 * physics_.step * (1.0 + physics_.bounce) * std::sqrt(fastest) + kSlack;
}

void PlanarEngine::step() {
  moves_.resize(crew_->threads());
  fastest_.resize(crew_->threads());
  start_moving_boxes();
  hinges_.clear();
  for (const std::uint32_t i : jointed_) {
    robots_[i].begin(physics_.step, movers_);
    for (Hinge& hinge : robots_[i].hinges()) hinges_.push_back(&hinge);
  }
  encounters_.find(moving_, begin_movers(), *crew_);
  encounters_.solve(hinges_, *crew_);
  time_ += physics_.step;
  settle();
}

/// Moves all bodies.
void PlanarEngine::settle() {
  const double limit = bounds_.most_speed();
  crew_->divide(robots_.size(), kLeastMovers, [&](const base::Crew::Share& share) {
    std::exception_ptr failure;  // the others are moved, too
    for (std::size_t i = share.first; i < share.end; ++i) {
      try {
        settle_robot(i, limit, moves_[share.thread]);
      } catch (const PhysicsFailure&) {
        if (!failure) failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
  });
  settle_boxes(limit, moves_.front());
  scene_.settle(moves_);
}

void PlanarEngine::settle_robot(std::size_t i, double limit, PlanarScene::Moves& moves) {
  PlanarRobot& robot = robots_[i];
  for (std::uint32_t k = 0; k < robot.vehicles(); ++k) {
    movers_[robot.first() + k].advance(physics_.step);
  }
  robot.settle(movers_);
  place_in_scene(i, moves);
  for (std::uint32_t k = 0; k < robot.vehicles(); ++k) {
    judge(movers_[robot.first() + k], limit, robot_bodies_[i].stays_within, {BodyKind::robot, i},
          k > 0 ? std::optional<std::size_t>(k - 1) : std::nullopt);
  }
}

void PlanarEngine::settle_boxes(double limit, PlanarScene::Moves& moves) {
  for (const std::uint32_t index : mobile_boxes_) {
    BoxBody& box = boxes_[index];
    Mover& mover = mover_of_box(box);
    mover.advance(physics_.step);
    if (box.kind == world::BoxKind::moving) {
      if (box.driven) {
        box.driven = false;
        mover.shift({box.target.x - mover.place().x, box.target.y - mover.place().y});
      }
    } else {
      judge(mover, limit, box.stays_within, {BodyKind::box, index});
    }
    scene_.move(box.thing, mover.place(), mover.ahead(), moves);
  }
}

void PlanarEngine::judge(const Mover& mover, double limit, bool stays_within, const Body& body,
                         std::optional<std::size_t> segment) const {
  const Vector2& at = mover.place();
  const Twist& v = mover.velocity();
  const bool is_well = v.x * v.x + v.y * v.y <= limit * limit &&
                       std::isfinite(at.x + at.y + v.turn) &&
                       (!stays_within || bounds_.within_walls({at.x, at.y, 0.0}));
  if (is_well) return;
  Failure failure;
  if (auto found = bounds_.check({at.x, at.y, 0.0}, {v.x, v.y, 0.0}, stays_within)) {
    failure = *found;
  } else {
    failure.kind = Failure::Kind::not_finite;
  }
  failure.body = body;
  failure.segment = segment;
  failure.time_s = time_;
  throw PhysicsFailure(failure);
}

std::uint64_t PlanarEngine::hash_state(std::uint64_t hash) const {
  base::Fnv1a all(hash);
  const auto add = [&](const Thing& thing) {
    const bool moves = thing.mover != Contact::kFixed;
    const Vector2& at = moves ? movers_[thing.mover].place() : thing.place;
    const Direction& ahead = moves ? movers_[thing.mover].ahead() : thing.ahead;
    for (const double number : {at.x, at.y, ahead.c, ahead.s}) all.add(number);
    if (!moves) return;
    const Twist& v = movers_[thing.mover].velocity();
    for (const double number : {v.x, v.y, v.turn}) all.add(number);
  };
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    for (std::size_t k = 0; k < robots_[i].vehicles(); ++k) {
      add(things_[robot_bodies_[i].first_thing + k]);
    }
    for (const JointSetting& joint : robots_[i].joints()) {
      all.add(joint.rate_rad_s);
      all.add(joint.angle_rad);
    }
  }
  for (const BoxBody& box : boxes_) {
    all.add(std::uint64_t{box.present});
    if (box.present) add(things_[box.thing]);
  }
  return all.value();
}

}  // namespace

}  // namespace elsie::physics

extern "C" __attribute__((visibility("default"))) elsie::physics::Engine* elsie_make_engine(
    const elsie::world::Arena& arena, const elsie::world::Physics& physics) {
  return new elsie::physics::PlanarEngine(arena, physics);
}

extern "C" {
__attribute__((
    visibility("default"))) extern const elsie::physics::EngineInterface elsie_engine_interface{};
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
