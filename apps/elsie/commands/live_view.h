// The live view of a run: --live.
#pragma once

#include "elsie/live/live_run.h"

#include "run_views.h"

namespace elsie::program {

class LiveView {
 public:
  /// Listens. Throws BadInput when that is not possible.
  explicit LiveView(const ViewOptions& options);
  /// Says how many messages were sent, and how many left out.
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  /// Lets viewers in, and says where. Returns the observer of the run.
  simulation::Observer& open(const simulation::Simulation& simulation, RunAgain again);
  void linger(const simulation::Simulation& simulation);

 private:
  live::Address asked_;
  bool quiet_;
  live::LiveRun run_;
};

}  // namespace elsie::program
