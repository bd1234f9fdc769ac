// Drives to the nearest green thing that an omnidirectional camera sees.
#include <elsie/api/behavior.h>
#include <elsie/readings/omnidirectional_camera.h>

class FetchGreen final : public elsie::Behavior {
 public:
  double speed = 0.2;

  elsie::Response respond(const elsie::Perception& now) override {
    for (const auto& blob : now.readings<elsie::OmnidirectionalReading>()[0]->blobs) {
      if (blob.green <= blob.red || blob.green <= blob.blue) continue;  // the nearest come first
      return elsie::Motion{speed * std::max(0.0, std::cos(blob.bearing_rad)), 0.0,
                           2.0 * blob.bearing_rad};
    }
    return elsie::Motion{0.0, 0.0, 0.5};  // it looks around
  }
};

ELSIE_BEHAVIOR(FetchGreen, "fetch_green", "Drives to the nearest green thing around it",
               elsie::needs<elsie::OmnidirectionalReading>(),
               elsie::parameter("speed", &FetchGreen::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "straight on"}));
