#include <catch2/catch.hpp>

#include "elsie/recording/formats.h"
#include "elsie/render/world_cameras.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

TEST_CASE("The suffix of a name selects the format") {
  REQUIRE(recording::format_of("a/run.csv"));
  CHECK(recording::format_of("a/run.csv")->suffix == ".csv");
  CHECK(recording::format_of("run.mcap")->suffix == ".mcap");
  CHECK(!recording::format_of("run.txt"));
  CHECK(!recording::format_of(".csv"));  // a hidden file without a suffix
  CHECK(!recording::format_of("/dev/stdout"));
  CHECK(recording::suffixes(" or ") == ".csv or .mcap");
  CHECK(recording::suffixes(" or ", true) == ".mcap");
}

TEST_CASE("Every format records a run, and its files begin with its mark") {
  for (const recording::Format& format : recording::formats()) {
    INFO(format.suffix);
    const Folder folder;
    const auto file = folder / ("run" + std::string(format.suffix));
    Simulation simulation(shipped_world("find_resource.xml", 1), shipped(),
                          {.cameras = render::world_cameras});
    const std::uint64_t alone = simulation.run().state_hash;
    simulation.reset();
    const auto recorder = format.recorder(file, {.images = format.images});
    simulation::Observer* const observers[] = {recorder.get()};
    CHECK(simulation.run(observers).state_hash == alone);
    const std::string start = folder.read(file.filename()).substr(0, 1024);
    CHECK(start.starts_with(format.mark));
    CHECK_THAT(start, Catch::Contains(std::string(format.maker)));
    CHECK(!format.description.empty());
  }
}
