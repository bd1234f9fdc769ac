#include "path_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "elsie/plugin/near_name.h"
#include "elsie/world/description.h"

#include "arguments.h"
#include "command.h"
#include "text_table.h"

void PathOptions::add_to(CLI::App& command) {
  command
      .add_option("--picture-robots", choice_.robots,
                  "Draw the ways of these robots only: ids, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs("--picture")
      ->type_name("IDS");
  command.add_option("--picture-from", choice_.from_s, "Draw the ways from this time on")
      ->needs("--picture")
      ->check(non_negative_number())
      ->type_name("SECONDS");
  command.add_option("--picture-to", choice_.to_s, "Draw the ways up to this time")
      ->needs("--picture")
      ->check(positive_number())
      ->type_name("SECONDS");
  command
      .add_option("--picture-fade", choice_.fade_s,
                  "Have the ways fade: what is this much older than their end is gone")
      ->needs("--picture")
      ->check(positive_number())
      ->type_name("SECONDS");
}

void PathOptions::check(const elsie::world::World& world) const {
  if (choice_.from_s >= choice_.to_s) {
    throw BadInput("--picture-from: the ways cannot begin at " + text("%g", choice_.from_s) +
                   " s and end at " + text("%g", choice_.to_s) + " s");
  }
  std::vector<std::string> ids;
  for (const elsie::world::Robot& robot : world.robots) {
    ids.push_back(robot.id);
  }
  for (const std::string& id : choice_.robots) {
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
      throw BadInput("--picture-robots: there is no robot '" + id + "' in this world" +
                     elsie::plugin::did_you_mean(id, ids));
    }
  }
}
