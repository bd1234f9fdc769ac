// Neither evaluation nor training allocates.

#include <catch2/catch.hpp>

#include "elsie/neural/back_propagation.h"

#include "allocations.h"
#include "support.h"

using namespace elsie;

TEST_CASE("Nothing is allocated while a network answers or learns") {
  for (const std::vector<int>& sizes : test::various_sizes()) {
    neural::Network network = test::random_network(sizes);
    neural::Workspace workspace(network);
    neural::BackPropagation learner(network, {});
    std::vector<double> inputs(network.inputs(), 0.5), outputs(network.outputs());
    const long before = test::allocations();
    for (int i = 0; i < 100; ++i) {
      learner.present(inputs, outputs);
      network.evaluate(inputs, outputs, workspace);
    }
    const long during = test::allocations() - before;
    INFO(neural::sizes_text(sizes));
    CHECK(during == 0);
  }
}
