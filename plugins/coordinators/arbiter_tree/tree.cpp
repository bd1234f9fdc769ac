#include "tree.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "member_names.h"
#include "tree_words.h"

using elsie::Status;

namespace {

/// Throws what is wrong with a node itself.
void check(const TreeNode& node) {
  const std::string tag = "<" + node.kind + ">";
  const auto count = static_cast<int>(node.children.size());
  if (node.has_one_child() ? count != 1 : !node.is_leaf() && count == 0) {
    throw std::invalid_argument(tag + " has " + std::to_string(count) + " nodes in it; expected " +
                                (node.has_one_child() ? "one" : "at least one"));
  }
  if (node.kind == "condition" && node.when.empty() == node.event.empty()) {
    throw std::invalid_argument("<condition> needs either when=\"...\" or event=\"...\"");
  }
  if (node.kind == "parallel" && (node.successes > count || node.failures > count)) {
    throw std::invalid_argument("<parallel> waits for more nodes than the " +
                                std::to_string(count) + " in it");
  }
}

}  // namespace

BehaviorTree::Kind BehaviorTree::kind_of(const std::string& name) {
  static const std::map<std::string, Kind> kKinds{
      {"sequence", Kind::sequence}, {"fallback", Kind::fallback},   {"parallel", Kind::parallel},
      {"inverter", Kind::inverter}, {"retry", Kind::retry},         {"repeat", Kind::repeat},
      {"timeout", Kind::timeout},   {"condition", Kind::condition}, {"run", Kind::run}};
  return kKinds.at(name);
}

BehaviorTree::BehaviorTree(const TreeNode& root) { add(root, 0, root.kind); }

void BehaviorTree::add(const TreeNode& described, std::size_t parent, const std::string& path) {
  const std::size_t own = nodes_.size();
  Node node;
  node.described = &described;
  node.kind = kind_of(described.kind);
  node.parent = parent;
  node.where = described.where.empty() ? path + ": " : described.where;
  try {
    check(described);
    if (!described.when.empty()) node.when.emplace(described.when);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(node.where + error.what());
  }
  nodes_.push_back(std::move(node));
  for (const TreeNode& child : described.children) {
    nodes_[own].children.push_back(nodes_.size());
    add(child, own, path_in(path, described, child));
  }
}

void BehaviorTree::equip(std::span<const elsie::Member> members, const elsie::Perception& example) {
  MemberNames names;
  names.read(members);
  for (Node& node : nodes_) {
    try {
      if (node.kind == Kind::run) {
        node.member = names.find("run", "behavior", node.described->behavior).value_or(0);
        names.throw_problems();
      }
      if (node.when) node.when->equip(members, example);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(node.where + error.what());
    }
  }
}

void BehaviorTree::reset() {
  halt(0);
  for (Node& node : nodes_) node.is_ticked = false;
}

bool BehaviorTree::runs(std::size_t member) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const Node& node) {
    return node.is_running && node.kind == Kind::run && node.member == member;
  });
}

std::vector<double> BehaviorTree::progress() const {
  std::vector<double> numbers;
  for (const Node& node : nodes_) {
    numbers.push_back(static_cast<double>(node.children.size()));
    numbers.push_back(node.is_running ? 1.0 : 0.0);
    numbers.push_back(static_cast<double>(node.at));
    numbers.push_back(node.since_s);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const auto ended = i < node.of.size() ? node.of[i] : std::nullopt;
      numbers.push_back(ended ? static_cast<double>(*ended) : -1.0);
    }
  }
  return numbers;
}

bool BehaviorTree::resume(const std::vector<double>& progress) {
  constexpr std::size_t kOwn = 4;  // numbers of a node, besides those of its children
  std::size_t at = 0;
  for (Node& node : nodes_) {
    const std::size_t count = node.children.size();
    if (at + kOwn + count > progress.size() || progress[at] != static_cast<double>(count)) {
      reset();
      return false;
    }
    node.is_running = progress[at + 1] != 0.0;
    node.at = static_cast<std::size_t>(progress[at + 2]);
    node.since_s = progress[at + 3];
    node.of.assign(node.kind == Kind::parallel ? count : 0, std::nullopt);
    for (std::size_t i = 0; i < node.of.size(); ++i) {
      const double ended = progress[at + kOwn + i];
      if (ended >= 0.0) node.of[i] = static_cast<Status>(static_cast<int>(ended));
    }
    at += kOwn + count;
  }
  return at == progress.size();
}

Status BehaviorTree::tick(std::span<elsie::Member> members, const elsie::Perception& now) {
  for (Node& node : nodes_) node.is_ticked = false;
  const Status status = tick(0, {members, now});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].is_running && !nodes_[i].is_ticked) halt(i);
  }
  return status;
}

