#include "tree_words.h"

std::string path_in(const std::string& path, const TreeNode& parent, const TreeNode& node) {
  std::size_t number = 0, count = 0;
  for (const TreeNode& each : parent.children) {
    if (each.kind != node.kind) continue;
    ++count;
    if (&each == &node) number = count;
  }
  return path + "/" + node.kind + (count > 1 ? "[" + std::to_string(number) + "]" : "");
}
