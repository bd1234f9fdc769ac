#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/api/sensor.h"

#include "shipped.h"

using namespace elsie;

namespace {

/// Only a wall at x = 0.5 m across the whole world.
class OneWall final : public Surroundings {
 public:
  std::optional<double> cast_ray(const Vector3& origin, const Vector3& direction,
                                 double max_range) const override {
    const double distance = (0.5 - origin.x) / direction.x;
    return distance >= 0 && distance <= max_range ? std::optional(distance) : std::nullopt;
  }
  void cast_rays(const Frame&, std::span<RayQuery>, std::span<Surface>) const override {}
  bool anything_in(const Pyramid& pyramid) const override {
    asked = pyramid;
    return pyramid.frame.origin.x + pyramid.range_m >= 0.5;
  }
  Pose pose() const override { return {}; }
  std::span<const Colour> resource_colours() const override { return {}; }
  mutable Pyramid asked{};
};

struct Reader {
  OneWall wall;
  Mounting mounting;
  Random random{5};

  template <class Reading>
  Reading read(Sensor& sensor, const Frame& frame) {
    sensor.update({0.0, 0.01, frame, &mounting, &wall, &random});
    return *static_cast<const Reading*>(sensor.reading());
  }
};

plugin::Object<Sensor> sensor(const char* name, test::Parameters parameters = {}) {
  return test::make<Sensor>(PluginKind::sensor, name, std::move(parameters));
}

}  // namespace

TEST_CASE("A beam reads the distance along its ray, or its maximum range") {
  const auto beam = sensor("beam_range");
  Reader reader;
  const auto straight = reader.read<RangeReading>(*beam, Frame::turned({0.1, 0, 0}, 0, 0));
  CHECK(straight.distance_m == Approx(0.4));
  CHECK(straight.hit);
  CHECK(reader.read<RangeReading>(*beam, Frame::turned({0, 0, 0}, radians(60), 0)).distance_m ==
        Approx(1.0));
  const auto away = reader.read<RangeReading>(*beam, Frame::turned({0, 0, 0}, radians(180), 0));
  CHECK(away.distance_m == 1.0);
  CHECK_FALSE(away.hit);
}

TEST_CASE("The error of a beam is a fraction of the distance, or absolute") {
  Reader reader;
  const auto spread = [&](test::Parameters parameters) {
    const auto beam = sensor("beam_range", std::move(parameters));
    double sum = 0, squares = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double d =
          reader.read<RangeReading>(*beam, Frame::turned({0.1, 0, 0}, 0, 0)).distance_m;
      sum += d;
      squares += d * d;
    }
    CHECK(sum / n == Approx(0.4).margin(0.002));
    return std::sqrt(squares / n - sum / n * sum / n);
  };
  CHECK(spread({}) == Approx(0.0).margin(1e-6));
  CHECK(spread({{"error", 0.1}}) == Approx(0.04).epsilon(0.03));
  CHECK(spread({{"error_m", 0.02}}) == Approx(0.02).epsilon(0.03));
  CHECK(spread({{"error", 0.1}, {"error_m", 0.03}}) == Approx(0.05).epsilon(0.03));
}

TEST_CASE("A noisy reading stays between zero and the maximum range") {
  Reader reader;
  const auto beam = sensor("beam_range", {{"error_m", 1.0}});
  for (int i = 0; i < 1000; ++i) {
    const double d = reader.read<RangeReading>(*beam, Frame::turned({0.1, 0, 0}, 0, 0)).distance_m;
    REQUIRE(d >= 0.0);
    REQUIRE(d <= 1.0);
  }
}

TEST_CASE("A proximity sensor asks about its pyramid") {
  const auto proximity = sensor("proximity", {{"max_range", 0.3}});
  Reader reader;
  CHECK(reader.read<ProximityReading>(*proximity, Frame::turned({0.25, 0, 0}, 0, 0)).detected);
  CHECK_FALSE(reader.read<ProximityReading>(*proximity, Frame::turned({0.1, 0, 0}, 0, 0)).detected);
  CHECK(reader.wall.asked.horizontal_fov_rad == Approx(radians(40)));
  CHECK(reader.wall.asked.vertical_fov_rad == Approx(radians(5)));
  CHECK(reader.wall.asked.range_m == 0.3);
}

TEST_CASE("The error of a proximity sensor is the probability of the wrong answer") {
  const auto proximity = sensor("proximity", {{"error", 0.2}});
  Reader reader;
  int detected = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    detected +=
        reader.read<ProximityReading>(*proximity, Frame::turned({0.4, 0, 0}, 0, 0)).detected;
  }
  CHECK(static_cast<double>(detected) / n == Approx(0.8).margin(0.01));
}
