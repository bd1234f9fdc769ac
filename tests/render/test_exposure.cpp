// Pictures for people: light and shade, lines, and what cameras must not notice.
#include <numbers>

#include <catch2/catch.hpp>

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

constexpr Colour kPaper{220, 220, 220};

/// From above, with north at the top: 200 pixels show 4 m.
View from_above() {
  View view{Frame::turned({0, 0, 10}, radians(90), radians(-90)), {200, 200, 2.0 * std::atan(0.2)}};
  return view;
}

struct Developed {
  int width;
  std::vector<std::uint32_t> pixels;

  std::uint32_t at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row * width + column)];
  }
  /// At a place on the floor in a view from above.
  Colour of(double x, double y) const {
    const std::uint32_t pixel =
        at(static_cast<int>(100.0 + 50.0 * x), static_cast<int>(100.0 - 50.0 * y));
    return {std::uint8_t(pixel >> 16U), std::uint8_t(pixel >> 8U), std::uint8_t(pixel)};
  }
};

Developed develop(const Scene& scene, const View& view, Shadows shadows, int passes) {
  Style style;
  style.arena = {4, 4};
  Exposure exposure;
  renderer().compose(scene, view, style);
  for (int i = 0; i < passes; ++i) renderer().expose(shadows, exposure);
  Developed developed{exposure.width(), {}};
  exposure.develop(developed.pixels);
  return developed;
}

Scene with_box() {
  Scene scene;
  scene.floor = kPaper;
  scene.boxes = {cube({0, 0, 0.25}, 0.5, kRed)};
  return scene;
}

}  // namespace

TEST_CASE("A box throws a shadow on the floor, away from the light") {
  // The light comes from the south-west.
  for (const auto& [shadows, passes] :
       {std::pair{Shadows::hard, 1}, {Shadows::sun, 4}, {Shadows::soft, 16}}) {
    CAPTURE(passes);
    const Developed picture = develop(with_box(), from_above(), shadows, passes);
    CHECK(picture.of(0.33, 0.3).red < 0.8 * kPaper.red);
    CHECK(picture.of(-0.45, -0.45).red > 0.85 * kPaper.red);
    CHECK(picture.of(1.5, -1.5).red == Approx(kPaper.red).margin(4));
  }
  CHECK(develop(with_box(), from_above(), Shadows::none, 1).of(0.33, 0.3) == kPaper);
}

TEST_CASE(
    "A soft shadow has an edge that becomes lighter step by step, and falls on what stands there") {
  Scene scene = with_box();
  scene.boxes[0].size = {0.1, 1.0, 1.0};
  const auto shades = [&](Shadows shadows, int passes) {
    const Developed picture = develop(scene, from_above(), shadows, passes);
    std::vector<int> reds;
    for (double x = 0.4; x < 0.9; x += 0.02) reds.push_back(picture.of(x, 0.3).red);
    std::sort(reds.begin(), reds.end());
    return std::unique(reds.begin(), reds.end()) - reds.begin();
  };
  CHECK(shades(Shadows::soft, 32) > 2 * shades(Shadows::hard, 1));

  scene.balls = {{{0.3, 0.1, 0.1}, 0.1, kBlue}};
  Scene alone = scene;
  alone.boxes.clear();
  for (const Shadows shadows : {Shadows::sun, Shadows::soft}) {
    const auto blue = [&](const Scene& of) {
      return develop(of, from_above(), shadows, 8).of(0.3, 0.1).blue;
    };
    CHECK(blue(scene) < blue(alone) - 20);
  }
}

TEST_CASE("The shadow in a picture of any size has the edge that it has in a large one") {
  Scene scene = with_box();
  scene.boxes[0].size.z = 1.0;
  const auto share_in_shadow = [&](int size, Shadows shadows) {
    View view = from_above();
    view.camera.width = view.camera.height = size;
    const Developed picture = develop(scene, view, shadows, 4);
    const auto dark = std::count_if(
        picture.pixels.begin(), picture.pixels.end(),
        [](std::uint32_t pixel) { return pixel >> 24U == 255 && (pixel & 255U) < 170; });
    return static_cast<double>(dark) / (size * size);
  };
  for (const Shadows shadows : {Shadows::sun, Shadows::soft}) {
    const double large = share_in_shadow(1000, shadows);
    CHECK(large > 0.01);
    for (const int size : {60, 300}) {
      CHECK(share_in_shadow(size, shadows) == Approx(large).epsilon(0.25));
    }
  }
}

