// Coordinators' graphs in recordings.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/api/coordinator.h"
#include "elsie/recording/graph_json.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

/// Two states in a frame, in turn for 0.2 s each.
class Turning final : public Coordinator {
 public:
  static inline bool fails = false;

  Motion coordinate(std::span<Member> members, const Perception& now) override {
    for (Member& member : members) member.respond();
    is_second_ = static_cast<int>(now.time_s() / 0.2 + 1e-9) % 2 == 1;
    return {0.1, 0.0, 0.0};
  }
  Graph graph() const override {
    if (fails) throw std::runtime_error("it has no plan");
    return {{{"both"}, {"first", 0}, {"second", 0}}, {{1, 2, "after"}, {2, 1}}};
  }
  void light(std::span<NodeState> nodes) const override {
    nodes[0] = NodeState::running;
    nodes[is_second_ ? 2 : 1] = is_second_ ? NodeState::success : NodeState::running;
  }

 private:
  bool is_second_ = false;
};

const plugin::Host& turning() {
  static const plugin::Host host = [] {
    plugin::Host made{shipped_directory()};
    made.add(declaration_of(PluginKind::coordinator, "turning",
                            [] { return std::make_unique<Turning>(); }));
    return made;
  }();
  return host;
}

/// "r1" has the coordinator, "r2" one without a graph.
world::World of_both() {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("wander")));
  world.robots[0].coordinator->plugin = world.robots[0].coordinator->id = "turning";
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.limits.time = 1;
  return world;
}

using Names = std::vector<std::string>;

/// The labels of the nodes that are listed.
Names labels(const nlohmann::json& graph, const nlohmann::json& listed) {
  Names names;
  for (const auto& index : listed)
    names.push_back(graph["nodes"][index.get<std::size_t>()]["label"]);
  return names;
}

}  // namespace

TEST_CASE("A recording has a graph once, and what is lit in each decision where that changed") {
  const RecordedFile file(of_both(), turning());
  const auto all = recorded(file.path);
  const auto& graphs = all.at("/robots/r1/graphs");
  REQUIRE(graphs.size() == 1);
  CHECK(graphs[0].time_ns == 0);
  REQUIRE(graphs[0].content["graphs"].size() == 1);
  const auto& graph = graphs[0].content["graphs"][0];
  CHECK(graph["path"] == "turning");
  CHECK(graph["plugin"] == "turning");
  CHECK(graph["nodes"][0] == nlohmann::json{{"label", "both"}});
  CHECK(graph["nodes"][2] == nlohmann::json{{"label", "second"}, {"within", 0}});
  CHECK(graph["edges"][0] == nlohmann::json{{"from", 1}, {"to", 2}, {"label", "after"}});
  CHECK(graph["edges"][1] == nlohmann::json{{"from", 2}, {"to", 1}});

  const auto& lights = all.at("/robots/r1/lit");
  REQUIRE(lights.size() == 5);  // at 0, 0.2, 0.4, 0.6 and 0.8 s
  for (std::size_t i = 0; i < lights.size(); ++i) {
    CAPTURE(i);
    CHECK(lights[i].time_s() == Approx(0.2 * static_cast<double>(i)));
    CHECK(lights[i].timestamp_s() == lights[i].time_s());
    const auto& lit = lights[i].content["graphs"][0];
    CHECK(lit["path"] == "turning");
    CHECK(labels(graph, lit["running"]) == (i % 2 == 0 ? Names{"both", "first"} : Names{"both"}));
    CHECK(lit.contains("success") == (i % 2 == 1));
  }
}

TEST_CASE("A robot whose coordinator has no graph has no channels for one") {
  const RecordedFile file(of_both(), turning());
  const auto all = recorded(file.path);
  CHECK_FALSE(all.contains("/robots/r2/graphs"));
  CHECK_FALSE(all.contains("/robots/r2/lit"));
}

TEST_CASE("The same run is recorded with its graphs and not recorded, bit for bit") {
  const RecordedFile file(of_both(), turning());
  CHECK(file.result.state_hash == Simulation(of_both(), turning()).run().state_hash);
}

TEST_CASE("A trace has the graphs with what was lit when") {
  const RecordedFile file(of_both(), turning());
  const traces::Trace trace = recording::read_trace(file.path);
  CHECK(trace.robots[1].graphs.empty());
  REQUIRE(trace.robots[0].graphs.size() == 1);
  const traces::TraceGraph& graph = trace.robots[0].graphs[0];
  CHECK(graph.path == "turning");
  CHECK(graph.graph == Turning().graph());
  CHECK(std::isinf(graph.to_s));
  REQUIRE(graph.lights.size() == 5);
  CHECK(graph.lights[1].time_s == Approx(0.2));
  CHECK(graph.lights[1].nodes ==
        std::vector{NodeState::running, NodeState::dark, NodeState::success});
}

