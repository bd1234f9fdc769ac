// Neither an evaluation nor a presentation allocates.
#include <atomic>
#include <cstdlib>
#include <new>

#include <catch2/catch.hpp>

#include "elsie/neural/back_propagation.h"

#include "support.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Counts for the whole program; the library's calls arrive here too.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

using namespace elsie;

TEST_CASE("Nothing is allocated while a network answers or learns") {
  for (const std::vector<int>& sizes : test::various_sizes()) {
    neural::Network network = test::random_network(sizes);
    neural::Workspace workspace(network);
    neural::BackPropagation learner(network, {});
    std::vector<double> inputs(network.inputs(), 0.5), outputs(network.outputs());
    const long before = allocations;
    for (int i = 0; i < 100; ++i) {
      learner.present(inputs, outputs);
      network.evaluate(inputs, outputs, workspace);
    }
    const long during = allocations - before;
    INFO(neural::sizes_text(sizes));
    CHECK(during == 0);
  }
}
