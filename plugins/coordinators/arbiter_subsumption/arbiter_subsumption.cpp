// The subsumption architecture (Brooks, 1986): layers of behaviours, in which higher ones suppress
// or inhibit the signals of lower ones.
//
// Every layer has a line that carries its signal: its command while it is active. The line of the
// lowest layer leads to the motors. Links are nodes on the line of the layer that they act on:
//
//   suppress:  while the other layer's line carries a signal, that signal replaces this one
//   inhibit:   while the other layer's line carries a signal, this one is removed
//
// Several nodes on one line are in the order of the layers, with that of the highest one nearest to
// the motors.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/remember.h>
#include <elsie/base/near_name.h>
#include <elsie/base/words.h>

#include "winner.h"

namespace {

struct Link {
  std::string by;
  std::string of;
  double hold = 0.0;
};

class ArbiterSubsumption final : public WinnerTakesAll, public elsie::Remembers {
 public:
  double threshold = 0.0;
  double hold = 0.0;
  std::vector<Link> suppressions;
  std::vector<Link> inhibitions;

  void configured() override {
    if (!layers_.empty()) {
      wire();
    }
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception&) override {
    layers_.clear();
    prioritized_.clear();
    for (const elsie::Member& member : members) {
      layers_.emplace_back(member.name());
      if (member.priority() != 1.0) {
        prioritized_.emplace_back(member.name());
      }
    }
    wire();
  }

  std::vector<std::string> notes() const override {
    // Links lead downwards, so all lines below are decided before a layer's own line.
    std::vector<bool> leads(layers_.size(), false);
    std::vector<std::string> notes;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
      leads[layer] = layer == 0 || std::any_of(nodes_.begin(), nodes_.end(), [&](const Node& node) {
                       return node.by == layer && node.suppresses && leads[node.of];
                     });
      if (!leads[layer]) {
        notes.push_back("the command of layer '" + layers_[layer] +
                        "' never reaches the motors: it only inhibits, or suppresses what does not "
                        "reach them either");
      }
    }
    if (!prioritized_.empty()) {
      notes.push_back("the attribute 'priority' of " + elsie::base::joined(prioritized_) +
                      " has no effect: the order in the file decides which layer is higher");
    }
    return notes;
  }

  void reset(elsie::Random&) override {
    winner_.reset();
    for (Node& node : nodes_) {
      node.last.reset();
    }
  }
  void remember(elsie::Memory& memory) override;

  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception& now) override;

  void rate(std::span<elsie::Member> members, const elsie::Perception& now,
            const elsie::Motion& given, std::span<const elsie::Motion> candidates,
            std::span<double> desirability) override {
    if (held_) {
      Coordinator::rate(members, now, given, candidates, desirability);
    } else {
      WinnerTakesAll::rate(members, now, given, candidates, desirability);
    }
  }
  elsie::CommandSets command_sets(std::span<elsie::Member> members, const elsie::Perception& now,
                                  const elsie::Motion& given) override {
    return held_ ? Coordinator::command_sets(members, now, given)
                 : WinnerTakesAll::command_sets(members, now, given);
  }

 private:
  /// A signal on a line: a command and the layer that it comes from.
  struct Signal {
    elsie::Motion command;
    std::size_t source;
    bool held;  // the last signal of a source that is silent now
  };
  struct Node {
    std::size_t by;
    std::size_t of;
    bool suppresses;
    double hold;
    std::optional<Signal> last = {};  // the last signal of `by`, and its time
    double last_s = 0.0;
  };

  std::size_t layer_of(const char* element, const char* attribute, const std::string& name,
                       std::vector<std::string>& problems) const;
  void add(const char* element, const std::vector<Link>& links, std::vector<std::string>& problems);
  void wire();
  /// The signal that the node takes from the line of `by` now, or for a while the last one.
  std::optional<Signal> tapped(Node& node, double now_s);
  void trace(std::span<elsie::Member> members) const;

  std::vector<std::string> layers_;
  std::vector<std::string> prioritized_;  // layers with a `priority` of their own
  std::vector<Node>
      nodes_;  // by line from the highest, on each from the lowest to the highest `by`

  // From the last decision:
  std::vector<std::optional<Signal>> lines_;
  std::vector<int> stopped_by_;  // the layer that stopped each layer's own signal, or -1
  std::vector<bool> inhibited_;  // whether it did so by inhibition
  bool held_ = false;            // the command is from a layer that is no longer active
};

