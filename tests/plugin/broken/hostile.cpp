// A shared library without a note that takes the program down when it is loaded.
#include <cstdlib>

namespace {
struct Trap {
  Trap() { std::abort(); }
} const trap;
}  // namespace
