#include <algorithm>
#include <array>
#include <cmath>

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

Vector2 at(const Layout& layout, const Pose& pose) { return layout.map.pixel({pose.x, pose.y}); }

double length(const Vector2& a, const Vector2& b) { return std::hypot(b.x - a.x, b.y - a.y); }

double path_length(const std::vector<PathStep>& steps) {
  double sum = 0.0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    sum += steps[i].driven ? length(steps[i - 1].at, steps[i].at) : 0.0;
  }
  return sum;
}

// Draws old parts paler, in pieces, each with an outline that separates it from what it crosses.
void draw_line(Canvas& canvas, const std::vector<PathStep>& steps, const Ink& ink, double width,
               double palest) {
  constexpr int kPieces = 40;
  std::size_t first = 0;
  while (first + 1 < steps.size()) {
    const int piece = std::min(kPieces - 1, static_cast<int>(steps[first].part * kPieces));
    std::size_t last = first + 1;
    if (!steps[last].driven) {
      first = last;
      continue;
    }
    while (last + 1 < steps.size() && steps[last + 1].driven &&
           std::min(kPieces - 1, static_cast<int>(steps[last].part * kPieces)) == piece) {
      ++last;
    }
    std::vector<Vector2> points;
    for (std::size_t i = first; i <= last; ++i) points.push_back(steps[i].at);
    const double age = 1.0 - (piece + 1.0) / kPieces;
    canvas.polyline(points).stroke(kFloor.with_alpha(0.75), {.width = width + 2});
    canvas.polyline(points).stroke(mix(ink, kFloor, palest * age),
                                   {.width = width, .dash = {}, .round = true});
    first = last;
  }
}

void draw_directions(Canvas& canvas, const std::vector<PathStep>& steps, const Ink& ink,
                     double apart, double size) {
  double since = apart * 0.5;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (!steps[i].driven) continue;
    since += length(steps[i - 1].at, steps[i].at);
    if (since < apart) continue;
    since = 0.0;
    const Vector2& to = steps[i].at;
    const Vector2& from = steps[i - 1].at;
    draw_arrow_head(canvas, to, std::atan2(to.y - from.y, to.x - from.x), size,
                    mix(ink, kText, 0.12));
  }
}

void draw_time_marks(Canvas& canvas, const Scene& scene, const Layout& layout,
                     const DrawnRobot& robot) {
  const auto& path = robot.track.path;
  const double poses_apart = scene.mark_every_s / scene.path_period_s;
  constexpr double kNearly = 1e-6;  // a pose that is due a rounding error later is meant
  for (double i = poses_apart + kNearly; i < static_cast<double>(path.size()); i += poses_apart) {
    const Pose& pose = path[static_cast<std::size_t>(i)];
    canvas.circle(at(layout, pose), 2.8).fill_keep(kPaper);
    canvas.stroke(robot.ink, {.width = 1.5});
  }
}

/// Parts of a vehicle in their order on paper: wheels below the chassis; casters are out of sight.
void draw_vehicle(Canvas& canvas, const DrawnRobot& robot, const Layout& layout,
                  std::size_t vehicle, const Pose& pose, const Ink& chassis) {
  for (const PartRole role : {PartRole::wheel, PartRole::chassis}) {
    for (const Part& part : robot.plan.parts) {
      if (part.vehicle != vehicle || part.role != role) continue;
      const Vector2 middle = point_of(pose, {part.frame.origin.x, part.frame.origin.y});
      const double turned = std::atan2(part.frame.forward.y, part.frame.forward.x);
      if (part.shape.is_round()) {
        canvas.circle(layout.map.pixel(middle), layout.map.scale_x * part.shape.radius());
      } else {
        canvas.polygon(pixels(layout.map, {middle.x, middle.y, pose.heading_rad + turned},
                              outline_of(part.shape, 4)));
      }
      if (role == PartRole::wheel) {
        canvas.fill(kText);
      } else {
        canvas.fill_keep(chassis);
        canvas.stroke(mix(robot.ink, kText, 0.45), {.width = 1});
      }
    }
  }
}

