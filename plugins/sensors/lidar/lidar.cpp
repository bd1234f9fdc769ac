// A lidar: many rays in one plane, all at the same instant.
#include <cstddef>
#include <vector>

#include <elsie/api/sensor.h>
#include <elsie/readings/lidar.h>

namespace {

class Lidar final : public elsie::SensorOf<elsie::LidarReading> {
 public:
  int rays = 360;
  double fov_deg = 360.0;
  double max_range = 4.0;

  void configured() override {
    const elsie::LidarReading reading = blank();
    frames_.clear();
    queries_.clear();
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      frames_.push_back(elsie::Frame::turned({}, reading.azimuth_rad(i), 0.0));
    }
    for (const elsie::Frame& frame : frames_) {
      queries_.push_back({&frame, max_range});
    }
  }

  elsie::LidarReading blank() const override {
    elsie::LidarReading reading;
    reading.ranges_m.assign(static_cast<std::size_t>(rays), max_range);
    describe(reading);
    return reading;
  }

  void describe(elsie::LidarReading& reading) const {
    reading.max_range_m = max_range;
    const double fov = elsie::radians(fov_deg);
    // The first and the last ray of a full circle are neighbours, not the same.
    const bool is_round = fov_deg >= 360.0;
    reading.step_rad = is_round ? fov / rays : rays > 1 ? fov / (rays - 1) : 0.0;
    reading.first_rad = is_round ? 0.5 * (fov - reading.step_rad) : rays > 1 ? 0.5 * fov : 0.0;
  }

  void sense_into(const elsie::SensorContext& now, elsie::LidarReading& reading) override {
    describe(reading);
    now.world->cast_rays(now.frame, queries_);
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      reading.ranges_m[i] = std::min(queries_[i].distance_m, max_range);
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    const elsie::LidarReading& reading = current();
    std::vector<elsie::Vector3> ends, hits;
    for (std::size_t i = 0; i < reading.ranges_m.size() && i < frames_.size(); ++i) {
      ends.push_back(frames_[i].point({reading.ranges_m[i], 0.0, 0.0}));
      if (queries_[i].distance_m <= max_range) hits.push_back(ends.back());  // not its noise alone
    }
    if (ends.size() > 1) sketch.line(elsie::SketchRole::range, ends);
    sketch.points(elsie::SketchRole::hit, hits);
  }

 private:
  std::vector<elsie::Frame> frames_;  // of the rays, in that of the sensor
  std::vector<elsie::RayQuery> queries_;
};

}  // namespace

ELSIE_SENSOR(
    Lidar, "lidar", "Measures the distances to surfaces along a fan of rays",
    elsie::parameter("rays", &Lidar::rays,
                     {.min = 1, .max = 10000, .meaning = "number of rays", .live = false}),
    elsie::parameter("fov_deg", &Lidar::fov_deg,
                     {.unit = "deg",
                      .above = 0,
                      .max = 360,
                      .meaning = "from the first ray to the last; 360: evenly all around"}),
    elsie::parameter(
        "max_range", &Lidar::max_range,
        {.unit = "m", .above = 0, .meaning = "range; also the reading where nothing is nearer"}));
