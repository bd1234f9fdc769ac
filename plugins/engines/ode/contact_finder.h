// Finds the contacts of all bodies at the start of a step.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/base/thread_pool.h"
#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "box_body.h"
#include "grip.h"
#include "ode_contacts.h"
#include "ode_handles.h"
#include "ode_robot.h"
#include "scene.h"
#include "watches.h"

namespace elsie::physics {

/// The bodies of an engine.
struct OdeBodies {
  explicit OdeBodies(const world::Arena& arena) : scene(arena) {}

  const BoxBody& box_of(const Body& body) const {
    return body.kind == BodyKind::wall ? walls[body.index] : boxes[body.index];
  }
  bool is_mobile(const Body& body) const {
    return body.kind == BodyKind::robot || box_of(body).is_mobile();
  }
  bool holds(const Body& robot, const Body& box) const {
    return box.kind == BodyKind::obstacle && grips.has(robot.index, box.index);
  }

  Scene scene;
  std::vector<OdeRobot> robots;
  std::vector<BoxBody> boxes;
  std::vector<BoxBody> walls;
  std::vector<Scene::Id> mobile;  // ascending
  Grips grips;
};

/// Some of the contacts of a step.
struct FoundContacts {
  OdeContacts contacts;
  std::vector<Touch> touches;
  std::vector<Scene::Id> neighbors;  // of the current body; kept to reuse its memory
  /// The contacts of two bodies of which one is watched: those from `first` to before `last`.
  struct Watched {
    Scene::Id a = 0, b = 0;
    std::size_t first = 0, last = 0;
  };
  std::vector<Watched> watched;
  std::vector<ContactImpulse> impulses;  // of these
};

/// A pool finds the contacts of several bodies at once. Their order does not depend on the pool.
class ContactFinder {
 public:
  explicit ContactFinder(const world::Physics& physics);

  /// Bodies in a share of the pool.
  static constexpr std::size_t kBlock = 16;

  void find(const OdeBodies& bodies, const ContactWatch& watch, base::ThreadPool& pool);
  /// After the step that found() was for.
  void note(const OdeBodies& bodies, ContactWatch& watch);

  std::span<FoundContacts> found() { return std::span(blocks_).first(used_); }
  /// See Engine::touches().
  std::span<const Touch> touches() const { return touches_; }

 private:
  void find_floor(const OdeBodies& bodies, base::ThreadPool& pool);
  void find_neighbors(const OdeBodies& bodies, const ContactWatch& watch, Scene::Id id,
                      FoundContacts& found) const;
  Vector3 impulse_on_a(const FoundContact& contact) const;

  world::Physics physics_;
  OdeGeom floor_;
  std::vector<FoundContacts> blocks_;
  std::size_t used_ = 0;
  std::vector<Touch> touches_;
};

}  // namespace elsie::physics
