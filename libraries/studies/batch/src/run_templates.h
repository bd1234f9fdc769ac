// The templates of a batch; see run_template.h.
#pragma once

#include <cstddef>
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
  using Original = std::shared_ptr<RunTemplate>;
  template <class Key, class Make>
  static Original kept(std::map<Key, Original>& originals, const Key& key, const Make& make);
  void note_refusal(RunTemplate& original, const std::string& consequence, const std::string& what);

  const PoolOptions& options_;
  /// The key is what the runs of a template have in common. Their repetition is part of it: copies
  /// of one process have the same addresses and the same state of libraries after loading, which
  /// repetitions must not have in common.
  std::map<std::pair<std::vector<std::string>, int>, Original> by_libraries_;
  std::map<std::pair<std::size_t, int>, Original> by_cell_;
};

}  // namespace elsie::batch
