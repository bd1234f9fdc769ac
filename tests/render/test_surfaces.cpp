// The appearance of things: shapes and colours.
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

double brightness(const Colour& colour) {
  return std::max({colour.red, colour.green, colour.blue}) / 255.0;
}

}  // namespace

TEST_CASE("Every face of a box keeps hue and saturation of its colour, and is not too dark") {
  Scene scene;
  scene.boxes = {cube({0, 0, 5}, 1.0, kRed)};
  std::set<int> shades;
  for (const auto& [yaw, pitch, eye] : {std::tuple{0.0, 0.0, Vector3{-3, 0, 5}},
                                        {180.0, 0.0, Vector3{3, 0, 5}},
                                        {90.0, 0.0, Vector3{0, -3, 5}},
                                        {-90.0, 0.0, Vector3{0, 3, 5}},
                                        {0.0, -90.0, Vector3{0, 0, 8}},
                                        {0.0, 90.0, Vector3{0, 0, 2}}}) {
    CAPTURE(yaw, pitch);
    const Image picture = take(scene, view_from(eye, yaw, pitch));
    const Colour middle = colour_at(picture, 50, 50);
    CHECK(shows(middle, kRed));
    const double light = brightness(middle) / brightness(kRed);
    CHECK(light >= kDarkestShade - 0.005);
    CHECK(light <= 1.0);
    shades.insert(middle.red);
    // Each face is evenly lit.
    const Patch patch = find(picture, kRed);
    for (const int column : {patch.left, patch.right}) {
      for (const int row : {patch.top, patch.bottom}) {
        CHECK(colour_at(picture, column, row) == middle);
      }
    }
  }
  CHECK(shades.size() == 6);  // neighbouring faces can be distinguished
}

TEST_CASE("A box that floats or is tilted is seen as such") {
  // A long stick, tilted about the camera's axis by 30 degrees.
  Box stick;
  const double tilt = radians(30);
  stick.frame.left = {0.0, std::cos(tilt), std::sin(tilt)};
  stick.frame.up = {0.0, -std::sin(tilt), std::cos(tilt)};
  stick.size = {0.02, 0.6, 0.02};
  stick.frame.origin = Vector3{2, 0, 1} - 0.01 * stick.frame.up;
  stick.colour = kRed;
  Scene scene;
  scene.boxes = {stick};
  const Image picture = take(scene, view_from({0, 0, 1}));
  const double half = 50.0 / std::tan(radians(15)) * 0.3 / 2.0;  // px
  const Patch seen = find(picture, kRed);
  CHECK(seen.column == Approx(50).margin(1));
  CHECK(seen.row == Approx(50).margin(1));
  CHECK(seen.right - seen.left == Approx(2 * half * std::cos(tilt)).margin(2.5));
  CHECK(seen.bottom - seen.top == Approx(2 * half * std::sin(tilt)).margin(2.5));
  // Its left end is the upper one.
  CHECK(shows(colour_at(picture, seen.left + 2, seen.top + 2), kRed));
  CHECK_FALSE(shows(colour_at(picture, seen.right - 2, seen.top + 2), kRed));
}

TEST_CASE("A wheel is round from the side and a bar from the front") {
  Scene scene;
  Cylinder wheel;
  wheel.frame = Frame::turned({0, 0, 1}, 0.0, 0.0);
  wheel.radius = 0.3;
  wheel.length = 0.1;
  wheel.colour = kGreen;
  scene.cylinders = {wheel};
  const double scale = 50.0 / std::tan(radians(15));  // px for a unit of slope

  for (const double side : {1.0, -1.0}) {
    const Image picture = take(scene, view_from({0, side * 2.05, 1}, -side * 90.0));
    const Patch seen = find(picture, kGreen);
    const double radius = scale * 0.3 / 2.0;
    CHECK(seen.right - seen.left + 1 == Approx(2 * radius).margin(2));
    CHECK(seen.bottom - seen.top + 1 == Approx(2 * radius).margin(2));
    CHECK(seen.area == Approx(std::numbers::pi * radius * radius).epsilon(0.04));
    CHECK(colour_at(picture, 40, 50) == colour_at(picture, 60, 50));  // one flat face
  }

  const Patch front = find(take(scene, view_from({-2.3, 0, 1})), kGreen);
  CHECK(front.right - front.left + 1 == Approx(scale * 0.1 / 2.0).margin(2));
  CHECK(front.bottom - front.top + 1 == Approx(scale * 0.6 / 2.3).margin(3));
}

TEST_CASE("A ball is round from every side, and lighter above") {
  Scene scene;
  scene.balls = {{{0, 0, 1}, 0.3, kGreen}};
  const double radius = 50.0 / std::tan(radians(15)) * 0.3 / 2.0;  // px
  for (const double side : {0.0, 30.0, 90.0, 215.0}) {
    CAPTURE(side);
    const Vector3 at{-2 * std::cos(radians(side)), -2 * std::sin(radians(side)), 1};
    const Image picture = take(scene, view_from(at, side));
    const Patch seen = find(picture, kGreen);
    CHECK(seen.right - seen.left + 1 == Approx(2 * radius).margin(3));
    CHECK(seen.bottom - seen.top + 1 == Approx(2 * radius).margin(3));
    CHECK(seen.area == Approx(std::numbers::pi * radius * radius).epsilon(0.06));
    CHECK(colour_at(picture, 50, 35).green > colour_at(picture, 50, 65).green);
  }
  View own = view_from({-2, 0, 1});
  own.carrier = 3;
  scene.balls[0].carrier = 3;
  CHECK(find(take(scene, own), kGreen).area == 0);
}

