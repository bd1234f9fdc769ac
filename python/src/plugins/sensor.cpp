// Sensors in Python.
#include "sensor.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/api/sensor.h"
#include "elsie/api/surroundings.h"
#include "elsie/base/number_text.h"

#include "device.h"
#include "image_array.h"
#include "kinds.h"
#include "perception.h"

namespace elsie::python {
namespace {

/// `now` of a sensor.
struct SensorNow : Made {
  LentTo<const SensorContext> context = std::make_shared<Lent<const SensorContext>>();
  LentRandom random = std::make_shared<Lent<Random>>();

  const SensorContext& operator*() const { return **context; }
  const SensorContext* operator->() const { return &**context; }
};

class ScriptedSensor : public ScriptedDevice<Sensor> {
 public:
  explicit ScriptedSensor(const ScriptClassRef& of)
      : ScriptedDevice(of, StructLayout::of(of->declared["struct"])) {
    run({}, [&] {
      sense_ = method("sense");
      equipped_ = method("equipped");
      camera_ = method("camera");
      now_ = py::cast(made<SensorNow>());
      lends_ = now_.cast<SensorNow*>();
    });
  }
  ~ScriptedSensor() override { drop({&sense_, &equipped_, &camera_, &now_}); }

  void equipped(const Carrier& carrier) override { call_if_there(equipped_, *carrier.mounting); }
  std::optional<Camera> camera() const override {
    if (!camera_) return std::nullopt;
    return run(camera_, [&]() -> std::optional<Camera> {
      const py::object given = camera_();
      if (given.is_none()) return std::nullopt;
      const auto [width, height, fov_rad] = given.cast<std::tuple<int, int, double>>();
      return Camera{width, height, fov_rad};
    });
  }
  void update(const SensorContext& now) override {
    run(sense_, [&] {
      const Lending context(*lends_->context, now);
      const Lending random(*lends_->random, *now.random);
      layout().fill(in_work(), sense_(now_), "its reading");
      check(in_work());
    });
  }

