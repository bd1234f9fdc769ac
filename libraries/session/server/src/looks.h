// What a run shows besides poses and numbers, stored while a window watches it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "link.h"
#include "samples.h"

namespace elsie::server {

/// Samples of Watching::look(): the pictures of cameras, the messages that robots hear, and the
/// reasons of decisions; see Samples. There are none from the times when nothing of this was
/// watched.
class Looks {
 public:
  struct Sample {
    double time_s = 0.0;
    SharedNames names;  // none; Samples asks for them
    std::vector<std::uint8_t> packed;

    std::size_t bytes() const { return sizeof(*this) + packed.size(); }
  };

  explicit Looks(std::size_t most = std::size_t{200} << 20) : samples_(most) {}

  /// Begins a new run.
  void begin(double period_s) { samples_.begin(period_s); }
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return samples_.is_due(time_s); }
  /// Adds a look; null is none.
  void add(double time_s, const Json& look) {
    if (!look.is_null()) samples_.add({time_s, no_names_, Json::to_cbor(look)});
  }
  /// The look of a time: the last one until then, but not from more than a period before. Null if
  /// there is none.
  Json at(double time_s) const {
    const Sample* const last = samples_.until(time_s);
    return last && time_s - last->time_s < samples_.period_s() ? Json::from_cbor(last->packed)
                                                               : Json();
  }

 private:
  Samples<Sample> samples_;
  SharedNames no_names_ = share({});
};

}  // namespace elsie::server
