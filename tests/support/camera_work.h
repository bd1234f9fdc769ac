// A sensor with a camera, alone in a world that is drawn but does not run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elsie/api/sensor.h"
#include "elsie/render/renderer.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/colours.h"
#include "elsie/world/description.h"

#include "shipped.h"

namespace elsie::test {

/// Surroundings that only know the resources' colours, which a sensor with a camera asks for.
class Colours final : public Surroundings {
 public:
  std::vector<Colour> colours;

  std::optional<double> cast_ray(const Vector3&, const Vector3&, double) const override {
    return std::nullopt;
  }
  void cast_rays(const Frame&, std::span<RayQuery>, std::span<Surface>) const override {}
  bool anything_in(const Pyramid&) const override { return false; }
  Pose pose() const override { return {}; }
  std::span<const Colour> resource_colours() const override { return colours; }
};

/// A vision sensor that gets one picture after another.
class Watcher {
 public:
  explicit Watcher(Parameters parameters = {}, const std::vector<ElementValue>& elements = {})
      : sensor_(make<Sensor>(PluginKind::sensor, "vision", std::move(parameters), elements)) {}

  Colours world;  // the sensor learns changed colours before it looks
  Random random{1};

  const VisionReading& look_at(const Image& image) {
    const Mounting mounting;
    if (told_ != world.colours) {
      told_ = world.colours;
      sensor_->equipped({&mounting, *told_});
    }
    SensorContext now{0.0, 0.01, {}, &mounting, &world, &random};
    now.image = &image;
    sensor_->update(now);
    return *static_cast<const VisionReading*>(sensor_->reading());
  }
  Sensor& sensor() { return *sensor_; }
  Camera camera() const { return *sensor_->camera(); }

 private:
  plugin::Object<Sensor> sensor_;
  std::optional<std::vector<Colour>> told_;
};

/// A picture of a world by a free camera.
inline Image photograph(const world::World& world, const Frame& from, const Camera& camera,
                        std::size_t carrier = render::kNobody) {
  static render::Renderer renderer;
  Image image;
  Image* place[] = {&image};
  const render::View view{from, camera, carrier};
  renderer.render(render::WorldScene(world).scene(), std::span(&view, 1), place);
  return image;
}

}  // namespace elsie::test
