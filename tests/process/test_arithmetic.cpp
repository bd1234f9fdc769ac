// The settings with which the C library's mathematics is the same on all processors.
#include <catch2/catch.hpp>

#include "elsie/process/arithmetic.h"

using elsie::process::with_fixed_arithmetic;

TEST_CASE("The settings are added to those that are there, once") {
  const std::string ours = "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4";
  CHECK(with_fixed_arithmetic("") == ours);
  CHECK(with_fixed_arithmetic(ours) == ours);
  CHECK(with_fixed_arithmetic("glibc.malloc.check=3") == "glibc.malloc.check=3:" + ours);
  CHECK(with_fixed_arithmetic("glibc.cpu.hwcaps=-SSE4_2") ==
        "glibc.cpu.hwcaps=-SSE4_2,-AVX,-AVX2,-FMA,-FMA4");
  const std::string mixed = with_fixed_arithmetic("glibc.cpu.hwcaps=-SSE4_2:glibc.malloc.check=3");
  CHECK(with_fixed_arithmetic(mixed) == mixed);
}
