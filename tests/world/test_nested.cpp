// Elements inside a plugin's element: those that it declares, and what a behaviour holds.
#include <algorithm>

#include <catch2/catch.hpp>

#include "elsie/plugin/parameters.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::World everything(std::vector<std::string> edits = {}) {
  return world::read_world(kFolder + "data/everything.xml", host(), options(std::move(edits)));
}

double real(const world::ElementUse& use, const char* name) {
  return std::get<double>(use.parameters.at(name));
}
std::string text(const world::ElementUse& use, const char* name) {
  return std::get<std::string>(use.parameters.at(name));
}

// On which line of the file the text stands.
int line_of(const std::string& text) {
  const std::string file = text_of(kFolder + "data/everything.xml");
  const std::size_t at = file.find(text);
  REQUIRE(at != std::string::npos);
  return 1 + static_cast<int>(std::count(file.begin(), file.begin() + static_cast<long>(at), '\n'));
}

std::string robot(const std::string& content) {
  return "<robots><robot id='r1'>" + content + "</robot></robots>";
}

// A plugin's object as a world configures it.
template <class Class>
plugin::Object<Class> configured(PluginKind kind, const world::PluginUse& use) {
  auto object = host().create<Class>(kind, use.plugin);
  plugin::apply_parameters(*host().find(kind, use.plugin), *object, use.parameters,
                           world::values_of(use.elements));
  return object;
}

}  // namespace

TEST_CASE("Elements that a plugin declares are read in the order of the file") {
  const world::World w = everything();
  const world::PluginUse& layers = *w.robots[1].coordinator;
  REQUIRE(layers.elements.size() == 3);
  CHECK(layers.elements[0].element == "suppress");
  CHECK(text(layers.elements[0], "by") == "avoid");
  CHECK(real(layers.elements[0], "hold_s") == 1.25);
  CHECK(layers.elements[1].element == "inhibit");
  CHECK(layers.elements[2].element == "suppress");
  CHECK_FALSE(layers.elements[2].parameters.contains("hold_s"));
  CHECK(layers.elements[0].location.line == line_of("<suppress by=\"avoid\""));

  const auto object = configured<Layers>(PluginKind::coordinator, layers);
  REQUIRE(object->links.size() == 3);
  CHECK(std::get<Suppress>(object->links[0]).hold_s == 1.25);
  CHECK(std::get<Inhibit>(object->links[1]).of == "avoid");
  CHECK(std::get<Suppress>(object->links[2]).hold_s == 0.5);
}

TEST_CASE("A list that a world gives replaces its defaults; the others keep theirs") {
  const auto eye = [](const std::string& content) {
    const world::World w = read(robot("<sensors><eye>" + content + "</eye></sensors>"));
    return configured<Eye>(PluginKind::sensor, w.robots[0].sensors[0]);
  };
  const std::vector<Threshold> defaults{{0.2, 0.4, "red"}, {0.0, 0.9, "blue"}};
  CHECK(eye("")->thresholds == defaults);
  CHECK(eye("<mask/>")->thresholds == defaults);
  CHECK(eye("<threshold low='0.1'/>")->thresholds == std::vector<Threshold>{{0.1, 1.0, "red"}});
  CHECK(eye("<mask/><mask/>")->masks.size() == 2);
}

TEST_CASE("Files that nested elements name are found like others") {
  const world::World w = everything();
  const auto& elements = w.robots[0].sensors[3].elements;
  const std::string song = std::filesystem::canonical(kFolder + "data/songs/one.txt").string();
  REQUIRE(elements.size() == 4);
  CHECK(text(elements[1], "picture") == song);
  CHECK(elements[1].file_names.at("picture").name.empty());  // the default
  CHECK(text(elements[3], "picture") == song);
  CHECK(elements[3].file_names.at("picture").name == "songs/one.txt");
}

