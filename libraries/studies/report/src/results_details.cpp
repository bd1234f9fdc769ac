// Large data, read cell by cell when they are drawn. Robots: r2 comes before r10.
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "elsie/report/results.h"

#include "results_state.h"

namespace elsie::report {

namespace {

using JsonValue = nlohmann::json;

std::string query(const std::string& columns, const std::string& table, const std::string& order) {
  return "SELECT run_id, " + columns + " FROM " + table +
         " WHERE run_id IN (SELECT id FROM runs WHERE cell_id = ?) ORDER BY " + order;
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

}  // namespace

std::vector<Trajectory> ResultsFile::trajectories(std::int64_t cell) const {
  return state_->reading([&] {
    std::vector<Trajectory> all;
    const std::filesystem::path& file = state_->file;
    sqlite::Statement rows(state_->connection,
                           query("robot, period_s, poses, x_m, y_m, heading_rad, from_s",
                                 "trajectories LEFT JOIN run_robots USING (run_id, robot)",
                                 "run_id, length(robot), robot"));
    rows.bind(1, cell);
    while (rows.next()) {
      Trajectory way{rows.integer(0), rows.text(1), rows.number(2), {}, rows.number(7)};
      each(rows.text(3), file, "trajectories", [&](const JsonValue& pose) {
        way.poses.push_back({number(pose, 0), number(pose, 1), number(pose, 2)});
      });
      if (!rows.is_null(4)) {  // null for failed runs
        way.poses.push_back({rows.number(4), rows.number(5), rows.number(6)});
      }
      all.push_back(std::move(way));
    }
    return all;
  });
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
      all.push_back({rows.integer(0), rows.number(1), rows.text(2)});
    }
    return all;
  });
}

std::vector<Timeline> ResultsFile::timelines(std::int64_t cell) const {
  return state_->reading([&] {
    std::vector<Timeline> all;
    const std::filesystem::path& file = state_->file;
    sqlite::Statement rows(state_->connection, query("robot, behaviors, episodes", "timelines",
                                                     "run_id, length(robot), robot"));
    rows.bind(1, cell);
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
  });
}

}  // namespace elsie::report
