#include "exclusions.h"

#include <stdexcept>
#include <string>

#include "elsie/experiment/grid.h"
#include "elsie/experiment/where.h"

namespace elsie::experiment {

std::vector<Exclusion> exclusions_from(const std::vector<ExclusionDraft>& drafts,
                                       const Experiment& experiment, base::Problems& problems) {
  std::vector<Exclusion> exclusions;
  if (drafts.empty()) {
    return exclusions;
  }
  const std::vector<Cell> all = cells(experiment);
  const Grid grid(experiment, all);
  std::vector<bool> left(all.size(), true);
  std::size_t count = all.size();
  for (const ExclusionDraft& draft : drafts) {
    const std::string what = "where=\"" + draft.where + "\" of <exclude>";
    try {
      Exclusion exclusion{parse_where(draft.where, labels_of(experiment)), draft.location};
      const std::vector<std::size_t> found = grid.cells_of(exclusion.where);
      const std::size_t before = count;
      for (const std::size_t cell : found) {
        count -= left[cell] ? 1 : 0;
        left[cell] = false;
      }
      if (count == before) {
        problems.add(draft.location,
                     what + " matches no cell that is left; expected one that others keep");
        continue;
      }
      if (count == 0) {
        problems.add(draft.location,
                     what +
                         (found.size() == all.size() ? " matches every cell"
                                                     : " matches every cell that is left") +
                         ", and nothing would be run; expected one that leaves some");
        return exclusions;
      }
      exclusions.push_back(std::move(exclusion));
    } catch (const std::invalid_argument& error) {
      problems.add(draft.location, what + ": " + error.what());
    }
  }
  return exclusions;
}

}  // namespace elsie::experiment
