#include "elsie/picture/timeline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "file.h"
#include "graph_inks.h"
#include "legend.h"
#include "text.h"
#include "timeline_parts.h"

namespace elsie::picture {
namespace {

using traces::RobotAccount;
using traces::TimeSpan;
using traces::TraceRobot;

constexpr double kColumn = 1.5;        // width, units
constexpr double kBesideRight = 50.0;  // for the shares in per cent
constexpr double kHeadline = 28.0;     // of a robot
constexpr double kEventsRow = 20.0;    // all events
constexpr double kKindRow = 15.0;      // events of one name
constexpr double kLaneHead = 10.0;
constexpr double kBand = 28.0;
constexpr double kGap = 9.0;
constexpr double kLaneGap = 5.0;
constexpr double kAxis = 30.0;
constexpr double kBetweenRobots = 22.0;
constexpr double kSymbol = 22.0;  // width in the legend

/// The heights that stretch with the picture.
struct Heights {
  double shares = 0.0;
  double weights = 0.0;  // 0: not shown
  double lane = 0.0;     // 0: not shown
  double number = 0.0;   // that is published; 0: not shown

  Heights times(double stretch) const {
    return {shares * stretch, weights * stretch, lane * stretch, number * stretch};
  }
  double of(const TraceRobot& robot) const {
    return shares + weights + lane * static_cast<double>(robot.members.size()) +
           number * static_cast<double>(robot.numbers.size());
  }
};

class Sheet {
 public:
  Sheet(const Timeline& timeline, double zoom, double width)
      : timeline_(timeline),
        robots_(robots_of(timeline)),
        in_full_(robots_.size() <= kTimelineRobotsInFull),
        span_(traces::within(timeline.span, timeline.trace)),
        inks_(timeline.trace),
        symbols_(timeline.trace, robots_, span_),
        zoom_(zoom),
        width_(width) {
    for (const std::size_t r : robots_) {
      const TraceRobot& robot = timeline.trace.robots[r];
      accounts_.push_back(traces::account(robot, span_));
      kinds_[&robot] = event_kinds(robot, span_);
      if (in_full_) graphs_[&robot] = graph_rows(robot, span_);
    }
    if (!(span_.from_s < span_.to_s)) span_.to_s = span_.from_s + timeline.trace.period_s;
    natural_ = in_full_ ? Heights{104.0, 74.0, 30.0, 44.0} : Heights{56.0, 0.0, 0.0, 0.0};
  }

  /// The height of the parts that do not stretch.
  double fixed_height(const Canvas& ruler) {
    legend_ = legend();
    const double room = width_ - 2 * kPageMargin;
    for (LegendEntry& entry : legend_) {
      entry.text = ruler.fitted(entry.text, {.size = kTick}, room - 60);
    }
    legend_layout_ = lay_out_legend(ruler, legend_, room);
    double height =
        header_height(title(), timeline_.subtitles) + kPageMargin + 20.0 + legend_layout_.height;
    for (const std::size_t r : robots_) {
      const TraceRobot& robot = timeline_.trace.robots[r];
      height += kHeadline + events_height(robot) + kBand + kGap + kAxis + kBetweenRobots +
                (in_full_ ? kGap : kLaneGap);
      if (in_full_) {
        height += kGap + kLaneHead +
                  kLaneGap * static_cast<double>(robot.members.size() + robot.numbers.size());
        for (const GraphRows& graph : graphs_.at(&robot)) height += graph.height();
      }
    }
    return height;
  }
  double natural_height() const {
    double height = 0.0;
    for (const std::size_t r : robots_) height += natural_.of(timeline_.trace.robots[r]);
    return height;
  }

  void draw(Canvas& canvas, double stretch) {
    double y = draw_header(canvas, title(), timeline_.subtitles, width_) + 8;
    const Heights heights = natural_.times(stretch);
    const double left = left_of_plots(canvas);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      y = draw_robot(canvas, timeline_.trace.robots[robots_[i]], accounts_[i], heights, left, y);
    }
    draw_legend(canvas, legend_, legend_layout_, {kPageMargin, y});
  }

 private:
  static std::vector<std::size_t> robots_of(const Timeline& timeline) {
    std::vector<std::size_t> robots = timeline.robots;
    if (robots.empty()) {
      robots.resize(timeline.trace.robots.size());
      std::iota(robots.begin(), robots.end(), 0);
    }
    for (const std::size_t r : robots) {
      if (r >= timeline.trace.robots.size()) {
        throw std::invalid_argument("A timeline of robot " + std::to_string(r) +
                                    " cannot be drawn: the trace has " +
                                    std::to_string(timeline.trace.robots.size()) + " robots.");
      }
    }
    return robots;
  }

  const std::vector<EventKind>& kinds_of(const TraceRobot& robot) const {
    return kinds_.at(&robot);
  }

  /// True if each kind of event has its own row.
  bool in_rows(const TraceRobot& robot) const {
    return in_full_ && kinds_of(robot).size() <= kMostEventRows;
  }

