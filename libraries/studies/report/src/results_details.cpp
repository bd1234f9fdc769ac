// Large data, read cell by cell when they are drawn. Robots: r2 comes before r10.
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "elsie/report/results.h"

#include "results_state.h"

namespace elsie::report {

namespace {

using JsonValue = nlohmann::json;

// Which rows of a table, by the id that is bound.
constexpr const char* kOfCell = "run_id IN (SELECT id FROM runs WHERE cell_id = ?)";
constexpr const char* kOfRun = "run_id = ?";

std::string query(const std::string& columns, const std::string& table, const std::string& order,
                  const char* which = kOfCell) {
  return "SELECT run_id, " + columns + " FROM " + table + " WHERE " + which + " ORDER BY " + order;
}

// An element in a row of a list of lists; NaN if it is not a number.
double number(const JsonValue& row, std::size_t place) {
  return row.is_array() && place < row.size() && row[place].is_number() ? row[place].get<double>()
                                                                        : std::nan("");
}

std::string text_of(const JsonValue& object, const char* member) {
  const auto found = object.find(member);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

double number_of(const JsonValue& object, const char* member) {
  const auto found = object.find(member);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

// Passes each element of a JSON list to the visitor.
template <class Visitor>
void each(const std::string& text, const std::filesystem::path& file, const char* table,
          Visitor visit) {
  const JsonValue list = JsonValue::parse(text, nullptr, false);
  if (!list.is_array()) {
    throw results::damaged(file, "in `" + std::string(table) + "` a text is not a JSON list");
  }
  for (const JsonValue& element : list) visit(element);
}

std::vector<Trajectory> read_trajectories(sqlite::Connection& connection,
                                          const std::filesystem::path& file, const char* which,
                                          std::int64_t id) {
  std::vector<Trajectory> all;
  sqlite::Statement rows(connection,
                         query("robot, period_s, poses, x_m, y_m, heading_rad, from_s",
                               "trajectories LEFT JOIN run_robots USING (run_id, robot)",
                               "run_id, length(robot), robot", which));
  rows.bind(1, id);
  while (rows.next()) {
    Trajectory way{rows.integer(0), rows.text(1), rows.number(2), {}, rows.number(7)};
    each(rows.text(3), file, "trajectories", [&](const JsonValue& pose) {
      way.poses.push_back({number(pose, 0), number(pose, 1), number(pose, 2)});
    });
    way.has_end = !rows.is_null(4);  // null for failed runs
    if (way.has_end) way.poses.push_back({rows.number(4), rows.number(5), rows.number(6)});
    all.push_back(std::move(way));
  }
  return all;
}

std::vector<Timeline> read_timelines(sqlite::Connection& connection,
                                     const std::filesystem::path& file, const char* which,
                                     std::int64_t id) {
  std::vector<Timeline> all;
  sqlite::Statement rows(connection, query("robot, behaviors, episodes", "timelines",
                                           "run_id, length(robot), robot", which));
  rows.bind(1, id);
  while (rows.next()) {
    Timeline timeline{rows.integer(0), rows.text(1), {}, {}};
    each(rows.text(2), file, "timelines", [&](const JsonValue& behavior) {
      timeline.behaviors.push_back({text_of(behavior, "path"), number_of(behavior, "share"),
                                    number_of(behavior, "decided_s")});
    });
    each(rows.text(3), file, "timelines", [&](const JsonValue& episode) {
      Timeline::Episode& last =
          timeline.episodes.emplace_back(Timeline::Episode{number_of(episode, "from_s"),
                                                           number_of(episode, "to_s"),
                                                           text_of(episode, "decider"),
                                                           number_of(episode, "share"),
                                                           {}});
      const auto parts = episode.find("parts");
      if (parts == episode.end() || !parts->is_array()) return;
      for (const JsonValue& part : *parts) {
        last.parts.emplace_back(text_of(part, "decider"), number_of(part, "time_s"));
      }
    });
    all.push_back(std::move(timeline));
  }
  return all;
}

}  // namespace

std::vector<Trajectory> ResultsFile::trajectories(std::int64_t cell) const {
  return state_->reading(
      [&] { return read_trajectories(state_->connection, state_->file, kOfCell, cell); });
}

std::vector<Curve> ResultsFile::curves(std::int64_t cell) const {
  return state_->reading([&] {
    std::vector<Curve> all;
    sqlite::Statement rows(state_->connection,
                           query("robot, plugin, name, x_label, y_label, points", "curves",
                                 "run_id, length(robot), robot, plugin, name"));
    rows.bind(1, cell);
    while (rows.next()) {
      Curve curve{rows.integer(0),
                  rows.text(1),
                  rows.text(2),
                  rows.text(3),
                  rows.text(4),
                  rows.text(5),
                  {}};
      each(rows.text(6), state_->file, "curves", [&](const JsonValue& point) {
        curve.points.push_back({number(point, 0), number(point, 1)});
      });
      all.push_back(std::move(curve));
    }
    return all;
  });
}

std::vector<Event> ResultsFile::events(std::int64_t cell) const {
  return state_->reading([&] {
    std::vector<Event> all;
    sqlite::Statement rows(state_->connection,
                           query("time_s, name", "run_events", "run_id, place"));
    rows.bind(1, cell);
    while (rows.next()) {
      all.push_back({rows.integer(0), rows.number(1), rows.text(2), {}, {}});
    }
    return all;
  });
}

std::vector<Timeline> ResultsFile::timelines(std::int64_t cell) const {
  return state_->reading(
      [&] { return read_timelines(state_->connection, state_->file, kOfCell, cell); });
}

std::vector<std::int64_t> ResultsFile::runs_with_trajectories() const {
  return state_->reading([&] {
    std::vector<std::int64_t> runs;
    sqlite::Statement rows(state_->connection,
                           "SELECT DISTINCT run_id FROM trajectories ORDER BY run_id");
    while (rows.next()) runs.push_back(rows.integer(0));
    return runs;
  });
}

RunDetails ResultsFile::run_details(std::int64_t run) const {
  return state_->reading([&] {
    sqlite::Connection& connection = state_->connection;
    RunDetails details;
    sqlite::Statement world(connection, "SELECT world_text FROM run_worlds WHERE run_id = ?");
    world.bind(1, run);
    if (world.next()) details.world_text = world.text(0);
    details.trajectories = read_trajectories(connection, state_->file, kOfRun, run);
    details.timelines = read_timelines(connection, state_->file, kOfRun, run);
    sqlite::Statement rows(connection,
                           query("time_s, name, robot, detail", "run_events", "place", kOfRun));
    rows.bind(1, run);
    while (rows.next()) {
      details.events.push_back(
          {rows.integer(0), rows.number(1), rows.text(2), rows.text(3), rows.text(4)});
    }
    return details;
  });
}

}  // namespace elsie::report
