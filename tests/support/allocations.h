// Counts a program's allocations.
#pragma once

namespace elsie::test {

/// The number of allocations so far in the whole program, with its libraries and plugins. For this,
/// allocations.cpp must be among the sources of the test program.
long allocations();

}  // namespace elsie::test
