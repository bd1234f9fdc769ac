// Samples of a run at equal intervals of simulated time, in bounded memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// The place of each name in a list; the list's size if it is not in it.
inline std::vector<std::size_t> places_of(std::span<const std::string> names,
                                          const std::vector<std::string>& list) {
  std::unordered_map<std::string_view, std::size_t> known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    known.emplace(list[i], i);
  }
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    const auto place = known.find(name);
    places.push_back(place == known.end() ? list.size() : place->second);
  }
  return places;
}

/// One sample per period, ascending in time. When they take more than `most` bytes, every second
/// sample is dropped, and the period doubles; the first one stays. A `Sample` has `time_s` and
/// `bytes()`.
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
    bytes_ += sample.bytes();
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

 private:
  void thin_out() {
    const double now_s = samples_.back().time_s;
    bytes_ = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples_.size(); i += 2, ++kept) {
      if (i != kept) {
        samples_[kept] = std::move(samples_[i]);
      }
      bytes_ += samples_[kept].bytes();
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
