// A run that people watch while it happens, over the live protocol of Foxglove: a server on the
// loopback publishes the messages that a recording would have, and viewers pause the run, set its
// speed and go to other times. docs/live.md is the page about it.
//
//   LiveRun live(address, options);            // listens from here on
//   live.open(simulation, {make_again, edits});
//   simulation.run({&live});
//   live.linger(simulation);                   // until the user ends the program
//
// The run is the same with and without it, bit for bit: pausing only holds it between two steps. To
// go back, a second simulation of the same world, seed and edits is made and run to that time,
// while the first stands still; both continue as one where the second reaches the first. A recorder
// of the first therefore records one run, whatever its viewers do.
//
// The server has a thread of its own. Messages of channels without subscriptions are not made.
// Those for a client that reads too slowly make room for newer ones, so that the run never waits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "elsie/live/address.h"
#include "elsie/simulation/edit.h"
#include "elsie/simulation/observer.h"

namespace elsie::live {

struct Options {
  /// Simulated seconds per second on the clock, at first.
  double speed = 1.0;
  /// Origins whose pages may connect, besides those of this machine and of Foxglove.
  std::vector<std::string> origins{};
  /// Ids of the robots with channels of their own; see recording::RecorderOptions.
  std::vector<std::string> robots{};
  bool with_times = false;  // likewise
  std::string program = "elsie";
  /// Whether the user wants the program to end.
  std::function<bool()> is_interrupted = [] { return false; };
  /// Called with a sentence about what viewers lack.
  std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// How to make the run again.
struct Again {
  /// The simulation at its start; empty: it cannot be made again, for the reason.
  std::function<std::unique_ptr<simulation::Simulation>()> make{};
  std::vector<simulation::TimedEdit> edits{};  // those given to Simulation::run()
  std::string reason{};
};

struct Counts {
  std::uint64_t clients = 0;   // that have connected so far
  std::uint64_t messages = 0;  // sent to them, or waiting
  std::uint64_t dropped = 0;   // that made room for newer ones
};

class LiveRun final : public simulation::Observer {
 public:
  /// Throws base::BadInput when nothing can listen there. Clients are let in by open().
  LiveRun(const Address& address, Options options);
  ~LiveRun() override;

  /// The address with the port that is used.
  const Address& address() const;
  void open(const simulation::Simulation& simulation, Again again);

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

  /// After the run: shows it until Options::is_interrupted().
  void linger(const simulation::Simulation& simulation);

  Counts counts() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::live
