// A depth camera: a ray for each pixel. It needs no graphics.
#include <cmath>
#include <cstdint>
#include <vector>

#include <elsie/api/sensor.h>
#include <elsie/readings/depth.h>

namespace {

class Depth final : public elsie::SensorOf<elsie::DepthReading> {
 public:
  int width = 32;
  int height = 24;
  double fov_deg = 60.0;
  double max_range = 4.0;

  void configured() override {
    // The pinhole camera of image.h: the plane of the picture is at the distance half / tan(fov/2).
    const double far = 0.5 * width / std::tan(0.5 * elsie::radians(fov_deg));
    frames_.clear();
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const double left = 0.5 * width - column - 0.5, up = 0.5 * height - row - 0.5;
        const double flat = std::hypot(far, left);
        frames_.push_back(elsie::Frame::turned({}, std::atan2(left, far), std::atan2(up, flat)));
      }
    }
    queries_.clear();
    for (const elsie::Frame& frame : frames_) {
      queries_.push_back({&frame, max_range});
    }
  }

  elsie::DepthReading blank() const override {
    elsie::DepthReading reading;
    reading.width = width;
    reading.height = height;
    describe(reading);
    reading.depths_m.assign(static_cast<std::size_t>(width * height), max_range);
    reading.picture = {width, height, 1, std::vector<std::uint8_t>(reading.depths_m.size(), 0)};
    return reading;
  }

  void describe(elsie::DepthReading& reading) const {
    reading.max_range_m = max_range;
    reading.horizontal_fov_rad = elsie::radians(fov_deg);
  }

  void sense_into(const elsie::SensorContext& now, elsie::DepthReading& reading) override {
    describe(reading);
    now.world->cast_rays(now.frame, queries_);
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const double depth = std::min(queries_[i].distance_m, max_range);
      reading.depths_m[i] = depth;
      reading.picture.bytes[i] =
          static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - depth / max_range)));
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    const double half = 0.5 * elsie::radians(fov_deg);
    sketch.pyramid(elsie::SketchRole::range, 2.0 * half,
                   2.0 * std::atan(std::tan(half) * height / width), 0.2);
    std::vector<elsie::Vector3> hits;
    for (std::size_t i = 0; i < current().depths_m.size() && i < frames_.size(); ++i) {
      const double depth = current().depths_m[i];
      if (depth < max_range) hits.push_back(frames_[i].point({depth, 0.0, 0.0}));
    }
    sketch.points(elsie::SketchRole::hit, hits);
  }

 private:
  std::vector<elsie::Frame> frames_;  // of the pixels' rays, in that of the sensor
  std::vector<elsie::RayQuery> queries_;
};

}  // namespace

ELSIE_SENSOR(
    Depth, "depth", "Measures the distance to what is seen in each pixel of a picture",
    elsie::parameter("width", &Depth::width,
                     {.unit = "px", .min = 1, .max = 320, .meaning = "columns", .live = false}),
    elsie::parameter("height", &Depth::height,
                     {.unit = "px", .min = 1, .max = 240, .meaning = "rows", .live = false}),
    elsie::parameter("fov_deg", &Depth::fov_deg,
                     {.unit = "deg", .min = 1, .max = 170, .meaning = "horizontal field of view"}),
    elsie::parameter("max_range", &Depth::max_range,
                     {.unit = "m", .above = 0, .meaning = "range; also the depth of nothing"}));
