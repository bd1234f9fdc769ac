// The steps from a camera's picture to the blob, on pictures painted by hand.
#include <catch2/catch.hpp>

#include "camera_work.h"

using namespace elsie;
using elsie::test::Watcher;

namespace {

using Reals = std::vector<double>;
using Steps = std::vector<ElementValue>;

constexpr Colour kRed{208, 48, 48};
constexpr Colour kBlue{48, 96, 208};

/// A grey picture to paint on.
class Canvas {
 public:
  explicit Canvas(int width = 40, int height = 30) {
    image.width = width;
    image.height = height;
    image.bytes.assign(static_cast<std::size_t>(width * height * 3), 100);
  }
  Canvas& rectangle(int left, int top, int width, int height, const Colour& colour = kRed) {
    for (int row = top; row < top + height; ++row) {
      for (int column = left; column < left + width; ++column) {
        auto* pixel = const_cast<std::uint8_t*>(image.pixel(column, row));
        pixel[0] = colour.red;
        pixel[1] = colour.green;
        pixel[2] = colour.blue;
      }
    }
    return *this;
  }
  Image image;
};

VisionReading look(const Steps& steps, const Canvas& canvas) {
  Watcher watcher({}, steps);
  watcher.world.colours = {kRed};
  return watcher.look_at(canvas.image);
}

int mask_pixels(const VisionReading& reading) {
  return static_cast<int>(
      std::count(reading.processed.bytes.begin(), reading.processed.bytes.end(), 255));
}

const ElementValue kMatch{"match_colour", {}};
ElementValue blob(const std::string& choose) { return {"blob", {{"choose", choose}}}; }

}  // namespace

TEST_CASE("A pipeline of convert, threshold and blob is the one that it says") {
  const Canvas canvas = Canvas().rectangle(10, 5, 4, 6).rectangle(20, 5, 8, 8, kBlue);
  const Steps reds{{"convert", {{"to", "hsv"}}},
                   {"threshold", {{"low", Reals{0, 80, 40}}, {"high", Reals{10, 255, 255}}}}};
  const VisionReading seen = look(reds, canvas);
  CHECK(seen.found);
  CHECK(seen.area_px == 24);
  CHECK(seen.column == Approx(12));
  CHECK(seen.row == Approx(8));
  CHECK(mask_pixels(seen) == 24);

  // Another colour space, another colour.
  const Steps blues{{"threshold", {{"low", Reals{0, 0, 200}}, {"high", Reals{100, 255, 255}}}}};
  CHECK(look(blues, canvas).area_px == 64);
  const Steps lab{{"convert", {{"to", "lab"}}},
                  {"threshold", {{"low", Reals{0, 160, 0}}, {"high", Reals{255, 255, 255}}}}};
  CHECK(look(lab, canvas).area_px == 24);
  const Steps dark{{"convert", {{"to", "grey"}}},
                   {"threshold", {{"low", Reals{0}}, {"high", Reals{99}}}},
                   blob("rightmost")};
  CHECK(look(dark, canvas).area_px > 0);
}

TEST_CASE("A range of hues may go round through red") {
  const Canvas canvas = Canvas()
                            .rectangle(2, 2, 3, 3, {200, 40, 10})    // 9 degrees
                            .rectangle(10, 2, 3, 3, {200, 10, 40})   // 351 degrees
                            .rectangle(20, 2, 3, 3, {40, 200, 10});  // green
  const auto area = [&](double low, double high) {
    return mask_pixels(
        look({{"convert", {{"to", "hsv"}}},
              {"threshold", {{"low", Reals{low, 80, 80}}, {"high", Reals{high, 255, 255}}}}},
             canvas));
  };
  CHECK(area(0, 10) == 9);
  CHECK(area(170, 180) == 9);
  CHECK(area(170, 10) == 18);
  CHECK(area(11, 169) == 9);
  CHECK(area(0, 180) == 27);
}