TEST_CASE("A behaviour holds behaviours and their coordinator, to any depth") {
  const world::World w = everything();
  const world::BehaviorUse& explore = w.robots[0].behaviors[3];
  CHECK(explore.id == "explore");
  CHECK(explore.priority == 3);
  CHECK(explore.elements.size() == 2);
  REQUIRE(explore.inside.size() == 1);
  CHECK(explore.inside[0].coordinator->plugin == "sum");
  REQUIRE(explore.inside[0].behaviors.size() == 2);
  CHECK(explore.inside[0].behaviors[0].id == "roam");
  const world::BehaviorUse& inner = explore.inside[0].behaviors[1];
  CHECK(inner.id == "blend");
  CHECK(text(inner.elements.at(0), "of") == "seek");
  REQUIRE(inner.inside.size() == 1);
  CHECK(inner.inside[0].coordinator->id == "inner");
  CHECK(inner.inside[0].coordinator->elements.size() == 1);
  REQUIRE(inner.inside[0].behaviors.size() == 2);
  CHECK(std::get<double>(inner.inside[0].behaviors[0].parameters.at("x")) == 2);
  CHECK(inner.inside[0].behaviors[1].location.line == line_of("<roam id=\"roam\" patience"));
  CHECK(inner.inside[0].behaviors[0].inside.empty());
}