const Part& chassis_of(const DrawnRobot& robot, std::size_t vehicle = 0) {
  return *std::find_if(robot.plan.parts.begin(), robot.plan.parts.end(),
                       [&](const Part& part) { return part.vehicle == vehicle; });
}

// The segments, and the bars between them from joint to joint.
void draw_segments(Canvas& canvas, const DrawnRobot& robot, const Layout& layout,
                   LabelPlacer& labels) {
  const auto ahead_of = [&](const Pose& pose, double ahead) {
    return layout.map.pixel(point_of(pose, {ahead, 0.0}));
  };
  const std::vector<Pose>& poses = robot.track.segments;
  for (std::size_t i = poses.size(); i-- > 0;) {
    if (!finite(poses[i])) continue;
    const Vector2 middle = at(layout, poses[i]);
    if (const Pose& front = i == 0 ? robot.track.now : poses[i - 1]; finite(front)) {
      const HitchJoint& hitch = std::get<HitchJoint>(chassis_of(robot, i + 1).joint);
      const std::array<Vector2, 3> bars{at(layout, front), ahead_of(poses[i], hitch.ahead), middle};
      canvas.polyline(bars).stroke(kText, {.width = 1.6});
    }
    draw_vehicle(canvas, robot, layout, i + 1, poses[i], mix(robot.ink, kPaper, 0.35));
    labels.avoid_spot(middle);
  }
}

// The nose of a large enough robot: a wedge in the front half of the chassis.
void draw_nose(Canvas& canvas, const DrawnRobot& robot, const Layout& layout) {
  const Vector3& size = chassis_of(robot).shape.size;
  const auto point = [&](double along, double aside) {
    const double x = along * size.x, y = aside * size.y;
    return layout.map.pixel(point_of(robot.track.now, {x, y}));
  };
  const std::array<Vector2, 3> wedge{point(0.44, 0.0), point(0.12, 0.3), point(0.12, -0.3)};
  canvas.polygon(wedge).fill(kPaper.with_alpha(0.92));
}

// A ring around a robot that is too small to be seen, with a tip that points ahead.
void draw_ring(Canvas& canvas, const Vector2& middle, double heading_rad, const Ink& ink) {
  const double angle = -heading_rad;  // y points down in the picture
  const Vector2 tip{middle.x + (kRing + 9) * std::cos(angle),
                    middle.y + (kRing + 9) * std::sin(angle)};
  canvas.circle(middle, kRing + 1.8).fill(kPaper.with_alpha(0.85));
  canvas.circle(middle, kRing).fill_keep(mix(kPaper, ink, 0.16));
  canvas.stroke(ink, {.width = 2});
  draw_arrow_head(canvas, tip, angle, 11, mix(ink, kText, 0.2));
}

double chassis_size(const DrawnRobot& robot, const Layout& layout) {
  const Vector3& size = chassis_of(robot).shape.size;
  return 0.5 * layout.map.scale_x * std::min(size.x, size.y);
}

}  // namespace

std::vector<PathStep> visible_steps(const Layout& layout, const RobotTrack& track, double apart) {
  std::vector<PathStep> steps;
  const std::size_t count = track.path.size();
  std::size_t placements = 0;
  bool driven = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose& pose = track.path[i];
    if (placements < track.placed.size() && track.placed[placements] == i) {
      driven = false;
      ++placements;
    }
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y)) continue;
    const Vector2 here = at(layout, pose);
    if (driven && !steps.empty() && i + 1 < count && length(steps.back().at, here) < apart) {
      continue;
    }
    steps.push_back(
        {here, static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(count - 1, 1)),
         driven});
    driven = true;
  }
  return steps;
}

