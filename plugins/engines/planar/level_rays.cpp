#include "level_rays.h"

#include <algorithm>
#include <cstring>
#include <limits>

// Vectors are passed between inline functions only, so that it does not matter how.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace elsie::physics {
namespace {

using Lanes = LevelRays::Lanes;
using Flags = LevelRays::Flags;
using Group = LevelRays::Group;
using Extent = LevelRays::Extent;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

#define ELSIE_INLINE [[gnu::always_inline]] inline

ELSIE_INLINE Lanes lesser(const Lanes& a, const Lanes& b) { return b < a ? b : a; }
ELSIE_INLINE Lanes greater(const Lanes& a, const Lanes& b) { return a < b ? b : a; }
ELSIE_INLINE Lanes size_of(const Lanes& a) { return a < 0.0 ? -a : a; }

/// With the vector x to the circle's middle and the ray's direction d, not a unit vector: the line
/// passes the middle at |x cross d| / |d|, which must not exceed the radius, and the middle lies x
/// d along the ray.
ELSIE_INLINE Flags meets_circle(const Group& rays, const SceneBody& target) {
  const Lanes x = target.place.x - rays.x, y = target.place.y - rays.y;
  const Lanes across = x * rays.along_y - y * rays.along_x;
  const Lanes to_middle = x * rays.along_x + y * rays.along_y;
  return (across * across <= target.reach * target.reach * rays.flat) &
         (to_middle - target.reach <= rays.nearest) & (to_middle + target.reach >= 0.0);
}

/// Where rays are within `half` of 0, in one direction (slab method, Kay and Kajiya 1986):
/// |from + t along| <= half between the two t = (+-half - from) / along. A ray is in a box where it
/// is between both pairs of sides, from the latest entry to the earliest exit.
ELSIE_INLINE void clip(const Lanes& from, const Lanes& along, double half, Lanes& enter,
                       Lanes& leave) {
  // A ray that runs along the sides is always between them, or never: a and b are infinite. On a
  // side, one of them is no number; the order of operands drops it. No zero is negative here.
  const Lanes inverse = 1.0 / (along + 0.0);
  const Lanes a = (-half - from) * inverse, b = (half - from) * inverse;
  enter = greater(enter, lesser(a, b));
  leave = lesser(leave, greater(b, a));
}

/// Tests all rays against each box: which rays may meet it is hard to predict, and finding out
/// costs half as much as the test.
ELSIE_INLINE void meet_boxes(std::span<Group> groups, std::span<const SceneBody* const> boxes) {
  for (Group& group : groups) {
    const Group rays = group;
    Lanes nearest = rays.nearest;
    Flags found = rays.found;
    for (const SceneBody* const box : boxes) {
      const Lanes x = rays.x - box->place.x, y = rays.y - box->place.y;
      const auto [c, s] = box->ahead;
      Lanes enter{}, leave = nearest;
      clip(c * x + s * y, c * rays.along_x + s * rays.along_y, box->half.x, enter, leave);
      clip(c * y - s * x, c * rays.along_y - s * rays.along_x, box->half.y, enter, leave);
      const Flags is_met = (enter <= leave) & (rays.z >= box->low) & (rays.z <= box->high);
      nearest = is_met ? enter : nearest;
      found |= is_met;
    }
    group.nearest = nearest;
    group.found = found;
  }
}

/// Four of a frame's numbers.
ELSIE_INLINE Lanes four(const Frame* frame, std::size_t first) {
  static_assert(sizeof(Frame) == 12 * sizeof(double));
  Lanes lanes;
  std::memcpy(&lanes, reinterpret_cast<const char*>(frame) + first * sizeof(double), sizeof lanes);
  return lanes;
}

/// The rows of a matrix, one in each lane.
struct Rows {
  Lanes x, y, z, w;

  ELSIE_INLINE Rows(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    const Lanes even_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Lanes odd_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Lanes even_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Lanes odd_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    x = __builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5);
    y = __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5);
    z = __builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7);
    w = __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7);
  }
};

/// The rays of one group, turned from the level frame `within` to the world. Returns what is not
/// level in them; not finite if a ray is not.
ELSIE_INLINE Lanes turn(const Frame& within, const RayQuery& a, const RayQuery& b,
                        const RayQuery& c, const RayQuery& d, Group& group) {
  // x, y, z and ahead; aside, up, and two unused lanes.
  const Rows first(four(a.from, 0), four(b.from, 0), four(c.from, 0), four(d.from, 0));
  const Rows second(four(a.from, 4), four(b.from, 4), four(c.from, 4), four(d.from, 4));
  const Lanes &x = first.x, &y = first.y, &ahead = first.w, &aside = second.x, &up = second.y;
  const auto& [at, f, l, u] = within;
  group.x = at.x + (x * f.x + y * l.x);
  group.y = at.y + (x * f.y + y * l.y);
  group.z = at.z + first.z;
  group.along_x = ahead * f.x + aside * l.x;
  group.along_y = ahead * f.y + aside * l.y;
  group.flat = group.along_x * group.along_x + group.along_y * group.along_y;
  group.nearest = Lanes{a.max_range_m, b.max_range_m, c.max_range_m, d.max_range_m};
  group.found = Flags{};
  return size_of(up) + 0.0 * (group.x + group.y + group.z + group.flat);
}

