#include <algorithm>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Two robots with three cameras, one of them with noise.
constexpr const char* kWorld = R"(<world format="1">
  <physics control_steps="2"/>
  <resources><resource team="red" x="1"/></resources>
  <robots>
    <robot id="r1" team="red"><sensors><vision id="left" y="0.02"/><vision id="right"/></sensors></robot>
    <robot id="r2" team="red" x="-1"><sensors>
      <vision error="0.05"/>
    </sensors></robot>
  </robots>
  <limits time="1"/>
</world>
)";

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

}  // namespace

TEST_CASE("--save-images writes raw and processed pictures, named after step, robot and sensor") {
  Workplace here;
  here.write("world.xml", kWorld);
  const auto run = here.elsie("run world.xml --duration 0.06 --save-images images --quiet");
  CHECK(run.exit_code == 1);
  CHECK(run.err.empty());
  std::set<std::string> expected;
  for (const char* step : {"0000000", "0000002", "0000004"}) {
    for (const char* sensor : {"r1+left", "r1+right", "r2+vision"}) {
      for (const char* kind : {"raw", "processed"}) {
        expected.insert(std::string(step) + "_" + sensor + "_" + kind + ".png");
      }
    }
  }
  CHECK(files_in(here.file("images")) == expected);
  CHECK_THAT(here.read("images/0000000_r1+left_raw.png"), Catch::StartsWith("\x89PNG"));
  CHECK(here.read("images/0000000_r1+left_raw.png") !=
        here.read("images/0000000_r1+right_raw.png"));
  CHECK(here.read("images/0000000_r1+left_raw.png") !=
        here.read("images/0000000_r1+left_processed.png"));
  // The pictures include noise: no two are equal.
  CHECK(here.read("images/0000000_r2+vision_raw.png") !=
        here.read("images/0000002_r2+vision_raw.png"));
}

TEST_CASE("--save-images-every takes one picture per period, and none of it changes the run") {
  Workplace here;
  here.write("world.xml", kWorld);
  const auto hash = [&](const std::string& options) {
    const auto run = here.elsie("run world.xml --json " + options);
    return json::parse(run.out).at("state_hash").get<std::string>();
  };
  const std::string without = hash("");
  CHECK(hash("--save-images a --save-images-every 0.3") == without);
  std::set<std::string> steps;
  for (const std::string& name : files_in(here.file("a"))) {
    steps.insert(name.substr(0, 7));
  }
  CHECK(steps == std::set<std::string>{"0000000", "0000030", "0000060", "0000090"});
  CHECK(hash("--save-images b --save-images-every 0.3") == without);
  for (const std::string& name : files_in(here.file("a"))) {
    CHECK(here.read("a/" + name) == here.read("b/" + name));
  }
  fs::create_directory(here.file("empty"));
  CHECK(hash("--save-images empty --save-images-every 10") == without);
  CHECK(files_in(here.file("empty")).size() == 6);
}

TEST_CASE("If images cannot be saved, a sentence says why, before the run") {
  Workplace here;
  here.write("world.xml", kWorld);
  here.write("file", "");
  fs::create_directory(here.file("full"));
  here.write("full/something", "");
  const auto refuse = [&](const std::string& options, const std::string& sentence) {
    CAPTURE(options);
    const auto run = here.elsie("run " + options);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  refuse("world.xml --save-images full", "'full': it is not empty, and pictures of two runs would");
  refuse("world.xml --save-images file", "'file': it is a file, not a folder");
  refuse("world.xml --save-images nowhere/images", "nowhere' to make it in");
  refuse("world.xml --save-images ''", "the name of a folder is missing");
  refuse("world.xml --save-images images --save-images-every 0", "--save-images-every");
  refuse("world.xml --save-images-every 1", "--save-images");
  refuse("worlds/open_arena.xml --save-images images",
         "no robot of this world has a sensor with a camera");
  CHECK_FALSE(fs::exists(here.file("images")));
}

TEST_CASE("When the disk is full the run ends and says which picture could not be written") {
  Workplace here;
  here.write("world.xml", kWorld);
  // Files of at most 512 bytes: the noisy picture does not fit.
  const auto run =
      here.sh("trap '' XFSZ; ulimit -f 1; elsie run world.xml --save-images images --quiet");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Catch::Contains("Cannot write the picture 'images/0000000_"));
  CHECK_FALSE(files_in(here.file("images")).contains("0000000_r2+vision_raw.png"));
}

TEST_CASE("Without EGL a world with cameras is refused at the sensor; others run") {
  Workplace here;
  here.write("world.xml", kWorld);
  here.write("libEGL.so.1", "this is no library");
  for (const std::string environment :
       {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json", "LD_LIBRARY_PATH=."}) {
    CAPTURE(environment);
    const auto refused = here.sh(environment + " elsie run world.xml");
    CHECK(refused.exit_code == 2);
    CHECK(refused.out.empty());
    CHECK_THAT(refused.err, Catch::Contains("world.xml:5: plugin 'vision': cameras take their") &&
                                Catch::Contains("libegl-mesa0"));
    // Once, not for every camera.
    CHECK(refused.err.find("libegl-mesa0") == refused.err.rfind("libegl-mesa0"));
    const auto run = here.sh(environment + " elsie run worlds/open_arena.xml --duration 1 --quiet");
    CHECK(run.exit_code == 1);
    CHECK(run.err.empty());
  }
}

TEST_CASE("A team without a colour also finds its resources") {
  Workplace here;
  here.write("world.xml", R"(<world format="1"><teams><team id="crew"/></teams>
<resources><resource team="crew" x="1"/></resources>
<robots>
  <robot id="r1" team="crew"><sensors>
    <vision/></sensors>
    <behaviors><find_resource/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
</robots>
<goals><collect/></goals>
<limits time="20"/>
</world>
)");
  CHECK(here.elsie("check world.xml").exit_code == 0);
  const auto run = here.elsie("run world.xml --quiet");
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
}
