// Samples of a run at equal intervals of simulated time, in bounded memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elsie/traces/sampling.h"

namespace elsie::server {

/// Half the period of a recording with ten samples per second, so that the stored past has all of
/// its samples; the whole period if the half is no whole number of steps.
inline double period_of_past(double step_s) {
  constexpr double kRecorded_s = 0.1;
  const std::uint64_t steps = traces::steps_in(kRecorded_s, step_s);
  return static_cast<double>(steps % 2 == 0 ? steps / 2 : steps) * step_s;
}

/// Names that the samples of a run share as long as they stay the same.
class NameList {
 public:
  explicit NameList(std::vector<std::string> names) : names_(std::move(names)) {
    places_.reserve(names_.size());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      places_.emplace(names_[i], i);
    }
  }
  NameList(const NameList&) = delete;
  NameList& operator=(const NameList&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  /// The place of each of these names; size() of the list if it is not in it.
  std::vector<std::size_t> places_of(std::span<const std::string> names) const {
    std::vector<std::size_t> places;
    places.reserve(names.size());
    for (const std::string& name : names) {
      const auto place = places_.find(name);
      places.push_back(place == places_.end() ? names_.size() : place->second);
    }
    return places;
  }
  /// About the memory that the list takes.
  std::size_t bytes() const {
    std::size_t bytes =
        names_.size() * (sizeof(std::string) + sizeof(*places_.begin()) + 3 * sizeof(void*));
    for (const std::string& name : names_) {
      bytes += name.size();
    }
    return bytes;
  }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string_view, std::size_t> places_;
};

using SharedNames = std::shared_ptr<const NameList>;

inline SharedNames share(std::vector<std::string> names) {
  return std::make_shared<const NameList>(std::move(names));
}

/// Calls `see` for each of these names and each of the samples, with their indices and the place of
/// the name in the sample; past its end if the sample does not have it.
template <class Sample, class See>
void visit_places(std::span<const std::string> names, std::span<const Sample> samples,
                  const See& see) {
  const NameList* list = nullptr;  // successive samples mostly share it
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples[k].names.get() != list) {
      list = samples[k].names.get();
      places = list->places_of(names);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      see(i, k, places[i]);
    }
  }
}

/// One sample per period, ascending in time. When they and their names take more than `most` bytes,
/// every second sample is dropped, and the period doubles; the first one stays. A `Sample` has
/// `time_s`, its `names` and `bytes()` without these.
template <class Sample>
class Samples {
 public:
  explicit Samples(std::size_t most) : most_(most) {}

  void begin(double period_s) {
    samples_.clear();
    bytes_ = 0;
    sampling_ = traces::Sampling(period_s);
    sampling_.is_due(0.0);
  }
  double period_s() const { return sampling_.period_s(); }
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return sampling_.is_due(time_s); }
  /// A sample that is not later than the last one is ignored.
  void add(Sample sample) {
    if (!samples_.empty() && sample.time_s <= samples_.back().time_s) {
      return;
    }
    bytes_ += sample.bytes() + new_names(sample, samples_.size());
    samples_.push_back(std::move(sample));
    if (bytes_ > most_ && samples_.size() > 2) {
      thin_out();
    }
  }

  const std::vector<Sample>& all() const { return samples_; }
  /// The samples after that time.
  std::span<const Sample> after(double time_s) const {
    const auto first =
        std::upper_bound(samples_.begin(), samples_.end(), time_s,
                         [](double time, const Sample& sample) { return time < sample.time_s; });
    return {first, samples_.end()};
  }
  /// The last sample until that time; null if there is none.
  const Sample* until(double time_s) const {
    const std::span<const Sample> later = after(time_s);
    const std::size_t earlier = samples_.size() - later.size();
    return earlier > 0 ? &samples_[earlier - 1] : nullptr;
  }

 private:
  /// The bytes of the names of a sample that the sample before this place does not have.
  std::size_t new_names(const Sample& sample, std::size_t place) const {
    return place > 0 && samples_[place - 1].names == sample.names ? 0 : sample.names->bytes();
  }

  void thin_out() {
    const double now_s = samples_.back().time_s;
    bytes_ = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples_.size(); i += 2, ++kept) {
      if (i != kept) {
        samples_[kept] = std::move(samples_[i]);
      }
      bytes_ += samples_[kept].bytes() + new_names(samples_[kept], kept);
    }
    samples_.resize(kept);
    sampling_ = traces::Sampling(2.0 * sampling_.period_s());
    sampling_.is_due(now_s);
  }

  std::size_t most_;
  std::size_t bytes_ = 0;
  traces::Sampling sampling_;
  std::vector<Sample> samples_;
};

}  // namespace elsie::server
