#include "elsie/picture/graph_picture.h"

#include <memory>
#include <optional>

#include <graphviz/cgraph.h>
#include <graphviz/gvc.h>

#include "elsie/base/error.h"

namespace elsie::picture {
namespace {

using simulation::LitGraph;

constexpr const char* kGraphFont = "DejaVu Sans";

const char* fill_of(NodeState state) {
  switch (state) {
    case NodeState::running:
      return "#ffd966";
    case NodeState::success:
      return "#b6d7a8";
    case NodeState::failure:
      return "#f4b6ae";
    case NodeState::dark:
      break;
  }
  return "#fafafa";
}

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

/// Draws one graph. Nodes that hold others are frames, which no edge can reach: it ends at a node
/// inside, and is cut off at the frame.
class Drawing {
 public:
  Drawing(const LitGraph& lit, Agraph_t* page, std::size_t number)
      : lit_(lit), prefix_(std::to_string(number) + "."), holds_(lit.graph.nodes.size()) {
    for (const Graph::Node& node : lit.graph.nodes) {
      if (node.within >= 0) holds_[static_cast<std::size_t>(node.within)] = true;
    }
    frames_.resize(lit.graph.nodes.size());
    nodes_.resize(lit.graph.nodes.size());
    for (std::size_t i = 0; i < lit.graph.nodes.size(); ++i) add_node(i, page);
    for (const Graph::Edge& edge : lit.graph.edges) add_edge(edge, page);
  }

 private:
  void add_node(std::size_t i, Agraph_t* page) {
    const Graph::Node& node = lit_.graph.nodes[i];
    Agraph_t* const around =
        node.within < 0 ? page : frames_[static_cast<std::size_t>(node.within)];
    if (holds_[i]) {
      frames_[i] = agsubg(around, text("cluster" + prefix_ + std::to_string(i)), 1);
      set(frames_[i], "label", literal(node.label));
      set(frames_[i], "style", "rounded,filled");
      set(frames_[i], "fillcolor", lit_.lights[i] == NodeState::dark ? "#f2f2f2" : "#fff4d1");
      return;
    }
    nodes_[i] = agnode(around, text(prefix_ + std::to_string(i)), 1);
    set(nodes_[i], "label", literal(node.label));
    set(nodes_[i], "fillcolor", fill_of(lit_.lights[i]));
    set(nodes_[i], "penwidth", lit_.lights[i] == NodeState::running ? "2.5" : "1");
  }

  /// The first node in a frame, or the node itself.
  std::size_t representative(std::size_t i) const {
    while (holds_[i]) {
      std::size_t inner = i + 1;
      while (lit_.graph.nodes[inner].within != static_cast<int>(i)) ++inner;
      i = inner;
    }
    return i;
  }

  void add_edge(const Graph::Edge& edge, Agraph_t* page) {
    Agedge_t* const made = agedge(page, nodes_[representative(edge.from)],
                                  nodes_[representative(edge.to)], nullptr, 1);
    set(made, "label", edge.label.empty() ? "" : " " + literal(edge.label) + " ");
    if (holds_[edge.from]) set(made, "ltail", "cluster" + prefix_ + std::to_string(edge.from));
    if (holds_[edge.to]) set(made, "lhead", "cluster" + prefix_ + std::to_string(edge.to));
  }

  const LitGraph& lit_;
  std::string prefix_;
  std::vector<bool> holds_;
  std::vector<Agraph_t*> frames_;
  std::vector<Agnode_t*> nodes_;
};

void set_defaults(Agraph_t* page, const std::string& title) {
  const auto by_default = [page](int kind, const char* name, const std::string& value) {
    agattr(page, kind, const_cast<char*>(name), text(value));
  };
  by_default(AGRAPH, "label", literal(title));
  by_default(AGRAPH, "labelloc", "t");
  by_default(AGRAPH, "compound", "true");
  by_default(AGRAPH, "fontname", kGraphFont);
  by_default(AGRAPH, "bgcolor", "white");
  by_default(AGRAPH, "dpi", "144");
  by_default(AGRAPH, "ranksep", "0.6");
  by_default(AGNODE, "shape", "box");
  by_default(AGNODE, "style", "rounded,filled");
  by_default(AGNODE, "fontname", kGraphFont);
  by_default(AGNODE, "fontsize", "12");
  by_default(AGEDGE, "fontname", kGraphFont);
  by_default(AGEDGE, "fontsize", "10");
  by_default(AGEDGE, "color", "#606060");
}

}  // namespace

std::string draw_graphs(const std::vector<LitGraph>& graphs, const std::string& title,
                        const std::string& format) {
  // One for the life of the process: Graphviz' plugin for texts keeps names of fonts that belong to
  // the first one, and reads them again after that is freed (seen in 2.43).
  static GVC_t* const context = gvContext();
  const std::unique_ptr<Agraph_t, int (*)(Agraph_t*)> page(
      agopen(text("coordinators"), Agdirected, nullptr), agclose);
  set_defaults(page.get(), title);
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    Agraph_t* around = page.get();
    if (graphs.size() > 1) {
      around = agsubg(around, text("cluster" + std::to_string(i)), 1);
      set(around, "label", literal(graphs[i].path));
    }
    Drawing(graphs[i], around, i);
  }
  char* data = nullptr;
  unsigned int length = 0;
  std::string content;
  const bool is_laid_out = gvLayout(context, page.get(), "dot") == 0;
  if (is_laid_out && gvRenderData(context, page.get(), format.c_str(), &data, &length) == 0) {
    content.assign(data, length);
    gvFreeRenderData(data);
  }
  if (is_laid_out) gvFreeLayout(context, page.get());
  if (content.empty()) throw base::Error("Graphviz cannot draw this graph as " + format);
  return content;
}

}  // namespace elsie::picture
