#include "live_view.h"

#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "command.h"
#include "interrupts.h"
#include "streams.h"

namespace elsie::program {
namespace {

live::Options live_options(const ViewOptions& options) {
  constexpr std::string_view kAfterScheme = "://";
  for (const std::string& origin : options.live_origins) {
    const std::size_t scheme = origin.find(kAfterScheme);
    if (scheme == origin.npos || origin.find('/', scheme + kAfterScheme.size()) != origin.npos) {
      throw BadInput("--live-origin " + origin +
                     ": expected scheme and host of a page, without a path, as in "
                     "https://viewer.example.org");
    }
  }
  return {.speed = options.live_speed,
          .origins = options.live_origins,
          .robots = options.record.robots,
          .with_times = options.record.times,
          .program = "elsie " ELSIE_VERSION,
          .is_interrupted = InterruptGuard::is_interrupted,
          .warn = [](const std::string& text) { spdlog::warn(text); }};
}

}  // namespace

LiveView::LiveView(const ViewOptions& options)
    : asked_(live::address_of(*options.live, "--live")),
      quiet_(options.quiet),
      run_(asked_, live_options(options)) {}

LiveView::~LiveView() {
  const live::Counts counts = run_.counts();
  if (quiet_ || counts.clients == 0) return;
  err() << "elsie: live: " << counts.clients << (counts.clients == 1 ? " client, " : " clients, ")
        << counts.messages << " messages, of which " << counts.dropped
        << " were left out because a client was too slow\n";
}

simulation::Observer& LiveView::open(const simulation::Simulation& simulation, RunAgain again) {
  run_.open(simulation, {std::move(again.make), std::move(again.edits),
                         "a run with --watch cannot go back: its plugins may have changed"});
  const std::string url = run_.address().url();
  if (!asked_.is_loopback()) {
    spdlog::warn("--live: everyone who reaches " + url + " can watch this run and hold it");
  }
  if (!quiet_ || asked_.port == 0) {  // nothing else says which port it is
    err() << "elsie: live at " << url << "  (Foxglove: Open connection > Foxglove WebSocket)\n";
  }
  return run_;
}

void LiveView::linger(const simulation::Simulation& simulation) {
  if (!quiet_) err() << "elsie: the run has ended; its live view stays until Ctrl-C\n";
  run_.linger(simulation);
}

}  // namespace elsie::program
