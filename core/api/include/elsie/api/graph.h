// How a coordinator shows what it is made of: states and the ways between them, or a tree. Views
// draw it, and light up where it is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace elsie {

struct Graph {
  struct Node {
    std::string label;
    int within = -1;  // index of the node around it, which comes first; -1: none

    bool operator==(const Node&) const = default;
  };
  struct Edge {
    std::size_t from = 0, to = 0;  // indices of nodes
    std::string label{};

    bool operator==(const Edge&) const = default;
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;

  bool operator==(const Graph&) const = default;
  bool empty() const { return nodes.empty(); }
};

/// What a node is in this control period.
enum class NodeState { dark, running, success, failure };

}  // namespace elsie
