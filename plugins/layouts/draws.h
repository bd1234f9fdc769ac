// Attributes whose values are drawn.
#pragma once

#include "described.h"

namespace elsie::layouts {

/// Returns whether each <draw> gives one distribution, and no two of them have the same path; if
/// not, adds problems. `layout` is the id of the <scatter> that contains them; none if each is a
/// layout of its own.
bool check_draws(Drawing& drawing, const std::vector<Draw>& draws,
                 const std::optional<std::string>& layout);

/// Draws the attributes of a scattered thing before it has a place. Its number counts from 0;
/// `list` is the group of the world that it belongs to.
void draw_in(const Drawing& drawing, const Scatter& scatter, Element& thing,
             const std::string& list, std::size_t number);

/// Draws the values of the <draw>s of a world for everything at their paths. The n-th element at a
/// path gets the same value in every call, so that calls may repeat while elements are added.
class PathDraws {
 public:
  PathDraws(const Drawing& drawing, const std::vector<Draw>& draws);

  bool empty() const { return draws_.empty(); }
  /// A path that leads nowhere may lead to something later.
  void apply(Drawing& drawing);
  /// The last call: adds a problem for each path that never led anywhere.
  void finish(Drawing& drawing);

 private:
  struct One {
    Draw draw;
    Random random;
    std::vector<double> values;
    std::string why_not;  // "" once the path has led somewhere
  };
  std::vector<One> draws_;
};

}  // namespace elsie::layouts
