#include "elsie/recording/graph_json.h"

#include <string>
#include <utility>

#include "elsie/files/clean_text.h"

#include "format.h"
#include "reading.h"

namespace elsie::recording {
namespace {

constexpr std::pair<NodeState, const char*> kStates[] = {{NodeState::running, "running"},
                                                         {NodeState::success, "success"},
                                                         {NodeState::failure, "failure"}};

std::size_t index_below(const Json& index, std::size_t count) {
  const auto value = index.get<long long>();
  if (value < 0 || static_cast<std::size_t>(value) >= count) {
    throw Unexpected("its graph has no node " + std::to_string(value) +
                     " where one is expected; there are " + std::to_string(count));
  }
  return static_cast<std::size_t>(value);
}

}  // namespace

Json graph_json(std::string_view path, std::string_view plugin, const Graph& graph) {
  Json json{{"path", path}, {"plugin", plugin}};
  Json& nodes = json["nodes"] = Json::array();
  for (const Graph::Node& node : graph.nodes) {
    nodes.push_back({{"label", node.label}});
    if (node.within >= 0) nodes.back()["within"] = node.within;
  }
  Json& edges = json["edges"] = Json::array();
  for (const Graph::Edge& edge : graph.edges) {
    edges.push_back({{"from", edge.from}, {"to", edge.to}});
    if (!edge.label.empty()) edges.back()["label"] = edge.label;
  }
  return json;
}

void add_lights(const std::vector<NodeState>& lights, Json& json) {
  json["running"] = Json::array();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    for (const auto& [state, name] : kStates) {
      if (lights[i] == state) json[name].push_back(i);
    }
  }
}

Graph graph_of(const Json& json) {
  Graph graph;
  for (const Json& node : json.at("nodes")) {
    const auto within = node.find("within");
    // A node comes after the one around it.
    const int around =
        within == node.end() ? -1 : static_cast<int>(index_below(*within, graph.nodes.size()));
    graph.nodes.push_back({files::one_line(node.at("label").get<std::string>()), around});
  }
  for (const Json& edge : json.at("edges")) {
    graph.edges.push_back({index_below(edge.at("from"), graph.nodes.size()),
                           index_below(edge.at("to"), graph.nodes.size()),
                           files::one_line(edge.value("label", ""))});
  }
  return graph;
}

std::vector<NodeState> lights_of(const Json& json, std::size_t nodes) {
  std::vector<NodeState> lights(nodes);
  for (const auto& [state, name] : kStates) {
    const auto listed = json.find(name);
    if (listed == json.end()) continue;
    for (const Json& index : *listed) lights[index_below(index, nodes)] = state;
  }
  return lights;
}

}  // namespace elsie::recording
