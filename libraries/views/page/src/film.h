// A run while it is read, and what a page has of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "elsie/page/viewer.h"
#include "elsie/plugin/host.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/world/description.h"

#include "layer.h"
#include "motion.h"

namespace elsie::page {

/// Everything that a run says, sample by sample.
class Film {
 public:
  explicit Film(const plugin::Host& drives) : drives_(drives) {}

  /// Throws world::WorldError when the run's world cannot be read.
  void add(const recording::RecordedRun& run);
  bool empty() const { return times_.empty(); }
  /// As the run began.
  const world::World& world() const { return first_world_; }

  /// Terms, and what they are; those without a text are left out.
  using Facts = std::vector<std::pair<std::string, std::string>>;

  /// What a page has of it, in at most so many bytes of data if that is possible. `whole`: the run
  /// at its end. `others`: what it says besides. `exactness`: of poses, in words.
  PageRun page_run(const recording::RecordedRun& whole, double end_s,
                   const std::vector<Layer*>& others, const std::string& exactness,
                   const Facts& more, std::size_t most_bytes);

 private:
  Sample now() const { return static_cast<Sample>(times_.size()); }
  std::array<SampledLayer*, 4> sampled() { return {&poses_, &lights_, &sketches_, &fields_}; }
  std::string scenes_text() const;

  const plugin::Host& drives_;
  std::string world_xml_;
  world::World world_, first_world_;
  Bodies bodies_;
  std::vector<std::int64_t> times_;
  Keys<std::string> scenes_;
  std::vector<std::string> images_;  // of floors, for all scenes
  Poses poses_;
  Lights lights_;
  Sketches sketches_;
  Fields fields_;
};

/// A text in HTML.
std::string escaped(std::string_view text);

}  // namespace elsie::page
