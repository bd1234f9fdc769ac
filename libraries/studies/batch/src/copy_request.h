// What the pool asks of a process that is copied; see run_template.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <sys/types.h>

namespace elsie::batch {

struct CopyRequest {
  /// A copy to end, if it has not ended, and to wait for; 0: a copy is to be made.
  pid_t ended = 0;
  bool is_template = false;  // the copy is copied itself
  // For a run of the template's own job:
  std::int64_t run = 0;
  std::uint64_t seed = 0;
};

/// A request and its descriptors: the output, the answer, and the job, if it is another one.
struct ReceivedRequest {
  CopyRequest request;
  std::vector<int> descriptors;
};

/// Returns whether it was sent.
bool send_request(int to, const CopyRequest& request, const std::vector<int>& descriptors);

/// Waits for the next request; none: there will be none.
std::optional<ReceivedRequest> next_request(int from);

}  // namespace elsie::batch
