// The last work of a process that crashes or is stopped: completing files, removing folders.
#pragma once

namespace elsie::files {

/// Completes or removes something when the process crashes or is stopped.
class EmergencyWriter {
 public:
  virtual ~EmergencyWriter() = default;
  // Signal handlers call both functions, so they may only use calls like write(2) and unlink(2).

  /// Called before the stack trace, only on the thread that made this object or on one that works
  /// for it: another may be in the middle of a change. Returns whether there was a file to write.
  virtual bool write_now() noexcept { return false; }
  /// Called after the stack trace.
  virtual void clean_up_now() noexcept {}

 protected:
  EmergencyWriter();
  EmergencyWriter(const EmergencyWriter&) = delete;
  EmergencyWriter& operator=(const EmergencyWriter&) = delete;
  /// Destructors of derived classes call this first.
  void retire() noexcept;

 private:
  friend bool write_in_emergency() noexcept;
  const int thread_;
};

/// Calls write_now() of every writer of this thread. Returns whether one of them had a file.
bool write_in_emergency() noexcept;
/// Calls clean_up_now() of every writer; a second call does nothing.
void clean_up_in_emergency() noexcept;

}  // namespace elsie::files
