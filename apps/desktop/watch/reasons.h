// Why robots stand still and runs fail, in words.
#pragma once

#include <QStringList>

#include "engine/json.h"

namespace elsie::desktop {

/// A sentence about one robot of a message's `stuck`: "r1 has been stuck for 12 s: avoid_obstacle
/// and find_resource cancel each other".
QString why_stuck(const Json& robot, double now_s);

/// Whether it is asked to move, and does not get on.
bool is_trouble(const Json& robot);

/// Why the run that ended has not succeeded: its reason, what is missing of its goals, and who
/// stood still. Empty after a success.
QStringList why_failed(const Json& end);

/// The outcome as a heading: "Time is up after 60 s".
QString outcome_words(const Json& end);

}  // namespace elsie::desktop
