#include "write_run.h"

#include "write_plan.h"

namespace elsie::batch {

RunWriter::RunWriter(sqlite::Connection& connection)
    : connection_(connection),
      run_(connection, "UPDATE runs SET " + results::field_names(" = ?") +
                           ", ended = ? WHERE id = ? AND state = 'pending'"),
      // Runs are written in any order: the result for a measure must not depend on it.
      measure_(connection,
               "INSERT INTO measures (name, unit, meaning) VALUES (?, ?, ?) ON CONFLICT (name) DO "
               "UPDATE SET unit = min(unit, excluded.unit), meaning = min(meaning, "
               "excluded.meaning)"),
      run_measure_(insert("run_measures", "run_id, measure, value")),
      robot_(insert("run_robots",
                    "run_id, robot, team, distance_m, collected, energy, collisions, x_m, y_m, "
                    "heading_rad")),
      event_(insert("run_events", "run_id, place, time_s, robot, name, detail")),
      trajectory_(insert("trajectories", "run_id, robot, from_s, period_s, poses, touches")),
      curve_(insert("curves", "run_id, robot, plugin, name, x_label, y_label, points")),
      timeline_(insert("timelines", "run_id, robot, behaviors, episodes")),
      note_(insert("notes", "run_id, place, robot, plugin, text")) {}

sqlite::Statement RunWriter::insert(const std::string& table, const std::string& columns) {
  return sqlite::Statement::insert(connection_, table, columns);
}

bool RunWriter::write(std::int64_t run, const RunRecord& record) {
  sqlite::Transaction transaction(connection_);
  if (!update(run, record)) {
    return false;
  }
  write_measures(run, record);
  for (const simulation::RobotResult& robot : record.robots) {
    robot_.run(run, robot.id, robot.team, robot.distance_m, robot.collected, robot.energy,
               robot.collisions, robot.pose.x, robot.pose.y, robot.pose.heading_rad);
  }
  write_events(run, record);
  for (const Trajectory& each : record.trajectories) {
    trajectory_.run(run, each.robot, each.from_s, each.period_s, each.poses, each.touches);
  }
  for (const Curve& curve : record.curves) {
    curve_.run(run, curve.robot, curve.plugin, curve.name, curve.x_label, curve.y_label,
               curve.points);
  }
  for (const Timeline& timeline : record.timelines) {
    timeline_.run(run, timeline.robot, timeline.behaviors, timeline.episodes);
  }
  transaction.commit();
  return true;
}

bool RunWriter::update(std::int64_t run, const RunRecord& record) {
  const int next = results::bind_fields(run_, 1, record);
  run_.bind(next, utc_now()).bind(next + 1, run).run();
  return connection_.changes() == 1;
}

void RunWriter::write_measures(std::int64_t run, const RunRecord& record) {
  for (const Measure& measure : record.measures) {
    measure_.run(measure.name, measure.unit, measure.meaning);
    run_measure_.run(run, measure.name, measure.value);
  }
}

void RunWriter::write_events(std::int64_t run, const RunRecord& record) {
  std::int64_t place = 0;
  for (const Event& event : record.events) {
    event_.run(run, place++, event.time_s, event.robot, event.name, event.detail);
  }
  place = 0;
  for (const simulation::Note& note : record.notes) {
    note_.run(run, place++, note.robot, note.plugin, note.text);
  }
}

}  // namespace elsie::batch
