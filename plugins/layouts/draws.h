// Attributes whose values are drawn.
#pragma once

#include "drawing.h"

namespace elsie::layouts {

/// Whether a <draw> says one distribution; else a problem is added.
bool check_draw(Drawing& drawing, const world::Draw& draw, const std::string& layout);

/// Draws the attributes of a scattered thing, its number from 0, before it has a place. `list`: the
/// group of the world that it belongs to.
void draw_in(const Drawing& drawing, const world::Scatter& scatter, Element& thing,
             const std::string& list, std::size_t number);

/// Draws the values of one <draw>, in two parts: for what is there before anything is scattered, and
/// for what was scattered.
class PathDraw {
 public:
  PathDraw(const Drawing& drawing, const world::Draw& draw)
      : draw_(draw), random_(drawing.stream(draw.id)) {}

  const world::Draw& draw() const { return draw_; }
  /// Adds a problem if the path leads nowhere, unless more is `expected`.
  void apply(Drawing& drawing, bool is_more_expected);

 private:
  world::Draw draw_;
  Random random_;
  std::size_t drawn_ = 0;
};

}  // namespace elsie::layouts
