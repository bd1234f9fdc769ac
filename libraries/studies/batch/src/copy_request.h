// What the pool asks of a process that is copied; see run_template.h.
#pragma once

#include <optional>
#include <vector>

#include <sys/types.h>

namespace elsie::batch {

struct CopyRequest {
  /// A copy to end, if it has not ended, and to wait for; 0: a copy is to be made.
  pid_t ended = 0;
  /// Of a copy that is to be made: its job, its output, and its answer.
  std::vector<int> descriptors{};
};

/// Returns whether it was sent.
bool send_request(int to, const CopyRequest& request);

/// Waits for the next request; none: there will be none.
std::optional<CopyRequest> next_request(int from);

}  // namespace elsie::batch
