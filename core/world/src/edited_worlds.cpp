#include "elsie/world/edited_worlds.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/world/world_tree.h"

namespace elsie::world {

void visit_edited_worlds(const World& world, const plugin::Host& host, const ReadOptions& options,
                         const std::function<void(World)>& visit) {
  std::vector<TimedEdit> edits(world.edits.begin(), world.edits.end());
  std::stable_sort(edits.begin(), edits.end(),
                   [](const TimedEdit& a, const TimedEdit& b) { return a.time < b.time; });
  World was = world;
  Problems problems;
  ReadOptions reading = options;
  const auto refuse = [&](const TimedEdit& edit, const std::string& message, bool plugin_failed) {
    problems.add(edit.location,
                 "at " + base::number_text(edit.time) + " s, " + edit.text() + ": " + message,
                 plugin_failed);
  };
  for (auto first = edits.begin(), last = first; first != edits.end(); first = last) {
    last = std::find_if(first, edits.end(),
                        [&](const TimedEdit& edit) { return edit.time != first->time; });
    reading.edits_from = first->location.file;
    reading.edits.clear();
    for (const TimedEdit& edit : std::span(first, last)) {
      reading.edits.push_back(edit.text());
    }
    try {
      World next = edited(WorldTree(was), host, reading);
      if (next.physics.engine != was.physics.engine) {
        const auto culprit = std::find_if(
            first, last, [](const TimedEdit& edit) { return edit.path.starts_with("physics"); });
        refuse(culprit == last ? *first : *culprit, kEngineStays, false);
      }
      visit(next);
      was = std::move(next);
    } catch (const WorldError& error) {
      // Each problem gets the place of the edit that causes it, or of the first edit.
      for (const Problem& problem : error.problems()) {
        const auto own = std::find_if(first, last, [&](const TimedEdit& edit) {
          return problem.file == "--set " + edit.text();
        });
        refuse(own == last ? *first : *own, problem.message, problem.plugin_failed);
      }
    }
  }
  problems.raise<WorldError>(world.file);
}

}  // namespace elsie::world
