#include "ode_handles.h"

#include <new>
#include <stdexcept>

namespace elsie::physics {
namespace {

// The only way in which ODE tells that its solver gave up is a message. It comes in the thread that
// steps.
thread_local bool solver_gave_up = false;

void note_message(int, const char*, va_list) { solver_gave_up = true; }

bool start_ode() {
  if (!dInitODE2(0)) throw std::runtime_error("The physics library ODE could not be started.");
  dSetMessageHandler(note_message);
  return true;
}

}  // namespace

void prepare_ode() {
  // Once in a process, and never closed: engines may live to the very end of it.
  static const bool started = start_ode();
  static_cast<void>(started);
  thread_local const bool allocated = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!allocated) {
    throw std::runtime_error("The physics library ODE could not allocate memory for a thread.");
  }
}

bool step_ode(dWorldID world, double step) {
  solver_gave_up = false;
  if (!dWorldStep(world, step)) throw std::bad_alloc();
  return !solver_gave_up;
}

}  // namespace elsie::physics
