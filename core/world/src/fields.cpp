#include "elsie/world/fields.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"

#include "reading.h"

namespace elsie::world {
namespace {

std::size_t pieces(double whole, double largest) {
  constexpr double kRounding = 1e-9;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(whole / largest - kRounding)));
}

/// A short number that is enough as ScalarField::cell in this arena.
double large_cell(ScalarField field, const Arena& arena) {
  const double least = std::sqrt(arena.length * arena.width / static_cast<double>(kMostFieldCells));
  const double digit = std::pow(10.0, std::floor(std::log10(least)) - 1.0);
  field.cell = digit * std::ceil(least / digit);
  while (cells_of(field, arena).count() > kMostFieldCells) field.cell += digit;
  return field.cell;
}

void check_size(const ScalarField& field, const Arena& arena, Problems& problems) {
  const FieldCells cells = cells_of(field, arena);
  if (cells.count() <= kMostFieldCells) return;
  using base::number_text;
  problems.add(field.location,
               "the field '" + field.id + "' would have " + std::to_string(cells.columns) + " x " +
                   std::to_string(cells.rows) + " cells of " + number_text(field.cell) +
                   " m; expected at most " + std::to_string(kMostFieldCells) +
                   " cells, which cell=\"" + number_text(large_cell(field, arena), 6) +
                   "\" gives in this arena");
}

/// Checks the names of fields that a sensor or an actuator gives.
class NameCheck {
 public:
  NameCheck(const World& world, const plugin::Host& host, PluginKind kind, Problems& problems)
      : kind_(kind), problems_(problems) {
    for (const ScalarField& field : world.fields) ids_.push_back(field.id);
    for (const Declaration* declaration : host.all(kind)) {
      if (!declaration->field_parameters.empty()) named_by_.push_back(declaration);
    }
  }

  void check(const MountedUse& use) const {
    const auto found =
        std::find_if(named_by_.begin(), named_by_.end(),
                     [&](const Declaration* each) { return each->name == use.plugin; });
    if (found == named_by_.end()) return;
    for (const ParameterDeclaration& parameter : (*found)->parameters) {
      const auto& names = (*found)->field_parameters;
      if (std::find(names.begin(), names.end(), parameter.name) == names.end()) continue;
      const auto given = use.parameters.find(parameter.name);
      const std::string id = std::get<std::string>(
          given == use.parameters.end() ? parameter.default_value : given->second);
      if (std::find(ids_.begin(), ids_.end(), id) != ids_.end()) continue;
      problems_.add(use.location,
                    "the " + std::string(plugin::kind_name(kind_)) + " '" + use.id +
                        "' is for the field '" + id + "', which the world does not have" +
                        (ids_.empty() ? "; add <fields> with a <field id=\"" + id + "\"/>"
                                      : base::near_or_all(id, ids_, "it has")));
    }
  }

 private:
  PluginKind kind_;
  Problems& problems_;
  std::vector<std::string> ids_;
  std::vector<const Declaration*> named_by_;
};

}  // namespace

FieldCells cells_of(const ScalarField& field, const Arena& arena) {
  FieldCells cells{pieces(arena.length, field.cell), pieces(arena.width, field.cell)};
  cells.length = arena.length / static_cast<double>(cells.columns);
  cells.width = arena.width / static_cast<double>(cells.rows);
  return cells;
}

void check_fields(const Reading& reading, const plugin::Host& host, bool all, Problems& problems) {
  const World& world = reading.world;
  for (const ScalarField& field : world.fields) {
    if (reading.sound(field.location)) check_size(field, world.arena, problems);
  }
  const NameCheck sensors(world, host, PluginKind::sensor, problems);
  const NameCheck actuators(world, host, PluginKind::actuator, problems);
  const auto check = [&](const Robot& robot) {
    for (const MountedUse& use : robot.sensors) {
      if (!reading.has_flaw(use.location)) sensors.check(use);
    }
    for (const MountedUse& use : robot.actuators) {
      if (!reading.has_flaw(use.location)) actuators.check(use);
    }
  };
  if (all) {
    std::for_each(world.robots.begin(), world.robots.end(), check);
  } else {
    for (const std::size_t robot : reading.read_robots) check(world.robots[robot]);
  }
}

}  // namespace elsie::world
