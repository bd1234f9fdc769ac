// A behaviour tree at run time: who is ticked, and what comes of it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "condition.h"

/// A node as a world file gives it.
struct TreeNode {
  std::string kind;   // "sequence", "fallback", "parallel", "inverter", "retry", "repeat",
                      // "timeout", "condition" or "run"
  std::string where;  // "tree.xml:4: ", of a file
  std::string name;   // for pictures; empty: its kind
  bool memory = true;
  int successes = 0;  // of a parallel; 0: all of its children
  int failures = 1;
  int times = 3;
  double seconds = 10.0;
  std::string when;
  std::string event;
  std::string behavior;
  std::string success;  // events
  std::string failure;
  std::vector<TreeNode> children;

  bool is_leaf() const { return kind == "condition" || kind == "run"; }
  bool has_one_child() const {
    return kind == "inverter" || kind == "retry" || kind == "repeat" || kind == "timeout";
  }
};

class BehaviorTree {
 public:
  /// The node must outlive the tree. Throws std::invalid_argument with a sentence.
  explicit BehaviorTree(const TreeNode& root);

  /// Finds members and what conditions name. Throws std::invalid_argument with a sentence.
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);
  /// Forgets what is running.
  void reset();
  /// Ticks the root once. What ran before, and is not ticked now, is halted.
  elsie::Status tick(std::span<elsie::Member> members, const elsie::Perception& now);

  /// Whether a node that runs this member is running after the last tick.
  bool runs(std::size_t member) const;

  /// What is running, and since when: numbers for a tree of the same shape.
  std::vector<double> progress() const;
  /// Goes on from there. False: that is of another shape, and nothing is running.
  bool resume(const std::vector<double>& progress);

  elsie::Graph graph() const;
  /// How each node was left by the last tick; dark: it was not ticked.
  void light(std::span<elsie::NodeState> nodes) const;

 private:
  enum class Kind {
    sequence,
    fallback,
    parallel,
    inverter,
    retry,
    repeat,
    timeout,
    condition,
    run
  };
  static Kind kind_of(const std::string& name);

  struct Node {
    const TreeNode* described;
    Kind kind;
    std::size_t parent;
    std::string where;  // before what is wrong with it: "tree.xml:4: " or "fallback/run[2]: "
    std::vector<std::size_t> children;
    std::optional<Condition> when;
    std::size_t member = 0;
    // While it is running:
    bool is_running = false;
    std::size_t at = 0;                            // the child that is next, or attempts so far
    double since_s = 0.0;                          // when it began
    std::vector<std::optional<elsie::Status>> of;  // of a parallel: how children ended
    // In the last tick:
    bool is_ticked = false;
    elsie::Status status = elsie::Status::running;
  };
  struct Now {
    std::span<elsie::Member> members;
    const elsie::Perception& perception;
  };

  void add(const TreeNode& described, std::size_t parent, const std::string& path);
  elsie::Status tick(std::size_t node, const Now& now);
  elsie::Status outcome(Node& node, bool is_new, const Now& now);
  elsie::Status in_order(Node& node, const Now& now, elsie::Status goes_on);
  elsie::Status parallel(Node& node, const Now& now);
  elsie::Status again(Node& node, const Now& now, elsie::Status goes_on);
  elsie::Status run(Node& node, bool is_new, const Now& now);
  void halt(std::size_t node);

  std::vector<Node> nodes_;  // each before its children
};