TEST_CASE("A recorded run has the graphs as they were lit at a time") {
  const RecordedFile file(of_both(), turning());
  const auto at = [&](double time_s) {
    const auto run = recording::read_recorded_run(file.path, time_s);
    REQUIRE(run.graphs.size() == 1);
    const recording::RecordedGraphs& shown = run.graphs.at("r1");
    REQUIRE(shown.graphs.size() == 1);
    CHECK(shown.graphs[0] == picture::NamedGraph{"turning", Turning().graph()});
    return shown.lights.at(0);
  };
  CHECK(at(0.1)[1] == NodeState::running);
  CHECK(at(0.3)[1] == NodeState::dark);
  CHECK(at(0.3)[2] == NodeState::success);
}

TEST_CASE("A graph that an edit changes is there again from then on") {
  McapFile file;
  Simulation simulation(shipped_world("fetch.xml", 4), shipped());
  {
    const auto recorder = recording::mcap_recorder(file.path);
    simulation::Observer* const observers[] = {recorder.get()};
    const simulation::TimedEdit changes[] = {
        {1.0, {"robot[r1]/coordinator/state[2]/transition/@after", "5"}},
        {2.0, {"robot[r1]/coordinator/state[+]", R"(<state name="more"/>)"}}};
    simulation.run(observers, changes);
  }
  auto all = recorded(file.path);
  const auto& graphs = all["/robots/r1/graphs"];
  REQUIRE(graphs.size() == 3);
  CHECK(graphs[1].time_s() == Approx(1.0));
  CHECK(graphs[2].time_s() == Approx(2.0));
  CHECK(graphs[2].content["graphs"][0]["nodes"].size() == 9);

  const traces::Trace trace = recording::read_trace(file.path);
  std::vector<traces::TraceGraph> read;
  for (const traces::TraceRobot& robot : trace.robots) {
    read.insert(read.end(), robot.graphs.begin(), robot.graphs.end());
  }
  REQUIRE(read.size() == 3);
  CHECK(read[0].to_s == Approx(1.0));
  CHECK(read[1].lights.front().time_s == Approx(1.0));
  CHECK(read[1].to_s == Approx(2.0));
  CHECK(std::isinf(read[2].to_s));
}

TEST_CASE("What is lit in a trace is what was lit in each decision of the run") {
  const std::string name = GENERATE("fetch.xml", "guard.xml");
  struct Watch final : simulation::Observer {
    void stepped(const Simulation& simulation) override {
      if (simulation.decided()) seen.push_back(simulation.graphs(0)[0].lights);
    }
    std::vector<std::vector<NodeState>> seen;
  } watch;
  McapFile file;
  Simulation simulation(shipped_world(name, 30), shipped());
  {
    const auto recorder = recording::mcap_recorder(file.path);
    simulation::Observer* const observers[] = {recorder.get(), &watch};
    simulation.run(observers);
  }
  const traces::Trace trace = recording::read_trace(file.path);
  const traces::TraceGraph& graph = trace.robots[0].graphs.at(0);
  CHECK(graph.lights.size() > 2);
  std::size_t next = 0;
  for (std::size_t i = 0; i < watch.seen.size(); ++i) {
    const double time_s = trace.period_s * static_cast<double>(i);
    while (next + 1 < graph.lights.size() && graph.lights[next + 1].time_s < time_s + 1e-6) ++next;
    REQUIRE(graph.lights[next].nodes == watch.seen[i]);
  }
}

TEST_CASE("A recording lacks the graph of a plugin that fails to show it, and says so once") {
  Simulation simulation(of_both(), turning());
  McapFile file;
  std::vector<std::string> warnings;
  recording::RecorderOptions options;
  options.warn = [&](const std::string& text) { warnings.push_back(text); };
  Turning::fails = true;
  record(simulation, file.path, options);
  Turning::fails = false;
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Contains("the recording lacks graphs") &&
                              Catch::Contains("'turning'") && Catch::Contains("it has no plan"));
  CHECK_FALSE(recorded(file.path).contains("/robots/r1/graphs"));
}

TEST_CASE("A graph of nodes that are not there is refused in a sentence") {
  using Json = nlohmann::ordered_json;
  const auto says = [](const char* text, const char* problem) {
    CHECK_THROWS_WITH(recording::graph_of(Json::parse(text)), Catch::Contains(problem));
  };
  says(R"({"nodes": [{"label": "a", "within": 0}], "edges": []})", "no node 0");
  says(R"({"nodes": [{"label": "a"}], "edges": [{"from": 0, "to": 1}]})", "no node 1");
  says(R"({"nodes": [{"label": "a"}], "edges": [{"from": -1, "to": 0}]})", "no node -1");
  says(R"({"nodes": [{"label": 3}], "edges": []})", "must be string");
  says(R"({"edges": []})", "'nodes' not found");
  CHECK_THROWS_WITH(recording::lights_of(Json::parse(R"({"running": [2]})"), 2),
                    Catch::Contains("no node 2"));
}
