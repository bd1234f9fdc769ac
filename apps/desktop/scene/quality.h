// How finely a picture that moves is drawn: as finely as the time allows.
#pragma once

#include <array>
#include <cstddef>

#include "elsie/render/exposure.h"

namespace elsie::desktop {

/// Chooses a level from how long the last pictures took. A level that is too slow is left after
/// three pictures, and a finer one is tried when it should take less than half of what there is.
class Quality {
 public:
  struct Level {
    render::Shadows shadows;
    int passes;
  };
  static constexpr std::array<Level, 4> kLevels{{{render::Shadows::none, 1},
                                                 {render::Shadows::hard, 1},
                                                 {render::Shadows::hard, 2},
                                                 {render::Shadows::hard, 4}}};
  /// The time for drawing a picture, of 33 ms for thirty in a second: the rest is for lines, words
  /// and panels.
  static constexpr double kMost_ms = 18.0;

  const Level& level() const { return kLevels[level_]; }
  std::size_t number() const { return level_; }
  /// A picture of the present level took that long.
  void took(double ms) {
    if (ms > kMost_ms) {
      quick_ = 0;
      if (++slow_ == 3 && level_ > 0) {
        --level_;
        slow_ = 0;
      }
      return;
    }
    slow_ = 0;
    if (level_ + 1 == kLevels.size()) return;
    const double finer = ms * kLevels[level_ + 1].passes / kLevels[level_].passes;
    quick_ = finer < 0.5 * kMost_ms ? quick_ + 1 : 0;
    if (quick_ == 10) {
      ++level_;
      quick_ = 0;
    }
  }

 private:
  std::size_t level_ = 1;
  int slow_ = 0, quick_ = 0;  // pictures in a row
};

}  // namespace elsie::desktop
