#include "ode_handles.h"

#include <array>
#include <cstdio>
#include <mutex>
#include <new>
#include <vector>

namespace elsie::physics {
namespace {

// ODE reports only by a message that its solver gave up. The message comes in the thread that
// steps.
thread_local bool solver_gave_up = false;

void note_message(int, const char*, va_list) { solver_gave_up = true; }

[[noreturn]] void fail(int, const char* format, va_list arguments) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw OdeFailure(text.data());
}

/// A scheduler with a job left in it cannot be freed, because ODE would end the process. It is
/// kept.
void abandon(dThreadingImplementationID scheduler) {
  static std::mutex guard;
  static auto* const abandoned = new std::vector<dThreadingImplementationID>;
  const std::lock_guard lock(guard);
  abandoned->push_back(scheduler);
}

bool start_ode() {
  if (!dInitODE2(0)) throw std::runtime_error("The physics library ODE could not be started.");
  dSetMessageHandler(note_message);
  // ODE reports failed assertions through one handler, other errors through the other.
  dSetDebugHandler(fail);
  dSetErrorHandler(fail);
  return true;
}

}  // namespace

void prepare_ode() {
  // Once in a process, and never closed: engines may live until its very end.
  static const bool started = start_ode();
  static_cast<void>(started);
  thread_local const bool allocated = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!allocated) {
    throw std::runtime_error("The physics library ODE could not allocate memory for a thread.");
  }
}

OdeWorld::OdeWorld() {
  prepare_ode();
  // ODE's default is one scheduler for all worlds of the process, which fails when two worlds are
  // stepped in two threads.
  threading_ = dThreadingAllocateSelfThreadedImplementation();
  if (!threading_) throw std::bad_alloc();
  world_ = dWorldCreate();
  dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_),
                                       threading_);
}

OdeWorld::~OdeWorld() {
  dWorldDestroy(world_);
  if (stopped_) {
    abandon(threading_);
  } else {
    dThreadingFreeImplementation(threading_);
  }
}

bool OdeWorld::step(double step) {
  solver_gave_up = false;
  try {
    if (!dWorldStep(world_, step)) throw std::bad_alloc();
  } catch (const OdeFailure&) {
    stopped_ = true;
    throw;
  }
  return !solver_gave_up;
}

}  // namespace elsie::physics
