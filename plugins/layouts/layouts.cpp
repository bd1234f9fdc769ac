// Draws the layouts of a world: first walls, then scattered things, in the order of the file.
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

world::Arena arena_of(const Element& world, Problems& problems) {
  world::Arena arena;
  if (const auto* given = world.child("arena")) {
    world::read_object(*world::vocabulary().child("arena"), *given, &arena, problems);
  }
  return arena;
}

bool are_right(Drawing& drawing, const Described& all) {
  bool right = check_draws(drawing, all.draws, std::nullopt);
  for (const Scatter& scatter : all.scatters) {
    right &= check_draws(drawing, scatter.draws, scatter.id);
  }
  return right;
}

void draw(Drawing& drawing, const Element& element, Described all) {
  const std::size_t before = drawing.problems.size();
  const auto failed = [&] { return drawing.problems.size() > before; };
  PathDraws draws(drawing, all.draws);
  if (!draws.empty()) {  // the arena may be drawn, which decides about areas
    draws.apply(drawing);
    drawing.arena = arena_of(drawing.world, drawing.problems);
    all = described(element, drawing.arena, drawing.seed, drawing.problems);
  }
  const auto draw_each = [&](const auto& layouts, const auto& draw_one) {
    for (const auto& each : layouts) {
      drawing.layout = each.element;
      draw_one(each);
    }
  };
  draw_each(all.mazes, [&](const Maze& maze) { draw_maze(drawing, maze); });
  draw_each(all.rooms, [&](const Rooms& rooms) { draw_rooms(drawing, rooms); });
  draw_each(all.plans, [&](const FloorPlan& plan) { draw_floor_plan(drawing, plan); });
  if (!failed() && !all.scatters.empty()) {
    draws.apply(drawing);
    Occupied occupied(drawing.arena);
    if (occupied.add_world(drawing)) {
      draw_each(all.scatters,
                [&](const Scatter& scatter) { draw_scatter(drawing, scatter, draws, occupied); });
    }
  }
  if (!failed()) draws.finish(drawing);
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
  const elsie::world::Arena arena = layouts::arena_of(world, problems);
  const layouts::Described all = layouts::described(element, arena, options.seed, problems);
  drawn = {all.seed, all.by_run};
  layouts::Drawing drawing{world, all.seed, file, host, files, options, problems, arena};
  if (problems.size() == before && layouts::are_right(drawing, all)) {
    layouts::draw(drawing, element, all);
  }
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
