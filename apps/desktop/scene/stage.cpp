#include "scene/stage.h"

#include <QImage>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "scene/floor_fields.h"

namespace elsie::desktop {
namespace {

// A light floor, on which the colours of teams and lines are easy to see.
constexpr Colour kFloor{226, 228, 224};
constexpr Colour kSky{244, 246, 248};
constexpr int kRound = 24;       // corners of a disc
constexpr double kDisc = 0.004;  // m: flatter objects lie on the floor as marks

Vector3 vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Frame frame_from(const Json& json) {
  return {vector_of(json.at(0)), vector_of(json.at(1)), vector_of(json.at(2)),
          vector_of(json.at(3))};
}

/// The number of a name in a list.
template <class Names>
std::uint8_t place_in(const Names& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::invalid_argument(name);
  return static_cast<std::uint8_t>(found - names.begin());
}

Colour colour_from(const Json& json) {
  return {json.at(0).get<std::uint8_t>(), json.at(1).get<std::uint8_t>(),
          json.at(2).get<std::uint8_t>()};
}

/// The pixels of a file; null if it is no image.
std::shared_ptr<const Image> image_from(const QString& file) {
  const QImage read = QImage(file).convertToFormat(QImage::Format_RGB888);
  if (read.isNull()) return nullptr;
  auto image = std::make_shared<Image>(Image{read.width(), read.height(), 3, {}});
  for (int row = 0; row < read.height(); ++row) {
    const uchar* const line = read.constScanLine(row);
    image->bytes.insert(image->bytes.end(), line,
                        line + 3 * static_cast<std::ptrdiff_t>(read.width()));
  }
  return image;
}

Shape shape_from(const Json& json) {
  Shape shape;
  shape.kind = Shape::Kind{place_in(Shape::kKinds, json.at("shape").get<std::string>())};
  shape.axis = Shape::Axis{place_in(Shape::kAxes, json.at("axis").get<std::string>())};
  shape.size = vector_of(json.at("size"));
  for (const Json& corner : member(json, "outline")) {
    shape.outline.push_back({corner.at(0).get<double>(), corner.at(1).get<double>()});
  }
  return shape;
}

Stage::Solid solid_from(const Json& json) {
  const QString role = text_of(json, "role");
  return {shape_from(json),
          frame_from(json.at("frame")),
          colour_from(json.at("colour")),
          json.at("body").get<int>(),
          text_of(json, "path"),
          role == "wheel"  ? render::Material::wheel
          : role == "wall" ? render::Material::wall
                           : render::Material::plain,
          role == "chassis" && json.at("body").get<int>() >= 0};
}

/// The frame of a wheel that has turned about its axle.
Frame turned(const Frame& frame, double by_rad) {
  const double c = std::cos(by_rad), s = std::sin(by_rad);
  return {frame.origin, c * frame.forward - s * frame.up, frame.left,
          s * frame.forward + c * frame.up};
}

/// A colour that is easy to see on another one.
Colour ink_on(const Colour& ground) {
  const int light = 3 * ground.red + 6 * ground.green + ground.blue;  // of 2550
  return light > 1500 ? Colour{45, 48, 54} : Colour{244, 246, 248};
}

render::FlatPatch patch_of(const Stage::Solid& solid, const Frame& frame) {
  std::vector<Vector2> outline;
  for (const Vector2& corner : elsie::outline_of(solid.shape, kRound)) {
    const Vector3 at = frame.point({corner.x, corner.y, 0.0});
    outline.push_back({at.x, at.y});
  }
  return {std::move(outline), solid.colour};
}

void add(render::Scene& scene, const Stage::Solid& solid, const Frame& frame) {
  const Shape& shape = solid.shape;
  if (Stage::is_patch(solid.path)) {
    scene.patches.push_back(patch_of(solid, frame));
  } else if (shape.is_round() && shape.size.z < kDisc) {
    scene.marks.push_back({{frame.origin.x, frame.origin.y}, shape.radius(), solid.colour});
  } else {
    render::add(scene, shape, solid.turned_rad == 0.0 ? frame : turned(frame, solid.turned_rad),
                solid.colour,
                solid.body < 0 ? render::kNobody : static_cast<std::size_t>(solid.body),
                solid.material);
  }
}

/// A ball that shines, with a halo and a pool of light on the floor.
void add_light(render::Scene& scene, const Stage::Solid& light, const Frame& frame, double halo,
               double pool) {
  render::add(scene, light.shape, frame, light.colour, render::kNobody, render::Material::glowing);
  scene.glows.push_back({frame.origin, halo * light.shape.radius(), pool, light.colour});
}

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Keeps the part of a ray where `at` + way * `per` is at most `most`.
void clip(double at, double per, double most, double& enters, double& leaves) {
  if (std::abs(per) < 1e-12) {
    leaves = at > most ? -kFar : leaves;
  } else if (per < 0.0) {
    enters = std::max(enters, (most - at) / per);
  } else {
    leaves = std::min(leaves, (most - at) / per);
  }
}

/// How far along a ray a solid is hit; infinite if it is not.
double way_to(const Stage::Solid& solid, const Frame& frame, const Vector3& from,
              const Vector3& direction) {
  const Vector3 aside = from - frame.origin;
  const auto in_frame = [&](const Vector3& v) {
    return Vector3{dot(v, frame.forward), dot(v, frame.left), dot(v, frame.up)};
  };
  const Vector3 at = in_frame(aside), per = in_frame(direction);
  double enters = 0.0, leaves = kFar;
  clip(at.z, per.z, 0.5 * solid.shape.size.z, enters, leaves);
  clip(-at.z, -per.z, 0.5 * solid.shape.size.z, enters, leaves);
  const std::vector<Vector2> corners = outline_of(solid.shape, kRound);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double x = b.y - a.y, y = a.x - b.x;  // outwards
    clip(x * at.x + y * at.y, x * per.x + y * per.y, x * a.x + y * a.y, enters, leaves);
  }
  return enters <= leaves ? enters : kFar;
}

}  // namespace

