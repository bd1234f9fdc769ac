#include <nlohmann/json.hpp>

#include "elsie/traces/graph_account.h"

#include "explain_report.h"

namespace elsie::program {

namespace {

using traces::Trace;
using traces::TraceRobot;
using Json = nlohmann::ordered_json;

/// Rounds a sum of times, which has rounding errors that nobody wants to read.
double tidy(double value) {
  constexpr double kDecimals = 1e6;
  return std::abs(value) < 1e9 ? std::round(value * kDecimals) / kDecimals : value;
}

Json member(const TraceRobot& robot, std::size_t index, const traces::MemberAccount& account) {
  const auto& traced = robot.members[index];
  Json object{{"path", traced.path},
              {"plugin", traced.plugin},
              {"coordinator", traced.coordinator},
              {"priority", traced.priority},
              {"decided_s", tidy(account.decided_s)},
              {"turns", account.periods},
              {"longest_s", tidy(account.longest_s)},
              {"longest_at_s", tidy(account.longest_at_s)},
              {"asked_s", tidy(account.asked_s)},
              {"share", tidy(account.share)},
              {"robot_share", tidy(account.robot_share)},
              {"weight",
               {{"mean", tidy(account.weight)},
                {"least", account.least_weight},
                {"largest", account.largest_weight}}},
              {"activation", tidy(account.activation)},
              {"strength", tidy(account.strength)}};
  object["silenced"] = Json::array();
  for (const auto& inhibition : account.inhibited) {
    object["silenced"].push_back({{"by", robot.members[index_of(inhibition.by)].path},
                                  {"times", inhibition.times},
                                  {"time_s", tidy(inhibition.time_s)}});
  }
  if (traced.times.answers > 0) {
    object["took"] = {{"answers", traced.times.answers},
                      {"mean_s", traced.times.mean_s},
                      {"longest_s", traced.times.longest_s}};
  }
  return object;
}

Json episode(const Trace& trace, const TraceRobot& robot, const traces::Episode& shown) {
  const auto& part = shown.parts[0];
  Json object{{"from_s", tidy(shown.from_s)}, {"to_s", tidy(shown.to_s)}};
  if (part.decider >= 0) {
    object["decider"] = robot.members[index_of(part.decider)].path;
    object["share"] = tidy(part.share);
    object["weight"] = tidy(part.weight);
    object["began"] = trace.reasons[part.first_reason];
    object["reason"] = trace.reasons[part.reason];
  } else {
    object["decider"] = nullptr;
    object["why"] = part.decider == traces::kNobody     ? "nobody"
                    : part.decider == traces::kTogether ? "several"
                                                        : "not asked";
  }
  return object;
}

Json coordinator(const Trace& trace, const TraceRobot& robot,
                 const traces::CoordinatorAccount& account) {
  Json object{{"inside", account.parent >= 0 ? Json(robot.members[index_of(account.parent)].path)
                                             : Json(nullptr)},
              {"coordinator", account.coordinator},
              {"asked_s", tidy(account.asked_s)},
              {"nobody_s", tidy(account.nobody_s)},
              {"several_s", tidy(account.together_s)},
              {"changes", account.switches}};
  object["episodes"] = Json::array();
  for (const auto& shown : account.episodes) {
    object["episodes"].push_back(episode(trace, robot, shown));
  }
  return object;
}

Json published(const traces::TraceNumber& number, const NumberAccount& account) {
  const auto if_any = [&](double value) {
    return account.samples > 0 ? Json(tidy(value)) : Json(nullptr);
  };
  return {{"path", number.path},
          {"name", number.name},
          {"unit", number.unit},
          {"samples", account.samples},
          {"mean", if_any(account.mean)},
          {"least", if_any(account.least)},
          {"largest", if_any(account.largest)},
          {"last", if_any(account.last)}};
}

Json lit_graph(const traces::TraceGraph& graph, const traces::TimeSpan& there) {
  Json nodes = Json::array();
  const std::vector<traces::NodeAccount> accounts = traces::account(graph, there);
  for (std::size_t i = 0; i < accounts.size(); ++i) {
    const Graph::Node& node = graph.graph.nodes[i];
    nodes.push_back(
        {{"label", node.label}, {"within", node.within >= 0 ? Json(node.within) : Json(nullptr)}});
    for (const auto& [name, lit] : {std::pair("running", accounts[i].running),
                                    {"success", accounts[i].success},
                                    {"failure", accounts[i].failure}}) {
      nodes.back()[name] = {{"time_s", tidy(lit.time_s)}, {"times", lit.times}};
    }
  }
  return {{"path", graph.path},
          {"plugin", graph.plugin},
          {"from_s", tidy(there.from_s)},
          {"to_s", tidy(there.to_s)},
          {"nodes", std::move(nodes)}};
}

}  // namespace

std::string json(const Trace& trace, const traces::TimeSpan& span,
                 const std::vector<ExplainedRobot>& robots) {
  Json object{{"world", trace.world},   {"file", trace.world_file},   {"seed", trace.seed},
              {"step_s", trace.step_s}, {"period_s", trace.period_s}, {"end_s", trace.end_s}};
  object["outcome"] = trace.outcome.empty() ? Json(nullptr) : Json(trace.outcome);
  object["reason"] = trace.outcome_reason;
  object["cut_off"] = trace.cut_off;
  object["from_s"] = tidy(span.from_s);
  object["to_s"] = tidy(span.to_s);
  object["without_decisions"] = trace.without_decisions.size();
  object["robots"] = Json::array();
  for (const ExplainedRobot& explained : robots) {
    const TraceRobot& robot = *explained.robot;
    Json entry{{"id", robot.id}, {"team", robot.team}, {"coordinator", robot.coordinator}};
    entry["from_s"] = tidy(explained.account.span.from_s);
    entry["to_s"] = tidy(explained.account.span.to_s);
    entry["behaviors"] = Json::array();
    for (std::size_t i = 0; i < robot.members.size(); ++i) {
      entry["behaviors"].push_back(member(robot, i, explained.account.members[i]));
    }
    entry["coordinators"] = Json::array();
    for (const auto& account : explained.account.coordinators) {
      entry["coordinators"].push_back(coordinator(trace, robot, account));
    }
    entry["numbers"] = Json::array();
    for (const auto& number : robot.numbers) {
      entry["numbers"].push_back(published(number, account(number, explained.account.span)));
    }
    for (const traces::TraceGraph& graph : robot.graphs) {
      const traces::TimeSpan there = presence(graph, explained.account.span);
      if (there.from_s < there.to_s) entry["graphs"].push_back(lit_graph(graph, there));
    }
    for (const traces::TraceActuator& actuator : robot.actuators) {
      Json by = Json::array();
      for (const Commander& each : commanders(actuator, explained.account.span)) {
        by.push_back({{"behavior", each.by},
                      {"time_s", tidy(each.time_s)},
                      {"last", each.last->text},
                      {"last_from_s", tidy(each.last->time_s)}});
      }
      if (by.empty()) continue;  // it was there at another time
      const traces::TimeSpan there = presence(actuator, explained.account.span);
      entry["actuators"].push_back({{"id", actuator.id},
                                    {"from_s", tidy(there.from_s)},
                                    {"to_s", tidy(there.to_s)},
                                    {"by", std::move(by)}});
    }
    for (const traces::TraceHeard& heard : robot.heard) {
      if (heard.time_s < span.from_s || heard.time_s > span.to_s) continue;
      entry["heard"].push_back({{"time_s", heard.time_s},
                                {"by", heard.device},
                                {"from", heard.from},
                                {"kind", heard.kind},
                                {"message", heard.text}});
    }
    entry["events"] = Json::array();
    for (const auto& event : robot.events) {
      if (event.time_s >= span.from_s && event.time_s <= span.to_s) {
        entry["events"].push_back(
            {{"time_s", event.time_s}, {"name", event.name}, {"detail", event.detail}});
      }
    }
    object["robots"].push_back(std::move(entry));
  }
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace elsie::program