TEST_CASE("match_colour looks for the robot's resources, or for colours of its own") {
  const Canvas canvas = Canvas()
                            .rectangle(2, 2, 3, 3)
                            .rectangle(10, 2, 5, 5, kBlue)
                            .rectangle(20, 10, 4, 4, {255, 208, 0});
  CHECK(mask_pixels(look({kMatch}, canvas)) == 9);
  CHECK(mask_pixels(look({{"match_colour", {{"colours", "#3060d0"}}}}, canvas)) == 25);
  CHECK(mask_pixels(look({{"match_colour", {{"colours", " #ffd000  #d03030 "}}}}, canvas)) == 25);
}

TEST_CASE("The tolerances of match_colour say how far a surface may be off") {
  const auto found = [](const Colour& colour, test::Parameters parameters) {
    return look({{"match_colour", std::move(parameters)}}, Canvas().rectangle(5, 5, 4, 4, colour))
        .found;
  };
  const Colour orange{208, 88, 48};  // hue 15 instead of 0
  CHECK_FALSE(found(orange, {}));
  CHECK(found(orange, {{"hue_tolerance_deg", 16.0}}));
  const Colour pale{208, 120, 120};  // saturation 0.42 instead of 0.77
  CHECK_FALSE(found(pale, {}));
  CHECK(found(pale, {{"saturation_tolerance", 0.42}}));
  const Colour nearly_grey{208, 140, 140};  // less than half as saturated: never
  CHECK_FALSE(found(nearly_grey, {{"saturation_tolerance", 1.0}}));
  const Colour dark{83, 19, 19};  // 0.4 times as bright
  CHECK_FALSE(found(dark, {}));
  CHECK(found(dark, {{"darkest", 0.38}}));
  CHECK(found(kRed, {{"hue_tolerance_deg", 0.0}, {"saturation_tolerance", 0.0}, {"darkest", 1.0}}));
  CHECK(found({48, 208, 48}, {{"hue_tolerance_deg", 180.0}}));
}

TEST_CASE("A tolerance of nearly half a circle takes in nearly every hue, whatever the colour's") {
  // Red, yellow, green, cyan, blue, violet: the colour to find, and those that are near enough.
  const Colour hues[] = {{208, 48, 48},  {208, 208, 48}, {48, 208, 48},
                         {48, 208, 208}, {48, 48, 208},  {208, 48, 208}};
  const char* names[] = {"#d03030", "#d0d030", "#30d030", "#30d0d0", "#3030d0", "#d030d0"};
  for (std::size_t wanted = 0; wanted < 6; ++wanted) {
    for (const double tolerance : {170.0, 177.0, 178.0, 178.5, 179.0, 179.5, 179.9, 180.0}) {
      for (std::size_t seen = 0; seen < 6; ++seen) {
        CAPTURE(names[wanted], names[seen], tolerance);
        const double apart = 60.0 * std::abs(std::remainder(double(seen) - double(wanted), 6.0));
        const bool matches =
            look({{"match_colour",
                   {{"colours", std::string(names[wanted])}, {"hue_tolerance_deg", tolerance}}}},
                 Canvas().rectangle(5, 5, 4, 4, hues[seen]))
                .found;
        // The opposite hue is included from 178 on: limits are rounded outwards to OpenCV's 2
        // degrees.
        if (apart < 180.0 || tolerance > 178.0) {
          CHECK(matches);
        } else if (tolerance < 178.0) {
          CHECK_FALSE(matches);
        }
      }
    }
  }
}

TEST_CASE("Morphology takes specks away and fills holes") {
  const Canvas canvas = Canvas()
                            .rectangle(5, 5, 10, 10)
                            .rectangle(9, 9, 1, 1, {100, 100, 100})  // a hole
                            .rectangle(30, 20, 1, 1);                // a speck
  CHECK(mask_pixels(look({kMatch}, canvas)) == 100);
  CHECK(mask_pixels(look({kMatch, {"close", {}}}, canvas)) == 101);
  CHECK(mask_pixels(look({kMatch, {"close", {}}, {"open", {}}}, canvas)) == 100);
  CHECK(mask_pixels(look({kMatch, {"close", {}}, {"erode", {}}}, canvas)) == 64);
  CHECK(mask_pixels(
            look({kMatch, {"close", {}}, {"erode", {{"times", std::int64_t{2}}}}}, canvas)) == 36);
  CHECK(mask_pixels(
            look({kMatch, {"close", {}}, {"erode", {{"size", std::int64_t{5}}}}}, canvas)) == 36);
  CHECK(mask_pixels(look({kMatch, {"dilate", {}}}, canvas)) == 144 + 9);
  CHECK(mask_pixels(look({kMatch, {"dilate", {{"shape", "cross"}}}}, canvas)) == 140 + 5);
  CHECK(mask_pixels(look({kMatch, {"dilate", {{"shape", "disc"}, {"size", std::int64_t{5}}}}},
                         canvas)) > 160);
}