double heading_rad(const Frame& frame) { return std::atan2(frame.forward.y, frame.forward.x); }

bool Stage::set_scene(const Json& scene, std::uint64_t epoch) {
  epoch_ = epoch;
  bodies_.clear();
  solids_.clear();
  lights_.clear();
  marks_.clear();
  goals_.clear();
  sensors_.clear();
  if (!scene.is_object()) {
    return false;
  }
  Stage whole;
  try {
    whole.read(scene);
  } catch (const std::exception&) {  // a plugin may have damaged the engine's messages
    return false;
  }
  length_ = whole.length_;
  width_ = whole.width_;
  floor_ = whole.floor_;
  image_ = std::move(whole.image_);
  has_fields_ = whole.has_fields_;
  has_actuators_ = whole.has_actuators_;
  with_fields_.reset();
  bodies_ = std::move(whole.bodies_);
  solids_ = std::move(whole.solids_);
  chassis_.assign(bodies_.size(), -1);
  for (std::size_t i = solids_.size(); i-- > 0;) {
    if (solids_[i].is_chassis) chassis_[static_cast<std::size_t>(solids_[i].body)] = int(i);
  }
  goals_ = std::move(whole.goals_);
  sensors_ = std::move(whole.sensors_);
  is_placed_ = false;
  ground_ = image_;
  if (has_fields_) {
    std::vector<render::FlatPatch> patches;
    for (const Solid& solid : solids_) {
      if (is_patch(solid.path)) patches.push_back(patch_of(solid, solid.frame));
    }
    ground_ = with_patches(image_, floor_.value_or(kFloor), {length_, width_}, patches);
  }
  latest_s_ = 0.0;
  place();
  return true;
}

