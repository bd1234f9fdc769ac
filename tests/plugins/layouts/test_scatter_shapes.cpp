// <scatter> of cylinders and prisms.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/world/vocabulary.h"

#include "support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// Points all around an area, at most `step` m apart, in the world.
std::vector<Vector2> outline(const world::Footprint& area, double step) {
  std::vector<Vector2> points;
  if (area.round) {
    const auto count = static_cast<int>(7.0 * area.half_length / step) + 1;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * 3.141592654 * i / count;
      points.push_back({area.x + area.half_length * std::cos(angle),
                        area.y + area.half_length * std::sin(angle)});
    }
    return points;
  }
  for (std::size_t i = 0; i < area.outline.size(); ++i) {
    const Vector2 &a = area.outline[i], &b = area.outline[(i + 1) % area.outline.size()];
    const auto count = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / step) + 1;
    for (int k = 0; k < count; ++k) {
      const double part = static_cast<double>(k) / count;
      points.push_back(point_of({area.x, area.y, area.heading_rad},
                                {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}));
    }
  }
  return points;
}

}  // namespace

TEST_CASE("Cylinders and prisms keep the gap to each other and to walls") {
  const double gap = 0.1, step = 0.01;
  const world::World world = drawn(
      "<arena length='5' width='5'/>"
      "<layouts><scatter id='a' count='20' gap='0.1'><static_cylinder radius='0.2'/></scatter>"
      "<scatter id='b' count='20' gap='0.1'><dynamic_prism><point x='0' y='0'/>"
      "<point x='0.5' y='0'/><point x='0' y='0.3'/></dynamic_prism><heading/></scatter></layouts>",
      4);
  REQUIRE(world.obstacles.size() == 40);
  const auto all = footprints(world);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<Vector2> own = outline(all[i], step);
    for (const Vector2& point : own) {
      CHECK(std::max(std::abs(point.x), std::abs(point.y)) <= 2.5 - gap + 1e-6);
    }
    for (std::size_t j = 0; j < i; ++j) {
      double nearest = 1e9;
      for (const Vector2& a : own) {
        for (const Vector2& b : outline(all[j], step)) {
          nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
        }
      }
      CHECK(nearest >= gap - 1e-6);
    }
  }
}

TEST_CASE("A density of cylinders and of prisms covers its share of the area") {
  const auto count = [](const std::string& thing) {
    return static_cast<double>(
        drawn("<layouts><scatter id='c' density='0.1'>" + thing + "</scatter></layouts>", 5)
            .obstacles.size());
  };
  CHECK(count("<static_cylinder radius='0.3'/>") * 3.141592654 * 0.09 == Approx(10.0).margin(0.2));
  CHECK(count("<static_prism><point x='1' y='0'/><point x='0' y='0.5'/><point x='0' y='0'/>"
              "</static_prism>") *
            0.25 ==
        Approx(10.0).margin(0.2));
}

TEST_CASE("All that the vocabulary has in a scatter can be scattered") {
  const world::ElementSpec& scatter = *world::vocabulary().child("layouts")->child("scatter");
  std::size_t members = 0;
  for (const world::ElementSpec& group : world::vocabulary().children) {
    if (!group.group || group.name == "layouts") continue;
    for (const world::ElementSpec& thing : group.held()) {
      if (!scatter.child(thing.name)) continue;
      CAPTURE(thing.name);
      ++members;
      std::string inside;
      if (thing.child("waypoint")) inside += "<waypoint x='1' y='1'/>";
      if (thing.child("point")) {
        inside += "<point x='1' y='0'/><point x='0' y='0.5'/><point x='0' y='0'/>";
      }
      const std::string text = text_of(
          scattered("count='2'", "<" + thing.name + ">" + inside + "</" + thing.name + ">"));
      CHECK(text.find("<" + thing.name + " id=\"c2\"") != std::string::npos);
    }
  }
  CHECK(members > 10);
}

TEST_CASE("Nests are scattered within their region, and on a grid keep apart") {
  const world::World world = drawn(
      scattered(
          "count='4'",
          "<nest radius='0.2'/><on_grid columns='2' rows='2' length='2' width='2' jitter='0.5'/>"),
      3);
  REQUIRE(world.nests.size() == 4);
  for (const world::Nest& nest : world.nests) {
    CHECK(std::max(std::abs(nest.x), std::abs(nest.y)) <= 1.0 + 1e-4);
  }
  CHECK(world.nests[0].x != world.nests[1].x);
}
