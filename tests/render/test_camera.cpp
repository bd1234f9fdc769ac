// Where objects appear: the pinhole model of elsie::Camera.
#include <catch2/catch.hpp>

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

Scene with(std::vector<Box> boxes) {
  Scene scene;
  scene.boxes = std::move(boxes);
  return scene;
}

/// The pixel at which elsie::Camera sees a direction: `left` and `up` are its components along the
/// camera's left and up axes for one unit along its axis.
double column_of(const Camera& camera, double left) {
  const double half = 0.5 * camera.width;
  return half - half * left / std::tan(0.5 * camera.horizontal_fov_rad);
}
double row_of(const Camera& camera, double up) {
  const double half = 0.5 * camera.width;  // pixels are square
  return 0.5 * camera.height - half * up / std::tan(0.5 * camera.horizontal_fov_rad);
}

}  // namespace

TEST_CASE("A thing at an angle from the axis is seen in the column that the pinhole model says") {
  for (const Camera camera : {Camera{100, 100, radians(30)}, Camera{160, 60, radians(30)},
                              Camera{64, 128, radians(70)}, Camera{500, 400, radians(120)}}) {
    const double half_fov = 0.5 * degrees(camera.horizontal_fov_rad);
    for (const double part : {-0.9, -0.5, -0.1, 0.0, 0.3, 0.8}) {
      for (const double distance : {0.5, 2.0, 6.0}) {
        const double angle = radians(part * half_fov);
        const double pixel = distance * std::tan(radians(half_fov)) / (0.5 * camera.width);
        const double edge = 2.5 * pixel;
        const Scene scene =
            with({cube({distance * std::cos(angle), distance * std::sin(angle), 1}, edge, kRed)});
        const Patch seen = find(take(scene, view_from({0, 0, 1}, 0, 0, camera)), kRed);
        CAPTURE(camera.width, half_fov, part, distance, seen.area);
        REQUIRE(seen.area > 0);
        CHECK(std::abs(seen.column - column_of(camera, std::tan(angle))) <= 1.0);
        CHECK(std::abs(seen.row - 0.5 * camera.height) <= 1.0);
      }
    }
  }
}

TEST_CASE("A thing above or below the axis is seen in the row that follows from square pixels") {
  for (const Camera camera : {Camera{100, 100, radians(30)}, Camera{160, 60, radians(60)},
                              Camera{64, 128, radians(50)}}) {
    for (const double rise : {-0.2, -0.1, 0.0, 0.15, 0.2}) {
      const Scene scene = with({cube({2, 0, 1 + 2 * rise}, 0.05, kRed)});
      const Patch seen = find(take(scene, view_from({0, 0, 1}, 0, 0, camera)), kRed);
      CAPTURE(camera.width, rise, seen.area);
      REQUIRE(seen.area > 0);
      CHECK(std::abs(seen.row - row_of(camera, rise)) <= 1.0);
      CHECK(std::abs(seen.column - 0.5 * camera.width) <= 1.0);
    }
  }
}

TEST_CASE("A thing is as large as its angle") {
  // A face of 0.2 m at 2 m, perpendicular to the axis.
  const double half = 0.1;
  const Patch seen =
      find(take(with({cube({2 + half, 0, 1}, 2 * half, kRed)}), view_from({0, 0, 1})), kRed);
  const double pixels = 50.0 * half / 2.0 / std::tan(radians(15));
  CHECK(std::abs(seen.right - seen.left + 1 - 2 * pixels) <= 1.0);
  CHECK(std::abs(seen.bottom - seen.top + 1 - 2 * pixels) <= 1.0);
  CHECK(seen.area == (seen.right - seen.left + 1) * (seen.bottom - seen.top + 1));
}

TEST_CASE("A camera looks where its frame looks: yaw, pitch and roll") {
  const Vector3 eye{1.0, -2.0, 1.5};
  for (const double yaw : {0.0, 40.0, 135.0, -90.0}) {
    for (const double pitch : {0.0, 35.0, -60.0}) {
      const View view = view_from(eye, yaw, pitch);
      CAPTURE(yaw, pitch);
      // Two units ahead, a little to the left, a little more up.
      const Vector3 there = view.frame.point({2.0, 0.15, 0.3});
      const Patch seen = find(take(with({cube(there, 0.05, kRed)}), view), kRed);
      REQUIRE(seen.area > 0);
      CHECK(std::abs(seen.column - column_of(view.camera, 0.075)) <= 1.0);
      CHECK(std::abs(seen.row - row_of(view.camera, 0.15)) <= 1.0);

      // The camera on its left side: up is to the right.
      View rolled = view;
      rolled.frame.up = view.frame.left;
      rolled.frame.left = -1.0 * view.frame.up;
      const Patch turned = find(take(with({cube(there, 0.05, kRed)}), rolled), kRed);
      CHECK(std::abs(turned.column - column_of(view.camera, -0.15)) <= 1.0);
      CHECK(std::abs(turned.row - row_of(view.camera, 0.075)) <= 1.0);
    }
  }
}

