#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/batch/plan.h"
#include "elsie/results/hash.h"
#include "elsie/world/error.h"
#include "elsie/world/reader.h"
#include "elsie/world/writer.h"

#include "support.h"

using namespace elsie;
using Catch::Contains;

TEST_CASE_METHOD(test::SmallBatch,
                 "A plan has every cell and every run, in the order of the grid") {
  CHECK(plan.factors == std::vector<std::string>{"world", "speed"});
  REQUIRE(plan.cells.size() == 2);
  CHECK(plan.cells[0].label == "slow");
  CHECK(plan.cells[1].label == "fast");
  CHECK(plan.cells[1].levels == std::vector<std::string>{"small", "fast"});
  CHECK(plan.cells[1].places == std::vector<std::size_t>{0, 1});
  REQUIRE(plan.runs.size() == 6);
  CHECK(plan.all_runs == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(plan.runs[i].id == static_cast<std::int64_t>(i) + 1);
    CHECK(plan.runs[i].cell == i / 3);
    CHECK(plan.runs[i].seed == std::vector<std::uint64_t>{1, 2, 18446744073709551615U}[i % 3]);
  }
}

TEST_CASE("Repetitions of a seed are adjacent") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.repeats = 2;
  const auto plan = test::plan_of(experiment);
  REQUIRE(plan.runs.size() == 12);
  CHECK(plan.runs[1].repetition == 2);
  CHECK(plan.runs[1].seed == plan.runs[0].seed);
  CHECK(plan.runs[2].seed != plan.runs[0].seed);
}

TEST_CASE("Runs are done seed by seed, with repetitions last, whatever is done already") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.repeats = 2;
  const auto in_words = [](const batch::Plan& plan, const std::vector<std::int64_t>& pending) {
    std::string words;
    for (const batch::PlannedRun& run : batch::in_order(plan, pending)) {
      words += plan.cells[run.cell].label + " " + std::to_string(run.seed).substr(0, 2) + "." +
               std::to_string(run.repetition) + ", ";
    }
    return words;
  };
  const auto all_of = [](const batch::Plan& plan) {
    std::vector<std::int64_t> ids;
    for (const batch::PlannedRun& run : plan.runs) {
      ids.push_back(run.id);
    }
    return ids;
  };
  const auto plan = test::plan_of(experiment);
  CHECK(in_words(plan, all_of(plan)) ==
        "slow 1.1, fast 1.1, slow 2.1, fast 2.1, slow 18.1, fast 18.1, "
        "slow 1.2, fast 1.2, slow 2.2, fast 2.2, slow 18.2, fast 18.2, ");
  CHECK(in_words(plan, {3, 4, 5, 7}) == "fast 1.1, slow 2.1, slow 18.1, slow 2.2, ");
  // Each shard by itself.
  const auto part = test::plan_of(experiment, {1, 3});
  CHECK(in_words(part, all_of(part)) == "slow 1.1, fast 1.1, slow 2.2, fast 2.2, ");
  CHECK_THROWS_AS(batch::in_order(plan, {13}), std::out_of_range);
}

TEST_CASE_METHOD(
    test::SmallBatch,
    "A cell's world is one text with all that is set in it, and names every data file") {
  const batch::PlannedCell& cell = plan.cells[0];
  CHECK_THAT(cell.world_text, Contains("max_speed=\"0.1\""));
  CHECK_THAT(cell.world_text, Contains("left_model=\"fuzzy_models/avoid_obstacle_left.fcl\""));
  CHECK(cell.sha256 == results::sha256(cell.world_text));
  REQUIRE(cell.data.size() == 2);
  CHECK(cell.data[0].name == "fuzzy_models/avoid_obstacle_left.fcl");
  const batch::PlannedFile& model = plan.files[cell.data[0].file];
  CHECK(model.path == test::source_path("fuzzy_models/avoid_obstacle_left.fcl"));
  CHECK(model.content == results::file_content(model.path));
  CHECK(model.sha256 == results::sha256(model.content));
  std::vector<std::string> plugins;
  for (const std::size_t plugin : cell.plugins) {
    plugins.push_back(plan.plugins[plugin].kind + " " + plan.plugins[plugin].name);
    CHECK(plan.plugins[plugin].file);
  }
  CHECK(plugins.size() == 5);
  CHECK(std::find(plugins.begin(), plugins.end(), "coordinator arbiter_suppression") !=
        plugins.end());
  CHECK(plan.libraries(cell).size() == 5);
  CHECK(plan.files[0].kind == batch::FileKind::library);
  CHECK_THAT(plan.files[0].path, Contains("libelsie.so"));
}

