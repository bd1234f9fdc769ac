// Draws the layouts of a world: first walls, then what is scattered, in the order of the file.
#include <algorithm>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/world/object_reader.h"

#include "described.h"
#include "draws.h"
#include "scatter.h"

namespace elsie::layouts {

namespace {

/// Takes <layouts> out of the world.
Element taken(Element& world, Problems& problems) {
  const auto found = std::stable_partition(world.children.begin(), world.children.end(),
                                           [](const auto& each) { return each.name != "layouts"; });
  Element layouts = std::move(*found);
  if (found + 1 != world.children.end()) {
    problems.add((found + 1)->where, "<world> holds more than one <layouts>");
  }
  world.children.erase(found, world.children.end());
  return layouts;
}

bool are_right(Drawing& drawing, const Described& all) {
  bool right = true;
  for (const Scatter& scatter : all.scatters) {
    for (const Draw& draw : scatter.draws) right &= check_draw(drawing, draw, scatter.id);
  }
  for (const Draw& draw : all.draws) right &= check_draw(drawing, draw, draw.id);
  return right;
}

void draw(Drawing& drawing, const Described& all) {
  const std::size_t before = drawing.problems.size();
  const auto failed = [&] { return drawing.problems.size() > before; };
  const bool is_more_expected =
      !all.scatters.empty() || !all.mazes.empty() || !all.rooms.empty() || !all.plans.empty();
  std::vector<PathDraw> draws;
  for (const Draw& each : all.draws) {
    draws.emplace_back(drawing, each).apply(drawing, is_more_expected);
  }
  for (const Maze& maze : all.mazes) draw_maze(drawing, maze);
  for (const Rooms& rooms : all.rooms) draw_rooms(drawing, rooms);
  for (const FloorPlan& plan : all.plans) draw_floor_plan(drawing, plan);
  if (!failed() && !all.scatters.empty()) {
    Occupied occupied(drawing.arena);
    if (occupied.add_world(drawing)) {
      for (const Scatter& scatter : all.scatters) draw_scatter(drawing, scatter, occupied);
    }
  }
  if (!failed() && is_more_expected) {
    for (PathDraw& each : draws) each.apply(drawing, false);
  }
}

}  // namespace

}  // namespace elsie::layouts

extern "C" __attribute__((visibility("default"))) void elsie_draw_layouts(
    elsie::world::Element& world, const std::string& file, const elsie::plugin::Host& host,
    const elsie::world::Files& files, const elsie::world::ReadOptions& options,
    std::optional<elsie::world::Drawn>& drawn, elsie::base::Problems& problems) {
  namespace layouts = elsie::layouts;
  const std::size_t before = problems.size();
  const elsie::world::Element element = layouts::taken(world, problems);
  elsie::world::Arena arena;
  if (const auto* given = world.child("arena")) {
    elsie::world::read_object(*elsie::world::vocabulary().child("arena"), *given, &arena, problems);
  }
  const layouts::Described all = layouts::described(element, arena, options.seed, problems);
  drawn = {all.seed, all.by_run};
  layouts::Drawing drawing{world, all.seed, file, host, files, options, problems, arena};
  if (problems.size() == before && layouts::are_right(drawing, all)) {
    layouts::draw(drawing, all);
  }
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
