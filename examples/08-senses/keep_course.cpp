// Keeps a course by a compass.
#include <elsie/api/behavior.h>
#include <elsie/readings/compass.h>

class KeepCourse final : public elsie::Behavior {
 public:
  double course_deg = 0.0;
  double speed = 0.2;

  elsie::Response respond(const elsie::Perception& now) override {
    const auto compass = now.readings<elsie::CompassReading>()[0];
    const double off = elsie::wrap_angle(elsie::radians(course_deg) - compass->heading_rad);
    return elsie::Motion{speed, 0.0, 6.0 * off};
  }
  void sketch(elsie::Sketch& sketch) const override {
    sketch.arrow(elsie::SketchRole::wish, {}, {0.3, 0.0, 0.0});
  }
};

ELSIE_BEHAVIOR(KeepCourse, "keep_course", "Keeps a course by a compass",
               elsie::needs<elsie::CompassReading>(),
               elsie::parameter("course_deg", &KeepCourse::course_deg,
                                {.unit = "deg", .meaning = "from east, counter-clockwise"}),
               elsie::parameter("speed", &KeepCourse::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "ahead"}));
