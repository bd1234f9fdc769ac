#include "worlds.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/random.h"
#include "elsie/picture/top_view.h"
#include "elsie/recording/run_picture.h"
#include "elsie/simulation/edit.h"
#include "elsie/simulation/fault.h"

namespace elsie::python {
namespace {

constexpr std::uint64_t kNotBegun = static_cast<std::uint64_t>(-1);  // as number of an episode

/// A fault of one of several worlds, with its number.
template <class Fault>
class OfWorld : public Fault {
 public:
  OfWorld(const Fault& fault, std::size_t world)
      : Fault(fault), sentence_("world " + std::to_string(world) + ": " + fault.what()) {}
  const char* what() const noexcept override { return sentence_.c_str(); }

 private:
  std::string sentence_;
};

[[noreturn]] void rethrow(const std::exception_ptr& failure, std::size_t world) {
  try {
    std::rethrow_exception(failure);
  } catch (const simulation::PluginFault& fault) {
    throw OfWorld(fault, world);
  } catch (const simulation::PhysicsFault& fault) {
    throw OfWorld(fault, world);
  } catch (const simulation::EditRefused& refused) {
    throw OfWorld(refused, world);
  } catch (const base::BadInput& error) {
    throw OfWorld(error, world);
  }
}

}  // namespace

Worlds::Work::Work(std::atomic_flag& at_work) : at_work_(at_work) {
  if (at_work_.test_and_set(std::memory_order_acquire)) {
    throw base::BadInput("This environment is at work in another thread; give each thread its own");
  }
}

/// The first episode has the seed that was given; the others follow from it.
std::uint64_t Worlds::Seeds::next() const {
  if (episode == 0) return first;
  return Random(first, "episode " + std::to_string(episode)).bits() >> 32;
}

Worlds::Worlds(Declared declared, MakeWorld make, std::shared_ptr<const plugin::Host> host,
               std::size_t count, std::size_t threads, Calls calls)
    : declared_(std::move(declared)),
      make_(std::move(make)),
      host_(std::move(host)),
      seeds_(count),
      outcomes_(count),
      calls_(std::move(calls)),
      pool_(std::min(threads, count)),
      all_(count),
      is_done_(count),
      failures_(count) {
  std::iota(all_.begin(), all_.end(), 0);
  episodes_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    episodes_.push_back(std::make_unique<Episode>(declared_, make_, *host_));
  }
  episodes_.front()->begin(1);
  std::vector<std::vector<Bounded>> observed, acted;
  for (const Observing& eyes : episodes_.front()->eyes()) {
    observed.push_back(eyes.numbers());
    observations_size_ += eyes.numbers().size();
  }
  for (const Acting& hands : episodes_.front()->hands()) {
    acted.push_back(hands.numbers());
    actions_size_ += hands.numbers().size();
  }
  declared_.observed = std::move(observed);
  declared_.acted = std::move(acted);
  const std::size_t robots = declared_.robots.size();
  observations_.resize(count * observations_size_);
  last_observations_.resize(count * observations_size_);
  rewards_.resize(count * robots);
  ended_.resize(count * robots);
  terminated_.resize(count);
  truncated_.resize(count);
  begun_.resize(count);
  for (std::size_t i = 0; i < count; ++i) seeds_[i] = {i + 1, kNotBegun};
}

/// Does this for the chosen worlds, in threads, and throws the failure of the first. `what` returns
/// whether it is done with a world; if not, because its turn was over, it is called again.
template <class What>
void Worlds::each(const std::vector<std::size_t>& chosen, const What& what) {
  calls_.start();
  for (const std::size_t world : chosen) is_done_[world] = false;
  const auto make_turn = [&](const Turn& turn) {
    pool_.divide(chosen.size(), 1, [&](const base::ThreadPool::Share& share) {
      const std::shared_ptr<void> helping = share.thread == 0 ? nullptr : calls_.help();
      for (std::size_t i = share.first; i < share.end; ++i) {
        const std::size_t world = chosen[i];
        if (is_done_[world] || turn.has_ended()) continue;
        try {
          is_done_[world] = what(world, turn);
        } catch (...) {
          is_done_[world] = true;
          failures_[world] = std::current_exception();
        }
      }
    });
    return std::all_of(chosen.begin(), chosen.end(),
                       [&](std::size_t world) { return is_done_[world] != 0; });
  };
  while (!make_turn(Turn())) {
    try {
      calls_.look();
    } catch (...) {
      for (const std::size_t world : chosen) {
        failures_[world] = nullptr;
        episodes_[world]->interrupt();
      }
      throw;
    }
  }
  std::exception_ptr first;
  std::size_t failed = 0;
  for (const std::size_t world : chosen) {
    std::exception_ptr failure = std::exchange(failures_[world], nullptr);
    if (!failure || first) continue;
    first = std::move(failure);
    failed = world;
  }
  if (!first) return;
  if (size() == 1) std::rethrow_exception(first);
  rethrow(first, failed);
}

