#include "elsie/api/coordinator.h"

namespace elsie {

void Coordinator::equipped(std::span<const Member>, const Perception&) {}

}  // namespace elsie
