// All headers for testing plugins without a test framework; see docs/testing-a-plugin.md. For
// Catch2: catch.h.
#pragma once

#include "elsie/testing/actuator.h"
#include "elsie/testing/behavior.h"
#include "elsie/testing/checker.h"
#include "elsie/testing/coordinator.h"
#include "elsie/testing/expectation.h"
#include "elsie/testing/golden.h"
#include "elsie/testing/measure.h"
#include "elsie/testing/picture.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/rule.h"
#include "elsie/testing/scene.h"
#include "elsie/testing/sensor.h"
#include "elsie/testing/sequence.h"
#include "elsie/testing/situation.h"
#include "elsie/testing/surroundings.h"
#include "elsie/testing/team.h"
#include "elsie/testing/verdict.h"
#include "elsie/testing/world.h"