/// The links that hold a signal; both objects have the same links unless the world was changed.
void ArbiterSubsumption::remember(elsie::Memory& memory) {
  for (Node& node : nodes_) {
    const std::string name =
        layers_[node.by] + (node.suppresses ? " suppresses " : " inhibits ") + layers_[node.of];
    std::optional<std::vector<double>> held;
    if (node.last) {
      const elsie::Motion& command = node.last->command;
      held = {command.forward, command.lateral, command.turn, node.last_s};
    }
    memory(name, held);
    std::string source = node.last ? layers_[node.last->source] : "";
    memory(name + " from", source);
    const auto from = std::find(layers_.begin(), layers_.end(), source);
    if (memory.recalls() && held && held->size() == 4 && from != layers_.end()) {
      const auto layer = static_cast<std::size_t>(from - layers_.begin());
      node.last = Signal{{(*held)[0], (*held)[1], (*held)[2]}, layer, false};
      node.last_s = (*held)[3];
    }
  }
}

std::optional<ArbiterSubsumption::Signal> ArbiterSubsumption::tapped(Node& node, double now_s) {
  const std::optional<Signal>& line = lines_[node.by];
  if (line && !line->held) {
    node.last = line;
    node.last_s = now_s;
  }
  if (line) {
    return line;  // a signal that is held further up is not held again here
  }
  if (node.last && node.hold > 0.0 && now_s - node.last_s <= node.hold + 1e-9) {
    std::optional<Signal> held = node.last;
    held->held = true;
    return held;
  }
  node.last.reset();
  return std::nullopt;
}

elsie::Motion ArbiterSubsumption::coordinate(std::span<elsie::Member> members,
                                             const elsie::Perception& now) {
  if (members.size() != layers_.size()) {
    equipped(members, now);
  }
  held_ = false;
  if (members.empty()) {
    return nobody(members, "");
  }
  lines_.resize(members.size());
  stopped_by_.assign(members.size(), -1);
  inhibited_.assign(members.size(), false);
  std::size_t next = 0;
  for (std::size_t layer = members.size(); layer-- > 0;) {
    // Brooks' layers do not know those above them: all of them run, whoever decides.
    const elsie::Response& response = members[layer].respond();
    std::optional<Signal>& line = lines_[layer];
    line.reset();
    if (response.activation > threshold) {
      line = Signal{response.command, layer, false};
    }
    for (; next < nodes_.size() && nodes_[next].of == layer; ++next) {
      Node& node = nodes_[next];
      const std::optional<Signal> tap = tapped(node, now.time_s());
      if (!tap) {
        continue;
      }
      if (line && line->source != tap->source) {
        stopped_by_[line->source] = static_cast<int>(tap->source);
        inhibited_[line->source] = !node.suppresses;
      }
      line.reset();
      if (node.suppresses) {
        line = tap;
      }
    }
  }

  winner_.reset();
  if (lines_[0]) {
    winner_ = lines_[0]->source;
    held_ = lines_[0]->held;
  }
  trace(members);
  return lines_[0] ? lines_[0]->command : elsie::Motion{};
}

void ArbiterSubsumption::trace(std::span<elsie::Member> members) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    elsie::TraceRow& row = members[i].trace;
    const bool active = row.activation > threshold;
    if (winner_ == i) {
      row.weight = 1.0;
      row.share = 1.0;
      row.reason = held_ ? "held" : "its signal reaches the motors";
    } else if (!active) {
      row.reason = "not active";
    } else if (stopped_by_[i] >= 0) {
      row.inhibited_by = stopped_by_[i];
      row.reason = inhibited_[i] ? "inhibited" : "suppressed";
    } else {
      row.reason = "its signal leads nowhere";
    }
  }
}

std::size_t ArbiterSubsumption::layer_of(const char* element, const char* attribute,
                                         const std::string& name,
                                         std::vector<std::string>& problems) const {
  const auto found = std::find(layers_.begin(), layers_.end(), name);
  if (found == layers_.end()) {
    problems.push_back("<" + std::string(element) + " " + attribute + "=\"" + name +
                       "\"> names no behaviour of this coordinator" +
                       elsie::base::did_you_mean(name, layers_));
  }
  return static_cast<std::size_t>(found - layers_.begin());
}