/// Returns whether all rays are level and finite.
ELSIE_INLINE bool turn_all(const Frame& within, std::span<const RayQuery> rays,
                           std::span<Group> groups, Extent& extent) {
  Lanes off{}, reach{}, lowest = Lanes{} + kInfinity;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Group& group = groups[i];
    const auto some = rays.subspan(i * LevelRays::kLanes);
    // Lanes without a ray repeat the first one.
    const auto ray = [&](std::size_t lane) -> const RayQuery& {
      return some[lane < some.size() ? lane : 0];
    };
    off += turn(within, some[0], ray(1), ray(2), ray(3), group);
    if (i == 0) extent.middle = {group.x[0], group.y[0]};
    const Lanes away = size_of(group.x - extent.middle.x) + size_of(group.y - extent.middle.y);
    reach = greater(reach, away + group.nearest);
    lowest = lesser(lowest, group.z);
  }
  extent.reach = std::max(std::max(reach[0], reach[1]), std::max(reach[2], reach[3]));
  extent.lowest = std::min(std::min(lowest[0], lowest[1]), std::min(lowest[2], lowest[3]));
  return off[0] + off[1] + off[2] + off[3] == 0.0;
}

ELSIE_INLINE void answer(std::span<const Group> groups, std::span<RayQuery> rays) {
  for (const Group& group : groups) {
    const Lanes distance = group.found ? group.nearest : Lanes{} + RayQuery::kNothing;
    if (rays.size() < LevelRays::kLanes) {
      for (std::size_t lane = 0; lane < rays.size(); ++lane) rays[lane].distance_m = distance[lane];
      return;
    }
    rays[0].distance_m = distance[0];
    rays[1].distance_m = distance[1];
    rays[2].distance_m = distance[2];
    rays[3].distance_m = distance[3];
    rays = rays.subspan(LevelRays::kLanes);
  }
}

struct Instructions {
  void (*meet_boxes)(std::span<Group> groups, std::span<const SceneBody* const> boxes);
  bool (*turn_all)(const Frame& within, std::span<const RayQuery> rays, std::span<Group> groups,
                   Extent& extent);
  void (*answer)(std::span<const Group> groups, std::span<RayQuery> rays);
};

constexpr Instructions kPlain{
    [](std::span<Group> groups, std::span<const SceneBody* const> boxes) {
      meet_boxes(groups, boxes);
    },
    [](const Frame& within, std::span<const RayQuery> rays, std::span<Group> groups,
       Extent& extent) { return turn_all(within, rays, groups, extent); },
    [](std::span<const Group> groups, std::span<RayQuery> rays) { answer(groups, rays); }};

#if defined(__x86_64__)
__attribute__((target("avx2"))) void meet_boxes_avx2(std::span<Group> groups,
                                                     std::span<const SceneBody* const> boxes) {
  meet_boxes(groups, boxes);
}
__attribute__((target("avx2"))) bool turn_all_avx2(const Frame& within,
                                                   std::span<const RayQuery> rays,
                                                   std::span<Group> groups, Extent& extent) {
  return turn_all(within, rays, groups, extent);
}
__attribute__((target("avx2"))) void answer_avx2(std::span<const Group> groups,
                                                 std::span<RayQuery> rays) {
  answer(groups, rays);
}
const Instructions kFast = __builtin_cpu_supports("avx2")
                               ? Instructions{meet_boxes_avx2, turn_all_avx2, answer_avx2}
                               : kPlain;
#else
constexpr Instructions kFast = kPlain;
#endif

}  // namespace

bool LevelRays::set(const Frame& within, std::span<const RayQuery> rays) {
  if (within.up != Vector3{0.0, 0.0, 1.0} || within.forward.z != 0.0 || within.left.z != 0.0) {
    return false;
  }
  used_ = (rays.size() + kLanes - 1) / kLanes;
  return kFast.turn_all(within, rays, std::span(groups_).first(used_), extent_);
}

void LevelRays::meet_boxes(std::span<const SceneBody* const> boxes) {
  kFast.meet_boxes(std::span(groups_).first(used_), boxes);
}

std::uint32_t LevelRays::meeting_circle(const SceneBody& target) const {
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
  kFast.answer(std::span(groups_).first(used_), rays);
}

}  // namespace elsie::physics
