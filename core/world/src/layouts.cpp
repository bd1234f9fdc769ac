// The vocabulary of <layouts>, and the call of the library that draws them.
#include "elsie/world/layouts.h"

#include "elsie/plugin/engine_libraries.h"
#include "elsie/world/facts.h"

namespace elsie::world {
namespace {
constexpr std::optional<double> kNone;
constexpr std::optional<std::int64_t> kNoCount;

// `value`: the default, of the attribute's type; an optional without a value has none.
template <class Member>
AttributeSpec given(const char* name, Member value, ParameterFacts facts) {
  AttributeSpec attribute;
  attribute.name = name;
  attribute.type = detail::type_of<decltype(held_by(value))>();
  const std::optional<decltype(held_by(value))>& held = value;
  if (held) attribute.default_value = detail::to_value(*held);
  attribute.facts = std::move(facts);
  return attribute;
}
AttributeSpec required(AttributeSpec attribute) {
  attribute.required = true;
  attribute.default_value.reset();
  return attribute;
}

ElementSpec element(const char* name, const char* meaning, std::vector<AttributeSpec> attributes,
                    std::vector<ElementSpec> children = {},
                    std::size_t at_most = ElementSpec::kAnyNumber) {
  ElementSpec spec;
  spec.name = name;
  spec.meaning = meaning;
  spec.attributes = std::move(attributes);
  spec.children = std::move(children);
  spec.at_most = at_most;
  return spec;
}
}  // namespace

ElementSpec with_layouts(ElementSpec world) {
  AttributeSpec id = given("id", std::optional<std::string>(),
                           fact("its name; by default its element's, with a number"));
  id.form = TextForm::id;
  const auto x = given("x", 0.0, metres("its middle, east"));
  const auto y = given("y", 0.0, metres("its middle, north"));
  const auto length = given("length", kNone, size("along x; by default the arena's", 1e4));
  const auto width = given("width", kNone, size("along y; by default the arena's", 1e4));
  const auto x1 = given("x1", -1.0, metres("its start, east"));
  const auto y1 = given("y1", 0.0, metres("its start, north"));
  const auto x2 = given("x2", 1.0, metres("its end, east"));
  const auto y2 = given("y2", 0.0, metres("its end, north"));
  const auto thickness = given("wall_thickness", 0.1, size("of its walls", 100));
  const auto height = given("wall_height", 0.3, size("of its walls", 100));
  const auto border = given("border", false, fact("whether there are walls around it"));
  const auto radius = given("radius", 1.0, size("of the disc", 1e4));
  AttributeSpec file = given("file", std::string(),
                             fact("a PNG or PGM image, or a text with the lines X1 Y1 X2 Y2, m"));
  file.type = ParameterType::file;
  const std::vector<AttributeSpec> draws{
      required(given("path", std::string(),
                     fact("of the attribute: in a <scatter> from the thing, as @length; else as in "
                          "`elsie run --set`"))),
      given("from", kNone, fact("the least value")),
      given("to", kNone, fact("the greatest value; with from, all between are alike")),
      given("mean", kNone,
            fact("of a normal distribution; values beyond from and to are drawn again")),
      given("sd", kNone, {.min = 0, .meaning = "its standard deviation"}),
      given("whole", false, fact("whether it is a whole number"))};
  std::vector<AttributeSpec> named_draws = draws;
  named_draws.insert(named_draws.begin(), id);

  std::vector<ElementSpec> in_scatter;
  for (const char* const list :
       {"obstacles", "resources", "chargers", "nests", "lamps", "patches", "robots"}) {
    for (ElementSpec thing : world.child(list)->children) {
      thing.make = nullptr;
      thing.at_most = 1;
      in_scatter.push_back(std::move(thing));
    }
  }
  for (ElementSpec& spec : std::vector<ElementSpec>{
           element("in_box", "Where: anywhere in a rectangle, all places alike",
                   {x, y, length, width, given("heading_deg", 0.0, angle("of the rectangle"))}),
           element("in_disc", "Where: anywhere in a disc, all places alike", {x, y, radius}),
           element("in_ring", "Where: anywhere between two circles, all places alike",
                   {x, y, given("inner", 1.0, range("m", 0, 1e4, "radius of the inner circle")),
                    given("outer", 2.0, size("radius of the outer circle", 1e4))}),
           element("gaussian", "Where: about a point, normally distributed",
                   {x, y, given("sd", 1.0, size("standard deviation of each coordinate", 1e4))}),
           element("on_grid", "Where: in the cells of a grid, one in each, in random order",
                   {x, y, length, width, given("columns", 3, range("", 1, 1000, "cells along x")),
                    given("rows", 3, range("", 1, 1000, "cells along y")),
                    given("jitter", 0.0,
                          range("", 0, 1, "from the middle of its cell; 1 is to its edge"))}),
           element("on_line", "Where: along a line",
                   {x1, y1, x2, y2,
                    given("even", false, fact("whether at equal distances, from end to end"))}),
           element("heading", "Which way each faces; by default as its element says",
                   {given("rule", std::string("uniform"),
                          {.choices = {"fixed", "uniform", "gaussian", "along", "towards", "away"},
                          .meaning = "fixed: deg; uniform: from from_deg to to_deg; gaussian: "
                                     "about deg; along: the line, turned by deg; towards or away: "
                                     "from the point x, y, turned by deg"}),
                    given("deg", 0.0, angle("counter-clockwise from east")),
                    given("from_deg", 0.0, angle("the least")),
                    given("to_deg", 360.0, angle("the most")),
                    given("sd_deg", 30.0, range("deg", 0, 360, "standard deviation")),
                    given("x", 0.0, metres("of the point, east")),
                    given("y", 0.0, metres("of the point, north"))},
                   {}, 1),
           element("keep_clear", "A disc in which none of them stands", {x, y, radius}),
           element("draw", "Draws an attribute of each thing, before it is given a place",
                   draws)}) {
    in_scatter.push_back(std::move(spec));
  }
  ElementSpec layouts = element(
      "layouts", "What is drawn from a seed, before the world runs",
      {given("seed", kNoCount, range("", 0, 9007199254740992.0, "by default the run's"))},
      {element("scatter", "Things of one kind at random places: what, and where",
               {id, given("count", kNoCount, range("", 0, 999999, "how many; by default 1")),
                given("density", kNone,
                      {.above = 0,
                       .max = 0.9,
                       .meaning = "instead of count: the share of the area that they cover"}),
                given("gap", 0.05, range("m", 0, 1e3, "the least distance from everything else")),
                given("tries", 1000,
                      range("", 1, 999999, "places tried for a thing before giving up"))},
               in_scatter),
       element("maze", "A perfect maze: one way from each cell to each other",
               {id, x, y, length, width, thickness, height, border,
                given("columns", 6, range("", 1, 500, "cells along x")),
                given("rows", 6, range("", 1, 500, "cells along y"))}),
       element("rooms", "Rooms, each with a door to another",
               {id, x, y, length, width, thickness, height, border,
                given("door", 0.8, size("width of the doors", 100)),
                given("smallest", 1.5, size("least side of a room"))}),
       element("floor_plan", "Walls from an image, a list or the <wall>s in it",
               {id, x, y, thickness, height, file,
                given("metres_per_pixel", 0.05, positive("m", 100, "of an image")),
                given("threshold", 0.5,
                      range("", 0, 1, "what is darker is a wall: 0 is black, 1 white"))},
               {element("wall", "A wall from one point to another",
                        {required(x1), required(y1), required(x2), required(y2)})}),
       element("draw", "Draws an attribute of everything at a path, each its own", named_draws)},
      1);
  layouts.group = true;
  layouts.members = "layout";
  world.children.push_back(std::move(layouts));
  return world;
}

void draw_layouts(Element& world, const std::string& file, const plugin::Host& host,
                  const Files& files, const ReadOptions& options, std::optional<Drawn>& drawn,
                  Problems& problems) {
  if (world.child("layouts")) {
    reinterpret_cast<DrawLayouts*>(
        plugin::part_symbol("layouts", plugin::part_file("layouts"), "elsie_draw_layouts"))(
        world, file, host, files, options, drawn, problems);
  }
}

}  // namespace elsie::world