double robot_radius(const DrawnRobot& robot, const Layout& layout) {
  double half_width = 0.0;
  for (const Part& part : robot.plan.parts) {
    if (part.vehicle == 0) {
      half_width = std::max(half_width, std::abs(part.frame.origin.y) + 0.5 * part.shape.size.y);
    }
  }
  const double own =
      layout.map.scale_x * std::hypot(0.5 * chassis_of(robot).shape.size.x, half_width);
  return chassis_size(robot, layout) < kLegibleChassis ? std::max(own, kRing + 2) : own;
}

void draw_robot_symbol(Canvas& canvas, const Vector2& middle, double heading_rad, const Ink& ink) {
  const double angle = -heading_rad;
  canvas.circle(middle, 7.5).fill_keep(mix(kPaper, ink, 0.16));
  canvas.stroke(ink, {.width = 1.8});
  canvas.rectangle({middle.x - 3.5, middle.y - 3.5, 7, 7}).fill(ink);
  draw_arrow_head(canvas, {middle.x + 15.5 * std::cos(angle), middle.y + 15.5 * std::sin(angle)},
                  angle, 8.5, mix(ink, kText, 0.2));
}

void draw_touch(Canvas& canvas, const Vector2& middle) {
  constexpr double kArm = 4.5;
  for (const auto& [ink, width] : {std::pair{kPaper, 4.2}, std::pair{kTouch, 2.0}}) {
    canvas.line({middle.x - kArm, middle.y - kArm}, {middle.x + kArm, middle.y + kArm});
    canvas.line({middle.x - kArm, middle.y + kArm}, {middle.x + kArm, middle.y - kArm});
    canvas.stroke(ink, {.width = width, .dash = {}, .round = true});
  }
}

void draw_paths(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels) {
  std::vector<std::vector<PathStep>> paths;
  double total = 0.0;
  for (const DrawnRobot& robot : scene.robots) {
    paths.push_back(visible_steps(layout, robot.track, 1.2));
    total += path_length(paths.back());
  }
  // The more paths on the floor, the thinner the lines and the fewer the arrows.
  const double area = layout.plot.width * layout.plot.height;
  const double fullness = total / std::max(area, 1.0);
  const double width = std::clamp(2.4 - 60.0 * fullness, 1.1, 2.2);
  const double size = std::clamp(9.5 - 120.0 * fullness, 6.0, 8.5);
  constexpr int kArrows = 60;  // in the whole picture
  const double apart = std::max(110.0, total / kArrows);

  for (std::size_t i = 0; i < paths.size(); ++i) {
    draw_line(canvas, paths[i], scene.robots[i].ink, width, scene.paths.fade_s > 0.0 ? 1.0 : 0.58);
    for (const PathStep& step : paths[i]) labels.avoid_spot(step.at);
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const DrawnRobot& robot = scene.robots[i];
    if (paths[i].size() < 2) continue;
    draw_directions(canvas, paths[i], robot.ink, apart, size);
    if (scene.mark_every_s > 0.0) draw_time_marks(canvas, scene, layout, robot);
    if (scene.paths.fade_s > 0.0) continue;  // the path fades in
    const Vector2& start = paths[i].front().at;
    canvas.rectangle({start.x - 3.8, start.y - 3.8, 7.6, 7.6}).fill_keep(kPaper);
    canvas.stroke(robot.ink, {.width = 2});
  }
}

void draw_beliefs(Canvas& canvas, const Scene& scene, const Layout& layout) {
  for (const DrawnRobot& robot : scene.robots) {
    std::vector<Vector2> points;
    for (const Pose& pose : robot.track.believed_path) {
      if (finite(pose)) points.push_back(at(layout, pose));
    }
    if (points.size() > 1) {
      canvas.polyline(points).stroke(robot.ink, {.width = 1.6, .dash = {0.1, 4}, .round = true});
    }
    if (!robot.track.believed || !finite(*robot.track.believed)) continue;
    const Pose& pose = *robot.track.believed;
    const Shape& chassis = chassis_of(robot).shape;
    const Pen pen{.width = 1.4, .dash = {3, 2}};
    if (chassis_size(robot, layout) < kLegibleChassis) {
      canvas.circle(at(layout, pose), kRing).stroke(robot.ink, pen);
    } else {
      canvas.polygon(pixels(layout.map, pose, outline_of(chassis, 24))).stroke(robot.ink, pen);
    }
    canvas.line(at(layout, pose), layout.map.pixel(point_of(pose, {0.5 * chassis.size.x, 0.0})));
    canvas.stroke(robot.ink, pen);
  }
}

