#include "ode_threading.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "ode_handles.h"

namespace elsie::physics {
namespace {

// Islands for each thread; fewer are not worth waking a thread.
constexpr std::size_t kLeast = 8;

}  // namespace

struct OdeThreading::Call {
  dThreadedCallFunction* function = nullptr;
  void* context = nullptr;
  std::size_t index = 0;
  Call* dependent = nullptr;  // waits for this call, among others
  int* fault = nullptr;       // set to 1 if this call, or one that it waited for, failed
  std::atomic<std::ptrdiff_t> waits_for{0};  // calls that precede it; while it is made, itself
                                             // and calls that it adds: its end waits for them
  bool is_begun = false;
  std::atomic<bool> failed{false};
  bool is_outer = false;
};

/// The calls that follow from one call of ODE, in the thread that made this one.
struct OdeThreading::Chain {
  OdeThreading* threading = nullptr;
  std::vector<Call*> ready;
  std::deque<Call> calls;
  std::vector<Call*> unused;
};

/// Only memory is shared between islands. What is locked for the bodies of an island is used by one
/// thread, and no geometry is in a space.
struct OdeThreading::Locks {
  std::mutex memory;
  std::vector<bool> are_needed;
};

/// The blocks of memory that ODE works with in steps. It loses those of an island whose step ends
/// with an exception.
struct OdeThreading::Blocks {
  std::mutex guard;
  std::unordered_map<void*, const OdeThreading*> owners;

