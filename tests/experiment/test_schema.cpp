// The schema accepts what the reader accepts, and refuses what it refuses where a schema can.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/experiment/vocabulary.h"

#include "fixture.h"
#include "schema_judge.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

// Wrong experiments that no schema of this language can refuse, by what it would need to know.
const std::map<std::string, std::vector<std::string>> kBeyondSchemas = {
    {"what is there once among others in any order", {"no_worlds", "no_seeds", "worlds_twice"}},
    {"worlds and what is set in them",
     {"circumstance_a_level", "circumstance_a_world", "circumstance_in_the_world", "set_is_lost",
      "set_no_number", "set_out_of_range", "set_path_to_nowhere", "set_unknown_attribute",
      "set_unknown_robot", "level_changes_nothing", "levels_do_not_fit", "vary_value_out_of_range",
      "vary_value_same_number", "vary_values_without_a_separator", "world_is_wrong"}},
    {"seeds, which no type of number has room for", {"seeds_negative"}},
    {"files",
     {"world_file_empty", "world_in_capitals", "world_is_a_directory", "world_missing",
      "world_is_an_experiment", "set_missing_file"}},
    {"paths",
     {"set_element_at_an_attribute", "set_value_at_an_element", "set_path_with_value",
      "vary_element_values", "vary_element_at_an_attribute", "vary_range_at_an_element",
      "vary_path_for_nothing", "vary_without_a_name"}},
    {"attributes and elements that depend on each other",
     {"set_with_value_and_element",
      "set_without_value",
      "vary_in_two_ways",
      "vary_nothing",
      "vary_without_a_path",
      "level_value_and_element",
      "level_value_without_a_path",
      "level_without_a_label",
      "range_incomplete",
      "range_backwards",
      "seeds_in_two_ways",
      "seeds_say_nothing",
      "seeds_without_an_end",
      "seeds_backwards",
      "seeds_too_many",
      "compared_in_two_ways",
      "expect_about_and_at_most",
      "expect_about_without_tolerance",
      "expect_certainty",
      "expect_confidence_in_the_largest",
      "expect_nothing",
      "expect_rate_above_one",
      "expect_the_impossible"}},
    {"arithmetic",
     {"exclude_everything", "exclude_everything_together", "exclude_twice",
      "more_runs_than_allowed", "range_misses_its_end", "range_too_far_apart", "range_too_fine",
      "grid_too_large", "too_many_runs"}},
    {"labels, titles, and lists in one attribute",
     {"vary_called_world", "vary_value_empty", "vary_value_no_label", "vary_value_twice",
      "vary_values_with_commas", "level_label_bad", "level_label_twice", "world_twice",
      "seeds_no_number", "seeds_none", "seeds_twice", "name_is_empty"}},
    {"sentences in one attribute",
     {"exclude_no_factor",
      "exclude_no_level",
      "expect_compared_with_excluded",
      "expect_excluded",
      "formula_called_like_a_factor",
      "formula_empty",
      "formula_ends_early",
      "formula_no_function",
      "formula_sign",
      "formula_without_a_name",
      "formula_without_measure",
      "meaning_without_formula",
      "unit_without_formula",
      "compared_with_itself",
      "compared_with_several",
      "expect_twice",
      "where_factor_twice",
      "where_no_factor",
      "where_no_level",
      "where_pattern_matches_nothing",
      "where_without_a_level"}},
    {"what is measured",
     {"formula_below", "formula_called_like_a_measure", "formula_factor_of_words",
      "formula_unknown_name", "expect_unknown_measure", "expect_unknown_per",
      "measure_of_two_kinds", "measure_of_two_kinds_by_level", "measure_unknown"}},
    {"it is well-formed XML", {"entity"}},
};

bool is_beyond_schemas(const std::string& name) {
  return std::any_of(kBeyondSchemas.begin(), kBeyondSchemas.end(), [&](const auto& reason) {
    return std::find(reason.second.begin(), reason.second.end(), name) != reason.second.end();
  });
}

class Judge : public test::SchemaJudge {
 public:
  explicit Judge(const plugin::Host& host)
      : SchemaJudge(experiment::experiment_schema(host), "experiment.xsd") {}

  bool accepts_text(const std::string& content) const {
    const std::string file = test::build_path("judged_experiment.xml");
    std::ofstream(file) << "<experiment format='1'>" + content + "</experiment>";
    const bool accepted = accepts(file);
    fs::remove(file);
    return accepted;
  }
};

}  // namespace

TEST_CASE("The schema accepts an experiment that says everything") {
  CHECK(Judge(host()).accepts(kFolder + "data/everything.xml"));
}

TEST_CASE("The schema refuses what the reader refuses, wherever a schema can") {
  const Judge judge(host());
  for (const auto& entry : fs::directory_iterator(kFolder + "wrong")) {
    if (entry.path().extension() == ".xml") {
      const std::string name = entry.path().stem().string();
      CAPTURE(name);
      CHECK(judge.accepts(entry.path().string()) == is_beyond_schemas(name));
    }
  }
}

TEST_CASE("The schema knows the elements that may be set: those of worlds and of plugins") {
  const Judge judge(host());
  const auto accepts = [&](const std::string& element) {
    return judge.accepts_text("<set path='a'>" + element + "</set>");
  };
  CHECK(accepts("<sum weighted='true'/>"));
  CHECK(accepts("<physics step='0.02'/>"));
  CHECK(accepts("<layers><inhibit by='a' of='b'/></layers>"));
  CHECK(accepts("<suppress by='a' of='b' hold_s='1'/>"));
  CHECK(accepts("<blend><behaviors><roam/></behaviors></blend>"));
  CHECK(accepts("<robot x='1'/>"));  // keeps the id of the robot that it replaces
  CHECK_FALSE(accepts("<sum weighted='yes'/>"));
  CHECK_FALSE(accepts("<summ/>"));
  CHECK_FALSE(accepts("<physics step='fast'/>"));
  CHECK_FALSE(accepts("<suppress by='a'/>"));
  CHECK_FALSE(accepts("<experiment format='1'/>"));
}

TEST_CASE("A schema of experiments without plugins is a schema") {
  const plugin::Host none;
  const Judge judge(none);
  CHECK(judge.accepts_text("<worlds><world file='a.xml'/></worlds><seeds from='1' to='2'/>"));
  CHECK_FALSE(judge.accepts_text("<worlds><world file='a.xml'/></worlds><seeds repeats='a'/>"));
}

TEST_CASE("The schema accepts every experiment that is shipped") {
  const plugin::Host shipped(
      std::vector<plugin::SearchDirectory>{{test::plugin_directory(), "the build"}});
  const Judge judge(shipped);
  int count = 0;
  for (const auto& entry : fs::directory_iterator(test::source_path("experiments"))) {
    if (entry.path().extension() == ".xml") {
      ++count;
      const std::string file = entry.path().string();
      CAPTURE(file);
      CHECK(judge.accepts(file));
    }
  }
  CHECK(count > 0);
}
