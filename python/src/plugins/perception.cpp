#include "perception.h"

#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

namespace elsie::python {

Now::Now()
    : perception_(std::make_shared<Lent<const Perception>>()),
      random_(std::make_shared<Lent<Random>>()) {}

py::object Now::readings() {
  const auto groups = perception().all_readings();
  bool fits = readings_ && groups.size() == made_.size();
  for (std::size_t i = 0; fits && i < groups.size(); ++i) fits = made_[i].arrays->fits(groups[i]);
  if (!fits) {
    readings_ = py::module_::import("elsie.plugins").attr("_Readings")();
    made_.clear();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      py::object arrays = py::cast(ReadingArrays(perception_, i, ""));
      readings_[py::str(groups[i].kind.name)] = arrays;
      made_.push_back({arrays, arrays.cast<ReadingArrays*>()});
    }
  }
  return readings_;
}

namespace {

/// The robot itself, `now.self`.
struct Self {
  LentPerception perception;
  const OwnState& operator*() const { return (**perception).self(); }
};
struct Team {
  LentPerception perception;
  const TeamState& operator*() const { return (**perception).team(); }
};

py::object place_or_none(const std::optional<Vector2>& place) {
  return place ? py::object(py::make_tuple(place->x, place->y)) : py::none();
}

py::object mate(const TeamMate& mate) {
  return py::module_::import("elsie.plugins")
      .attr("Mate")(mate.id, mate.pose, mate.distance_m, mate.bearing_rad, mate.is_leader,
                    mate.team_index);
}

template <class Get>
auto of_self(Get get) {
  return [get](const Self& self) { return get(*self); };
}

void bind_self(py::module_& module) {
  py::class_<Self>(module, "Self", "The robot itself: its pose and motion are what it believes.")
      .def_property_readonly("id", of_self([](const OwnState& own) { return own.id; }))
      .def_property_readonly("pose", of_self([](const OwnState& own) { return own.pose; }))
      .def_property_readonly("commanded",
                             of_self([](const OwnState& own) { return own.commanded; }),
                             "The last command, as the drive can make it.")
      .def_property_readonly("moving", of_self([](const OwnState& own) { return own.moving; }))
      .def_property_readonly("odometry", of_self([](const OwnState& own) { return own.odometry; }),
                             "The motion of its wheels, if none slips.")
      .def_property_readonly("has_lateral",
                             of_self([](const OwnState& own) { return own.channels.lateral; }),
                             "Whether its drive can move it to the side.")
      .def_property_readonly("wheel_radius_m",
                             of_self([](const OwnState& own) { return own.wheels.radius; }))
      .def_property_readonly("half_axle_m",
                             of_self([](const OwnState& own) { return own.wheels.half_axle; }))
      .def_property_readonly("length_m", of_self([](const OwnState& own) { return own.length_m; }))
      .def_property_readonly("width_m", of_self([](const OwnState& own) { return own.width_m; }))
      .def_property_readonly("max_speed_m_s",
                             of_self([](const OwnState& own) { return own.max_speed_m_s; }))
      .def_property_readonly("max_wheel_rate",
                             of_self([](const OwnState& own) { return own.max_wheel_rate(); }),
                             "rad/s")
      .def_property_readonly("coverage_m",
                             of_self([](const OwnState& own) { return own.coverage_m; }))
      .def_property_readonly("is_leader",
                             of_self([](const OwnState& own) { return own.is_leader; }))
      .def_property_readonly("team_index",
                             of_self([](const OwnState& own) { return own.team_index; }))
      .def_property_readonly("energy", of_self([](const OwnState& own) { return own.energy; }))
      .def_property_readonly("capacity", of_self([](const OwnState& own) { return own.capacity; }))
      .def_property_readonly("charging", of_self([](const OwnState& own) { return own.charging; }))
      .def_property_readonly(
          "held", of_self([](const OwnState& own) {
            py::list held;
            for (const HeldThing& thing : own.held) {
              held.append(py::module_::import("elsie.plugins")
                              .attr("Held")(thing.id, thing.actuator, thing.moves));
            }
            return held;
          }),
          "What it holds: id, actuator, moves.")
      .def(
          "motion",
          [](const Self& self, double left, double right) {
            return (*self).wheels.motion({left, right});
          },
          py::arg("left"), py::arg("right"),
          "The motion of wheels that turn at these rates, rad/s.")
      .def(
          "wheel_rates",
          [](const Self& self, const Motion& motion) {
            const WheelRates rates = (*self).wheels.wheel_rates(motion);
            return py::make_tuple(rates.left, rates.right);
          },
          py::arg("motion"), "The rates of the wheels (left, right) for a motion, rad/s.");

  py::class_<Team>(module, "Team", "The team of the robot.")
      .def_property_readonly("name", [](const Team& team) { return (*team).name; })
      .def_property_readonly(
          "mates",
          [](const Team& team) {
            py::list mates;
            for (const TeamMate& each : (*team).mates) mates.append(mate(each));
            return mates;
          },
          "Robots of the team whose coverage reaches this one.")
      .def_property_readonly(
          "leader",
          [](const Team& team) -> py::object {
            const TeamMate* const leader = (*team).leader();
            return leader ? mate(*leader) : py::none();
          },
          "The nearest leader among them, or None.")
      .def_property_readonly(
          "charger", [](const Team& team) { return place_or_none((*team).charger); },
          "(x, y) of the nearest charger, or None.")
      .def_property_readonly(
          "nest",
          [](const Team& team) -> py::object {
            const auto& nest = (*team).nest;
            if (!nest) return py::none();
            return py::make_tuple(nest->place.x, nest->place.y, nest->radius_m);
          },
          "(x, y, radius) of the nearest nest, or None.");
}

py::list heard(const Perception& now, const std::optional<std::string>& kind) {
  py::list all;
  for (const HeardMessage& heard : now.all_heard()) {
    if (kind && *kind != heard.message->kind().name) continue;
    py::dict numbers;
    heard.message->visit_fields([&](const ReadingField& field) {
      const py::str name(field.name.data(), field.name.size());
      if (!field.is_array) {
        numbers[name] = field.number(0);
        return;
      }
      py::list array;
      for (std::size_t i = 0; i < field.count; ++i) array.append(field.number(i));
      numbers[name] = array;
    });
    all.append(py::module_::import("elsie.plugins")
                   .attr("Heard")(heard.message->kind().name, numbers, heard.device, heard.from,
                                  heard.age_s, heard.distance_m, heard.bearing_rad,
                                  heard.elevation_rad));
  }
  return all;
}

}  // namespace

