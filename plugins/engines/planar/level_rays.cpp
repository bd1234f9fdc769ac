#include "level_rays.h"

#include <cmath>
#include <limits>

// Vectors are passed between inline functions only, so that it does not matter how.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace elsie::physics {
namespace {

using Lanes = LevelRays::Lanes;
using Flags = LevelRays::Flags;
using Group = LevelRays::Group;
using Target = LevelRays::Target;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

#define ELSIE_INLINE [[gnu::always_inline]] inline

ELSIE_INLINE Lanes all(double value) { return Lanes{} + value; }
ELSIE_INLINE Lanes lesser(const Lanes& a, const Lanes& b) { return b < a ? b : a; }
ELSIE_INLINE Lanes greater(const Lanes& a, const Lanes& b) { return a < b ? b : a; }
ELSIE_INLINE Lanes size_of(const Lanes& a) { return a < 0.0 ? -a : a; }
ELSIE_INLINE bool any(const Flags& flags) { return (flags[0] | flags[1] | flags[2] | flags[3]) != 0; }

ELSIE_INLINE Flags meets_circle(const Group& rays, const Target& target) {
  const Lanes x = target.place.x - rays.x, y = target.place.y - rays.y;
  const Lanes across = x * rays.along_y - y * rays.along_x;
  const Lanes to_middle = x * rays.along_x + y * rays.along_y;
  return (across * across <= target.reach * target.reach * rays.flat) &
         (to_middle - target.reach <= rays.nearest) & (to_middle + target.reach >= 0.0);
}

/// Where rays are within `half` of 0, in one direction (slab method, Kay and Kajiya 1986).
ELSIE_INLINE void clip(const Lanes& from, const Lanes& along, double half, Lanes& enter,
                       Lanes& leave) {
  const Lanes inverse = 1.0 / along;
  const Lanes a = (-half - from) * inverse, b = (half - from) * inverse;
  // A ray that runs along the sides is always between them, or never.
  const Flags is_between = size_of(from) <= half;
  const Lanes ever = is_between ? all(-kInfinity) : all(kInfinity);
  enter = greater(enter, along == 0.0 ? ever : lesser(a, b));
  leave = lesser(leave, along == 0.0 ? -ever : greater(a, b));
}

ELSIE_INLINE void meet(Group& rays, const Target& box) {
  const Lanes x = rays.x - box.place.x, y = rays.y - box.place.y;
  const auto [c, s] = box.ahead;
  Lanes enter{}, leave = rays.nearest;
  clip(c * x + s * y, c * rays.along_x + s * rays.along_y, box.half.x, enter, leave);
  clip(c * y - s * x, c * rays.along_y - s * rays.along_x, box.half.y, enter, leave);
  const Flags is_met = (enter <= leave) & (rays.z >= box.low) & (rays.z <= box.high);
  rays.nearest = is_met ? enter : rays.nearest;
  rays.found |= is_met;
}

ELSIE_INLINE void meet_all(std::span<Group> groups, const Target& box) {
  for (Group& rays : groups) {
    if (any(meets_circle(rays, box))) meet(rays, box);
  }
}

void meet_plainly(std::span<Group> groups, const Target& box) { meet_all(groups, box); }

#if defined(__x86_64__)
__attribute__((target("avx2"))) void meet_with_avx2(std::span<Group> groups, const Target& box) {
  meet_all(groups, box);
}
const auto meet_fast = __builtin_cpu_supports("avx2") ? meet_with_avx2 : meet_plainly;
#else
const auto meet_fast = meet_plainly;
#endif

}  // namespace

bool LevelRays::set(std::span<const RayQuery> rays) {
  used_ = (rays.size() + kLanes - 1) / kLanes;
  double sum = 0.0, steepest = 0.0;
  for (std::size_t k = 0; k < used_ * kLanes; ++k) {
    const auto& [origin, direction, range, distance] = rays[k < rays.size() ? k : 0];
    Group& group = groups_[k / kLanes];
    const std::size_t lane = k % kLanes;
    const double flat = direction.x * direction.x + direction.y * direction.y;
    group.x[lane] = origin.x;
    group.y[lane] = origin.y;
    group.z[lane] = origin.z;
    group.along_x[lane] = direction.x;
    group.along_y[lane] = direction.y;
    group.flat[lane] = flat;
    group.nearest[lane] = range;
    group.found[lane] = 0;
    sum += origin.x + origin.y + origin.z + flat;
    steepest += std::abs(direction.z);
  }
  return steepest == 0.0 && std::isfinite(sum);
}

void LevelRays::meet_box(const Target& box) { meet_fast(std::span(groups_).first(used_), box); }

std::uint32_t LevelRays::meeting_circle(const Target& target) const {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    const Flags meets = meets_circle(groups_[i], target);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      bits |= static_cast<std::uint32_t>(meets[lane] & 1) << (i * kLanes + lane);
    }
  }
  return bits;
}

void LevelRays::answer(std::span<RayQuery> rays) const {
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Group& group = groups_[k / kLanes];
    const std::size_t lane = k % kLanes;
    rays[k].distance_m = group.found[lane] != 0 ? group.nearest[lane] : RayQuery::kNothing;
  }
}

}  // namespace elsie::physics
