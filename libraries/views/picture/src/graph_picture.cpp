#include "elsie/picture/graph_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"

#include "canvas.h"
#include "graph_inks.h"

namespace elsie::picture {
namespace {

constexpr double kNodeText = 12.0, kEdgeText = 10.0;
constexpr double kRounding = 6.0;  // radius of corners

constexpr Ink kArrowInk = hex(0x606060, "muted");

const char* words_of(NodeState state) {
  constexpr std::array kWords{"", ": running", ": success", ": failure"};
  return kWords[static_cast<std::size_t>(state)];
}

void trace_rounded(Canvas& canvas, const Vector2& from, const Vector2& to) {
  constexpr double kCircle = 0.5523;  // of the radius: a cubic curve that is nearly a quarter of it
  const double r = std::min({kRounding, (to.x - from.x) / 2, (to.y - from.y) / 2});
  const double near = r * (1.0 - kCircle);
  canvas.line({from.x + r, from.y}, {to.x - r, from.y});
  canvas.curve_to({to.x - near, from.y}, {to.x, from.y + near}, {to.x, from.y + r});
  canvas.line_to({to.x, to.y - r});
  canvas.curve_to({to.x, to.y - near}, {to.x - near, to.y}, {to.x - r, to.y});
  canvas.line_to({from.x + r, to.y});
  canvas.curve_to({from.x + near, to.y}, {from.x, to.y - near}, {from.x, to.y - r});
  canvas.line_to({from.x, from.y + r});
  canvas.curve_to({from.x, from.y + near}, {from.x + near, from.y}, {from.x + r, from.y});
  canvas.close();
}

/// In the upper right corner: a tick or a cross, for who cannot tell the colours.
void draw_mark(Canvas& canvas, const GraphLayout::Box& box, NodeState state) {
  const double right = box.to.x - 3.5, top = box.from.y + 3.5;
  constexpr double kSize = 5.0;
  if (state == NodeState::success) {
    canvas.line({right - kSize, top + 0.6 * kSize}, {right - 0.6 * kSize, top + kSize});
    canvas.line_to({right, top});
  } else {
    canvas.line({right - kSize, top}, {right, top + kSize});
    canvas.line({right - kSize, top + kSize}, {right, top});
  }
  canvas.stroke(kText, {.width = 1.2});
}

void draw_box(Canvas& canvas, const GraphLayout::Box& box, NodeState state) {
  canvas.open_mark(box.label.text + words_of(state));
  trace_rounded(canvas, box.from, box.to);
  canvas.fill_keep(node_ink(state, box.is_frame));
  const bool is_running = state == NodeState::running && !box.is_frame;
  canvas.stroke(kText, {.width = is_running ? 2.5 : 1.0});
  const bool is_done = state == NodeState::success || state == NodeState::failure;
  if (is_done) draw_mark(canvas, box, state);
  canvas.text(box.label.text, box.label.at,
              {.size = kNodeText, .across = Across::centre, .down = Down::middle});
  canvas.close_mark();
}

void draw_arrow(Canvas& canvas, const GraphLayout::Arrow& arrow) {
  const auto& curve = arrow.curve;
  canvas.move_to(curve.front());
  for (std::size_t i = 1; i + 2 < curve.size(); i += 3) {
    canvas.curve_to(curve[i], curve[i + 1], curve[i + 2]);
  }
  canvas.stroke(kArrowInk, {.width = 1.0});
  const Vector2 end = curve.back();
  const double length = std::hypot(arrow.tip.x - end.x, arrow.tip.y - end.y);
  if (length > 0.0) {
    constexpr double kHalf = 3.5;  // of the width
    const Vector2 aside{kHalf * (arrow.tip.y - end.y) / length,
                        kHalf * (end.x - arrow.tip.x) / length};
    canvas.polygon(std::vector<Vector2>{
        arrow.tip, {end.x + aside.x, end.y + aside.y}, {end.x - aside.x, end.y - aside.y}});
    canvas.fill(kArrowInk);
  }
  if (!arrow.label.text.empty()) {
    canvas.text(arrow.label.text, arrow.label.at,
                {.size = kEdgeText, .across = Across::centre, .down = Down::middle});
  }
}

void draw(Canvas& canvas, GraphLayout layout, const GraphLights& lights, const Vector2& by) {
  const auto shift = [&](Vector2& point) { point = {point.x + by.x, point.y + by.y}; };
  for (GraphLayout::Box& box : layout.boxes) {
    shift(box.from), shift(box.to), shift(box.label.at);
    draw_box(canvas, box, box.node ? lights.at(box.graph).at(*box.node) : NodeState::dark);
  }
  for (GraphLayout::Arrow& arrow : layout.arrows) {
    std::for_each(arrow.curve.begin(), arrow.curve.end(), shift);
    shift(arrow.tip), shift(arrow.label.at);
    draw_arrow(canvas, arrow);
  }
  for (Vector2& dot : layout.dots) {
    shift(dot);
    canvas.dot(dot, kGraphDot, kArrowInk);
  }
}

}  // namespace

std::string draw_graphs(const GraphLayout& layout, const GraphLights& lights,
                        const std::string& title, const std::string& format) {
  const bool is_png = format == "png";
  if (!is_png && format != "svg") {
    throw base::Error("a graph cannot be drawn as " + format + "; expected svg or png");
  }
  constexpr double kMostPixels = 16000.0, kMargin = 10.0, kTitle = 15.0;
  const TextStyle style{.size = kTitle, .bold = true, .down = Down::top};
  const Canvas ruler(FileType::png, 1, 1, 1.0);
  const double across = std::max(layout.width, ruler.text_width(title, style));
  const double width = across + 2 * kMargin;
  const double height = layout.height + 3 * kMargin + kTitle;
  const double most = kMostPixels / std::max(width, height);
  if (is_png && most < 1.0) {
    throw base::Error("the graph is " + base::number_text(std::ceil(width)) + " by " +
                          base::number_text(std::ceil(height)) +
                          " pixels large, and a PNG has at most " + base::number_text(kMostPixels) +
                          " on a side if its texts can be read; write it as .svg",
                      base::kBadInput);
  }
  const double zoom = is_png ? std::min(2.0, most) : 1.25;
  Canvas canvas(is_png ? FileType::png : FileType::svg, static_cast<int>(std::ceil(width * zoom)),
                static_cast<int>(std::ceil(height * zoom)), zoom);
  canvas.text(title, {kMargin, kMargin}, style);
  draw(canvas, layout, lights, {kMargin + (across - layout.width) / 2, 2 * kMargin + kTitle});
  return canvas.finish();
}

std::vector<std::uint32_t> screen_graphs(const GraphLayout& layout, const GraphLights& lights,
                                         const Vector2& from, int width, int height, double zoom,
                                         const Style& style) {
  Canvas canvas(FileType::png, width, height, zoom, style);
  draw(canvas, layout, lights, {-from.x, -from.y});
  return canvas.pixels();
}

}  // namespace elsie::picture