TEST_CASE("The ground in a corner is darker than in the open, on the sunny side, too") {
  Scene scene;
  scene.floor = kPaper;
  for (const Vector3& at : {Vector3{-1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}}) {
    scene.boxes.push_back(cube(at + Vector3{0, 0, 0.3}, 0.6, kRed));
  }
  for (const auto& [shadows, passes] :
       {std::pair{Shadows::hard, 1}, {Shadows::sun, 4}, {Shadows::soft, 32}}) {
    const Developed picture = develop(scene, from_above(), shadows, passes);
    CHECK(picture.of(-1.41, 0.9).red + 8 < picture.of(-1.85, 0.9).red);
  }
}

TEST_CASE("More passes make edges smooth, and the picture says what is floor or sky") {
  Scene scene = with_box();
  scene.boxes[0].frame = Frame::turned({}, 0.3, 0.0);
  for (const int passes : {1, 16}) {
    const Developed picture = develop(scene, from_above(), Shadows::none, passes);
    int between = 0;
    for (const std::uint32_t pixel : picture.pixels) {
      const std::uint32_t open = pixel >> 24U;
      between += open > 0 && open < 255;
    }
    CHECK((between > 20) == (passes == 16));
    CHECK(picture.at(100, 100) >> 24U == 0);
    CHECK(picture.at(10, 10) >> 24U == 255);
  }
}

TEST_CASE("The sky is darker above than at the horizon") {
  const View level = view_from({0, 0, 1}, 0.0, 5.0, {100, 100, radians(80.0)});
  const Developed picture = develop({}, level, Shadows::none, 1);
  const auto blue_against_red = [&](int row) {
    return static_cast<int>(picture.at(50, row) & 255U) -
           static_cast<int>(picture.at(50, row) >> 16U & 255U);
  };
  CHECK((picture.at(50, 2) >> 8U & 255U) < (picture.at(50, 50) >> 8U & 255U));
  CHECK(blue_against_red(2) > blue_against_red(50));
}

TEST_CASE("The turning of a wheel is seen by people, not by cameras") {
  Scene scene;
  Cylinder wheel;
  wheel.radius = 0.3;
  wheel.length = 0.1;
  wheel.material = Material::wheel;
  wheel.colour = {30, 30, 30};
  const auto turned = [&](double angle) {
    wheel.frame = {{0, 0, 0.3},
                   {std::cos(angle), 0, -std::sin(angle)},
                   {0, 1, 0},
                   {std::sin(angle), 0, std::cos(angle)}};
    scene.cylinders = {wheel};
    return scene;
  };
  const View aside = view_from({0, -2, 0.3}, 90.0);
  const Developed before = develop(turned(0.0), aside, Shadows::none, 1);
  const Developed after = develop(turned(0.7), aside, Shadows::none, 1);
  int different = 0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    different += before.pixels[i] != after.pixels[i];
  }
  CHECK(different > 100);
  // A camera sees a twentieth of a turn of its twenty sides as nothing.
  const double side = 2.0 * std::numbers::pi / 20.0;
  CHECK(differing_pixels(take(turned(0.0), aside), take(turned(side), aside)) < 10);
}

TEST_CASE(
    "A line behind something is fainter, and lines on the floor are below what stands there") {
  Scene scene = with_box();
  const auto green = [&](double x) {
    const Colour seen = develop(scene, from_above(), Shadows::none, 1).of(x, 0.0);
    return seen.green - seen.red;
  };
  const int plain = green(0.0);
  scene.strokes = {{{-1, 0, 1}, {1, 0, 1}, kGreen, 1.0, 4.0}};
  const int before = green(0.0) - plain;
  CHECK(green(0.8) > 100);
  scene.strokes[0].from.z = scene.strokes[0].to.z = 0.1;
  const int behind = green(0.0) - plain;
  CHECK(behind > 10);
  CHECK(behind < before / 2);
  scene.drawing.swap(scene.strokes);
  CHECK(green(0.0) == plain);
  CHECK(green(0.8) > 100);
}

TEST_CASE("What people see changes no picture of a camera") {
  Scene scene = with_box();
  const View view = view_from({-3, 0.2, 0.5}, 0.0, -8.0, {120, 90, radians(50.0)});
  const std::vector<View> views{view, view_from({0, -2, 0.3}, 90.0)};
  const std::vector<Image> before = take(scene, views);
  develop(scene, {view.frame, {333, 222, 0.9}}, Shadows::soft, 3);
  scene.boxes[0].material = Material::wall;
  scene.strokes = {{{-1, 0, 0.5}, {1, 0, 0.5}, kGreen, 1.0, 4.0}};
  scene.drawing = scene.strokes;
  scene.glows = {{{-1, 0, 0.5}, 0.5, 1.0, kGreen}};
  const std::vector<Image> after = take(scene, views);
  for (std::size_t i = 0; i < views.size(); ++i) CHECK(before[i].bytes == after[i].bytes);
}