void BehaviorTree::halt(std::size_t node) {
  nodes_[node].is_running = false;
  for (const std::size_t child : nodes_[node].children) halt(child);
}

Status BehaviorTree::tick(std::size_t index, const Now& now) {
  Node& node = nodes_[index];
  const bool is_new = !node.is_running;
  node.is_ticked = node.is_running = true;
  if (is_new) {
    node.at = 0;
    node.since_s = now.perception.time_s();
    node.of.assign(node.kind == Kind::parallel ? node.children.size() : 0, std::nullopt);
  }
  node.status = outcome(node, is_new, now);
  node.is_running = node.status == Status::running;
  if (!node.is_running) {
    for (const std::size_t child : node.children) halt(child);
  }
  return node.status;
}

Status BehaviorTree::outcome(Node& node, bool is_new, const Now& now) {
  switch (node.kind) {
    case Kind::sequence:
      return in_order(node, now, Status::success);
    case Kind::fallback:
      return in_order(node, now, Status::failure);
    case Kind::parallel:
      return parallel(node, now);
    case Kind::retry:
      return again(node, now, Status::failure);
    case Kind::repeat:
      return again(node, now, Status::success);
    case Kind::inverter: {
      const Status status = tick(node.children[0], now);
      return status == Status::success   ? Status::failure
             : status == Status::failure ? Status::success
                                         : Status::running;
    }
    case Kind::timeout: {
      constexpr double kRounding = 1e-9;  // s
      const double age = now.perception.time_s() - node.since_s;
      return age + kRounding >= node.described->seconds ? Status::failure
                                                        : tick(node.children[0], now);
    }
    case Kind::condition: {
      const bool holds = node.when ? node.when->holds(now.members, now.perception)
                                   : perceives(now.perception, node.described->event);
      return holds ? Status::success : Status::failure;
    }
    case Kind::run:
      break;
  }
  return run(node, is_new, now);
}

/// A sequence goes on after a success, a fallback after a failure. With memory, children that are
/// done are not ticked again while it is running.
Status BehaviorTree::in_order(Node& node, const Now& now, Status goes_on) {
  for (std::size_t i = node.described->memory ? node.at : 0; i < node.children.size(); ++i) {
    node.at = i;
    if (const Status status = tick(node.children[i], now); status != goes_on) return status;
  }
  return goes_on;
}

/// Children that are done wait for the others.
Status BehaviorTree::parallel(Node& node, const Now& now) {
  const auto ended = [&](Status how) { return std::count(node.of.begin(), node.of.end(), how); };
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (node.of[i]) continue;
    if (const Status status = tick(node.children[i], now); status != Status::running) {
      node.of[i] = status;
    }
  }
  const auto count = static_cast<std::ptrdiff_t>(node.children.size());
  const auto wanted = node.described->successes > 0 ? node.described->successes : count;
  if (ended(Status::success) >= wanted) return Status::success;
  const bool is_lost = count - ended(Status::failure) < wanted;
  return is_lost || ended(Status::failure) >= node.described->failures ? Status::failure
                                                                       : Status::running;
}

/// Retry goes on after a failure, repeat after a success: at most one attempt a tick.
Status BehaviorTree::again(Node& node, const Now& now, Status goes_on) {
  const Status status = tick(node.children[0], now);
  if (status != goes_on) return status;
  ++node.at;
  const auto times = static_cast<std::size_t>(node.described->times);
  return times > 0 && node.at >= times ? goes_on : Status::running;
}

/// Events are perceived one control period after they were raised, so the first tick sees only
/// those of others.
Status BehaviorTree::run(Node& node, bool is_new, const Now& now) {
  const TreeNode& described = *node.described;
  const auto is_raised = [&](const std::string& event) {
    return !is_new && !event.empty() && perceives(now.perception, event);
  };
  if (is_raised(described.success)) return Status::success;
  if (is_raised(described.failure)) return Status::failure;
  return now.members[node.member].respond().status;
}

elsie::Graph BehaviorTree::graph() const {
  elsie::Graph graph;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    graph.nodes.push_back({label_of(*nodes_[i].described)});
    if (i > 0) graph.edges.push_back({nodes_[i].parent, i});
  }
  return graph;
}

void BehaviorTree::light(std::span<elsie::NodeState> nodes) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Status status = nodes_[i].status;
    nodes[i] = !nodes_[i].is_ticked        ? elsie::NodeState::dark
               : status == Status::success ? elsie::NodeState::success
               : status == Status::failure ? elsie::NodeState::failure
                                           : elsie::NodeState::running;
  }
}
