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
      run_measure_(connection,
                   "INSERT INTO run_measures (run_id, measure, value) VALUES (?, ?, ?)"),
      robot_(connection,
             "INSERT INTO run_robots (run_id, robot, team, distance_m, collected, energy, "
             "collisions, x_m, y_m, heading_rad) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      event_(connection,
             "INSERT INTO run_events (run_id, place, time_s, robot, name, detail) "
             "VALUES (?, ?, ?, ?, ?, ?)"),
      trajectory_(connection,
                  "INSERT INTO trajectories (run_id, robot, from_s, period_s, poses, touches) "
                  "VALUES (?, ?, ?, ?, ?, ?)"),
      curve_(connection,
             "INSERT INTO curves (run_id, robot, plugin, name, x_label, y_label, points) "
             "VALUES (?, ?, ?, ?, ?, ?, ?)"),
      timeline_(connection,
                "INSERT INTO timelines (run_id, robot, behaviors, episodes) VALUES (?, ?, ?, ?)"),
      note_(connection,
            "INSERT INTO notes (run_id, place, robot, plugin, text) VALUES (?, ?, ?, ?, ?)") {}

bool RunWriter::write(std::int64_t run, const RunRecord& record) {
  sqlite::Transaction transaction(connection_);
  if (!update(run, record)) {
    return false;
  }
  write_measures(run, record);
  for (const simulation::RobotResult& robot : record.robots) {
    robot_.bind(1, run)
        .bind(2, robot.id)
        .bind(3, robot.team)
        .bind(4, robot.distance_m)
        .bind(5, std::int64_t{robot.collected})
        .bind(6, robot.energy)
        .bind(7, std::int64_t{robot.collisions})
        .bind(8, robot.pose.x)
        .bind(9, robot.pose.y)
        .bind(10, robot.pose.heading_rad)
        .run();
  }
  write_events(run, record);
  for (const Trajectory& trajectory : record.trajectories) {
    trajectory_.bind(1, run)
        .bind(2, trajectory.robot)
        .bind(3, trajectory.from_s)
        .bind(4, trajectory.period_s)
        .bind(5, trajectory.poses)
        .bind(6, trajectory.touches)
        .run();
  }
  for (const Curve& curve : record.curves) {
    curve_.bind(1, run)
        .bind(2, curve.robot)
        .bind(3, curve.plugin)
        .bind(4, curve.name)
        .bind(5, curve.x_label)
        .bind(6, curve.y_label)
        .bind(7, curve.points)
        .run();
  }
  for (const Timeline& timeline : record.timelines) {
    timeline_.bind(1, run)
        .bind(2, timeline.robot)
        .bind(3, timeline.behaviors)
        .bind(4, timeline.episodes)
        .run();
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
    measure_.bind(1, measure.name).bind(2, measure.unit).bind(3, measure.meaning).run();
    run_measure_.bind(1, run).bind(2, measure.name).bind(3, measure.value).run();
  }
}

void RunWriter::write_events(std::int64_t run, const RunRecord& record) {
  std::int64_t place = 0;
  for (const Event& event : record.events) {
    event_.bind(1, run)
        .bind(2, place++)
        .bind(3, event.time_s)
        .bind(4, event.robot)
        .bind(5, event.name)
        .bind(6, event.detail)
        .run();
  }
  place = 0;
  for (const simulation::Note& note : record.notes) {
    note_.bind(1, run)
        .bind(2, place++)
        .bind(3, note.robot)
        .bind(4, note.plugin)
        .bind(5, note.text)
        .run();
  }
}

}  // namespace elsie::batch
