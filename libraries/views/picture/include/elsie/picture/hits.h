// How sketches are shown: what all pictures of a world, recordings and the window have in common.
#pragma once

#include <vector>

#include "elsie/api/sketch.h"

namespace elsie::picture {

/// The places that a sketch marks with the role `hit`.
class Hits {
 public:
  /// The sketch must outlive it.
  explicit Hits(const Sketch& sketch);

  /// The role by which a mark is shown. A straight line of role `range` that ends at a hit is shown
  /// as one: so a beam that meets something looks unlike one that does not.
  SketchRole role_of(const Sketch::Mark& mark) const;

 private:
  const Sketch& sketch_;
  std::vector<Vector3> places_;  // sorted
};

}  // namespace elsie::picture
