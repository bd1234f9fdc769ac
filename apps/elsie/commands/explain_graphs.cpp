// Where coordinators were in their graphs.
#include <algorithm>

#include "elsie/base/words.h"
#include "elsie/process/text_table.h"
#include "elsie/traces/graph_account.h"

#include "explain_report.h"

namespace elsie::program {

using traces::Lit;
using traces::NodeAccount;
using traces::TraceGraph;

traces::TimeSpan presence(const TraceGraph& graph, const traces::TimeSpan& span) {
  if (graph.lights.empty()) return {span.to_s, span.to_s};
  return {std::max(graph.lights.front().time_s, span.from_s), std::min(graph.to_s, span.to_s)};
}

std::string graphs(const ExplainedRobot& explained) {
  std::string text;
  for (const TraceGraph& graph : explained.robot->graphs) {
    const traces::TimeSpan there = presence(graph, explained.account.span);
    if (!(there.from_s < there.to_s)) continue;
    const std::vector<NodeAccount> accounts = traces::account(graph, there);
    const std::vector<int> depths = traces::depths(graph.graph);
    const auto counts = [&](Lit NodeAccount::*lit) {
      return std::any_of(accounts.begin(), accounts.end(),
                         [&](const NodeAccount& each) { return (each.*lit).times > 0; });
    };
    const bool ends = counts(&NodeAccount::success) || counts(&NodeAccount::failure);
    std::vector<std::vector<std::string>> rows{{"  node", "running", "of the time", "times"}};
    if (ends) rows[0].insert(rows[0].end(), {"success", "failure"});
    constexpr std::size_t kMost = 50;  // of more, those that were never lit are left out
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < accounts.size(); ++i) {
      const NodeAccount& node = accounts[i];
      if (accounts.size() > kMost && !node.was_lit()) {
        ++left_out;
        continue;
      }
      std::vector<std::string> row{
          std::string(2 + 2 * index_of(depths[i]), ' ') + graph.graph.nodes[i].label,
          seconds(node.running.time_s) + " s",
          per_cent(node.running.time_s, there.to_s - there.from_s),
          std::to_string(node.running.times)};
      if (ends) {
        row.push_back(std::to_string(node.success.times));
        row.push_back(std::to_string(node.failure.times));
      }
      rows.push_back(std::move(row));
    }
    text += "\ngraph of " + graph.path + ", " + seconds(there.from_s) + " to " +
            seconds(there.to_s) + " s\n" + process::laid_out(rows, 1);
    if (left_out > 0) text += "  " + base::counted(left_out, "node") + " never reached\n";
  }
  return text;
}

}  // namespace elsie::program
