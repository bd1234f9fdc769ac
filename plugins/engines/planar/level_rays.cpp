#include "level_rays.h"

#include <algorithm>
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
ELSIE_INLINE bool any(const Flags& flags) {
  return (flags[0] | flags[1] | flags[2] | flags[3]) != 0;
}

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

/// The rays of one group, turned from the frame `within` to the world. Returns what is not level in
/// them; not finite if a ray is not.
ELSIE_INLINE double turn(const Frame& within, const RayQuery* rays, std::size_t count,
                         Group& group) {
  Lanes x{}, y{}, z{}, ahead{}, aside{}, up{};  // in the frame `within`
  for (std::size_t lane = 0; lane < LevelRays::kLanes; ++lane) {
    const auto& [from, range, distance] = rays[lane < count ? lane : 0];
    x[lane] = from->origin.x;
    y[lane] = from->origin.y;
    z[lane] = from->origin.z;
    ahead[lane] = from->forward.x;
    aside[lane] = from->forward.y;
    up[lane] = from->forward.z;
    group.nearest[lane] = range;
  }
  const auto& [at, f, l, u] = within;
  group.x = at.x + (x * f.x + y * l.x + z * u.x);
  group.y = at.y + (x * f.y + y * l.y + z * u.y);
  group.z = at.z + (x * f.z + y * l.z + z * u.z);
  group.along_x = ahead * f.x + aside * l.x + up * u.x;
  group.along_y = ahead * f.y + aside * l.y + up * u.y;
  group.flat = group.along_x * group.along_x + group.along_y * group.along_y;
  group.found = Flags{};
  const Lanes slant = size_of(ahead * f.z + aside * l.z + up * u.z);
  const Lanes finite = 0.0 * (group.x + group.y + group.z + group.flat);
  const Lanes both = slant + finite;
  return both[0] + both[1] + both[2] + both[3];
}

ELSIE_INLINE double turn_all(const Frame& within, std::span<const RayQuery> rays,
                             std::span<Group> groups) {
  double sum = 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::size_t first = i * LevelRays::kLanes;
    sum += turn(within, &rays[first], rays.size() - first, groups[i]);
  }
  return sum;
}

struct Instructions {
  void (*meet_all)(std::span<Group> groups, const Target& box);
  double (*turn_all)(const Frame& within, std::span<const RayQuery> rays, std::span<Group> groups);
};

constexpr Instructions kPlain{
    [](std::span<Group> groups, const Target& box) { meet_all(groups, box); },
    [](const Frame& within, std::span<const RayQuery> rays, std::span<Group> groups) {
      return turn_all(within, rays, groups);
    }};

#if defined(__x86_64__)
__attribute__((target("avx2"))) void meet_all_avx2(std::span<Group> groups, const Target& box) {
  meet_all(groups, box);
}
__attribute__((target("avx2"))) double turn_all_avx2(const Frame& within,
                                                     std::span<const RayQuery> rays,
                                                     std::span<Group> groups) {
  return turn_all(within, rays, groups);
}
const Instructions kFast =
    __builtin_cpu_supports("avx2") ? Instructions{meet_all_avx2, turn_all_avx2} : kPlain;
#else
constexpr Instructions kFast = kPlain;
#endif

}  // namespace

bool LevelRays::set(const Frame& within, std::span<const RayQuery> rays) {
  used_ = (rays.size() + kLanes - 1) / kLanes;
  if (kFast.turn_all(within, rays, std::span(groups_).first(used_)) != 0.0) return false;
  middle_ = {groups_[0].x[0], groups_[0].y[0]};
  reach_ = 0.0;
  lowest_ = kInfinity;
  for (const Group& group : std::span(groups_).first(used_)) {
    const Lanes far = size_of(group.x - middle_.x) + size_of(group.y - middle_.y) + group.nearest;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      reach_ = std::max(reach_, far[lane]);
      lowest_ = std::min(lowest_, group.z[lane]);
    }
  }
  return true;
}

void LevelRays::meet_box(const Target& box) {
  kFast.meet_all(std::span(groups_).first(used_), box);
}

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