TEST_CASE("A median takes specks out of the picture, and other filters soften it") {
  const Canvas canvas = Canvas().rectangle(5, 5, 10, 10).rectangle(30, 20, 1, 1);
  const auto blurred = [&](const std::string& kind, std::int64_t size) {
    return look({{"blur", {{"kind", kind}, {"size", size}}}, kMatch}, canvas);
  };
  CHECK(mask_pixels(blurred("median", 3)) == 96);  // the corners are rounded
  CHECK(mask_pixels(blurred("gaussian", 3)) < 101);
  CHECK(mask_pixels(blurred("gaussian", 3)) >= 64);
  CHECK(mask_pixels(blurred("box", 5)) < mask_pixels(blurred("box", 3)));
  CHECK(mask_pixels(blurred("box", 1)) == 101);
  // The raw picture is the camera's.
  CHECK(blurred("box", 5).raw.bytes == canvas.image.bytes);
}

TEST_CASE("The blob to report can be chosen") {
  const Canvas canvas = Canvas()
                            .rectangle(2, 12, 6, 6)    // largest
                            .rectangle(10, 25, 2, 2)   // lowest
                            .rectangle(18, 14, 3, 2)   // nearest to the centre (20, 15)
                            .rectangle(25, 1, 2, 2)    // highest
                            .rectangle(0, 20, 1, 4)    // leftmost
                            .rectangle(38, 20, 2, 2);  // rightmost
  const auto column = [&](const std::string& choose) {
    return look({kMatch, blob(choose)}, canvas).column;
  };
  CHECK(column("largest") == Approx(5));
  CHECK(column("lowest") == Approx(11));
  CHECK(column("nearest_centre") == Approx(19.5));
  CHECK(column("highest") == Approx(26));
  CHECK(column("leftmost") == Approx(0.5));
  CHECK(column("rightmost") == Approx(39));
  // Without the step it is the largest.
  CHECK(look({kMatch}, canvas).column == Approx(5));
}

TEST_CASE("Blobs that are too small or too large do not count") {
  const Canvas canvas =
      Canvas().rectangle(2, 2, 6, 6).rectangle(20, 2, 3, 3).rectangle(30, 2, 1, 1);
  const auto area = [&](test::Parameters limits) {
    return look({kMatch, {"blob", std::move(limits)}}, canvas).area_px;
  };
  CHECK(area({}) == 36);
  CHECK(area({{"max_area", 35.0}}) == 9);
  CHECK(area({{"min_area", 2.0}, {"max_area", 8.0}}) == 0);
  CHECK(area({{"min_area", 37.0}}) == 0);
  CHECK(area({{"min_area", 36.0}, {"max_area", 36.0}}) == 36);
}

TEST_CASE("A blob is connected over corners, around holes and by arms that meet later") {
  // Two pixels, corner to corner.
  CHECK(look({kMatch}, Canvas().rectangle(5, 5, 1, 1).rectangle(6, 6, 1, 1)).area_px == 2);
  CHECK(look({kMatch}, Canvas().rectangle(6, 5, 1, 1).rectangle(5, 6, 1, 1)).area_px == 2);
  CHECK(look({kMatch}, Canvas().rectangle(5, 5, 1, 1).rectangle(7, 6, 1, 1)).area_px == 1);
  // A comb: only the last row joins its teeth.
  Canvas comb;
  for (int tooth = 0; tooth < 10; ++tooth) {
    comb.rectangle(2 + 3 * tooth, 4, 1, 10);
  }
  CHECK(look({kMatch}, comb).area_px == 10);
  comb.rectangle(2, 14, 28, 1);
  CHECK(look({kMatch}, comb).area_px == 100 + 28);
  // A frame, and a spot in it.
  Canvas frame;
  frame.rectangle(5, 5, 20, 20).rectangle(6, 6, 18, 18, {100, 100, 100}).rectangle(14, 14, 2, 2);
  const VisionReading seen = look({kMatch}, frame);
  CHECK(seen.area_px == 76);
  CHECK(seen.column == Approx(15));
  // The whole picture with its edges.
  CHECK(look({kMatch}, Canvas().rectangle(0, 0, 40, 30)).area_px == 1200);
  CHECK(look({kMatch}, Canvas(1, 1).rectangle(0, 0, 1, 1)).column == Approx(0.5));
}

