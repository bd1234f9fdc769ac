#include "elsie/plugin/call.h"

#include <time.h>

namespace elsie::plugin {
namespace {

std::int64_t now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

constinit thread_local Call* Call::innermost_ = nullptr;

void Call::stop_clock() noexcept {
  if (outer_) {
    outer_->inner_ns_ += now_ns() - start_ns_;
  }
}

void Call::start_clock() noexcept { start_ns_ = now_ns(); }

double Call::own_time_s() const noexcept {
  return start_ns_ == 0 ? 0.0 : 1e-9 * static_cast<double>(now_ns() - start_ns_ - inner_ns_);
}

}  // namespace elsie::plugin
