#include "tree_words.h"

#include <elsie/base/number_text.h>

namespace {

/// The symbols are those of Colledanchise and Oegren; * marks memory.
std::string symbol_of(const TreeNode& node) {
  const std::string memory = node.memory ? "*" : "";
  if (node.kind == "sequence") return "→" + memory;
  if (node.kind == "fallback") return "?" + memory;
  if (node.kind == "parallel") return "⇉";
  if (node.kind == "inverter") return "¬";
  if (node.kind == "timeout") return "timeout " + elsie::base::number_text(node.seconds) + " s";
  return node.kind + (node.times > 0 ? " " + std::to_string(node.times) : "");
}

}  // namespace

std::string label_of(const TreeNode& node) {
  if (node.kind == "run") return node.name.empty() ? node.behavior : node.name;
  if (node.kind == "condition") {
    return "if " + (!node.name.empty() ? node.name : node.when.empty() ? node.event : node.when);
  }
  return symbol_of(node) + (node.name.empty() ? "" : " " + node.name);
}

std::string path_in(const std::string& path, const TreeNode& parent, const TreeNode& node) {
  std::size_t number = 0, count = 0;
  for (const TreeNode& each : parent.children) {
    if (each.kind != node.kind) continue;
    ++count;
    if (&each == &node) number = count;
  }
  return path + "/" + node.kind + (count > 1 ? "[" + std::to_string(number) + "]" : "");
}
