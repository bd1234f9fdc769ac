// Explores by a map of cells, which it draws: free, taken, or not known. It drives to the nearest
// known cell beside one that is not known (Yamauchi, "A frontier-based approach for autonomous
// exploration", 1997), and home when there is none.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/readings/lidar.h>

class Explore final : public elsie::Behavior {
 public:
  double size = 6.0;
  double cell = 0.1;
  double speed = 0.3;
  double home_x = 0.0;
  double home_y = 0.0;

  void configured() override { columns_ = static_cast<int>(std::ceil(size / cell)); }

  void reset(elsie::Random&) override {
    cells_.assign(static_cast<std::size_t>(columns_ * columns_), State::unknown);
    path_.clear();
    planned_s_ = -1.0;
    known_m2 = 0.0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Pose& here = now.self().pose;
    for (const auto& scan : now.readings<elsie::LidarReading>()) {
      mark(here, scan);
    }
    if (planned_s_ < 0.0 || now.time_s() - planned_s_ > 0.5) {
      planned_s_ = now.time_s();
      plan(here);
    }
    while (path_.size() > 1 && std::hypot(path_[0].x - here.x, path_[0].y - here.y) < 0.15) {
      path_.erase(path_.begin());
    }
    if (path_.empty()) return elsie::Motion{0.0, 0.0, 1.0};
    const double off = elsie::bearing(here, path_[0].x, path_[0].y);
    return elsie::Motion{speed * std::max(0.0, std::cos(off) - 0.3), 0.0, 3.0 * off};
  }

  void sketch(elsie::Sketch& sketch) const override {
    sketch.in_world();
    std::vector<elsie::Vector3> taken;
    for (int i = 0; i < columns_ * columns_; ++i) {
      if (state(i) == State::taken) {
        taken.push_back({middle(i % columns_), middle(i / columns_), 0.02});
      }
    }
    sketch.points(elsie::SketchRole::belief, taken);
    std::vector<elsie::Vector3> way;
    for (const elsie::Vector2& place : path_) {
      way.push_back({place.x, place.y, 0.02});
    }
    if (way.size() > 1) sketch.line(elsie::SketchRole::target, way);
  }

  double known_m2 = 0.0;

 private:
  enum class State : std::uint8_t { unknown, free, taken };

  double middle(int column) const { return (column + 0.5) * cell - 0.5 * size; }
  int column(double place) const {
    return static_cast<int>(std::floor((place + 0.5 * size) / cell));
  }
  /// The index of a cell, or none outside of the map.
  std::optional<int> index(int x, int y) const {
    if (x < 0 || y < 0 || x >= columns_ || y >= columns_) return std::nullopt;
    return y * columns_ + x;
  }
  State state(int i) const { return cells_[static_cast<std::size_t>(i)]; }

  void set(const elsie::Vector2& place, State state) {
    const auto i = index(column(place.x), column(place.y));
    if (!i) return;
    State& known = cells_[static_cast<std::size_t>(*i)];
    if (known == State::unknown) known_m2 += cell * cell;
    if (known != State::taken) known = state;
  }

  /// Marks what the rays have passed as free, and what they hit as taken.
  void mark(const elsie::Pose& here, const elsie::Sensed<elsie::LidarReading>& scan) {
    const elsie::Vector3& at = scan.mounting().position;
    for (std::size_t i = 0; i < scan->ranges_m.size(); ++i) {
      const double azimuth = scan.azimuth_rad() + scan->azimuth_rad(i);
      const double range = scan->ranges_m[i];
      const bool is_hit = range < 0.95 * scan->max_range_m;  // noise shortens the range of nothing
      const auto along = [&](double far) {
        return elsie::point_of(here,
                               {at.x + far * std::cos(azimuth), at.y + far * std::sin(azimuth)});
      };
      for (double far = 0.0; far < range - cell; far += 0.5 * cell) {
        set(along(far), State::free);
      }
      if (is_hit) set(along(range), State::taken);
    }
  }

  /// Whether the robot fits into a cell: nothing is taken around it.
  bool has_room(int x, int y) const {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const auto i = index(x + dx, y + dy);
        if (i && state(*i) == State::taken && dx * dx + dy * dy <= 4) return false;
      }
    }
    return true;
  }

  /// The shortest way over free cells to the nearest one beside an unknown one, else home.
  void plan(const elsie::Pose& here) {
    const auto start = index(column(here.x), column(here.y));
    const auto home = index(column(home_x), column(home_y));
    if (!start || !home) return;
    std::vector<int> from(cells_.size(), -1);
    from[static_cast<std::size_t>(*start)] = *start;
    std::deque<int> next{*start};
    while (!next.empty()) {
      const int i = next.front();
      next.pop_front();
      for (const auto& [dx, dy] : {std::array{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        const int x = i % columns_ + dx, y = i / columns_ + dy;
        const auto to = index(x, y);
        if (!to) continue;
        if (state(*to) == State::unknown && i != *start) return keep_way(from, *start, i);
        const bool is_new = from[static_cast<std::size_t>(*to)] < 0;
        if (is_new && state(*to) == State::free && has_room(x, y)) {
          from[static_cast<std::size_t>(*to)] = i;
          next.push_back(*to);
        }
      }
    }
    keep_way(from, *start, from[static_cast<std::size_t>(*home)] < 0 ? *start : *home);
  }

  void keep_way(const std::vector<int>& from, int start, int end) {
    path_.clear();
    for (int i = end; i != start; i = from[static_cast<std::size_t>(i)]) {
      path_.insert(path_.begin(), {middle(i % columns_), middle(i / columns_)});
    }
  }

  int columns_ = 0;
  std::vector<State> cells_;
  std::vector<elsie::Vector2> path_;
  double planned_s_ = -1.0;
};

ELSIE_BEHAVIOR(
    Explore, "explore", "Maps what a lidar sees, until it knows all, and drives home",
    elsie::needs<elsie::LidarReading>(),
    elsie::parameter(
        "size", &Explore::size,
        {.unit = "m", .above = 0, .max = 100, .meaning = "edge of the map", .live = false}),
    elsie::parameter(
        "cell", &Explore::cell,
        {.unit = "m", .above = 0.01, .max = 10, .meaning = "edge of a cell", .live = false}),
    elsie::parameter("speed", &Explore::speed,
                     {.unit = "m/s", .min = 0, .max = 10, .meaning = "how fast"}),
    elsie::parameter("home_x", &Explore::home_x, {.unit = "m", .meaning = "east"}),
    elsie::parameter("home_y", &Explore::home_y, {.unit = "m", .meaning = "north"}),
    elsie::publishes("known", &Explore::known_m2,
                     {.unit = "m2", .meaning = "area of the cells that it knows"}));
