#include "write_run.h"

#include "write_plan.h"

namespace elsie::batch {
namespace {

bool write_fields(sqlite::Connection& connection, std::int64_t run, const RunRecord& record) {
  sqlite::Statement update(connection, "UPDATE runs SET " + results::field_names(" = ?") +
                                           ", ended = ? WHERE id = ? AND state = 'pending'");
  const int next = results::bind_fields(update, 1, record);
  update.bind(next, utc_now()).bind(next + 1, run).run();
  return connection.changes() == 1;
}

void write_measures(sqlite::Connection& connection, std::int64_t run, const RunRecord& record) {
  // Runs are written in any order: the result for a measure must not depend on it.
  sqlite::Statement measure(
      connection,
      "INSERT INTO measures (name, unit, meaning) VALUES (?, ?, ?) ON CONFLICT (name) DO "
      "UPDATE SET unit = min(unit, excluded.unit), meaning = min(meaning, excluded.meaning)");
  auto value = sqlite::Statement::insert(connection, "run_measures", "run_id, measure, value");
  for (const simulation::MeasuredValue& each : record.measures) {
    measure.run(each.name, each.unit, each.meaning);
    value.run(run, each.name, each.value);
  }
}

}  // namespace

bool write_run(sqlite::Connection& connection, std::int64_t run, const RunRecord& record) {
  sqlite::Transaction transaction(connection);
  if (!write_fields(connection, run, record)) {
    return false;
  }
  write_measures(connection, run, record);
  const auto insert = [&](const char* table, const char* columns) {
    return sqlite::Statement::insert(connection, table, columns);
  };
  auto robot = insert("run_robots",
                      "run_id, robot, team, distance_m, collected, energy, collisions, x_m, y_m, "
                      "heading_rad");
  for (const simulation::RobotResult& each : record.robots) {
    robot.run(run, each.id, each.team, each.distance_m, each.collected, each.energy,
              each.collisions, each.pose.x, each.pose.y, each.pose.heading_rad);
  }
  std::int64_t place = 0;
  auto event = insert("run_events", "run_id, place, time_s, robot, name, detail");
  for (const Event& each : record.events) {
    event.run(run, place++, each.time_s, each.robot, each.name, each.detail);
  }
  auto trajectory = insert("trajectories", "run_id, robot, from_s, period_s, poses, touches");
  for (const Trajectory& each : record.trajectories) {
    trajectory.run(run, each.robot, each.from_s, each.period_s, each.poses, each.touches);
  }
  auto curve = insert("curves", "run_id, robot, plugin, name, x_label, y_label, points");
  for (const Curve& each : record.curves) {
    curve.run(run, each.robot, each.plugin, each.name, each.x_label, each.y_label, each.points);
  }
  auto timeline = insert("timelines", "run_id, robot, behaviors, episodes");
  for (const Timeline& each : record.timelines) {
    timeline.run(run, each.robot, each.behaviors, each.episodes);
  }
  place = 0;
  auto note = insert("notes", "run_id, place, robot, plugin, text");
  for (const simulation::Note& each : record.notes) {
    note.run(run, place++, each.robot, each.plugin, each.text);
  }
  transaction.commit();
  return true;
}

}  // namespace elsie::batch
