// Rooms: a wall with a door divides an area, and each part in the same way, until a part is too
// small for two rooms. So all rooms are connected.
#include <algorithm>
#include <optional>
#include <vector>

#include "elsie/base/number_text.h"

#include "described.h"

namespace elsie::layouts {

namespace {

constexpr int kMostWallTries = 50;  // of a place for a wall that ends at no door
constexpr double kHair = 1e-9;      // m

struct Door {
  double x = 0.0, y = 0.0;  // m, its middle
};

class Dividing {
 public:
  Dividing(Drawing& drawing, const Rooms& rooms)
      : drawing_(drawing),
        rooms_(rooms),
        random_(drawing.stream(rooms.id)),
        thickness_(rounded_m(rooms.wall_thickness)) {}

  /// `area`: between the walls around it.
  void divide(const Area& area) {
    const bool may_length = area.length >= least(), may_width = area.width >= least();
    if (!may_length && !may_width) {
      return;
    }
    // Mostly across the longer side, so that rooms are not corridors.
    const bool across_x =
        may_length &&
        (!may_width || random_.chance(area.length / (area.length + area.width) > 0.5 ? 0.8 : 0.2));
    const auto at = wall_place(area, across_x);
    if (!at) {
      return;
    }
    add_wall_with_door(area, across_x, *at);
    Area low = area, high = area;
    if (across_x) {
      low.length = *at - 0.5 * thickness_ - area.left();
      high.length = area.length - low.length - thickness_;
      low.x = area.left() + 0.5 * low.length;
      high.x = *at + 0.5 * (thickness_ + high.length);
    } else {
      low.width = *at - 0.5 * thickness_ - area.bottom();
      high.width = area.width - low.width - thickness_;
      low.y = area.bottom() + 0.5 * low.width;
      high.y = *at + 0.5 * (thickness_ + high.width);
    }
    divide(low);
    divide(high);
  }

  void add(double x1, double y1, double x2, double y2) {
    drawing_.add_wall(rooms_.id + "_" + std::to_string(++count_), {x1, y1, x2, y2}, thickness_,
                      rooms_.wall_height, rooms_.location);
  }

 private:
  double least() const { return 2.0 * rooms_.smallest + thickness_ - kHair; }

  /// Where a wall divides the area; none if there is no place that keeps its ends from doors.
  std::optional<double> wall_place(const Area& area, bool across_x) {
    const double off_walls = rooms_.smallest + 0.5 * thickness_;
    const double from = (across_x ? area.left() : area.bottom()) + off_walls;
    const double to =
        (across_x ? area.left() + area.length : area.bottom() + area.width) - off_walls;
    // Rounded inwards, so that no room is smaller than the smallest.
    const double first = rounded_m(from) + (rounded_m(from) < from - kHair ? 1e-4 : 0.0);
    const double last = rounded_m(to) - (rounded_m(to) > to + kHair ? 1e-4 : 0.0);
    for (int i = 0; i < kMostWallTries && first <= last + kHair; ++i) {
      const double at =
          std::clamp(rounded_m(random_.uniform(from, to)), first, std::max(first, last));
      const bool is_free = std::none_of(doors_.begin(), doors_.end(), [&](const Door& door) {
        const double clearance = 0.5 * (rooms_.door + thickness_);
        const double off = std::abs((across_x ? door.x : door.y) - at);
        const double beside = across_x ? door.y : door.x;
        const double low = across_x ? area.bottom() : area.left();
        const double high = low + (across_x ? area.width : area.length);
        return off < clearance &&
               (std::abs(beside - low) < thickness_ || std::abs(beside - high) < thickness_);
      });
      if (is_free) {
        return at;
      }
    }
    return std::nullopt;
  }

  void add_wall_with_door(const Area& area, bool across_x, double at) {
    const double from = across_x ? area.bottom() : area.left();
    const double to = from + (across_x ? area.width : area.length);
    // Walls are longer than between their ends by half their thickness.
    const double half = 0.5 * (rooms_.door + thickness_);
    const double door =
        rounded_m(random_.uniform(from + half + thickness_, to - half - thickness_));
    doors_.push_back(across_x ? Door{at, door} : Door{door, at});
    for (const auto& [begin, end] : {std::pair(from, door - half), std::pair(door + half, to)}) {
      across_x ? add(at, begin, at, end) : add(begin, at, end, at);
    }
  }

  Drawing& drawing_;
  const Rooms& rooms_;
  Random random_;
  double thickness_;  // m, as written in the world
  std::vector<Door> doors_;
  std::size_t count_ = 0;
};

}  // namespace

void draw_rooms(Drawing& drawing, const Rooms& rooms) {
  const Area& area = rooms.area;
  if (!drawing.require_inside(area, rooms.location, rooms.id)) {
    return;
  }
  if (rooms.smallest < rooms.door + 3.0 * rooms.wall_thickness) {
    drawing.refuse(rooms.location, rooms.id,
                   "has rooms of " + base::number_text(rooms.smallest) + " m, but a door of " +
                       base::number_text(rooms.door) + " m and the walls beside it need " +
                       base::number_text(rounded_m(rooms.door + 3.0 * rooms.wall_thickness)) +
                       " m; make the smallest room larger, or the doors narrower");
    return;
  }
  if (area.length * area.width / (rooms.smallest * rooms.smallest) > 1e4) {
    drawing.refuse(rooms.location, rooms.id,
                   "could have more than 10000 rooms; make the smallest room larger");
    return;
  }
  const double thickness = rounded_m(rooms.wall_thickness);
  const Area floor = rooms.border ? area.shrunk(thickness) : area;
  if (std::min(floor.length, floor.width) < rooms.smallest - kHair) {
    drawing.refuse(rooms.location, rooms.id,
                   "has an area of " + base::number_text(rounded_m(area.length)) + " m by " +
                       base::number_text(rounded_m(area.width)) + " m, which has no room of " +
                       base::number_text(rooms.smallest) + " m" +
                       (rooms.border ? " between the walls around it" : "") +
                       "; make the area larger, or the smallest room smaller");
    return;
  }
  Dividing dividing(drawing, rooms);
  dividing.divide(floor);
  if (rooms.border) {
    const Area middles = area.shrunk(0.5 * thickness);
    const double right = middles.left() + middles.length, top = middles.bottom() + middles.width;
    dividing.add(middles.left(), middles.bottom(), right, middles.bottom());
    dividing.add(right, middles.bottom(), right, top);
    dividing.add(right, top, middles.left(), top);
    dividing.add(middles.left(), top, middles.left(), middles.bottom());
  }
}

}  // namespace elsie::layouts