  static Blocks& all() {
    static auto* const blocks = new Blocks;  // worlds may live until the very end of the process
    return *blocks;
  }
};

constinit thread_local OdeThreading::Chain* OdeThreading::present_ = nullptr;

OdeThreading::OdeThreading(base::ThreadPool& pool) : pool_(&pool), chains_(pool.threads()) {}

OdeThreading::~OdeThreading() {
  Blocks& blocks = Blocks::all();
  const std::lock_guard lock(blocks.guard);
  std::erase_if(blocks.owners, [this](const auto& block) {
    if (block.second != this) return false;
    std::free(block.first);
    return true;
  });
}

void OdeThreading::work_with(base::ThreadPool& pool) {
  pool_ = &pool;
  chains_ = std::vector<Chain>(pool.threads());
}

void OdeThreading::serve(dWorldID world) {
  dWorldSetStepThreadingImplementation(world, &functions(),
                                       reinterpret_cast<dThreadingImplementationID>(this));
  dWorldStepMemoryFunctionsInfo memory{};
  memory.struct_size = sizeof(memory);
  memory.alloc_block = allocate;
  memory.shrink_block = [](void* block, dsizeint, dsizeint) { return block; };
  memory.free_block = [](void* block, dsizeint) { release(block); };
  if (!dWorldSetStepMemoryManager(world, &memory)) throw std::bad_alloc();
}

void* OdeThreading::allocate(std::size_t size) {
  void* const block = std::malloc(size);
  if (!block) return nullptr;
  Blocks& blocks = Blocks::all();
  const std::lock_guard lock(blocks.guard);
  blocks.owners.emplace(block, present_ ? present_->threading : nullptr);
  return block;
}

void OdeThreading::release(void* block) {
  Blocks& blocks = Blocks::all();
  const std::lock_guard lock(blocks.guard);
  blocks.owners.erase(block);
  std::free(block);
}

void OdeThreading::expect(std::size_t islands) {
  threads_ = std::clamp<std::size_t>(islands / kLeast, 1, pool_->threads());
}

void OdeThreading::note_give_up() {
  if (present_) present_->threading->gave_up_ = true;
}

void OdeThreading::post(int* fault, dCallReleaseeID* posted, std::size_t waits_for, Call* dependent,
                        dThreadedCallFunction* function, void* context, std::size_t index) {
  Chain* const chain = present_;
  Call* call = nullptr;
  if (!chain) {
    call = &outer_.emplace_back();
  } else if (chain->unused.empty()) {
    call = &chain->calls.emplace_back();
  } else {
    call = chain->unused.back();
    chain->unused.pop_back();
  }
  call->function = function;
  call->context = context;
  call->index = index;
  call->dependent = dependent;
  call->fault = fault;
  call->waits_for.store(static_cast<std::ptrdiff_t>(waits_for), std::memory_order_relaxed);
  call->failed.store(false, std::memory_order_relaxed);
  call->is_begun = false;
  call->is_outer = !chain;
  if (posted) *posted = reinterpret_cast<dCallReleaseeID>(call);
  if (waits_for == 0) (chain ? chain->ready : ready_).push_back(call);
}

void OdeThreading::change_waiting(Call& call, std::ptrdiff_t by) {
  if (call.waits_for.fetch_add(by, std::memory_order_acq_rel) + by != 0) return;
  if (call.is_begun) {
    finish(call);
  } else {
    (present_ ? present_->ready : ready_).push_back(&call);
  }
}

void OdeThreading::make_all() {
  const std::vector<Call*> first = std::exchange(ready_, {});
  pool_->divide(first.size(), 1, [&](const base::ThreadPool::Share& share) {
    for (std::size_t i = share.first; i < share.end; ++i) make(*first[i], share.thread);
  });
  outer_.clear();
}

/// Makes a call, and all that follow from it.
void OdeThreading::make(Call& first, std::size_t thread) {
  prepare_ode();
  Chain& chain = chains_[thread];
  chain.threading = this;
  chain.ready.assign(1, &first);
  struct Presence {
    explicit Presence(Chain& chain) { present_ = &chain; }
    ~Presence() { present_ = nullptr; }
  } const presence(chain);
  while (!chain.ready.empty()) {
    Call& call = *chain.ready.back();
    chain.ready.pop_back();
    const auto id = reinterpret_cast<dCallReleaseeID>(&call);
    call.is_begun = true;
    call.waits_for.store(1, std::memory_order_relaxed);
    if (call.function(call.context, call.index, id) == 0) call.failed = true;
    change_waiting(call, -1);
  }
}

void OdeThreading::finish(Call& call) {
  const bool failed = call.failed.load(std::memory_order_relaxed);
  if (failed && call.fault) *call.fault = 1;
  Call* const dependent = call.dependent;
  if (!call.is_outer) present_->unused.push_back(&call);
  if (!dependent) return;
  if (failed) dependent->failed = true;
  change_waiting(*dependent, -1);
}

const dThreadingFunctionsInfo& OdeThreading::functions() {
  static const dThreadingFunctionsInfo all = [] {
    dThreadingFunctionsInfo info{};
    info.struct_size = sizeof(info);
    info.alloc_mutex_group = [](dThreadingImplementationID, dmutexindex_t count,
                                const char* const* names) {
      auto* const locks = new Locks;
      for (dmutexindex_t i = 0; i < count; ++i) {
        const std::string_view name = names && names[i] ? names[i] : "";
        const bool of_island =
            name.find("StepBody") != name.npos || name.find("addLimot") != name.npos;
        locks->are_needed.push_back(!of_island);
      }
      return reinterpret_cast<dMutexGroupID>(locks);
    };
    info.free_mutex_group = [](dThreadingImplementationID, dMutexGroupID group) {
      delete reinterpret_cast<Locks*>(group);
    };
    info.lock_group_mutex = [](dThreadingImplementationID, dMutexGroupID group,
                               dmutexindex_t index) {
      auto& locks = *reinterpret_cast<Locks*>(group);
      if (locks.are_needed[index]) locks.memory.lock();
    };
    info.unlock_group_mutex = [](dThreadingImplementationID, dMutexGroupID group,
                                 dmutexindex_t index) {
      auto& locks = *reinterpret_cast<Locks*>(group);
      if (locks.are_needed[index]) locks.memory.unlock();
    };
    // A wait is over when all calls are made: there is nothing to store in it.
    info.alloc_call_wait = [](dThreadingImplementationID id) {
      return reinterpret_cast<dCallWaitID>(id);
    };
    info.reset_call_wait = [](dThreadingImplementationID, dCallWaitID) {};
    info.free_call_wait = [](dThreadingImplementationID, dCallWaitID) {};
    info.post_call = [](dThreadingImplementationID id, int* fault, dCallReleaseeID* posted,
                        ddependencycount_t waits_for, dCallReleaseeID dependent, dCallWaitID,
                        dThreadedCallFunction* function, void* context, dcallindex_t index,
                        const char*) {
      of(id).post(fault, posted, waits_for, reinterpret_cast<Call*>(dependent), function, context,
                  index);
    };
    info.alter_call_dependencies_count = [](dThreadingImplementationID id, dCallReleaseeID call,
                                            ddependencychange_t by) {
      of(id).change_waiting(*reinterpret_cast<Call*>(call), by);
    };
    info.wait_call = [](dThreadingImplementationID id, int* status, dCallWaitID,
                        const dThreadedWaitTime*, const char*) {
      of(id).make_all();
      if (status) *status = 1;
    };
    info.retrieve_thread_count = [](dThreadingImplementationID id) {
      return static_cast<unsigned>(of(id).threads_);
    };
    info.preallocate_resources_for_calls = [](dThreadingImplementationID, ddependencycount_t) {
      return 1;
    };
    return info;
  }();
  return all;
}

}  // namespace elsie::physics
