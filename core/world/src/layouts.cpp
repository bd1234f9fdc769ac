// The vocabulary of <layouts>, and the call of the library that draws them.
#include "elsie/world/layouts.h"

#include <algorithm>

#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"
#include "elsie/world/facts.h"
#include "elsie/world/object_reader.h"

namespace elsie::world {

namespace {

template <class Area>
Describe<Area> centred(const char* name, const char* meaning) {
  return Describe<Area>(name, meaning)
      .attribute("x", &Area::x, metres("its middle, east"))
      .attribute("y", &Area::y, metres("its middle, north"));
}

template <class Area>
Describe<Area> sized(const char* name, const char* meaning) {
  return centred<Area>(name, meaning)
      .attribute("length", &Area::length, size("along x; by default the arena's", 1e4))
      .attribute("width", &Area::width, size("along y; by default the arena's", 1e4));
}

template <class Kind>
Describe<Kind> named(Describe<Kind> kind) {
  return std::move(kind).attribute(
      "id", &Kind::id, fact("its name; by default its element's, with a number"), kId);
}

Describe<Scatter> regions(Describe<Scatter> scatter) {
  return std::move(scatter)
      .each_of(sized<InBox>("in_box", "Where: anywhere in a rectangle, all places alike")
                   .attribute("heading_deg", &InBox::heading_deg,
                              angle("of the rectangle, counter-clockwise from east")),
               &Scatter::regions)
      .each_of(centred<InDisc>("in_disc", "Where: anywhere in a disc, all places alike")
                   .attribute("radius", &InDisc::radius, size("of the disc", 1e4)),
               &Scatter::regions)
      .each_of(
          centred<InRing>("in_ring", "Where: anywhere between two circles, all places alike")
              .attribute("inner", &InRing::inner, range("m", 0, 1e4, "radius of the inner circle"))
              .attribute("outer", &InRing::outer, size("radius of the outer circle", 1e4)),
          &Scatter::regions)
      .each_of(centred<Gaussian>("gaussian", "Where: about a point, normally distributed")
                   .attribute("sd", &Gaussian::sd,
                              size("standard deviation of each of the two coordinates", 1e4)),
               &Scatter::regions)
      .each_of(
          sized<OnGrid>("on_grid", "Where: in the cells of a grid, one in each, in random order")
              .attribute("columns", &OnGrid::columns, range("", 1, 1000, "cells along x"))
              .attribute("rows", &OnGrid::rows, range("", 1, 1000, "cells along y"))
              .attribute("jitter", &OnGrid::jitter,
                         range("", 0, 1,
                               "how far from the middle of its cell, at most: 1 is to its edge")),
          &Scatter::regions)
      .each_of(Describe<OnLine>("on_line", "Where: along a line")
                   .attribute("x1", &OnLine::x1, metres("its start, east"))
                   .attribute("y1", &OnLine::y1, metres("its start, north"))
                   .attribute("x2", &OnLine::x2, metres("its end, east"))
                   .attribute("y2", &OnLine::y2, metres("its end, north"))
                   .attribute("even", &OnLine::even,
                              fact("whether all have the same distance, from end to end")),
               &Scatter::regions);
}

ElementSpec heading() {
  return Describe<HeadingRule>("heading", "Which way each faces; by default as its element says")
      .attribute("rule", &HeadingRule::rule,
                 {.choices = {"fixed", "uniform", "gaussian", "along", "towards", "away"},
                  .meaning = "fixed: deg; uniform: from from_deg to to_deg; gaussian: about deg; "
                             "along: the line, turned by deg; towards or away from the point x, y, "
                             "turned by deg"})
      .attribute("deg", &HeadingRule::deg, angle("counter-clockwise from east"))
      .attribute("from_deg", &HeadingRule::from_deg, angle("the least"))
      .attribute("to_deg", &HeadingRule::to_deg, angle("the most"))
      .attribute("sd_deg", &HeadingRule::sd_deg, range("deg", 0, 360, "standard deviation"))
      .attribute("x", &HeadingRule::x, metres("of the point, east"))
      .attribute("y", &HeadingRule::y, metres("of the point, north"));
}

Describe<Draw> draw(const char* meaning, const char* path) {
  return Describe<Draw>("draw", meaning)
      .attribute("path", &Draw::path, fact(path), kRequired)
      .attribute("from", &Draw::from, fact("the least value"))
      .attribute("to", &Draw::to, fact("the greatest; all between are alike"))
      .attribute("mean", &Draw::mean, fact("of a normal distribution, with sd; then from and to "
                                           "are bounds, beyond which it is drawn again"))
      .attribute("sd", &Draw::sd, {.min = 0, .meaning = "its standard deviation"})
      .attribute("whole", &Draw::whole, fact("whether it is a whole number"));
}

ElementSpec scatter(const std::vector<ElementSpec>& things) {
  auto spec =
      named(Describe<Scatter>("scatter", "Things of one kind at random places: what, and where"))
          .attribute("count", &Scatter::count, range("", 1, 1e6, "how many; by default 1"))
          .attribute("density", &Scatter::density,
                     {.above = 0,
                      .max = 0.9,
                      .meaning = "instead of count: the share of the area that they cover"})
          .attribute("gap", &Scatter::gap,
                     range("m", 0, 1e3, "the least distance from everything else"))
          .attribute("tries", &Scatter::tries,
                     range("", 1, 1e6, "places that are tried for one thing before giving up"));
  for (const ElementSpec& thing : things) {
    std::move(spec).before_reading(thing);
  }
  return regions(std::move(spec))
      .optional(heading(), &Scatter::heading)
      .each(centred<KeepClear>("keep_clear", "A disc in which none of them stands")
                .attribute("radius", &KeepClear::radius, size("of the disc", 1e4)),
            &Scatter::clear)
      .each(draw("Draws an attribute of each of them, before it is given a place",
                 "from the thing: @length, behavior[roam]/@priority"),
            &Scatter::draws);
}

// `walls`: whether it is an area with walls inside.
template <class Area>
Describe<Area> walled(Describe<Area> area) {
  return named(std::move(area))
      .attribute("wall_thickness", &Area::wall_thickness, size("of its walls", 100))
      .attribute("wall_height", &Area::wall_height, size("of its walls", 100));
}

template <class Area>
Describe<Area> bordered(Describe<Area> area) {
  return walled(std::move(area))
      .attribute("border", &Area::border, fact("whether there are walls around it"));
}

ElementSpec floor_plan() {
  return walled(centred<FloorPlan>("floor_plan", "Walls from an image, a list or the <wall>s in it"))
      .attribute(
          "file", ParameterType::file,
          fact("a PNG or PGM image, or a text with the lines X1 Y1 X2 Y2, m"), {},
          [](void* plan, const ParameterValue& value) {
            static_cast<FloorPlan*>(plan)->file = std::get<std::string>(value);
          },
          [](const void* plan) -> std::optional<ParameterValue> {
            return static_cast<const FloorPlan*>(plan)->file;
          })
      .attribute("metres_per_pixel", &FloorPlan::metres_per_pixel,
                 positive("m", 100, "of an image"))
      .attribute("threshold", &FloorPlan::threshold,
                 range("", 0, 1, "what is darker is a wall: 0 is black, 1 white"))
      .each(Describe<PlanWall>("wall", "A wall from one point to another")
                .attribute("x1", &PlanWall::x1, metres("its start, east of the plan's middle"),
                           kRequired)
                .attribute("y1", &PlanWall::y1, metres("its start, north"), kRequired)
                .attribute("x2", &PlanWall::x2, metres("its end, east"), kRequired)
                .attribute("y2", &PlanWall::y2, metres("its end, north"), kRequired),
            &FloorPlan::walls);
}

}  // namespace

ElementSpec layouts_spec(const std::vector<ElementSpec>& things) {
  ElementSpec spec =
      Describe<Layouts>("layouts", "What is drawn from a seed, before the world runs")
          .members("layout")
          .attribute("seed", &Layouts::seed, {.min = 0, .meaning = "by default the run's"})
          .before_reading(scatter(things))
          .before_reading(
              bordered(sized<Maze>("maze", "A perfect maze: one way from each cell to each other"))
                  .attribute("columns", &Maze::columns, range("", 1, 500, "cells along x"))
                  .attribute("rows", &Maze::rows, range("", 1, 500, "cells along y")))
          .before_reading(
              bordered(sized<Rooms>("rooms", "Rooms, each with a door to another"))
                  .attribute("door", &Rooms::door, size("width of the doors", 100))
                  .attribute("smallest", &Rooms::smallest, size("least side of a room", 1e3)))
          .before_reading(floor_plan())
          .before_reading(named(draw("Draws an attribute of everything at a path, each its own",
                                     "as in `elsie run --set`: robot[*]/@heading_deg")));
  spec.group = true;
  for (ElementSpec& layout : spec.children) {
    layout.at_most = ElementSpec::kAnyNumber;
  }
  return spec;
}

void draw_layouts(Element& world, const std::string& file, const plugin::Host& host,
                  const Files& files, const ReadOptions& options, std::optional<Drawn>& drawn,
                  Problems& problems) {
  const auto found = std::stable_partition(world.children.begin(), world.children.end(),
                                           [](const Element& each) { return each.name != "layouts"; });
  if (found == world.children.end()) {
    return;
  }
  const Element layouts = *found;
  if (found + 1 != world.children.end()) {
    problems.add((found + 1)->where, "<world> holds more than one <layouts>");
  }
  world.children.erase(found, world.children.end());
  Element only_itself = layouts;
  only_itself.children.clear();
  Layouts given;
  read_object(*vocabulary().child("layouts"), only_itself, &given, problems);
  drawn = Drawn{given.seed ? static_cast<std::uint64_t>(*given.seed) : options.seed, !given.seed};
  const auto draw = reinterpret_cast<DrawLayouts*>(
      plugin::part_symbol("layouts", plugin::layouts_file(), "elsie_draw_layouts"));
  draw(world, layouts, drawn->seed, file, host, files, options, problems);
}

}  // namespace elsie::world
