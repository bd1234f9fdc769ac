// What a robot of an environment observes, as numbers of an array.
//
//   const Observing eyes(simulation, 0, {{"range.distance_m"}, {"pose"}, {"explore.clearance"}});
//   eyes.read(simulation, row);
//
// Names are looked up once; reading follows pointers, because it happens in every step of every
// world. It must be made again when an edit has made objects of the robot again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/reading.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

#include "declared.h"

namespace elsie::python {

class Observing {
 public:
  /// Throws base::BadInput with a sentence for a name that this robot does not have. Bounds of
  /// readings are complete after the first decision: a beam's range is part of its reading.
  Observing(const simulation::Simulation& simulation, const plugin::Host& host, std::size_t robot,
            const std::vector<Named>& names);

  const std::vector<Bounded>& numbers() const { return numbers_; }
  /// Replaces the bounds; there are as many.
  void take(const std::vector<Bounded>& numbers);
  /// Writes as many numbers as there are, within their bounds. What a list has no item for, or a
  /// plugin publishes no number for now, is 0.
  void read(const simulation::Simulation& simulation, float* to) const;

 private:
  /// A number that stays where it is.
  struct Stored {
    std::size_t place;  // in the observation
    const void* at;
    FieldType type;
  };
  /// The same for most of them.
  struct StoredReal {
    std::size_t place;
    const double* at;
  };
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  /// A sensor whose numbers move: lists. The places of its numbers, in the order of its visit.
  struct Visited {
    std::size_t sensor;
    std::vector<std::size_t> places;
  };

  bool add_readings(const simulation::Simulation& simulation, const plugin::Host& host,
                    const Named& named);
  bool add_own(const simulation::Simulation& simulation, const Named& named);
  bool add_published(const simulation::Simulation& simulation, const Named& named);
  std::size_t add(Bounded number, const Named& named);
  void keep(const Stored& stored);
  [[noreturn]] void refuse(const simulation::Simulation& simulation, const Named& named) const;

  std::size_t robot_;
  std::vector<Bounded> numbers_;
  std::vector<float> low_, high_;
  std::vector<StoredReal> reals_;
  std::vector<Stored> stored_;  // of other types
  std::vector<Visited> visited_;
  std::vector<std::size_t> published_;        // the places of the robot's published numbers
  std::vector<std::size_t> published_there_;  // of those of measures and rules
};

}  // namespace elsie::python
