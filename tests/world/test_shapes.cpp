// The table of shapes: what it says of a shape agrees.
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/shapes/outline.h"
#include "elsie/shapes/shape.h"
#include "elsie/world/parts.h"

using namespace elsie;

namespace {

const std::vector<Vector2> kTriangle{{-0.2, -0.1}, {0.4, -0.1}, {-0.2, 0.2}};

std::vector<Shape> one_of_each_kind() {
  return {Shape::box({0.2, 0.3, 0.4}), Shape::wheel(0.2, 0.1), Shape::sphere(0.2),
          Shape::capsule(0.1, 0.5), Shape::prism(kTriangle, 0.3)};
}

bool is_within(const std::vector<Vector2>& corners, double x, double y) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((b.x - a.x) * (y - a.y) < (b.y - a.y) * (x - a.x)) return false;
  }
  return true;
}

bool is_in(const Piece& piece, const Vector3& point) {
  const Vector3 from = point - piece.frame.origin, half = 0.5 * piece.shape.size;
  const double x = dot(from, piece.frame.forward), y = dot(from, piece.frame.left),
               z = dot(from, piece.frame.up);
  if (piece.shape.kind == Shape::Kind::sphere) {
    return std::sqrt(dot(from, from)) <= piece.shape.radius();
  }
  return std::abs(z) <= half.z && is_within(outline_of(piece.shape, 100), x, y);
}

}  // namespace

TEST_CASE("The pieces of a shape fill it: their moments are its moments") {
  const std::vector<Shape> shapes = one_of_each_kind();
  REQUIRE(shapes.size() == Shape::kKinds.size());
  for (const Shape& shape : shapes) {
    INFO(Shape::kKinds.at(static_cast<std::size_t>(shape.kind)));
    CHECK(is_sound(shape));
    const std::vector<Piece> pieces = pieces_of(shape, {});
    constexpr int kSteps = 60;
    double count = 0.0, x = 0.0, y = 0.0, z = 0.0;
    const auto at = [](int i) { return (i + 0.5) / kSteps - 0.5; };
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        for (int k = 0; k < kSteps; ++k) {
          const Vector3 p{at(i) * shape.size.x, at(j) * shape.size.y, at(k) * shape.size.z};
          if (std::none_of(pieces.begin(), pieces.end(),
                           [&](const Piece& piece) { return is_in(piece, p); })) {
            continue;
          }
          ++count;
          x += p.x * p.x;
          y += p.y * p.y;
          z += p.z * p.z;
        }
      }
    }
    const Vector3 moments = inertia_of(shape, 2.0);
    CHECK(moments.x == Approx(2.0 * (y + z) / count).epsilon(0.02));
    CHECK(moments.y == Approx(2.0 * (x + z) / count).epsilon(0.02));
    CHECK(moments.z == Approx(2.0 * (x + y) / count).epsilon(0.02));
    CHECK(upright_inertia_of(shape, 2.0) == Approx(moments.z));
    CHECK(spread_of(shape) == Approx(0.5 * moments.z));
  }
}

TEST_CASE("A resized shape has the new size, and a round one stays round") {
  const Shape box = resized(Shape::box({0.2, 0.3, 0.4}), 0.5, 0.6);
  CHECK(box.size == Vector3{0.5, 0.6, 0.4});
  const Shape pillar = resized(Shape::pillar(0.1, 0.4), 0.25, 0.6);
  CHECK(pillar.radius() == 0.3);
  CHECK(is_sound(pillar));
  const Shape prism = resized(Shape::prism(kTriangle, 0.3), 1.6, 0.2);
  CHECK(prism.outline[1].x == Approx(0.8));
  CHECK(prism.outline[2].y == Approx(0.1));
}

TEST_CASE("A shape whose size does not fit its kind is not sound") {
  Shape capsule = Shape::capsule(0.1, 0.5);
  capsule.size.z = 0.15;
  CHECK_FALSE(is_sound(capsule));
  Shape pillar = Shape::pillar(0.1, 0.5);
  pillar.size.y = 0.1;
  CHECK_FALSE(is_sound(pillar));
  CHECK_FALSE(is_sound(Shape::box({0.1, NAN, 0.1})));
  CHECK_FALSE(is_sound(Shape::prism({{0, 0}, {1, 0}}, 0.2)));
}

TEST_CASE("No part of a robot is a prism") {
  BodyPlan plan = world::plan_of(world::RobotBody{}, {});
  plan.parts[0].shape = Shape::prism(kTriangle, 0.1);
  CHECK_THROWS_WITH(world::check(plan), Catch::Contains("only obstacles can be prisms"));
}
