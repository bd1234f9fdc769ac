// A camera that finds resources by their colour.
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/sensor.h>

#include "pipeline.h"
#include "steps.h"

namespace {

class Vision final : public elsie::SensorOf<elsie::VisionReading> {
 public:
  int width = 100;
  int height = 100;
  double fov_deg = 30.0;
  double error = 0.0;
  std::vector<vision::Step> steps{vision::MatchColour{}, vision::Blob{}};

  void configured() override { pipeline_ = vision::make_pipeline(steps, resource_colours_); }

  void equipped(const elsie::Carrier& carrier) override {
    resource_colours_.assign(carrier.resource_colours.begin(), carrier.resource_colours.end());
    configured();
  }

  elsie::VisionReading blank() const override {
    elsie::VisionReading reading;
    reading.width = width;
    reading.height = height;
    reading.horizontal_fov_rad = elsie::radians(fov_deg);
    return reading;
  }

  std::optional<elsie::Camera> camera() const override {
    return elsie::Camera{width, height, elsie::radians(fov_deg)};
  }

  void sense_into(const elsie::SensorContext& now, elsie::VisionReading& reading) override {
    if (!now.image || now.image->empty() || now.image->channels != 3) {
      throw std::invalid_argument("it was handed no picture of three channels to look at");
    }
    reading.raw = *now.image;
    if (error > 0.0) {
      add_noise(reading.raw.bytes, *now.random);
    }
    const auto blob = pipeline_->run(reading.raw, reading.processed);
    reading.found = blob.has_value();
    reading.column = blob ? blob->column : 0.0;
    reading.row = blob ? blob->row : 0.0;
    reading.area_px = blob ? blob->area : 0.0;
    reading.width = reading.raw.width;
    reading.height = reading.raw.height;
    reading.horizontal_fov_rad = elsie::radians(fov_deg);
  }

  void sketch(elsie::Sketch& sketch) const override {
    using elsie::SketchRole;
    constexpr double kDrawn = 0.3;  // m: how far ahead
    const double across = std::tan(0.5 * elsie::radians(fov_deg));
    const double down = across * height / width;
    sketch.pyramid(SketchRole::range, elsie::radians(fov_deg), 2.0 * std::atan(down), kDrawn);
    const elsie::VisionReading& seen = current();
    if (!seen.found) return;
    const double left = across * (1.0 - 2.0 * seen.column / seen.width);
    const double up = down * (1.0 - 2.0 * seen.row / seen.height);
    sketch.line(SketchRole::hit, {}, elsie::Vector3{kDrawn, kDrawn * left, kDrawn * up});
  }

