#include <algorithm>
#include <array>

#include "graph_inks.h"
#include "timeline_parts.h"

namespace elsie::picture {
namespace {

constexpr std::size_t kMostGraphRows = 30;  // of a graph
constexpr double kLeastLit = 0.3;           // of a column's height
constexpr double kNodeIndent = 14.0;        // of a node inside of another
constexpr std::array kLitStates{NodeState::running, NodeState::success, NodeState::failure};

/// The part of a column's time in which a node was each of kLitStates.
using LitParts = std::array<double, kLitStates.size()>;

std::vector<std::vector<LitParts>> columns_of(const GraphRows& shown, const TimelineBlock& block) {
  const std::size_t count = block.columns.size();
  std::vector<std::vector<LitParts>> rows(shown.rows.size(), std::vector<LitParts>(count));
  const double from_s = block.span.from_s;
  const double length = (block.span.to_s - from_s) / static_cast<double>(count);
  const auto see = [&](const traces::TimeSpan& time, std::span<const NodeState> nodes) {
    const auto first = static_cast<std::size_t>((time.from_s - from_s) / length);
    for (std::size_t i = first; i < count; ++i) {
      const double begin = from_s + length * static_cast<double>(i);
      const double part = std::min(time.to_s, begin + length) - std::max(time.from_s, begin);
      if (part <= 0.0 && i > first) break;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t k = 0; k < kLitStates.size(); ++k) {
          if (nodes[shown.rows[r].node] == kLitStates[k]) rows[r][i][k] += part / length;
        }
      }
    }
  };
  traces::walk(*shown.graph, block.span, see);
  return rows;
}

void draw_lit(Canvas& canvas, const TimelineBlock& block, const Rect& area,
              const std::vector<LitParts>& columns) {
  for (std::size_t i = 0, next = 0; i < columns.size(); i = next) {
    next = i + 1;
    while (next < columns.size() && columns[next] == columns[i]) ++next;
    double y = area.bottom();
    for (std::size_t k = 0; k < kLitStates.size(); ++k) {
      if (columns[i][k] <= 0.0) continue;
      const double height =
          std::min(y - area.y, area.height * std::clamp(columns[i][k], kLeastLit, 1.0));
      y -= height;
      canvas.rectangle(
          {block.x_of_column(i), y, block.x_of_column(next) - block.x_of_column(i), height});
      canvas.fill(node_ink(kLitStates[k]));
    }
  }
}

}  // namespace

double GraphRows::height() const {
  return kGraphHead + kGraphRow * static_cast<double>(rows.size()) + kGraphHead / 2;
}

std::vector<GraphRows> graph_rows(const traces::TraceRobot& robot, const traces::TimeSpan& span) {
  std::vector<GraphRows> all;
  for (const traces::TraceGraph& graph : robot.graphs) {
    GraphRows shown{&graph, {}, 0};
    const std::vector<traces::NodeAccount> accounts = traces::account(graph, span);
    const std::vector<int> depths = traces::depths(graph.graph);
    for (std::size_t i = 0; i < accounts.size(); ++i) {
      const double indent = kNodeIndent * depths[i];
      if (accounts[i].was_lit()) shown.rows.push_back({i, indent, accounts[i].running.time_s});
    }
    shown.lit = shown.rows.size();
    if (shown.lit > kMostGraphRows) {
      // Those that were running the longest, in their order.
      std::vector<double> times_s;
      for (const GraphRows::Row& row : shown.rows) times_s.push_back(row.running_s);
      std::nth_element(times_s.begin(), times_s.begin() + kMostGraphRows - 1, times_s.end(),
                       std::greater<>());
      const double least_s = times_s[kMostGraphRows - 1];
      std::erase_if(shown.rows, [&](const auto& row) { return row.running_s < least_s; });
      shown.rows.resize(std::min(shown.rows.size(), kMostGraphRows));
    }
    if (shown.lit > 0) all.push_back(std::move(shown));
  }
  return all;
}

void draw_graph(Canvas& canvas, const TimelineBlock& block, const GraphRows& shown, double y) {
  const traces::TraceGraph& graph = *shown.graph;
  std::string head = graph.path;
  if (shown.rows.size() < shown.lit) {
    head += ": " + std::to_string(shown.rows.size()) + " of " + std::to_string(shown.lit) +
            " nodes, those that were running the longest";
  }
  const TextStyle bold{.size = kTick, .bold = true, .down = Down::middle};
  canvas.text(canvas.fitted(head, bold, block.right() - kPageMargin),
              {kPageMargin, y + kGraphHead / 2}, bold);
  y += kGraphHead;
  const Rect all{block.left, y, block.width(), kGraphRow * static_cast<double>(shown.rows.size())};
  draw_time_grid(canvas, block, all);
  const auto columns = columns_of(shown, block);
  for (std::size_t r = 0; r < shown.rows.size(); ++r, y += kGraphRow) {
    const GraphRows::Row& row = shown.rows[r];
    const Rect area{block.left, y + 1, block.width(), kGraphRow - 2};
    draw_lit(canvas, block, area, columns[r]);
    const TextStyle style{.size = kTick, .down = Down::middle};
    const double left = kPageMargin + row.indent;
    canvas.text(
        canvas.fitted(graph.graph.nodes[row.node].label, style, area.x - kBesidePlot - left),
        {left, area.centre().y}, style);
    const double part = row.running_s / (block.span.to_s - block.span.from_s);
    canvas.text(tick_label(100.0 * part, 1.0) + " %", {area.right() + 8, area.centre().y}, style);
  }
}

}  // namespace elsie::picture
