// Every shipped world has the same bits for every processor that the C library detects.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using elsie::test::build_path;
using elsie::test::Workplace;

namespace {

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> worlds;
  for (const auto& entry :
       std::filesystem::directory_iterator(elsie::test::source_path("worlds"))) {
    if (entry.path().extension() == ".xml") {
      worlds.push_back("worlds/" + entry.path().filename().string());
    }
  }
  return worlds;
}

/// The state hash of two simulated seconds. `tunables`: settings of the C library, as users may
/// have them.
std::string hash_of(const std::string& world, const std::string& tunables,
                    const std::string& program = "elsie") {
  const Workplace here;
  const auto run = here.sh("GLIBC_TUNABLES='" + tunables + "' " + program + " run " + world +
                           " --seed 3 --duration 2 --json || [ $? = 1 ]");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out).at("state_hash");
}

}  // namespace

TEST_CASE("The features of the processor make no difference to any shipped world") {
  // A processor without any features after the first x86-64.
  const std::string oldest =
      "glibc.cpu.hwcaps=-SSE3,-SSSE3,-SSE4_1,-SSE4_2,-AVX512F,-AVX512VL,-BMI1,-BMI2,-LZCNT,-POPCNT,"
      "-MOVBE,-ERMS";
  for (const std::string& world : shipped_worlds()) {
    CAPTURE(world);
    const std::string hash = hash_of(world, "");
    CHECK(hash_of(world, "glibc.cpu.hwcaps=-FMA,-AVX2:glibc.malloc.check=0") == hash);
    CHECK(hash_of(world, oldest) == hash);
  }
}

TEST_CASE("The program has the C library's functions for the first x86-64, and other settings") {
  const Workplace here;
  const auto run = here.sh(
      "export GLIBC_TUNABLES=glibc.malloc.check=0:glibc.cpu.hwcaps=-ERMS\n"
      "elsie run worlds/open_arena.xml --speed 1 --duration 100 --record run.csv & pid=$!\n"
      "until [ -e run.csv ]; do sleep 0.02; done\n"
      // Some versions of the C library put an end behind each setting.
      "tr '\\0' ':' < /proc/$pid/environ | grep -o 'GLIBC_TUNABLES=.*FMA4'; kill $pid");
  CHECK(run.out ==
        "GLIBC_TUNABLES=glibc.malloc.check=0:glibc.cpu.hwcaps=-ERMS,-AVX,-AVX2,-FMA,-FMA4\n");
}

TEST_CASE("Nor do they to a camera's pictures, and to what is found in them") {
  // Mesa and OpenCV also choose code by the processor; these are their own switches.
  const std::string world = "worlds/find_resource.xml";
  const std::string hash = hash_of(world, "");
  for (const std::string setting :
       {"GALLIUM_OVERRIDE_CPU_CAPS=sse2", "GALLIUM_OVERRIDE_CPU_CAPS=sse4.1",
        "LP_NATIVE_VECTOR_WIDTH=128", "LP_NATIVE_VECTOR_WIDTH=256",
        "OPENCV_CPU_DISABLE=AVX2,AVX,FP16,FMA3,AVX512_SKX"}) {
    CAPTURE(setting);
    CHECK(hash_of(world, "", "env " + setting + " elsie") == hash);
  }
}