 private:
  /// Normal noise for every channel of every pixel. Ten cameras need more than 100,000 numbers, so
  /// the noise is the number of ones among 64 random bits, with mean 32 and standard deviation 4.
  void add_noise(std::vector<std::uint8_t>& bytes, elsie::Random& random) const {
    const double scale = 255.0 * error / 4.0;
    for (std::uint8_t& byte : bytes) {
      const double value = byte + scale * (std::popcount(random.bits()) - 32);
      byte = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  }

  std::unique_ptr<vision::Pipeline> pipeline_;
  std::vector<elsie::Colour> resource_colours_;  // empty before it is equipped
};

using elsie::element;
using elsie::parameter;

template <class Step>
elsie::ElementItem<Step> morphology(const char* name, const char* meaning) {
  return element<Step>(
      name, meaning,
      parameter("size", static_cast<int Step::*>(&vision::Morphology::size),
                {.unit = "px", .min = 1, .max = 99, .meaning = "edge of the neighbourhood, odd"}),
      parameter("shape", static_cast<std::string Step::*>(&vision::Morphology::shape),
                {.choices = {"square", "cross", "disc"}, .meaning = "of the neighbourhood"}),
      parameter("times", static_cast<int Step::*>(&vision::Morphology::times),
                {.min = 1, .max = 99, .meaning = "how often, one after the other"}));
}

}  // namespace

ELSIE_SENSOR(
    Vision, "vision", "A camera that finds resources, or anything else, by colour",
    parameter("width", &Vision::width,
              {.unit = "px", .min = 1, .max = 4096, .meaning = "columns of the picture"}),
    parameter("height", &Vision::height,
              {.unit = "px", .min = 1, .max = 4096, .meaning = "rows of the picture"}),
    parameter("fov_deg", &Vision::fov_deg,
              {.unit = "deg",
               .min = 0.1,
               .max = 170,
               .meaning = "full horizontal angle; pixels are square, the vertical one follows"}),
    parameter(
        "error", &Vision::error,
        {.min = 0,
         .max = 1,
         .meaning = "standard deviation of the noise of every pixel and channel, as a part of "
                    "full brightness"}),
    elsie::elements(
        &Vision::steps,
        element<vision::Convert>(
            "convert", "Converts the picture to another colour space",
            parameter("to", &vision::Convert::to,
                      {.choices = {"rgb", "hsv", "hls", "lab", "luv", "ycrcb", "xyz", "grey"},
                       .meaning = "the colour space, as OpenCV's for 8 bits (hue: 0 to 180)"})),
        element<vision::Threshold>(
            "threshold", "Makes a mask of the pixels that lie between two limits",
            parameter("low", &vision::Threshold::low,
                      {.min = 0,
                       .max = 255,
                       .meaning = "least value of each channel; a hue above that of high: through "
                                  "red"}),
            parameter("high", &vision::Threshold::high,
                      {.min = 0, .max = 255, .meaning = "largest value of each channel"})),
        element<vision::MatchColour>(
            "match_colour",
            "Makes a mask of the pixels that show a surface of a colour in any light",
            parameter("colours", &vision::MatchColour::colours,
                      {.meaning = "like '#d03030 #ffd000'; empty: those of the resources that the "
                                  "robot may collect"}),
            parameter("hue_tolerance_deg", &vision::MatchColour::hue_tolerance_deg,
                      {.unit = "deg", .min = 0, .max = 180, .meaning = "to either side"}),
            parameter("saturation_tolerance", &vision::MatchColour::saturation_tolerance,
                      {.min = 0,
                       .max = 1,
                       .meaning = "to either side, as a part of full saturation; never below half "
                                  "of the colour's own"}),
            parameter("darkest", &vision::MatchColour::darkest,
                      {.min = 0,
                       .max = 1,
                       .meaning = "brightness of a face in the shade, as a part of that in full "
                                  "light"})),
        element<vision::Blur>(
            "blur", "Smooths the picture",
            parameter("kind", &vision::Blur::kind,
                      {.choices = {"gaussian", "median", "box"}, .meaning = "the filter"}),
            parameter(
                "size", &vision::Blur::size,
                {.unit = "px", .min = 1, .max = 99, .meaning = "edge of the neighbourhood, odd"})),
        morphology<vision::Erode>("erode", "Removes the rim (minimum of a neighbourhood)"),
        morphology<vision::Dilate>("dilate", "Adds a rim (maximum of a neighbourhood)"),
        morphology<vision::Open>("open", "Erodes, then dilates: removes specks"),
        morphology<vision::Close>("close", "Dilates, then erodes: fills holes"),
        element<vision::Blob>(
            "blob", "Selects the blob of the mask for the reading; the last step",
            parameter("choose", &vision::Blob::choose,
                      {.choices = {"largest", "nearest_centre", "leftmost", "rightmost", "highest",
                                   "lowest"},
                       .meaning = "which of several blobs it selects"}),
            parameter("min_area", &vision::Blob::min_area,
                      {.unit = "px", .min = 0, .meaning = "smaller blobs do not count"}),
            parameter(
                "max_area", &vision::Blob::max_area,
                {.unit = "px", .min = 0, .meaning = "larger blobs do not count; 0: no limit"}))));
