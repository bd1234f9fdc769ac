// The stored past of a run: the poses of all bodies and the numbers of all robots at regular
// simulated times, whatever a window shows, what it shows besides, and the orders that ask for
// them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/picture/top_view.h"
#include "elsie/simulation/observer.h"
#include "elsie/snapshots/snapshots.h"

#include "history.h"
#include "link.h"
#include "looks.h"
#include "numbers.h"
#include "watching.h"

namespace elsie::server {

class Past final : public simulation::Observer {
 public:
  /// The samples of the past that a window asks for.
  struct Request {
    bool of_numbers = false;          // otherwise the paths of robots
    std::vector<std::string> names;   // of the numbers
    std::vector<std::string> robots;  // none: all
    double after_s = -1.0;
    std::uint64_t layout = 0;  // the list of names that the window has
  };

  /// Measures, the values of fuzzy models, and all that is no number cost more than the rest: they
  /// are stored only while they are watched.
  explicit Past(const Watching& watching) : watching_(watching) {}

  /// Begins a new run, at time zero.
  void begin(const simulation::Simulation& simulation);
  /// Stores the present state as the last one of the run.
  void keep(const simulation::Simulation& simulation);
  /// The history of poses.
  const History& poses() const { return poses_; }
  /// Reads an order. Throws base::BadInput.
  static Request request_of(const Json& order, bool of_numbers);
  /// The notes about it since the last call.
  std::vector<simulation::Note> take_notes() { return numbers_.take_notes(); }
  /// Adds the paths of the robots to a picture of the present.
  void add_paths(picture::TopView& view) const;
  /// Adds the next samples to an answer, at most about a hundred thousand numbers.
  void tell(const Request& request, Json& answer) const;
  /// Adds what is stored of a time: the `numbers` of these robots, by name, and the `look`, if
  /// there is one.
  void tell_instant(double time_s, const std::vector<std::string>& robots, Json& answer) const;

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;

 private:
  /// An edit put a robot somewhere else, where it did not drive.
  struct Placed {
    std::string robot;
    double time_s = 0.0;
  };

  void keep_poses(const simulation::Simulation& simulation);
  void keep_numbers(const simulation::Simulation& simulation);
  void keep_look(const simulation::Simulation& simulation);
  void tell_paths(const Request& request, Json& answer) const;
  void tell_numbers(const Request& request, Json& answer) const;

  const Watching& watching_;
  History poses_;
  Numbers numbers_;
  Looks looks_;
  std::vector<Placed> placed_;  // ascending in time
  std::size_t events_ = 0;      // seen of the run
  std::vector<snapshots::BodyState> bodies_;
};

}  // namespace elsie::server