  double events_height(const TraceRobot& robot) const {
    const std::size_t kinds = kinds_of(robot).size();
    if (kinds == 0) return 0.0;
    return kEventsRow + (in_rows(robot) ? kKindRow * static_cast<double>(kinds - 1) : 0.0);
  }

  std::string title() const {
    return timeline_.title.empty() ? "Who decided: " + timeline_.trace.world : timeline_.title;
  }

  /// The left edge of all plots: right of the longest name, on a whole pixel.
  double left_of_plots(const Canvas& canvas) const {
    double widest = 60.0;
    for (const std::size_t r : robots_) {
      const TraceRobot& robot = timeline_.trace.robots[r];
      for (const EventKind& kind : kinds_of(robot)) {
        if (!in_rows(robot)) break;
        widest = std::max(widest, canvas.text_width(kind.name, {.size = kTick}));
      }
      for (const auto& member : robot.members) {
        if (!in_full_) break;
        const std::string name = member.path.substr(member.path.rfind('/') + 1);
        const std::string priority = number_text(member.priority);
        widest = std::max(widest, canvas.text_width(name, {.size = kLabel, .bold = true}) +
                                      14.0 * member.depth + 16.0 + kNameToPriority +
                                      canvas.text_width(priority, {.size = kTick}));
      }
      for (const auto& number : robot.numbers) {
        if (!in_full_) break;
        widest = std::max(widest, canvas.text_width(name_of(number), {.size = kTick}));
      }
      if (!in_full_) continue;
      for (const GraphRows& graph : graphs_.at(&robot)) {
        for (const GraphRows::Row& row : graph.rows) {
          const std::string& label = graph.graph->graph.nodes[row.node].label;
          widest = std::max(widest, row.indent + canvas.text_width(label, {.size = kTick}));
        }
      }
    }
    return std::round((kPageMargin + std::min(widest, 0.25 * width_) + 12.0) * zoom_) / zoom_;
  }

  double draw_robot(Canvas& canvas, const TraceRobot& robot, const RobotAccount& account,
                    const Heights& heights, double left, double y) {
    TimelineBlock block{robot, inks_, span_, {}, left, 0.0};
    block.column_width = std::max(1.0, std::round(kColumn * zoom_)) / zoom_;
    const double room = width_ - left - kPageMargin - (in_full_ ? kBesideRight : 0.0);
    block.columns = columns_of(robot, span_,
                               static_cast<std::size_t>(std::max(1.0, room / block.column_width)));

    const TextStyle name{.size = kPanelTitle, .bold = true, .down = Down::top};
    const TextStyle about{.size = kLabel, .ink = kFaintText, .down = Down::top};
    canvas.text(robot.id, {kPageMargin, y}, name);
    const double beside = kPageMargin + canvas.text_width(robot.id, name) + 12;
    std::string text = "team " + robot.team + ", " +
                       (robot.coordinator.empty() ? "no coordinator" : robot.coordinator);
    if (account.span.from_s > span_.from_s || account.span.to_s < span_.to_s) {
      text += ", from " + number_text(account.span.from_s) + " s to " +
              number_text(account.span.to_s) + " s";
    }
    canvas.text(canvas.fitted(text, about, width_ - beside - kPageMargin), {beside, y + 1}, about);
    y += kHeadline;

    const double events_at = y + kEventsRow / 2 - 3;
    y += events_height(robot);
    const auto panel = [&](double height, double gap) {
      const Rect area{left, y, block.width(), height};
      y += height + gap;
      return area;
    };
    draw_deciders(canvas, block, panel(kBand, kGap));
    draw_shares(canvas, block, panel(heights.shares, in_full_ ? kGap : kLaneGap));
    if (in_full_) {
      draw_weights(canvas, block, panel(heights.weights, kGap + kLaneHead));
      if (!robot.members.empty()) draw_lane_head(canvas, block, y - 3);
      for (std::size_t i = 0; i < robot.members.size(); ++i) {
        draw_lane(canvas, block, i, account.members[i].robot_share, panel(heights.lane, kLaneGap));
      }
      for (const traces::TraceNumber& number : robot.numbers) {
        draw_number(canvas, block, number, panel(heights.number, kLaneGap));
      }
      for (const GraphRows& graph : graphs_.at(&robot)) {
        draw_graph(canvas, block, graph, y);
        y += graph.height();
      }
    }
    draw_events(canvas, block, kinds_of(robot), symbols_, in_rows(robot), events_at, kKindRow, y);
    draw_time_axis(canvas, block, y);
    return y + kAxis + kBetweenRobots;
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries;
    if (!in_full_) add_behaviors(entries);
    const auto swatch = [](const Ink& ink) {
      return [ink](Canvas& canvas, const Vector2& at) {
        canvas.rectangle({at.x - 9, at.y - 6, 18, 12}).fill_keep(ink);
        canvas.stroke(kFrame, {.width = 0.8});
      };
    };
    const auto any = [&](auto predicate) {
      return std::any_of(accounts_.begin(), accounts_.end(), predicate);
    };
    if (any([](const RobotAccount& a) { return a.coordinators[0].together_s > 0.0; })) {
      entries.push_back({"several with the same share", kSymbol,
                         swatch(inks_.of_decider({}, traces::kTogether))});
    }
    if (any([](const RobotAccount& a) { return a.coordinators[0].nobody_s > 0.0; })) {
      entries.push_back({"nobody", kSymbol, swatch(inks_.of_decider({}, traces::kNobody))});
    }
    if (in_full_) {
      entries.push_back(
          {"part in the robot's command", kSymbol, swatch(series_ink(0).with_alpha(kLaneAlpha))});
      entries.push_back({"activation", kSymbol, [](Canvas& canvas, const Vector2& at) {
                           canvas.line({at.x - 11, at.y}, {at.x + 11, at.y});
                           canvas.stroke(kText, {.width = 1.3});
                         }});
    }
    if (in_full_ && any([](const RobotAccount& a) {
          return std::any_of(a.members.begin(), a.members.end(),
                             [](const auto& member) { return !member.inhibited.empty(); });
        })) {
      entries.push_back({"silenced by another", kSymbol, [](Canvas& canvas, const Vector2& at) {
                           const Rect area{at.x - 9, at.y - 6, 18, 12};
                           canvas.rectangle(area);
                           hatch(canvas, area);
                           canvas.rectangle(area).stroke(kFrame, {.width = 0.8});
                         }});
    }
    for (const auto& [words, state] : {std::pair("running", NodeState::running),
                                       {"success", NodeState::success},
                                       {"failure", NodeState::failure}}) {
      if (was_lit(state)) entries.push_back({words, kSymbol, swatch(node_ink(state))});
    }
    // Rows have the names of their events next to them.
    std::set<std::string> unnamed;
    for (const auto& [robot, kinds] : kinds_) {
      if (in_rows(*robot)) continue;
      for (const EventKind& kind : kinds) unnamed.insert(kind.name);
    }
    for (const std::string& name : symbols_.names()) {
      if (!unnamed.contains(name)) continue;
      entries.push_back({name, kSymbol, [this, name](Canvas& canvas, const Vector2& at) {
                           symbols_.draw(canvas, name, at);
                         }});
    }
    return entries;
  }

