#include "elsie/world/reader.h"

#include <algorithm>
#include <utility>

#include "elsie/plugin/host.h"
#include "elsie/world/ahead.h"
#include "elsie/world/colours.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/layouts.h"
#include "elsie/world/markup.h"
#include "elsie/world/object_reader.h"
#include "elsie/world/tree.h"
#include "elsie/world/vocabulary.h"

#include "ids.h"
#include "reading.h"

namespace elsie::world {

namespace {

// Every world has "red" and "blue"; the file may change their colours and add others.
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
  const std::string found = find_document(file, options.data_directories);
  return parse_world(read_text(found), found, host, options);
}

Element tree_of_world(std::string_view text, const std::string& file,
                      std::vector<ElementSpan>* spans) {
  Element root = parse_markup(text, file, "world", spans);
  Problems problems;
  const std::string right = "expected <world format=\"" + std::to_string(kFormat) + "\">";
  check_root(root, "world", kFormat,
             {{"robot_template", "this file is a template of a robot; " + right +
                                     ", in which a <robot template=\"...\"> may use the template"},
              {"experiment", "this file is an experiment, which names worlds; " + right}},
             problems);
  std::size_t count = 0;
  for_each_element(root, [&](Element& element) { element.object = count++; });
  complete_ids(root, vocabulary());
  return root;
}

World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options) {
  Problems problems;
  const Files files(file, options.data_directories, options.overrides_from, options.files,
                    options.found);
  Element root = tree_of_world(text, file);
  std::optional<Drawn> drawn;
  std::vector<std::string> of_drawn;  // edits of what layouts draw
  const auto apply = [&](const std::string& override) {
    const Concern concern = concern_of(override);
    if ((options.is_running || drawn) && concern == Concern::templates) {
      problems.add({"--set " + override, 0},
                   "what the template brings is in the robot since the start; replace the robot, "
                   "or edit what is in it");
      return;
    }
    Problems own;
    apply_override(root, override, options.is_running, own);
    if (!own.empty() && root.child("layouts") && !is_about_layouts(override)) {
      of_drawn.push_back(override);
      return;
    }
    problems.add(own);
    if ((options.is_running || drawn) && concern == Concern::robots) {
      merge_templates(root, host, files, problems);
    }
  };
  // What runs has no templates any more: its edits are made in the order given.
  std::vector<std::string> overrides = options.overrides;
  const auto later =
      options.is_running
          ? overrides.begin()
          : std::stable_partition(overrides.begin(), overrides.end(), [](const auto& override) {
              return concern_of(override) >= Concern::robots;
            });
  std::for_each(overrides.begin(), later, apply);
  merge_templates(root, host, files, problems);
  std::for_each(later, overrides.end(), apply);
  draw_layouts(root, file, host, files, options, drawn, problems);
  if (drawn) problems.raise<WorldError>(file);  // what follows would be about what was not drawn
  std::for_each(of_drawn.begin(), of_drawn.end(), apply);
  World world = world_of_tree(std::move(root), file, host, files, options, problems);
  world.drawn = drawn;
  return world;
}

World world_of_tree(Element root, const std::string& file, const plugin::Host& host,
                    const Files& files, const ReadOptions& options, Problems& problems) {
  std::optional<Drawn> drawn;
  draw_layouts(root, file, host, files, options, drawn, problems);
  if (drawn) problems.raise<WorldError>(file);  // what follows would be about what was not drawn
  remove_overridden(root);
  Reading reading = read_tree(root, host, files, options.check_plugins, problems);
  World& world = reading.world;
  world.file = file;
  world.drawn = drawn;
  add_default_teams(world.teams);
  colour_teams(world);
  build_bodies(reading, host, problems);
  std::stable_partition(world.boxes.begin(), world.boxes.end(),
                        [](const Box& box) { return box.kind != BoxKind::resource; });
  check_world(reading, root, host, options.is_running, problems);
  problems.raise<WorldError>(file);
  if (options.check_plugins && !options.is_running) {
    worlds_ahead(world, host, options);
  }
  return std::move(world);
}

}  // namespace elsie::world