TEST_CASE("Ids of held behaviours are theirs alone") {
  const world::World w = read(robot(R"(
      <behaviors>
        <roam/>
        <blend>
          <behaviors><roam/><roam/><roam id="roam_3"/></behaviors>
          <coordinator><sum/></coordinator>
        </blend>
      </behaviors>
      <coordinator><sum/></coordinator>)"));
  const auto& inside = w.robots[0].behaviors[1].inside.at(0);
  CHECK(inside.behaviors[0].id == "roam");
  CHECK(inside.behaviors[1].id == "roam_2");
  CHECK(inside.behaviors[2].id == "roam_3");
  CHECK(inside.coordinator->id == "sum");
}

TEST_CASE("Forty levels of behaviours are as good as one") {
  std::string content = "<behaviors><roam/></behaviors><coordinator><sum/></coordinator>";
  for (int i = 0; i < 20; ++i) {
    content =
        "<behaviors><blend>" + content + "</blend></behaviors><coordinator><sum/></coordinator>";
  }
  const world::World w = read(robot(content));
  CHECK(
      same(w, world::parse_world(world::write_world(w), kFolder + "world.xml", host(), options())));
  const world::Coordination* level = &w.robots[0];
  int depth = 0;
  for (; !level->behaviors[0].inside.empty(); ++depth) {
    level = &level->behaviors[0].inside[0];
  }
  CHECK(depth == 20);
}

TEST_CASE("All mistakes inside of plugins are reported at once, each on its line") {
  CHECK(problems(robot(R"(
    <sensors>
      <eye sharp="maybe">
        <threshold low="2" hihg="1"/>
        <threshold colour="rd"/>
        <threshhold/>
      </eye>
    </sensors>
    <behaviors>
      <blend haste="3">
        <rule weight="-1"/>
        <behaviors>
          <room/>
          <roam sped="1"/>
        </behaviors>
        <coordinator>
          <layers><suppres by="a"/><suppress by="a"/></layers>
        </coordinator>
      </blend>
    </behaviors>
    <coordinator><sum/></coordinator>)")) ==
        "world.xml:3: sharp=\"maybe\" of <eye>: expected true or false\n"
        "world.xml:4: low=\"2\" of <threshold>: expected a number at least 0 and at most 1 cd\n"
        "world.xml:4: <threshold> has no attribute 'hihg'; did you mean 'high'?\n"
        "world.xml:5: colour=\"rd\" of <threshold>: expected one of 'red', 'blue'; did you mean "
        "'red'?\n"
        "world.xml:6: <eye> may not hold <threshhold>; did you mean '<threshold>'?\n"
        "world.xml:10: haste=\"3\" of <blend>: expected a number at least 0 and at most 2\n"
        "world.xml:11: weight=\"-1\" of <rule>: expected a number at least 0\n"
        "world.xml:11: <rule> lacks the attribute 'of'; expected a text\n"
        "world.xml:13: there is no behavior 'room'; did you mean 'roam'?\n"
        "world.xml:14: <roam> has no attribute 'sped'; did you mean 'speed'?\n"
        "world.xml:17: <layers> may not hold <suppres>; did you mean '<suppress>'?\n"
        "world.xml:17: <suppress> lacks the attribute 'of'; expected a text");
}

namespace {

std::string plan(const std::string& phases) {
  return robot("<behaviors><roam/></behaviors><coordinator><plan>" + phases +
               "</plan></coordinator>");
}

const std::string kPhases = R"(
    <phase name="day">
      <leave to="night" after="2"/>
      <phase name="noon"><phase name="lunch"/><leave event="bored"/><pause name="nap"/></phase>
    </phase>
    <pause/>)";

// "phase day(leave night phase noon(...))"
std::string words(const std::vector<Phase>& phases) {
  std::string text;
  for (const Phase& phase : phases) {
    text += (text.empty() ? "" : " ") + phase.kind + " " + phase.name + "(";
    for (const Leave& leave : phase.leaves) text += leave.to + leave.song + ";";
    text += words(phase.phases) + ")";
  }
  return text;
}

std::string words(const world::World& w) {
  return words(configured<Plan>(PluginKind::coordinator, *w.robots[0].coordinator)->phases);
}

}  // namespace

TEST_CASE("Elements that a plugin declares hold others, to any depth") {
  const world::World w = read(plan(kPhases));
  CHECK(words(w) == "phase day(night;phase noon(bored;phase lunch() pause nap())) pause ()");
  const world::PluginUse& use = *w.robots[0].coordinator;
  const world::ElementUse& noon = use.elements.at(0).elements.at(1);
  CHECK(noon.elements.at(0).location.line == 4);
  CHECK(real(use.elements[0].elements[0], "after") == 2.0);
  CHECK(
      same(w, world::parse_world(world::write_world(w), kFolder + "world.xml", host(), options())));
  CHECK(words(read(plan(""))) == "phase first(second;pause inner())");
  CHECK(words(read(plan("<pause/>"))) == "pause ()");

  std::string deep = "<pause name='deepest'/>";
  for (int i = 0; i < 40; ++i) deep = "<phase name='p'>" + deep + "</phase>";
  const std::string found = words(read(plan(deep)));
  CHECK(found.find("pause deepest()") != std::string::npos);
  CHECK(std::count(found.begin(), found.end(), '(') == 41);
}

TEST_CASE("Mistakes in elements inside elements are reported, each on its line") {
  CHECK(problems(plan(R"(
    <phase name="day">
      <phase><leave after="-1"/></phase>
      <leaf/>
      <pause><phase name="x"/></pause>
      <leave><name/><to/></leave>
    </phase>
    <leave to="night"/>)")) ==
        "world.xml:3: after=\"-1\" of <leave>: expected a number at least 0 s\n"
        "world.xml:3: <phase> lacks the attribute 'name'; expected a text\n"
        "world.xml:4: <phase> may not hold <leaf>; did you mean '<leave>'?\n"
        "world.xml:5: <pause> may not hold <phase>; expected nothing in it\n"
        "world.xml:6: <leave> may not hold <name>; expected nothing in it\n"
        "world.xml:6: <leave> may not hold <to>; its parameters are attributes\n"
        "world.xml:8: <plan> may not hold <leave>; it may hold: <phase>, <pause>");
  CHECK(
      problems(plan(R"(
    <phase name="day"><phase name="noon"><leave event="noone"/></phase></phase>)")) ==
      "world.xml:2: 'plan' is for the event 'noone', which neither the simulator nor a rule nor a "
      "behaviour of the robot 'r1' raises; there are: battery_empty, bored, charging_ended, "
      "charging_started, collected, collision, delivered, released, taken");
}

TEST_CASE("Paths lead into elements inside elements") {
  const auto edited = [](std::vector<std::string> edits) {
    return world::parse_world("<world format='1'>" + plan(kPhases) + "</world>",
                              kFolder + "world.xml", host(), options(std::move(edits)));
  };
  const std::string noon = "robot[r1]/coordinator/phase[1]/phase[name=noon]/";
  const world::World later = edited({noon + "leave[1]/@after=9"});
  CHECK(real(later.robots[0].coordinator->elements[0].elements[1].elements[1], "after") == 9.0);
  CHECK(words(edited({noon + "leave[+]=<leave to='tea'/>"})) ==
        "phase day(night;phase noon(bored;tea;phase lunch() pause nap())) pause ()");
  CHECK(words(edited({noon + "pause/@remove=true"})) ==
        "phase day(night;phase noon(bored;phase lunch())) pause ()");
  CHECK(words(edited({noon + "phase=<pause name='tea'/>"})) ==
        "phase day(night;phase noon(bored;pause tea() pause nap())) pause ()");
}
