#include "elsie/files/emergency.h"

#include <array>
#include <atomic>

#include "elsie/base/thread_pool.h"

namespace elsie::files {
namespace {

// Signal handlers can only use globals.
std::array<std::atomic<EmergencyWriter*>, 512> writers;
std::atomic<bool> is_cleaning{false};

}  // namespace

EmergencyWriter::EmergencyWriter() : thread_(base::ThreadPool::worked_for()) {
  for (auto& slot : writers) {
    EmergencyWriter* none = nullptr;
    if (slot.compare_exchange_strong(none, this)) {
      return;
    }
  }
}

void EmergencyWriter::retire() noexcept {
  for (auto& slot : writers) {
    EmergencyWriter* self = this;
    slot.compare_exchange_strong(self, nullptr);
  }
}

bool write_in_emergency() noexcept {
  bool any = false;
  const int thread = base::ThreadPool::worked_for();
  for (const auto& slot : writers) {
    EmergencyWriter* const writer = slot.load();
    if (writer && writer->thread_ == thread) {
      any = writer->write_now() || any;
    }
  }
  return any;
}

void clean_up_in_emergency() noexcept {
  if (is_cleaning.exchange(true)) {
    return;
  }
  for (const auto& slot : writers) {
    if (EmergencyWriter* const writer = slot.load()) {
      writer->clean_up_now();
    }
  }
}

}  // namespace elsie::files
