// Where a coordinator was in its graph: sums over a part of a run.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "elsie/traces/trace.h"
#include "elsie/traces/trace_account.h"

namespace elsie::traces {

/// Calls `see` for the times of the span in which the lights stay the same, in order.
void walk(const TraceGraph& graph, const TimeSpan& span,
          const std::function<void(const TimeSpan&, std::span<const NodeState>)>& see);

/// How long and how often a node was something. Two stretches without a pause are one.
struct Lit {
  double time_s = 0.0;
  int times = 0;
};
struct NodeAccount {
  Lit running, success, failure;

  bool was_lit() const { return running.times + success.times + failure.times > 0; }
};

/// One for each node.
std::vector<NodeAccount> account(const TraceGraph& graph, const TimeSpan& span);

/// Whether one edge, without a label, leads to each node but the first, from one before it. Other
/// graphs are states and ways between them.
bool is_tree(const Graph& graph);

/// How deep each node stands: the nodes around it or, in a tree, above it.
std::vector<int> depths(const Graph& graph);

}  // namespace elsie::traces
