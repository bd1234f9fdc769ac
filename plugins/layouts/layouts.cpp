// Draws the layouts of a world: first walls, then what is scattered, in the order of the file.
#include <set>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/base/near_name.h"
#include "elsie/world/object_reader.h"
#include "elsie/world/vocabulary.h"

#include "drawing.h"
#include "draws.h"
#include "scatter.h"

namespace elsie::layouts {

namespace {

/// A layout of the file: its element, and what its attributes say.
template <class Layout>
struct Read {
  const Element* element;
  Layout layout;
};

struct AllRead {
  std::vector<Read<world::Scatter>> scatters;
  std::vector<Read<world::Maze>> mazes;
  std::vector<Read<world::Rooms>> rooms;
  std::vector<Read<world::FloorPlan>> plans;
  std::vector<PathDraw> draws;
};

/// What the core reads by itself: all but the thing that is scattered.
template <class Layout>
Layout read(const world::ElementSpec& spec, const Element& element, Problems& problems) {
  Element own = element;
  std::erase_if(own.children, [&](const Element& child) {
    const auto* known = spec.child(child.name);
    return child.removed_by || (known && !known->make);
  });
  Layout layout;
  layout.location = element.where;
  world::read_object(spec, own, &layout, problems);
  return layout;
}

AllRead read_all(Drawing& drawing, const Element& layouts) {
  AllRead all;
  const world::ElementSpec& spec = *world::vocabulary().child("layouts");
  std::set<std::string> ids;
  for (const Element& element : layouts.children) {
    if (element.removed_by) {
      continue;
    }
    const world::ElementSpec* known = spec.child(element.name);
    if (!known) {
      std::vector<std::string> tags;
      for (const auto& each : spec.children) tags.push_back("<" + each.name + ">");
      drawing.problems.add(element.where,
                           "<layouts> may not hold <" + element.name + ">" +
                               base::near_or_all("<" + element.name + ">", tags, "it may hold"));
      continue;
    }
    if (!ids.insert(element.value("id")).second) {
      drawing.problems.add(element.where,
                           "a second layout with the id '" + element.value("id") + "'");
    }
    Problems& problems = drawing.problems;
    if (element.name == "scatter") {
      all.scatters.push_back({&element, read<world::Scatter>(*known, element, problems)});
      for (const world::Draw& draw : all.scatters.back().layout.draws) {
        check_draw(drawing, draw, element.value("id"));
      }
    } else if (element.name == "maze") {
      all.mazes.push_back({&element, read<world::Maze>(*known, element, problems)});
    } else if (element.name == "rooms") {
      all.rooms.push_back({&element, read<world::Rooms>(*known, element, problems)});
    } else if (element.name == "floor_plan") {
      all.plans.push_back({&element, read<world::FloorPlan>(*known, element, problems)});
    } else {
      all.draws.emplace_back(drawing, read<world::Draw>(*known, element, problems));
      check_draw(drawing, all.draws.back().draw(), element.value("id"));
    }
  }
  return all;
}

void draw(Drawing& drawing, const Element& layouts) {
  Problems& problems = drawing.problems;
  const std::size_t before = problems.size();
  const auto failed = [&] { return problems.size() > before; };
  if (const Element* arena = drawing.world.child("arena")) {
    world::read_object(*world::vocabulary().child("arena"), *arena, &drawing.arena, problems);
  }
  AllRead all = read_all(drawing, layouts);
  if (failed()) {
    return;
  }
  const bool is_more_expected =
      !all.scatters.empty() || !all.mazes.empty() || !all.rooms.empty() || !all.plans.empty();
  for (PathDraw& each : all.draws) each.apply(drawing, is_more_expected);
  for (const auto& each : all.mazes) draw_maze(drawing, each.layout);
  for (const auto& each : all.rooms) draw_rooms(drawing, each.layout);
  for (const auto& each : all.plans) draw_floor_plan(drawing, each.layout, *each.element);
  if (!failed() && !all.scatters.empty()) {
    Occupied occupied(drawing.arena);
    if (occupied.add_world(drawing)) {
      for (const auto& each : all.scatters) {
        draw_scatter(drawing, each.layout, *each.element, occupied);
      }
    }
  }
  if (!failed() && is_more_expected) {
    for (PathDraw& each : all.draws) each.apply(drawing, false);
  }
}

}  // namespace

}  // namespace elsie::layouts

extern "C" __attribute__((visibility("default"))) void elsie_draw_layouts(
    elsie::world::Element& world, const elsie::world::Element& layouts, std::uint64_t seed,
    const std::string& file, const elsie::plugin::Host& host, const elsie::world::Files& files,
    const elsie::world::ReadOptions& options, elsie::base::Problems& problems) {
  elsie::layouts::Drawing drawing{world, seed, file, host, files, options, problems};
  elsie::layouts::draw(drawing, layouts);
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
