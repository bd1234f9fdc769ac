// The engine on ODE: contacts are found, ODE and the folder crowd solve.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/physics/failure.h"

#include "body_states.h"
#include "bounds.h"
#include "box_body.h"
#include "contact_finder.h"
#include "islands.h"
#include "ode_handles.h"
#include "ode_robot.h"
#include "scene.h"
#include "watches.h"

namespace elsie::physics {

class OdeEngine final : public Engine {
 public:
  OdeEngine(const world::Arena& arena, const world::Physics& physics);

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
  void set_joints(std::size_t robot, std::span<const JointSetting> settings) override;
  std::span<const JointSetting> joints(std::size_t robot) const override {
    return bodies_.robots.at(robot).joints();
  }
  void drive_obstacle(std::size_t box, const Vector2& position, const Vector2& velocity) override;
  void work_with(base::ThreadPool& pool) override {
    pool_ = &pool;
    world_.work_with(pool);
  }
  void step() override;

  RobotState robot(std::size_t robot) const override { return bodies_.robots.at(robot).state(); }
  std::size_t segments(std::size_t robot) const override {
    return bodies_.robots.at(robot).vehicles().size() - 1;
  }
  SegmentState segment(std::size_t robot, std::size_t segment) const override {
    return bodies_.robots.at(robot).segment(segment);
  }
  Frame obstacle(std::size_t box) const override;
  bool has_obstacle(std::size_t box) const override { return bodies_.boxes.at(box).present; }
  std::span<const Touch> touches() const override { return finder_.touches(); }
  void watch_contacts(std::size_t robot) override {
    static_cast<void>(bodies_.robots.at(robot));
    contact_watch_.watch(robot);
  }
  std::span<const BodyContact> contacts(std::size_t robot) const override {
    static_cast<void>(bodies_.robots.at(robot));
    return contact_watch_.of(robot);
  }
  BodyMotion motion(std::size_t robot) const override;
  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const override {
    return bodies_.scene.cast_ray(origin, direction, max_range, except);
  }
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                 std::size_t except) const override {
    bodies_.scene.cast_rays(within, rays, surfaces, except);
  }
  bool anything_in(const Pyramid& pyramid, std::size_t except) const override {
    return bodies_.scene.anything_in(pyramid, except);
  }
  std::uint64_t hash_state(std::uint64_t hash) const override;
  GiveUps give_ups() const override { return give_ups_; }

 private:
  /// The additional distance that a body may move in a step because it is accelerated.
  static constexpr double kSlack = 1e-3;  // m

  /// What a share of the robots does in a step.
  struct Share {
    BodyStates before;             // at the start of this step
    std::vector<Scene::Id> moved;  // to other cells of the scene
    std::optional<Failure> failure;
  };

  std::size_t add_upright(std::vector<BoxBody>& list, BodyKind kind, world::ObstacleKind box_kind,
                          const world::Fixture& fixture, double mass, bool sensed);
  std::size_t enter_robot(double top);
  void take_watches(const OdeEngine& other, std::size_t robot);
  void take_step();
  template <class Work>
  void for_each_robot(const Work& work);
  void begin();
  void restore();
  void find_contacts(Islands::OdeTakes takes);
  void start_moving_boxes();
  void place_in_scene(std::size_t robot);
  void settle();
  void settle_robot(std::size_t robot, Share& share);
  void settle_box(BoxBody& box, std::size_t index);
  std::optional<Failure> judge(const Vector3& middle, const Vector3& velocity, bool stays_within,
                               const Body& body,
                               std::optional<std::size_t> segment = std::nullopt) const;
  [[noreturn]] void fail(Failure failure) const;

  world::Physics physics_;
  double time_ = 0.0;
  base::ThreadPool alone_;
  base::ThreadPool* pool_ = &alone_;
  OdeWorld world_;
  // Geometry is destroyed before the world with the bodies that it is attached to.
  ContactFinder finder_;
  OdeBodies bodies_;
  std::vector<std::vector<Scene::Id>> robot_ids_;  // of a robot's vehicles
  std::vector<Share> shares_;
  BodyStates boxes_before_;  // at the start of this step
  Islands islands_;
  Bounds bounds_;
  ContactWatch contact_watch_;
  GiveUps give_ups_;
  std::vector<bool> stay_within_;  // within the arena's walls: each robot
};

}  // namespace elsie::physics
