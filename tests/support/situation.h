// Situations and teams for the tests of the shipped plugins: the test library's own.
#pragma once

#include "elsie/testing/situation.h"
#include "elsie/testing/team.h"

namespace elsie::test {

using testing::active;
using testing::Situation;
using testing::Team;

}  // namespace elsie::test
