#include "elsie/batch/job.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace elsie::batch {
namespace {

using Json = nlohmann::json;

/// Fields without a value are left out.
struct FieldWriter {
  Json& object;

  void operator()(const char* name, RunState state) { object[name] = to_string(state); }
  void operator()(const char* name, const std::string& text) { object[name] = text; }
  void operator()(const char* name, const std::optional<simulation::Outcome>& outcome) {
    if (outcome) {
      object[name] = simulation::to_string(*outcome);
    }
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    if (value) {
      object[name] = *value;
    }
  }
};

struct FieldReader {
  const Json& object;

  void operator()(const char* name, RunState& state) {
    state = results::run_state(object.at(name).get<std::string>());
  }
  void operator()(const char* name, std::string& text) { object.at(name).get_to(text); }
  void operator()(const char* name, std::optional<simulation::Outcome>& outcome) {
    outcome = results::outcome_of(object.value(name, ""));
  }
  template <class T>
  void operator()(const char* name, std::optional<T>& value) {
    if (const auto at = object.find(name); at != object.end() && !at->is_null()) {
      value = at->get<T>();
    }
  }
};

template <class List, class Make>
Json list(const List& from, Make make) {
  Json array = Json::array();
  for (const auto& item : from) {
    array.push_back(make(item));
  }
  return array;
}

template <class List, class Make>
void read_list(const Json& object, const char* name, List& into, Make make) {
  for (const Json& item : object.at(name)) {
    into.push_back(make(item));
  }
}

std::string text(const Json& array, std::size_t place) {
  return array.at(place).get<std::string>();
}
double number(const Json& array, std::size_t place) { return array.at(place).get<double>(); }

Json parsed(std::string_view json, const char* what) {
  Json object = Json::parse(json, nullptr, false);
  if (!object.is_object()) {
    throw std::runtime_error(std::string(what) + " is not a JSON object");
  }
  return object;
}

/// JSON on one line; bytes that are not UTF-8 are replaced.
std::string dumped(const Json& object) {
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const Job& job) {
  return dumped({{"run", job.run},
                 {"world_text", job.world_text},
                 {"world_file", job.world_file},
                 {"files", job.files},
                 {"libraries", job.libraries},
                 {"seed", job.seed},
                 {"trajectory_period_s", job.trajectory_period_s},
                 {"threads", job.threads}});
}

Job job_from(std::string_view json) {
  const Json object = parsed(json, "the job");
  try {
    Job job;
    object.at("run").get_to(job.run);
    object.at("world_text").get_to(job.world_text);
    object.at("world_file").get_to(job.world_file);
    object.at("files").get_to(job.files);
    object.at("libraries").get_to(job.libraries);
    object.at("seed").get_to(job.seed);
    object.at("trajectory_period_s").get_to(job.trajectory_period_s);
    object.at("threads").get_to(job.threads);
    return job;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("the job is not complete: ") + error.what());
  }
}

std::string to_json(const RunRecord& record) {
  Json object = Json::object();
  for_each_field(record, FieldWriter{object});
  object["measures"] = list(record.measures, [](const Measure& measure) {
    return Json{measure.name, measure.unit, measure.meaning,
                measure.value ? Json(*measure.value) : Json(nullptr)};
  });
  object["robots"] = list(record.robots, [](const simulation::RobotResult& robot) {
    return Json{robot.id,        robot.team,   robot.distance_m,
                robot.collected, robot.energy, robot.collisions,
                robot.pose.x,    robot.pose.y, robot.pose.heading_rad};
  });
  object["events"] = list(record.events, [](const Event& event) {
    return Json{event.time_s, event.robot, event.name, event.detail};
  });
  object["trajectories"] = list(record.trajectories, [](const Trajectory& trajectory) {
    return Json{trajectory.robot, trajectory.from_s, trajectory.period_s, trajectory.poses,
                trajectory.touches};
  });
  object["curves"] = list(record.curves, [](const Curve& curve) {
    return Json{curve.robot, curve.plugin, curve.name, curve.x_label, curve.y_label, curve.points};
  });
  object["timelines"] = list(record.timelines, [](const Timeline& timeline) {
    return Json{timeline.robot, timeline.behaviors, timeline.episodes};
  });
  object["notes"] = list(record.notes, [](const simulation::Note& note) {
    return Json{note.robot, note.plugin, note.text};
  });
  return dumped(object);
}

RunRecord record_from(std::string_view json) {
  const Json object = parsed(json, "the answer of the worker");
  try {
    RunRecord record;
    for_each_field(record, FieldReader{object});
    read_list(object, "measures", record.measures, [](const Json& a) {
      Measure measure{text(a, 0), text(a, 1), text(a, 2), std::nullopt};
      if (!a.at(3).is_null()) {
        measure.value = number(a, 3);
      }
      return measure;
    });
    read_list(object, "robots", record.robots, [](const Json& a) {
      simulation::RobotResult robot;
      robot.id = text(a, 0);
      robot.team = text(a, 1);
      robot.distance_m = number(a, 2);
      robot.collected = a.at(3).get<int>();
      robot.energy = number(a, 4);
      robot.collisions = a.at(5).get<int>();
      robot.pose = {number(a, 6), number(a, 7), number(a, 8)};
      return robot;
    });
    read_list(object, "events", record.events, [](const Json& a) {
      return Event{number(a, 0), text(a, 1), text(a, 2), text(a, 3)};
    });
    read_list(object, "trajectories", record.trajectories, [](const Json& a) {
      return Trajectory{text(a, 0), number(a, 1), number(a, 2), text(a, 3), text(a, 4)};
    });
    read_list(object, "curves", record.curves, [](const Json& a) {
      return Curve{text(a, 0), text(a, 1), text(a, 2), text(a, 3), text(a, 4), text(a, 5)};
    });
    read_list(object, "timelines", record.timelines, [](const Json& a) {
      return Timeline{text(a, 0), text(a, 1), text(a, 2)};
    });
    read_list(object, "notes", record.notes, [](const Json& a) {
      return simulation::Note{text(a, 0), text(a, 1), text(a, 2)};
    });
    return record;
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("the answer of the worker is not complete: ") +
                             error.what());
  }
}

}  // namespace elsie::batch
