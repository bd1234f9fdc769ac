#include "goals.h"

#include <map>
#include <string_view>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::report {

namespace {

bool has_goals(const CellInfo& cell) {
  try {
    // Reads only the markup: reading the world would require the plugins, or ignore goals about
    // time.
    const world::Element root = world::parse_markup(cell.world_text, cell.world_file);
    const world::Element* const goals = root.child("goals");
    return goals && !goals->children.empty();
  } catch (const world::WorldError&) {
    return true;
  }
}

}  // namespace

std::vector<bool> cells_with_goals(const Results& results) {
  std::map<std::string_view, bool> known;  // by the text of the world, which many cells may have
  std::vector<bool> all;
  for (const CellInfo& cell : results.cells) {
    const auto [found, is_new] = known.try_emplace(cell.world_text);
    if (is_new) {
      found->second = has_goals(cell);
    }
    all.push_back(found->second);
  }
  return all;
}

bool never_arrived(const Run& run, bool goals) {
  return goals && run.state == RunState::done &&
         (run.outcome == Outcome::time_limit || run.outcome == Outcome::failure);
}

}  // namespace elsie::report