TEST_CASE("Of equally good blobs the first, row by row, is chosen") {
  const Canvas canvas =
      Canvas().rectangle(20, 10, 3, 3).rectangle(4, 10, 3, 3).rectangle(8, 2, 3, 3);
  CHECK(look({kMatch}, canvas).column == Approx(9.5));
  CHECK(look({kMatch, blob("lowest")}, canvas).column == Approx(5.5));
}

TEST_CASE("A pipeline that makes no sense is refused when it is put together") {
  const auto refuse = [](const Steps& steps, const std::string& sentence) {
    CAPTURE(sentence);
    CHECK_THROWS_WITH(Watcher({}, steps), Catch::Contains(sentence));
  };
  const ElementValue grey{"convert", {{"to", "grey"}}};
  const ElementValue hsv{"convert", {{"to", "hsv"}}};
  const auto threshold = [](Reals low, Reals high) {
    return ElementValue{"threshold", {{"low", std::move(low)}, {"high", std::move(high)}}};
  };
  refuse({hsv}, "ends with a picture in the colour space 'hsv', in which no blob can be found");
  refuse({{"blob", {}}}, "step 1 of its pipeline, <blob>: it needs a mask");
  refuse({kMatch, {"blob", {}}, {"open", {}}},
         "step 3 of its pipeline, <open>: nothing may follow");
  refuse({kMatch, {"blob", {}}, {"blob", {}}}, "nothing may follow <blob>");
  refuse({kMatch, hsv}, "step 2 of its pipeline, <convert>: it needs a picture");
  refuse({kMatch, kMatch}, "<match_colour>: it needs a picture");
  refuse({kMatch, {"blur", {}}}, "<blur>: it needs a picture");
  refuse({kMatch, threshold({0}, {9})}, "<threshold>: it needs a picture");
  refuse({grey, hsv}, "it needs colours, but the picture is grey");
  refuse({grey, kMatch}, "it needs colours, but the picture is grey");
  refuse({hsv, threshold({0, 0}, {9, 9, 9})}, "has 3 channels; give as many numbers");
  refuse({grey, threshold({0, 0, 0}, {9, 9, 9})}, "has 1 channel; give as many numbers");
  refuse({hsv, threshold({0, 9, 0}, {9, 5, 9})}, "the lower limit of channel 2, 9, is above");
  refuse({threshold({9, 0, 0}, {5, 9, 9})}, "the lower limit of channel 1");
  refuse({hsv, threshold({0, 0, 0}, {200, 255, 255})}, "200 is not a value of channel 1");
  refuse({kMatch, {"open", {{"size", std::int64_t{4}}}}},
         "its size is 4 pixels, but must be an odd");
  refuse({{"blur", {{"size", std::int64_t{2}}}}, kMatch}, "must be an odd number");
  refuse({kMatch, {"blob", {{"min_area", 9.0}, {"max_area", 3.0}}}}, "no blob would do");
  refuse({{"match_colour", {{"colours", "#d03030, blue"}}}}, "'#d03030,' is not a colour");
  refuse({{"match_colour", {{"colours", "#d0303"}}}}, "is not a colour like");
  refuse({{"match_colour", {{"colours", "#+03030"}}}}, "is not a colour like");
  refuse({{"match_colour", {{"colours", "#777777"}}}}, "cannot look for the colour #777777");
  refuse({kMatch, blob("prettiest")}, "prettiest");
  refuse({{"convert", {{"to", "cmyk"}}}, kMatch}, "cmyk");
}
