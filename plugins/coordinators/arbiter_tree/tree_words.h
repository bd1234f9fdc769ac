// How nodes of a tree are called in drawings and messages.
#pragma once

#include <string>

#include "tree.h"

/// The symbol of its kind and its name, such as "→* charge"; of a leaf what it runs, or asks.
std::string label_of(const TreeNode& node);

/// The path of a node in this one, such as "fallback/sequence[2]": the second of this kind.
std::string path_in(const std::string& path, const TreeNode& parent, const TreeNode& node);