TEST_CASE("The libraries that decide a cell are those that its worlds need") {
  const test::Folder folder;
  using Names = std::vector<std::string>;
  const auto program_of = [&](const std::vector<std::pair<std::string, std::string>>& edits) {
    std::string text = test::kWorld;
    for (const auto& [before, after] : edits) {
      text.replace(text.find(before), before.size(), after);
    }
    auto experiment = test::small_experiment(folder);
    folder.write("small.xml", text);
    const auto plan = test::plan_of(experiment);
    CHECK(plan.program() == plan.cells[0].program);
    Names names;
    for (const std::size_t file : plan.cells[0].program) {
      CHECK(plan.files[file].kind == batch::FileKind::library);
      const std::string name = std::filesystem::path(plan.files[file].path).filename().string();
      names.push_back(name.substr(0, name.find('.')));
    }
    std::sort(names.begin(), names.end());
    return names;
  };
  const Names plain{"libelsie", "libelsie-base", "libelsie-inference", "libode", "ode"};
  CHECK(program_of({}) == plain);
  CHECK(program_of({{"<limits", "<physics engine=\"planar\"/><limits"}}) ==
        Names{"libelsie", "libelsie-base", "libelsie-inference", "planar"});
  const Names cameras{"libelsie",
                      "libelsie-base",
                      "libelsie-inference",
                      "libelsie-render",
                      "libelsie-vision",
                      "libode",
                      "ode"};
  CHECK(program_of({{"<sensors>", "<sensors><vision/>"}}) == cameras);
  // A robot that an edit adds may have one.
  CHECK(program_of({{"</world>",
                     "<changes><change time=\"1\" path=\"robot[r1]/sensor[+]\" "
                     "value=\"&lt;vision/>\"/></changes></world>"}}) == cameras);
  CHECK(
      program_of(
          {{"</world>",
            "<layouts><scatter id=\"s\" gap=\"0.3\"><static_box/></scatter></layouts></world>"}}) ==
      Names{"layouts", "libelsie", "libelsie-base", "libelsie-inference", "libode", "ode"});
  folder.write("floor.pgm", "P2 1 1 255 7");
  CHECK(program_of({{"<limits", "<floor image=\"floor.pgm\"/><limits"}}) ==
        Names{"images", "libelsie", "libelsie-base", "libelsie-inference", "libode", "ode"});
}

TEST_CASE("The image of a floor is a data file of its cell, and part of the fingerprint") {
  const test::Folder folder;
  const auto plan_with = [&](const std::string& pixel) {
    folder.write("floor.pgm", "P2 1 1 255 " + pixel);
    const auto experiment = test::small_experiment(folder);
    std::string text = test::kWorld;
    text.replace(text.find("<limits"), 7, "<floor image=\"floor.pgm\"/><limits");
    folder.write("small.xml", text);
    return test::plan_of(experiment);
  };
  const auto plan = plan_with("7");
  world::ReadOptions options;
  for (const auto& data : plan.cells[0].data) {
    options.files[data.name] = plan.files[data.file].path;
  }
  CHECK(options.files.contains("floor.pgm"));
  const world::World world =
      world::parse_world(plan.cells[0].world_text, "/nowhere/w.xml", test::shipped(), options);
  REQUIRE(world.floor.pixels);
  CHECK(world.floor.pixels->bytes == std::vector<std::uint8_t>{7, 7, 7});
  CHECK(plan_with("7").fingerprint == plan.fingerprint);
  CHECK(plan_with("8").fingerprint != plan.fingerprint);
}

