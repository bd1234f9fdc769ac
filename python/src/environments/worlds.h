// Several worlds that learn at once: the episodes of an environment, stepped in threads, with what
// they observe, act and earn in arrays.
//
// Nothing here knows Python: step() is called without its lock. Worlds share what was loaded and
// nothing that changes, so that each is the same in any company and any number of threads, bit for
// bit. Long steps are made in turns, between which the caller may look for signals.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/image.h"
#include "elsie/base/thread_pool.h"
#include "elsie/plugin/host.h"

#include "declared.h"
#include "episode.h"

namespace elsie::python {

/// When a world whose episode has ended begins the next one: in the next step, whose action is
/// ignored; in the same step; in begin().
enum class Renewal { next_step, same_step, on_reset };

class Worlds {
 public:
  /// Functions of the caller.
  struct Calls {
    /// Is called before begin() or step() works, in the thread that called it.
    std::function<void()> start;
    /// Is called between turns, in the thread that called begin() or step(). What it throws
    /// interrupts all worlds that are at work, which must begin again.
    std::function<void()> look;
    /// Is called in a thread that helps before it works; what it returns lives until that is done.
    std::function<std::shared_ptr<void>()> help;
  };

  /// Begins the first of them, to learn what there is to observe and to do. Throws base::BadInput,
  /// and what the world's making throws.
  Worlds(Declared declared, MakeWorld make, std::shared_ptr<const plugin::Host> host,
         std::size_t count, std::size_t threads, Calls calls);

  std::size_t size() const { return episodes_.size(); }
  /// With the numbers of each robot: the same in all worlds.
  const Declared& declared() const { return declared_; }
  /// Numbers of all robots of a world.
  std::size_t observations_size() const { return observations_size_; }
  std::size_t actions_size() const { return actions_size_; }

  /// Begins episodes: of the worlds in `chosen`, with these seeds, or else the next of each world.
  void begin(const std::vector<std::size_t>& chosen, std::span<const std::uint64_t> seeds);
  /// Makes a step of each world. `actions`: a row of actions_size() numbers for each. Throws
  /// base::BadInput for another size or a number that is not finite, before anything is done. The
  /// fault of the first world counts; its sentence names the world if there are several.
  void step(std::span<const float> actions, Renewal renewal);

  // After begin() and step(), a row or a number for each world.
  const std::vector<float>& observations() const { return observations_; }
  /// With Renewal::same_step: the last of an episode that has ended in this step.
  const std::vector<float>& last_observations() const { return last_observations_; }
  const std::vector<double>& rewards() const { return rewards_; }  // of each robot
  const std::vector<char>& ended() const { return ended_; }        // of each robot
  const std::vector<char>& terminated() const { return terminated_; }
  const std::vector<char>& truncated() const { return truncated_; }
  /// Whether an episode began in this step.
  const std::vector<char>& begun() const { return begun_; }

  /// Calls `look` with an episode, between two steps. Throws base::BadInput before its first
  /// begin(), and while another thread is at work.
  template <class Look>
  auto look_at(std::size_t world, const Look& look) const {
    const Work work(at_work_);
    return look(begun_episode(world));
  }
  /// How the last episode ended, in words of results.
  std::string outcome(std::size_t world) const {
    const Work work(at_work_);
    return outcomes_[world];
  }
  std::optional<double> save(std::size_t world, const std::filesystem::path& file);
  /// The world from above, north at its top.
  Image picture(std::size_t world, int width) const;

 private:
  struct Seeds {
    std::uint64_t first = 1;
    std::uint64_t episode = 0;
    std::uint64_t next() const;
  };

  /// One thread at a time: the others get base::BadInput.
  class Work {
   public:
    explicit Work(std::atomic_flag& at_work);
    ~Work() { at_work_.clear(std::memory_order_release); }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

   private:
    std::atomic_flag& at_work_;
  };

  const Episode& begun_episode(std::size_t world) const;
  template <class What>
  void each(const std::vector<std::size_t>& chosen, const What& what);
  void begin(std::size_t world);
  void take_results(std::size_t world);

  Declared declared_;
  MakeWorld make_;
  std::shared_ptr<const plugin::Host> host_;
  std::vector<std::unique_ptr<Episode>> episodes_;
  std::vector<Seeds> seeds_;
  std::vector<std::string> outcomes_;
  std::size_t observations_size_ = 0, actions_size_ = 0;
  std::vector<float> observations_, last_observations_;
  std::vector<double> rewards_;
  std::vector<char> ended_, terminated_, truncated_, begun_;
  Calls calls_;
  base::ThreadPool pool_;
  std::vector<std::size_t> all_;
  std::vector<char> is_done_;  // with the present work, for each world
  std::vector<std::exception_ptr> failures_;
  mutable std::atomic_flag at_work_;
};

}  // namespace elsie::python
