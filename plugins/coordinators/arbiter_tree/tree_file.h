// Trees in the XML of BehaviorTree.CPP, versions 3 and 4.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tree.h"

struct TreeFile {
  TreeNode root;
  std::vector<std::string> notes;  // what was left out
};

/// Reads the tree of a file. `conditions`: the texts of conditions by their names. Throws
/// std::invalid_argument with file and line. What it understands:
/// docs/coordinators/arbiter_tree.md.
TreeFile read_tree_file(const std::string& file,
                        const std::map<std::string, std::string>& conditions);
