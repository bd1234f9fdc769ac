#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>

#include "elsie/api/drive.h"
#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/parts.h"

#include "reading.h"

namespace elsie::world {
namespace {

void build(Robot& robot, const plugin::Host& host, Problems& problems) {
  const PluginUse& use = *robot.drive;
  const Declaration* const declaration = host.find(PluginKind::drive, use.plugin);
  if (!declaration) return;  // reported already
  plugin::Call call({.plugin = &use.plugin,
                     .id = &use.id,
                     .file = use.location.file.text().c_str(),
                     .line = use.location.line,
                     .doing = "while it was asked for the parts of a body"});
  const auto refuse = [&](const std::string& what, bool is_fault_of_plugin) {
    problems.add(use.location,
                 "the drive '" + use.plugin + "' of the robot '" + robot.id + "': " + what,
                 is_fault_of_plugin);
  };
  try {
    const auto drive = host.create<Drive>(PluginKind::drive, use.plugin);
    plugin::apply_parameters(*declaration, *drive, use.parameters, values_of(use.elements));
    robot.driven = plan_of(chassis_of(robot.body), *drive);
    if (const char* const changed = call.restore_arithmetic()) {
      refuse(std::string("it changed ") + changed + " for the whole program", true);
    }
  } catch (const plugin::PluginError& error) {
    refuse(error.what(), true);
  } catch (...) {
    refuse(base::what_was_thrown(), false);
  }
}

void check_default(const Robot& robot, Problems& problems) {
  try {
    check(plan_of(robot.body, {}));
  } catch (const std::invalid_argument& error) {
    problems.add(robot.location, "the robot '" + robot.id + "': " + error.what());
  }
}

}  // namespace

void build_bodies(Reading& reading, const plugin::Host& host, Problems& problems) {
  for (const std::size_t index : reading.read_robots) {
    Robot& robot = reading.world.robots[index];
    if (reading.has_flaw(robot.location) ||
        (robot.drive && reading.has_flaw(robot.drive->location))) {
      continue;
    }
    if (robot.drive) {
      build(robot, host, problems);
    } else {
      check_default(robot, problems);
    }
  }
}

}  // namespace elsie::world
