// Counting what a program allocates.
#pragma once

namespace elsie::test {

/// How often memory was asked for so far, in the whole program: by libraries and plugins, too. For
/// this, allocations.cpp must be among the sources of the test program.
long allocations();

}  // namespace elsie::test
