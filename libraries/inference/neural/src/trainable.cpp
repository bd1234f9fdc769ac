#include "elsie/neural/trainable.h"

namespace elsie::neural {

Random stream_of_seed(std::uint64_t seed) { return Random(seed, "network"); }

// Here, so that the class has one place where it is known to all libraries.
Trainable::~Trainable() = default;

}  // namespace elsie::neural
