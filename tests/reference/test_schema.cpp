// The schema accepts what the reader accepts, and refuses what it refuses where a schema can.
#include <filesystem>
#include <fstream>
#include <map>

#include <catch2/catch.hpp>

#include "elsie/plugin/search_path.h"
#include "elsie/reference/schema.h"
#include "elsie/world/writer.h"

#include "fixture.h"
#include "places.h"
#include "schema_judge.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

class Judge : public test::SchemaJudge {
 public:
  explicit Judge(const plugin::Host& host)
      : SchemaJudge(reference::world_schema(host), "world.xsd") {}
};

// Wrong worlds that no schema of this language can refuse, with the reason.
const std::map<std::string, std::string> kBeyondSchemas = {
    {"control_period_too_long", "a product of two attributes"},
    {"drive_wheels_inside", "what the plugin's own code says"},
    {"drive_no_track", "what the plugin's own code says"},
    {"drive_below_floor", "what the plugin's own code says"},
    {"drive_steered_without_limit", "what the plugin's own code says"},
    {"drive_in_the_air", "what the plugin's own code says"},
    {"drive_of_template_in_the_air", "what the plugin's own code says"},
    {"drive_twin_parts", "what the plugin's own code says"},
    {"drive_without_joints", "what the plugin's own code says"},
    {"drive_without_number", "what the plugin's own code says"},
    {"drive_refuses", "what the plugin's own code says"},
    {"schema_of_a_robot", "attributes that XML Schema allows everywhere"},
    {"planar_box_in_the_air", "what the engine cannot simulate"},
    {"planar_robot_in_the_air", "what the engine cannot simulate"},
    {"wheels_inside_each_other", "attributes that depend on each other"},
    {"goal_of_robot_and_team", "attributes that depend on each other"},
    {"goal_of_any_of_one", "attributes that depend on each other"},
    {"goal_of_a_team_without_robots", "which robots there are"},
    {"goal_waits_for_an_unknown_event", "what the plugins of robots raise"},
    {"unknown_robot_in_goal", "layouts may scatter the robot"},
    {"kp_without_kd", "attributes that depend on each other"},
    {"kp_beside_erp", "attributes that depend on each other"},
    {"energy_above_battery", "attributes that depend on each other"},
    {"round_but_not_as_wide", "attributes that depend on each other"},
    {"number_with_blanks", "numbers are stripped of blanks before they are judged"},
    {"parameter_missing_file", "files"},
    {"parameter_file_elsewhere", "files"},
    {"parameters_that_do_not_fit", "what the plugin's own code says"},
    {"parameter_named_like_an_attribute", "the plugin is at fault, not the file"},
    {"reading_missing", "what the plugins of a robot need of each other"},
    {"reading_of_another_version", "what the plugins of a robot need of each other"},
    {"no_coordinator", "it may come from a template"},
    {"held_no_coordinator", "it may come from a template"},
    {"held_no_coordinator_far_inside", "it may come from a template"},
    {"held_no_behaviors", "they may come from a template"},
    {"held_reading_missing", "what the plugins of a robot need of each other"},
    {"held_remove_without_template", "whether there is a template"},
    {"held_rule_about_nobody", "what the plugin's own code says"},
    {"elements_that_do_not_fit", "what the plugin's own code says"},
    {"element_missing_file", "files"},
    {"parameter_that_is_required", "it may come from a template"},
    {"parameter_required_file_empty", "files"},
    {"remove_without_template", "whether there is a template"},
    {"parameter_file_empty", "the default is a file, so that an empty text is none"},
    {"floor_image_a_folder", "files"},
    {"floor_image_broken", "files"},
    {"floor_image_huge", "files"},
    {"floor_image_missing", "files"},
    {"floor_image_no_image", "files"},
    {"image_size_without_image", "attributes that depend on each other"},
    {"field_of_too_many_cells", "attributes that depend on each other"},
    {"lamp_in_a_box", "places"},
    {"lamp_outside", "places"},
    {"line_leaves_the_arena", "places"},
    {"line_of_one_point", "places"},
    {"line_with_a_point_twice", "places"},
    {"patch_not_convex", "places"},
    {"patch_outside", "places"},
    {"template_is_a_folder", "files"},
    {"template_missing", "files"},
    {"template_elsewhere", "files"},
    {"template_is_a_world", "other files"},
    {"template_that_includes_itself", "other files"},
    {"templates_in_a_circle", "other files"},
    {"template_with_a_mistake", "other files"},
    {"template_with_an_id", "other files"},
    {"template_not_closed", "other files"},
    {"template_entry_of_another_plugin", "other files"},
    {"template_has_nothing_to_remove", "other files"},
    {"root_template", "it is a file of the other kind that the schema describes"},
    {"unknown_team", "teams that need not be named in the file"},
    {"unknown_box_in_goal", "boxes with default ids"},
    {"robot_in_a_wall", "places"},
    {"robot_outside", "places"},
    {"robot_in_a_box", "places"},
    {"robot_in_a_robot", "places"},
    {"box_outside", "places"},
    {"dynamic_box_in_a_box", "places"},
    {"dynamic_prism_in_a_cylinder", "places"},
    {"prism_of_two_points", "the form of an outline"},
    {"prism_of_too_many_points", "the form of an outline"},
    {"prism_not_convex", "the form of an outline"},
    {"prism_that_crosses_itself", "the form of an outline"},
    {"prism_without_area", "the form of an outline"},
    {"prism_with_a_point_twice", "the form of an outline"},
    {"resource_in_a_wall", "places"},
    {"change_without_value", "an attribute or an element"},
    {"charger_outside", "places"},
    {"moving_box_path_outside", "places"},
    {"moving_box_stays", "places"},
    {"goal_outside", "places"},
    {"goal_after_the_limit", "attributes that depend on each other"},
    {"goal_nothing_to_collect", "whether goals can be met"},
    {"goal_nothing_of_the_team", "whether goals can be met"},
    {"goal_pushes_a_brick", "whether goals can be met"},
    {"goal_gathers_one", "whether goals can be met"},
    {"goal_relative_to_itself", "attributes that depend on each other"},
    {"measures_that_do_not_fit", "attributes that depend on each other"},
    {"other_encoding", "it is well-formed XML"},
    {"utf16", "it is well-formed XML"},
};

}  // namespace