void bind_perception(py::module_& module) {
  bind_reading_arrays(module);
  bind_self(module);
  py::class_<Now>(module, "Now", "What a behaviour or coordinator perceives, during a call.")
      .def_property_readonly(
          "time", [](const Now& now) { return now.perception().time_s(); },
          "s, since the start of the run")
      .def_property_readonly(
          "period", [](const Now& now) { return now.perception().period_s(); },
          "s, from one decision to the next")
      .def_property_readonly("readings", &Now::readings,
                             "The readings by their kinds: now.readings[\"range\"].distance_m.")
      .def_property_readonly(
          "self",
          [](const Now& now) {
            now.perception();
            return Self{now.lent()};
          },
          "The robot itself.")
      .def_property_readonly(
          "team", [](const Now& now) { return Team{now.lent()}; },
          "its team, as far as it knows it")
      .def_property_readonly(
          "events",
          [](const Now& now) {
            py::list events;
            for (const Event& event : now.perception().events()) events.append(event.name);
            return events;
          },
          "The names of events of the last control period.")
      .def(
          "heard",
          [](const Now& now, const std::optional<std::string>& kind) {
            return heard(now.perception(), kind);
          },
          py::arg("kind") = py::none(), "The messages of this period, of one kind or of all.")
      .def_property_readonly(
          "random", [](const Now& now) { return now.random(); },
          "The object's own stream of random numbers.");
}

}  // namespace elsie::python
