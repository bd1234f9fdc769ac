#include "scene/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace elsie::desktop {
namespace {

// A light floor on which teams' colours and lines are easy to see.
constexpr Colour kFloor{226, 228, 224};
constexpr Colour kSky{244, 246, 248};
constexpr double kDisc = 0.004;  // m: what is flatter than this lies on the floor as a mark

Vector3 vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Frame frame_from(const Json& json) {
  return {vector_of(json.at(0)), vector_of(json.at(1)), vector_of(json.at(2)),
          vector_of(json.at(3))};
}

Shape::Kind kind_of(const std::string& name) {
  return name == "box"       ? Shape::Kind::box
         : name == "sphere"  ? Shape::Kind::sphere
         : name == "capsule" ? Shape::Kind::capsule
                             : Shape::Kind::cylinder;
}

Shape::Axis axis_of(const std::string& name) {
  return name == "forward" ? Shape::Axis::forward
         : name == "left"  ? Shape::Axis::left
                           : Shape::Axis::up;
}

void add(render::Scene& scene, const Stage::Solid& solid, const Frame& frame) {
  const Shape& shape = solid.shape;
  const double radius = shape.radius();
  if (shape.kind == Shape::Kind::box) {
    scene.boxes.push_back(
        {{frame.point({0.0, 0.0, -0.5 * shape.size.z}), frame.forward, frame.left, frame.up},
         shape.size,
         solid.colour});
    return;
  }
  if (shape.kind == Shape::Kind::sphere) {
    scene.balls.push_back({frame.origin, radius, solid.colour});
    return;
  }
  if (shape.is_round() && shape.size.z < kDisc) {
    scene.marks.push_back({{frame.origin.x, frame.origin.y}, radius, solid.colour});
    return;
  }
  const bool is_capsule = shape.kind == Shape::Kind::capsule;
  const double length = shape.length() - (is_capsule ? 2.0 * radius : 0.0);
  const Frame along = along_axis(frame, shape.axis);
  // The scene's cylinders lie along their left axis.
  scene.cylinders.push_back(
      {{along.origin, along.forward, along.up, -1.0 * along.left}, radius, length, solid.colour});
  if (is_capsule) {
    scene.balls.push_back({along.point({0.0, 0.0, 0.5 * length}), radius, solid.colour});
    scene.balls.push_back({along.point({0.0, 0.0, -0.5 * length}), radius, solid.colour});
  }
}

/// How far along a ray the box of a shape is met; infinite: it is missed.
double way_to(const Shape& shape, const Frame& frame, const Vector3& from,
              const Vector3& direction) {
  const Vector3 aside = from - frame.origin;
  const std::array<Vector3, 3> axes{frame.forward, frame.left, frame.up};
  const std::array<double, 3> half{0.5 * shape.size.x, 0.5 * shape.size.y, 0.5 * shape.size.z};
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = dot(aside, axes[i]), per = dot(direction, axes[i]);
    const double a = (-half[i] - at) / per, b = (half[i] - at) / per;
    if (std::abs(per) < 1e-12) {
      if (std::abs(at) > half[i]) {
        return std::numeric_limits<double>::infinity();
      }
      continue;
    }
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves ? enters : std::numeric_limits<double>::infinity();
}

}  // namespace

double heading_rad(const Frame& frame) { return std::atan2(frame.forward.y, frame.forward.x); }

bool Stage::set_scene(const Json& scene, std::uint64_t epoch) {
  epoch_ = epoch;
  bodies_.clear();
  solids_.clear();
  views_.clear();
  beams_.clear();
  if (!scene.is_object()) {
    return false;
  }
  Stage whole;
  try {
    whole.read(scene);
  } catch (const std::exception&) {  // a plugin may have written into the engine's words
    return false;
  }
  length_ = whole.length_;
  width_ = whole.width_;
  bodies_ = std::move(whole.bodies_);
  solids_ = std::move(whole.solids_);
  views_ = std::move(whole.views_);
  latest_s_ = 0.0;
  place();
  return true;
}

