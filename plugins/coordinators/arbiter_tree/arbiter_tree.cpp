// A behaviour tree: Colledanchise and Oegren, "Behavior Trees in Robotics and AI", CRC Press, 2018.
// It is ticked once in each control period.
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/declaration_items.h>
#include <elsie/api/remember.h>

#include "tree.h"
#include "tree_file.h"
#include "weighing.h"

namespace {

/// The name of a condition in a file.
struct Define {
  std::string name;
  std::string when;
};

class ArbiterTree final : public elsie::Coordinator, public elsie::Remembers {
 public:
  elsie::FilePath file;
  std::vector<TreeNode> nodes;
  std::vector<Define> defines;

  void configured() override {
    if (nodes.size() != (file.path.empty() ? 1 : 0)) {
      throw std::invalid_argument(
          file.path.empty() ? "it has " + std::to_string(nodes.size()) +
                                  " nodes in it; expected one, the root of the tree, or a file"
                            : "it has a file and nodes in it; expected one of them");
    }
    const std::vector<double> before = tree_ ? tree_->progress() : std::vector<double>();
    tree_.reset();
    from_file_.reset();
    if (!file.path.empty()) {
      std::map<std::string, std::string> conditions;
      for (const Define& each : defines) {
        if (!conditions.emplace(each.name, each.when).second) {
          throw std::invalid_argument("there are two <define> of the name '" + each.name + "'");
        }
        const Condition is_sound(each.when);
      }
      from_file_ = read_tree_file(file.path, conditions);
    } else if (!defines.empty()) {
      throw std::invalid_argument("<define> is for the conditions of a file, and there is none");
    }
    tree_.emplace(from_file_ ? from_file_->root : nodes.front());
    tree_->resume(before);
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    tree_->equip(members, example);
  }

  void reset(elsie::Random&) override {
    tree_->reset();
    status_ = elsie::Status::running;
  }

  void remember(elsie::Memory& memory) override {
    std::vector<double> progress = tree_->progress();
    memory("progress", progress);
    if (memory.recalls()) tree_->resume(progress);
  }

  std::vector<std::string> notes() const override {
    return from_file_ ? from_file_->notes : std::vector<std::string>();
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    status_ = tree_->tick(members, now);
    elsie::Motion sum;
    double total = 0.0;
    running_ = 0.0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      elsie::Member& member = members[i];
      elsie::TraceRow& trace = member.trace;
      if (!trace.asked) {
        trace.reason = "not ticked";
        continue;
      }
      if (trace.status != elsie::Status::running) {
        trace.reason = trace.status == elsie::Status::success ? "success" : "failure";
        continue;
      }
      if (!tree_->runs(i)) {
        trace.reason = "halted";  // by the end of a node around it
        continue;
      }
      trace.weight = std::max(0.0, member.priority());
      trace.reason = "running";
      running_ += 1.0;
      total += trace.weight;
      sum += trace.weight * member.respond().command;
    }
    if (total <= 0.0) return {};
    for (elsie::Member& member : members) member.trace.share = member.trace.weight / total;
    return sum / total;
  }

  elsie::Status status() const override { return status_; }
  elsie::Graph graph() const override { return tree_->graph(); }
  void light(std::span<elsie::NodeState> lights) const override { tree_->light(lights); }
  double running() const { return running_; }

 private:
  std::optional<TreeFile> from_file_;
  std::optional<BehaviorTree> tree_;
  elsie::Status status_ = elsie::Status::running;  // of the root, in the last tick
  double running_ = 0.0;                           // behaviours
};

template <class... Items>
auto node(const char* kind, const char* meaning, Items... items) {
  return elsie::element<TreeNode>(
      kind, meaning, elsie::element_name(&TreeNode::kind),
      elsie::parameter("name", &TreeNode::name, {.meaning = "for pictures"}), std::move(items)...);
}
template <class... Items>
auto holder(const char* kind, const char* meaning, Items... items) {
  return node(kind, meaning, elsie::nests(&TreeNode::children), std::move(items)...);
}

const auto kMemory = [] {
  return elsie::parameter("memory", &TreeNode::memory,
                          {.meaning = "whether those that are done are left out while it is "
                                      "running; false: all are ticked again"});
};
const auto kTimes = [] {
  return elsie::parameter("times", &TreeNode::times,
                          {.min = 0, .max = 1e6, .meaning = "how often at most; 0: for ever"});
};

}  // namespace

ELSIE_COORDINATOR(
    ArbiterTree, "arbiter_tree", "A behaviour tree: what its nodes run decides",
    elsie::elements(
        &ArbiterTree::nodes, holder("sequence", "one after the other, until one fails", kMemory()),
        holder("fallback", "one after the other, until one succeeds", kMemory()),
        holder("parallel", "all at once",
               elsie::parameter("successes", &TreeNode::successes,
                                {.min = 0, .meaning = "so many end it with success; 0: all"}),
               elsie::parameter("failures", &TreeNode::failures,
                                {.min = 1, .meaning = "so many end it with failure"})),
        holder("inverter", "success is failure, and failure success"),
        holder("retry", "again after a failure", kTimes()),
        holder("repeat", "again after a success", kTimes()),
        holder("timeout", "fails what takes longer",
               elsie::parameter("seconds", &TreeNode::seconds,
                                {.unit = "s", .above = 0, .meaning = "how long it may take"})),
        node("condition", "succeeds if it holds now, else fails",
             elsie::parameter("when", &TreeNode::when,
                              {.meaning = "a condition over what the robot perceives"}),
             elsie::parameter("event", &TreeNode::event,
                              {.meaning = "an event that the robot perceives"})),
        node("run", "a behaviour, until it says that it is done",
             elsie::parameter("behavior", &TreeNode::behavior,
                              {.meaning = "its id", .required = true}),
             elsie::parameter("success", &TreeNode::success,
                              {.meaning = "an event that means its success"}),
             elsie::parameter("failure", &TreeNode::failure,
                              {.meaning = "an event that means its failure"}))),
    elsie::elements(&ArbiterTree::defines,
                    elsie::element<Define>(
                        "define", "what a condition of the file means",
                        elsie::parameter("name", &Define::name,
                                         {.meaning = "as the file calls it", .required = true}),
                        elsie::parameter("when", &Define::when,
                                         {.meaning = "a condition over what the robot perceives",
                                          .required = true}))),
    elsie::parameter("file", &ArbiterTree::file,
                     {.meaning = "a tree in the XML of BehaviorTree.CPP, in place of nodes",
                      .live = false}),
    elsie::names_event("condition/event"), elsie::names_event("run/success"),
    elsie::names_event("run/failure"),
    elsie::publishes("running", &ArbiterTree::running,
                     {.meaning = "how many behaviours are running"}));
