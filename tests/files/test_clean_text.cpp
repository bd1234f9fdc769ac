// Text out of bytes that may be anything.
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/utf8.h"
#include "elsie/files/clean_text.h"

using namespace elsie;

namespace {

const std::string kBad = "\xef\xbf\xbd";

}  // namespace

TEST_CASE("Cleaned text is UTF-8") {
  const std::string bad = GENERATE("\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf",
                                   "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                                   "\xf5\x80\x80\x80", "\xff", "\xe2\x82", "\xf0\x9f\x90", "\xc3(");
  const std::string cleaned = files::clean("a" + bad + "b");
  CHECK(base::first_invalid(cleaned) == cleaned.size());
}

TEST_CASE("Cleaned text keeps what can be read") {
  CHECK(files::clean("a\tb\nc \xc3\xa4\xf0\x9f\x90\xa2") == "a\tb\nc \xc3\xa4\xf0\x9f\x90\xa2");
  CHECK(files::clean("a\xff"
                     "b\xe2\x82") == "a" + kBad + "b" + kBad + kBad);
  CHECK(files::clean("\x1b[31m\x7f\r") == kBad + "[31m" + kBad + kBad);
  // Of two bytes, and a control character: some terminals take U+009B for the beginning of a
  // colour.
  CHECK(files::clean("\xc2\x9b"
                     "31m") == kBad + "31m");
  CHECK(files::clean("\u202eab\u2069\u2028") == kBad + "ab" + kBad + kBad);
  CHECK(files::clean("\xef\xbf\xbe\xef\xbf\xbf") == kBad + kBad);
  CHECK(files::clean(std::string("\0", 1)) == kBad);
  CHECK(files::one_line("a\n\tb\x01") == "a  b" + kBad);
}

TEST_CASE("Long text is shortened in its middle, by characters") {
  CHECK(files::shortened("turtle", 6) == "turtle");
  CHECK(files::shortened("turtles", 6) ==
        "tur\xe2\x80\xa6"
        "es");
  CHECK(files::shortened("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9f", 3) == "\xc3\xa4\xe2\x80\xa6\xc3\x9f");
  CHECK(files::shortened("turtle", 1) == "\xe2\x80\xa6");
}