void Stage::read(const Json& scene) {
  length_ = scene.at("arena").at(0).get<double>();
  width_ = scene.at("arena").at(1).get<double>();
  for (const Json& each : scene.at("bodies")) {
    bodies_.push_back({text_of(each, "path"), integer_of(each, "vehicle", 0), {}, {}, true});
  }
  std::set<std::size_t> has_colour;
  for (const Json& each : scene.at("shapes")) {
    Solid solid;
    solid.shape = {kind_of(each.at("shape").get<std::string>()), vector_of(each.at("size")),
                   axis_of(each.at("axis").get<std::string>())};
    solid.frame = frame_from(each.at("frame"));
    const Json& colour = each.at("colour");
    solid.colour = {colour.at(0).get<std::uint8_t>(), colour.at(1).get<std::uint8_t>(),
                    colour.at(2).get<std::uint8_t>()};
    solid.body = each.at("body").get<int>();
    solid.path = text_of(each, "path");
    if (solid.body >= 0) {
      const auto number = static_cast<std::size_t>(solid.body);
      Body& body = bodies_.at(number);
      solid.path = body.path;
      if (has_colour.insert(number).second) {
        body.colour = solid.colour;
      }
    }
    solids_.push_back(std::move(solid));
  }
  for (const Json& each : member(scene, "views")) {
    View view;
    view.body = each.at("body").get<std::size_t>();
    view.frame = frame_from(each.at("frame"));
    view.fov_rad = each.at("fov_rad").get<double>();
    view.aspect = each.at("height").get<double>() / each.at("width").get<double>();
    static_cast<void>(bodies_.at(view.body));
    views_.push_back(view);
  }
}

bool Stage::take(const snapshots::Snapshot& snapshot) {
  facts_ = snapshot.facts;
  states_.assign(snapshot.bodies.begin(), snapshot.bodies.end());
  states_of_beams_.assign(snapshot.beams.begin(), snapshot.beams.end());
  if (facts_.epoch != epoch_) {
    return false;
  }
  place();
  return true;
}

void Stage::place() {
  if (facts_.epoch != epoch_ || states_.size() != bodies_.size()) {
    return;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].frame = states_[i].frame();
    bodies_[i].is_present = states_[i].present > 0.0F;
  }
  beams_ = states_of_beams_;
  time_s_ = facts_.time_s;
  latest_s_ = std::max(latest_s_, time_s_);
}

Frame Stage::frame_of(const Solid& solid) const {
  return solid.body < 0 ? solid.frame
                        : bodies_[static_cast<std::size_t>(solid.body)].frame.frame(solid.frame);
}

bool Stage::is_free(const QPointF& at, double room) const {
  return std::none_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
    const Vector3 middle = frame_of(solid).origin;
    return !solid.path.isEmpty() && is_present(solid) &&
           std::hypot(at.x() - middle.x, at.y() - middle.y) <
               room + 0.5 * std::hypot(solid.shape.size.x, solid.shape.size.y);
  });
}

bool Stage::is_present(const Solid& solid) const {
  return solid.body < 0 || bodies_[static_cast<std::size_t>(solid.body)].is_present;
}

const Stage::Body* Stage::body_of(const QString& path) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                  [&](const Body& body) { return body.path == path; });
  return found == bodies_.end() ? nullptr : &*found;
}

std::optional<Frame> Stage::place_of(const QString& path) const {
  if (const Body* body = body_of(path)) {
    return body->is_present ? std::optional(body->frame) : std::nullopt;
  }
  for (const Solid& solid : solids_) {
    if (solid.path == path && !path.isEmpty()) {
      Frame frame = frame_of(solid);
      frame.origin.z = 0.0;
      return frame;
    }
  }
  return std::nullopt;
}

render::Scene Stage::drawn() const {
  render::Scene scene;
  scene.floor = kFloor;
  scene.sky = kSky;
  for (const Solid& solid : solids_) {
    if (is_present(solid)) {
      add(scene, solid, frame_of(solid));
    }
  }
  return scene;
}

QString Stage::at(const Vector3& from, const Vector3& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  if (direction.z < 0.0) {
    nearest = -from.z / direction.z;  // the floor
  }
  QString path;
  for (const Solid& solid : solids_) {
    if (!is_present(solid)) {
      continue;
    }
    const double way = way_to(solid.shape, frame_of(solid), from, direction);
    if (way <= nearest + 1e-9) {
      nearest = way;
      path = solid.path;
    }
  }
  return path;
}

std::vector<std::pair<Vector3, Vector3>> edges_of(const Shape& shape, const Frame& frame) {
  std::array<Vector3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] =
        frame.point({(i & 1U ? 0.5 : -0.5) * shape.size.x, (i & 2U ? 0.5 : -0.5) * shape.size.y,
                     (i & 4U ? 0.5 : -0.5) * shape.size.z});
  }
  std::vector<std::pair<Vector3, Vector3>> edges;
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if (!(i & bit)) {
        edges.emplace_back(corners[i], corners[i | bit]);
      }
    }
  }
  return edges;
}

}  // namespace elsie::desktop
