// A run of which only a little is known, as a database of results has it: where its robots were
// from time to time, what happened, and who decided.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/page/viewer.h"
#include "elsie/plugin/host.h"
#include "elsie/recording/recorded_run.h"

namespace elsie::page {

struct StoredRobot {
  struct Episode {
    double from_s = 0.0;
    double to_s = 0.0;
    std::string decider;  // path of a behaviour; "": nobody; "*": several
    std::vector<std::pair<std::string, double>> parts{};  // of several: the time of each, s
  };

  std::string id;
  double from_s = 0.0;    // time of the first pose
  double period_s = 0.0;  // between two poses
  std::vector<Pose> poses;
  bool has_end = false;  // the last pose is that at StoredRun::end_s, whatever the period
  std::vector<std::string> behaviors{};  // paths
  std::vector<Episode> episodes{};       // ascending in time
};

struct StoredRun {
  std::string title;      // empty: the world's name
  std::string world_xml;  // at the start
  std::string world_file;
  std::string library;  // the program that did the run
  std::uint64_t seed = 0;
  double end_s = 0.0;  // 0: unknown
  recording::RecordedResult result;
  std::vector<std::pair<std::string, std::string>> facts;  // more terms about it
  std::vector<StoredRobot> robots;
  std::vector<recording::RecordedEvent> events;  // ascending in time
};

/// Returns whether a pose of the robot can be shown.
bool has_poses(const StoredRobot& robot);

/// The run for the viewer, in at most PageOptions::most_bytes, if it can be helped. Between two
/// poses robots drive straight. What a robot holds moves with it; other boxes stand where they
/// began, and the run says so. The same run gives the same bytes.
///
/// Throws world::WorldError when the world cannot be read; std::invalid_argument if no robot
/// has_poses().
PageRun page_run(const StoredRun& run, const plugin::Host& drives, const PageOptions& options = {});

}  // namespace elsie::page
