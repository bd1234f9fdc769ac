#include "elsie/world/reader.h"

#include <algorithm>
#include <utility>

#include "elsie/world/colours.h"
#include "elsie/world/vocabulary.h"

#include "checks.h"
#include "files.h"
#include "ids.h"
#include "markup.h"
#include "path.h"
#include "problems.h"
#include "reading.h"
#include "templates.h"
#include "tree_reader.h"

namespace elsie::world {

namespace {

// A file in another format has another vocabulary: nothing else in it is looked at.
void check_root(const Element& root, Problems& problems) {
  const std::string right = "<world format=\"" + std::to_string(kFormat) + "\">";
  if (root.name == "robot_template") {
    problems.add(root.where, "this file is a template of a robot; expected " + right +
                                 ", in which a <robot template=\"...\"> may use the template");
  } else if (root.name != "world") {
    problems.add(root.where, "found <" + root.name + "> as the root element; expected " + right);
  } else if (const Attribute* format = root.find("format")) {
    if (format->value != std::to_string(kFormat)) {
      problems.add(format->where, "format=\"" + format->value +
                                      "\" of <world>: this program reads " + "format \"" +
                                      std::to_string(kFormat) + "\"");
    }
  } else {
    problems.add(root.where, "<world> lacks its format; expected " + right);
  }
  problems.raise(root.where.file);
}

// "red" and "blue" are there by themselves; the file may change their colours and add others.
void add_default_teams(std::vector<Team>& teams) {
  std::vector<Team> all{{"red", kRedTeam}, {"blue", kBlueTeam}};
  for (Team& team : teams) {
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const Team& other) { return other.id == team.id; });
    if (known == all.end()) {
      all.push_back(std::move(team));
    } else {
      *known = std::move(team);
    }
  }
  teams = std::move(all);
}

}  // namespace

World read_world(const std::string& file, const plugin::Host& host, const ReadOptions& options) {
  return parse_world(read_text(file), file, host, options);
}

World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options) {
  Problems problems;
  const Files files(file, options.data_directories);
  Element root = parse_markup(text, file);
  check_root(root, problems);

  complete_world_ids(root);
  for (const bool before_templates : {true, false}) {
    if (!before_templates) {
      Templates(host, files, problems).merge_all(root);
    }
    for (const std::string& override : options.overrides) {
      if (concerns_templates(override) == before_templates) {
        apply_override(root, override, problems);
      }
    }
  }
  remove_overridden(root, problems);

  Reading reading = TreeReader(host, files, options.check_plugins, problems).read(root);
  World& world = reading.world;
  world.file = file;
  add_default_teams(world.teams);
  colour_teams(world);
  std::stable_partition(world.boxes.begin(), world.boxes.end(),
                        [](const Box& box) { return box.kind != BoxKind::resource; });
  check_world(reading, root, host, problems);
  problems.raise(file);
  return std::move(world);
}

}  // namespace elsie::world
