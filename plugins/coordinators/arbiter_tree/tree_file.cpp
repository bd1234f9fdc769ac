#include "tree_file.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>

#include <elsie/base/near_name.h>
#include <elsie/world/error.h>
#include <elsie/world/markup.h>

namespace {

using elsie::world::Element;

[[noreturn]] void fail(const Element& element, const std::string& problem) {
  throw std::invalid_argument(element.where.file.text() + ":" + std::to_string(element.where.line) +
                              ": " + problem);
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
    for (const Element& tree : root_.children) {
      if (tree.name != "BehaviorTree") continue;
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
    if (element.name == "SubTree" || element.name == "SubTreePlus") {
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
    const double children = static_cast<double>(element.children.size());
    if (made.kind == "parallel") {
      const double success = number(element, {"success_count", "success_threshold"}, -1);
      const double failure = number(element, {"failure_count", "failure_threshold"}, 1);
      // Below 0: counted from the number of its children, -1 is all of them.
      const auto counted = [&](double count) {
        return static_cast<int>(count < 0 ? children + 1 + count : count);
      };
      made.successes = counted(success);
      made.failures = counted(failure);
    } else if (made.kind == "retry") {
      made.times = static_cast<int>(number(element, {"num_attempts"}));
    } else if (made.kind == "repeat") {
      made.times = static_cast<int>(number(element, {"num_cycles"}));
    } else if (made.kind == "timeout") {
      made.seconds = 1e-3 * number(element, {"msec"});
    }
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
    for (const auto& attribute : element.attributes) {
      if (attribute.name == "ID" || attribute.name == "name") continue;
      file_.notes.push_back("line " + std::to_string(element.where.line) +
                            " of its file: the port " + attribute.name + "=\"" + attribute.value +
                            "\" of '" + id + "' is left out; parameters stand in the world file");
    }
    return made;
  }

  /// The first of these attributes that is there.
  static double number(const Element& element, std::initializer_list<const char*> names,
                       std::optional<double> none = {}) {
    for (const char* const name : names) {
      const auto* const found = element.find(name);
      if (!found) continue;
      const std::string& text = found->value;
      double value = 0.0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) < 1e9)) {
        fail(element,
             std::string(name) + "=\"" + text + "\" of <" + element.name + ">: expected a number");
      }
      return value;
    }
    if (!none) fail(element, "<" + element.name + "> lacks " + *names.begin() + "=\"...\"");
    return *none;
  }

  const Element& root_;
  const std::map<std::string, std::string>& conditions_;
  std::vector<std::string> inside_;  // the trees around what is being read
  TreeFile file_;
};

}  // namespace

TreeFile read_tree_file(const std::string& file,
                        const std::map<std::string, std::string>& conditions) {
  const Element root = elsie::world::parse_markup(elsie::world::read_text(file), file);
  return Reader(root, conditions).read();
}
