#include <memory>
#include <utility>

#include <graphviz/cgraph.h>
#include <graphviz/gvc.h>

#include "elsie/base/error.h"
#include "elsie/picture/graph_picture.h"
#include "elsie/traces/graph_account.h"

#include "graph_room.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr const char* kGraphFont = "DejaVu Sans";
constexpr double kPoints = 72.0;  // in an inch

/// Words as they are: Graphviz takes a backslash for an escape.
std::string literal(const std::string& words) {
  std::string text;
  for (const char c : words) text += c == '\\' ? std::string("\\\\") : std::string(1, c);
  return text;
}

// Graphviz takes texts that it does not change as char*.
char* text(const std::string& words) { return const_cast<char*>(words.c_str()); }
void set(void* object, const char* name, const std::string& value) {
  agsafeset(object, const_cast<char*>(name), text(value), const_cast<char*>(""));
}

/// One graph, for Graphviz. Nodes that hold others are frames, which no edge can reach: it ends at
/// a node inside, and is cut off at the frame.
class GraphSheet {
 public:
  GraphSheet(const NamedGraph& named, Agraph_t* page, std::size_t number, bool is_framed)
      : graph_(named.graph),
        path_(named.path),
        number_(number),
        prefix_(std::to_string(number) + "."),
        holds_(graph_.nodes.size()),
        frames_(graph_.nodes.size()),
        nodes_(graph_.nodes.size()) {
    if (is_framed) {
      page = agsubg(page, text("cluster" + std::to_string(number)), 1);
      whole_ = page;
      label(page, path_);
    }
    for (const Graph::Node& node : graph_.nodes) {
      if (node.within >= 0) holds_[static_cast<std::size_t>(node.within)] = true;
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_node(i, page);
    entries_ = nodes_;
    if (!traces::is_tree(graph_)) add_dots(page);
    for (const Graph::Edge& edge : graph_.edges) add_edge(edge, page);
    for (const Dot& dot : dots_) add_way_from(dot, page);
  }

  /// After the layout: adds what Graphviz has found.
  void read(GraphLayout& layout) const {
    if (whole_) layout.boxes.push_back(frame(whole_, std::nullopt, layout.height));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      layout.boxes.push_back(holds_[i] ? frame(frames_[i], i, layout.height)
                                       : box(nodes_[i], i, layout.height));
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) read_edge(i, layout);
    for (const Dot& dot : dots_) layout.dots.push_back(at(ND_coord(dot.made), layout.height));
  }

 private:
  /// With an edge to the state in which the whole, or a frame, begins.
  struct Dot {
    Agnode_t* made;
    std::size_t first;
  };

  /// On a node, or on the frame of the graph.
  std::string words_of(std::optional<std::size_t> node) const {
    return clean_text(node ? graph_.nodes[*node].label : path_);
  }
  static void label(void* object, const std::string& words) {
    set(object, "label", literal(clean_text(words)));
  }

  void add_node(std::size_t i, Agraph_t* page) {
    const Graph::Node& node = graph_.nodes[i];
    Agraph_t* const around =
        node.within < 0 ? page : frames_[static_cast<std::size_t>(node.within)];
    if (holds_[i]) {
      frames_[i] = agsubg(around, text(frame_name(i)), 1);
      label(frames_[i], node.label);
      return;
    }
    nodes_[i] = agnode(around, text(prefix_ + std::to_string(i)), 1);
    label(nodes_[i], node.label);
  }

  std::string frame_name(std::size_t i) const { return "cluster" + prefix_ + std::to_string(i); }

  /// The first node in a frame, or the node itself.
  std::size_t representative(std::size_t i) const {
    while (holds_[i]) {
      std::size_t inner = i + 1;
      while (graph_.nodes[inner].within != static_cast<int>(i)) ++inner;
      i = inner;
    }
    return i;
  }
  bool is_inside(std::size_t inner, std::size_t frame) const {
    int i = static_cast<int>(inner);
    while (i >= 0 && i != static_cast<int>(frame)) {
      i = graph_.nodes[static_cast<std::size_t>(i)].within;
    }
    return i >= 0;
  }

  void add_edge(const Graph::Edge& edge, Agraph_t* page) {
    Agedge_t* const made =
        agedge(page, nodes_[representative(edge.from)], entries_[edge.to], nullptr, 1);
    edges_.push_back(made);
    if (!edge.label.empty()) set(made, "label", " " + literal(clean_text(edge.label)) + " ");
    // An edge between a frame and something in it is not cut off.
    if (holds_[edge.from] && !is_inside(edge.to, edge.from)) {
      set(made, "ltail", frame_name(edge.from));
    }
    if (holds_[edge.to] && !is_inside(edge.from, edge.to)) set(made, "lhead", frame_name(edge.to));
  }

