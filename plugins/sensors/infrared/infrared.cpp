// An active infra-red proximity sensor: it sees the light of its own lamp come back.
//
// docs/sensors/infrared.md has the laws and their sources.
#include <algorithm>
#include <vector>

#include <elsie/api/sensor.h>
#include <elsie/readings/infrared.h>

#include "laws.h"

namespace {

class Infrared final : public elsie::SensorOf<elsie::InfraredReading> {
 public:
  std::string law = "khepera";
  int rays = 1;
  double spread_deg = 30.0;

  void configured() override {
    law_ = &infrared::law_of(law);
    frames_.clear();
    for (int i = 0; i < rays; ++i) {
      const double off = rays > 1 ? 0.5 - i / (rays - 1.0) : 0.0;
      frames_.push_back(elsie::Frame::turned({}, elsie::radians(off * spread_deg), 0.0));
    }
    queries_.assign(frames_.size(), {});
  }

  elsie::InfraredReading blank() const override { return reading_of(0.0); }

  elsie::InfraredReading sense(const elsie::SensorContext& now) override {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      queries_[i] = {&frames_[i], law_->max_range_m};
    }
    now.world->cast_rays(now.frame, queries_);
    double sum = 0.0;
    for (const elsie::RayQuery& query : queries_) {
      sum += value_at(query.distance_m);
    }
    return reading_of(sum / rays);
  }

  void update_all(const elsie::SensorBatch& all) override {
    for (std::size_t i = 0; i < all.sensors.size(); ++i) {
      const auto& each = all.sensors[i];
      if (self(each).rays != 1) return SensorOf::update_all(all);
      all.rays[i] = {&each.place->frame, self(each).law_->max_range_m};
    }
    all.world->cast_rays(all.robot, all.rays);
    for (std::size_t i = 0; i < all.sensors.size(); ++i) {
      Infrared& sensor = self(all.sensors[i]);
      sensor.queries_.front().distance_m = all.rays[i].distance_m;
      sensor.set_reading(sensor.reading_of(sensor.value_at(all.rays[i].distance_m)));
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const double reach_m = std::min(queries_[i].distance_m, law_->max_range_m);
      sketch.line(reach_m < law_->max_range_m ? elsie::SketchRole::hit : elsie::SketchRole::range,
                  {}, frames_[i].point({reach_m, 0.0, 0.0}));
    }
  }

 private:
  static Infrared& self(const elsie::SensorBatch::Entry& each) {
    return static_cast<Infrared&>(*each.sensor);
  }
  double value_at(double distance_m) const {
    return distance_m <= law_->max_range_m ? law_->value(distance_m) : 0.0;
  }
  elsie::InfraredReading reading_of(double value) const {
    return {value, law_ ? law_->largest : 1.0, law_ ? law_->max_range_m : 0.0};
  }

  const infrared::Law* law_ = nullptr;
  std::vector<elsie::Frame> frames_;  // of the rays, in that of the sensor
  std::vector<elsie::RayQuery> queries_;
};

}  // namespace

ELSIE_SENSOR(
    Infrared, "infrared", "Sees how much of its own infra-red light comes back",
    elsie::parameter("law", &Infrared::law,
                     {.choices = infrared::law_names(),
                      .meaning = "the robot whose sensors it has: value against distance"}),
    elsie::parameter("rays", &Infrared::rays,
                     {.min = 1, .max = 99, .meaning = "its value is the mean along so many rays"}),
    elsie::parameter(
        "spread_deg", &Infrared::spread_deg,
        {.unit = "deg", .min = 0, .max = 180, .meaning = "from the first ray to the last"}));
