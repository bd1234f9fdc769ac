// The graphs of coordinators as JSON, in recordings and sessions.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/api/graph.h"

namespace elsie::recording {

/// `path`, `plugin`; `nodes`, each with its `label` and, if there is a node around it, the index of
/// that as `within`; `edges`, each with `from` and `to`, indices of nodes, and its `label`, if it
/// has one.
nlohmann::ordered_json graph_json(std::string_view path, std::string_view plugin,
                                  const Graph& graph);
/// Adds what its nodes are: `running`, and `success` and `failure` if any are. Each is a list of
/// indices.
void add_lights(const std::vector<NodeState>& lights, nlohmann::ordered_json& json);

/// Reads these. Both throw nlohmann::json::exception, or std::runtime_error for an index of no
/// node.
Graph graph_of(const nlohmann::ordered_json& json);
std::vector<NodeState> lights_of(const nlohmann::ordered_json& json, std::size_t nodes);

}  // namespace elsie::recording