  /// One for the first state, and one for the first in each frame.
  void add_dots(Agraph_t* page) {
    std::vector<bool> has_one(graph_.nodes.size() + 1);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const int within = graph_.nodes[i].within;
      const std::size_t around = within < 0 ? 0 : static_cast<std::size_t>(within) + 1;
      if (has_one[around]) continue;
      has_one[around] = true;
      Agraph_t* const sheet = around == 0 ? page : frames_[around - 1];
      Agnode_t* const dot = agnode(sheet, text("dot" + prefix_ + std::to_string(around)), 1);
      const std::string size = std::to_string(2 * kGraphDot / kPoints);
      set(dot, "shape", "circle");
      set(dot, "fixedsize", "true");
      set(dot, "width", size);
      set(dot, "height", size);
      set(dot, "label", "");
      if (around > 0) entries_[around - 1] = dot;
      dots_.push_back({dot, i});
    }
  }
  void add_way_from(const Dot& dot, Agraph_t* page) {
    edges_.push_back(agedge(page, dot.made, entries_[dot.first], nullptr, 1));
    if (holds_[dot.first]) set(edges_.back(), "lhead", frame_name(dot.first));
  }

  // Graphviz' y goes up.
  static Vector2 at(const pointf& point, double height) { return {point.x, height - point.y}; }
  static GraphLayout::Label placed(const std::string& words, const textlabel_t& label,
                                   double height) {
    return {words, at(label.pos, height), {label.dimen.x, label.dimen.y}};
  }

  GraphLayout::Box frame(Agraph_t* made, std::optional<std::size_t> node, double height) const {
    const boxf& box = GD_bb(made);
    const textlabel_t* const label = GD_label(made);
    return {at({box.LL.x, box.UR.y}, height),
            at({box.UR.x, box.LL.y}, height),
            label ? placed(words_of(node), *label, height) : GraphLayout::Label{words_of(node), {}},
            number_,
            node,
            true};
  }
  GraphLayout::Box box(Agnode_t* made, std::size_t node, double height) const {
    const Vector2 middle = at(ND_coord(made), height);
    const double across = kPoints * ND_width(made) / 2, down = kPoints * ND_height(made) / 2;
    return {{middle.x - across, middle.y - down},
            {middle.x + across, middle.y + down},
            {words_of(node), middle},
            number_,
            node,
            false};
  }
  void read_edge(std::size_t edge, GraphLayout& layout) const {
    const splines* const found = ED_spl(edges_[edge]);
    for (int i = 0; found && i < found->size; ++i) {
      const bezier& drawn = found->list[i];
      GraphLayout::Arrow arrow;
      for (int k = 0; k < drawn.size; ++k) {
        arrow.curve.push_back(at(drawn.list[k], layout.height));
      }
      arrow.tip = drawn.eflag ? at(drawn.ep, layout.height) : arrow.curve.back();
      const textlabel_t* const label =
          edge < graph_.edges.size() ? ED_label(edges_[edge]) : nullptr;
      if (label && i == 0) {
        arrow.label = placed(clean_text(graph_.edges[edge].label), *label, layout.height);
      }
      layout.arrows.push_back(std::move(arrow));
    }
  }

  const Graph& graph_;
  const std::string& path_;
  std::size_t number_;
  std::string prefix_;
  std::vector<bool> holds_;
  Agraph_t* whole_ = nullptr;  // the frame of the graph
  std::vector<Agraph_t*> frames_;
  std::vector<Agnode_t*> nodes_;
  std::vector<Agnode_t*> entries_;  // where edges to a node end: to a frame, at the dot in it
  std::vector<Dot> dots_;
  std::vector<Agedge_t*> edges_;  // those of the graph, then those from the dots
};

void set_defaults(Agraph_t* page) {
  const auto by_default = [page](int kind, const char* name, const std::string& value) {
    agattr(page, kind, const_cast<char*>(name), text(value));
  };
  by_default(AGRAPH, "label", "");
  by_default(AGRAPH, "compound", "true");
  by_default(AGRAPH, "fontname", kGraphFont);
  by_default(AGRAPH, "fontsize", "12");
  by_default(AGRAPH, "ranksep", "0.6");
  by_default(AGNODE, "shape", "box");
  by_default(AGNODE, "fontname", kGraphFont);
  by_default(AGNODE, "fontsize", "12");
  by_default(AGEDGE, "fontname", kGraphFont);
  by_default(AGEDGE, "fontsize", "10");
  by_default(AGEDGE, "label", "");
}

}  // namespace

void require_drawable(const std::vector<NamedGraph>& graphs) {
  std::size_t nodes = 0;
  for (const NamedGraph& each : graphs) nodes += each.graph.nodes.size();
  if (nodes > kMostGraphNodes) {
    throw base::Error("the graph has " + std::to_string(nodes) + " nodes, and at most " +
                          std::to_string(kMostGraphNodes) +
                          " are drawn; `elsie explain` lists those of a recorded run",
                      base::kBadInput);
  }
}

GraphLayout lay_out(const std::vector<NamedGraph>& graphs) {
  require_drawable(graphs);
  // One for the life of the process: Graphviz' plugin for texts keeps names of fonts that belong to
  // the first one, and reads them again after that is freed (seen in 2.43).
  static GVC_t* const context = gvContext();
  const std::unique_ptr<Agraph_t, int (*)(Agraph_t*)> page(
      agopen(text("coordinators"), Agdirected, nullptr), agclose);
  set_defaults(page.get());
  std::vector<GraphSheet> sheets;
  sheets.reserve(graphs.size());
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    sheets.emplace_back(graphs[i], page.get(), i, graphs.size() > 1);
  }
  if (gvLayout(context, page.get(), "dot") != 0) {
    throw base::Error("Graphviz cannot lay out this graph");
  }
  const boxf& all = GD_bb(page.get());
  GraphLayout layout;
  layout.width = all.UR.x;
  layout.height = all.UR.y;
  for (const GraphSheet& sheet : sheets) sheet.read(layout);
  // No gvFreeLayout(): with edges into frames Graphviz 2.42 frees something twice there.
  part_arrows(layout);
  free_labels(layout);
  return layout;
}

}  // namespace elsie::picture