void Stage::read(const Json& scene) {
  length_ = scene.at("arena").at(0).get<double>();
  width_ = scene.at("arena").at(1).get<double>();
  const Json& floor = member(scene, "floor");
  if (const Json& colour = member(floor, "colour"); colour.is_array()) floor_ = colour_from(colour);
  if (const Json& size = member(floor, "image_size"); size.is_array()) {
    image_ = {{size.at(0).get<double>(), size.at(1).get<double>()},
              image_from(text_of(floor, "image"))};
  }
  has_fields_ = scene.value("has_fields", false);
  has_actuators_ = scene.value("has_actuators", false);
  for (const Json& each : scene.at("bodies")) {
    bodies_.push_back({text_of(each, "path"),
                       integer_of(each, "vehicle", 0),
                       {},
                       {},
                       true,
                       number_of(each, "coverage")});
  }
  std::set<std::size_t> has_colour;
  for (const Json& each : scene.at("shapes")) {
    Solid solid = solid_from(each);
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

  for (const Json& each : member(scene, "goals")) {
    const Json& at = each.at("at");
    goals_.push_back({{at.at(0).get<double>(), at.at(1).get<double>()},
                      each.at("radius").get<double>(),
                      each.at("body").get<int>(),
                      text_of(each, "whose")});
  }
  for (const Json& each : member(scene, "sensors")) {
    sensors_[text_of(each, "path")] = {each.at("body").get<int>(), frame_from(each.at("frame"))};
  }
}

void Stage::take_fields(const Json& fields) {
  try {
    with_fields_ = with_fields(ground_, floor_.value_or(kFloor), {length_, width_}, fields);
  } catch (const std::exception&) {  // a plugin may have damaged the engine's messages
    with_fields_.reset();
  }
}

void Stage::take_lights(const Json& lights) {
  lights_.clear();
  try {
    for (const Json& each : lights) lights_.push_back(solid_from(each));
  } catch (const std::exception&) {  // a plugin may have damaged the engine's messages
    lights_.clear();
  }
}

bool Stage::take(const snapshots::Snapshot& snapshot) {
  const auto differs = [](const auto& now, const auto& before) {
    return now.size() != before.size() ||
           (!now.empty() && std::memcmp(now.data(), before.data(), now.size_bytes()) != 0);
  };
  has_changed_ = facts_.epoch != snapshot.facts.epoch || differs(snapshot.bodies, states_) ||
                 differs(snapshot.marks, states_of_marks_) ||
                 // What is not stored of the past is drawn again.
                 is_past() || snapshot.facts.time_s < latest_s_;
  facts_ = snapshot.facts;
  states_.assign(snapshot.bodies.begin(), snapshot.bodies.end());
  states_of_marks_.assign(snapshot.marks.begin(), snapshot.marks.end());
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
  const std::vector<Body> before = is_placed_ ? bodies_ : std::vector<Body>();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].frame = states_[i].frame();
    bodies_[i].is_present = states_[i].present > 0.0F;
  }
  if (is_placed_) roll_wheels(before);
  is_placed_ = true;
  marks_ = states_of_marks_;
  time_s_ = facts_.time_s;
  latest_s_ = std::max(latest_s_, time_s_);
}

/// Wheels roll as far as their middles have moved ahead. A robot that was put somewhere else, or
/// that has come far since the last snapshot, has not rolled there as one would see it.
void Stage::roll_wheels(const std::vector<Body>& before) {
  constexpr double kJump = 0.5;  // m
  for (Solid& solid : solids_) {
    if (solid.material != render::Material::wheel || solid.body < 0) continue;
    const auto body = static_cast<std::size_t>(solid.body);
    const Frame now = bodies_[body].frame.frame(solid.frame);
    const Vector3 moved = now.origin - before[body].frame.point(solid.frame.origin);
    if (dot(moved, moved) > kJump * kJump || solid.shape.radius() <= 0.0) continue;
    solid.turned_rad = std::remainder(
        solid.turned_rad + dot(moved, now.forward) / solid.shape.radius(), 2.0 * std::numbers::pi);
  }
}

std::vector<Stage::Goal> Stage::goals() const {
  std::vector<Goal> goals = goals_;
  for (Goal& goal : goals) {
    const auto body = static_cast<std::size_t>(goal.body);
    if (goal.body < 0 || body >= bodies_.size()) continue;
    const Vector3 at = bodies_[body].frame.point({goal.at.x, goal.at.y, 0.0});
    goal.at = {at.x, at.y};
  }
  return goals;
}

std::optional<Frame> Stage::sensor_frame(const QString& path) const {
  const auto found = sensors_.constFind(path);
  if (found == sensors_.constEnd()) return std::nullopt;
  const auto& [body, frame] = *found;
  const auto number = static_cast<std::size_t>(body);
  if (body < 0 || number >= bodies_.size() || !bodies_[number].is_present) return std::nullopt;
  return bodies_[number].frame.frame(frame);
}

const Stage::Solid* Stage::chassis_of(const Body& body) const {
  const int solid = chassis_[static_cast<std::size_t>(&body - bodies_.data())];
  return solid < 0 ? nullptr : &solids_[static_cast<std::size_t>(solid)];
}

std::size_t Stage::carrier_of(const QString& robot) const {
  const Body* body = body_of(robot);
  return body ? static_cast<std::size_t>(body - bodies_.data()) : render::kNobody;
}

std::optional<Frame> Stage::seat_of(const QString& robot) const {
  const Body* body = body_of(robot);
  const Solid* chassis = body ? chassis_of(*body) : nullptr;
  if (!body || !chassis || !body->is_present) return std::nullopt;
  constexpr double kEyes = 0.03;  // m
  Frame seat = body->frame;
  seat.origin = frame_of(*chassis).point(
      {0.3 * chassis->shape.size.x, 0.0, 0.5 * chassis->shape.size.z + kEyes});
  return seat;
}

