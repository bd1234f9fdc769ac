#include "elsie/neural/trainable.h"

namespace elsie::neural {

Random stream_of_seed(std::uint64_t seed) { return Random(seed, "network"); }

// Defined here, so that all libraries share the class's type information.
Trainable::~Trainable() = default;

}  // namespace elsie::neural
