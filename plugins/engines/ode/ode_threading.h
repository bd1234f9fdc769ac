// ODE's steps with several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <vector>

#include <ode/ode.h>
#include <ode/threading.h>

#include "elsie/base/thread_pool.h"

namespace elsie::physics {

/// An implementation of ODE's threading interface (ode/threading.h). One thread makes all calls for
/// an island, always in the same order, so that the state after a step does not depend on the
/// number of threads. Unlike ODE's own implementations it passes exceptions on: dWorldStep() throws
/// what a call threw.
class OdeThreading {
 public:
  /// The pool must outlive the steps.
  explicit OdeThreading(base::ThreadPool& pool);
  ~OdeThreading();
  OdeThreading(const OdeThreading&) = delete;
  OdeThreading& operator=(const OdeThreading&) = delete;

  /// Takes another pool.
  void work_with(base::ThreadPool& pool);
  /// Schedules the steps of this world, which must be destroyed first, and keeps their memory.
  void serve(dWorldID world);
  /// Before a step of a world with so many islands, roughly. Few islands get few threads.
  void expect(std::size_t islands);

  /// Notes that ODE's solver gave up, in the thread in which it did.
  static void note_give_up();
  /// Whether the solver has given up since the last call.
  bool gave_up() { return gave_up_.exchange(false); }

 private:
  struct Call;
  struct Chain;
  struct Locks;
  struct Blocks;

  static OdeThreading& of(dThreadingImplementationID id) {
    return *reinterpret_cast<OdeThreading*>(id);
  }
  static const dThreadingFunctionsInfo& functions();
  static void* allocate(std::size_t size);
  static void release(void* block);
  void post(int* fault, dCallReleaseeID* posted, std::size_t waits_for, Call* dependent,
            dThreadedCallFunction* function, void* context, std::size_t index);
  void change_waiting(Call& call, std::ptrdiff_t by);
  void make_all();
  void make(Call& first, std::size_t thread);
  void finish(Call& call);

  // Of this thread, while it makes calls.
  static constinit thread_local Chain* present_;

  base::ThreadPool* pool_;
  std::size_t threads_ = 1;
  std::deque<Call> outer_;     // posted by the thread that steps the world
  std::vector<Call*> ready_;   // of these, the calls that wait for no others
  std::vector<Chain> chains_;  // of each thread
  std::atomic<bool> gave_up_{false};
};

}  // namespace elsie::physics
