#include "graph_news.h"

#include <algorithm>
#include <utility>

#include "elsie/recording/graph_json.h"

#include "messages.h"

namespace elsie::recording {

using simulation::LitGraph;

GraphNews::Messages GraphNews::take(std::vector<LitGraph> now, std::uint64_t time_ns) {
  const bool are_known = std::equal(
      now.begin(), now.end(), last_.begin(), last_.end(),
      [](const LitGraph& a, const LitGraph& b) { return a.path == b.path && a.graph == b.graph; });
  const bool are_lit_alike = are_known && std::equal(now.begin(), now.end(), last_.begin(),
                                                     [](const LitGraph& a, const LitGraph& b) {
                                                       return a.lights == b.lights;
                                                     });
  Messages messages;
  if (!are_known) {
    messages.graphs = Json{{"timestamp", time_json(time_ns)}, {"graphs", Json::array()}};
    for (const LitGraph& each : now) {
      (*messages.graphs)["graphs"].push_back(graph_json(each.path, each.plugin, each.graph));
    }
  }
  if (!are_lit_alike && !now.empty()) {
    messages.lights = Json{{"timestamp", time_json(time_ns)}, {"graphs", Json::array()}};
    for (const LitGraph& each : now) {
      Json& lights = (*messages.lights)["graphs"].emplace_back(Json{{"path", each.path}});
      add_lights(each.lights, lights);
    }
  }
  last_ = std::move(now);
  return messages;
}

}  // namespace elsie::recording
