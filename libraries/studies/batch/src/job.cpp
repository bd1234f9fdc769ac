#include "elsie/batch/job.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

// nlohmann-json finds these conversions by the namespaces of the types.

template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  static void to_json(json& to, const std::optional<T>& from) {
    to = from ? json(*from) : json(nullptr);
  }
  static void from_json(const json& from, std::optional<T>& to) {
    to = from.is_null() ? std::nullopt : std::optional(from.get<T>());
  }
};

namespace elsie {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pose, x, y, heading_rad)

static void to_json(nlohmann::json& to, RunEnd::Outcome from) { to = simulation::to_string(from); }
static void from_json(const nlohmann::json& from, RunEnd::Outcome& to) {
  to = results::outcome_of(from.get<std::string>()).value();
}

}  // namespace elsie

namespace elsie::simulation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MeasuredValue, name, unit, meaning, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RobotResult, id, team, distance_m, collected, energy, pose,
                                   collisions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Note, robot, plugin, text)

}  // namespace elsie::simulation

namespace elsie::results {

static void to_json(nlohmann::json& to, RunState from) { to = to_string(from); }
static void from_json(const nlohmann::json& from, RunState& to) {
  to = run_state(from.get<std::string>());
}

}  // namespace elsie::results

namespace elsie::batch {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, run, world_text, world_file, files, libraries, seed,
                                   trajectory_period_s, threads)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Event, time_s, robot, name, detail)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Trajectory, robot, from_s, period_s, poses, touches)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Curve, robot, plugin, name, x_label, y_label, points)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Timeline, robot, behaviors, episodes)

namespace {

using nlohmann::json;

template <class Record, class Visit>
void for_each_part(Record& record, Visit visit) {
  for_each_field(record, visit);
  visit("measures", record.measures);
  visit("robots", record.robots);
  visit("events", record.events);
  visit("trajectories", record.trajectories);
  visit("curves", record.curves);
  visit("timelines", record.timelines);
  visit("notes", record.notes);
}

json parsed(std::string_view text, const std::string& what) {
  json object = json::parse(text, nullptr, false);
  if (!object.is_object()) {
    throw std::runtime_error(what + " is not a JSON object");
  }
  return object;
}

/// JSON on one line; bytes that are not UTF-8 are replaced.
std::string dumped(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const Job& job) { return dumped(job); }

Job job_from(std::string_view text) {
  const json object = parsed(text, "the job");
  try {
    return object.get<Job>();
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("the job is not complete: ") + error.what());
  }
}

std::string to_json(const RunRecord& record) {
  json object;
  for_each_part(record, [&](const char* name, const auto& value) { object[name] = value; });
  return dumped(object);
}

RunRecord record_from(std::string_view text) {
  const json object = parsed(text, "the answer of the worker");
  try {
    RunRecord record;
    for_each_part(record, [&](const char* name, auto& value) { object.at(name).get_to(value); });
    return record;
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("the answer of the worker is not complete: ") +
                             error.what());
  }
}

}  // namespace elsie::batch