TEST_CASE("The schema accepts worlds that say everything, as written and as saved") {
  const Judge judge(host());
  CHECK(judge.accepts(kFolder + "data/everything.xml"));
  const std::string saved = test::build_path("everything_saved.xml");
  std::ofstream(saved) << world::write_world(
      world::read_world(kFolder + "data/everything.xml", host(), options()));
  CHECK(judge.accepts(saved));
  fs::remove(saved);
}

TEST_CASE("The schema accepts templates") {
  const Judge judge(host());
  CHECK(judge.accepts(kFolder + "wrong/parts/good.xml"));
  CHECK_FALSE(judge.accepts(kFolder + "wrong/parts/named.xml"));
  CHECK_FALSE(judge.accepts(kFolder + "wrong/parts/mistaken.xml"));
}

TEST_CASE("The schema refuses what the reader refuses, wherever a schema can") {
  const Judge judge(host());
  for (const auto& entry : fs::directory_iterator(kFolder + "wrong")) {
    if (entry.path().extension() == ".xml") {
      const std::string name = entry.path().stem().string();
      CAPTURE(name);
      CHECK(judge.accepts(entry.path().string()) == kBeyondSchemas.contains(name));
    }
  }
}

TEST_CASE("A schema without plugins is a schema") {
  const plugin::Host none;
  const Judge judge(none);
  const std::string file = test::build_path("plain_world.xml");
  std::ofstream(file) << "<world format='1'><robots><robot id='a'/></robots></world>";
  CHECK(judge.accepts(file));
  fs::remove(file);
}

TEST_CASE("The schema takes the elements inside of a plugin's in any order, and no others") {
  const Judge judge(host());
  const std::string file = test::build_path("ordered_world.xml");
  const auto accepts = [&](const std::string& content) {
    std::ofstream(file) << "<world format='1'><robots><robot id='a'><behaviors><blend>" + content +
                               "</blend></behaviors></robot></robots></world>";
    return judge.accepts(file);
  };
  const std::string rule = "<rule of='roam'/>", behaviors = "<behaviors><roam/></behaviors>",
                    coordinator = "<coordinator><pick/></coordinator>";
  const std::vector<std::string> orders = {"",
                                           rule + rule,
                                           behaviors + coordinator,
                                           coordinator + behaviors,
                                           rule + coordinator + rule + behaviors + rule + rule,
                                           behaviors + rule + coordinator,
                                           coordinator + rule};
  for (const std::string& order : orders) {
    CAPTURE(order);
    CHECK(accepts(order));
    CHECK(accepts("<behaviors><blend>" + order + "</blend></behaviors>"));
  }
  for (const std::string& wrong :
       {behaviors + behaviors, coordinator + behaviors + coordinator, behaviors + rule + behaviors,
        std::string("<rule/>"), std::string("<rule of='a' id='b'/>"),
        std::string("<behaviors><roam id='a'/><blend id='a'/></behaviors>"),
        std::string("<behaviors><pick/></behaviors>"), std::string("<roam/>")}) {
    CAPTURE(wrong);
    CHECK_FALSE(accepts(wrong));
    CHECK_FALSE(accepts("<behaviors><blend>" + wrong + "</blend></behaviors>"));
  }
  fs::remove(file);
}

TEST_CASE("The schema accepts every world and robot that is shipped, and the reader reads them") {
  const plugin::Host shipped(
      std::vector<plugin::SearchDirectory>{{test::plugin_directory(), "the build"}});
  const Judge judge(shipped);
  world::ReadOptions reading;
  reading.data_directories = {test::source_path("")};
  reading.check_plugins = true;
  for (const char* folder : {"worlds", "robots"}) {
    if (!fs::exists(test::source_path(folder))) {
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(test::source_path(folder))) {
      if (entry.path().extension() != ".xml") {
        continue;
      }
      const std::string file = entry.path().string();
      CAPTURE(file);
      CHECK(judge.accepts(file));
      if (std::string(folder) == "worlds") {
        CHECK_NOTHROW(world::read_world(file, shipped, reading));
      } else {
        const std::string text =
            "<world format='1'><robots><robot id='r' template='" + file + "'/></robots></world>";
        CHECK_NOTHROW(world::parse_world(text, "world.xml", shipped, reading));
      }
    }
  }
}
