// The parts of `elsie train`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "environment.h"
#include "learner.h"

namespace elsie::program {

// Of a training from rewards, if no option says otherwise.
inline constexpr int kEpisodes = 200;
inline constexpr double kExplore = 0.3;

struct TrainOptions {
  PluginOptions plugins;
  std::string world;
  bool from_input = false;  // the text of the world
  LearnerPlace place;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> edits;
  std::map<std::string, std::string> parameters;  // of a network, that replace the coordinator's
  std::optional<std::string> weights;
  std::optional<std::string> values;
  std::optional<int> episodes;
  std::optional<double> explore;
  std::optional<std::string> curve;
  bool json = false;
  bool progress = false;  // as lines of JSON
  bool quiet = false;
};

/// The world of a training, which is read more than once.
class TrainingWorld {
 public:
  /// Reads standard input, if the text is there. The options must outlive this object.
  explicit TrainingWorld(const TrainOptions& options);

  /// As it stands, but a file of what the coordinator has learned may be missing: the training is
  /// about to write it. To be called first. Throws world::WorldError.
  world::World described(const plugin::Host& host, std::uint64_t seed);
  /// With these edits after those of the user. `found` gets the files that the world names. Throws
  /// world::WorldError.
  world::World read(const plugin::Host& host, std::uint64_t seed,
                    const std::vector<std::string>& edits = {},
                    std::map<std::string, std::string>* found = nullptr) const;

 private:
  const TrainOptions& options_;
  std::string text_;
  std::vector<std::string> removal_;  // of the name of a missing file
};

/// How far a training is shown while it goes on.
enum class Shown { nothing, bar, lines };  // lines of JSON, for a program
Shown shown(const TrainOptions& options);

// Each trains, prints, writes the files, and returns the exit code. `described`: the world without
// further edits.
int train_network(const TrainOptions& options, const TrainingWorld& world,
                  const world::World& described, const plugin::Host& host);
int train_from_rewards(const TrainOptions& options, const TrainingWorld& world,
                       const world::World& described, const plugin::Host& host);

}  // namespace elsie::program
