#include "path_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/world/description.h"

#include "arguments.h"
#include "command.h"

namespace elsie::program {

void PathOptions::add_to(CLI::App& command) {
  command
      .add_option("--picture-robots", choice_.robots,
                  "Draw only these robots' paths: ids, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs("--picture")
      ->type_name("IDS");
  command.add_option("--picture-from", choice_.from_s, "Draw the paths from this time on")
      ->needs("--picture")
      ->check(non_negative_number())
      ->type_name("SECONDS");
  command.add_option("--picture-to", choice_.to_s, "Draw the paths up to this time")
      ->needs("--picture")
      ->check(positive_number())
      ->type_name("SECONDS");
  command
      .add_option("--picture-fade", choice_.fade_s,
                  "Let the paths fade: parts older than their end by this time are left out")
      ->needs("--picture")
      ->check(positive_number())
      ->type_name("SECONDS");
}

void PathOptions::check(const world::World& world) const {
  if (choice_.from_s >= choice_.to_s) {
    throw BadInput("--picture-from: the ways cannot begin at " +
                   base::number_text(choice_.from_s, 6) + " s and end at " +
                   base::number_text(choice_.to_s, 6) + " s");
  }
  require_robots(world, choice_.robots, "--picture-robots");
}

void require_robots(const world::World& world, const std::vector<std::string>& robots,
                    const std::string& option) {
  std::vector<std::string> ids;
  for (const world::Robot& robot : world.robots) {
    ids.push_back(robot.id);
  }
  for (const std::string& id : robots) {
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
      throw BadInput(option + ": there is no robot '" + id + "' in this world" +
                     base::did_you_mean(id, ids));
    }
  }
}

}  // namespace elsie::program