TEST_CASE("The first row is the top of the picture, the first column its left") {
  const Scene scene = with({cube({2, 0.3, 1.3}, 0.1, kRed), cube({2, -0.3, 0.7}, 0.1, kBlue)});
  const Image picture = take(scene, view_from({0, 0, 1}));
  CHECK(find(picture, kRed).column < 40);
  CHECK(find(picture, kRed).row < 40);
  CHECK(find(picture, kBlue).column > 60);
  CHECK(find(picture, kBlue).row > 60);
}

TEST_CASE("Things behind the camera or outside of its field of view are not seen") {
  for (const Vector3 place : {Vector3{-2, 0, 1}, Vector3{0, 2, 1}, Vector3{2, 0.7, 1},
                              Vector3{2, -0.7, 1}, Vector3{2, 0, 1.7}, Vector3{-0.02, 0, 1}}) {
    CAPTURE(place.x, place.y, place.z);
    const Image picture = take(with({cube(place, 0.02, kRed)}), view_from({0, 0, 1}));
    CHECK(find(picture, kRed).area == 0);
  }
}

TEST_CASE("Surfaces from one centimetre in front of the camera are seen, nearer ones are not") {
  const auto area = [](double distance) {
    // A thin plate across the axis.
    Box plate;
    plate.frame.origin = {distance, 0.0, 0.0};
    plate.size = {0.001, 1.0, 2.0};
    plate.colour = kRed;
    return find(take(with({plate}), view_from({0, 0, 1})), kRed).area;
  };
  CHECK(area(0.012) == 100 * 100);
  CHECK(area(0.005) == 0);
}

TEST_CASE("The nearer of two things hides the other, whatever their order") {
  Box near_box = cube({1, 0, 1}, 0.2, kRed), far_box = cube({2, 0, 1}, 0.2, kBlue);
  Box beside = cube({3, 0.5, 1}, 0.2, kGreen);
  for (const auto& boxes :
       {std::vector{near_box, far_box, beside}, std::vector{far_box, beside, near_box}}) {
    const Image picture = take(with(boxes), view_from({0, 0, 1}));
    CHECK(find(picture, kBlue).area == 0);
    CHECK(find(picture, kRed).area > 100);
    CHECK(find(picture, kGreen).area > 50);
  }
}

TEST_CASE("Surfaces a millimetre apart at three metres do not shine through each other") {
  const auto plate = [](double x, const Colour& colour) {
    Box box;
    box.frame = Frame::turned({x, 0, 0}, radians(20), 0);
    box.size = {0.0001, 1.0, 1.0};
    box.colour = colour;
    return box;
  };
  const Image picture = take(with({plate(3.0, kRed), plate(3.001, kBlue)}), view_from({0, 0, 0.5}));
  CHECK(find(picture, kRed).area > 1000);
  CHECK(find(picture, kBlue).area == 0);
}

TEST_CASE("A camera that is carried does not see its carrier, and one that is not sees all") {
  Scene scene = with({cube({1, 0, 1}, 0.2, kRed), cube({2, 0, 1}, 0.3, kBlue)});
  scene.boxes[0].carrier = 7;
  scene.cylinders.push_back({{.origin = {1, 0.12, 1}}, 0.05, 0.02, kGreen, 7});
  View view = view_from({0, 0, 1});
  CHECK(find(take(scene, view), kRed).area > 0);
  CHECK(find(take(scene, view), kGreen).area > 0);
  view.carrier = 3;
  CHECK(find(take(scene, view), kRed).area > 0);
  view.carrier = 7;
  CHECK(find(take(scene, view), kRed).area == 0);
  CHECK(find(take(scene, view), kGreen).area == 0);
  CHECK(find(take(scene, view), kBlue).area > 0);
}
