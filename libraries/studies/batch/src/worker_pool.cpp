#include "elsie/batch/worker_pool.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <poll.h>

#include "run_templates.h"
#include "worker_process.h"

namespace elsie::batch {

namespace {
constexpr auto kTick = std::chrono::seconds(1);
}  // namespace

WorkerPool::WorkerPool(PoolOptions options)
    : options_(std::move(options)), templates_(std::make_unique<RunTemplates>(options_)) {}

WorkerPool::~WorkerPool() = default;

bool WorkerPool::run(const Next& next, const Ended& ended, const Tick& tick) {
  bool more = true;
  std::vector<std::pair<std::int64_t, RunRecord>> results;
  const auto hand_over = [&] {
    for (auto& [number, record] : std::exchange(results, {})) {
      ended(number, std::move(record));
    }
  };
  try {
    for (;;) {
      while (more && workers_.size() < options_.workers) {
        if (std::optional<Job> job = next()) {
          workers_.emplace_back(options_, *std::move(job), *templates_);
        } else {
          more = false;
        }
      }
      hand_over();  // only now, so that the workers run meanwhile
      if (tick) {
        tick();
      }
      if (workers_.empty()) {
        return true;
      }
      if (!wait(results)) {
        workers_.clear();
        hand_over();
        return false;
      }
    }
  } catch (...) {
    try {
      hand_over();
    } catch (...) {
      // The results cannot be stored; the first error is reported.
    }
    throw;
  }
}

/// Waits for the next event. Returns false when the pool was stopped. Throws std::runtime_error.
bool WorkerPool::wait(std::vector<std::pair<std::int64_t, RunRecord>>& results) {
  using Clock = std::chrono::steady_clock;
  std::vector<pollfd> polled{{options_.stop_descriptor, POLLIN, 0}};
  auto until = Clock::now() + kTick;
  for (const Worker& worker : workers_) {
    worker.list(polled);
    until = std::min(until, worker.due());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  if (poll(polled.data(), polled.size(), static_cast<int>(std::max<std::int64_t>(left, 0))) < 0 &&
      errno != EINTR) {
    throw std::runtime_error("the workers cannot be waited for: " +
                             std::generic_category().message(errno));
  }
  const auto now = Clock::now();
  const pollfd* of_worker = polled.data() + 1;
  for (auto worker = workers_.begin(); worker != workers_.end(); of_worker += Worker::kPolled) {
    worker->read(of_worker);
    if (worker->has_ended()) {
      results.emplace_back(worker->run(), worker->record());
      worker = workers_.erase(worker);
      continue;
    }
    if (now >= worker->due()) {
      worker->overdue(now);
    }
    ++worker;
  }
  return polled.front().revents == 0;
}

}  // namespace elsie::batch
