#include "ode_handles.h"

#include <array>
#include <cstdio>
#include <new>

namespace elsie::physics {
namespace {

// ODE reports only by a message that its solver gave up. The message comes in the thread that
// solves.
void note_message(int, const char*, va_list) { OdeThreading::note_give_up(); }

[[noreturn]] void fail(int, const char* format, va_list arguments) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw OdeFailure(text.data());
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

OdeWorld::OdeWorld(base::ThreadPool& pool) : threading_(pool) {
  prepare_ode();
  world_ = dWorldCreate();
  threading_.serve(world_);
}

OdeWorld::~OdeWorld() { dWorldDestroy(world_); }

bool OdeWorld::step(double step, std::size_t islands) {
  threading_.expect(islands);
  if (!dWorldStep(world_, step)) throw std::bad_alloc();
  return !threading_.gave_up();
}

}  // namespace elsie::physics