void Worlds::begin(std::size_t world) {
  Seeds& seeds = seeds_[world];
  ++seeds.episode;
  Episode& episode = *episodes_[world];
  episode.begin(seeds.next());
  begun_[world] = true;
  take_results(world);
}

void Worlds::take_results(std::size_t world) {
  const Episode& episode = *episodes_[world];
  const std::size_t robots = declared_.robots.size();
  episode.observe(observations_.data() + world * observations_size_);
  for (std::size_t i = 0; i < robots; ++i) {
    rewards_[world * robots + i] = episode.rewards()[i];
    ended_[world * robots + i] = episode.has_ended(i);
  }
  terminated_[world] = episode.terminated();
  truncated_[world] = episode.truncated();
}

void Worlds::begin(const std::vector<std::size_t>& chosen, std::span<const std::uint64_t> seeds) {
  const Work work(at_work_);
  std::vector<std::size_t> sorted = chosen;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() ||
      (!sorted.empty() && sorted.back() >= size()) ||
      (!seeds.empty() && seeds.size() != chosen.size())) {
    throw base::BadInput("expected worlds of this environment, each once, with a seed for each");
  }
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    seeds_[chosen[i]] = {seeds[i], kNotBegun};
  }
  each(chosen, [&](std::size_t world, const Turn&) {
    begin(world);
    return true;
  });
}

const Episode& Worlds::begun_episode(std::size_t world) const {
  if (seeds_[world].episode == kNotBegun) {
    throw base::BadInput("The environment has not begun: call reset() first");
  }
  return *episodes_[world];
}

void Worlds::step(std::span<const float> actions, Renewal renewal) {
  const Work work(at_work_);
  for (const std::size_t world : all_) {
    try {
      begun_episode(world).require_sound();
    } catch (const base::BadInput& error) {
      if (size() == 1 || seeds_[world].episode == kNotBegun) throw;
      throw OfWorld(error, world);
    }
  }
  if (actions.size() != size() * actions_size_) {
    throw base::BadInput("There are " + std::to_string(actions.size()) +
                         " numbers of actions; expected " + std::to_string(size() * actions_size_));
  }
  float sum = 0.0f;
  for (const float action : actions) sum += action - action;  // NaN if one is not finite
  if (!(sum == 0.0f)) {
    throw base::BadInput("An action has a number that is not finite; expected numbers in [-1, 1]");
  }
  const std::size_t robots = declared_.robots.size();
  each(all_, [&](std::size_t world, const Turn& turn) {
    Episode& episode = *episodes_[world];
    if (!episode.is_stepping()) {
      begun_[world] = false;
      if (renewal == Renewal::next_step && episode.has_ended()) {
        begin(world);
        return true;
      }
      episode.begin_step(actions.data() + world * actions_size_);
    }
    if (!episode.finish_step(turn)) return false;
    take_results(world);
    if (!episode.has_ended()) return true;
    outcomes_[world] = to_string(episode.simulation().outcome());
    if (renewal != Renewal::same_step) return true;
    const auto from =
        observations_.begin() + static_cast<std::ptrdiff_t>(world * observations_size_);
    std::copy(from, from + static_cast<std::ptrdiff_t>(observations_size_),
              last_observations_.begin() + (from - observations_.begin()));
    const std::vector<double> rewards = episode.rewards();
    const bool terminated = episode.terminated(), truncated = episode.truncated();
    begin(world);
    std::copy(rewards.begin(), rewards.end(),
              rewards_.begin() + static_cast<std::ptrdiff_t>(world * robots));
    terminated_[world] = terminated;
    truncated_[world] = truncated;
    return true;
  });
}

std::optional<double> Worlds::save(std::size_t world, const std::filesystem::path& file) {
  const Work work(at_work_);
  return begun_episode(world).save(file);
}

Image Worlds::picture(std::size_t world, int width) const {
  const Work work(at_work_);
  const simulation::Simulation& simulation = begun_episode(world).simulation();
  picture::TopView view = recording::view_of(simulation, nullptr, [](const std::string&) {});
  view.bare = true;
  return picture::top_view_image(view, {.width = width});
}

}  // namespace elsie::python
