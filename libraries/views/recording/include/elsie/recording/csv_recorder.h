// Recording a run as a table.
#pragma once

#include <filesystem>
#include <memory>

#include "elsie/recording/formats.h"
#include "elsie/simulation/observer.h"

namespace elsie::recording {

/// Writes one row per robot and sample, comma-separated, with a heading line. Columns:
///
/// - time_s, robot, x_m, y_m, heading_rad, distance_m, energy;
/// - forward_m_s, lateral_m_s, turn_rad_s: the measured motion; with asked_ in front, the
///   motion that the coordinator asked for; with command_ in front, what the drive can make of it;
/// - believed_x_m, believed_y_m, believed_heading_rad: where the robot takes itself to be; only in
///   worlds that have a <localisation> at the start, and empty for robots without one;
/// - sensor[ID].VALUE for each number of each sensor's reading, actuator[ID].VALUE likewise of the
///   command that an actuator carries out;
/// - talk.sent, talk.heard: messages so far; only of robots with an actuator that hears messages;
/// - behavior[ID].asked, .forward_m_s, .lateral_m_s, .turn_rad_s, .activation, .strength, .weight,
///   .share, .inhibited_by, .reason (and .time_s when time is measured): the coordinator's trace of
///   its last decision;
/// - PATH.NAME for each number that a plugin of a robot or a measure publishes, as in
///   simulation::PublishedValue; empty where there is none now.
///
/// Poses are those at time_s; readings, commands and traces are those of the decision that led
/// there, and empty in the first row, before any decision. Columns for what a robot does not have
/// stay empty. When plugins are replaced, numbers that sensors did not have at the start get no
/// columns. Numbers are written so that they read back the same, bit for bit. The file is written
/// during the run: after a plugin has failed, it is valid. A recorder serves one run.
///
/// Creates the file at once. Throws std::runtime_error with a sentence when it cannot, or for a
/// rate that is not positive; the recorder throws one when the file could not be written to its end
/// (a full disk).
std::unique_ptr<simulation::Observer> csv_recorder(const std::filesystem::path& file,
                                                   const RecorderOptions& options);

/// Its entry in the table of formats.
Format csv_format();

}  // namespace elsie::recording