TEST_CASE("A mark is a disc on the floor, below whatever stands there") {
  Scene scene;
  scene.marks = {{{0, 0}, 0.5, kGreen}, {{0.5, 0}, 0.2, kBlue}};
  const View above = view_from({0, 0, 3}, 0, -90);
  const double scale = 50.0 / std::tan(radians(15)) / 3.0;  // px/m
  const double radius = 0.5 * scale, small = 0.2 * scale;
  const Patch alone = find(take(scene, above), kGreen);
  CHECK(alone.right - alone.left + 1 == Approx(2 * radius).margin(2));
  CHECK(find(take(scene, above), kBlue).area ==
        Approx(std::numbers::pi * small * small).epsilon(0.05));
  CHECK(shows(colour_at(take(scene, above), 50, 50), kGreen));
  CHECK(colour_at(take(scene, above), 50, 50) == kGreen);  // in full light
  scene.boxes = {cube({0, 0, 0.1}, 0.2, kRed)};
  const Image covered = take(scene, above);
  CHECK(shows(colour_at(covered, 50, 50), kRed));
  CHECK(find(covered, kGreen).area < alone.area);

  // From the side and far away, the mark is still whole, not mixed with the floor.
  scene.boxes.clear();
  const Image low = take(scene, view_from({-4, 0, 0.2}, 0, -3));
  const Patch seen = find(low, kGreen);
  for (int column = seen.left + 4; column <= seen.right - 4; ++column) {
    CHECK_FALSE(colour_at(low, column, (seen.top + seen.bottom) / 2) == scene.floor);
  }
}

TEST_CASE("The floor goes to the horizon, which is level with the camera; above is the sky") {
  Scene scene;
  for (const double height : {0.05, 0.1, 1.0}) {
    const Image picture = take(scene, view_from({3, -2, height}, 25));
    for (const int column : {0, 30, 99}) {
      CHECK(colour_at(picture, column, 0) == scene.sky);
      CHECK(colour_at(picture, column, 49) == scene.sky);
      CHECK(colour_at(picture, column, 50) == scene.floor);
      CHECK(colour_at(picture, column, 99) == scene.floor);
    }
  }
  const Image up = take(scene, view_from({0, 0, 0.1}, 0, 40));
  CHECK(colour_at(up, 0, 99) == scene.sky);
  CHECK(colour_at(up, 99, 99) == scene.sky);
}

TEST_CASE("What is not visible is not seen") {
  Scene scene;
  scene.boxes = {cube({1, 0, 1}, 0.2, kRed)};
  scene.boxes[0].visible = false;
  CHECK(find(take(scene, view_from({0, 0, 1})), kRed).area == 0);
}

TEST_CASE("Patches lie on the floor in their order, below marks and whatever stands there") {
  Scene scene;
  const View above = view_from({0, 0, 3}, 0, -90);          // x is up in the picture, y to the left
  const double scale = 50.0 / std::tan(radians(15)) / 3.0;  // px/m
  const auto pixel = [&](const Image& picture, double x, double y) {
    return colour_at(picture, static_cast<int>(50 - y * scale), static_cast<int>(50 - x * scale));
  };
  const std::vector<Vector2> square{{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}};
  scene.patches = {{square, kGreen}, {{{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}}, kBlue}};
  const Image picture = take(scene, above);
  CHECK(pixel(picture, -0.28, -0.18) == kGreen);
  CHECK(pixel(picture, 0.1, 0.1) == kBlue);
  CHECK(pixel(picture, -0.1, 0.3) == scene.floor);
  CHECK(find(picture, kGreen).area + 2 * find(picture, kBlue).area ==
        Approx(scale * scale * (0.6 * 0.4 - 0.3 * 0.2 + 0.25)).epsilon(0.05));
  scene.marks = {{{0.1, 0.1}, 0.05, kRed}};
  scene.boxes = {cube({-0.2, 0, 0.1}, 0.1, kRed)};
  CHECK(pixel(take(scene, above), 0.1, 0.1) == kRed);
  CHECK(shows(pixel(take(scene, above), -0.2, 0.0), kRed));
}

TEST_CASE("The image of a floor has its first row in the north, and its pixels as they are") {
  Scene scene;
  const Image pixels{2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 200, 200, 0}};
  scene.image = {{0.8, 0.4}, std::make_shared<const Image>(pixels)};
  const View above = view_from({0, 0, 3}, 90, -90);         // north is up in the picture
  const double scale = 50.0 / std::tan(radians(15)) / 3.0;  // px/m
  const auto pixel = [&](const Image& picture, double x, double y) {
    return colour_at(picture, static_cast<int>(50 + x * scale), static_cast<int>(50 - y * scale));
  };
  const Image picture = take(scene, above);
  CHECK(pixel(picture, -0.38, 0.18) == Colour{255, 0, 0});
  CHECK(pixel(picture, 0.38, 0.18) == Colour{0, 255, 0});
  CHECK(pixel(picture, -0.02, -0.02) == Colour{0, 0, 255});
  CHECK(pixel(picture, 0.38, -0.18) == Colour{200, 200, 0});
  CHECK(pixel(picture, 0.42, 0.1) == scene.floor);
  // Patches and boxes are above it, and the next picture has another image, or none.
  scene.patches = {{{{0.1, 0.05}, {0.3, 0.05}, {0.3, 0.15}, {0.1, 0.15}}, kRed}};
  CHECK(pixel(take(scene, above), 0.2, 0.1) == kRed);
  scene.patches.clear();
  Image other = pixels;
  other.bytes[0] = 9;
  scene.image.pixels = std::make_shared<const Image>(other);
  CHECK(pixel(take(scene, above), -0.38, 0.18) == Colour{9, 0, 0});
  scene.image.pixels = nullptr;
  const Image plain = take(scene, above);
  CHECK(plain.bytes == take(Scene(), above).bytes);
}
