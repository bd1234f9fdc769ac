// The planar engine.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"

#include "body_models.h"
#include "bounds.h"
#include "collision_pipeline.h"
#include "mover.h"
#include "planar_robot.h"
#include "planar_scene.h"
#include "refusals.h"
#include "watches.h"

namespace elsie::physics {

class PlanarEngine final : public Engine {
 public:
  PlanarEngine(const world::Arena& arena, const world::Physics& physics);

  std::size_t add_robot(const BodyPlan& plan, const Pose& pose, double z) override;
  std::size_t add_obstacle(const world::Obstacle& box) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                           const Pose& pose) override;
  std::size_t add_obstacle_of(const Engine& other, std::size_t box,
                              const world::Obstacle& added) override;
  void go_on_from(const Engine& other) override;
  void remove_obstacle(std::size_t box) override;
  void place_robot(std::size_t robot, const Pose& pose, double z) override;
  void hold(std::size_t robot, std::size_t box, const Vector2& at) override;
  void let_go(std::size_t robot, std::size_t box) override;
  void place_obstacle(std::size_t box, const Pose& pose) override;
  std::optional<std::string> fault_of_height(double z) const override {
    return physics::fault_of_height(z, "the robot");
  }
  void set_joints(std::size_t robot, std::span<const JointSetting> settings) override;
  std::span<const JointSetting> joints(std::size_t robot) const override {
    return robots_.at(robot).joints();
  }
  void drive_obstacle(std::size_t box, const Vector2& position, const Vector2& velocity) override;
  void work_with(base::ThreadPool& pool) override { pool_ = &pool; }
  void step() override;

  RobotState robot(std::size_t robot) const override;
  std::size_t segments(std::size_t robot) const override {
    return robots_.at(robot).vehicles() - 1;
  }
  SegmentState segment(std::size_t robot, std::size_t segment) const override;
  Frame obstacle(std::size_t box) const override;
  bool has_obstacle(std::size_t box) const override { return boxes_.at(box).present; }
  std::span<const Touch> touches() const override { return pipeline_.touches(); }
  void watch_contacts(std::size_t robot) override {
    static_cast<void>(robots_.at(robot));
    contact_watch_.watch(robot);
  }
  std::span<const BodyContact> contacts(std::size_t robot) const override {
    static_cast<void>(robots_.at(robot));
    return contact_watch_.of(robot);
  }
  BodyMotion motion(std::size_t robot) const override;
  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const override {
    return scene_.cast_ray(origin, direction, max_range, except);
  }
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                 std::size_t except) const override {
    scene_.cast_rays(within, rays, surfaces, except);
  }
  bool anything_in(const Pyramid& pyramid, std::size_t except) const override {
    return scene_.anything_in(pyramid, except);
  }
  std::uint64_t hash_state(std::uint64_t hash) const override;
  GiveUps give_ups() const override { return {}; }

 private:
  struct BoxBody {
    world::ObstacleKind kind = world::ObstacleKind::fixed;
    bool present = true;
    std::uint32_t collider = 0;
    double bottom = 0.0;
    bool stays_within = false;  // within the arena's walls
    int hands = 1;              // that move it
    int holders = 0;
    // For a moving box: its place at the end of the next step.
    bool driven = false;
    Vector2 target;
  };
  /// A robot that holds a box.
  struct Grip {
    std::size_t box = 0, robot = 0;
    Hinge hinge;
    double turned_rad = 0.0;  // the box, in the frame of the robot

    /// Where the robot has the place at which it holds the box, and the heading of that.
    Pose wanted(std::span<const Mover> movers) const;
  };
  struct RobotBody {
    std::uint32_t first_collider = 0;
    bool stays_within = false;
  };

  std::uint32_t add_collider(const Body& body, std::size_t vehicle,
                             std::shared_ptr<const std::vector<Solid>> solids,
                             std::shared_ptr<const SensorShape> sensor_shape, bool sensed,
                             const Pose& pose, std::optional<Mover> mover);
  std::uint32_t add_upright(const Body& body, const Shape& shape, double bottom, const Pose& pose,
                            bool sensed, std::optional<Mover> mover);
  Mover& mover_of_box(const BoxBody& box) { return movers_[colliders_[box.collider].mover]; }
  void enter_robot(std::size_t robot);
  void take_watches(const PlanarEngine& other, std::size_t robot);
  void place_in_scene(std::size_t robot, PlanarScene::Moves& moves);
  void take_footing(const BoxBody& box);
  void note_grips();
  void begin_grips();
  Pose carried(std::span<const Grip> grips, double now_rad) const;
  /// Puts each box that is carried where its robots have it.
  void settle_grips(PlanarScene::Moves& moves);
  void start_moving_boxes();
  void stop_moving_boxes();
  void move_on();
  double begin_movers();
  void settle();
  void settle_robot(std::size_t robot, double limit, PlanarScene::Moves& moves);
  void settle_boxes(double limit, PlanarScene::Moves& moves);
  bool is_well(const Mover& mover, double limit, bool stays_within) const;
  [[noreturn]] void fail(const Mover& mover, bool stays_within, const Body& body,
                         std::optional<std::size_t> segment) const;
  void fail_if_pressed() const;
  void note_contacts();
  void note_contact(const Contact& contact, bool of_a);

  const int parts_;         // of a step
  world::Physics physics_;  // with the length of a part as its step
  double time_ = 0.0;
  std::uint64_t next_number_ = 0;
  PlanarScene scene_;
  std::vector<Collider> colliders_;
  std::vector<Mover> movers_;
  std::vector<CollisionPipeline::Moving> moving_;
  BodyModels models_;
  std::vector<PlanarRobot> robots_;
  std::vector<RobotBody> robot_bodies_;
  std::vector<BoxBody> boxes_;
  std::vector<std::uint32_t> mobile_boxes_;
  CollisionPipeline pipeline_;
  Bounds bounds_;
  ContactWatch contact_watch_;
  std::vector<std::uint32_t> jointed_;  // robots with steering or segments
  std::vector<Grip> grips_;             // ascending by box and robot
  bool are_grips_noted_ = true;         // where contacts are found
  std::vector<Hinge*> hinges_;          // of all robots, in each step
  base::ThreadPool alone_;
  base::ThreadPool* pool_ = &alone_;
  // Of each thread:
  std::vector<PlanarScene::Moves> moves_ = std::vector<PlanarScene::Moves>(1);
  std::vector<double> fastest_;  // m2/s2
};

}  // namespace elsie::physics
