#include "elsie/picture/hits.h"

#include <algorithm>
#include <tuple>

namespace elsie::picture {
namespace {

bool is_before(const Vector3& a, const Vector3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

Hits::Hits(const Sketch& sketch) : sketch_(sketch) {
  for (const Sketch::Mark& mark : sketch.marks()) {
    if (mark.kind != Sketch::Kind::points || mark.role != SketchRole::hit) continue;
    const auto places = sketch.places(mark);
    places_.insert(places_.end(), places.begin(), places.end());
  }
  std::sort(places_.begin(), places_.end(), is_before);
}

SketchRole Hits::role_of(const Sketch::Mark& mark) const {
  const bool is_ray = mark.kind == Sketch::Kind::line && mark.count == 2;
  if (!is_ray || mark.role != SketchRole::range) return mark.role;
  const bool ends_at_hit =
      std::binary_search(places_.begin(), places_.end(), sketch_.places(mark).back(), is_before);
  return ends_at_hit ? SketchRole::hit : SketchRole::range;
}

}  // namespace elsie::picture
