// Many cameras at once.
#include <catch2/catch.hpp>

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

/// Boxes, cylinders, balls and marks all around.
Scene busy_scene() {
  Scene scene;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.7 * i, away = 0.8 + 0.05 * i;
    Box box = cube({away * std::cos(angle), away * std::sin(angle), 0.1}, 0.2,
                   i % 3 == 0   ? kRed
                   : i % 3 == 1 ? kGreen
                                : kBlue);
    box.frame = Frame::turned(box.frame.origin, 0.3 * i, 0.2 * (i % 5));
    scene.boxes.push_back(box);
    scene.cylinders.push_back(
        {Frame::turned({away * std::sin(angle), away * std::cos(angle), 0.1}, 0.4 * i, 0.0), 0.1,
         0.05, kBlue});
    scene.balls.push_back({{-away * std::sin(angle), away * std::cos(angle), 0.2}, 0.07, kRed});
    scene.marks.push_back({{away * std::sin(angle), -away * std::cos(angle)}, 0.2, kGreen});
  }
  return scene;
}

std::vector<View> views_around(int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    views.push_back(view_from({0.2 * std::cos(i), 0.2 * std::sin(i), 0.1 + 0.01 * (i % 7)},
                              37.0 * i, 5.0 * (i % 3) - 5.0));
  }
  return views;
}

}  // namespace

TEST_CASE("The same scene and views give the same bytes") {
  const Scene scene = busy_scene();
  const auto views = views_around(12);
  Renderer one, other;
  const auto first = take(scene, views, one);
  take({}, {view_from({0, 0, 1})}, one);  // another picture in between
  const auto again = take(scene, views, one);
  const auto elsewhere = take(scene, views, other);
  for (std::size_t i = 0; i < views.size(); ++i) {
    CHECK(first[i].bytes == again[i].bytes);
    CHECK(first[i].bytes == elsewhere[i].bytes);
  }
}

TEST_CASE("A picture taken with others equals the one taken alone") {
  const Scene scene = busy_scene();
  auto views = views_around(24);
  for (std::size_t i = 0; i < views.size(); ++i) {  // of many sizes
    views[i].camera.width = 20 + static_cast<int>(37 * i % 90);
    views[i].camera.height = 15 + static_cast<int>(53 * i % 110);
    views[i].camera.horizontal_fov_rad = radians(30.0 + static_cast<double>(i));
  }
  const auto together = take(scene, views);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Image alone = take(scene, views[i]);
    CAPTURE(i);
    REQUIRE(together[i].width == views[i].camera.width);
    REQUIRE(together[i].height == views[i].camera.height);
    REQUIRE(together[i].channels == 3);
    REQUIRE(together[i].bytes.size() == alone.bytes.size());
    // An edge may fall to the other side of a pixel's middle, because pictures begin at different
    // places in the card's memory.
    CHECK(differing_pixels(together[i], alone) <= 2);
  }
}

TEST_CASE("Neighbours in a batch do not reach into each other's pictures") {
  Scene scene;
  scene.boxes = {cube({2, 0, 1}, 3.0, kRed), cube({-2, 0, 1}, 3.0, kBlue)};
  std::vector<View> views;
  for (int i = 0; i < 30; ++i) {
    View view = view_from({0, 0, 1}, i % 2 == 0 ? 0.0 : 180.0);
    view.camera.width = 61;
    view.camera.height = 47;
    views.push_back(view);
  }
  const auto pictures = take(scene, views);
  for (std::size_t i = 0; i < views.size(); ++i) {
    CHECK(find(pictures[i], i % 2 == 0 ? kRed : kBlue).area == 61 * 47);
  }
}

TEST_CASE("More pictures than fit at once, and large ones, are also taken") {
  const Scene scene = busy_scene();
  auto views = views_around(1000);  // about 10 million pixels
  views[3].camera = {3000, 40, radians(90)};
  views[500].camera = {40, 3000, radians(10)};
  views[501].camera = {1, 1, radians(30)};
  const auto pictures = take(scene, views);
  for (const std::size_t i : {std::size_t{0}, std::size_t{3}, std::size_t{4}, std::size_t{499},
                              std::size_t{500}, std::size_t{501}, std::size_t{999}}) {
    CAPTURE(i);
    REQUIRE(pictures[i].width == views[i].camera.width);
    REQUIRE(pictures[i].height == views[i].camera.height);
    const int pixels = views[i].camera.width * views[i].camera.height;
    CHECK(differing_pixels(pictures[i], take(scene, views[i])) <= std::max(2, pixels / 1000));
  }
}

TEST_CASE("No cameras, no pictures") { CHECK(take(busy_scene(), std::vector<View>{}).empty()); }

TEST_CASE("An image's memory is reused, whatever it held before") {
  Image picture;
  picture.width = 3;
  picture.channels = 1;
  picture.bytes.assign(100000, 7);
  const std::uint8_t* memory = picture.bytes.data();
  Image* place[] = {&picture};
  const View view = view_from({0, 0, 1});
  renderer().render({}, std::span(&view, 1), place);
  CHECK(picture.bytes.data() == memory);
  CHECK(picture.bytes == take({}, view).bytes);
}

TEST_CASE("A camera that can take no picture is refused with a sentence") {
  const auto refuse = [](const Camera& camera, const char* sentence) {
    CHECK_THROWS_WITH(take({}, view_from({0, 0, 1}, 0, 0, camera)), Catch::Contains(sentence));
  };
  refuse({0, 100, 1.0}, "a picture of 0 x 100 pixels cannot be taken");
  refuse({100, -5, 1.0}, "from 1 to");
  refuse({renderer().largest_size() + 1, 10, 1.0}, "pixels cannot be taken");
  refuse({100, 100, 0.0}, "must be above 0 and below 180");
  refuse({100, 100, radians(180)}, "must be above 0 and below 180");
  refuse({100, 100, std::nan("")}, "must be above 0 and below 180");
  const View view = view_from({0, 0, 1});
  CHECK_THROWS_WITH(renderer().render({}, std::span(&view, 1), {}),
                    Catch::Contains("1 views, but 0 pictures"));
}
