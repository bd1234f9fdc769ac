// What is to be said of a worker that ended without a result.
#pragma once

#include <optional>
#include <string>

#include "elsie/batch/job.h"

#include "last_words.h"

namespace elsie::batch {

/// At most so much does a worker answer, bytes.
inline constexpr std::size_t kLongestAnswer = 256U << 20U;

struct WorkerEnd {
  int status = 0;                    // as of waitpid(2)
  std::optional<LastWords> words{};  // none: it had no time for any
  std::string problem{};             // what is wrong with its answer; empty: there is none
  bool said_nothing = true;
  bool said_too_much = false;  // more than kLongestAnswer
  bool overdue = false;        // it met the limit, and was ended
  double wall_limit_s = 0.0;
};

/// State, message, signal, plugin, robot and step of its run.
RunRecord post_mortem(const WorkerEnd& end);

}  // namespace elsie::batch