double Stage::height() const {
  double height = 0.0;
  for (const Solid& solid : solids_) {
    if (solid.material == render::Material::wall) height = std::max(height, solid.shape.size.z);
  }
  return height;
}

Frame Stage::frame_of(const Solid& solid) const {
  return solid.body < 0 ? solid.frame
                        : bodies_[static_cast<std::size_t>(solid.body)].frame.frame(solid.frame);
}

bool Stage::is_free(const QPointF& at, double room) const {
  return std::none_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
    const Vector3 middle = frame_of(solid).origin;
    return !solid.path.isEmpty() && !is_bodiless(solid.path) && is_present(solid) &&
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

const Stage::Solid* Stage::solid_of(const QString& path) const {
  const auto found = std::find_if(solids_.begin(), solids_.end(),
                                  [&](const Solid& solid) { return solid.path == path; });
  return found == solids_.end() || path.isEmpty() ? nullptr : &*found;
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
  scene.floor = floor_.value_or(kFloor);
  // Of the past, only bodies are known.
  const bool shows_fields = with_fields_ && !is_past();
  scene.image = shows_fields ? *with_fields_ : image_;
  scene.sky = kSky;
  for (const Solid& solid : solids_) {
    const bool is_below = shows_fields && is_patch(solid.path);  // it is in the image
    if (!is_present(solid) || is_below) continue;
    if (solid.path.startsWith("lamp[")) {
      const double height = frame_of(solid).origin.z;
      add_light(scene, solid, frame_of(solid), 7.0, std::clamp(2.0 * height, 0.7, 3.0));
      continue;
    }
    add(scene, solid, frame_of(solid));
    if (solid.is_chassis && bodies_[static_cast<std::size_t>(solid.body)].is_robot()) {
      add_front(scene, solid);
    }
  }
  for (std::size_t i = 0; !is_past() && i < lights_.size(); ++i) {
    add_light(scene, lights_[i], lights_[i].frame, 5.0, 0.2);
  }
  return scene;
}

/// An arrow on the top of a chassis, at its front.
void Stage::add_front(render::Scene& scene, const Solid& chassis) const {
  const Vector3& size = chassis.shape.size;
  const double length = 0.42 * std::min(size.x, 1.3 * size.y), half = 0.42 * length;
  const double height = std::clamp(0.04 * size.z, 0.002, 0.02);
  const Frame frame = frame_of(chassis);
  const double from_tip = chassis.shape.has_corners() ? 0.1 : 0.16;  // of the length of the chassis
  const Vector3 middle{(0.5 - from_tip) * size.x - 0.6 * length, 0.0, 0.5 * size.z};
  scene.prisms.push_back({{frame.point(middle), frame.forward, frame.left, frame.up},
                          {{0.6 * length, 0.0}, {-0.4 * length, half}, {-0.4 * length, -half}},
                          height,
                          ink_on(chassis.colour),
                          static_cast<std::size_t>(chassis.body)});
}

QString Stage::at(const Vector3& from, const Vector3& direction, double* way_there) const {
  double nearest = std::numeric_limits<double>::infinity();
  if (direction.z < 0.0) {
    nearest = -from.z / direction.z;  // the floor
  }
  QString path;
  for (const Solid& solid : solids_) {
    if (!is_present(solid)) {
      continue;
    }
    const double way = way_to(solid, frame_of(solid), from, direction);
    if (way <= nearest + 1e-9) {
      nearest = way;
      path = solid.path;
    }
  }
  if (way_there) *way_there = nearest;
  return path;
}

bool Stage::is_hidden(const Vector3& place, const Vector3& from) const {
  return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
    return is_present(solid) && !solid.path.startsWith("robot[") && !is_bodiless(solid.path) &&
           way_to(solid, frame_of(solid), from, place - from) < 1.0;
  });
}

std::vector<std::pair<Vector3, Vector3>> edges_of(const Stage::Solid& solid, const Frame& frame) {
  constexpr std::size_t kMostUpright = 16;
  const std::vector<Vector2> corners = outline_of(solid.shape, kRound);
  const double up = 0.5 * solid.shape.size.z;
  const std::size_t each = corners.size() > kMostUpright ? corners.size() / 4 : 1;
  std::vector<std::pair<Vector3, Vector3>> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    for (const double z : {-up, up}) {
      edges.emplace_back(frame.point({a.x, a.y, z}), frame.point({b.x, b.y, z}));
    }
    if (i % each == 0) {
      edges.emplace_back(frame.point({a.x, a.y, -up}), frame.point({a.x, a.y, up}));
    }
  }
  return edges;
}

}  // namespace elsie::desktop
