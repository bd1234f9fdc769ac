// The cases are those of RFC 3629 and of table 3-7 of the
// Unicode standard.
#include <iterator>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/utf8.h"

using namespace elsie;

namespace {

// What the standard's own bit layout makes of a code point.
std::string encoded(std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    return static_cast<char>(0x80U | ((code >> shift) & 0x3fU));
  };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xc0U | (code >> 6U)), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xe0U | (code >> 12U)), tail(6), tail(0)};
  return {static_cast<char>(0xf0U | (code >> 18U)), tail(12), tail(6), tail(0)};
}

}  // namespace

TEST_CASE("Every code point but the surrogates is read as it was written") {
  for (std::uint32_t code = 0; code <= 0x110000; ++code) {
    const std::string text = encoded(code);
    const base::Character found = base::character_at(text, 0);
    if ((code >= 0xd800 && code <= 0xdfff) || code > 0x10ffff) {
      REQUIRE(found.bytes == 0);
    } else if (found.code != code || found.bytes != text.size()) {
      FAIL("code point " << code << " is read as " << found.code);
    }
  }
}

TEST_CASE("What is no UTF-8 is no character") {
  const std::string bad = GENERATE("\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf",
                                   "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                                   "\xf5\x80\x80\x80", "\xff", "\xe2\x82", "\xf0\x9f\x90", "\xc3(");
  CHECK(base::character_at(bad, 0).bytes == 0);
  CHECK(base::first_invalid("a\xc3\xa4" + bad) == 3);
}

TEST_CASE("Characters are counted, not bytes") {
  CHECK(base::characters("\xc3\xa4\xf0\x9f\x90\xa2z") == 3);
}

TEST_CASE("A text is cut before a character, not within one") {
  const std::string text = "a\u00e9\u20ac";  // of 1, 2 and 3 bytes
  const std::size_t places[] = {0, 1, 1, 3, 3, 3, 6, 6};
  for (std::size_t at = 0; at < std::size(places); ++at) {
    CAPTURE(at);
    CHECK(base::cut_before(text, at) == places[at]);
  }
  CHECK(base::cut_before("", 3) == 0);
}