void draw_robots(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels) {
  for (const DrawnRobot& robot : scene.robots) {
    if (!finite(robot.track.now)) continue;
    const Vector2 middle = at(layout, robot.track.now);
    const bool small = chassis_size(robot, layout) < kLegibleChassis;
    if (small) draw_ring(canvas, middle, robot.track.now.heading_rad, robot.ink);
    draw_segments(canvas, robot, layout, labels);
    draw_vehicle(canvas, robot, layout, 0, robot.track.now, robot.ink);
    // In a very large arena the chassis is smaller than a pixel or two.
    if (chassis_size(robot, layout) < 3.0) canvas.circle(middle, 3.0).fill(robot.ink);
    if (!small) draw_nose(canvas, robot, layout);
    const double r = robot_radius(robot, layout) + (small ? 4.0 : 0.0);
    labels.avoid({middle.x - r, middle.y - r, 2 * r, 2 * r}, 6.0);
    // A name close to another robot would be taken for its name.
    const double wide = r + 9.0;
    labels.avoid({middle.x - wide, middle.y - wide, 2 * wide, 2 * wide}, 0.7);
  }
}

void draw_touches(Canvas& canvas, const Scene& scene, const Layout& layout) {
  for (const DrawnRobot& robot : scene.robots) {
    for (const Vector2& touch : robot.track.touches) draw_touch(canvas, layout.map.pixel(touch));
  }
}

void draw_robot_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                       LabelPlacer& labels) {
  constexpr std::size_t kMostLabels = 120, kMostCharacters = 18;
  if (scene.robots.size() > kMostLabels) return;
  for (const DrawnRobot& robot : scene.robots) {
    const std::string text = clean_text(robot.track.id, kMostCharacters);
    if (text.empty() || !finite(robot.track.now)) continue;
    const Vector2 middle = at(layout, robot.track.now);
    const Ink colour = readable(mix(robot.ink, kText, 0.25));
    const TextStyle style{.size = 13, .bold = true, .ink = colour, .halo = 2.5};
    draw_label(canvas, labels, text, middle, robot_radius(robot, layout), style);
  }
}

void draw_label(Canvas& canvas, LabelPlacer& labels, const std::string& text, const Vector2& middle,
                double radius, const TextStyle& style) {
  const auto place = labels.place(middle, radius, canvas.text_width(text, style), style.size);
  if (!place) return;
  const Rect& label = place->rect;
  if (place->apart) {
    const Vector2 to{std::clamp(middle.x, label.x, label.right()),
                     std::clamp(middle.y, label.y, label.bottom())};
    const double off = length(middle, to);
    const Vector2 from{middle.x + radius * (to.x - middle.x) / off,
                       middle.y + radius * (to.y - middle.y) / off};
    canvas.line(from, to).stroke(kPaper.with_alpha(0.8), {.width = 3});
    canvas.line(from, to).stroke(style.ink.with_alpha(0.8), {.width = 1});
  }
  constexpr double kDescent = 0.13;  // of the text's size, below its base line
  canvas.text(text, {label.x, label.bottom() - kDescent * style.size}, style);
}

void draw_left_out(Canvas& canvas, const Layout& layout, const LabelPlacer& labels) {
  if (labels.left_out() == 0) return;
  const std::string text = std::to_string(labels.left_out()) +
                           (labels.left_out() == 1 ? " label is" : " labels are") +
                           " left out for want of room";
  canvas.text(text, {layout.arena.right() - 6, layout.arena.bottom() - 6},
              {.size = 11, .across = Across::right, .halo = 2.5});
}

}  // namespace elsie::picture
