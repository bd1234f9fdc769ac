#include "marks.h"

#include "elsie/picture/hits.h"
#include "elsie/shapes/shape.h"
#include "elsie/simulation/fault.h"
#include "elsie/world/parts.h"

namespace elsie::server {

using simulation::RobotView;
using simulation::Simulation;
using snapshots::MarkState;

void Marks::list(const Simulation& simulation) {
  marks_.clear();
  left_out_ = 0;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const RobotView robot = simulation.robot(i);
    add_all(robot.description->id, [&] { return simulation.sketches(i); });
    if (robot.description->localisation) add_belief(robot);
  }
  add_all("", [&] { return simulation.sketches(); });
}

template <class List>
void Marks::add_all(const std::string& whose, const List& list) {
  if (failed_.contains(whose)) return;
  try {
    for (const simulation::PluginSketch& each : list()) add(each.sketch);
  } catch (const simulation::PluginFault& fault) {
    failed_.insert(whose);
    notes_.push_back(
        {fault.robot, fault.id,
         std::string("sketches are not drawn from now on, until an edit or a reset: ") +
             fault.what()});
  }
}

void Marks::add(const Sketch& sketch) {
  const picture::Hits hits(sketch);
  for (const Sketch::Mark& mark : sketch.marks()) {
    const auto places = sketch.places(mark);
    const SketchRole role = hits.role_of(mark);
    switch (mark.kind) {
      case Sketch::Kind::points:
        for (const Vector3& at : places) add(mark.kind, role, at, at);
        break;
      case Sketch::Kind::line:
        for (std::size_t i = 1; i < places.size(); ++i) {
          add(mark.kind, role, places[i - 1], places[i]);
        }
        break;
      case Sketch::Kind::arrow:
        add(mark.kind, role, places[0], places[1]);
        break;
      case Sketch::Kind::text:
        add(mark.kind, role, places[0], places[0], mark.text);
        break;
    }
  }
}

/// The outline of its chassis on the floor, and a line ahead.
void Marks::add_belief(const RobotView& robot) {
  const Pose& pose = robot.state->pose;
  const Frame frame = Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0);
  const Part chassis = world::plan_of(*robot.description).parts.front();
  constexpr int kRound = 24;  // corners of a disc
  const std::vector<Vector2> corners = outline_of(chassis.shape, kRound);
  const auto place = [&](const Vector2& corner) {
    return frame.point(chassis.frame.point({corner.x, corner.y, 0.0}));
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add(Sketch::Kind::line, SketchRole::belief, place(corners[i]),
        place(corners[(i + 1) % corners.size()]));
  }
  add(Sketch::Kind::line, SketchRole::belief, place({}), place({0.5 * chassis.shape.size.x, 0.0}));
}

void Marks::add(Sketch::Kind kind, SketchRole role, const Vector3& from, const Vector3& to,
                std::string_view text) {
  if (marks_.size() == kMost) {
    ++left_out_;
    return;
  }
  marks_.push_back(MarkState::of(kind, role, from, to, text));
}

}  // namespace elsie::server
