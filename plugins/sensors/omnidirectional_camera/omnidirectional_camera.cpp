// A camera that looks all around, and gives what it sees as a list of coloured blobs, as that of
// the foot-bot in ARGoS does. It needs no graphics: a thing is seen if no surface is in front of
// it.
#include <algorithm>
#include <cmath>
#include <vector>

#include <elsie/api/sensor.h>
#include <elsie/readings/omnidirectional_camera.h>

namespace {

using Blob = elsie::OmnidirectionalReading::Blob;

class OmnidirectionalCamera final : public elsie::SensorOf<elsie::OmnidirectionalReading> {
 public:
  double max_range = 2.0;
  int most = 16;
  bool lamps = true;

  elsie::OmnidirectionalReading blank() const override {
    elsie::OmnidirectionalReading reading;
    reading.most = static_cast<std::size_t>(most);
    return reading;
  }

  void sense_into(const elsie::SensorContext& now,
                  elsie::OmnidirectionalReading& reading) override {
    reading.most = static_cast<std::size_t>(most);
    reading.blobs.clear();
    near_.clear();
    // From the robot's middle; the camera may be elsewhere on it.
    now.world->things_within(max_range + reach_of(now), near_);
    for (const elsie::NearThing& near : near_) {
      const bool is_mark = near.thing.is_mark;
      const elsie::Vector3 place{near.place.x, near.place.y, is_mark ? 0.0 : now.frame.origin.z};
      if (is_mark ? now.world->is_open(now.frame.origin, place) : sees(near.thing, place, now)) {
        add(place, near.thing.colour, now, reading);
      }
    }
    if (lamps) {
      leds_.assign(now.world->lamps().begin(), now.world->lamps().end());
      now.world->lights_within(max_range + reach_of(now), leds_);
      for (const elsie::LampView& lamp : leds_) {
        if (now.world->is_open(now.frame.origin, lamp.place)) {
          add(lamp.place, lamp.colour, now, reading);
        }
      }
    }
    std::stable_sort(reading.blobs.begin(), reading.blobs.end(),
                     [](const Blob& a, const Blob& b) { return a.distance_m < b.distance_m; });
    if (reading.blobs.size() > reading.most) reading.blobs.resize(reading.most);
  }

  void sketch(elsie::Sketch& sketch) const override {
    for (const Blob& blob : current().blobs) {
      const elsie::Vector3 place{blob.distance_m * std::cos(blob.bearing_rad),
                                 blob.distance_m * std::sin(blob.bearing_rad), 0.0};
      sketch.line(elsie::SketchRole::range, {}, place);
      sketch.point(elsie::SketchRole::hit, place);
    }
  }

 private:
  static double reach_of(const elsie::SensorContext& now) {
    const elsie::Pose robot = now.world->pose();
    return std::hypot(now.frame.origin.x - robot.x, now.frame.origin.y - robot.y);
  }

  /// Whether the first surface on the way to the thing's middle is the thing's own, or there is
  /// none, as range sensors need not see it. A thing lower than the camera is looked for below the
  /// horizon.
  bool sees(const elsie::Thing& thing, const elsie::Vector3& place,
            const elsie::SensorContext& now) const {
    elsie::Surface surface;
    for (const double height : {place.z, 0.5 * place.z, 0.1 * place.z}) {
      const elsie::Vector3 way = elsie::Vector3{place.x, place.y, height} - now.frame.origin;
      const double far = std::sqrt(elsie::dot(way, way));
      if (far <= 0.0) return true;
      elsie::Frame along;
      along.origin = now.frame.origin;
      along.forward = (1.0 / far) * way;
      elsie::RayQuery query{&along, far};
      surface = {};
      now.world->cast_rays({}, {&query, 1}, {&surface, 1});
      const elsie::Thing found = now.world->thing(surface);
      if (found.kind == thing.kind && found.id == thing.id) return true;
    }
    return surface.kind == elsie::Surface::Kind::nothing;
  }

  void add(const elsie::Vector3& place, const elsie::Colour& colour,
           const elsie::SensorContext& now, elsie::OmnidirectionalReading& reading) const {
    const elsie::Vector3 way = place - now.frame.origin;
    const double distance = std::hypot(way.x, way.y);
    if (distance > max_range) return;
    const double towards = std::atan2(way.y, way.x);
    const double forward = std::atan2(now.frame.forward.y, now.frame.forward.x);
    reading.blobs.push_back(
        {distance, elsie::wrap_angle(towards - forward), colour.red, colour.green, colour.blue});
  }

  std::vector<elsie::NearThing> near_;
  std::vector<elsie::LampView> leds_;
};

}  // namespace

ELSIE_SENSOR(OmnidirectionalCamera, "omnidirectional_camera",
             "Looks all around, and lists the coloured things that it sees",
             elsie::parameter("max_range", &OmnidirectionalCamera::max_range,
                              {.unit = "m", .above = 0, .max = 1000, .meaning = "how far it sees"}),
             elsie::parameter("most", &OmnidirectionalCamera::most,
                              {.min = 1,
                               .max = 1000,
                               .meaning = "blobs that it lists at most; the nearest first",
                               .live = false}),
             elsie::parameter("lamps", &OmnidirectionalCamera::lamps,
                              {.meaning = "whether it sees lamps, also those on robots"}));
