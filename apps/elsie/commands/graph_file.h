// The option --graph: the states or the tree of a robot's coordinators as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/picture/graph_picture.h"

namespace elsie::program {

/// Added to a refusal that a robot's coordinator has no graph.
inline constexpr const char* kWhoHasGraphs =
    "; coordinators such as arbiter_states and arbiter_tree show what they are made of";

class GraphFile {
 public:
  /// `option`: [ROBOT=]FILE. Throws BadInput.
  explicit GraphFile(const std::string& option);

  /// Empty: the first robot that has a graph.
  const std::string& robot() const { return robot_; }
  const std::filesystem::path& file() const { return file_; }
  /// `line`: after the robot's id, such as how its run ended. Throws base::Error.
  void save(const std::vector<picture::NamedGraph>& graphs, const picture::GraphLights& lights,
            const std::string& robot, const std::string& line) const;

 private:
  std::string robot_;
  std::filesystem::path file_;  // absolute: a plugin may change folders
};

}  // namespace elsie::program
