#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/near_name.h"

using elsie::base::did_you_mean;
using elsie::base::nearest_name;

namespace {
const std::vector<std::string_view> kNames{"speed", "speed_limit", "wander", "avoid_obstacle",
                                           "x",     "y",           "yaw"};
}

TEST_CASE("A slip of one letter finds the right name") {
  for (const char* const slip : {"spee", "sspeed", "spped", "spede", "Speed", "SPEED"}) {
    INFO(slip);
    CHECK(nearest_name(slip, kNames) == std::string_view("speed"));
  }
  CHECK(nearest_name("avoid-obstacles", kNames) == std::string_view("avoid_obstacle"));
}

TEST_CASE("The nearest of several names wins, and the first of equally near ones") {
  CHECK(nearest_name("speed_limi", kNames) == std::string_view("speed_limit"));
  const std::vector<std::string_view> candidates{"bat", "cat"};
  CHECK(nearest_name("rat", candidates) == std::string_view("bat"));
}

TEST_CASE("The beginning of a name is enough") {
  CHECK(nearest_name("avoid", kNames) == std::string_view("avoid_obstacle"));
  CHECK_FALSE(nearest_name("av", kNames));
}

TEST_CASE("A name that is like none has no nearest name") {
  CHECK_FALSE(nearest_name("temperature", kNames));
  CHECK_FALSE(nearest_name("z", kNames));
  CHECK_FALSE(nearest_name("", kNames));
  CHECK_FALSE(nearest_name("speed", {}));
  CHECK_FALSE(nearest_name(std::string(100'000, 's'), kNames));
}

TEST_CASE("The hint is the end of a sentence, or nothing") {
  CHECK(did_you_mean("spede", kNames) == "; did you mean 'speed'?");
  CHECK(did_you_mean("temperature", std::vector<std::string>{"speed"}).empty());
}
