// Each experiment in wrong/ has one mistake; a text file of the same name has its message.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

std::string message_of(const std::string& file) {
  try {
    experiment::read_experiment(file, host(), options());
    return "accepted";
  } catch (const world::WorldError& error) {
    return without_folder(error.what());
  }
}

}  // namespace

TEST_CASE("Each wrong experiment gives its message") {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kFolder + "wrong")) {
    fs::path file = entry.path();
    if (file.extension() == ".xml") {
      ++count;
      CAPTURE(file.filename().string());
      const std::string message = message_of(file.string());
      CHECK(message + "\n" == text_of(file.replace_extension(".txt").string()));
      CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    }
  }
  CHECK(count >= 90);
}

TEST_CASE("All mistakes are reported at once, in the order of their lines") {
  CHECK(problems(
            "\n<worlds>\n<world file='data/arena.xml'/>\n<world file='nowhere.xml'/>\n</worlds>\n"
            "<set path='robot[r1]/@x'/>\n"
            "<vary path='robot[r1]/@y' from='2' to='1' step='0.1'/>\n"
            "<seeds list='1 1'/>\n"
            "<limits tyme='3'/>\n"
            "<measures><measure name='success'/><measure name='success'/></measures>") ==
        "experiment.xml:4: file=\"nowhere.xml\" of <world>: there is no such file; looked in the "
        "folder tests/experiment or in the data directory tests/world/data\n"
        "experiment.xml:6: <set> lacks what to set; expected value=\"...\", or an element in it\n"
        "experiment.xml:7: the range of the factor 'y': there is nothing from 2 to 1; give the "
        "smaller number first\n"
        "experiment.xml:8: the seed 1 is listed twice: the same seed gives the same run\n"
        "experiment.xml:9: <limits> has no attribute 'tyme'; did you mean 'time'?\n"
        "experiment.xml:10: the measure 'success' is named twice");
}

TEST_CASE("A mistake is not reported again as another one") {
  // What could not be read must not lead to further messages about levels, expectations or cells.
  CHECK(problems(kArena +
                 "<vary name='speed' path='robot[r1]/@max_speed' from='0.1' to='x' step='1'/>"
                 "<expectations><expect measure='success' at_least='1' where='speed=0.1'/>"
                 "</expectations>") == "experiment.xml:1: to=\"x\" of <vary>: expected a number");
  CHECK(problems(kArena + "<set path='robot[r7]/@x' value='1'/>"
                          "<vary path='robot[r1]/@max_speed' from='0.1' to='0.5' step='0.1'/>") ==
        "experiment.xml:1: there is no robot[r7]; there are: r1, r2");
}
