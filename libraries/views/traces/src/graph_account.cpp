#include "elsie/traces/graph_account.h"

#include <algorithm>

namespace elsie::traces {

void walk(const TraceGraph& graph, const TimeSpan& span,
          const std::function<void(const TimeSpan&, std::span<const NodeState>)>& see) {
  for (std::size_t i = 0; i < graph.lights.size(); ++i) {
    const double end_s = i + 1 < graph.lights.size() ? graph.lights[i + 1].time_s : graph.to_s;
    const TimeSpan part{std::max(graph.lights[i].time_s, span.from_s), std::min(end_s, span.to_s)};
    if (part.from_s < part.to_s) see(part, graph.lights[i].nodes);
  }
}

std::vector<NodeAccount> account(const TraceGraph& graph, const TimeSpan& span) {
  std::vector<NodeAccount> accounts(graph.graph.nodes.size());
  std::vector<NodeState> before(accounts.size());
  walk(graph, span, [&](const TimeSpan& part, std::span<const NodeState> nodes) {
    for (std::size_t i = 0; i < accounts.size(); ++i) {
      Lit* const lit = nodes[i] == NodeState::running   ? &accounts[i].running
                       : nodes[i] == NodeState::success ? &accounts[i].success
                       : nodes[i] == NodeState::failure ? &accounts[i].failure
                                                        : nullptr;
      if (lit) {
        lit->time_s += part.to_s - part.from_s;
        lit->times += nodes[i] != before[i] ? 1 : 0;
      }
      before[i] = nodes[i];
    }
  });
  return accounts;
}

bool is_tree(const Graph& graph) {
  std::vector<bool> is_below(graph.nodes.size());
  for (const Graph::Edge& edge : graph.edges) {
    if (edge.from >= edge.to || is_below[edge.to] || !edge.label.empty()) return false;
    is_below[edge.to] = true;
  }
  return graph.edges.size() + 1 == graph.nodes.size() &&
         std::all_of(graph.nodes.begin(), graph.nodes.end(),
                     [](const Graph::Node& node) { return node.within < 0; });
}

std::vector<int> depths(const Graph& graph) {
  std::vector<int> above;
  for (const Graph::Node& node : graph.nodes) above.push_back(node.within);
  if (is_tree(graph)) {
    for (const Graph::Edge& edge : graph.edges) above[edge.to] = static_cast<int>(edge.from);
  }
  std::vector<int> depths;
  for (const int node : above) {
    depths.push_back(node < 0 ? 0 : depths[static_cast<std::size_t>(node)] + 1);
  }
  return depths;
}

}  // namespace elsie::traces
