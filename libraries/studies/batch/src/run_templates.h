// The templates of a batch; see run_template.h.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "elsie/batch/worker_pool.h"

#include "run_template.h"

namespace elsie::batch {

class RunTemplates {
 public:
  /// The options must outlive this object.
  explicit RunTemplates(const PoolOptions& options) : options_(options) {}

  /// The process to copy for this job: it is ready, or must be waited for. Null: there is none, and
  /// the run needs a program of its own. Throws std::runtime_error if none can be started.
  std::shared_ptr<RunTemplate> original_for(const Job& job);

 private:
  const PoolOptions& options_;
  /// By what the runs of a template have in common. Their repetition is part of it: copies of one
  /// process have the same addresses and the same state of libraries after loading, which
  /// repetitions must not have in common.
  std::map<std::pair<std::vector<std::string>, int>, std::shared_ptr<RunTemplate>> originals_;
};

}  // namespace elsie::batch
