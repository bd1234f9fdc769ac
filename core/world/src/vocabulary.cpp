#include "elsie/world/vocabulary.h"

#include <algorithm>
#include <set>

#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/facts.h"
#include "elsie/world/layouts.h"

#include "floor_vocabulary.h"
#include "obstacle_shapes.h"

namespace elsie::world {

namespace {

ElementSpec arena() {
  return Describe<Arena>("arena", "The flat rectangular area; its middle is the origin")
      .costs(Cost::engine)
      .attribute("length", &Arena::length, size("along x, between the walls", 1e4))
      .attribute("width", &Arena::width, size("along y, between the walls", 1e4))
      .attribute("wall_height", &Arena::wall_height, size("height of the walls", 100))
      .attribute("wall_thickness", &Arena::wall_thickness,
                 size("thickness of the walls, outside of the area", 100))
      .attribute("walls", &Arena::walls, fact("whether the arena has walls"));
}

// A parameter of an engine, kept in Physics::parameters.
Describe<Physics> with_parameter(Describe<Physics> physics, const AttributeSpec& own) {
  const auto set = [name = own.name](void* object, const ParameterValue& value) {
    static_cast<Physics*>(object)->parameters[name] = value;
  };
  const auto get = [name = own.name, by_default = own.default_value](const void* object) {
    const auto& given = static_cast<const Physics*>(object)->parameters;
    const auto found = given.find(name);
    return found == given.end() ? by_default : std::optional(found->second);
  };
  return std::move(physics).attribute(own.name.c_str(), own.type, own.facts, {}, set, get);
}

ElementSpec physics() {
  std::set<std::string> known;  // parameters of engines
  auto described =
      Describe<Physics>("physics", "Parameters of the physics engine")
          .costs(Cost::engine)
          .attribute("engine", &Physics::engine,
                     {.choices = plugin::engine_names(), .meaning = "the physics engine"})
          .attribute("step", &Physics::step, range("s", 1e-6, 0.1, "length of a step"))
          .attribute("control_steps", &Physics::control_steps,
                     range("", 1, 1000, "steps in one control period"), kCheap)
          .attribute("gravity", &Physics::gravity, range("m/s2", -100, 0, "along z"));
  for (const std::string& engine : plugin::engine_names()) {
    for (const AttributeSpec& own : engine_parameters(engine)) {
      if (known.insert(own.name).second) described = with_parameter(std::move(described), own);
    }
  }
  return std::move(described)
      .attribute("friction", &Physics::friction,
                 range("", 0, 1000,
                       "Coulomb friction of contacts; tyres on the floor hold three times as well"))
      .attribute("wheel_slip", &Physics::wheel_slip,
                 range("m/(s N)", 0, 10, "how fast a wheel slips sideways for each newton"))
      .attribute("bounce", &Physics::bounce, range("", 0, 1, "restitution of contacts"));
}

ElementSpec team() {
  return Describe<Team>("team", "A team of robots; \"red\" and \"blue\" always exist")
      .attribute("id", &Team::id, fact("its name"), kRequiredId)
      .attribute(
          "colour", &Team::colour,
          fact("of its robots and resources in pictures; by default a hue far from all others "
               "in the world"));
}

// The attributes that all kinds of boxes have.
// `place`: what it costs to put one elsewhere.
Describe<Obstacle> obstacle(const std::string& name, const std::string& meaning,
                            ObstacleShape shape = ObstacleShape::box,
                            const AttributeExtras& place = {}) {
  auto placed = Describe<Obstacle>(name, meaning)
                    .costs(Cost::engine)
                    .attribute("id", &Obstacle::id,
                               fact("its name; by default its element's, with a number"), kId)
                    .attribute("x", &Obstacle::x, metres("its middle, east"), place)
                    .attribute("y", &Obstacle::y, metres("its middle, north"), place)
                    .attribute("z", &Obstacle::z, range("m", 0, 100, "its bottom"))
                    .attribute("heading_deg", &Obstacle::heading_deg,
                               angle("counter-clockwise from east"), place);
  return form_of(shape)
      .with_size(std::move(placed))
      .attribute("height", &Obstacle::height, size("along z"))
      .attribute("colour", &Obstacle::colour, fact("in pictures; by default that of its kind"),
                 {.cost = Cost::nothing})
      .attribute("seen_by_range_sensors", &Obstacle::seen_by_range_sensors,
                 fact("whether range and proximity sensors see it"));
}

ElementSpec waypoint() {
  return Describe<Vector2>("waypoint", "A place that a moving obstacle passes")
      .costs(Cost::engine)
      .required()
      .attribute("x", &Vector2::x, metres("east"), kRequired)
      .attribute("y", &Vector2::y, metres("north"), kRequired);
}

ParameterFacts hands() {
  return range(
      "", 1, 100,
      "robots that must hold it before it moves with them; above 1, nothing else moves it");
}

ElementSpec obstacle(ObstacleKind kind, ObstacleShape shape) {
  Obstacle example;
  example.kind = kind;
  example.shape = shape;
  const std::string form = form_of(shape).words;
  if (kind == ObstacleKind::fixed) {
    return obstacle(example.element(), "An obstacle that never moves" + form, shape);
  }
  if (kind == ObstacleKind::dynamic) {
    return obstacle(example.element(), "An obstacle that can be pushed" + form, shape, kLive)
        .attribute("mass", &Obstacle::mass, mass("its mass", 1e6))
        .attribute("hands", &Obstacle::hands, hands());
  }
  return obstacle(
             example.element(),
             "An obstacle that moves from its start through its waypoints; robots cannot push it" +
                 form,
             shape)
      .attribute("speed", &Obstacle::speed, positive("m/s", 100, "along its path"))
      .choice(
          "path", &Obstacle::round_trip,
          {.choices = {"round", "to_and_fro"},
           .meaning = "how it returns from the last waypoint: straight to its start, or back the "
                      "same way"},
          "round")
      .each(waypoint(), &Obstacle::waypoints);
}

ElementSpec resource() {
  return obstacle("resource", "A box that robots collect, or carry to a nest", ObstacleShape::box,
                  kLive)
      .attribute("team", &Obstacle::team, fact("whose robots may take it; by default any"), kTeam)
      .attribute("energy", &Obstacle::energy,
                 range("units", 0, 1e12, "the energy that the collector gains"), kCheap)
      .choice("collect", &Obstacle::to_nest,
              {.choices = {"touch", "nest"},
               .meaning = "what collects it: a robot that touches it, or its release in a nest; "
                          "until then it can be pushed and held"},
              "nest")
      .attribute("mass", &Obstacle::mass, mass("its mass, with collect=\"nest\"", 1e6))
      .attribute("hands", &Obstacle::hands, hands());
}

ElementSpec nest() {
  return Describe<Nest>("nest", "A disc on the floor to which robots carry resources")
      .attribute("id", &Nest::id, fact("its name; by default its element's, with a number"), kId)
      .attribute("team", &Nest::team, fact("whose robots deliver there; by default any"), kTeam)
      .attribute("x", &Nest::x, metres("its middle, east"))
      .attribute("y", &Nest::y, metres("its middle, north"))
      .attribute("radius", &Nest::radius, size("of the disc", 1e4))
      .attribute("colour", &Nest::colour, fact("what sensors, cameras and pictures see"));
}

ElementSpec charger() {
  return Describe<Charger>("charger", "A mark on the floor where robots charge")
      .costs(Cost::engine)
      .attribute("id", &Charger::id, fact("its name; by default its element's, with a number"), kId)
      .attribute("team", &Charger::team, fact("whose robots may charge; by default any"), kTeam)
      .attribute("x", &Charger::x, metres("its middle, east"))
      .attribute("y", &Charger::y, metres("its middle, north"))
      .attribute("radius", &Charger::radius, size("how close a charging robot must be"), kCheap)
      .attribute("rate", &Charger::rate, positive("units/s", 1e12, "the energy that a robot gains"),
                 kCheap)
      .attribute("seen_by_range_sensors", &Charger::seen_by_range_sensors,
                 fact("true: a box of 0.1 m edge, which these sensors see; false: a mark"));
}

// The attributes that say which robots a goal is about.
template <class About>
Describe<About> about_robots(Describe<About> goal) {
  auto described =
      std::move(goal)
          .attribute("robot", &About::robot,
                     fact("which one; by default every robot, or every one of `team`"), kRobot)
          .attribute("team", &About::team, fact("only the robots of this team"), kTeam);
  if constexpr (requires(About about) { about.any; }) {
    return std::move(described).attribute(
        "any", &About::any, fact("whether one of the robots is enough, whichever it is"));
  } else {
    return described;
  }
}

template <class Group>
const ElementSpec& goals_of_group();

// Adds the goals to reach to the element of a world or of a group.
template <class Holder>
Describe<Holder> goals_to_reach(Describe<Holder> list) {
  const auto radius = size("the largest distance that counts");
  return std::move(list)
      .each_of(Describe<CollectGoal>("collect", "To reach: all resources are collected")
                   .attribute("team", &CollectGoal::team, fact("only those of this team"), kTeam),
               &Holder::goals)
      .each_of(
          about_robots(Describe<ReachGoal>("reach", "To reach: a robot is at a place"))
              .attribute("x", &ReachGoal::x, metres("the place, east"), kRequired)
              .attribute("y", &ReachGoal::y, metres("the place, north"), kRequired)
              .attribute("radius", &ReachGoal::radius, radius)
              .attribute("of", &ReachGoal::of,
                         fact("the place is relative to this robot: x ahead of it, y to its left"),
                         kRobot),
          &Holder::goals)
      .each_of(Describe<PushGoal>("push", "To reach: a box is at a place")
                   .attribute("box", &PushGoal::obstacle, fact("which one"),
                              {TextForm::id, Reference::obstacle, true})
                   .attribute("x", &PushGoal::x, metres("the place, east"), kRequired)
                   .attribute("y", &PushGoal::y, metres("the place, north"), kRequired)
                   .attribute("radius", &PushGoal::radius, radius),
               &Holder::goals)
      .each_of(Describe<GatherGoal>(
                   "gather", "To reach: every robot of a team is near another one or its leader")
                   .attribute("team", &GatherGoal::team, fact("which one"),
                              {TextForm::id, Reference::team, true})
                   .attribute("distance", &GatherGoal::distance, radius),
               &Holder::goals)
      .each_of(about_robots(Describe<TravelGoal>("travel", "To reach: a robot has driven this far"))
                   .attribute("distance", &TravelGoal::distance, size("along its way", 1e9)),
               &Holder::goals)
      .each_of(
          about_robots(Describe<EventGoal>("event", "To reach: an event has been raised")
                           .attribute("name", &EventGoal::name, fact("of the event"), kRequired)
                           .attribute("count", &EventGoal::count,
                                      range("", 1, 1e9, "how often, by all these robots"))),
          &Holder::goals)
      .each_of(about_robots(
                   Describe<DeliverGoal>("deliver", "To reach: resources are delivered in nests")
                       .attribute("count", &DeliverGoal::count,
                                  range("", 1, 1e9, "how many, by all these robots"))),
               &Holder::goals)
      .each_of(Describe<EndureGoal>("endure", "To reach: this much simulated time has passed")
                   .attribute("time", &EndureGoal::time, positive("s", 1e9, "how much")),
               &Holder::goals)
      .each_of(Describe<AnyGoal>("any", "To reach: one of the goals in it is reached")
                   .nested(goals_of_group<AnyGoal>),
               &Holder::goals)
      .each_of(Describe<AllGoal>("all", "To reach: all goals in it are reached")
                   .nested(goals_of_group<AllGoal>),
               &Holder::goals);
}

template <class Group>
const ElementSpec& goals_of_group() {
  static const ElementSpec table = goals_to_reach(Describe<Group>("goals", "Goals to reach"));
  return table;
}

Describe<World> goals() {
  return goals_to_reach(Describe<World>("goals",
                                        "A run succeeds if all goals to reach are met and no goal "
                                        "to keep is broken")
                            .members("goal"))
      .each_of(
          about_robots(Describe<NoCollisionGoal>(
              "no_collision", "To keep: a robot touches nothing but the floor and its resources")),
          &World::goals)
      .each_of(about_robots(
                   Describe<BatteryGoal>("battery", "To keep: a robot's battery is never empty")),
               &World::goals);
}

ElementSpec measure() {
  return plugin_use<PluginUse>("measure", "A measure", PluginKind::measure, Cost::object,
                               "the name that its values get; by default the plugin's name, "
                               "with a number if there are several");
}

ElementSpec rule() {
  return plugin_use<PluginUse>("rule", "A rule", PluginKind::rule, Cost::object,
                               "its name; by default the plugin's name, with a number if there are "
                               "several");
}

ElementSpec change() {
  return Describe<TimedEdit>("change", "An edit between two steps, as `elsie run --at` makes it")
      .takes_element(&TimedEdit::element)
      .attribute("time", &TimedEdit::time,
                 range("s", 0, 1e9, "before the first step that begins at this time or after it"),
                 kRequired)
      .attribute("path", &TimedEdit::path, fact("what is edited, as in `elsie run --set`"),
                 kRequired)
      .attribute(
          "value", ParameterType::text,
          fact("of the attribute at the end of the path; a new element stands inside instead"), {},
          [](void* object, const ParameterValue& value) {
            static_cast<TimedEdit*>(object)->value = std::get<std::string>(value);
          },
          [](const void* object) -> std::optional<ParameterValue> {
            const auto& edit = *static_cast<const TimedEdit*>(object);
            return edit.element ? *edit.element : edit.value.value_or("");
          });
}

ElementSpec limits() {
  return Describe<Limits>("limits", "Limits at which a run ends")
      .attribute("time", &Limits::time, positive("s", 1e9, "simulated time"))
      .attribute("wall_time", &Limits::wall_time, positive("s", 1e9, "time on the clock"));
}

ElementSpec learning() {
  return Describe<Learning>("learning", "What a learning agent observes and sets")
      .attribute("robots", &Learning::robots, fact("ids of those that learn, or 'all'"))
      .attribute("observe", &Learning::observe, fact("names of what is observed"))
      .attribute("act", &Learning::act, fact("names of what is set"))
      .attribute("steps", &Learning::steps,
                 range("", 0, 1e9, "of the physics in each of its steps; 0: a control period"))
      .attribute("duration", &Learning::duration,
                 positive("s", 1e9, "of an episode, instead of the limit of time"));
}

// Adds the boxes of one kind and shape to a list.
Describe<World> obstacles(Describe<World> list, ElementSpec obstacle, ObstacleKind kind,
                          ObstacleShape shape = ObstacleShape::box) {
  return std::move(list).each(
      std::move(obstacle), &World::obstacles,
      [=](const Obstacle& each) { return each.kind == kind && each.shape == shape; },
      [=](Obstacle& made) {
        made.kind = kind;
        made.shape = shape;
      });
}

Describe<World> obstacles() {
  auto list = Describe<World>("obstacles", "What stands in the way").members("obstacle");
  for (std::size_t i = 0; i < kBoxShapes.size(); ++i) {
    const auto shape = static_cast<ObstacleShape>(i);
    for (const ObstacleKind kind :
         {ObstacleKind::fixed, ObstacleKind::dynamic, ObstacleKind::moving}) {
      list = obstacles(std::move(list), obstacle(kind, shape), kind, shape);
    }
  }
  return list;
}

ElementSpec world() {
  return root<World>("world", "A world: everything that a run needs")
      .attribute("name", &World::name, fact("its title"))
      .attribute("description", &World::description, fact("what it is for"))
      .one(arena(), &World::arena)
      .one(physics(), &World::physics)
      .group(Describe<World>("teams", "The teams").each(team(), &World::teams))
      .group(obstacles())
      .group(obstacles({"resources", "Boxes to be collected"}, resource(), ObstacleKind::resource))
      .group(Describe<World>("chargers", "Where robots charge").each(charger(), &World::chargers))
      .group(Describe<World>("nests", "Where resources are delivered").each(nest(), &World::nests))
      .group(Describe<World>("lamps", "Where light comes from").each(lamp(), &World::lamps))
      .one(floor(), &World::floor)
      .group(patches())
      .group(Describe<World>("fields", "Numbers over the floor").each(field(), &World::fields))
      .group(Describe<World>("robots", "The robots").each(robot_spec(), &World::robots))
      .group(goals())
      .group(Describe<World>("measures", "Additional measures of a run")
                 .each(measure(), &World::measures))
      .group(Describe<World>("rules", "What changes the world while it runs")
                 .each(rule(), &World::rules))
      .group(Describe<World>("changes", "Edits of the world while it runs")
                 .each(change(), &World::edits))
      .one(limits(), &World::limits)
      .one(learning(), &World::learning);
}

}  // namespace

const AttributeSpec* ElementSpec::attribute(const std::string& attribute_name) const {
  return plugin::find_declared(attributes, attribute_name);
}

const ElementSpec* ElementSpec::child(const std::string& child_name) const {
  return plugin::find_declared(held(), child_name);
}

const std::vector<ElementSpec>& ElementSpec::below() const {
  return inside ? coordination_vocabulary().children : held();
}

std::vector<std::pair<DescribedObject, const ElementSpec*>> ElementSpec::parts_of(
    const void* object) const {
  std::vector<std::pair<DescribedObject, const ElementSpec*>> found;
  for (const ElementSpec& child : held()) {
    if (!child.parts) continue;  // it has no objects
    for (const DescribedObject& part : child.parts(object)) {
      found.push_back({part, &child});
    }
  }
  if ((group && children.size() > 1) || nested) {
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first.order < b.first.order; });
  }
  return found;
}

std::vector<AttributeSpec> engine_parameters(const std::string& engine) {
  std::vector<AttributeSpec> parameters;
  try {
    reinterpret_cast<EngineParameters>(plugin::engine_symbol(engine, "elsie_engine_parameters"))(
        parameters);
  } catch (const plugin::PluginError&) {
    return {};  // reported where a world uses the engine
  }
  return parameters;
}

const ElementSpec& vocabulary() {
  static const ElementSpec table = with_layouts(world());
  return table;
}

}  // namespace elsie::world