  bool was_lit(NodeState state) const {
    for (const auto& [robot, graphs] : graphs_) {
      for (const GraphRows& shown : graphs) {
        for (const traces::TraceGraph::Lights& lights : shown.graph->lights) {
          if (std::find(lights.nodes.begin(), lights.nodes.end(), state) != lights.nodes.end()) {
            return true;
          }
        }
      }
    }
    return false;
  }

  void add_behaviors(std::vector<LegendEntry>& entries) const {
    std::vector<std::string> paths;
    for (const std::size_t r : robots_) {
      const TraceRobot& robot = timeline_.trace.robots[r];
      for (std::size_t i = 0; i < robot.members.size(); ++i) {
        const std::string& path = robot.members[i].path;
        if (robot.members[i].parent >= 0 ||
            std::find(paths.begin(), paths.end(), path) != paths.end()) {
          continue;
        }
        paths.push_back(path);
        entries.push_back(
            {path, kSymbol,
             [ink = inks_.of(robot, static_cast<int>(i))](Canvas& canvas, const Vector2& at) {
               canvas.rectangle({at.x - 9, at.y - 6, 18, 12}).fill(ink);
             }});
      }
    }
  }

  const Timeline& timeline_;
  std::vector<std::size_t> robots_;
  bool in_full_;
  TimeSpan span_;
  std::vector<RobotAccount> accounts_;  // parallel to the robots
  std::map<const TraceRobot*, std::vector<EventKind>> kinds_;
  std::map<const TraceRobot*, std::vector<GraphRows>> graphs_;
  BehaviorInks inks_;
  EventSymbols symbols_;
  double zoom_, width_;
  Heights natural_;
  std::vector<LegendEntry> legend_;
  LegendLayout legend_layout_;
};

}  // namespace

void save_timeline(const Timeline& timeline, const std::filesystem::path& file, const Size& size) {
  const FileType type = file_type(file);
  check_size(size);
  const double zoom = zoom_for_width(size.width);
  Sheet sheet(timeline, zoom, size.width / zoom);
  const Canvas ruler(FileType::png, 1, 1, zoom);
  const double fixed = sheet.fixed_height(ruler), natural = sheet.natural_height();
  const double wanted = std::ceil((fixed + natural) * zoom);
  constexpr double kHighest = 16000.0;
  if (size.height == 0 && wanted > kHighest) {
    throw std::invalid_argument(
        "A timeline of " +
        std::to_string(timeline.robots.empty() ? timeline.trace.robots.size()
                                               : timeline.robots.size()) +
        " robots would be " + std::to_string(static_cast<int>(wanted)) +
        " pixels high, but pictures have at most 16000: choose some of the robots, or a smaller "
        "width.");
  }
  const int height = size.height > 0 ? size.height : static_cast<int>(std::max(200.0, wanted));
  const double stretch = natural > 0.0 ? std::max(0.2, (height / zoom - fixed) / natural) : 1.0;
  Canvas canvas(type, size.width, height, zoom);
  sheet.draw(canvas, stretch);
  write_whole(file, canvas.finish());
}

}  // namespace elsie::picture
