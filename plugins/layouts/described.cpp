#include "described.h"

#include <set>

#include "given.h"

namespace elsie::layouts {

namespace {

using world::ElementSpec;

Area area_of(const Given& given, const world::Arena& arena) {
  return {given["x"], given["y"], given.number("length").value_or(arena.length),
          given.number("width").value_or(arena.width)};
}

InDisc disc_of(const Given& given) { return {given["x"], given["y"], given["radius"]}; }

/// None for an element that is not a region.
std::optional<Region> region_of(const std::string& name, const Given& given,
                                const world::Arena& arena) {
  if (name == "in_box") return InBox{area_of(given, arena), given["heading_deg"]};
  if (name == "in_disc") return disc_of(given);
  if (name == "in_ring") return InRing{given["x"], given["y"], given["inner"], given["outer"]};
  if (name == "gaussian") return Gaussian{given["x"], given["y"], given["sd"]};
  if (name == "on_grid") {
    return OnGrid{area_of(given, arena), given.count("columns"), given.count("rows"),
                  given["jitter"]};
  }
  if (name == "on_line") {
    return OnLine{given["x1"], given["y1"], given["x2"], given["y2"], given.flag("even")};
  }
  return std::nullopt;
}

HeadingRule heading_of(const Given& given, const Location& where) {
  return {given.text("rule"), given["deg"], given["from_deg"], given["to_deg"],
          given["sd_deg"],    given["x"],   given["y"],        where};
}

Draw draw_of(const Given& given, const Element& element) {
  return {element.value("id"),  given.text("path"), given.number("from"), given.number("to"),
          given.number("mean"), given.number("sd"), given.flag("whole"),  element.where};
}

class Reading {
 public:
  Reading(const world::Arena& arena, Problems& problems) : arena_(arena), problems_(problems) {}

  Scatter scatter(const ElementSpec& spec, const Element& element) {
    const Given given(spec, element, problems_);
    Scatter scatter{&element,
                    element.value("id"),
                    given.whole("count"),
                    given.number("density"),
                    given["gap"],
                    given.count("tries"),
                    {},
                    {},
                    {},
                    {},
                    {},
                    element.where};
    for (const Element& child : element.children) {
      const ElementSpec* const known = spec.child(child.name);
      if (!known) continue;  // already reported as a problem
      if (list_of(child.name)) {
        scatter.things.push_back(&child);
        continue;
      }
      if (child.removed_by) continue;
      const Given inside(*known, child, problems_);
      if (const auto region = region_of(child.name, inside, arena_)) {
        scatter.regions.push_back(*region);
      } else if (child.name == "heading") {
        if (scatter.heading) {
          problems_.add(child.where, "<scatter> holds more than one <heading>");
        }
        scatter.heading = heading_of(inside, child.where);
      } else if (child.name == "keep_clear") {
        scatter.clear.push_back(disc_of(inside));
      } else {
        scatter.draws.push_back(draw_of(inside, child));
      }
    }
    return scatter;
  }

  WalledArea walled(const Given& given, const Element& element) const {
    return {&element,
            element.value("id"),
            area_of(given, arena_),
            given["wall_thickness"],
            given["wall_height"],
            given.flag("border"),
            element.where};
  }
  Maze maze(const ElementSpec& spec, const Element& element) {
    const Given given(spec, element, problems_);
    return {walled(given, element), given.count("columns"), given.count("rows")};
  }
  Rooms rooms(const ElementSpec& spec, const Element& element) {
    const Given given(spec, element, problems_);
    return {walled(given, element), given["door"], given["smallest"]};
  }
  FloorPlan plan(const ElementSpec& spec, const Element& element) {
    const Given given(spec, element, problems_);
    FloorPlan plan{&element,
                   element.value("id"),
                   given.text("file"),
                   given["x"],
                   given["y"],
                   given["metres_per_pixel"],
                   given["threshold"],
                   given["wall_thickness"],
                   given["wall_height"],
                   {},
                   element.where};
    for (const Element& child : element.children) {
      if (child.name == "wall" && !child.removed_by) {
        const Given wall(*spec.child("wall"), child, problems_);
        plan.walls.push_back({wall["x1"], wall["y1"], wall["x2"], wall["y2"]});
      }
    }
    return plan;
  }
  Draw draw(const ElementSpec& spec, const Element& element) {
    return draw_of(Given(spec, element, problems_), element);
  }

 private:
  const world::Arena& arena_;
  Problems& problems_;
};

}  // namespace

Described described(const Element& layouts, const world::Arena& arena, std::uint64_t seed_of_run,
                    Problems& problems) {
  const ElementSpec& spec = *world::vocabulary().child("layouts");
  const Given given(spec, layouts, problems);
  Described all;
  all.seed = given.seed("seed").value_or(seed_of_run);
  all.by_run = !given.seed("seed");
  if (const auto* seed = layouts.find("seed");
      layouts.children.empty() && seed && seed->where.line == 0) {
    problems.add(seed->where,
                 "the world has no layouts that could be drawn from a seed; expected "
                 "<layouts> with a <scatter>, <maze>, <rooms>, <floor_plan> or <draw> in it");
  }
  Reading reading(arena, problems);
  std::set<std::string> ids;
  for (const Element& element : layouts.children) {
    const ElementSpec* const known = spec.child(element.name);
    if (!known || element.removed_by) continue;
    if (!ids.insert(element.value("id")).second) {
      problems.add(element.where, "there is another layout with the id '" + element.value("id") +
                                      "'; give one of them another id");
    }
    if (element.name == "scatter") {
      all.scatters.push_back(reading.scatter(*known, element));
    } else if (element.name == "maze") {
      all.mazes.push_back(reading.maze(*known, element));
    } else if (element.name == "rooms") {
      all.rooms.push_back(reading.rooms(*known, element));
    } else if (element.name == "floor_plan") {
      all.plans.push_back(reading.plan(*known, element));
    } else {
      all.draws.push_back(reading.draw(*known, element));
    }
  }
  return all;
}

}  // namespace elsie::layouts
