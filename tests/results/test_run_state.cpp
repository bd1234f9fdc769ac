#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/results/run_state.h"

using elsie::results::run_state;
using elsie::results::RunState;

TEST_CASE("Each state of a run has its word") {
  for (const auto state : {RunState::pending, RunState::done, RunState::fault, RunState::crash,
                           RunState::hang, RunState::error}) {
    CHECK(run_state(to_string(state)) == state);
  }
  CHECK(run_state("hang") == RunState::hang);
  CHECK_THROWS_AS(run_state("asleep"), std::invalid_argument);
}
