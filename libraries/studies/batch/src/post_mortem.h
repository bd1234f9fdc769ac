// The record of a run whose worker ended without a result.
#pragma once

#include <optional>
#include <string>

#include "elsie/batch/job.h"

#include "last_words.h"

namespace elsie::batch {

/// The longest answer of a worker in bytes.
inline constexpr std::size_t kLongestAnswer = 256U << 20U;

struct WorkerEnd {
  int status = 0;                    // as from waitpid(2)
  std::optional<LastWords> words{};  // none if it could not report
  std::string problem{};             // the error in its answer, or empty
  bool said_nothing = true;
  bool said_too_much = false;  // its answer exceeded kLongestAnswer
  bool overdue = false;        // it was ended at its wall limit
  double wall_limit_s = 0.0;
};

/// The run's state, message, signal, plugin, robot and step.
RunRecord post_mortem(const WorkerEnd& end);

}  // namespace elsie::batch
