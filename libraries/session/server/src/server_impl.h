// The parts of a session: server.cpp has its orders, editing.cpp the document, running.cpp the run,
// reporting.cpp the messages and snapshots to the window, renewing.cpp changes of plugins.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
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
#include "elsie/traces/standstill.h"

#include "link.h"
#include "marks.h"
#include "past.h"
#include "recording.h"
#include "repetition.h"
#include "watching.h"

namespace elsie::server {

using Clock = std::chrono::steady_clock;
using simulation::Simulation;

inline constexpr std::chrono::microseconds kLongestWait{200'000};  // between checks of plugins

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

  /// Carries out an order. The answer has the message's id, and either the result or `refused`
  /// (sentences). It follows after the step for `step`, and after the end of the run for `reset`.
  void handle(const Json& message);
  /// Answers a line that is no order.
  void refuse_line();
  void open(const Json& message, Json& answer);
  void edit(const Json& message, Json& answer);
  void become(const Json& message, Json& answer);
  void text_for(const Json& message, Json& answer);
  void move(const Json& message, Json& answer);
  void catalog(const Json& message, Json& answer);
  void ping(const Json& message, Json& answer);
  void start(const Json& message, Json& answer);
  void pause(const Json& message, Json& answer);
  void step(const Json& message, Json& answer);
  void set_speed(const Json& message, Json& answer);
  void reset(const Json& message, Json& answer);
  void watch(const Json& message, Json& answer);
  void look_back(const Json& message, Json& answer);
  void paths(const Json& message, Json& answer);
  void numbers(const Json& message, Json& answer);
  void record(const Json& message, Json& answer);
  void draw(const Json& message, Json& answer);
  void add_plugin(const Json& message, Json& answer);
  void command(const Json& message, Json& answer);

  // The document.

  const plugin::Host& host() const { return plugins_.host(); }
  world::ReadOptions reading(std::uint64_t seed) const;
  /// Changes the document. A run that is under way is changed by the same `edits` or, if it cannot
  /// make them or there are none, by those that lead to the document's new world.
  void change(const std::function<void()>& make, const std::vector<std::string>& edits,
              Json& answer);
  /// The document's world, with file names relative to the folder where the run began; none: the
  /// document has not moved to another folder since then.
  std::optional<world::World> world_of_run() const;
  /// Adapts a text that was written for another file to the folder of the document's file.
  std::string from_elsewhere(const std::string& text, const std::string& file) const;
  /// The same for any folder.
  std::string adapted(const std::string& text, const std::string& file,
                      const std::filesystem::path& folder) const;
  /// `edits_there`: with names of files as the run has them; `edits`: as the document has them.
  void change_run(const std::vector<std::string>& edits_there,
                  const std::vector<std::string>& edits);
  void describe(Json& answer);

  // The run.

  std::unique_ptr<Simulation> simulation_of(const world::World& world, std::uint64_t seed,
                                            const plugin::Host& host) const;
  void restart(std::uint64_t seed);
  /// Throws BadInput if the run has ended.
  void require_unended() const;
  /// Prepares for a run that starts or continues.
  void get_ready();
  /// The files that the document's world is read from.
  std::vector<std::filesystem::path> inputs() const;
  /// Begins a new run. A run that is under way is ended first.
  void begin(std::unique_ptr<Simulation> simulation);
  void take_next();
  void run();
  /// Reads messages; does not return while the run is paused.
  void between_decisions();
  /// Pauses the run: sends a snapshot, and the answers to unfinished steps.
  void hold();
  void answer_later();
  void hear();
  void start_clock();

  // Messages and snapshots to the window.

  void show();
  /// Answers an order for the past: while the run advances, just before the next snapshot, so that
  /// a window has the past up to what it shows.
  void tell_past(Past::Request request, Json& answer);
  void answer_past();
  void report_state();
  void report_state_if_due();
  /// Says that a run to a time has reached it.
  void report_pause();
  /// Sends new events and notes of the run.
  void report_news();
  void report_note(const simulation::Note& note);
  /// Says which robots stand still, when others do than before.
  void report_stuck();

  /// Loads plugins that have changed on disk, as `elsie run --watch` does.
  void renew_plugins();
  /// Makes the document and its run use the plugins of this host; on failure, nothing changes.
  void use(const plugin::Host& host, Json& event);

  build::Watch& plugins_;
  ServerOptions options_;
  snapshots::SharedMemory memory_;
  snapshots::Writer writer_;
  Link link_;

  std::optional<editing::Document> document_;

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Simulation>
      next_;  // replaces simulation_ after the end of the run that is under way
  Phase phase_ = Phase::ready;
  bool left_ = false;
  bool running_ = false;
  bool answers_later_ = false;             // to the current order, after its steps
  bool answers_with_snapshot_ = false;     // to the current order, with the next snapshot
  std::optional<std::uint64_t> pause_at_;  // steps
  bool is_pause_paced_ = false;            // until then the run keeps its speed; else full speed
  bool is_pause_told_ = false;             // an event will report the pause
  bool is_pause_due_ = false;              // after the answer to the current order
  std::vector<Json> later_;                // answers to be sent later
  std::vector<std::pair<Past::Request, Json>> with_next_snapshot_;  // and with the next snapshot
  std::uint64_t seed_ = 1;
  std::uint64_t epoch_ = 0;

  Watching watching_;
  bool is_state_due_ = false;  // the shown state has changed while nothing runs
  std::size_t told_events_ = 0, told_notes_ = 0;
  traces::StandstillWatch standstills_;
  std::vector<traces::Standstill> told_standstills_;
  Past past_{watching_};
  Recording recording_;
  Repetition repetition_;
  std::string run_file_;  // the document's when the run began

  double speed_ = 0.0;  // simulated seconds per second; 0: as fast as possible
  Clock::time_point paced_from_;
  double paced_from_s_ = 0.0;
  Clock::time_point heard_, shown_, stated_;
  double shown_s_ = 0.0;
  std::vector<snapshots::BodyState> bodies_;
  Marks marks_;
};

}  // namespace elsie::server
