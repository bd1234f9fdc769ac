#include "tree_file.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <stdexcept>

#include <elsie/base/near_name.h>
#include <elsie/world/error.h>
#include <elsie/world/markup.h>

namespace {

using elsie::world::Element;

std::string place_of(const Element& element) {
  return element.where.file.text() + ":" + std::to_string(element.where.line) + ": ";
}
[[noreturn]] void fail(const Element& element, const std::string& problem) {
  throw std::invalid_argument(place_of(element) + problem);
}

/// What a node of BehaviorTree.CPP is here.
struct Known {
  const char* kind;
  bool memory = true;
};
const std::map<std::string, Known> kKnown{
    {"Sequence", {"sequence"}},
    {"SequenceStar", {"sequence"}},
    {"SequenceWithMemory", {"sequence"}},
    {"ReactiveSequence", {"sequence", false}},
    {"Fallback", {"fallback"}},
    {"ReactiveFallback", {"fallback", false}},
    {"Parallel", {"parallel"}},
    {"Inverter", {"inverter"}},
    {"RetryUntilSuccessful", {"retry"}},
    {"RetryUntilSuccesful", {"retry"}},  // as version 3 spells it
    {"Repeat", {"repeat"}},
    {"Timeout", {"timeout"}},
};

class Reader {
 public:
  Reader(const Element& root, const std::map<std::string, std::string>& conditions)
      : root_(root), conditions_(conditions) {}

  TreeFile read() {
    if (root_.name != "root") {
      fail(root_, "found <" + root_.name + "> as the root element; expected <root>");
    }
    std::string main = root_.value("main_tree_to_execute");
    std::size_t trees = 0;
    std::set<std::string> ids;
    for (const Element& tree : root_.children) {
      // Editors keep a list of known nodes in the file.
      if (tree.name == "TreeNodesModel") continue;
      if (tree.name != "BehaviorTree") {
        fail(tree, "<root> may not hold <" + tree.name + "> here; expected <BehaviorTree>");
      }
      if (!ids.insert(tree.value("ID")).second) {
        fail(tree, "there are two <BehaviorTree> of the ID '" + tree.value("ID") +
                       "'; expected IDs that differ");
      }
      ++trees;
      if (main.empty() && trees == 1) main = tree.value("ID");
    }
    if (trees == 0) fail(root_, "<root> has no <BehaviorTree> in it");
    if (trees > 1 && !root_.find("main_tree_to_execute")) {
      fail(root_, "there are " + std::to_string(trees) +
                      " trees; say which is the first: main_tree_to_execute=\"...\" of <root>");
    }
    file_.root = tree(root_, main);
    return std::move(file_);
  }

 private:
  static void refuse_text(const Element& element) {
    if (!element.text.empty()) fail(element, "found text in <" + element.name + ">");
  }

  TreeNode tree(const Element& from, const std::string& id) {
    std::vector<std::string> names;
    for (const Element& each : root_.children) {
      if (each.name != "BehaviorTree") continue;
      names.push_back(each.value("ID"));
      if (names.back() != id) continue;
      if (std::find(inside_.begin(), inside_.end(), id) != inside_.end()) {
        fail(from, "the tree '" + id + "' holds itself");
      }
      if (each.children.size() != 1) {
        fail(each, "<BehaviorTree> has " + std::to_string(each.children.size()) +
                       " nodes in it; expected one");
      }
      inside_.push_back(id);
      TreeNode made = node(each.children.front());
      inside_.pop_back();
      return made;
    }
    fail(from, "there is no tree '" + id + "'" + elsie::base::near_or_all(id, names, "there are"));
  }

  TreeNode node(const Element& element) {
    constexpr int kMost = 10000;  // trees that name others twice grow without end
    if (++count_ > kMost) fail(element, "the tree has more than 10000 nodes");
    refuse_text(element);
    if (element.name == "SubTree" || element.name == "SubTreePlus") {
      note_others(element, {"ID", "name"});
      return tree(element, element.value("ID"));
    }
    const auto known = kKnown.find(element.name);
    return known == kKnown.end() ? leaf(element) : control(element, known->second);
  }