TEST_CASE("A world's measures are among its plugins, and in its text") {
  const test::Folder folder;
  std::string text = test::kWorld;
  text.insert(text.rfind("</world>"), "<measures><coverage cell=\"0.25\"/></measures>");
  experiment::Experiment experiment = test::small_experiment(folder);
  folder.write("small.xml", text);
  const batch::Plan plan = test::plan_of(experiment);
  const batch::PlannedCell& cell = plan.cells[0];
  CHECK_THAT(cell.world_text, Contains("<coverage id=\"coverage\" cell=\"0.25\"/>"));
  CHECK(std::any_of(cell.plugins.begin(), cell.plugins.end(), [&](std::size_t plugin) {
    return plan.plugins[plugin].kind == "measure" && plan.plugins[plugin].name == "coverage" &&
           plan.plugins[plugin].file.has_value();
  }));
  CHECK(plan.libraries(cell).size() == 6);
}

TEST_CASE_METHOD(test::SmallBatch,
                 "The text of a cell is all of its world, wherever the files are by then") {
  const test::Folder elsewhere;
  world::ReadOptions options;
  for (const auto& data : plan.cells[0].data) {
    options.files[data.name] = elsewhere.write(std::filesystem::path(data.name).filename().string(),
                                               plan.files[data.file].content);
  }
  const world::World world =
      world::parse_world(plan.cells[0].world_text, "/nowhere/w.xml", test::shipped(), options);
  CHECK(world.robots[0].max_speed == 0.1);
  CHECK(std::get<std::string>(world.robots[0].behaviors[1].parameters.at("left_model")) ==
        elsewhere.file("avoid_obstacle_left.fcl"));
}

TEST_CASE("Two files of one name have different names in a cell's text") {
  const test::Folder folder;
  const std::string name = "fuzzy_models/avoid_obstacle_left.fcl";
  const std::string model = results::file_content(test::source_path(name));
  std::string text = test::kWorld;
  text.replace(text.find("<avoid_obstacle/>"), 17,
               "<avoid_obstacle right_model=\"" + name + "\"/>");
  // The default is in a data directory, the world's own file is next to the world.
  const auto plan_in = [&](const test::Folder& place, const std::string& own) {
    place.write(name, own);
    const auto experiment = test::small_experiment(place);
    place.write("small.xml", text);
    return test::plan_of(experiment);
  };
  const auto plan = plan_in(folder, model + "// another one\n");
  const batch::PlannedCell& cell = plan.cells[0];
  REQUIRE(cell.data.size() == 2);
  world::ReadOptions options;
  for (const auto& data : cell.data) {
    options.files[data.name] = plan.files[data.file].path;
  }
  const world::World world =
      world::parse_world(cell.world_text, "/nowhere/w.xml", test::shipped(), options);
  const auto& parameters = world.robots[0].behaviors[1].parameters;
  const auto content = [&](const char* parameter) {
    return results::file_content(std::get<std::string>(parameters.at(parameter)));
  };
  CHECK(content("left_model") == model);
  CHECK(content("right_model") == model + "// another one\n");

  // Where they are does not change the experiment.
  const test::Folder copy;
  CHECK(plan_in(copy, model + "// another one\n").fingerprint == plan.fingerprint);
  CHECK(plan_in(copy, model + "// yet another\n").fingerprint != plan.fingerprint);
}

