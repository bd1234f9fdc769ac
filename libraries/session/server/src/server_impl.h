// What a session is made of. server.cpp has its orders, editing.cpp the document, running.cpp the
// run, reporting.cpp what the window hears and sees of it, renewing.cpp plugins that change.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/build/watch.h"
#include "elsie/editing/document.h"
#include "elsie/server/server.h"
#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"

#include "history.h"
#include "link.h"
#include "recording.h"
#include "repetition.h"
#include "watching.h"

namespace elsie::server {

using Clock = std::chrono::steady_clock;
using simulation::Simulation;

inline constexpr std::chrono::microseconds kLongestWait{200'000};  // then plugins are looked at

inline double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

class Server::Impl {
 public:
  Impl(build::Watch& plugins, ServerOptions options)
      : plugins_(plugins),
        options_(std::move(options)),
        memory_(snapshots::SharedMemory::open(kMemory)),
        writer_(memory_),
        link_(kMessages) {}

  void serve();

 private:
  enum class Phase { ready, under_way, ended };

  // Orders.

  using Order = void (Impl::*)(const Json& message, Json& answer);
  struct KnownOrder {
    Order perform;
    bool needs_world = true;
  };
  static const std::map<std::string, KnownOrder>& orders();

  /// Its answer has the message's id, and either what was asked for or `refused`: sentences. That
  /// to a step comes when the step is done, that to a reset when the run has been left.
  void handle(const Json& message);
  void open(const Json& message, Json& answer);
  void edit(const Json& message, Json& answer);
  void become(const Json& message, Json& answer);
  void undo(const Json& message, Json& answer);
  void text_for(const Json& message, Json& answer);
  void move(const Json& message, Json& answer);
  void check(const Json& message, Json& answer);
  void catalog(const Json& message, Json& answer);
  void ping(const Json& message, Json& answer);
  void start(const Json& message, Json& answer);
  void pause(const Json& message, Json& answer);
  void step(const Json& message, Json& answer);
  void set_speed(const Json& message, Json& answer);
  void reset(const Json& message, Json& answer);
  void watch(const Json& message, Json& answer);
  void look_back(const Json& message, Json& answer);
  void record(const Json& message, Json& answer);
  void command(const Json& message, Json& answer);

  // The document.

  const plugin::Host& host() const { return plugins_.host(); }
  world::ReadOptions reading(std::uint64_t seed) const;
  /// Changes the document; `make` returns the inverse. A run that is under way becomes what the
  /// document is then, by `edits` or, if there are none, those that lead there.
  void change(const std::function<editing::Edits()>& make, std::vector<std::string> edits,
              Json& answer);
  std::vector<std::string> edits_from(const world::World& before) const;
  /// A text that was written for another file, as it has to be in the document's.
  std::string from_elsewhere(const std::string& text, const std::string& file) const;
  void change_run(std::vector<std::string> edits);
  void describe(Json& answer);

  // The run.

  std::unique_ptr<Simulation> simulation_of(const world::World& world, std::uint64_t seed,
                                            const plugin::Host& host) const;
  void restart(std::uint64_t seed);
  /// For a run that starts or goes on.
  void get_ready();
  /// A run from the beginning. One that is under way is left first.
  void begin(std::unique_ptr<Simulation> simulation);
  void take_next();
  void run();
  /// Messages are heard here; while the run is paused, it stays here.
  void between_decisions();
  /// Shows where everything is, and ends steps that are not done.
  void hold();
  void answer_later();
  void hear();
  void start_clock();

  // What the window sees and hears.

  void show();
  /// Keeps where everything is for the history.
  void keep();
  void report_state();
  /// Events and notes of the run, as they arise.
  void report_news();

  /// Takes plugins that have changed on disk, as `elsie run --watch` does.
  void renew_plugins();
  /// The document and its run have the plugins of this host from now on, or nothing changes.
  void use(const plugin::Host& host, Json& event);

  build::Watch& plugins_;
  ServerOptions options_;
  snapshots::SharedMemory memory_;
  snapshots::Writer writer_;
  Link link_;

  std::optional<editing::Document> document_;
  std::map<std::uint64_t, editing::Edits> inverses_;
  std::uint64_t last_inverse_ = 0;

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Simulation>
      next_;  // takes its place once the run that is under way has been left
  Phase phase_ = Phase::ready;
  bool left_ = false;
  bool running_ = false;
  bool answers_later_ = false;             // to the order at hand
  std::optional<std::uint64_t> pause_at_;  // steps; until there it goes as fast as it can
  bool is_pause_told_ = false;             // by an event
  std::vector<Json> later_;                // answers that come later
  std::uint64_t seed_ = 1;
  std::uint64_t epoch_ = 0;

  Watching watching_;
  bool is_state_due_ = false;  // what is shown has changed while nothing runs
  std::size_t told_events_ = 0, told_notes_ = 0;
  History history_;
  Recording recording_;
  Repetition repetition_;

  double speed_ = 0.0;  // 0: as fast as it goes
  Clock::time_point paced_from_;
  double paced_from_s_ = 0.0;
  Clock::time_point heard_, shown_, stated_;
  double shown_s_ = 0.0;
  std::vector<snapshots::BodyState> bodies_;
  std::vector<snapshots::BeamState> beams_;
};

}  // namespace elsie::server