  TreeNode control(const Element& element, const Known& known) {
    TreeNode made;
    made.kind = known.kind;
    made.memory = known.memory;
    made.name = element.value("name");
    made.where = place_of(element);
    const int children = static_cast<int>(element.children.size());
    std::vector<std::string> own{"name"};
    if (made.kind == "parallel") {
      own.insert(own.end(),
                 {"success_count", "success_threshold", "failure_count", "failure_threshold"});
      // Below 0: counted from the number of its children, -1 is all of them.
      const auto counted = [&](int count) { return count < 0 ? children + 1 + count : count; };
      made.successes = counted(whole(element, {"success_count", "success_threshold"}, -1));
      made.failures = counted(whole(element, {"failure_count", "failure_threshold"}, 1));
      if (made.successes < 1 || made.failures < 1) {
        fail(element, "<" + element.name + "> must wait for at least one success and one failure");
      }
    } else if (made.kind == "retry" || made.kind == "repeat") {
      const char* const name = made.kind == "retry" ? "num_attempts" : "num_cycles";
      own.emplace_back(name);
      made.times = whole(element, {name});
      if (made.times < -1 || made.times == 0 || made.times > 1000000) {
        fail(element, std::string(name) + " of <" + element.name +
                          ">: expected a number from 1 to 1000000, or -1 for ever");
      }
    } else if (made.kind == "timeout") {
      own.emplace_back("msec");
      made.seconds = 1e-3 * whole(element, {"msec"});
      if (!(made.seconds > 0.0)) fail(element, "msec of <Timeout>: expected a number above 0");
    }
    note_others(element, own);
    if (made.times < 0) made.times = 0;  // for ever
    for (const Element& child : element.children) made.children.push_back(node(child));
    return made;
  }

  TreeNode leaf(const Element& element) {
    const bool has_id = element.name == "Action" || element.name == "Condition";
    const std::string id = has_id ? element.value("ID") : element.name;
    if (!element.children.empty()) {
      std::vector<std::string> names{"SubTree"};
      for (const auto& [name, known] : kKnown) names.push_back(name);
      fail(element, "<" + element.name + "> is no node that holds others" +
                        elsie::base::near_or_all(element.name, names, "there are"));
    }
    TreeNode made;
    made.name = element.value("name");
    made.where = place_of(element);
    const auto condition = conditions_.find(id);
    if (condition != conditions_.end()) {
      made.kind = "condition";
      made.when = condition->second;
    } else if (element.name == "Condition") {
      fail(element, "the condition '" + id + "' is not known; say what it means: <define name=\"" +
                        id + "\" when=\"...\"/> in <arbiter_tree>");
    } else {
      made.kind = "run";
      made.behavior = id;
    }
    note_others(element, {"ID", "name"});
    return made;
  }

  /// Notes attributes that are left out. Conditions of nodes would change what the tree does.
  void note_others(const Element& element, const std::vector<std::string>& own) {
    for (const auto& attribute : element.attributes) {
      if (std::find(own.begin(), own.end(), attribute.name) != own.end()) continue;
      if (attribute.name.starts_with("_") && attribute.name != "_autoremap") {
        fail(element, "the condition " + attribute.name + " of <" + element.name +
                          "> is not understood; write it as a node of its own");
      }
      file_.notes.push_back(place_of(element) + "the port " + attribute.name + "=\"" +
                            attribute.value + "\" of <" + element.name +
                            "> is left out; parameters stand in the world file");
    }
  }

  /// The first of these attributes that is there, a whole number.
  static int whole(const Element& element, std::initializer_list<const char*> names,
                   std::optional<int> none = {}) {
    for (const char* const name : names) {
      const auto* const found = element.find(name);
      if (!found) continue;
      const std::string& text = found->value;
      int value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size()) {
        fail(element, std::string(name) + "=\"" + text + "\" of <" + element.name +
                          ">: expected a whole number");
      }
      return value;
    }
    if (!none) fail(element, "<" + element.name + "> lacks " + *names.begin() + "=\"...\"");
    return *none;
  }

  const Element& root_;
  const std::map<std::string, std::string>& conditions_;
  std::vector<std::string> inside_;  // the trees around what is being read
  int count_ = 0;                    // of nodes
  TreeFile file_;
};

}  // namespace

TreeFile read_tree_file(const std::string& file,
                        const std::map<std::string, std::string>& conditions) {
  const std::string text = elsie::world::read_text(file);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw std::invalid_argument(file + ": the file is empty; expected <root> ... </root>");
  }
  const Element root = elsie::world::parse_markup(text, file, "root");
  return Reader(root, conditions).read();
}