TEST_CASE("The fingerprint follows from what decides the runs, and from nothing else") {
  const test::Folder folder;
  const std::string before = test::small_plan(folder).fingerprint;
  CHECK(before.size() == 64);
  CHECK(test::small_plan(folder).fingerprint == before);
  const auto changed = [&](auto change) {
    auto experiment = test::small_experiment(folder);
    change(experiment);
    return test::plan_of(experiment).fingerprint != before;
  };
  using experiment::Experiment;
  CHECK(changed([](Experiment& e) { e.seeds.back() = 3; }));
  CHECK(changed([](Experiment& e) { e.repeats = 2; }));
  CHECK(changed([](Experiment& e) { e.factors[0].levels[0].label = "slower"; }));
  CHECK(changed([](Experiment& e) { e.settings = {test::setting("arena/@length", "12")}; }));
  CHECK_FALSE(changed([](Experiment& e) { e.description = "another"; }));
  CHECK_FALSE(changed([](Experiment& e) { e.wall_limit = 5.0; }));
  auto options = test::plan_options();
  options.elsie_version = "1.2.4";
  CHECK(batch::make_plan(test::small_experiment(folder), test::shipped(), options).fingerprint !=
        before);
  CHECK(test::small_plan(folder, {2, 3}).fingerprint == before);
  // A copy of everything in another folder, with its data files, is the same experiment.
  const test::Folder copy;
  options = test::with_models_in(copy);
  const auto elsewhere = test::small_experiment(copy);
  CHECK(batch::make_plan(elsewhere, test::shipped(), options).fingerprint == before);
  copy.write("fuzzy_models/avoid_obstacle_left.fcl",
             copy.read("fuzzy_models/avoid_obstacle_left.fcl") + " ");
  CHECK(batch::make_plan(elsewhere, test::shipped(), options).fingerprint != before);
}

TEST_CASE("Shards share the runs among them") {
  CHECK(batch::parse_shard("2/5") == batch::Shard{2, 5});
  CHECK(batch::parse_shard("1/1") == batch::Shard{});
  for (const char* wrong : {"", "2", "0/5", "6/5", "2/", "/5", "2/5x", "a/b", "-1/5", "1/0"}) {
    CAPTURE(wrong);
    CHECK_FALSE(batch::parse_shard(wrong));
  }
  const test::Folder folder;
  std::vector<int> count(7, 0);
  for (std::size_t index = 1; index <= 4; ++index) {
    const batch::Plan plan = test::small_plan(folder, {index, 4});
    CHECK(plan.all_runs == 6);
    for (const batch::PlannedRun& run : plan.runs) {
      CHECK((static_cast<std::size_t>(run.id) - 1) % 4 == index - 1);
      ++count[static_cast<std::size_t>(run.id)];
    }
  }
  CHECK(count == std::vector<int>{0, 1, 1, 1, 1, 1, 1});
}

TEST_CASE("A plan is not made of a world that is wrong") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.settings = {test::setting("robot[r9]/@max_speed", "1")};
  CHECK_THROWS_AS(test::plan_of(experiment), world::WorldError);
}

TEST_CASE("A world's own limit of time on the clock does not count") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.settings = {test::setting("limits/@wall_time", "0.001")};
  const auto plan = test::plan_of(experiment);
  CHECK(plan.cells[0].world_text.find("wall_time") == std::string::npos);
}

TEST_CASE("A file that changes during a batch is noticed") {
  const test::Folder folder;
  const auto options = test::with_models_in(folder);
  const auto plan = batch::make_plan(test::small_experiment(folder), test::shipped(), options);
  batch::FileCheck check(plan);
  CHECK_FALSE(check.changed(0));
  CHECK_FALSE(check.changed(0));
  const std::string name = "fuzzy_models/avoid_obstacle_left.fcl";
  const std::string content = folder.read(name);
  folder.write(name, content);  // written again with the same content
  CHECK_FALSE(check.changed(1));
  folder.write(name, content + "\n");
  CHECK(check.changed(1) == folder.file(name));
  folder.write(name, content);
  CHECK_FALSE(check.changed(1));
  std::filesystem::remove(folder.file(name));
  CHECK(check.changed(0) == folder.file(name));
}
