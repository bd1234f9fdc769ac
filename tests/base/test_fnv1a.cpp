// The hash by which runs and files are compared.
#include <catch2/catch.hpp>

#include "elsie/base/fnv1a.h"

using elsie::base::Fnv1a;

TEST_CASE("FNV-1a gives its published values") {
  // Fowler, Noll and Vo's test vectors.
  const auto hash_of = [](std::string_view text) {
    Fnv1a hash;
    hash.add(text);
    return hash.value();
  };
  CHECK(hash_of("") == 0xcbf29ce484222325ULL);
  CHECK(hash_of("a") == 0xaf63dc4c8601ec8cULL);
  CHECK(hash_of("foobar") == 0x85944171f73967e8ULL);
}

TEST_CASE("Words are hashed byte by byte, the lowest first, and a hash can be continued") {
  Fnv1a word, bytes;
  word.add(std::uint64_t{0x0102});
  bytes.add(std::string_view("\x02\x01\0\0\0\0\0\0", 8));
  CHECK(word.value() == bytes.value());
  Fnv1a number(word.value()), same(word.value());
  number.add(1.5);
  same.add(std::bit_cast<std::uint64_t>(1.5));
  CHECK(number.value() == same.value());
}