 private:
  py::object sense_, equipped_, camera_, now_;
  SensorNow* lends_ = nullptr;
};

/// A ray from the sensor, turned to the left by `azimuth` and upwards by `pitch`.
/// A number of a script, which engines take as it is.
double finite(const char* name, double value) {
  if (std::isfinite(value)) return value;
  throw py::value_error(std::string(name) + " is " + base::number_text(value) +
                        "; expected a finite number");
}
/// The same for a length.
double length(const char* name, double value) {
  if (std::isfinite(value) && value >= 0.0) return value;
  throw py::value_error(std::string(name) + " is " + base::number_text(value) +
                        "; expected a finite number of at least 0");
}

Frame ray(const SensorContext& now, double azimuth_rad, double pitch_rad) {
  finite("azimuth_rad", azimuth_rad);
  finite("pitch_rad", pitch_rad);
  return now.frame.frame(Frame::turned({}, azimuth_rad, pitch_rad));
}

const char* name_of(Thing::Kind kind) {
  constexpr const char* kNames[] = {"nothing",  "floor",   "wall", "obstacle",
                                    "resource", "charger", "robot"};
  return kNames[static_cast<std::size_t>(kind)];
}

py::object thing_of(const Thing& thing) {
  return py::module_::import("elsie.plugins")
      .attr("Thing")(name_of(thing.kind), thing.id, thing.team,
                     py::make_tuple(thing.colour.red, thing.colour.green, thing.colour.blue));
}

py::tuple colour_of(const Colour& colour) {
  return py::make_tuple(colour.red, colour.green, colour.blue);
}

py::tuple place_of(const Vector3& place) { return py::make_tuple(place.x, place.y, place.z); }

py::list lamps_of(std::span<const LampView> lamps) {
  py::list all;
  for (const LampView& lamp : lamps) {
    all.append(
        py::module_::import("elsie.plugins")
            .attr("Lamp")(lamp.id, place_of(lamp.place), lamp.intensity, colour_of(lamp.colour)));
  }
  return all;
}

Vector2 place_or_own(const SensorContext& now, std::optional<double> x, std::optional<double> y) {
  return {finite("x", x.value_or(now.frame.origin.x)), finite("y", y.value_or(now.frame.origin.y))};
}

}  // namespace

void bind_sensors(py::module_& module) {
  py::class_<Mounting>(module, "Mounting",
                       "Where a sensor or an actuator is, in the frame of its robot.")
      .def_property_readonly(
          "place", [](const Mounting& own) { return place_of(own.position); }, "(x, y, z) in m")
      .def_readonly("azimuth_rad", &Mounting::azimuth_rad)
      .def_readonly("pitch_rad", &Mounting::pitch_rad)
      .def_readonly("segment", &Mounting::segment);
  py::class_<SensorNow>(module, "SensorNow", "What a sensor may ask of the world, during sense().")
      .def_property_readonly(
          "time", [](const SensorNow& now) { return now->time_s; }, "s")
      .def_property_readonly(
          "period", [](const SensorNow& now) { return now->period_s; }, "s")
      .def_property_readonly(
          "random", [](const SensorNow& now) { return now.random; }, "its own stream")
      .def_property_readonly(
          "mounting", [](const SensorNow& now) { return *now->mounting; },
          "where it is on its robot")
      .def_property_readonly(
          "place", [](const SensorNow& now) { return place_of(now->frame.origin); },
          "(x, y, z) of the sensor in the world")
      .def_property_readonly(
          "forward", [](const SensorNow& now) { return place_of(now->frame.forward); },
          "the direction in which it looks, a unit vector in the world")
      .def_property_readonly(
          "pose", [](const SensorNow& now) { return now->world->pose(); },
          "the true pose of the robot")
      .def_property_readonly(
          "motion",
          [](const SensorNow& now) {
            const BodyMotion motion = now->world->motion();
            return py::make_tuple(place_of(motion.velocity), place_of(motion.turning));
          },
          "the true velocity (m/s) and turning (rad/s) of the robot, in the world")
      .def_property_readonly(
          "energy", [](const SensorNow& now) { return now->world->self().energy; },
          "in the battery of the robot, units")
      .def(
          "ray",
          [](const SensorNow& now, double range_m, double azimuth_rad, double pitch_rad) {
            const Frame from = ray(*now, azimuth_rad, pitch_rad);
            return now->world->cast_ray(from.origin, from.forward, length("range_m", range_m));
          },
          py::arg("range_m"), py::arg("azimuth_rad") = 0.0, py::arg("pitch_rad") = 0.0,
          "The distance to the first surface in this direction from that of the sensor, or None.")
      .def(
          "see",
          [](const SensorNow& now, double range_m, double azimuth_rad,
             double pitch_rad) -> py::object {
            const Frame from = ray(*now, azimuth_rad, pitch_rad);
            RayQuery query{&from, length("range_m", range_m)};
            Surface surface;
            now->world->cast_rays(Frame{}, {&query, 1}, {&surface, 1});
            if (query.distance_m == RayQuery::kNothing) return py::none();
            return py::make_tuple(query.distance_m, thing_of(now->world->thing(surface)));
          },
          py::arg("range_m"), py::arg("azimuth_rad") = 0.0, py::arg("pitch_rad") = 0.0,
          "(distance, thing) of the first surface in this direction, or None.")
      .def(
          "anything_in",
          [](const SensorNow& now, double range_m, double horizontal_fov_rad,
             double vertical_fov_rad) {
            return now->world->anything_in(
                {now->frame, length("horizontal_fov_rad", horizontal_fov_rad),
                 length("vertical_fov_rad", vertical_fov_rad), length("range_m", range_m)});
          },
          py::arg("range_m"), py::arg("horizontal_fov_rad"), py::arg("vertical_fov_rad"),
          "Whether a body reaches into a pyramid before the sensor.")
      .def(
          "is_open",
          [](const SensorNow& now, double x, double y, double z) {
            return now->world->is_open(now->frame.origin,
                                       {finite("x", x), finite("y", y), finite("z", z)});
          },
          py::arg("x"), py::arg("y"), py::arg("z"), "Whether nothing is between it and a place.")
      .def(
          "things",
          [](const SensorNow& now, double radius_m) {
            std::vector<NearThing> things;
            now->world->things_within(length("radius_m", radius_m), things);
            py::list all;
            for (const NearThing& each : things) {
              all.append(py::make_tuple(thing_of(each.thing), each.distance_m, each.bearing_rad));
            }
            return all;
          },
          py::arg("radius_m"),
          "(thing, distance, bearing) of resources, boxes, chargers and robots.")
      .def_property_readonly(
          "lamps", [](const SensorNow& now) { return lamps_of(now->world->lamps()); },
          "All lamps of the world, also hidden ones.")
      .def(
          "lights",
          [](const SensorNow& now, double radius_m) {
            std::vector<LampView> lights;
            now->world->lights_within(length("radius_m", radius_m), lights);
            return lamps_of(lights);
          },
          py::arg("radius_m"), "What actuators of other robots shine, also hidden lights.")
      .def(
          "floor_colour",
          [](const SensorNow& now, std::optional<double> x, std::optional<double> y) {
            return colour_of(now->world->floor_colour(place_or_own(*now, x, y)));
          },
          py::arg("x") = py::none(), py::arg("y") = py::none(),
          "(red, green, blue) of the floor below the sensor, or elsewhere.")
      .def(
          "field",
          [](const SensorNow& now, const std::string& id, std::optional<double> x,
             std::optional<double> y) { return now->world->field(id, place_or_own(*now, x, y)); },
          py::arg("id"), py::arg("x") = py::none(), py::arg("y") = py::none(),
          "The value of a field of the world below the sensor, or elsewhere.")
      .def_property_readonly(
          "contacts",
          [](const SensorNow& now) {
            py::list all;
            for (const Contact& each : now->world->contacts()) {
              all.append(py::make_tuple(thing_of(now->world->thing(each.other)),
                                        place_of(each.place), each.impulse_n_s));
            }
            return all;
          },
          "(thing, place, impulse in N s) of what touched the robot; needs feels_contacts = True.")
      .def_property_readonly(
          "image",
          [](const SensorNow& now) -> py::object {
            if (!now->image) return py::none();
            return array_of(*now->image);
          },
          "The picture of its camera: (rows, columns, 3), or None.");
}

std::unique_ptr<Component> make_sensor(const ScriptClassRef& of) {
  return make_scripted<ScriptedSensor>(of);
}

}  // namespace elsie::python
