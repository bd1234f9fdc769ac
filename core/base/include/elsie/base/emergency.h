// What is left to do when the process is brought down: files to be written to their end, folders to
// be removed.
#pragma once

#include <sys/types.h>

namespace elsie::base {

/// Something that is written, or removed, when the process is brought down.
class EmergencyWriter {
 public:
  virtual ~EmergencyWriter() = default;
  // Both are called within handlers of signals: they may use write(2), unlink(2) and the like,
  // nothing else.

  /// Called before the stack trace is written, and only in the thread that made this object: what
  /// another thread is in the middle of is left alone. Returns whether there was a file to write.
  virtual bool write_now() noexcept { return false; }
  /// Called after the stack trace.
  virtual void clean_up_now() noexcept {}

 protected:
  EmergencyWriter();
  EmergencyWriter(const EmergencyWriter&) = delete;
  EmergencyWriter& operator=(const EmergencyWriter&) = delete;
  /// For the destructors of derived classes, which call it first.
  void retire() noexcept;

 private:
  friend bool write_in_emergency() noexcept;
  const pid_t thread_;
};

/// Calls write_now() of every writer of this thread; returns whether one of them had a file to
/// write.
bool write_in_emergency() noexcept;
/// Calls clean_up_now() of every writer; a second call does nothing.
void clean_up_in_emergency() noexcept;

}  // namespace elsie::base
