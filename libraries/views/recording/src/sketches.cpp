#include "sketches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/picture/hits.h"
#include "elsie/plugin/kind_name.h"

#include "entity.h"
#include "messages.h"
#include "reading.h"

namespace elsie::recording {
namespace {

constexpr const char* kMarks = "marks";  // metadata: kind, role and number of places of each mark
constexpr const char* kKinds[] = {"points", "line", "arrow", "text"};

struct RoleStyle {
  Colour colour;
  double opacity;
  double diameter_m;  // of its points
};
constexpr std::array<RoleStyle, 7> kStyles{{{{0x9a, 0x9f, 0xa6}, 0.8, 0.015},   // range
                                            {{0xd0, 0x30, 0x30}, 0.8, 0.02},    // hit
                                            {{0x2f, 0x6f, 0x9f}, 0.35, 0.04},   // field
                                            {{0x1b, 0x5f, 0xb0}, 0.9, 0.05},    // target
                                            {{0x9c, 0x2f, 0x8a}, 0.9, 0.02},    // wish
                                            {{0x5a, 0x5f, 0x6b}, 0.7, 0.03},    // belief
                                            {{0x00, 0x83, 0x8f}, 0.9, 0.02}}};  // message

const RoleStyle& style_of(SketchRole role) { return kStyles.at(static_cast<std::size_t>(role)); }
Json colour_of(SketchRole role) {
  return colour_json(style_of(role).colour, style_of(role).opacity);
}

/// Pairs of points.
Json line_list(SketchRole role) {
  constexpr int kPairs = 2;  // foxglove.LineType: LINE_LIST
  return {{"type", kPairs},          {"pose", pose_json({})},   {"thickness", 2.0},
          {"scale_invariant", true}, {"points", Json::array()}, {"color", colour_of(role)},
          {"colors", Json::array()}, {"indices", Json::array()}};
}

Json sphere(SketchRole role, const Vector3& at) {
  const double diameter_m = style_of(role).diameter_m;
  return {{"pose", pose_json({.origin = at})},
          {"size", position_json({diameter_m, diameter_m, diameter_m})},
          {"color", colour_of(role)}};
}

Json arrow(SketchRole role, const Vector3& from, const Vector3& to) {
  const Vector3 way = to - from;
  const double flat = std::hypot(way.x, way.y), length = std::hypot(flat, way.z);
  const Frame frame = Frame::turned(from, std::atan2(way.y, way.x), std::atan2(way.z, flat));
  return {{"pose", pose_json(frame)}, {"shaft_length", 0.75 * length},
          {"shaft_diameter", 0.01},   {"head_length", 0.25 * length},
          {"head_diameter", 0.025},   {"color", colour_of(role)}};
}

Json text(SketchRole role, const Vector3& at, const std::string& text) {
  return {{"pose", pose_json({.origin = at})}, {"billboard", true},        {"font_size", 0.05},
          {"scale_invariant", false},          {"color", colour_of(role)}, {"text", text}};
}

/// Adds the marks of a sketch to an entity.
void add_marks(const Sketch& sketch, Json& entity) {
  const picture::Hits hits(sketch);
  std::array<Json, kStyles.size()> lines;
  Json listed = Json::array();
  for (const Sketch::Mark& mark : sketch.marks()) {
    const auto places = sketch.places(mark);
    const SketchRole role = hits.role_of(mark);
    const auto number = static_cast<std::size_t>(role);
    listed.push_back(
        {kKinds[static_cast<std::size_t>(mark.kind)], kSketchRoles[number], mark.count});
    switch (mark.kind) {
      case Sketch::Kind::points:
        for (const Vector3& at : places) entity["spheres"].push_back(sphere(role, at));
        break;
      case Sketch::Kind::line:
        if (lines[number].is_null()) lines[number] = line_list(role);
        for (std::size_t i = 1; i < places.size(); ++i) {
          lines[number]["points"].push_back(position_json(places[i - 1]));
          lines[number]["points"].push_back(position_json(places[i]));
        }
        break;
      case Sketch::Kind::arrow:
        entity["arrows"].push_back(arrow(role, places[0], places[1]));
        break;
      case Sketch::Kind::text:
        entity["texts"].push_back(text(role, places[0], mark.text));
        break;
    }
  }
  for (Json& list : lines) {
    if (!list.is_null()) entity["lines"].push_back(std::move(list));
  }
  entity["metadata"].push_back({{"key", kMarks}, {"value", text_of(listed)}});
}

Vector3 vector_of(const Json& json) {
  return {json.at("x").get<double>(), json.at("y").get<double>(), json.at("z").get<double>()};
}

Vector3 place_of(const Json& primitive) { return vector_of(primitive.at("pose").at("position")); }

/// The point of an arrow, from its rotated x axis.
Vector3 end_of(const Json& arrow) {
  const Json& turn = arrow.at("pose").at("orientation");
  const Vector3 v = vector_of(turn);
  const double w = turn.at("w").get<double>();
  const Vector3 forward{1.0 - 2.0 * (v.y * v.y + v.z * v.z), 2.0 * (v.x * v.y + w * v.z),
                        2.0 * (v.x * v.z - w * v.y)};
  const double length =
      arrow.at("shaft_length").get<double>() + arrow.at("head_length").get<double>();
  return place_of(arrow) + length * forward;
}

template <std::size_t N>
std::size_t place_in(const char* const (&words)[N], const std::string& word) {
  const auto found = std::find(std::begin(words), std::end(words), word);
  if (found == std::end(words)) throw Unexpected("it has a mark '" + word + "'");
  return static_cast<std::size_t>(found - std::begin(words));
}

/// Takes the marks of an entity in the order of its metadata.
class MarkReader {
 public:
  explicit MarkReader(const Json& entity)
      : entity_(entity),
        marks_(Json::parse(entity.at("metadata").at(0).at("value").get<std::string>())) {
    std::set<std::size_t> roles;
    for (const Json& mark : marks_) {
      if (mark.at(0) == "line") roles.insert(role_of(mark));
    }
    std::size_t next = 0;
    for (const std::size_t role : roles) lists_[role] = next++;
  }

