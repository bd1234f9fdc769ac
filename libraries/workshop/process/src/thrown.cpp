#include "thrown.h"

#include <cstring>
#include <exception>

#include <execinfo.h>

#include "elsie/plugin/call.h"
#include "elsie/process/crash_report.h"

#include "stack_trace.h"

namespace elsie::process {
namespace {

/// The last exception that was thrown in this thread while a plugin was at work.
struct Thrown {
  static constexpr int kMostFrames = 32;

  const void* exception = nullptr;
  void* frames[kMostFrames];
  int count = 0;
};
thread_local Thrown last;

}  // namespace

void note_throw(const void* exception) noexcept {
  if (plugin::Call::innermost()) {
    last.exception = exception;
    last.count = backtrace(last.frames, Thrown::kMostFrames);
  }
}

std::string place_of_throw() {
  const std::exception_ptr handled = std::current_exception();
  const void* exception = nullptr;
  static_assert(sizeof handled == sizeof exception);
  std::memcpy(&exception, static_cast<const void*>(&handled), sizeof exception);
  return exception && exception == last.exception
             ? own_line(std::span(last.frames).first(static_cast<std::size_t>(last.count)))
             : "";
}

}  // namespace elsie::process
