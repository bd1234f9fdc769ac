#include "elsie/picture/top_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "elsie/world/colours.h"

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

// Members of a team differ in lightness and a little in hue: one team, but each differs from the
// others.
Ink member_ink(const Ink& team, std::size_t index, std::size_t members) {
  if (members < 2) return team;
  constexpr std::array<double, 4> kLightness = {0.0, 0.13, -0.12, 0.06};
  const auto others = static_cast<double>(members - 1);
  const double spread = radians(std::min(50.0, 10.0 * others));
  const double part = static_cast<double>(index) / others - 0.5;
  return shifted(team, kLightness[index % kLightness.size()], part * spread);
}

void give_colours(const world::World& world, std::vector<DrawnRobot>& robots) {
  std::map<std::string, std::size_t> members, seen;
  for (const DrawnRobot& robot : robots) ++members[robot.team_id];
  for (DrawnRobot& robot : robots) {
    robot.team = team_ink(world, robot.team_id);
    robot.ink = member_ink(robot.team, seen[robot.team_id]++, members[robot.team_id]);
  }
}

DrawnRobot drawn(RobotTrack track, const world::Robot& known) {
  DrawnRobot robot{std::move(track), world::plan_of(known), {}, {}, known.team};
  // Segments that the track does not have are in line behind the robot.
  const std::vector<Frame> frames = world::in_line(robot.plan);
  const Pose& now = robot.track.now;
  robot.track.segments.resize(std::min(robot.track.segments.size(), frames.size() - 1));
  for (std::size_t i = robot.track.segments.size() + 1; i < frames.size(); ++i) {
    const Vector2 at = point_of(now, {frames[i].origin.x, frames[i].origin.y});
    robot.track.segments.push_back({at.x, at.y, now.heading_rad});
  }
  return robot;
}

void keep_part(std::vector<Pose>& path, std::size_t first, std::size_t end) {
  end = std::min(end, path.size());
  first = std::min(first, end);
  path = std::vector<Pose>(path.begin() + static_cast<std::ptrdiff_t>(first),
                           path.begin() + static_cast<std::ptrdiff_t>(end));
}

// Reduces a path to the chosen part. Touches have no times: those on that part stay.
void choose_path(const TopView& view, RobotTrack& track) {
  const PathChoice& choice = view.paths;
  if (!choice.robots.empty() &&
      std::find(choice.robots.begin(), choice.robots.end(), track.id) == choice.robots.end()) {
    track.path.clear();
    track.believed_path.clear();
    track.placed.clear();
    track.touches.clear();
    return;
  }
  const double period_s = view.path_period_s;
  if (!(period_s > 0.0) || track.path.empty()) return;
  const auto last = static_cast<double>(track.path.size() - 1);
  const double end_s = std::min(choice.to_s, track.from_s + period_s * last);
  const double begin_s = std::max(choice.from_s, choice.fade_s > 0.0 ? end_s - choice.fade_s : 0.0);
  const double first_pose = std::ceil((begin_s - track.from_s) / period_s - 1e-6);
  const double last_pose = std::floor((end_s - track.from_s) / period_s + 1e-6);
  const auto first = static_cast<std::size_t>(std::clamp(first_pose, 0.0, last));
  const auto end =
      last_pose < 0.0 ? first : static_cast<std::size_t>(std::min(last_pose, last)) + 1;
  if (first == 0 && end == track.path.size()) return;
  keep_part(track.path, first, end);
  keep_part(track.believed_path, first, end);
  std::vector<std::size_t> placed;
  for (const std::size_t place : track.placed) {
    if (place >= first && place < end) placed.push_back(place - first);
  }
  track.placed = std::move(placed);
  constexpr double kNear = 0.1;
  std::erase_if(track.touches, [&](const Vector2& touch) {
    return std::none_of(track.path.begin(), track.path.end(), [&](const Pose& pose) {
      return std::hypot(pose.x - touch.x, pose.y - touch.y) < kNear;
    });
  });
}

// A round time that gives the longest path about as many marks as are readable.
double mark_interval(const Scene& scene) {
  std::size_t longest = 0;
  for (const DrawnRobot& robot : scene.robots) {
    longest = std::max(longest, robot.track.path.size());
  }
  if (!(scene.path_period_s > 0.0) || longest < 2) return 0.0;
  const double duration = scene.path_period_s * static_cast<double>(longest - 1);
  const double most = scene.robots.size() > 4 ? 6.0 : 12.0;
  constexpr std::array<double, 15> kIntervals = {0.1, 0.2, 0.5, 1,   2,   5,    10,  20,
                                                 30,  60,  120, 300, 600, 1200, 3600};
  for (const double interval : kIntervals) {
    if (duration / interval <= most) return interval;
  }
  return 3600.0 * std::ceil(duration / most / 3600.0);
}

}  // namespace