void ArbiterSubsumption::add(const char* element, const std::vector<Link>& links,
                             std::vector<std::string>& problems) {
  for (const Link& link : links) {
    const std::size_t known = problems.size();
    const std::size_t by = layer_of(element, "by", link.by, problems);
    const std::size_t of = layer_of(element, "of", link.of, problems);
    if (problems.size() > known) {
      continue;
    }
    const std::string text =
        "<" + std::string(element) + " by=\"" + link.by + "\" of=\"" + link.of + "\">";
    const auto same = [&](const Node& node) { return node.by == by && node.of == of; };
    const auto opposite = [&](const Node& node) { return node.by == of && node.of == by; };
    if (by == of) {
      problems.push_back(text + " links a layer to itself; name two layers");
    } else if (std::any_of(nodes_.begin(), nodes_.end(), opposite)) {
      problems.push_back(text + " closes a circle with the link from '" + link.of + "' to '" +
                         link.by + "'; remove one of them");
    } else if (by < of) {
      problems.push_back(text +
                         " goes upwards, but only a higher layer acts on a lower one, and '" +
                         link.by + "' stands before '" + link.of +
                         "' in the file: the first is the lowest; swap the behaviours or the link");
    } else if (std::any_of(nodes_.begin(), nodes_.end(), same)) {
      problems.push_back(text + " is the second link of these two layers; remove one");
    }
    nodes_.push_back({by, of, element == std::string("suppress"), link.hold});
  }
}

void ArbiterSubsumption::wire() {
  nodes_.clear();
  std::vector<std::string> problems;
  add("suppress", suppressions, problems);
  add("inhibit", inhibitions, problems);
  if (!problems.empty()) {
    nodes_.clear();
    std::string all;
    for (const std::string& problem : problems) {
      all += (all.empty() ? "" : "; ") + problem;
    }
    throw std::invalid_argument(all);
  }
  // A layer without links suppresses all layers below it.
  const std::size_t links = nodes_.size();
  for (std::size_t by = 1; by < layers_.size(); ++by) {
    const bool linked = std::any_of(nodes_.begin(), nodes_.begin() + static_cast<long>(links),
                                    [&](const Node& node) { return node.by == by; });
    for (std::size_t of = 0; !linked && of < by; ++of) {
      nodes_.push_back({by, of, true, hold});
    }
  }
  std::sort(nodes_.begin(), nodes_.end(),
            [](const Node& a, const Node& b) { return a.of != b.of ? a.of > b.of : a.by < b.by; });
}

}  // namespace

ELSIE_COORDINATOR(
    ArbiterSubsumption, "arbiter_subsumption",
    "Layers, the first in the file the lowest: higher active ones suppress or inhibit lower ones",
    elsie::parameter(
        "threshold", &ArbiterSubsumption::threshold,
        {.min = 0, .max = 1, .meaning = "a layer is active when its activation is above this"}),
    elsie::parameter("hold", &ArbiterSubsumption::hold,
                     {.unit = "s",
                      .min = 0,
                      .meaning = "time constant of layers without links: how long their last "
                                 "signal still suppresses"}),
    elsie::elements(
        &ArbiterSubsumption::suppressions,
        elsie::element<Link>(
            "suppress", "while layer 'by' has a signal, it replaces that of layer 'of'",
            elsie::parameter("by", &Link::by,
                             {.meaning = "the id of the higher layer", .required = true}),
            elsie::parameter("of", &Link::of,
                             {.meaning = "the id of the lower layer", .required = true}),
            elsie::parameter(
                "hold", &Link::hold,
                {.unit = "s",
                 .min = 0,
                 .meaning = "time constant: how long the last signal stays in effect"}))),
    elsie::elements(
        &ArbiterSubsumption::inhibitions,
        elsie::element<Link>(
            "inhibit", "while layer 'by' has a signal, that of layer 'of' is removed",
            elsie::parameter("by", &Link::by,
                             {.meaning = "the id of the higher layer", .required = true}),
            elsie::parameter("of", &Link::of,
                             {.meaning = "the id of the lower layer", .required = true}),
            elsie::parameter("hold", &Link::hold,
                             {.unit = "s",
                              .min = 0,
                              .meaning = "time constant: how long it still acts once there is no "
                                         "signal"}))));