  Sketch read() {
    Sketch sketch(Frame{});
    for (const Json& mark : marks_) {
      const auto kind = static_cast<Sketch::Kind>(place_in(kKinds, mark.at(0).get<std::string>()));
      add(kind, role_of(mark), mark.at(2).get<std::size_t>(), sketch);
    }
    return sketch;
  }

 private:
  static std::size_t role_of(const Json& mark) {
    return place_in(kSketchRoles, mark.at(1).get<std::string>());
  }

  void add(Sketch::Kind kind, std::size_t number, std::size_t count, Sketch& sketch) {
    const auto role = static_cast<SketchRole>(number);
    std::vector<Vector3> places;
    switch (kind) {
      case Sketch::Kind::points:
        for (std::size_t i = 0; i < count; ++i) {
          places.push_back(place_of(entity_.at("spheres").at(next_sphere_++)));
        }
        sketch.points(role, places);
        break;
      case Sketch::Kind::line: {
        const Json& points = entity_.at("lines").at(lists_[number]).at("points");
        std::size_t& next = next_point_[number];
        for (std::size_t i = 0; i + 1 < count; ++i, next += 2) {
          if (i == 0) places.push_back(vector_of(points.at(next)));
          places.push_back(vector_of(points.at(next + 1)));
        }
        sketch.line(role, places);
        break;
      }
      case Sketch::Kind::arrow: {
        const Json& arrow = entity_.at("arrows").at(next_arrow_++);
        sketch.arrow(role, place_of(arrow), end_of(arrow));
        break;
      }
      case Sketch::Kind::text: {
        const Json& text = entity_.at("texts").at(next_text_++);
        sketch.text(role, place_of(text), text.at("text").get<std::string>());
        break;
      }
    }
  }

  const Json& entity_;
  Json marks_;
  std::array<std::size_t, kStyles.size()> lists_{};  // which list of lines a role has
  std::array<std::size_t, kStyles.size()> next_point_{};
  std::size_t next_sphere_ = 0, next_arrow_ = 0, next_text_ = 0;
};

}  // namespace

Json sketches_message(std::uint64_t time_ns, std::uint64_t lifetime_ns, const std::string& whose,
                      std::span<const simulation::PluginSketch> sketches) {
  Json entities = Json::array();
  std::set<std::string> ids;
  for (const simulation::PluginSketch& each : sketches) {
    std::string id = whose + "/" + each.path;
    // A behaviour and a coordinator may have the same path.
    if (!ids.insert(id).second) id += " " + std::string(plugin::kind_name(each.kind));
    Json made = entity(time_ns, id, kWorldFrame);
    made["lifetime"] = time_json(lifetime_ns);
    add_marks(each.sketch, made);
    entities.push_back(std::move(made));
  }
  return {{"deletions", Json::array()}, {"entities", std::move(entities)}};
}

std::vector<Sketch> sketches_of(const Json& message) {
  std::vector<Sketch> sketches;
  try {
    for (const Json& entity : message.at("entities")) {
      sketches.push_back(MarkReader(entity).read());
    }
  } catch (const base::Error& error) {  // of Sketch
    throw Unexpected(error.what());
  }
  return sketches;
}

}  // namespace elsie::recording
