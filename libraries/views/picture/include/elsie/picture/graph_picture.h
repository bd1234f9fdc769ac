// Coordinators' states or trees as drawings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/graph.h"
#include "elsie/picture/plot.h"

namespace elsie::picture {

/// A coordinator's graph. The path, such as "explore/arbiter_tree", names it among others.
struct NamedGraph {
  std::string path;
  Graph graph;

  bool operator==(const NamedGraph&) const = default;
};

/// What the nodes of each graph are.
using GraphLights = std::vector<std::vector<NodeState>>;

inline constexpr double kGraphDot = 4.0;  // radius of a dot

/// Where the parts of graphs stand, in units of which a text has 10 to 12; y goes down. Drawing it
/// again with other lights is cheap.
struct GraphLayout {
  struct Label {
    std::string text;
    Vector2 at;      // its middle
    Vector2 size{};  // the room that it takes
  };
  /// A node; one that holds others is a frame around them.
  struct Box {
    Vector2 from, to;  // upper left and lower right corner
    Label label;
    std::size_t graph = 0;
    std::optional<std::size_t> node{};  // none: the frame of the graph, if there are several
    bool is_frame = false;
  };
  struct Arrow {
    std::vector<Vector2> curve;  // a point, then three for each cubic Bezier curve
    Vector2 tip;                 // of its head, which begins at the end of the curve
    Label label;
  };

  std::vector<Box> boxes;     // each after those around it
  std::vector<Arrow> arrows;  // those of edges, then those from the dots
  /// Middles of dots, each with an arrow to the state in which the whole, or the frame around it,
  /// begins. Trees have none.
  std::vector<Vector2> dots;
  double width = 0.0, height = 0.0;
};

/// Graphviz' time grows with the square of the nodes (6 minutes for a ring of 5000), and nothing
/// interrupts it.
inline constexpr std::size_t kMostGraphNodes = 400;
/// Throws base::Error if the graphs have more nodes than that together.
void require_drawable(const std::vector<NamedGraph>& graphs);

/// Graphviz lays the graphs out: each in a frame with its path, if there are several. Throws
/// base::Error when they are not drawable, or Graphviz fails.
GraphLayout lay_out(const std::vector<NamedGraph>& graphs);

/// Draws what is running, and what has succeeded or failed, in colour. `format`: "svg" or "png".
/// Returns the content of the file. Throws base::Error for another format, and for a PNG so large
/// that its texts could not be read.
std::string draw_graphs(const GraphLayout& layout, const GraphLights& lights,
                        const std::string& title, const std::string& format);

/// A part of the same as pixels, like screen_chart(): from this corner of the layout on, with
/// `zoom` pixels for a unit. The style may also have "running", "within" (a frame around it),
/// "success" and "failure".
std::vector<std::uint32_t> screen_graphs(const GraphLayout& layout, const GraphLights& lights,
                                         const Vector2& from, int width, int height, double zoom,
                                         const Style& style);

}  // namespace elsie::picture