Ink team_ink(const world::World& world, const std::string& team) {
  return ink(world::team_colour(world, team));
}

Ink resource_ink(const world::World& world, const world::Obstacle& resource) {
  return ink(world::resource_colour(world, resource));
}

Scene complete(const TopView& view) {
  Scene scene{view.world, {},         view.sketches,  view.fields,
              view.boxes, view.title, view.subtitles, view.path_period_s,
              0.0,        view.paths, view.bare};
  std::unordered_map<std::string_view, const world::Robot*> robots;
  std::unordered_set<std::string_view> tracked;
  for (const world::Robot& robot : view.world.robots) robots.emplace(robot.id, &robot);
  for (const RobotTrack& track : view.robots) {
    const auto known = robots.find(track.id);
    tracked.insert(track.id);
    world::Robot unknown;
    unknown.team.clear();
    DrawnRobot robot = drawn(track, known != robots.end() ? *known->second : unknown);
    choose_path(view, robot.track);
    scene.robots.push_back(std::move(robot));
  }
  for (const world::Robot& robot : view.world.robots) {
    if (tracked.contains(robot.id)) continue;
    RobotTrack track;
    track.id = robot.id;
    track.now = {robot.x, robot.y, radians(robot.heading_deg)};
    scene.robots.push_back(drawn(std::move(track), robot));
  }
  give_colours(view.world, scene.robots);

  const std::size_t given = std::min(view.boxes.size(), view.world.obstacles.size());
  scene.boxes.resize(given);
  for (std::size_t i = given; i < view.world.obstacles.size(); ++i) {
    scene.boxes.emplace_back(start_of(view.world.obstacles[i]));
  }
  if (scene.title.empty()) scene.title = view.world.name.empty() ? "World" : view.world.name;
  if (!scene.is_crowd()) scene.mark_every_s = mark_interval(scene);
  return scene;
}

namespace {

/// Draws the view on a canvas of this type, and calls `take` with it.
template <class Take>
auto drawn(const TopView& view, FileType type, const Size& size, const Take& take) {
  check_size(size);
  const Scene scene = complete(view);
  const std::vector<LegendEntry> legend = legend_of(scene);
  const Layout layout = lay_out(scene, legend, size, zoom_for_width(size.width));

  Canvas canvas(type, layout.width, layout.height, layout.zoom);
  LabelPlacer labels(layout.arena);
  if (!scene.bare) draw_frame(canvas, scene, layout);
  draw_legend(canvas, legend, layout.legend, layout.legend_corner);
  {
    canvas.rectangle(layout.plot);
    const Clip clip(canvas);
    draw_floor(canvas, scene, layout);
    draw_goals(canvas, scene, layout);
    draw_chargers(canvas, scene, layout);
    draw_boxes(canvas, scene, layout, labels);
    draw_walls(canvas, scene, layout);
    if (scene.is_crowd()) {
      draw_crowd(canvas, scene, layout);
    } else {
      draw_paths(canvas, scene, layout, labels);
      draw_sketches(canvas, scene, layout, labels);
      draw_robots(canvas, scene, layout, labels);
      draw_beliefs(canvas, scene, layout);
      draw_touches(canvas, scene, layout);
    }
    draw_lamps(canvas, scene, layout);
    if (!scene.bare) {
      draw_robot_labels(canvas, scene, layout, labels);
      draw_floor_labels(canvas, scene, layout, labels);
      draw_goal_labels(canvas, scene, layout, labels);
    }
    draw_left_out(canvas, layout, labels);
  }
  return take(canvas, layout);
}

std::string bytes_of(const TopView& view, FileType type, const Size& size) {
  return drawn(view, type, size, [](Canvas& canvas, const Layout&) { return canvas.finish(); });
}

}  // namespace

void save_top_view(const TopView& view, const std::filesystem::path& file, const Size& size) {
  write_whole(file, bytes_of(view, file_type(file), size));
}

std::string top_view_svg(const TopView& view, const Size& size) {
  return bytes_of(view, FileType::svg, size);
}

Image top_view_image(const TopView& view, const Size& size) {
  return drawn(view, FileType::png, size, [](Canvas& canvas, const Layout& layout) {
    Image image;
    image.width = layout.width;
    image.height = layout.height;
    for (const std::uint32_t pixel : canvas.pixels()) {  // 0x??RRGGBB
      for (const int shift : {16, 8, 0}) {
        image.bytes.push_back(static_cast<std::uint8_t>(pixel >> shift));
      }
    }
    return image;
  });
}

}  // namespace elsie::picture
