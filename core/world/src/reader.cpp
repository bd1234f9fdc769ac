#include "elsie/world/reader.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "elsie/plugin/host.h"
#include "elsie/world/colours.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/edited_worlds.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/layouts.h"
#include "elsie/world/markup.h"
#include "elsie/world/object_reader.h"
#include "elsie/world/tree.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/world_tree.h"

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

namespace {
// Applies the edits to the tree of a world, and reads it.
World read_edited(Element& root, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options, const World* before = nullptr) {
  Problems problems;
  const Files files(file, options.data_directories, options.edits_from, options.files,
                    options.found);
  std::optional<Drawn> drawn;
  const std::vector<std::string>& edits = options.edits;
  std::set<std::size_t> of_drawn;  // edits of what layouts draw
  const auto apply = [&](std::size_t number) {
    const std::string& edit = edits[number];
    const Concern concern = concern_of(edit);
    if ((options.is_running || drawn) && concern == Concern::templates) {
      problems.add({"--set " + edit, 0},
                   "the content of the template is part of the robot since the start; replace the "
                   "robot, or edit its content");
      return;
    }
    Problems own;
    apply_edit(root, edit, options.is_running, own);
    const bool leads_nowhere = !own.empty() || !own.remarks().empty();
    if (leads_nowhere && root.child("layouts") && !is_about_layouts(edit)) {
      of_drawn.insert(number);
      return;
    }
    problems.add(own);
    if ((options.is_running || drawn) && concern == Concern::robots) {
      merge_templates(root, host, files, problems);
    }
  };
  // A running world has no templates any more: its edits are made in the given order.
  std::vector<std::size_t> order(edits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto later = options.is_running
                         ? order.begin()
                         : std::stable_partition(order.begin(), order.end(), [&](std::size_t each) {
                             return concern_of(edits[each]) >= Concern::robots;
                           });
  std::for_each(order.begin(), later, apply);
  merge_templates(root, host, files, problems);
  std::for_each(later, order.end(), apply);
  draw_layouts(root, file, host, files, options, drawn, problems);
  if (drawn) problems.raise<WorldError>(file);  // what follows would be about what was not drawn
  // The last edit decides: those after one that had to wait are made again, unless they add.
  for (std::size_t i = of_drawn.empty() ? edits.size() : *of_drawn.begin(); i < edits.size(); ++i) {
    const std::string path = edits[i].substr(0, end_of_path(edits[i]));
    if (of_drawn.contains(i)) {
      apply(i);
    } else if (concern_of(path) <= Concern::removed_robots && path.find("[+") == path.npos) {
      Problems made_already;
      apply_edit(root, edits[i], options.is_running, made_already);
    }
  }
  // Boxes of both lists have different ids.
  Element *const obstacles = root.child("obstacles"), *const resources = root.child("resources");
  if (obstacles && resources && obstacles->unread != resources->unread) {
    completed(*obstacles);
    completed(*resources);
  }
  World world = world_of_tree(std::move(root), file, host, files, options, problems, before);
  world.drawn = drawn;
  return world;
}
}  // namespace

World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options) {
  Element root = tree_of_world(text, file);
  return read_edited(root, file, host, options);
}

World edited(WorldTree&& world, const plugin::Host& host, ReadOptions options) {
  options.is_running = true;
  return read_edited(world.begun(), world.world().file, host, options, &world.world());
}

World world_of_tree(Element root, const std::string& file, const plugin::Host& host,
                    const Files& files, const ReadOptions& options, Problems& problems,
                    const World* before) {
  std::optional<Drawn> drawn;
  draw_layouts(root, file, host, files, options, drawn, problems);
  if (drawn) problems.raise<WorldError>(file);  // what follows would be about what was not drawn
  remove_overridden(root);
  Problems of_ids;  // after those of reading, which takes the tree apart
  check_ids(root, vocabulary(), of_ids);
  Reading reading = read_tree(root, host, files, options.check_plugins, problems);
  problems.add(of_ids);
  World& world = reading.world;
  world.file = file;
  world.drawn = drawn;
  add_default_teams(world.teams);
  colour_teams(world);
  read_floor_image(world, root, before, files, problems);
  build_bodies(reading, host, problems);
  std::stable_partition(
      world.obstacles.begin(), world.obstacles.end(),
      [](const Obstacle& obstacle) { return obstacle.kind != ObstacleKind::resource; });
  reading.time_limit_s = options.time_limit_s.value_or(world.limits.time);
  check_world(reading, root, host, options.is_running, problems);
  problems.raise<WorldError>(file);
  world.remarks = problems.remarks();
  if (options.check_plugins && !options.is_running) {
    visit_edited_worlds(world, host, options);
  }
  return std::move(world);
}

}  // namespace elsie::world
